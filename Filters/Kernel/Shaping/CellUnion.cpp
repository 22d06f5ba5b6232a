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

// The cost of volume that joined boundary faces add or remove: for a hundredth of the box, about that of a face just
// beyond preferred quality limits.
constexpr double CostOfVolume = 1000;

// Cosines of angles at which faces are joined: failing ones; those that strain solvers (107 degrees).
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

// Between boundary faces as they are and joined.
double volumeMoved(const UnionView& of, const JoinedFaces& joined, const JoinedShape& result)
{
  double moved = 0;
  double byCuts = 0;
  std::size_t face = result.kept(joined);
  for (const JoinedFaces::Group& group : joined.groups)
  {
    const Vector& centre = result.measures.faces[face++].centre;
    if (!of.view.shape.isBoundary[group.members.front()])
    {
      continue;
    }
    double between = 0;
    for (const std::uint32_t f : group.members)
    {
      between += dot(minus(of.shape.faces[f].centre, centre), of.shape.faces[f].area);
    }
    byCuts += group.recut ? between / 3 : 0;
    moved += group.recut ? 0 : std::abs(between) / 3;
  }
  return moved + std::abs(byCuts);
}

}

void UnionTrial::look(UnionView& cells) const
{
  takeOut(cells_, cells.keys, cells.view, cells.shape);
  cells.verdict.reset();
  cells.joined.reset();
}

void UnionTrial::tryOut(CellUnion& cells, const JoinSpec& joins, double most)
{
  UnionView& of = *cells.of;
  if (!evaluate(of, most))
  {
    cells.verdict.cost = Never;
    return;
  }
  if (!of.joined || !(of.joined->spec == joins))
  {
    of.joined = joinAll(of, joins);
  }
  cells.joined = of.joined->faces;
  cells.verdict = of.joined->verdict;
}

// Before any face is joined; false where the cost is larger than `most`.
bool UnionTrial::evaluate(UnionView& of, double most) const
{
  if (!of.verdict)
  {
    const Verdict verdict = cartesian::evaluate(of.view.shape, of.shape, of.view.beyond, {}, most);
    if (verdict.cost > most)
    {
      return false;
    }
    of.verdict = verdict;
    of.joiner.joinAcross(leastCosine_);
    of.joiner.look(of.view, of.shape);
  }
  return of.verdict->cost <= most;
}

UnionView::Joined UnionTrial::joinAll(UnionView& of, const JoinSpec& joins) const
{
  UnionView::Joined result{ joins, of.joiner.join(joins), *of.verdict };
  if (result.faces.groups.empty())
  {
    addCostOfCell(of.view.shape, of.shape, cells_.volumeOfBox(of.keys.front()), result.verdict);
  }
  else
  {
    result.verdict = joined(of, result.faces, Never);
  }
  return result;
}

// The cost is Never, if it is larger than `most`.
Verdict UnionTrial::joined(UnionView& of, const JoinedFaces& faces, double most) const
{
  const JoinedShape& result = of.joiner.shapeOf(faces);
  const double box = cells_.volumeOfBox(of.keys.front());
  const double ofVolume =
    CostOfVolume * volumeMoved(of, faces, result) / std::min(box, of.shape.volume);
  Verdict verdict;
  const bool mayBe =
    keepsVolume(Accepted::Join, of.shape.volume, result.measures.volume) && !(ofVolume > most);
  if (mayBe)
  {
    verdict = cartesian::evaluate(result.polyhedron, result.measures, result.beyond, {}, most);
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

void UnionTrial::simplify(CellUnion& cells)
{
  Verdict& now = cells.verdict;
  while (now.cost < Never && (now.refused > 0 || now.worst >= StrainedCost))
  {
    double least = now.cost - LeastGain;
    JoinedFaces best;
    Verdict ofBest;
    for (JoinedFaces& faces : cells.of->joiner.joinOneMore(
           cells.joined, now.toMend, now.refused > 0 ? AnyAngle : CosineOfStrained))
    {
      const Verdict verdict = joined(*cells.of, faces, least);
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
    if (cells.of->view.across[group.members.front()] == other)
    {
      std::vector<std::uint32_t> members;
      for (const std::uint32_t member : group.members)
      {
        members.push_back(beyond_.find(cells.of->view.faces[member]));
      }
      // It has all these nodes.
      beyond_.join(std::move(members), beyond_.seen(group.ring, cells.of->view, {}), false);
    }
  }
  const Verdict after = beyond_.joined();
  return accepts(Accepted::Join, beyond_.now, after) ? -gain(beyond_.now, after) : Never;
}

double UnionTrial::costBeyond(const CellUnion& cells)
{
  const CellView& view = cells.of->view;
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
  return !isFolded(cells.of->view) &&
    !cells_.hasFacesNear(cells.of->keys.front(), cells.of->view, cells.joined);
}

}
