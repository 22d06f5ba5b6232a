#include "Boundary.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// What lies on one side of an inner face.
struct Beyond
{
  std::uint32_t cell = None; // number of the cell that stays there
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
    for (std::size_t c = 0; c < cells.size(); ++c)
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
    const std::uint32_t n = parts_.sides.ordinal[box];
    if (n == None)
    {
      return { numbers_.ofBox[box], NoBoundary };
    }
    const std::size_t first = parts_.patches.boxStart[n];
    return { None,
      first < parts_.patches.boxStart[n + 1] ? parts_.patches.boundary[first] : NoBoundary };
  }

  void exposeInnerFaces(std::size_t s)
  {
    const Side& side = parts_.sides.sides[s];
    for (std::size_t f = parts_.inner.sideStart[s]; f < parts_.inner.sideStart[s + 1]; ++f)
    {
      const Beyond low = beyond(side.low, parts_.cells.ofInnerFace[f][0]);
      const Beyond high = beyond(side.high, parts_.cells.ofInnerFace[f][1]);
      if (low.cell != None && high.cell == None)
      {
        exposed_.push_back({ low.cell, f, high.boundary, BoundaryFace::Kind::Inner });
      }
      if (low.cell == None && high.cell != None)
      {
        exposed_.push_back({ high.cell, f, low.boundary, BoundaryFace::Kind::TurnedInner });
      }
    }
  }

  // Inside boxes at the end of the grid, where the meshlines cut the domain, or without a
  // neighbour, where the surface leaks. On a flawed side only the inside box has a face.
  void exposeBoxSides()
  {
    const auto& flawed = parts_.inner.flawed;
    const bool anywhere =
      !parts_.boxes.closed || std::find(flawed.begin(), flawed.end(), 1) != flawed.end();
    for (std::uint32_t b = 0; b < parts_.boxes.boxes.size(); ++b)
    {
      const Box& box = parts_.boxes.boxes[b];
      if (box.status != BoxStatus::Inside)
      {
        continue;
      }
      for (int axis = 0; axis < 3; ++axis)
      {
        const bool first = box.global[axis] == 0;
        const bool last = box.global[axis] + 2 == parts_.boxes.planes[axis].size();
        for (const int direction : { -1, +1 })
        {
          const bool atEnd = direction < 0 ? first : last;
          if ((atEnd || anywhere) && exposed(box, axis, direction))
          {
            exposed_.push_back({ numbers_.ofBox[b], std::size_t(6) * b + 2 * axis + (direction > 0),
              NoBoundary, BoundaryFace::Kind::BoxSide });
          }
        }
      }
    }
  }

  bool exposed(const Box& box, int axis, int direction) const
  {
    std::array<std::int64_t, 3> at = { box.global[0], box.global[1], box.global[2] };
    at[axis] += direction;
    const std::uint32_t other = boxAt(parts_.boxes, at[0], at[1], at[2]);
    if (other == None)
    {
      return true;
    }
    const std::uint32_t n = parts_.sides.ordinal[other];
    if (n == None)
    {
      return false;
    }
    // Where the side carries faces, they are the boundary; a side without any is missing here.
    const std::uint32_t side = parts_.sides.ofBox[n][2 * axis + (direction < 0)];
    return parts_.inner.sideStart[side] == parts_.inner.sideStart[side + 1];
  }

  const MeshParts& parts_;
  const CellNumbers& numbers_;
  std::vector<BoundaryFace> exposed_;
};

}

CellNumbers numberCells(const MeshParts& parts)
{
  CellNumbers numbers;
  numbers.ofBox.reserve(parts.boxes.boxes.size() + 1);
  numbers.ofCell.assign(parts.cells.size(), None);
  std::uint32_t next = 0;
  std::size_t n = 0;
  for (const Box& box : parts.boxes.boxes)
  {
    numbers.ofBox.push_back(next);
    if (box.status == BoxStatus::Inside)
    {
      ++next;
      continue;
    }
    for (std::size_t c = parts.cells.boxStart[n]; c < parts.cells.boxStart[n + 1]; ++c)
    {
      if (!parts.cells.cells[c].removed)
      {
        numbers.ofCell[c] = next++;
      }
    }
    ++n;
  }
  numbers.ofBox.push_back(next);
  return numbers;
}

std::vector<BoundaryFace> collectBoundary(const MeshParts& parts, const CellNumbers& numbers)
{
  return Collector(parts, numbers).collect();
}

}
