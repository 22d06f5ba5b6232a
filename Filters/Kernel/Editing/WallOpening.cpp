// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/EditMeasures.h"
#include "Editing/EditableWall.h"
#include "Editing/NodeKinds.h"
#include "Editing/WallRing.h"
#include "Lattice/PointSortKey.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <unordered_map>

namespace cartesian
{

namespace
{

constexpr float MostMissing = 0.1F; // in boxes: what patches may lack that is believed

class Opening
{
public:
  Opening(const MeshParts& parts, EditableWall& result, Execution& execution)
    : parts_(parts)
    , result_(result)
    , mesh_(result.mesh)
    , execution_(execution)
    , keys_(cellsToEdit(parts))
    , ofCell_(parts.wall.size(), None)
    , ofHexahedron_(parts.boxes.packed.size(), None)
  {
  }

  void run(double featureAngle)
  {
    chooseUnit();
    for (const CellKey key : keys_)
    {
      addCell(key, CellState::Free);
    }
    result_.opened.cells = static_cast<std::uint32_t>(mesh_.cellCount());
    std::for_each(keys_.begin(), keys_.end(), [&](CellKey key) { listFaces(key); });
    addGhosts();
    addNodes();
    addFaces();
    mesh_.connect();
    freeze();
    measure();
    findNodeKinds(mesh_, parts_.nodes.kinds, featureAngle);
  }

private:
  // A face as the cell below has it.
  struct Listed
  {
    std::size_t begin; // in corners_
    std::size_t end;
    std::uint32_t number; // in WallFaces, or None
    CellKey below;
    CellKey above; // or None
    std::int32_t wall;
    bool turned;
  };

  // Vertices of the global mesh that are not in Nodes: numbered behind those.
  struct NewVertices
  {
    std::vector<VertexNode> all;
    std::unordered_map<std::uint64_t, std::uint32_t> numbers;
  };

  // --- cells

  // The smallest box has an edge of 1 to 2 units. The first planes are an origin for all parts of a mesh.
  void chooseUnit()
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      result_.origin[axis] = parts_.boxes.planes[axis].front();
    }
    double least = 0;
    for (const CellKey key : keys_)
    {
      const double edge = edgeOf(parts_.boxes.box(boxOf(parts_.wall, key)));
      least = least > 0 ? std::min(least, edge) : edge;
    }
    mesh_.store().level = least > 0 ? std::ldexp(1.0, -std::ilogb(least)) : 1;
    Point end = result_.origin;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      end[axis] = parts_.boxes.planes[axis].back();
    }
    mesh_.store().low = Vector{};
    mesh_.store().high = result_.inside(end);
  }

  static double edgeOf(const Box& box)
  {
    const Vector size = minus(box.high, box.low);
    return std::cbrt(size[0] * size[1] * size[2]);
  }

  std::uint32_t& numberOf(CellKey key)
  {
    return isHexahedron(key) ? ofHexahedron_[boxOfHexahedron(key)] : ofCell_[key];
  }

  bool isThere(CellKey key) const { return key != None && !parts_.wall.isRemoved(key); }

  void addCell(CellKey key, CellState state)
  {
    const std::uint32_t box = boxOf(parts_.wall, key);
    const Box at = parts_.boxes.box(box);
    const Vector low = result_.inside(at.low);
    const Vector high = result_.inside(at.high);
    const Vector size = minus(high, low);
    EditCell cell;
    cell.centre = scaled(plus(low, high), 0.5);
    cell.box = size[0] * size[1] * size[2];
    cell.volume = cell.box;
    cell.edge = std::cbrt(cell.box);
    cell.number = key;
    cell.home = box;
    cell.state = state;
    cell.wall = isHexahedron(key) ? NoBoundary : parts_.wall.cells[key].boundary;
    cell.region = isHexahedron(key) ? parts_.boxes.regionOf(box) : parts_.wall.cells[key].region;
    numberOf(key) = mesh_.addCell(cell);
  }

  // Each is all of its box: cells of intersected boxes are no ghosts.
  void addGhosts()
  {
    std::sort(ghosts_.begin(), ghosts_.end(),
      [&](CellKey a, CellKey b) { return boxOf(parts_.wall, a) < boxOf(parts_.wall, b); });
    ghosts_.erase(std::unique(ghosts_.begin(), ghosts_.end()), ghosts_.end());
    for (const CellKey key : ghosts_)
    {
      addCell(key, CellState::Ghost);
    }
  }

  // --- faces

  void listFaces(CellKey key)
  {
    if (!isHexahedron(key))
    {
      parts_.wall.forEachUse(key, [&](const FaceUse& use) { listFace(key, use); });
      return;
    }
    for (unsigned side = 0; side < 6; ++side)
    {
      lookBeside(parts_.boxes, parts_.sides, parts_.wall, boxOfHexahedron(key), side, beside_);
      for (const FaceUse& use : beside_.faces)
      {
        listFace(key, use);
      }
      if (beside_.faces.empty())
      {
        listSide(boxOfHexahedron(key), side);
      }
    }
  }

  // Where both its cells are opened, it is listed to that below.
  void listFace(CellKey key, const FaceUse& use)
  {
    const CellKey other = parts_.wall.faces.beyond(use);
    const bool isBetween = isThere(other);
    if (isBetween && use.turned && numberOf(other) != None)
    {
      return;
    }
    const std::size_t begin = corners_.size();
    parts_.wall.faces.forEachNode(use, [&](std::uint32_t node) { corners_.push_back(node); });
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
  void listSide(std::uint32_t box, unsigned side)
  {
    const CellKey other =
      beside_.box == None || beside_.isPolyhedral ? CellKey(None) : keyOfHexahedron(beside_.box);
    const bool upper = side % 2 == 1;
    if (!upper && other != None && numberOf(other) != None)
    {
      return;
    }
    const std::array<unsigned, 4> ring = sideCorners(static_cast<int>(side / 2), upper ? 1 : 0);
    const std::size_t begin = corners_.size();
    for (std::size_t i = 0; i < 4; ++i)
    {
      corners_.push_back(cornerNode(box, ring[upper ? i : 3 - i]));
    }
    close({ begin, 0, None, keyOfHexahedron(box), other, NoBoundary, false });
  }

  void close(Listed face)
  {
    if (face.above != None && numberOf(face.above) == None)
    {
      ghosts_.push_back(face.above);
    }
    face.end = corners_.size();
    faces_.push_back(face);
  }

  // In Nodes, or behind those: a vertex of the global mesh that is not there.
  std::uint32_t cornerNode(std::uint32_t box, unsigned corner)
  {
    const std::uint32_t node = nodeOfCorner(parts_.boxes, parts_.sides, parts_.nodes, box, corner);
    if (node != None)
    {
      return node;
    }
    VertexNode vertex = vertexAt(parts_.boxes, box, corner);
    const auto& planes = parts_.boxes.planes;
    const std::uint64_t row = vertex.j + vertex.k * std::uint64_t(planes[1].size());
    vertex.node = static_cast<std::uint32_t>(parts_.nodes.at.size() + vertices_.all.size());
    const auto [known, isNew] =
      vertices_.numbers.emplace(vertex.i + row * planes[0].size(), vertex.node);
    if (isNew)
    {
      vertices_.all.push_back(vertex);
    }
    return known->second;
  }

  Point placeOf(std::uint32_t node) const
  {
    const std::size_t known = parts_.nodes.at.size();
    if (node < known)
    {
      return parts_.nodes.at[node];
    }
    const VertexNode& vertex = vertices_.all[node - known];
    const auto& planes = parts_.boxes.planes;
    return { planes[0][vertex.i], planes[1][vertex.j], planes[2][vertex.k] };
  }

  // --- nodes

  // In the order of their places; corners_ then has their numbers. No two share a place.
  void addNodes()
  {
    const std::size_t known = parts_.nodes.at.size();
    std::vector<std::uint32_t> numbers(known + vertices_.all.size(), None);
    std::vector<PointSortKey> places;
    for (const std::uint32_t node : corners_)
    {
      if (numbers[node] == None)
      {
        numbers[node] = 0;
        places.emplace_back(placeOf(node), node);
      }
    }
    std::sort(places.begin(), places.end());
    mesh_.reserve(places.size(), faces_.size(), mesh_.cellCount(), corners_.size());
    for (const PointSortKey& place : places)
    {
      const std::uint32_t from = place.number();
      EditNode node;
      node.at = result_.inside(place.point());
      node.home = node.at;
      node.number = from < known ? from : std::uint32_t(None);
      numbers[from] = mesh_.addNode(node);
    }
    for (std::uint32_t& corner : corners_)
    {
      corner = numbers[corner];
    }
    for (VertexNode vertex : vertices_.all)
    {
      vertex.node = numbers[vertex.node];
      result_.opened.onVertices.push_back(vertex);
    }
    result_.opened.nodes = static_cast<std::uint32_t>(mesh_.nodeCount());
  }

  // --- faces of the mesh

  void addFaces()
  {
    const auto corner = [&](std::size_t i) { return corners_.begin() + std::ptrdiff_t(i); };
    for (const Listed& face : faces_)
    {
      std::rotate(corner(face.begin), std::min_element(corner(face.begin), corner(face.end)),
        corner(face.end));
    }
    for (auto begin = faces_.begin(); begin != faces_.end();)
    {
      const auto end = std::find_if(
        begin, faces_.end(), [&](const Listed& face) { return face.below != begin->below; });
      std::sort(begin, end, [&](const Listed& x, const Listed& y) {
        return std::lexicographical_compare(
          corner(x.begin), corner(x.end), corner(y.begin), corner(y.end));
      });
      std::for_each(begin, end, [&](const Listed& face) { addFace(face); });
      begin = end;
    }
  }

  void addFace(const Listed& listed)
  {
    const std::uint32_t* const corners = corners_.data() + listed.begin;
    const std::size_t size = listed.end - listed.begin;
    EditFace face;
    face.below = numberOf(listed.below);
    face.above = listed.above == None ? None : numberOf(listed.above);
    face.number = listed.number;
    face.wall = listed.wall;
    std::uint8_t held = 0;
    if (face.above != None && mesh_.isGhost(face.above))
    {
      held = HeldFast;
    }
    else if (face.above == None && listed.wall == NoBoundary)
    {
      held = holdAtEnd(corners, size, face.wall);
    }
    for (std::size_t i = 0; i < size; ++i)
    {
      EditNode& node = mesh_.rawNode(corners[i]);
      node.held |= held;
      node.atWall = node.atWall || (face.above != None && face.wall != NoBoundary);
    }
    mesh_.addFace(face, corners, size);
    AsOpened& opened = result_.opened;
    opened.corners.insert(opened.corners.end(), corners, corners + size);
    opened.start.push_back(static_cast<std::uint32_t>(opened.corners.size()));
    opened.cellsOf.push_back({ face.below, face.above });
    opened.turned.push_back(listed.turned ? 1 : 0);
  }

  // Nodes at an end of the grid may slide in it; where nothing is known of a wall, they stay.
  std::uint8_t holdAtEnd(const std::uint32_t* corners, std::size_t size, std::int32_t& wall) const
  {
    for (std::size_t side = 0; side < 6; ++side)
    {
      const std::size_t axis = side / 2;
      const auto& planes = parts_.boxes.planes[axis];
      Point end = result_.origin;
      end[axis] = side % 2 == 1 ? planes.back() : planes.front();
      const double at = result_.inside(end)[axis];
      if (std::all_of(
            corners, corners + size, [&](std::uint32_t n) { return mesh_.node(n).at[axis] == at; }))
      {
        wall = wallOfEnd(side);
        return static_cast<std::uint8_t>(1 << axis);
      }
    }
    return HeldFast;
  }

  // Cells that touch themselves along an edge, where the surface does, stay as they are.
  void freeze()
  {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges; // of a cell, counter-clockwise
    for (std::uint32_t c = 0; c < result_.opened.cells; ++c)
    {
      if (isHexahedron(mesh_.cell(c).number))
      {
        continue;
      }
      edges.clear();
      for (const std::uint32_t f : mesh_.facesOf(c))
      {
        const Items corners = mesh_.cornersOf(f);
        const bool turned = mesh_.face(f).above == c;
        std::uint32_t from = corners[corners.size() - 1];
        for (const std::uint32_t to : corners)
        {
          edges.emplace_back(turned ? to : from, turned ? from : to);
          from = to;
        }
      }
      std::sort(edges.begin(), edges.end());
      if (std::adjacent_find(edges.begin(), edges.end()) != edges.end())
      {
        mesh_.rawCell(c).state = CellState::Frozen;
      }
    }
  }

  // --- measures

  void measure()
  {
    measureAll(mesh_.store(), execution_);
    const Patches& patches = parts_.patches;
    for (std::size_t f = 0; f < mesh_.faceCount(); ++f)
    {
      EditFace& face = mesh_.rawFace(static_cast<std::uint32_t>(f));
      face.original = face.above == None ? face.area : Vector{};
    }
    std::vector<float> missing(patches.missing.empty() ? 0 : patches.size());
    for (std::size_t n = 0; n + 1 < patches.boxStart.size() && !missing.empty(); ++n)
    {
      std::fill(missing.begin() + std::ptrdiff_t(patches.boxStart[n]),
        missing.begin() + std::ptrdiff_t(patches.boxStart[n + 1]), patches.missing[n]);
    }
    for (std::uint32_t f = 0; f < mesh_.faceCount() && !missing.empty(); ++f)
    {
      EditFace& face = mesh_.rawFace(f);
      if (face.above == None && face.number < missing.size())
      {
        const double most = MostMissing * mesh_.cell(face.below).edge;
        face.debt = std::clamp(missing[face.number] * mesh_.level(), -most, most) * norm(face.area);
      }
    }
  }

  const MeshParts& parts_;
  EditableWall& result_;
  EditMesh& mesh_;
  Execution& execution_;
  std::vector<CellKey> keys_;
  std::vector<std::uint32_t> ofCell_;       // numbers in the mesh of cells, or None
  std::vector<std::uint32_t> ofHexahedron_; // ... of hexahedra, by box
  std::vector<CellKey> ghosts_;
  std::vector<Listed> faces_;
  std::vector<std::uint32_t> corners_;
  NewVertices vertices_;
  BesideHexahedron beside_;
};

}

Point EditableWall::placeOf(std::uint32_t node) const
{
  Point place = origin;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double levels = mesh.node(node).at[axis] / mesh.level();
    assert(levels == std::floor(levels));
    place[axis] = static_cast<Level>(static_cast<std::int64_t>(levels) + place[axis]);
  }
  return place;
}

EditableWall openWall(const MeshParts& parts, double featureAngle, Execution& execution)
{
  EditableWall result;
  Opening(parts, result, execution).run(featureAngle);
  return result;
}

}
