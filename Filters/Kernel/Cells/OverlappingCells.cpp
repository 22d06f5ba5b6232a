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

constexpr std::size_t FacesAChunk = 4096;
constexpr std::size_t NodesAChunk = 4096;

class Search
{
public:
  Search(const Boxes& boxes, const WallMesh& wall)
    : boxes_(boxes)
    , wall_(wall)
  {
  }

  std::vector<std::uint32_t> run(std::size_t nodes, Execution& execution) const
  {
    const Buckets<std::uint32_t> facesAt = fillBuckets<std::uint32_t>(
      wall_.faces.size(), FacesAChunk, nodes, // by their lowest node
      [&](std::size_t first, std::size_t last, auto&& add) {
        for (auto f = static_cast<std::uint32_t>(first); f < last; ++f)
        {
          if (isThere(f))
          {
            add(*std::min_element(begin(f), end(f)), f);
          }
        }
      },
      execution);
    std::vector<std::vector<std::uint32_t>> found(chunks(nodes, NodesAChunk));
    execution.forEach(nodes, NodesAChunk, [&](std::size_t first, std::size_t last) {
      for (std::size_t node = first; node < last; ++node)
      {
        for (const std::uint32_t* f = facesAt.begin(node); f != facesAt.end(node); ++f)
        {
          for (const std::uint32_t* g = facesAt.begin(node); g != f; ++g)
          {
            compare(*f, *g, found[first / NodesAChunk]);
          }
        }
      }
    });
    return sortedUnique(concatenated(found));
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

  void compare(std::uint32_t f, std::uint32_t g, std::vector<std::uint32_t>& found) const
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
        found.push_back(isSmaller(one, other) ? one : other);
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
    return wall_.cells[key].volumeFraction * cartesian::volumeOf(boxes_.box(wall_.cells[key].box));
  }

  const Boxes& boxes_;
  const WallMesh& wall_;
};

}

std::vector<std::uint32_t> overlappingCells(
  const Boxes& boxes, std::size_t nodes, const WallMesh& wall, Execution& execution)
{
  return Search(boxes, wall).run(nodes, execution);
}

}
