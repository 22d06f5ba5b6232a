// SPDX-License-Identifier: BSD-3-Clause
#include "Optimisation/WallMesh.h"

#include "Base/EdgeTable.h"
#include "Cells/Interfaces.h"
#include "Faces/UsedVertices.h"
#include "Lattice/PointSortKey.h"

#include <algorithm>
#include <numeric>

namespace cartesian
{

namespace
{

// A cell: its number, or (number of cells) + box for a hexahedron.
using CellKey = std::uint32_t;

// A face of a changing cell before it is known whether its other cell has it already.
struct FaceBetween
{
  CellKey below;
  CellKey above; // or None
  std::int32_t boundary;
};

class WallMeshBuilder
{
public:
  WallMeshBuilder(const WallParts& parts, const Slab& slab)
    : p_(parts)
    , slab_(slab)
    , firstHexahedron_(static_cast<CellKey>(parts.cells.size()))
  {
    mesh_.origin = { 0, 0, p_.boxes.planes[2][slab.layers.begin] };
    const auto& planes = p_.boxes.planes;
    mesh_.ends = { minus(Point{ planes[0].front(), planes[1].front(), planes[2].front() },
                     mesh_.origin),
      minus(Point{ planes[0].back(), planes[1].back(), planes[2].back() }, mesh_.origin) };
  }

  WallMesh run()
  {
    listCells();
    const std::size_t faces = p_.cells.all[end_].firstFace - p_.cells.all[first_].firstFace;
    const std::size_t nodes = mostNodes();
    stateOf_.reset(nodes + 8 * (divided_[1] - divided_[0]));
    findMovable();
    listChanging();
    localOf_.reset(nodes + 8 * hexahedra_.size());
    vertexOf_.reset(8 * hexahedra_.size());
    faceOf_.reset(faces + 6 * hexahedra_.size());
    quadOf_.reset(6 * hexahedra_.size());
    cellOf_.reset(faces + 6 * hexahedra_.size());
    listFaces();
    sortNodes();
    sortFaces();
    listFacesOfCells();
    return std::move(mesh_);
  }

private:
  // In stateOf_:
  static constexpr std::uint32_t Fixed = 0;
  static constexpr std::uint32_t Movable = 1;
  static constexpr std::uint32_t Listed = 2; // movable; the hexahedra around it are known

  // --- cells

  void listCells()
  {
    const auto firstOf = [&](std::uint32_t layer) {
      const auto& boxes = p_.sides.polyhedral;
      const auto at = std::lower_bound(boxes.begin(), boxes.end(), p_.boxes.firstBoxOf(layer));
      return static_cast<CellKey>(p_.cells.boxStart[static_cast<std::size_t>(at - boxes.begin())]);
    };
    first_ = firstOf(slab_.layers.begin);
    end_ = firstOf(slab_.layers.end);
    const auto& divided = p_.sides.divided;
    for (const std::size_t end : { 0, 1 })
    {
      const std::uint32_t box =
        p_.boxes.firstBoxOf(end == 0 ? slab_.moving.begin : slab_.moving.end);
      divided_[end] = static_cast<std::size_t>(
        std::lower_bound(divided.begin(), divided.end(), box) - divided.begin());
    }
  }

  // Each node of a closed cell is at two of its faces or more: at no more than two where it lies within an edge.
  std::size_t mostNodes() const
  {
    std::size_t corners = 0;
    for (CellKey c = first_; c < end_; ++c)
    {
      forEachNodeOfCell(c, [&](std::uint32_t) { ++corners; });
    }
    return corners / 2;
  }

  bool isFree(CellKey c) const
  {
    const Cell& cell = p_.cells.all[c];
    const std::uint32_t layer = p_.boxes.globalOf(p_.boxes.packed[cell.box]).index[2];
    return layer - cell.reach[0] >= slab_.moving.begin && layer + cell.reach[1] < slab_.moving.end;
  }

  template <class Visitor>
  void forEachFace(CellKey c, Visitor&& visit) const
  {
    for (std::size_t f = p_.cells.all[c].firstFace; f < p_.cells.all[c + 1].firstFace; ++f)
    {
      visit(p_.cells.faces[f]);
    }
  }

  template <class Visitor>
  void forEachNodeOf(const FaceOfCell& face, Visitor&& visit) const
  {
    forEachNode(face, p_.patches, p_.inner, p_.cells.shaped, visit);
  }

  // The cell beyond a face, removed or not, or None.
  CellKey beyond(const FaceOfCell& face) const
  {
    if (face.kind() == FaceOfCell::Kind::Patch)
    {
      return None;
    }
    const auto& pair =
      isInner(face) ? p_.cells.ofInnerFace[face.index] : p_.cells.shaped.cells[face.index];
    const CellKey other = pair[face.turned() ? 0 : 1];
    if (isInner(face) && other == None)
    {
      const Side& side = p_.sides.common[p_.sideOf[face.index]];
      return keyOfBox(face.turned() ? side.low : side.high);
    }
    return other == ShapedFaces::SomeHexahedron ? keyOfBox(p_.hexahedronAt[face.index]) : other;
  }

  static bool isInner(const FaceOfCell& face)
  {
    return face.kind() == FaceOfCell::Kind::Inner || face.kind() == FaceOfCell::Kind::TurnedInner;
  }

  bool isRemoved(CellKey key) const { return key < firstHexahedron_ && p_.cells.all[key].removed; }

  // The cell beyond a face, or None.
  CellKey across(const FaceOfCell& face) const
  {
    const CellKey other = beyond(face);
    return isRemoved(other) ? CellKey(None) : other;
  }

  // Of a face that has no cell beyond it, or one of another region.
  std::int32_t boundaryOf(const FaceOfCell& face) const
  {
    if (isInner(face) && p_.inner.isInterface(face.index))
    {
      return p_.inner.wallOf(face.index);
    }
    if (face.kind() == FaceOfCell::Kind::Patch)
    {
      return p_.patches.boundary[face.index];
    }
    if (const CellKey other = beyond(face); isRemoved(other))
    {
      return p_.cells.all[other].boundary;
    }
    return isInner(face) ? NoBoundary : p_.cells.shaped.boundary[face.index];
  }

  // Of a hexahedron; of others None.
  CellKey keyOfBox(std::uint32_t box) const
  {
    return box == None || p_.sides.polyhedralOrdinal(box) != None
      ? CellKey(None)
      : static_cast<CellKey>(firstHexahedron_ + box);
  }

  // --- which nodes may move

  void findMovable()
  {
    for (CellKey c = first_; c < end_; ++c)
    {
      bool wall = false;
      forEachFace(c, [&](const FaceOfCell& face) {
        wall = wall || across(face) == None || isInterface(p_.cells, face);
      });
      if (wall && !p_.cells.all[c].removed && isFree(c))
      {
        forEachNodeOfCell(c, [&](std::uint32_t node) {
          std::uint32_t& state = stateOf_.at(node, node);
          state = state == EdgeTable::Fresh ? (mayEverMove(node) ? Movable : Fixed) : state;
        });
      }
    }
    for (CellKey c = first_; c < end_; ++c)
    {
      if (!p_.cells.all[c].removed && !isFree(c))
      {
        forEachNodeOfCell(c, [&](std::uint32_t node) { stateOf_.at(node, node) = Fixed; });
      }
    }
  }

  template <class Visitor>
  void forEachNodeOfCell(CellKey c, Visitor&& visit) const
  {
    forEachFace(c, [&](const FaceOfCell& face) { forEachNodeOf(face, visit); });
  }

  // Not at the ends of the grid, nor where plain hexahedra that are not free, or know no node, have a corner.
  bool mayEverMove(std::uint32_t node) const
  {
    const Point& at = p_.nodes.at[node];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto& planes = p_.boxes.planes[axis];
      if (at[axis] <= planes.front() || at[axis] >= planes.back())
      {
        return false;
      }
    }
    if (node < p_.nodes.patchPoints)
    {
      return true;
    }
    const std::size_t ofGrid = node - p_.nodes.patchPoints;
    if (ofGrid >= p_.nodes.grid.size())
    {
      return p_.isVertex[ofGrid - p_.nodes.grid.size()] == 0;
    }
    const Level z = p_.nodes.grid[ofGrid][2];
    const auto& planes = p_.boxes.planes[2];
    const bool atEnd = slab_.moving.end == p_.boxes.allLayers().end;
    return (slab_.moving.begin == 0 || z > planes[slab_.moving.begin]) &&
      (atEnd || z < planes[slab_.moving.end]);
  }

  bool isMovable(std::uint32_t node)
  {
    const std::uint32_t state = stateOf_.at(node, node);
    return state == Movable || state == Listed;
  }

  // --- which cells change

  void listChanging()
  {
    std::vector<std::uint32_t> boxes;
    for (CellKey c = first_; c < end_; ++c)
    {
      bool changes = false;
      if (!p_.cells.all[c].removed && isFree(c))
      {
        forEachNodeOfCell(c, [&](std::uint32_t node) { changes = changes || isMovable(node); });
      }
      if (changes)
      {
        changing_.push_back(c);
        forEachNodeOfCell(c, [&](std::uint32_t node) {
          if (std::uint32_t& state = stateOf_.at(node, node); state == Movable)
          {
            state = Listed;
            listUndividedAt(node, boxes);
          }
        });
      }
    }
    for (std::size_t d = divided_[0]; d < divided_[1]; ++d)
    {
      const auto& nodes = p_.nodes.ofDivided[d];
      const std::uint32_t box = p_.sides.divided[d];
      if (p_.sides.polyhedralOrdinal(box) == None &&
        std::any_of(
          nodes.begin(), nodes.end(), [&](std::uint32_t node) { return isMovable(node); }))
      {
        boxes.push_back(box);
      }
    }
    std::sort(boxes.begin(), boxes.end());
    boxes.erase(std::unique(boxes.begin(), boxes.end()), boxes.end());
    hexahedra_ = std::move(boxes);
  }

  // Appends the undivided hexahedra with a corner at a node.
  void listUndividedAt(std::uint32_t node, std::vector<std::uint32_t>& boxes) const
  {
    if (node < p_.nodes.patchPoints)
    {
      return;
    }
    const std::size_t c = node - p_.nodes.patchPoints;
    if (c >= p_.nodes.grid.size())
    {
      return;
    }
    const auto& rows = p_.nodes.rowStart;
    const auto row =
      static_cast<std::size_t>(std::upper_bound(rows.begin(), rows.end(), c) - rows.begin()) - 1;
    const std::size_t rowLength = p_.boxes.planes[1].size();
    const std::size_t j = row % rowLength;
    const std::size_t k = row / rowLength;
    std::uint32_t i = 0;
    if (!UsedVertices::isVertex(p_.boxes.planes, p_.nodes.grid[c], j, k, i))
    {
      return;
    }
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      const std::uint32_t global = p_.boxes.globalAt(std::int64_t(i) - (corner & 1),
        std::int64_t(j) - (corner >> 1 & 1), std::int64_t(k) - (corner >> 2));
      if (global != None && p_.boxes.globals[global].depth == 0 &&
        p_.sides.ordinal[p_.boxes.globals[global].firstBox] == None)
      {
        boxes.push_back(p_.boxes.globals[global].firstBox);
      }
    }
  }

  // --- faces

  void listFaces()
  {
    for (const CellKey c : changing_)
    {
      addCell(c);
    }
    for (const std::uint32_t box : hexahedra_)
    {
      addCell(firstHexahedron_ + box);
    }
    mesh_.changing = mesh_.measures.size();
    for (const CellKey c : changing_)
    {
      forEachFace(c, [&](const FaceOfCell& face) { addFace(c, face); });
    }
    for (const std::uint32_t box : hexahedra_)
    {
      for (unsigned side = 0; side < 6; ++side)
      {
        addSide(box, side);
      }
    }
  }

  std::uint32_t addCell(CellKey key)
  {
    const auto n = static_cast<std::uint32_t>(mesh_.measures.size());
    cellOf_.at(key, key) = n;
    const bool isHexahedron = key >= firstHexahedron_;
    const std::uint32_t box = isHexahedron ? key - firstHexahedron_ : p_.cells.all[key].box;
    const Box whole = p_.boxes.box(box);
    const Vector size = minus(whole.high, whole.low);
    mesh_.cell.push_back(isHexahedron ? std::uint32_t(None) : key);
    mesh_.region.push_back(isHexahedron ? p_.boxes.regionOf(box) : p_.cells.all[key].region);
    mesh_.volumeOfBox.push_back(size[0] * size[1] * size[2]);
    mesh_.measures.push_back(
      { plus(minus(whole.low, mesh_.origin), scaled(size, 0.5)), mesh_.volumeOfBox.back() });
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
    if (key < firstHexahedron_)
    {
      mesh_.measures[added] = measure(key);
    }
    return added;
  }

  CellGeometry measure(CellKey key)
  {
    std::vector<FaceGeometry> faces;
    std::vector<Vector> ring;
    forEachFace(key, [&](const FaceOfCell& face) {
      ring.clear();
      forEachNodeOf(face, [&](std::uint32_t node) { ring.push_back(placeOf(node)); });
      faces.push_back(measureFace(ring.size(), [&](std::size_t i) { return ring[i]; }));
    });
    return measureCell(
      faces.size(), [&](std::size_t i) -> const FaceGeometry& { return faces[i]; });
  }

  Vector placeOf(std::uint32_t node) const { return minus(p_.nodes.at[node], mesh_.origin); }

  // A face of a cell, unless it is there already.
  void addFace(CellKey c, const FaceOfCell& face)
  {
    const bool isPatch = face.kind() == FaceOfCell::Kind::Patch;
    std::uint32_t& known = faceOf_.at(face.index, isPatch ? 0u : isInner(face) ? 1u : 2u);
    if (known != EdgeTable::Fresh)
    {
      return;
    }
    known = static_cast<std::uint32_t>(mesh_.faces());
    forEachNodeOf(
      face, [&](std::uint32_t node) { mesh_.corners.push_back(localOf(node, isMovable(node))); });
    const CellKey other = across(face);
    const bool isWall = other == None || isInterface(p_.cells, face);
    closeFace({ c, other, isWall ? boundaryOf(face) : NoBoundary });
  }

  void closeFace(const FaceBetween& face)
  {
    mesh_.start.push_back(static_cast<std::uint32_t>(mesh_.corners.size()));
    mesh_.cells.push_back({ cellOf(face.below), cellOf(face.above) });
    mesh_.boundary.push_back(face.boundary);
  }

  // The side of a hexahedron: as its polyhedral neighbour has it, or four corners.
  void addSide(std::uint32_t box, unsigned side)
  {
    const bool upper = side % 2 == 1;
    const int axis = static_cast<int>(side / 2);
    const std::uint32_t other = facing(p_.boxes, p_.boxes.packed[box], axis, upper)[0];
    const std::uint32_t n = p_.sides.polyhedralOrdinal(other);
    const CellKey key = firstHexahedron_ + box;
    for (std::size_t i = n == None ? 0 : p_.sides.boxStart[n];
         n != None && i < p_.sides.boxStart[n + 1]; ++i)
    {
      const std::size_t s = p_.sides.ofBox[i].side;
      const Side& shared = p_.sides.common[s];
      if ((upper ? shared.low : shared.high) == box && shared.axis == axis &&
        p_.inner.sideStart[s] < p_.inner.sideStart[s + 1])
      {
        for (std::size_t f = p_.inner.sideStart[s]; f < p_.inner.sideStart[s + 1]; ++f)
        {
          addFace(
            key, FaceOfCell(f, upper ? FaceOfCell::Kind::Inner : FaceOfCell::Kind::TurnedInner));
        }
        return;
      }
    }
    if (const std::uint32_t face = shapedFaceAt(box, side); face != None)
    {
      const bool turned = p_.cells.shaped.cells[face][1] == ShapedFaces::SomeHexahedron;
      addFace(
        key, FaceOfCell(face, turned ? FaceOfCell::Kind::TurnedShaped : FaceOfCell::Kind::Shaped));
      return;
    }
    std::uint32_t& known = quadOf_.at(upper || other == None ? box : other,
      upper || other != None ? static_cast<std::uint32_t>(axis)
                             : 3u + static_cast<std::uint32_t>(axis));
    if (known == EdgeTable::Fresh)
    {
      known = static_cast<std::uint32_t>(mesh_.faces());
      addQuad(box, axis, upper);
      closeFace({ key, keyOfBox(other), NoBoundary });
    }
  }

  // The shaped face on a side of a hexahedron, or None.
  std::uint32_t shapedFaceAt(std::uint32_t box, std::uint32_t side) const
  {
    const auto& given = p_.cells.shaped.ofHexahedra;
    const auto at = std::lower_bound(given.begin(), given.end(), std::make_pair(box, side),
      [](const ShapedFaces::HexahedronSide& x, const std::pair<std::uint32_t, std::uint32_t>& y) {
        return std::make_pair(x.box, x.side) < y;
      });
    return at != given.end() && at->box == box && at->side == side ? at->face : std::uint32_t(None);
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
      mesh_.corners.push_back(localOfCorner(box, corner));
    }
  }

  // --- nodes

  std::uint32_t addNode(const Vector& at, std::uint32_t number, bool movable)
  {
    mesh_.at.push_back(at);
    mesh_.number.push_back(number);
    mesh_.mayMove.push_back(movable ? 1 : 0);
    return static_cast<std::uint32_t>(mesh_.at.size() - 1);
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
    if (const std::uint32_t ordinal = p_.sides.ordinal[box]; ordinal != None)
    {
      return localOf(p_.nodes.ofDivided[ordinal & ~Sides::HexahedronBit][corner], false);
    }
    const auto& low = p_.boxes.globalOf(p_.boxes.packed[box]).index;
    const std::array<std::uint32_t, 3> at{ low[0] + (corner & 1), low[1] + (corner >> 1 & 1),
      low[2] + (corner >> 2) };
    const std::size_t row = at[1] + at[2] * p_.boxes.planes[1].size();
    const Point p = cornerOf(p_.boxes.box(box), corner);
    const auto begin = p_.nodes.grid.begin();
    const auto end = begin + static_cast<std::ptrdiff_t>(p_.nodes.rowStart[row + 1]);
    const auto found =
      std::lower_bound(begin + static_cast<std::ptrdiff_t>(p_.nodes.rowStart[row]), end, p);
    if (found != end && areSame(*found, p))
    {
      return localOf(static_cast<std::uint32_t>(p_.nodes.patchPoints) +
          static_cast<std::uint32_t>(found - begin),
        false);
    }
    std::uint32_t& local = vertexOf_.at(static_cast<std::uint32_t>(row), at[0]);
    if (local == EdgeTable::Fresh)
    {
      local = addNode(minus(p, mesh_.origin), None, false);
    }
    return local;
  }

  // --- order

  void sortNodes()
  {
    const auto count = static_cast<std::uint32_t>(mesh_.at.size());
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return mesh_.at[a] != mesh_.at[b] ? mesh_.at[a] < mesh_.at[b] : a < b;
    });
    std::vector<std::uint32_t> rank(count);
    for (std::uint32_t i = 0; i < count; ++i)
    {
      rank[order[i]] = i;
    }
    for (std::uint32_t& corner : mesh_.corners)
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
    permute(mesh_.at);
    permute(mesh_.number);
    permute(mesh_.mayMove);
  }

  // Each from its lowest corner, and towards the lower of its two neighbours: cells change sides with it, but boundary
  // faces keep theirs.
  void turn(std::size_t f)
  {
    const auto begin = mesh_.corners.begin() + std::ptrdiff_t(mesh_.start[f]);
    const auto end = mesh_.corners.begin() + std::ptrdiff_t(mesh_.start[f + 1]);
    std::rotate(begin, std::min_element(begin, end), end);
    if (mesh_.cells[f][1] != None && *(begin + 1) > *(end - 1))
    {
      std::reverse(begin + 1, end);
      std::swap(mesh_.cells[f][0], mesh_.cells[f][1]);
    }
  }

  void sortFaces()
  {
    const std::size_t count = mesh_.faces();
    std::vector<std::uint32_t> order(count);
    for (std::size_t f = 0; f < count; ++f)
    {
      turn(f);
      order[f] = static_cast<std::uint32_t>(f);
    }
    const auto ring = [&](std::uint32_t f) {
      const std::uint32_t* corners = mesh_.corners.data();
      return std::make_pair(corners + mesh_.start[f], corners + mesh_.start[f + 1]);
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      const auto x = ring(a);
      const auto y = ring(b);
      return std::lexicographical_compare(x.first, x.second, y.first, y.second);
    });
    WallMesh sorted;
    sorted.corners.reserve(mesh_.corners.size());
    for (const std::uint32_t f : order)
    {
      const auto corners = ring(f);
      sorted.corners.insert(sorted.corners.end(), corners.first, corners.second);
      sorted.start.push_back(static_cast<std::uint32_t>(sorted.corners.size()));
      sorted.cells.push_back(mesh_.cells[f]);
      sorted.boundary.push_back(mesh_.boundary[f]);
    }
    mesh_.corners = std::move(sorted.corners);
    mesh_.start = std::move(sorted.start);
    mesh_.cells = std::move(sorted.cells);
    mesh_.boundary = std::move(sorted.boundary);
  }

  void listFacesOfCells()
  {
    mesh_.cellStart.assign(mesh_.changing + 1, 0);
    const auto forEachUse = [&](auto&& visit) {
      for (std::uint32_t f = 0; f < mesh_.faces(); ++f)
      {
        for (const std::uint32_t c : mesh_.cells[f])
        {
          if (c < mesh_.changing)
          {
            visit(c, f);
          }
        }
      }
    };
    forEachUse([&](std::uint32_t c, std::uint32_t) { ++mesh_.cellStart[c]; });
    std::uint32_t sum = 0;
    for (std::uint32_t& count : mesh_.cellStart)
    {
      sum += count;
      count = sum;
    }
    mesh_.cellFaces.resize(sum);
    for (auto f = static_cast<std::uint32_t>(mesh_.faces()); f-- > 0;)
    {
      for (const std::uint32_t c : mesh_.cells[f])
      {
        if (c < mesh_.changing)
        {
          mesh_.cellFaces[--mesh_.cellStart[c]] = f;
        }
      }
    }
  }

  const WallParts& p_;
  const Slab& slab_;
  CellKey firstHexahedron_;
  CellKey first_ = 0; // of polyhedral boxes in the slab's layers
  CellKey end_ = 0;
  std::vector<CellKey> changing_;
  std::vector<std::uint32_t> hexahedra_; // boxes, that change
  std::array<std::size_t, 2> divided_{}; // Sides::divided in the free layers: begin and end
  EdgeTable stateOf_;                    // of nodes
  EdgeTable localOf_;                    // of nodes: their numbers here
  EdgeTable vertexOf_;                   // of other corners of hexahedra
  EdgeTable faceOf_;
  EdgeTable quadOf_;
  EdgeTable cellOf_;
  WallMesh mesh_;
};

}

WallParts::WallParts(const Boxes& b, const Patches& p, const Sides& s, const Nodes& n,
  const InnerFaces& i, const Cells& c, const std::vector<std::uint32_t>& side)
  : boxes(b)
  , patches(p)
  , sides(s)
  , nodes(n)
  , inner(i)
  , cells(c)
  , sideOf(side)
  , hexahedronAt(c.shaped.size(), None)
  , isVertex(n.at.size() - n.patchPoints - n.grid.size())
{
  for (const ShapedFaces::HexahedronSide& of : cells.shaped.ofHexahedra)
  {
    hexahedronAt[of.face] = of.box;
  }
  for (const VertexNode& vertex : nodes.moreVertices)
  {
    isVertex[vertex.node - nodes.patchPoints - nodes.grid.size()] = 1;
  }
}

WallMesh wallMesh(const WallParts& parts, const Slab& slab)
{
  return WallMeshBuilder(parts, slab).run();
}

}
