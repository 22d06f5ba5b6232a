// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/NodeMoves.h"

#include "Editing/EditMeasures.h"
#include "Editing/PrimitiveEdits.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr double LongestStep = 0.25; // in boxes, as far as slopes say anything
constexpr double Parallel = 1e-8;    // square of a sine: to a plane, or across it
constexpr double LittleCost = 0.1;   // what costs less is not looked at for directions

// A step is tried where its slope promises so much more than is needed: costs are convex, or nearly so.
constexpr double Promise = 1.5;
constexpr double FirstStep = 0.1;
constexpr double Longer = 2;
constexpr double Shorter = 0.35;
constexpr int MostSteps = 4;

struct Descent
{
  double slope; // the gain by length
  std::uint32_t node;
  Vector direction; // of length 1
};

Vector within(const Vector& way, std::uint8_t held)
{
  Vector left = way;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    left[axis] = (held >> axis & 1) != 0 ? 0 : left[axis];
  }
  return left;
}

// Where the node may go: not across its surface, off its edge or the planes that hold it.
Vector allowed(const EditNode& node, const Vector& wanted)
{
  const Vector way = within(wanted, node.constrainedAxes);
  const Vector along = within(node.along, node.constrainedAxes);
  if (node.kind == NodeKind::OnSurface)
  {
    const double square = dot(along, along);
    return square > Parallel ? minus(way, scaled(along, dot(way, along) / square)) : way;
  }
  if (node.kind == NodeKind::OnEdge)
  {
    const Vector off = minus(node.along, along);
    return dot(off, off) > Parallel ? Vector{} : scaled(along, dot(way, along));
  }
  return way;
}

double search(const MeshView& mesh, ProposalTrials& trials, const Descent& descent, double edge,
  double least, Proposal& best)
{
  const EditNode node = mesh.node(descent.node);
  double gained = NoGain;
  double step = FirstStep * edge;
  bool grows = false;
  for (int i = 0; i < MostSteps; ++i)
  {
    const double needed = std::max(gained, least);
    if (descent.slope * step < Promise * needed)
    {
      break;
    }
    const Proposal move{ EditKind::Move, descent.node, 0, 0,
      onLattice(mesh, plus(node.at, scaled(descent.direction, step)), node.constrainedAxes) };
    const double gain = trials.gain(move, needed);
    if (gain > NoGain)
    {
      gained = gain;
      best = move;
      if (i > 0 && !grows)
      {
        break;
      }
      grows = true;
      step *= Longer;
    }
    else if (grows)
    {
      break;
    }
    else
    {
      step *= Shorter;
    }
  }
  return gained;
}

}

double bestMove(MeshEditor& mesh, ProposalTrials& trials, const ObjectiveSpec& spec,
  const SearchSpec& searchSpec, const FixedList<std::uint32_t, 16>& nodes, double edge,
  double least, Proposal& best)
{
  FixedList<Descent, 16> descents;
  if (searchSpec.nodes == 0)
  {
    return NoGain;
  }
  for (const std::uint32_t n : nodes)
  {
    const EditNode& node = mesh.node(n);
    if (node.gone || node.constrainedAxes == AllAxes || node.kind == NodeKind::Corner)
    {
      continue;
    }
    const Vector way = allowed(node, scaled(gradientAt(mesh, n, spec, LittleCost), -1));
    if (const double slope = norm(way); slope * LongestStep * edge > Promise * least)
    {
      descents.push({ slope, n, scaled(way, 1 / slope) });
    }
  }
  std::sort(descents.begin(), descents.end(), [](const Descent& x, const Descent& y) {
    return x.slope != y.slope ? x.slope > y.slope : x.node < y.node;
  });
  double gained = NoGain;
  for (std::size_t i = 0; i < std::min(descents.size(), searchSpec.nodes); ++i)
  {
    const double gain = search(mesh, trials, descents[i], edge, std::max(gained, least), best);
    gained = std::max(gained, gain);
  }
  return gained;
}

}
