// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/CellTrial.h"

#include <algorithm>

namespace cartesian
{

void takeOut(
  const CellComplex& cells, const std::vector<CellKey>& keys, CellView& view, CellShape& shape)
{
  cells.view(keys, view);
  cells.lookBeyond(keys.front(), view);
  measure(view.shape, shape);
}

Verdict verdictOf(const CellComplex& cells, CellKey key, MeasuredCell& cell)
{
  cells.lookAround(key, cell);
  return evaluateCell(cell.shape, cell.measures, cell.beyond, cells.share(key));
}

void CellTrial::look(const CellComplex& cells, CellKey cell)
{
  key = cell;
  takeOut(cells, { cell }, view, shape);
  now = evaluate(view.shape, shape, view.beyond);
  faces.groups.clear();
}

Verdict CellTrial::joined()
{
  joiner.look(view, shape);
  const JoinedShape& result = joiner.shapeOf(faces);
  return evaluate(result.polyhedron, result.measures, result.beyond);
}

bool CellTrial::isSound(const CellComplex& cells) const
{
  const auto isStarGroup = [&](const JoinedFaces::Group& group) {
    const Ring ring{ view.shape.nodes.data(), group.ring.data(), group.ring.size() };
    return isStar(ring, unit(group.shape.area));
  };
  return std::all_of(faces.groups.begin(), faces.groups.end(), isStarGroup) &&
    !cells.hasFacesNear(key, view, faces);
}

void CellTrial::join(
  std::vector<std::uint32_t> members, std::vector<std::uint32_t> ring, bool recut)
{
  const FaceShape of = measure({ view.shape.nodes.data(), ring.data(), ring.size() });
  faces.groups.push_back({ std::move(members), std::move(ring), of, recut });
}

std::uint32_t CellTrial::find(const FaceUse& face) const
{
  const auto at = std::find_if(view.faces.begin(), view.faces.end(),
    [&](const FaceUse& use) { return use.face == face.face; });
  return static_cast<std::uint32_t>(at - view.faces.begin());
}

std::vector<std::uint32_t> CellTrial::seen(
  const std::vector<std::uint32_t>& ring, const CellView& from, const Vector& way)
{
  std::vector<std::uint32_t> turned;
  for (auto node = ring.rbegin(); node != ring.rend(); ++node)
  {
    const auto at = std::find(view.nodes.begin(), view.nodes.end(), from.nodes[*node]);
    turned.push_back(static_cast<std::uint32_t>(at - view.nodes.begin()));
    if (turned.back() == view.nodes.size())
    {
      view.nodes.push_back(from.nodes[*node]);
      view.shape.nodes.push_back(plus(from.shape.nodes[*node], way));
    }
  }
  return turned;
}

}
