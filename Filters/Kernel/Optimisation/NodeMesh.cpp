// SPDX-License-Identifier: BSD-3-Clause
#include "Optimisation/NodeMesh.h"

#include "Base/EdgeTable.h"
#include "Optimisation/MovingCells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace cartesian
{

namespace
{

// A face of a changing cell before it is known whether its other cell has it already.
struct FaceBetween
{
  CellKey below;
  CellKey above; // or None
  std::int32_t boundary;
};

class NodeMeshBuilder
{
public:
  NodeMeshBuilder(const Boxes& boxes, const Sides& sides, const Nodes& nodes, const WallMesh& wall,
    const Slab& slab)
    : boxes_(boxes)
    , sides_(sides)
    , nodes_(nodes)
    , wall_(wall)
    , moving_(boxes, sides, nodes, wall, slab)
  {
    const auto& planes = boxes.planes;
    mesh_.origin = { 0, 0, planes[2][slab.layers.begin] };
    mesh_.ends = { minus(Point{ planes[0].front(), planes[1].front(), planes[2].front() },
                     mesh_.origin),
      minus(Point{ planes[0].back(), planes[1].back(), planes[2].back() }, mesh_.origin) };
    const std::size_t hexahedra = moving_.hexahedra().size();
    localOf_.reset(moving_.mostNodes() + 8 * hexahedra);
    vertexOf_.reset(8 * hexahedra);
    faceOf_.reset(moving_.mostFaces() + 6 * hexahedra);
    quadOf_.reset(6 * hexahedra);
    cellOf_.reset(moving_.mostFaces() + 6 * hexahedra);
  }

  NodeMesh run()
  {
    listFaces();
    return std::move(mesh_);
  }

private:
  void listFaces()
  {
    for (const CellKey c : moving_.cells())
    {
      addCell(c);
    }
    for (const std::uint32_t box : moving_.hexahedra())
    {
      addCell(keyOfHexahedron(box));
    }
    mesh_.cells.changing = mesh_.cells.measures.size();
    for (const CellKey c : moving_.cells())
    {
      wall_.forEachUse(c, [&](const FaceUse& use) { addFace(c, use); });
    }
    for (const std::uint32_t box : moving_.hexahedra())
    {
      for (unsigned side = 0; side < 6; ++side)
      {
        addSide(box, side);
      }
    }
  }

  std::uint32_t addCell(CellKey key)
  {
    const auto n = static_cast<std::uint32_t>(mesh_.cells.measures.size());
    cellOf_.at(key, key) = n;
    const bool hexahedron = isHexahedron(key);
    const std::uint32_t box = hexahedron ? boxOfHexahedron(key) : wall_.cells[key].box;
    const Box whole = boxes_.box(box);
    const Vector size = minus(whole.high, whole.low);
    mesh_.cells.number.push_back(hexahedron ? std::uint32_t(None) : key);
    mesh_.cells.box.push_back(hexahedron ? box : std::uint32_t(None));
    mesh_.cells.region.push_back(hexahedron ? boxes_.regionOf(box) : wall_.cells[key].region);
    mesh_.cells.volumeOfBox.push_back(size[0] * size[1] * size[2]);
    mesh_.cells.measures.push_back(
      { plus(minus(whole.low, mesh_.origin), scaled(size, 0.5)), mesh_.cells.volumeOfBox.back() });
    return n;
  }

  // A neighbour that does not change is measured once.
  std::uint32_t cellOf(CellKey key)
  {
    if (key == None)
    {
      return None;
    }
    const std::uint32_t known = cellOf_.at(key, key);
    if (known != EdgeTable::Fresh)
    {
      return known;
    }
    const std::uint32_t added = addCell(key);
    if (!isHexahedron(key))
    {
      mesh_.cells.measures[added] = measure(key);
    }
    return added;
  }

  CellGeometry measure(CellKey key)
  {
    std::vector<FaceGeometry> faces;
    std::vector<Vector> ring;
    wall_.forEachUse(key, [&](const FaceUse& use) {
      ring.clear();
      wall_.faces.forEachNode(use, [&](std::uint32_t node) { ring.push_back(placeOf(node)); });
      faces.push_back(measureFace(ring.size(), [&](std::size_t i) { return ring[i]; }));
    });
    return measureCell(
      faces.size(), [&](std::size_t i) -> const FaceGeometry& { return faces[i]; });
  }

  Vector placeOf(std::uint32_t node) const { return minus(nodes_.at[node], mesh_.origin); }

  // The cell beyond a face, or None.
  CellKey across(const FaceUse& use) const
  {
    const CellKey other = wall_.faces.beyond(use);
    return wall_.isRemoved(other) ? CellKey(None) : other;
  }

  // Of a face that has no cell beyond it, or one of another region.
  std::int32_t boundaryOf(const FaceUse& use) const
  {
    const CellKey other = wall_.faces.beyond(use);
    return wall_.isRemoved(other) && wall_.faces.originOf(use.face) != FaceOrigin::Interface
      ? wall_.cells[other].boundary
      : wall_.faces.boundary[use.face];
  }

  // A face of a cell, unless it is there already.
  void addFace(CellKey c, const FaceUse& use)
  {
    std::uint32_t& known = faceOf_.at(use.face, use.face);
    if (known != EdgeTable::Fresh)
    {
      return;
    }
    known = static_cast<std::uint32_t>(mesh_.faces.size());
    wall_.faces.forEachNode(use, [&](std::uint32_t node) {
      mesh_.faces.corners.push_back(localOf(node, moving_.isMovable(node)));
    });
    const CellKey other = across(use);
    const bool isWall = other == None || wall_.isInterface(use.face);
    closeFace({ c, other, isWall ? boundaryOf(use) : NoBoundary }, use.face);
    mesh_.faces.isTurned.back() = use.turned;
  }

  void closeFace(const FaceBetween& face, std::uint32_t number)
  {
    mesh_.faces.close({ cellOf(face.below), cellOf(face.above) }, face.boundary, number);
  }

  // The side of a hexahedron: as its polyhedral neighbour has it, or four corners.
  void addSide(std::uint32_t box, unsigned side)
  {
    const CellKey key = keyOfHexahedron(box);
    lookBeside(boxes_, sides_, wall_, box, side, beside_);
    for (const FaceUse& use : beside_.faces)
    {
      addFace(key, use);
    }
    if (!beside_.faces.empty())
    {
      return;
    }
    const bool upper = side % 2 == 1;
    const int axis = static_cast<int>(side / 2);
    const std::uint32_t other = beside_.box;
    std::uint32_t& known = quadOf_.at(upper || other == None ? box : other,
      upper || other != None ? static_cast<std::uint32_t>(axis)
                             : 3u + static_cast<std::uint32_t>(axis));
    if (known == EdgeTable::Fresh)
    {
      const bool isBetween = other != None && !beside_.isPolyhedral;
      known = static_cast<std::uint32_t>(mesh_.faces.size());
      addQuad(box, axis, upper);
      closeFace({ key, isBetween ? keyOfHexahedron(other) : CellKey(None), NoBoundary }, None);
    }
  }

  void addQuad(std::uint32_t box, int axis, bool upper)
  {
    std::array<unsigned, 4> ring = sideCorners(axis, upper ? 1 : 0);
    if (!upper)
    {
      std::reverse(ring.begin(), ring.end());
    }
    for (const unsigned corner : ring)
    {
      mesh_.faces.corners.push_back(localOfCorner(box, corner));
    }
  }

  // --- nodes

  std::uint32_t addNode(const Vector& at, std::uint32_t number, bool movable)
  {
    mesh_.nodes.at.push_back(at);
    mesh_.nodes.number.push_back(number);
    mesh_.nodes.mayMove.push_back(movable ? 1 : 0);
    return static_cast<std::uint32_t>(mesh_.nodes.at.size() - 1);
  }

  std::uint32_t localOf(std::uint32_t node, bool movable)
  {
    std::uint32_t& local = localOf_.at(node, node);
    if (local == EdgeTable::Fresh)
    {
      local = addNode(placeOf(node), node, movable);
    }
    return local;
  }

  // Those that may move are here already, as nodes of a wall cell.
  std::uint32_t localOfCorner(std::uint32_t box, unsigned corner)
  {
    if (const std::uint32_t node = nodeOfCorner(boxes_, sides_, nodes_, box, corner); node != None)
    {
      return localOf(node, false);
    }
    const VertexNode at = vertexAt(boxes_, box, corner);
    const auto row = static_cast<std::uint32_t>(at.j + at.k * boxes_.planes[1].size());
    std::uint32_t& local = vertexOf_.at(row, at.i);
    if (local == EdgeTable::Fresh)
    {
      local = addNode(minus(cornerOf(boxes_.box(box), corner), mesh_.origin), None, false);
    }
    return local;
  }

  const Boxes& boxes_;
  const Sides& sides_;
  const Nodes& nodes_;
  const WallMesh& wall_;
  MovingCells moving_;
  EdgeTable localOf_;  // of nodes: their numbers here
  EdgeTable vertexOf_; // of other corners of hexahedra
  EdgeTable faceOf_;
  EdgeTable quadOf_;
  EdgeTable cellOf_;
  BesideHexahedron beside_;
  NodeMesh mesh_;
};

// --- order

void sortNodes(NodeMesh& mesh)
{
  const auto count = static_cast<std::uint32_t>(mesh.nodes.at.size());
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return mesh.nodes.at[a] != mesh.nodes.at[b] ? mesh.nodes.at[a] < mesh.nodes.at[b] : a < b;
  });
  std::vector<std::uint32_t> rank(count);
  for (std::uint32_t i = 0; i < count; ++i)
  {
    rank[order[i]] = i;
  }
  for (std::uint32_t& corner : mesh.faces.corners)
  {
    corner = rank[corner];
  }
  const auto permute = [&](auto& values) {
    auto old = values;
    for (std::uint32_t i = 0; i < count; ++i)
    {
      values[i] = old[order[i]];
    }
  };
  permute(mesh.nodes.at);
  permute(mesh.nodes.number);
  permute(mesh.nodes.mayMove);
}

// Each from its lowest corner, and towards the lower of its two neighbours: cells change sides with it, but boundary
// faces keep theirs.
void turn(NodeMesh& mesh, std::size_t f)
{
  const auto begin = mesh.faces.corners.begin() + std::ptrdiff_t(mesh.faces.start[f]);
  const auto end = mesh.faces.corners.begin() + std::ptrdiff_t(mesh.faces.stop[f]);
  std::rotate(begin, std::min_element(begin, end), end);
  if (mesh.faces.cells[f][1] != None && *(begin + 1) > *(end - 1))
  {
    std::reverse(begin + 1, end);
    std::swap(mesh.faces.cells[f][0], mesh.faces.cells[f][1]);
    mesh.faces.isTurned[f] ^= 1;
  }
}

void sortFaces(NodeMesh& mesh)
{
  const std::size_t count = mesh.faces.size();
  std::vector<std::uint32_t> order(count);
  for (std::size_t f = 0; f < count; ++f)
  {
    turn(mesh, f);
    order[f] = static_cast<std::uint32_t>(f);
  }
  const auto ring = [&](std::uint32_t f) {
    const std::uint32_t* corners = mesh.faces.corners.data();
    return std::make_pair(corners + mesh.faces.start[f], corners + mesh.faces.stop[f]);
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto x = ring(a);
    const auto y = ring(b);
    return std::lexicographical_compare(x.first, x.second, y.first, y.second);
  });
  NodeMesh::Faces sorted;
  sorted.corners.reserve(mesh.faces.corners.size());
  for (const std::uint32_t f : order)
  {
    const auto corners = ring(f);
    sorted.corners.insert(sorted.corners.end(), corners.first, corners.second);
    sorted.close(mesh.faces.cells[f], mesh.faces.boundary[f], mesh.faces.number[f]);
    sorted.isTurned.back() = mesh.faces.isTurned[f];
  }
  mesh.faces = std::move(sorted);
}

void listFacesOfCells(NodeMesh& mesh)
{
  mesh.cells.firstUse.assign(mesh.cells.changing, 0);
  const auto forEachUse = [&](auto&& visit) {
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
    {
      for (const std::uint32_t c : mesh.faces.cells[f])
      {
        if (c < mesh.cells.changing)
        {
          visit(c, f);
        }
      }
    }
  };
  forEachUse([&](std::uint32_t c, std::uint32_t) { ++mesh.cells.firstUse[c]; });
  std::uint32_t sum = 0;
  for (std::uint32_t& count : mesh.cells.firstUse)
  {
    sum += count;
    count = sum;
  }
  mesh.cells.uses.resize(sum);
  mesh.cells.endUse = mesh.cells.firstUse;
  for (auto f = static_cast<std::uint32_t>(mesh.faces.size()); f-- > 0;)
  {
    for (const std::uint32_t c : mesh.faces.cells[f])
    {
      if (c < mesh.cells.changing)
      {
        mesh.cells.uses[--mesh.cells.firstUse[c]] = f;
      }
    }
  }
}

}

std::vector<double> NodeMesh::edgesAtFaces() const
{
  std::vector<double> ofCells(cells.volumeOfBox.size());
  std::transform(cells.volumeOfBox.begin(), cells.volumeOfBox.end(), ofCells.begin(),
    [](double volume) { return std::cbrt(volume); });
  std::vector<double> edges(faces.size(), std::numeric_limits<double>::infinity());
  for (std::size_t f = 0; f < edges.size(); ++f)
  {
    for (const std::uint32_t c : faces.cells[f])
    {
      edges[f] = c == None ? edges[f] : std::min(edges[f], ofCells[c]);
    }
  }
  return edges;
}

NodeMesh nodeMesh(const Boxes& boxes, const Sides& sides, const Nodes& nodes, const WallMesh& wall,
  const Slab& slab)
{
  NodeMesh mesh = NodeMeshBuilder(boxes, sides, nodes, wall, slab).run();
  sortNodes(mesh);
  sortFaces(mesh);
  listFacesOfCells(mesh);
  return mesh;
}

}
