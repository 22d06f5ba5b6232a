#include "Boundary.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// What lies on one side of an inner face.
struct Beyond
{
  std::uint32_t cell = None;          // number of the cell that stays there
  std::int32_t boundary = NoBoundary; // or the boundary that the face takes over
};

class Collector
{
public:
  Collector(const MeshParts& parts, const CellNumbers& numbers)
    : parts_(parts)
    , numbers_(numbers)
  {
  }

  std::vector<BoundaryFace> collect()
  {
    for (std::size_t s = 0; s < parts_.sides.sides.size(); ++s)
    {
      exposeInnerFaces(s);
    }
    exposeShapedFaces();
    exposeBoxSides();
    std::sort(exposed_.begin(), exposed_.end());
    std::vector<BoundaryFace> patches = patchesOfCells();
    std::vector<BoundaryFace> all(patches.size() + exposed_.size());
    std::merge(patches.begin(), patches.end(), exposed_.begin(), exposed_.end(), all.begin());
    return all;
  }

private:
  std::vector<BoundaryFace> patchesOfCells() const
  {
    std::vector<BoundaryFace> faces;
    faces.reserve(parts_.patches.size());
    const Cells& cells = parts_.cells;
    for (std::size_t c = numbers_.coreBegin; c < numbers_.coreEnd; ++c)
    {
      const std::size_t before = faces.size();
      for (std::size_t f = cells.cells[c].firstFace; f < cells.cells[c + 1].firstFace; ++f)
      {
        const FaceRef& face = cells.faces[f];
        if (numbers_.ofCell[c] != None && face.kind() == FaceRef::Kind::Patch)
        {
          faces.push_back({ numbers_.ofCell[c], face.index, parts_.patches.boundary[face.index],
            BoundaryFace::Kind::Patch });
        }
      }
      std::sort(faces.begin() + std::ptrdiff_t(before), faces.end());
    }
    return faces;
  }

  Beyond beyond(std::uint32_t box, std::uint32_t cell) const
  {
    if (cell != None)
    {
      return { numbers_.ofCell[cell], parts_.cells.cells[cell].boundary };
    }
    if (box == None)
    {
      return {};
    }
    const std::uint32_t n = parts_.sides.polyhedralOrdinal(box);
    if (n == None)
    {
      return { numbers_.ofBox[box], NoBoundary };
    }
    return { None, boundaryBeyond(parts_.patches, parts_.sides, box) };
  }

  void expose(const Beyond& low, const Beyond& high, std::size_t face, BoundaryFace::Kind kind,
    BoundaryFace::Kind turned)
  {
    if (CellNumbers::isHere(low.cell) && high.cell == None)
    {
      exposed_.push_back({ low.cell, face, high.boundary, kind });
    }
    if (low.cell == None && CellNumbers::isHere(high.cell))
    {
      exposed_.push_back({ high.cell, face, low.boundary, turned });
    }
  }

  void exposeInnerFaces(std::size_t s)
  {
    const Side& side = parts_.sides.sides[s];
    for (std::size_t f = parts_.inner.sideStart[s]; f < parts_.inner.sideStart[s + 1]; ++f)
    {
      const Beyond low = beyond(side.low, parts_.cells.ofInnerFace[f][0]);
      const Beyond high = beyond(side.high, parts_.cells.ofInnerFace[f][1]);
      expose(low, high, f, BoundaryFace::Kind::Inner, BoundaryFace::Kind::TurnedInner);
    }
  }

  void exposeShapedFaces()
  {
    const ShapedFaces& shaped = parts_.cells.shaped;
    for (std::size_t f = 0; f < shaped.size(); ++f)
    {
      const auto side = [&](std::uint32_t cell) {
        return cell == ShapedFaces::SomeHexahedron ? Beyond{ cell, NoBoundary }
          : cell != None                           ? beyond(None, cell)
                                                   : Beyond{ None, shaped.boundary[f] };
      };
      expose(side(shaped.cells[f][0]), side(shaped.cells[f][1]), f, BoundaryFace::Kind::Shaped,
        BoundaryFace::Kind::TurnedShaped);
    }
  }

  // Hexahedra at the end of the grid, where the meshlines cut the domain, or without a neighbour,
  // where the surface leaks. On a flawed side only the hexahedron has a face.
  void exposeBoxSides()
  {
    const auto& flawed = parts_.inner.flawed;
    const bool anywhere = std::find(flawed.begin(), flawed.end(), 1) != flawed.end();
    const Boxes& boxes = parts_.boxes;
    for (std::uint32_t b = boxes.firstBoxOf(boxes.core.begin); b < boxes.firstBoxOf(boxes.core.end);
         ++b)
    {
      if (parts_.sides.polyhedralOrdinal(b) != None)
      {
        continue;
      }
      const Box& box = boxes.boxes[b];
      for (unsigned i = 0; i < 6; ++i)
      {
        if ((anywhere || isAtEnd(box, i / 2, i % 2 == 1)) &&
          exposed(b, static_cast<int>(i / 2), i % 2 == 1))
        {
          exposed_.push_back(
            { numbers_.ofBox[b], std::size_t(6) * b + i, NoBoundary, BoundaryFace::Kind::BoxSide });
        }
      }
    }
  }

  bool isAtEnd(const Box& box, std::size_t axis, bool upper) const
  {
    const auto& planes = parts_.boxes.planes[axis];
    return upper ? box.high[axis] == planes.back() : box.low[axis] == planes.front();
  }

  // A hexahedron has one neighbour on each side, or none. Where the side between them carries
  // faces, they are the boundary; a side without any is missing.
  bool exposed(std::uint32_t b, int axis, bool upper) const
  {
    const std::uint32_t other = facing(parts_.boxes, parts_.boxes.boxes[b], axis, upper)[0];
    const std::uint32_t n = parts_.sides.polyhedralOrdinal(other);
    if (n == None)
    {
      return other == None;
    }
    if (parts_.sides.boxStart[n] == parts_.sides.boxStart[n + 1]) // was a hexahedron
    {
      return false;
    }
    for (std::size_t i = parts_.sides.boxStart[n]; i < parts_.sides.boxStart[n + 1]; ++i)
    {
      const std::uint32_t s = parts_.sides.ofBox[i].side;
      if ((upper ? parts_.sides.sides[s].low : parts_.sides.sides[s].high) == b)
      {
        return parts_.inner.sideStart[s] == parts_.inner.sideStart[s + 1];
      }
    }
    return true;
  }

  const MeshParts& parts_;
  const CellNumbers& numbers_;
  std::vector<BoundaryFace> exposed_;
};

}

std::int32_t boundaryBeyond(const Patches& patches, const Sides& sides, std::uint32_t box)
{
  const std::uint32_t n = sides.polyhedralOrdinal(box);
  const std::uint32_t of = n == None ? None : sides.patchBox[n];
  return of == None || patches.boxStart[of] == patches.boxStart[of + 1]
    ? NoBoundary
    : patches.boundary[patches.boxStart[of]];
}

CellNumbers numberCells(const MeshParts& parts)
{
  const Boxes& boxes = parts.boxes;
  const Cells& cells = parts.cells;
  CellNumbers numbers;
  numbers.ofBox.reserve(boxes.boxes.size() + 1);
  numbers.ofCell.assign(cells.size(), None);
  numbers.coreBegin = cells.size();
  std::uint32_t next = 0;
  for (std::uint32_t b = 0; b < boxes.boxes.size(); ++b)
  {
    const bool isCore = boxes.isCore(boxes.boxes[b]);
    numbers.ofBox.push_back(isCore ? next : CellNumbers::Elsewhere);
    const std::uint32_t n = parts.sides.polyhedralOrdinal(b);
    if (n == None)
    {
      next += isCore ? 1 : 0;
      continue;
    }
    if (isCore)
    {
      numbers.coreBegin = std::min(numbers.coreBegin, cells.boxStart[n]);
      numbers.coreEnd = cells.boxStart[n + 1];
    }
    for (std::size_t c = cells.boxStart[n]; c < cells.boxStart[n + 1]; ++c)
    {
      if (!cells.cells[c].removed)
      {
        numbers.ofCell[c] = isCore ? next++ : CellNumbers::Elsewhere;
      }
    }
  }
  numbers.coreBegin = std::min(numbers.coreBegin, numbers.coreEnd);
  numbers.ofBox.push_back(next);
  return numbers;
}

std::vector<BoundaryFace> collectBoundary(const MeshParts& parts, const CellNumbers& numbers)
{
  return Collector(parts, numbers).collect();
}

}
