// SPDX-License-Identifier: BSD-3-Clause
#include "Optimisation/ClosedCells.h"

#include "Acceptance/CellFaults.h"

#include <algorithm>
#include <tuple>

namespace cartesian
{

bool ClosedCells::Side::operator<(const Side& other) const
{
  return std::tie(low, high, isUp, face) < std::tie(other.low, other.high, other.isUp, other.face);
}

bool ClosedCells::Side::hasSameEdge(const Side& other) const
{
  return low == other.low && high == other.high;
}

bool ClosedCells::Side::isOpposite(const Side& other) const
{
  return hasSameEdge(other) && isUp != other.isUp;
}

bool ClosedCells::isClosed(std::uint32_t c)
{
  if (m_.cells.endUse[c] - m_.cells.firstUse[c] < LeastFaces)
  {
    return false;
  }
  listSides(c);
  pairs_.clear();
  for (std::size_t i = 0; i < sides_.size(); i += 2)
  {
    if (i + 1 == sides_.size() || !sides_[i].isOpposite(sides_[i + 1]) ||
      (i + 2 < sides_.size() && sides_[i].hasSameEdge(sides_[i + 2])))
    {
      return false;
    }
    pairs_.push_back({ std::min(sides_[i].face, sides_[i + 1].face),
      std::max(sides_[i].face, sides_[i + 1].face) });
  }
  return !areFoldedTogether();
}

void ClosedCells::listSides(std::uint32_t c)
{
  sides_.clear();
  for (std::uint32_t u = m_.cells.firstUse[c]; u < m_.cells.endUse[c]; ++u)
  {
    const std::uint32_t f = m_.cells.uses[u];
    const bool turned = m_.faces.cells[f][0] != c;
    std::uint32_t from = m_.faces.corners[m_.faces.stop[f] - 1];
    m_.forEachCorner(f, [&](std::uint32_t to) {
      sides_.push_back({ std::min(from, to), std::max(from, to), (from < to) != turned, f });
      from = to;
    });
  }
  std::sort(sides_.begin(), sides_.end());
}

// Whether two of the faces that share an edge share all edges of one of them: nothing is between.
bool ClosedCells::areFoldedTogether()
{
  std::sort(pairs_.begin(), pairs_.end());
  for (auto begin = pairs_.begin(); begin != pairs_.end();)
  {
    const auto end =
      std::find_if(begin, pairs_.end(), [&](const auto& pair) { return pair != *begin; });
    const auto shared = static_cast<std::size_t>(end - begin);
    if (shared >= std::min(m_.faces.sizeOf((*begin)[0]), m_.faces.sizeOf((*begin)[1])))
    {
      return true;
    }
    begin = end;
  }
  return false;
}

}
