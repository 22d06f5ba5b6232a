// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/CellUnion.h"

#include "Polyhedra/CellCost.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

// Below this cost no face is refused.
constexpr double AcceptedCost = 0.4;

// What a part of the box that joined boundary faces add or take costs: a hundredth about as much as a face at
// which solvers are not at ease.
constexpr double CostOfVolume = 1000;

// Joined faces change a cell's volume by no more than this factor.
constexpr double LeastVolumeKept = 0.8;

// Cosines of angles at which faces are joined: those that solvers refuse; that strain them (107 degrees).
constexpr double AnyAngle = -1;
constexpr double CosineOfStrained = -0.3;

// Costs have to fall by more than rounding.
constexpr double LeastGain = 1e-6;

// Whether two faces have the same nodes, and a cell is beyond one of them: nothing would be between.
// (Between two boundary faces CellComplex::merge leaves nothing.)
bool isFolded(const CellView& view)
{
  std::vector<std::uint32_t> nodes(view.shape.corners.begin(), view.shape.corners.end());
  const auto begin = [&](std::size_t f) { return nodes.begin() + view.shape.start[f]; };
  std::vector<std::size_t> faces(view.faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    faces[f] = f;
    std::sort(begin(f), begin(f + 1));
  }
  std::sort(faces.begin(), faces.end(), [&](std::size_t f, std::size_t g) {
    return std::lexicographical_compare(begin(f), begin(f + 1), begin(g), begin(g + 1));
  });
  return std::adjacent_find(faces.begin(), faces.end(), [&](std::size_t f, std::size_t g) {
    return std::equal(begin(f), begin(f + 1), begin(g), begin(g + 1)) &&
      (view.across[f] != None || view.across[g] != None);
  }) != faces.end();
}

}

FaceCosts& FaceCosts::operator+=(const FaceCosts& other)
{
  sum += other.sum;
  worst = std::max(worst, other.worst);
  refused += other.refused;
  return *this;
}

// --- costs

namespace
{

// Whether solvers refuse faces of a cell; knows its other centres once they are asked for.
class Refusal
{
public:
  Refusal(const Polyhedron& cell, const CellShape& shape, const std::vector<NeighbourCell>& beyond)
    : cell_(cell)
    , shape_(shape)
    , beyond_(beyond)
  {
  }

  bool isRefused(std::uint32_t face)
  {
    if (cartesian::isRefused(cell_, shape_, face, beyond_[face]))
    {
      return true;
    }
    const bool boundary = cell_.isBoundary[face] != 0;
    if (!mayBeDoubtful(shape_, boundary, face))
    {
      return false;
    }
    if (projected_.faces.empty())
    {
      measureProjected(cell_, projected_);
    }
    return isDoubtful(projected_, boundary, face);
  }

private:
  const Polyhedron& cell_;
  const CellShape& shape_;
  const std::vector<NeighbourCell>& beyond_;
  CellShape projected_;
};

}

FaceCosts costsOf(const Polyhedron& cell, const CellShape& shape,
  const std::vector<NeighbourCell>& beyond, const std::vector<std::uint8_t>& counts, double most)
{
  FaceCosts costs;
  double worstRefused = -1;
  Refusal refusal(cell, shape, beyond);
  const double negligible = negligibleArea(shape);
  for (std::uint32_t f = 0; f < cell.faces() && costs.sum <= most; ++f)
  {
    if (!counts.empty() && !counts[f])
    {
      continue;
    }
    const double cost = costOfFace(cell, shape, f, beyond[f]) +
      (norm(shape.faces[f].area) < negligible ? CostOfNegligible : 0);
    costs.sum += cost;
    costs.toMend = cost > costs.worst && costs.refused == 0 ? f : costs.toMend;
    costs.worst = std::max(costs.worst, cost);
    if (cost >= AcceptedCost && refusal.isRefused(f))
    {
      ++costs.refused;
      costs.toMend = cost > worstRefused ? f : costs.toMend;
      worstRefused = std::max(worstRefused, cost);
    }
  }
  return costs;
}

// --- unions

double UnionTrial::tryOut(CellUnion& cells, const JoinSpec& joins, double most)
{
  cells_.view(cells.keys, cells.view);
  cells_.lookBeyond(cells.keys.front(), cells.view);
  return tryOutView(cells, joins, most);
}

double UnionTrial::tryOutView(CellUnion& cells, const JoinSpec& joins, double most)
{
  measure(cells.view.shape, shape_);
  if (costsOf(cells.view.shape, shape_, cells.view.beyond, {}, most).sum > most)
  {
    return Never;
  }
  cells.joined = joinFaces(cells.view, shape_, joins);
  return cost(cells);
}

double UnionTrial::cost(CellUnion& cells)
{
  const bool isJoined = !cells.joined.groups.empty();
  Polyhedron joined;
  if (isJoined)
  {
    joined = shapeOf(cells.view, cells.joined, beyond_);
    measure(joined, joinedShape_);
  }
  const Polyhedron& polyhedron = isJoined ? joined : cells.view.shape;
  const CellShape& shape = isJoined ? joinedShape_ : shape_;
  if (polyhedron.faces() < LeastFaces || shape.volume < LeastVolumeKept * shape_.volume ||
    shape_.volume < LeastVolumeKept * shape.volume)
  {
    return Never;
  }
  const double box = cells_.volumeOfBox(cells.keys.front());
  cells.costs = costsOf(polyhedron, shape, isJoined ? beyond_ : cells.view.beyond);
  return cells.costs.sum + costOfShare(shape.volume / box) + costOfDeterminant(polyhedron, shape) +
    (isJoined ? CostOfVolume * volumeMoved(cells, joined) / std::min(box, shape_.volume) : 0);
}

// Between boundary faces as they are and joined.
double UnionTrial::volumeMoved(const CellUnion& cells, const Polyhedron& joined) const
{
  double moved = 0;
  double byCuts = 0;
  for (std::size_t g = 0; g < cells.joined.groups.size(); ++g)
  {
    const std::vector<std::uint32_t>& members = cells.joined.groups[g].members;
    if (!cells.joined.groups[g].isNew() || !joined.isBoundary[g])
    {
      continue;
    }
    double between = 0;
    for (const std::uint32_t f : members)
    {
      between +=
        dot(minus(shape_.faces[f].centre, joinedShape_.faces[g].centre), shape_.faces[f].area);
    }
    byCuts += cells.joined.groups[g].recut ? between / 3 : 0;
    moved += cells.joined.groups[g].recut ? 0 : std::abs(between) / 3;
  }
  return moved + std::abs(byCuts);
}

double UnionTrial::simplify(CellUnion& cells, double cost)
{
  while (cells.costs.refused > 0 || cells.costs.worst >= StrainedCost)
  {
    trial_.keys = cells.keys;
    trial_.view = cells.view;
    double least = cost;
    JoinedFaces best;
    FaceCosts costsOfBest;
    for (JoinedFaces& joined : joinOneMore(cells.view, shape_, cells.joined, cells.costs.toMend,
           cells.costs.refused > 0 ? AnyAngle : CosineOfStrained))
    {
      trial_.joined = std::move(joined);
      const double now = this->cost(trial_);
      if (now < least - LeastGain)
      {
        least = now;
        best = std::move(trial_.joined);
        costsOfBest = trial_.costs;
      }
    }
    if (best.groups.empty())
    {
      break;
    }
    cost = least;
    cells.joined = std::move(best);
    cells.costs = costsOfBest;
  }
  return cost;
}

bool UnionTrial::isSound(const CellUnion& cells) const
{
  return !isFolded(cells.view) &&
    !cells_.hasFacesNear(cells.keys.front(), cells.view, cells.joined);
}

}
