// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/OpenedFaces.h"

#include "Base/EdgeTable.h"
#include "Base/Sorting.h"
#include "Editing/NearWallSelection.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t CellsAChunk = 256;

// Lists the faces of some cells.
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
    close({ begin, 0, use.face, key, isBetween ? other : CellKey(None), wall, use.turned != 0 });
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
    if (faces.originOf(use.face) == FaceOrigin::Side)
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
    close({ begin, 0, None, keyOfHexahedron(box), other, NoBoundary, false });
  }

  void close(OpenedFace face)
  {
    if (face.above != None && numbers_[face.above] == None)
    {
      list_.ghosts.push_back(std::uint64_t(boxOf(parts_.wall, face.above)) << 32 | face.above);
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
  OpenedFaces faces;
  faces.lists.resize(chunks(cells.size(), CellsAChunk));
  execution.forEach(cells.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    FaceLister lister(parts, numbers, end - begin, faces.lists[begin / CellsAChunk]);
    for (std::size_t k = begin; k < end; ++k)
    {
      lister.add(cells[k]);
    }
  });
  gatherVertices(faces, parts.nodes.at.size(), execution);
  return faces;
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
