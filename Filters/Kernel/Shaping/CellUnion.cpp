// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/CellUnion.h"

#include "Acceptance/CellCost.h"
#include "Acceptance/Refusal.h"

#include <algorithm>
#include <cmath>
#include <numeric>

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
  invalid += other.invalid;
  return *this;
}

// --- costs

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
      costs.invalid += isTurnedOver(shape, f, beyond[f]) ? 1 : 0;
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
  cells.costs = costsOf(cells.view.shape, shape_, cells.view.beyond, {}, most);
  if (cells.costs.sum > most)
  {
    return Never;
  }
  joiner_.look(cells.view, shape_);
  cells.joined = joiner_.join(joins);
  return cells.joined.groups.empty() ? costOfCell(cells, cells.view.shape, shape_, cells.costs)
                                     : costOfJoined(cells, cells.joined, Never, cells.costs);
}

// Of the cell itself, besides its faces' costs.
double UnionTrial::costOfCell(const CellUnion& cells, const Polyhedron& polyhedron,
  const CellShape& shape, const FaceCosts& costs) const
{
  const double box = cells_.volumeOfBox(cells.keys.front());
  return polyhedron.faces() < LeastFaces
    ? Never
    : costs.sum + costOfShare(shape.volume / box) + costOfDeterminant(polyhedron, shape);
}

// Never, if it is larger than `most`.
double UnionTrial::costOfJoined(
  const CellUnion& cells, const JoinedFaces& joined, double most, FaceCosts& costs)
{
  const JoinedShape& result = joiner_.shapeOf(joined);
  const double volume = result.measures.volume;
  const double ofVolume = CostOfVolume * volumeMoved(cells.view, joined, result) /
    std::min(cells_.volumeOfBox(cells.keys.front()), shape_.volume);
  if (volume < LeastVolumeKept * shape_.volume || shape_.volume < LeastVolumeKept * volume ||
    ofVolume > most)
  {
    return Never;
  }
  costs = costsOf(result.polyhedron, result.measures, result.beyond, {}, most);
  return costs.sum > most ? Never
                          : costOfCell(cells, result.polyhedron, result.measures, costs) + ofVolume;
}

// Between boundary faces as they are and joined.
double UnionTrial::volumeMoved(
  const CellView& view, const JoinedFaces& joined, const JoinedShape& result) const
{
  double moved = 0;
  double byCuts = 0;
  std::size_t face = result.kept(joined);
  for (const JoinedFaces::Group& group : joined.groups)
  {
    const Vector& centre = result.measures.faces[face++].centre;
    if (!view.shape.isBoundary[group.members.front()])
    {
      continue;
    }
    double between = 0;
    for (const std::uint32_t f : group.members)
    {
      between += dot(minus(shape_.faces[f].centre, centre), shape_.faces[f].area);
    }
    byCuts += group.recut ? between / 3 : 0;
    moved += group.recut ? 0 : std::abs(between) / 3;
  }
  return moved + std::abs(byCuts);
}

double UnionTrial::simplify(CellUnion& cells, double cost)
{
  while (cells.costs.refused > 0 || cells.costs.worst >= StrainedCost)
  {
    double least = cost - LeastGain;
    JoinedFaces best;
    FaceCosts costsOfBest;
    for (JoinedFaces& joined : joiner_.joinOneMore(
           cells.joined, cells.costs.toMend, cells.costs.refused > 0 ? AnyAngle : CosineOfStrained))
    {
      FaceCosts costs;
      const double now = costOfJoined(cells, joined, least, costs);
      if (now < least)
      {
        least = now - LeastGain;
        best = std::move(joined);
        costsOfBest = costs;
      }
    }
    if (best.groups.empty())
    {
      break;
    }
    cost = least + LeastGain;
    cells.joined = std::move(best);
    cells.costs = costsOfBest;
  }
  return cost;
}

// The same faces, as a cell of another region has them.
JoinedFaces seenFrom(const CellView& beyond, CellKey key, const CellUnion& cells)
{
  JoinedFaces joined;
  for (const JoinedFaces::Group& group : cells.joined.groups)
  {
    if (cells.view.across[group.members.front()] != key)
    {
      continue;
    }
    JoinedFaces::Group& seen = joined.groups.emplace_back();
    for (const std::uint32_t member : group.members)
    {
      const auto at = std::find_if(beyond.faces.begin(), beyond.faces.end(),
        [&](const FaceUse& use) { return use.face == cells.view.faces[member].face; });
      seen.members.push_back(static_cast<std::uint32_t>(at - beyond.faces.begin()));
    }
    for (auto node = group.ring.rbegin(); node != group.ring.rend(); ++node)
    {
      const auto at = std::find(beyond.nodes.begin(), beyond.nodes.end(), cells.view.nodes[*node]);
      seen.ring.push_back(static_cast<std::uint32_t>(at - beyond.nodes.begin()));
    }
  }
  return joined;
}

// By how much the costs of a cell of another region rise with the faces that are joined between them; Never, where
// solvers refuse more of it than before.
double UnionTrial::costBeyond(const CellUnion& cells, CellKey other)
{
  cells_.view({ other }, beyond_);
  cells_.lookBeyond(other, beyond_);
  measure(beyond_.shape, shapeBeyond_);
  const FaceCosts before = costsOf(beyond_.shape, shapeBeyond_, beyond_.beyond);
  joinerBeyond_.look(beyond_, shapeBeyond_);
  const JoinedShape& result = joinerBeyond_.shapeOf(seenFrom(beyond_, other, cells));
  const double volume = result.measures.volume;
  const FaceCosts after = costsOf(result.polyhedron, result.measures, result.beyond);
  const bool isFair = result.polyhedron.faces() >= LeastFaces &&
    volume >= LeastVolumeKept * shapeBeyond_.volume &&
    shapeBeyond_.volume >= LeastVolumeKept * volume && after.refused <= before.refused;
  return isFair ? after.sum - before.sum : Never;
}

double UnionTrial::costBeyond(const CellUnion& cells)
{
  const CellView& view = cells.view;
  std::vector<CellKey> others;
  for (const JoinedFaces::Group& group : cells.joined.groups)
  {
    const std::uint32_t face = group.members.front();
    if (view.across[face] != None && view.shape.isBoundary[face])
    {
      others.push_back(view.across[face]);
    }
  }
  std::sort(others.begin(), others.end());
  others.erase(std::unique(others.begin(), others.end()), others.end());
  return std::accumulate(others.begin(), others.end(), 0.0,
    [&](double sum, CellKey other) { return sum + costBeyond(cells, other); });
}

bool UnionTrial::isSound(const CellUnion& cells) const
{
  return !isFolded(cells.view) &&
    !cells_.hasFacesNear(cells.keys.front(), cells.view, cells.joined);
}

}
