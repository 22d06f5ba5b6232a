// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Boundary.h"

#include "Base/Sorting.h"
#include "Cells/Cells.h"
#include "Lattice/NearestPlace.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace cartesian
{

namespace
{

// What lies on one side of an inner face.
struct OtherSide
{
  std::uint32_t cell = None;          // number of the cell there, if it was not removed
  std::int32_t boundary = NoBoundary; // else the boundary that the face belongs to
  std::uint32_t box = None;           // ... or the nearest in this box, if it has several
};

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

// The mean of a face's nodes, in levels.
Vector middleOf(const MeshParts& parts, std::size_t face)
{
  Vector sum{};
  double count = 0;
  parts.wall.faces.forEachNode({ face, false }, [&](std::uint32_t node) {
    sum = plus(sum, minus(parts.nodes.at[node], Point{}));
    ++count;
  });
  return scaled(sum, 1 / count);
}

// From a patch to a place.
double distanceOf(const MeshParts& parts, std::size_t patch, const Vector& place)
{
  const WallFaces& faces = parts.wall.faces;
  const auto corner = [&](std::size_t i) { return parts.nodes.at[faces.corners[i]]; };
  const std::size_t first = faces.start[patch];
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = first + 1; i + 1 < faces.start[patch + 1]; ++i)
  {
    const Corners triangle{ corner(first), corner(i), corner(i + 1) };
    nearest = std::min(nearest, norm(minus(nearestPlace(triangle, place), place)));
  }
  return nearest;
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
    const WallFaces& all = parts_.wall.faces;
    const auto& flawed = parts_.wall.flawed;
    const bool anywhere = std::find(flawed.begin(), flawed.end(), 1) != flawed.end();
    Faces exposed = facesOfEach(0, parts_.sides.common.size(), execution,
      [&](std::size_t s, Faces& faces) { exposeInnerFaces(s, faces); });
    const Faces others = facesOfEach(all.firstInterface(), all.size(), execution,
      [&](std::size_t f, Faces& faces) { exposeOther(f, faces); });
    const Faces ofBoxes = facesOfEach(boxes.row(0, boxes.core.begin), boxes.row(0, boxes.core.end),
      execution, [&](std::size_t row, Faces& faces) { exposeBoxesOfRow(row, anywhere, faces); });
    exposed.insert(exposed.end(), others.begin(), others.end());
    exposed.insert(exposed.end(), ofBoxes.begin(), ofBoxes.end());
    std::sort(exposed.begin(), exposed.end());
    const Faces patches = facesOfEach(numbers_.coreBegin, numbers_.coreEnd, execution,
      [&](std::size_t c, Faces& faces) { addPatches(c, faces); });
    Faces result(patches.size() + exposed.size());
    std::merge(patches.begin(), patches.end(), exposed.begin(), exposed.end(), result.begin());
    if (boxes.ends != NoEnds)
    {
      nameEnds(result, execution);
    }
    return result;
  }

private:
  void addPatches(std::size_t c, std::vector<BoundaryFace>& faces) const
  {
    const std::uint32_t number = numbers_.ofCell[c];
    const WallFaces& all = parts_.wall.faces;
    const std::size_t before = faces.size();
    parts_.wall.forEachUse(c, [&](const FaceUse& use) {
      if (number != None && all.isPatch(use.face))
      {
        faces.push_back({ number, use.face, parts_.patches.walls.boundary(all.boundary[use.face]),
          BoundaryFace::Kind::Patch });
      }
    });
    std::sort(faces.begin() + std::ptrdiff_t(before), faces.end());
  }

  // `box`: without a cell, the box there, or None.
  OtherSide sideOf(std::size_t face, std::size_t k, std::uint32_t box = None) const
  {
    const CellKey cell = parts_.wall.faces.cells[face][k];
    if (cell == None)
    {
      return { None, parts_.wall.faces.boundary[face], box };
    }
    if (isHexahedron(cell))
    {
      return { numbers_.ofBox[boxOfHexahedron(cell)], NoBoundary };
    }
    const Cell& there = parts_.wall.cells[cell];
    return { numbers_.ofCell[cell], there.boundary, there.box };
  }

  std::int32_t wallOf(const OtherSide& gone, std::size_t face) const
  {
    return exposedWall(parts_, face, gone.box, gone.boundary);
  }

  void add(std::uint32_t cell, const FaceUse& use, std::int32_t boundary,
    std::vector<BoundaryFace>& faces) const
  {
    faces.push_back({ cell, use.face, boundary, kindOf(parts_.wall.faces, use) });
  }

  void expose(const OtherSide& below, const OtherSide& above, std::size_t face,
    std::vector<BoundaryFace>& faces) const
  {
    const Walls& walls = parts_.patches.walls;
    if (CellNumbers::isHere(below.cell) && above.cell == None)
    {
      add(below.cell, { face, false }, walls.boundary(wallOf(above, face)), faces);
    }
    if (below.cell == None && CellNumbers::isHere(above.cell))
    {
      add(above.cell, { face, true }, walls.boundary(wallOf(below, face)), faces);
    }
  }

  // Both sides of a face of a baffle are boundary faces.
  void exposeBaffle(const OtherSide& behind, const OtherSide& front, std::size_t face,
    std::vector<BoundaryFace>& faces) const
  {
    const Walls& walls = parts_.patches.walls;
    const std::int32_t wall = parts_.wall.faces.boundary[face];
    if (!walls.isBaffle(wall) || behind.cell == None || front.cell == None)
    {
      return;
    }
    if (CellNumbers::isHere(behind.cell))
    {
      add(behind.cell, { face, false }, walls.boundary(wall), faces);
    }
    if (CellNumbers::isHere(front.cell))
    {
      add(front.cell, { face, true }, walls.boundaryInFront(wall), faces);
    }
  }

  void exposeInnerFaces(std::size_t s, std::vector<BoundaryFace>& faces) const
  {
    const Side& side = parts_.sides.common[s];
    const auto& start = parts_.wall.faces.sideStart;
    for (std::size_t f = start[s]; f < start[s + 1]; ++f)
    {
      expose(sideOf(f, 0, side.low), sideOf(f, 1, side.high), f, faces);
    }
  }

  // A face between two regions one of which has lost its cell there, or of a baffle; or one that edits made.
  void exposeOther(std::size_t f, std::vector<BoundaryFace>& faces) const
  {
    const OtherSide below = sideOf(f, 0);
    const OtherSide above = sideOf(f, 1);
    expose(below, above, f, faces);
    exposeBaffle(below, above, f, faces);
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

  // Adds sides of hexahedra at the end of the grid, where the meshlines cut the domain, and of hexahedra
  // without a neighbour, where the surface leaks. On a flawed side (`anywhere`) only the hexahedron has a
  // face.
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
        exposed(b, static_cast<int>(i / 2), i % 2 == 1))
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

  // A hexahedron has one neighbour on each side, or none. If the side between them has faces, these are the
  // boundary; a side without faces is added here.
  bool exposed(std::uint32_t b, int axis, bool upper) const
  {
    const std::uint32_t other = facing(parts_.boxes, parts_.boxes.packed[b], axis, upper)[0];
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
      if ((upper ? parts_.sides.common[s].low : parts_.sides.common[s].high) == b)
      {
        return parts_.wall.faces.sideStart[s] == parts_.wall.faces.sideStart[s + 1];
      }
    }
    return true;
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
  switch (faces.originOf(use.face))
  {
    case FaceOrigin::Patch:
      return Kind::Patch;
    case FaceOrigin::Shaped:
      return use.turned ? Kind::TurnedShaped : Kind::Shaped;
    default:
      return use.turned ? Kind::TurnedInner : Kind::Inner;
  }
}

std::int32_t exposedWall(
  const MeshParts& parts, std::size_t face, std::uint32_t box, std::int32_t otherwise)
{
  const Patches& patches = parts.patches;
  const std::uint32_t n = parts.sides.polyhedralOrdinal(box);
  const std::uint32_t of = n == None ? None : parts.sides.patchBox[n];
  const std::size_t first = of == None ? 0 : patches.boxStart[of];
  const std::size_t end = of == None ? 0 : patches.boxStart[of + 1];
  const auto ofBox = patches.boundary.begin();
  if (std::adjacent_find(ofBox + std::ptrdiff_t(first), ofBox + std::ptrdiff_t(end),
        std::not_equal_to<>()) == ofBox + std::ptrdiff_t(end))
  {
    return otherwise;
  }
  const Vector place = middleOf(parts, face);
  std::pair<double, std::int32_t> nearest{ std::numeric_limits<double>::infinity(), otherwise };
  for (std::size_t p = first; p < end; ++p)
  {
    if (patches.walls.isInterface(patches.boundary[p]))
    {
      continue;
    }
    const double distance = distanceOf(parts, p, place);
    nearest = distance < nearest.first ? std::pair(distance, patches.boundary[p]) : nearest;
  }
  return nearest.second;
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
