// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/OverlappingCells.h"

#include "Base/Sorting.h"
#include "Lattice/Vector.h"

#include <algorithm>
#include <utility>

namespace cartesian
{

namespace
{

class Search
{
public:
  Search(const Boxes& boxes, const WallMesh& wall)
    : boxes_(boxes)
    , wall_(wall)
  {
  }

  std::vector<std::uint32_t> run(std::size_t nodes)
  {
    std::vector<std::uint32_t> last(nodes, None); // face with this lowest node
    std::vector<std::uint32_t> before(wall_.faces.size(), None);
    for (std::uint32_t f = 0; f < wall_.faces.size(); ++f)
    {
      if (!isThere(f))
      {
        continue;
      }
      const std::uint32_t lowest = *std::min_element(begin(f), end(f));
      for (std::uint32_t other = last[lowest]; other != None; other = before[other])
      {
        compare(f, other);
      }
      before[f] = std::exchange(last[lowest], f);
    }
    return sortedUnique(std::move(found_));
  }

private:
  const std::uint32_t* begin(std::uint32_t f) const
  {
    return wall_.faces.corners.data() + wall_.faces.start[f];
  }
  const std::uint32_t* end(std::uint32_t f) const { return begin(f + 1); }

  bool isCell(CellKey key) const { return key != None && !wall_.isRemoved(key); }

  bool isThere(std::uint32_t f) const
  {
    const auto& [below, above] = wall_.faces.cells[f];
    return begin(f) != end(f) && (isCell(below) || isCell(above));
  }

  void compare(std::uint32_t f, std::uint32_t g)
  {
    if (!std::is_permutation(begin(f), end(f), begin(g), end(g)))
    {
      return;
    }
    const std::size_t turned = isSameWayRound(f, g) ? 0 : 1;
    for (const std::size_t side : { 0U, 1U })
    {
      const CellKey one = wall_.faces.cells[f][side];
      const CellKey other = wall_.faces.cells[g][side ^ turned];
      if (isCell(one) && isCell(other) && !(isHexahedron(one) && isHexahedron(other)))
      {
        found_.push_back(isSmaller(one, other) ? one : other);
      }
    }
  }

  bool isSameWayRound(std::uint32_t f, std::uint32_t g) const
  {
    const std::uint32_t* at = std::find(begin(g), end(g), *begin(f));
    return (at + 1 == end(g) ? *begin(g) : at[1]) == begin(f)[1];
  }

  // Hexahedra stay.
  bool isSmaller(CellKey one, CellKey other) const
  {
    return isHexahedron(other) ||
      (!isHexahedron(one) && std::pair(volumeOf(one), one) < std::pair(volumeOf(other), other));
  }

  double volumeOf(CellKey key) const
  {
    const Box box = boxes_.box(wall_.cells[key].box);
    const Vector size = minus(box.high, box.low);
    return wall_.cells[key].volumeFraction * size[0] * size[1] * size[2];
  }

  const Boxes& boxes_;
  const WallMesh& wall_;
  std::vector<std::uint32_t> found_;
};

}

std::vector<std::uint32_t> overlappingCells(
  const Boxes& boxes, std::size_t nodes, const WallMesh& wall)
{
  return Search(boxes, wall).run(nodes);
}

}
