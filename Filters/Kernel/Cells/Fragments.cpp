// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Fragments.h"

#include "Lattice/Vector.h"

#include <algorithm>
#include <unordered_set>

namespace cartesian
{

namespace
{

constexpr std::size_t CellsAChunk = 512;

class Search
{
public:
  Search(const Boxes& boxes, const Patches& patches, const Sides& sides, const WallMesh& wall)
    : boxes_(boxes)
    , patches_(patches)
    , sides_(sides)
    , wall_(wall)
    , isLarge_(wall.size())
  {
  }

  std::vector<SmallPart> run(Execution& execution)
  {
    execution.forEach(wall_.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c)
      {
        isLarge_[c] = hasHexahedronBeside(static_cast<std::uint32_t>(c)) ? 1 : 0;
      }
    });
    std::vector<SmallPart> parts;
    for (std::uint32_t c = 0; c < wall_.size(); ++c)
    {
      if (isLarge_[c] == 0 && !wall_.cells[c].removed && collect(c))
      {
        parts.push_back(
          { part_, !patches_.walls.any() && volume() < LargestFragment * enclosed() });
      }
      for (const std::uint32_t cell : part_) // each is looked at once
      {
        isLarge_[cell] = 1;
      }
      part_.clear();
    }
    return parts;
  }

private:
  // visit(cell beyond a face) until it returns true. Returns whether it did.
  template <class Visitor>
  bool anyBeyond(std::uint32_t c, Visitor&& visit) const
  {
    const auto use = wall_.uses.begin();
    return std::any_of(use + std::ptrdiff_t(wall_.cells[c].firstUse),
      use + std::ptrdiff_t(wall_.cells[c + 1].firstUse), [&](const FaceUse& face) {
        const CellKey other = wall_.faces.beyond(face);
        return other != None && !wall_.isInterface(face.face) &&
          !patches_.walls.isBaffle(wall_.faces.boundary[face.face]) && visit(other);
      });
  }

  bool hasHexahedronBeside(std::uint32_t c) const { return anyBeyond(c, isHexahedron); }

  // Fills part_, in order; returns whether it is a small part.
  bool collect(std::uint32_t c)
  {
    part_.assign(1, c);
    std::size_t next = 0;
    while (next < part_.size()) // it grows
    {
      if (anyBeyond(part_[next++], [&](std::uint32_t other) { return !add(other); }))
      {
        return false;
      }
    }
    std::sort(part_.begin(), part_.end());
    return true;
  }

  // False: with this cell the part is too large.
  bool add(std::uint32_t other)
  {
    if (wall_.cells[other].removed || std::find(part_.begin(), part_.end(), other) != part_.end())
    {
      return true;
    }
    part_.push_back(other);
    return isLarge_[other] == 0 && part_.size() <= MostCellsOfSmallPart;
  }

  double volume() const
  {
    double sum = 0;
    for (const std::uint32_t c : part_)
    {
      sum += wall_.cells[c].volumeFraction * volumeOf(boxes_.box(wall_.cells[c].box));
    }
    return sum;
  }

  // The largest volume that a component of the surface encloses on which the part has a node.
  double enclosed() const
  {
    std::unordered_set<std::uint32_t> nodes;
    double largest = 0;
    for (const std::uint32_t c : part_)
    {
      wall_.forEachNodeOf(c, [&](std::uint32_t node) { nodes.insert(node); });
    }
    for (const std::uint32_t c : part_)
    {
      const std::uint32_t cut =
        sides_.patchBox[sides_.polyhedralOrdinal(wall_.cells[c].box)]; // or None
      for (std::size_t p = cut == None ? 0 : patches_.boxStart[cut];
           cut != None && p < patches_.boxStart[cut + 1]; ++p)
      {
        const auto corner = patches_.corners.begin();
        if (std::any_of(corner + std::ptrdiff_t(patches_.start[p]),
              corner + std::ptrdiff_t(patches_.start[p + 1]),
              [&](std::uint32_t node) { return nodes.count(node) > 0; }))
        {
          largest = std::max(largest, double(patches_.enclosed[patches_.triangle[p]]));
        }
      }
    }
    return largest;
  }

  const Boxes& boxes_;
  const Patches& patches_;
  const Sides& sides_;
  const WallMesh& wall_;
  std::vector<std::uint8_t> isLarge_; // 1: in no small part, or in one that is known
  std::vector<std::uint32_t> part_;
};

}

std::vector<SmallPart> findSmallParts(const Boxes& boxes, const Patches& patches,
  const Sides& sides, const WallMesh& wall, Execution& execution)
{
  return Search(boxes, patches, sides, wall).run(execution);
}

}
