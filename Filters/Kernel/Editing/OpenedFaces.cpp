// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/OpenedFaces.h"

#include "Base/EdgeTable.h"
#include "Base/Sorting.h"
#include "Editing/NearWallSelection.h"
#include "Lattice/NearestPlace.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace cartesian
{

namespace
{

constexpr std::size_t CellsAChunk = 256;
constexpr std::size_t FacesAChunk = 1024;

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

// The wall (Walls.h) of a face that is exposed, as there is no cell beyond it: that of the nearest patch in the box there,
// if that has several.
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

// Lists the faces of some cells, or some faces.
class FaceLister
{
public:
  FaceLister(
    const MeshParts& parts, const OpenedCells& numbers, std::size_t cells, OpenedFaceList& list)
    : parts_(parts)
    , numbers_(numbers)
    , list_(list)
  {
    known_.reset(8 * cells);
  }

  void add(CellKey key)
  {
    if (!isHexahedron(key))
    {
      parts_.wall.forEachUse(key, [&](const FaceUse& use) { addFace(key, use); });
      return;
    }
    for (unsigned side = 0; side < 6; ++side)
    {
      lookBeside(parts_.boxes, parts_.sides, parts_.wall, boxOfHexahedron(key), side, beside_);
      for (const FaceUse& use : beside_.faces)
      {
        addFace(key, use);
      }
      if (beside_.faces.empty())
      {
        addSide(boxOfHexahedron(key), side);
      }
    }
  }

  // A face of the wall mesh, unless it is one of a cell that is opened.
  void addOther(std::uint32_t f)
  {
    const auto& [below, above] = parts_.wall.faces.cells[f];
    const auto isOpened = [&](CellKey key) { return isThere(key) && numbers_[key] != None; };
    if ((isThere(below) || isThere(above)) && !isOpened(below) && !isOpened(above))
    {
      const FaceUse use(f, !isThere(below));
      addFace(use.turned ? above : below, use);
    }
  }

  // The sides of a hexahedron that is not opened where the box beyond has no faces: they did not close.
  void addOpenSides(std::uint32_t box)
  {
    for (unsigned side = 0; side < 6; ++side)
    {
      lookBeside(parts_.boxes, parts_.sides, parts_.wall, box, side, beside_);
      if (beside_.isPolyhedral && beside_.faces.empty())
      {
        addSide(box, side);
      }
    }
  }

private:
  bool isThere(CellKey key) const { return key != None && !parts_.wall.isRemoved(key); }

  // Where both its cells are opened, it is listed to that below.
  void addFace(CellKey key, const FaceUse& use)
  {
    const CellKey other = parts_.wall.faces.beyond(use);
    const bool isBetween = isThere(other);
    if (isBetween && use.turned && numbers_[other] != None)
    {
      return;
    }
    const std::size_t begin = list_.corners.size();
    parts_.wall.faces.forEachNode(use, [&](std::uint32_t node) { list_.corners.push_back(node); });
    const std::int32_t wall =
      isBetween ? parts_.wall.faces.boundary[use.face] : wallBeyond(use, other);
    close({ begin, 0, use.face, key, isBetween ? other : CellKey(None), wall });
  }

  // Of a face without a cell beyond.
  std::int32_t wallBeyond(const FaceUse& use, CellKey removed) const
  {
    const WallFaces& faces = parts_.wall.faces;
    if (removed != None)
    {
      const Cell& there = parts_.wall.cells[removed];
      return exposedWall(parts_, use.face, there.box, there.boundary);
    }
    std::uint32_t box = None;
    if (faces.isOfSide(use.face))
    {
      const auto next = std::upper_bound(faces.sideStart.begin(), faces.sideStart.end(), use.face);
      const auto s = static_cast<std::size_t>(next - faces.sideStart.begin()) - 1;
      box = use.turned ? parts_.sides.common[s].low : parts_.sides.common[s].high;
    }
    return exposedWall(parts_, use.face, box, faces.boundary[use.face]);
  }

  // Of a hexahedron: no polyhedron has a face there.
  void addSide(std::uint32_t box, unsigned side)
  {
    const CellKey other =
      beside_.box == None || beside_.isPolyhedral ? CellKey(None) : keyOfHexahedron(beside_.box);
    const bool upper = side % 2 == 1;
    if (!upper && other != None && numbers_[other] != None)
    {
      return;
    }
    const std::array<unsigned, 4> ring = sideCorners(static_cast<int>(side / 2), upper ? 1 : 0);
    const std::size_t begin = list_.corners.size();
    for (std::size_t i = 0; i < 4; ++i)
    {
      list_.corners.push_back(cornerNode(box, ring[upper ? i : 3 - i]));
    }
    close({ begin, 0, None, keyOfHexahedron(box), other, NoBoundary });
  }

  void close(OpenedFace face)
  {
    for (const CellKey key : { face.below, face.above })
    {
      if (key != None && numbers_[key] == None)
      {
        list_.ghosts.push_back(std::uint64_t(boxOf(parts_.wall, key)) << 32 | key);
      }
    }
    face.end = list_.corners.size();
    list_.faces.push_back(face);
  }

  // In Nodes, or behind those: one of `vertices`.
  std::uint32_t cornerNode(std::uint32_t box, unsigned corner)
  {
    const std::uint32_t node = nodeOfCorner(parts_.boxes, parts_.sides, parts_.nodes, box, corner);
    if (node != None)
    {
      return node;
    }
    const VertexNode vertex = vertexAt(parts_.boxes, box, corner);
    const auto row =
      static_cast<std::uint32_t>(vertex.j + vertex.k * parts_.boxes.planes[1].size());
    std::uint32_t& number = known_.at(row, vertex.i);
    if (number == EdgeTable::Fresh)
    {
      number = static_cast<std::uint32_t>(parts_.nodes.at.size() + list_.vertices.size());
      list_.vertices.push_back(vertex);
    }
    return number;
  }

  const MeshParts& parts_;
  const OpenedCells& numbers_;
  OpenedFaceList& list_;
  EdgeTable known_; // vertices
  BesideHexahedron beside_;
};

// Gathers those of all lists, and numbers them as one.
void gatherVertices(OpenedFaces& faces, std::size_t known, Execution& execution)
{
  std::vector<std::uint32_t> first(faces.lists.size());
  for (std::size_t i = 0; i < faces.lists.size(); ++i)
  {
    const std::vector<VertexNode>& more = faces.lists[i].vertices;
    first[i] = static_cast<std::uint32_t>(faces.vertices.size());
    faces.vertices.insert(faces.vertices.end(), more.begin(), more.end());
  }
  execution.forEach(faces.lists.size(), 1, [&](std::size_t i, std::size_t) {
    for (std::uint32_t& node : faces.lists[i].corners)
    {
      node += node >= known ? first[i] : 0;
    }
  });
}

}

OpenedCells::OpenedCells(const MeshParts& parts, Execution& execution)
  : ofCell_(parts.wall.size())
  , ofHexahedron_(parts.boxes.packed.size())
{
  for (RawVector<std::uint32_t>* numbers : { &ofCell_, &ofHexahedron_ })
  {
    execution.forEach(numbers->size(), NumbersAChunk, [&](std::size_t begin, std::size_t end) {
      std::fill(
        numbers->begin() + std::ptrdiff_t(begin), numbers->begin() + std::ptrdiff_t(end), None);
    });
  }
}

OpenedFaces listOpenedFaces(const MeshParts& parts, const std::vector<CellKey>& cells,
  const OpenedCells& numbers, Execution& execution)
{
  OpenedFaces result;
  // Lists those of `count` items behind all that are listed: add(lister, i) those of one.
  const auto list = [&](std::size_t count, std::size_t ofChunk, auto&& add) {
    const std::size_t first = result.lists.size();
    result.lists.resize(first + chunks(count, ofChunk));
    execution.forEach(count, ofChunk, [&](std::size_t begin, std::size_t end) {
      FaceLister lister(parts, numbers, end - begin, result.lists[first + begin / ofChunk]);
      for (std::size_t i = begin; i < end; ++i)
      {
        add(lister, i);
      }
    });
  };
  list(cells.size(), CellsAChunk, [&](FaceLister& lister, std::size_t i) { lister.add(cells[i]); });
  list(parts.wall.faces.size(), FacesAChunk,
    [](FaceLister& lister, std::size_t f) { lister.addOther(static_cast<std::uint32_t>(f)); });
  const auto& flawed = parts.wall.flawed;
  const bool isAny = std::find(flawed.begin(), flawed.end(), 1) != flawed.end();
  list(isAny ? parts.boxes.packed.size() : 0, FacesAChunk, [&](FaceLister& lister, std::size_t i) {
    const auto box = static_cast<std::uint32_t>(i);
    if (parts.sides.polyhedralOrdinal(box) == None && numbers[keyOfHexahedron(box)] == None)
    {
      lister.addOpenSides(box);
    }
  });
  gatherVertices(result, parts.nodes.at.size(), execution);
  return result;
}

std::vector<CellKey> takeGhosts(OpenedFaces& faces, Execution& execution)
{
  std::vector<std::uint64_t> ghosts;
  for (OpenedFaceList& list : faces.lists)
  {
    ghosts.insert(ghosts.end(), list.ghosts.begin(), list.ghosts.end());
    std::vector<std::uint64_t>().swap(list.ghosts);
  }
  sortAll(ghosts, execution);
  ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
  std::vector<CellKey> cells(ghosts.size());
  std::transform(ghosts.begin(), ghosts.end(), cells.begin(),
    [](std::uint64_t ghost) { return static_cast<CellKey>(ghost); });
  return cells;
}

void sortFaces(OpenedFaceList& list, const RawVector<std::uint32_t>& nodeOf)
{
  for (std::uint32_t& corner : list.corners)
  {
    corner = nodeOf[corner];
  }
  const auto corner = [&](std::size_t i) { return list.corners.begin() + std::ptrdiff_t(i); };
  for (const OpenedFace& face : list.faces)
  {
    std::rotate(
      corner(face.begin), std::min_element(corner(face.begin), corner(face.end)), corner(face.end));
  }
  for (auto begin = list.faces.begin(); begin != list.faces.end();)
  {
    const auto end = std::find_if(
      begin, list.faces.end(), [&](const OpenedFace& face) { return face.below != begin->below; });
    std::sort(begin, end, [&](const OpenedFace& x, const OpenedFace& y) {
      return std::lexicographical_compare(
        corner(x.begin), corner(x.end), corner(y.begin), corner(y.end));
    });
    begin = end;
  }
}

}
