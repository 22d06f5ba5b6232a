// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/CellUnion.h"

#include "Acceptance/CellCost.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace cartesian
{

namespace
{

// What a part of the box that joined boundary faces add or take costs: a hundredth about as much as a face at
// which solvers are not at ease.
constexpr double CostOfVolume = 1000;

// Cosines of angles at which faces are joined: those that solvers refuse; that strain them (107 degrees).
constexpr double AnyAngle = -1;
constexpr double CosineOfStrained = -0.3;

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

// Of the cell itself, besides its faces' costs.
void addCostOfCell(
  const Polyhedron& polyhedron, const CellShape& shape, double box, Verdict& verdict)
{
  verdict.cost = verdict.faces < LeastFaces
    ? Never
    : verdict.cost + costOfShare(shape.volume / box) + costOfDeterminant(polyhedron, shape);
}

}

void UnionTrial::tryOut(CellUnion& cells, const JoinSpec& joins, double most)
{
  cells_.view(cells.keys, cells.view);
  cells_.lookBeyond(cells.keys.front(), cells.view);
  tryOutView(cells, joins, most);
}

void UnionTrial::tryOutView(CellUnion& cells, const JoinSpec& joins, double most)
{
  const Polyhedron& shape = cells.view.shape;
  measure(shape, shape_);
  cells.verdict = evaluate(shape, shape_, cells.view.beyond, {}, most);
  if (cells.verdict.cost > most)
  {
    cells.verdict.cost = Never;
    return;
  }
  joiner_.look(cells.view, shape_);
  cells.joined = joiner_.join(joins);
  if (cells.joined.groups.empty())
  {
    addCostOfCell(shape, shape_, cells_.volumeOfBox(cells.keys.front()), cells.verdict);
  }
  else
  {
    cells.verdict = joined(cells, cells.joined, Never);
  }
}

// The cost is Never, if it is larger than `most`.
Verdict UnionTrial::joined(const CellUnion& cells, const JoinedFaces& faces, double most)
{
  const JoinedShape& result = joiner_.shapeOf(faces);
  const double box = cells_.volumeOfBox(cells.keys.front());
  const double ofVolume =
    CostOfVolume * volumeMoved(cells.view, faces, result) / std::min(box, shape_.volume);
  Verdict verdict;
  const bool mayBe =
    keepsVolume(Accepted::Join, shape_.volume, result.measures.volume) && !(ofVolume > most);
  if (mayBe)
  {
    verdict = evaluate(result.polyhedron, result.measures, result.beyond, {}, most);
  }
  if (!mayBe || verdict.cost > most)
  {
    verdict.cost = Never;
    return verdict;
  }
  addCostOfCell(result.polyhedron, result.measures, box, verdict);
  verdict.cost += ofVolume;
  return verdict;
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

void UnionTrial::simplify(CellUnion& cells)
{
  Verdict& now = cells.verdict;
  while (now.cost < Never && (now.refused > 0 || now.worst >= StrainedCost))
  {
    double least = now.cost - LeastGain;
    JoinedFaces best;
    Verdict ofBest;
    for (JoinedFaces& faces :
      joiner_.joinOneMore(cells.joined, now.toMend, now.refused > 0 ? AnyAngle : CosineOfStrained))
    {
      const Verdict verdict = joined(cells, faces, least);
      if (verdict.cost < least)
      {
        least = verdict.cost - LeastGain;
        best = std::move(faces);
        ofBest = verdict;
      }
    }
    if (best.groups.empty())
    {
      break;
    }
    cells.joined = std::move(best);
    now = ofBest;
    now.cost = least + LeastGain;
  }
}

// By how much the costs of a cell of another region rise with the faces that are joined between them.
double UnionTrial::costBeyond(const CellUnion& cells, CellKey other)
{
  beyond_.look(cells_, other);
  for (const JoinedFaces::Group& group : cells.joined.groups)
  {
    if (cells.view.across[group.members.front()] == other)
    {
      std::vector<std::uint32_t> members;
      for (const std::uint32_t member : group.members)
      {
        members.push_back(beyond_.find(cells.view.faces[member]));
      }
      // It has all these nodes.
      beyond_.join(std::move(members), beyond_.seen(group.ring, cells.view, {}), false);
    }
  }
  const Verdict after = beyond_.joined();
  return accepts(Accepted::Join, beyond_.now, after) ? -gain(beyond_.now, after) : Never;
}

double UnionTrial::costBeyond(const CellUnion& cells)
{
  const CellView& view = cells.view;
  std::set<CellKey> others;
  for (const JoinedFaces::Group& group : cells.joined.groups)
  {
    const std::uint32_t face = group.members.front();
    if (view.across[face] != None && view.shape.isBoundary[face])
    {
      others.insert(view.across[face]);
    }
  }
  return std::accumulate(others.begin(), others.end(), 0.0,
    [&](double sum, CellKey other) { return sum + costBeyond(cells, other); });
}

bool UnionTrial::isSound(const CellUnion& cells) const
{
  return !isFolded(cells.view) &&
    !cells_.hasFacesNear(cells.keys.front(), cells.view, cells.joined);
}

}
