// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Boundary.h"

#include "Base/Sorting.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t ItemsAChunk = 1024;

// Calls list(i, faces) for the items from `first` to `end`; returns the faces in the order of items.
template <class List>
std::vector<BoundaryFace> facesOfEach(
  std::size_t first, std::size_t end, Execution& execution, List&& list)
{
  std::vector<std::vector<BoundaryFace>> parts(chunks(end - first, ItemsAChunk));
  execution.forEach(end - first, ItemsAChunk, [&](std::size_t from, std::size_t to) {
    for (std::size_t i = first + from; i < first + to; ++i)
    {
      list(i, parts[from / ItemsAChunk]);
    }
  });
  std::vector<BoundaryFace> all;
  for (const std::vector<BoundaryFace>& part : parts)
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

class Collector
{
public:
  Collector(const MeshParts& parts, const CellNumbers& numbers)
    : parts_(parts)
    , numbers_(numbers)
  {
  }

  std::vector<BoundaryFace> collect(Execution& execution) const
  {
    using Faces = std::vector<BoundaryFace>;
    const Boxes& boxes = parts_.boxes;
    const auto& flawed = parts_.wall.flawed;
    const bool anywhere = std::find(flawed.begin(), flawed.end(), 1) != flawed.end();
    Faces result = facesOfEach(0, parts_.wall.faces.size(), execution,
      [&](std::size_t f, Faces& faces) { addFace(f, faces); });
    const Faces ofBoxes = facesOfEach(boxes.row(0, boxes.core.begin), boxes.row(0, boxes.core.end),
      execution, [&](std::size_t row, Faces& faces) { exposeBoxesOfRow(row, anywhere, faces); });
    result.insert(result.end(), ofBoxes.begin(), ofBoxes.end());
    sortAll(result, execution);
    if (boxes.ends != NoEnds)
    {
      nameEnds(result, execution);
    }
    return result;
  }

private:
  // None: there is no cell, or it was removed.
  std::uint32_t numberOf(CellKey cell) const
  {
    return cell == None    ? std::uint32_t(None)
      : isHexahedron(cell) ? numbers_.ofBox[boxOfHexahedron(cell)]
                           : numbers_.ofCell[cell];
  }

  // Both sides of a face of a baffle are boundary faces.
  void addFace(std::size_t f, std::vector<BoundaryFace>& faces) const
  {
    const Walls& walls = parts_.patches.walls;
    const WallFaces& all = parts_.wall.faces;
    const std::int32_t wall = all.boundary[f];
    const std::array<std::uint32_t, 2> cells{ numberOf(all.cells[f][0]),
      numberOf(all.cells[f][1]) };
    for (const std::size_t side : { 0U, 1U })
    {
      const bool isEnd = cells[1 - side] == None;
      if (CellNumbers::isHere(cells[side]) && (isEnd || walls.isBaffle(wall)))
      {
        const bool isFront = !isEnd && side == 1;
        const FaceUse use(f, side == 1);
        faces.push_back({ cells[side], f,
          isFront ? walls.boundaryInFront(wall) : walls.boundary(wall), kindOf(all, use) });
      }
    }
  }

  // Apart from the first and the last global box of a row, most are not at the end of the grid.
  void exposeBoxesOfRow(std::size_t row, bool anywhere, std::vector<BoundaryFace>& faces) const
  {
    const Boxes& boxes = parts_.boxes;
    const std::size_t first = boxes.rowStart[row];
    const std::size_t end = boxes.rowStart[row + 1];
    const auto expose = [&](std::size_t from, std::size_t to) {
      for (std::uint32_t b = boxes.globals[from].firstBox; b < boxes.globals[to].firstBox; ++b)
      {
        exposeBoxSides(b, anywhere, faces);
      }
    };
    const std::size_t rowsOfLayer = boxes.planes[1].size() - 1;
    const std::size_t j = row % rowsOfLayer;
    const std::size_t k = row / rowsOfLayer;
    if (anywhere || j == 0 || j + 1 == rowsOfLayer || k == 0 || k + 2 == boxes.planes[2].size())
    {
      expose(first, end);
    }
    else if (first < end)
    {
      expose(first, first + 1);
      expose(std::max(first + 1, end - 1), end);
    }
  }

  // Adds sides of hexahedra without a box beyond: at the end of the grid, where the meshlines cut the domain, or
  // where the surface leaks (`anywhere`).
  void exposeBoxSides(std::uint32_t b, bool anywhere, std::vector<BoundaryFace>& faces) const
  {
    if (parts_.sides.polyhedralOrdinal(b) != None)
    {
      return;
    }
    const Box box = parts_.boxes.box(b);
    for (unsigned i = 0; i < 6; ++i)
    {
      if ((anywhere || isAtEnd(box, i / 2, i % 2 == 1)) &&
        facing(parts_.boxes, parts_.boxes.packed[b], static_cast<int>(i / 2), i % 2 == 1)[0] ==
          None)
      {
        faces.push_back(
          { numbers_.ofBox[b], std::size_t(6) * b + i, NoBoundary, BoundaryFace::Kind::BoxSide });
      }
    }
  }

  bool isAtEnd(const Box& box, std::size_t axis, bool upper) const
  {
    const auto& planes = parts_.boxes.planes[axis];
    return upper ? box.high[axis] == planes.back() : box.low[axis] == planes.front();
  }

  // Faces where the grid cuts the domain are known by their place: all that is there lies on the last plane.
  void nameEnds(std::vector<BoundaryFace>& faces, Execution& execution) const
  {
    execution.forEach(faces.size(), ItemsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f)
      {
        if (faces[f].boundary == NoBoundary)
        {
          faces[f].boundary = boundaryOfEnd(faces[f]);
        }
      }
    });
  }

  std::int32_t boundaryOfEnd(const BoundaryFace& face) const
  {
    for (std::size_t side = 0; side < 6; ++side)
    {
      if (face.kind == BoundaryFace::Kind::BoxSide ? side == face.index % 6 &&
            isAtEnd(parts_.boxes.box(face.index / 6), side / 2, side % 2 == 1)
                                                   : liesAtEnd(face, side))
      {
        return parts_.boxes.ends[side];
      }
    }
    return NoBoundary;
  }

  bool liesAtEnd(const BoundaryFace& face, std::size_t side) const
  {
    const auto& planes = parts_.boxes.planes[side / 2];
    const Level level = side % 2 == 1 ? planes.back() : planes.front();
    bool all = true;
    parts_.wall.faces.forEachNode(face.use(),
      [&](std::uint32_t node) { all = all && parts_.nodes.at[node][side / 2] == level; });
    return all;
  }

  const MeshParts& parts_;
  const CellNumbers& numbers_;
};

}

namespace
{

// The first cell of the first polyhedral box from this box on.
std::size_t firstCellOf(const MeshParts& parts, std::uint32_t box)
{
  const std::vector<std::uint32_t>& polyhedral = parts.sides.polyhedral;
  const auto at = std::lower_bound(polyhedral.begin(), polyhedral.end(), box);
  return parts.wall.boxStart[static_cast<std::size_t>(at - polyhedral.begin())];
}

// Calls visit(c) for the cells of the n-th polyhedral box, unless n is None.
template <class Visitor>
void forEachCellOf(const WallMesh& wall, std::uint32_t n, Visitor&& visit)
{
  for (std::size_t c = n == None ? 0 : wall.boxStart[n]; n != None && c < wall.boxStart[n + 1]; ++c)
  {
    visit(c);
  }
}

}

BoundaryFace::Kind kindOf(const WallFaces& faces, const FaceUse& use)
{
  using Kind = BoundaryFace::Kind;
  return use.face >= faces.firstShaped ? (use.turned ? Kind::TurnedShaped : Kind::Shaped)
                                       : (use.turned ? Kind::TurnedCut : Kind::Cut);
}

CellNumbers numberCells(const MeshParts& parts, Execution& execution)
{
  const Boxes& boxes = parts.boxes;
  const WallMesh& wall = parts.wall;
  const std::uint32_t first = boxes.firstBoxOf(boxes.core.begin);
  const std::uint32_t end = boxes.firstBoxOf(boxes.core.end);
  const auto isCore = [&](std::size_t box) { return box >= first && box < end; };
  CellNumbers numbers;
  numbers.ofBox.resize(boxes.packed.size() + 1);
  numbers.ofCell.resize(wall.size());
  std::vector<std::uint32_t> next(chunks(boxes.packed.size(), ItemsAChunk));
  const auto forEachBox = [&](auto&& visit) {
    execution.forEach(boxes.packed.size(), ItemsAChunk, [&](std::size_t begin, std::size_t after) {
      for (std::size_t box = begin; box < after; ++box)
      {
        visit(box, parts.sides.polyhedralOrdinal(static_cast<std::uint32_t>(box)),
          next[begin / ItemsAChunk]);
      }
    });
  };
  forEachBox([&](std::size_t box, std::uint32_t n, std::uint32_t& count) {
    count += isCore(box) && n == None ? 1 : 0;
    forEachCellOf(
      wall, n, [&](std::size_t c) { count += isCore(box) && !wall.cells[c].removed ? 1 : 0; });
  });
  numbers.ofBox.back() = scan(next);
  forEachBox([&](std::size_t box, std::uint32_t n, std::uint32_t& number) {
    const auto take = [&] { return isCore(box) ? number++ : CellNumbers::Elsewhere; };
    numbers.ofBox[box] = isCore(box) ? number : CellNumbers::Elsewhere;
    number += isCore(box) && n == None ? 1 : 0;
    forEachCellOf(
      wall, n, [&](std::size_t c) { numbers.ofCell[c] = wall.cells[c].removed ? None : take(); });
  });
  numbers.coreBegin = firstCellOf(parts, first);
  numbers.coreEnd = firstCellOf(parts, end);
  return numbers;
}

std::vector<BoundaryFace> collectBoundary(
  const MeshParts& parts, const CellNumbers& numbers, Execution& execution)
{
  return Collector(parts, numbers).collect(execution);
}

}
