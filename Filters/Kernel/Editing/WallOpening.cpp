// SPDX-License-Identifier: BSD-3-Clause
#include "Base/EdgeTable.h"
#include "Base/Sorting.h"
#include "Editing/CellClosure.h"
#include "Editing/EditMeasures.h"
#include "Editing/EditableWall.h"
#include "Editing/NodeKinds.h"
#include "Editing/WallRing.h"
#include "Lattice/PointSortKey.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>

namespace cartesian
{

namespace
{

constexpr float MostMissing = 0.1F; // in boxes: what patches may lack that is believed
constexpr std::size_t ItemsAChunk = 1024;
constexpr std::size_t CellsAChunk = 256;

// A face as the cell below has it.
struct Listed
{
  std::size_t begin; // in the list's corners
  std::size_t end;
  std::uint32_t number; // in WallFaces, or None
  CellKey below;
  CellKey above; // or None
  std::int32_t wall;
  bool turned;
};

// The faces of a chunk of cells. Vertices of the global mesh that are not in Nodes are numbered behind those.
struct FaceList
{
  std::vector<Listed> faces;
  std::vector<std::uint32_t> corners;
  std::vector<VertexNode> vertices;
  std::vector<std::uint64_t> ghosts; // box and key of the cells beyond that are not opened
};

// Numbers in the mesh of cells that are opened, or None.
class OpenedCells
{
public:
  OpenedCells(const MeshParts& parts, Execution& execution)
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

  std::uint32_t& operator[](CellKey key)
  {
    return isHexahedron(key) ? ofHexahedron_[boxOfHexahedron(key)] : ofCell_[key];
  }
  std::uint32_t operator[](CellKey key) const
  {
    return isHexahedron(key) ? ofHexahedron_[boxOfHexahedron(key)] : ofCell_[key];
  }

private:
  static constexpr std::size_t NumbersAChunk = 1 << 16;

  RawVector<std::uint32_t> ofCell_;
  RawVector<std::uint32_t> ofHexahedron_; // by box
};

// Lists the faces of some cells.
class FaceLister
{
public:
  FaceLister(const MeshParts& parts, const OpenedCells& numbers, std::size_t cells, FaceList& list)
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

  void close(Listed face)
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
  FaceList& list_;
  EdgeTable known_; // vertices
  BesideHexahedron beside_;
};

class Opening
{
public:
  Opening(const MeshParts& parts, EditableWall& result, Execution& execution)
    : parts_(parts)
    , result_(result)
    , store_(result.mesh.store())
    , execution_(execution)
    , keys_(cellsToEdit(parts, execution))
    , numbers_(parts, execution)
    , lists_(chunks(keys_.size(), CellsAChunk))
  {
  }

  void run(double featureAngle)
  {
    chooseUnit();
    addCells();
    listFaces();
    addGhosts();
    addNodes();
    addFaces();
    store_.connect(execution_);
    result_.mesh.refresh();
    hold();
    freeze();
    measure();
    findNodeKinds(store_, parts_.nodes.kinds, featureAngle, execution_);
  }

private:
  template <class Visitor>
  void forEach(std::size_t count, Visitor&& visit)
  {
    execution_.forEach(count, ItemsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        visit(static_cast<std::uint32_t>(i));
      }
    });
  }

  template <class Visitor>
  void forEachList(Visitor&& visit)
  {
    execution_.forEach(lists_.size(), 1, [&](std::size_t i, std::size_t) { visit(i); });
  }

  // --- cells

  // The smallest box has an edge of 1 to 2 units. The first planes are an origin for all parts of a mesh.
  void chooseUnit()
  {
    Point end;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      result_.origin[axis] = parts_.boxes.planes[axis].front();
      end[axis] = parts_.boxes.planes[axis].back();
    }
    std::vector<double> least(lists_.size(), HUGE_VAL); // volume
    forEachList([&](std::size_t i) {
      const std::size_t last = std::min((i + 1) * CellsAChunk, keys_.size());
      for (std::size_t k = i * CellsAChunk; k < last; ++k)
      {
        const Box box = parts_.boxes.box(boxOf(parts_.wall, keys_[k]));
        const Vector size = minus(box.high, box.low);
        least[i] = std::min(least[i], size[0] * size[1] * size[2]);
      }
    });
    store_.level = keys_.empty()
      ? 1
      : std::ldexp(1.0, -std::ilogb(std::cbrt(*std::min_element(least.begin(), least.end()))));
    store_.low = Vector{};
    store_.high = result_.inside(end);
  }

  void addCells()
  {
    store_.cells.reserve(withSpare(keys_.size()));
    store_.cells.resize(keys_.size());
    forEach(keys_.size(), [&](std::uint32_t c) { setCell(c, keys_[c], CellState::Free); });
    result_.opened.cells = static_cast<std::uint32_t>(keys_.size());
  }

  // With room for what edits make: it takes no memory before.
  static std::size_t withSpare(std::size_t count) { return 2 * count; }

  void setCell(std::uint32_t c, CellKey key, CellState state)
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
    store_.cells[c] = cell;
    numbers_[key] = c;
  }

  // --- faces

  void listFaces()
  {
    forEachList([&](std::size_t i) {
      const std::size_t begin = i * CellsAChunk;
      const std::size_t end = std::min(begin + CellsAChunk, keys_.size());
      FaceLister lister(parts_, numbers_, end - begin, lists_[i]);
      for (std::size_t k = begin; k < end; ++k)
      {
        lister.add(keys_[k]);
      }
    });
  }

  // Each is all of its box: cells of intersected boxes are no ghosts.
  void addGhosts()
  {
    std::vector<std::uint64_t> ghosts;
    for (FaceList& list : lists_)
    {
      ghosts.insert(ghosts.end(), list.ghosts.begin(), list.ghosts.end());
      std::vector<std::uint64_t>().swap(list.ghosts);
    }
    sortAll(ghosts, execution_);
    ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
    store_.cells.resize(keys_.size() + ghosts.size());
    forEach(ghosts.size(), [&](std::uint32_t i) {
      setCell(result_.opened.cells + i, static_cast<CellKey>(ghosts[i]), CellState::Ghost);
    });
  }

  // --- nodes

  // In the order of their places; corners then have their numbers. No two share a place, except vertices that several
  // lists have.
  void addNodes()
  {
    numberVertices();
    RawVector<PointSortKey> places = findPlaces();
    sortAll(places, execution_);
    const auto isFirst = [&](std::size_t i) { return i == 0 || !places[i].isAt(places[i - 1]); };
    std::vector<std::size_t> start(chunks(places.size(), ItemsAChunk) + 1);
    execution_.forEach(places.size(), ItemsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        start[begin / ItemsAChunk] += isFirst(i) ? 1 : 0;
      }
    });
    const std::size_t count = scan(start);
    store_.nodes.reserve(withSpare(count));
    store_.nodes.resize(count);
    nodeOf_.resize(parts_.nodes.at.size() + vertices_.size());
    std::vector<std::vector<VertexNode>> onVertices(start.size());
    execution_.forEach(places.size(), ItemsAChunk, [&](std::size_t begin, std::size_t end) {
      std::size_t next = start[begin / ItemsAChunk];
      for (std::size_t i = begin; i < end; ++i)
      {
        next += isFirst(i) ? 1 : 0;
        nodeOf_[places[i].number()] = static_cast<std::uint32_t>(next - 1);
        if (isFirst(i))
        {
          setNode(places[i], onVertices[begin / ItemsAChunk]);
        }
      }
    });
    result_.opened.onVertices = concatenated(onVertices);
    result_.opened.nodes = static_cast<std::uint32_t>(count);
  }

  void setNode(const PointSortKey& place, std::vector<VertexNode>& onVertices)
  {
    const std::size_t known = parts_.nodes.at.size();
    const std::uint32_t from = place.number();
    const std::uint32_t n = nodeOf_[from];
    EditNode node;
    node.at = result_.inside(place.point());
    node.home = node.at;
    node.number = from < known ? from : std::uint32_t(None);
    store_.nodes[n] = node;
    if (from >= known)
    {
      onVertices.push_back(vertices_[from - known]);
      onVertices.back().node = n;
    }
  }

  // Gathers those of all lists.
  void numberVertices()
  {
    std::vector<std::uint32_t> first(lists_.size());
    for (std::size_t i = 0; i < lists_.size(); ++i)
    {
      first[i] = static_cast<std::uint32_t>(vertices_.size());
      vertices_.insert(vertices_.end(), lists_[i].vertices.begin(), lists_[i].vertices.end());
    }
    const std::size_t known = parts_.nodes.at.size();
    forEachList([&](std::size_t i) {
      for (std::uint32_t& node : lists_[i].corners)
      {
        node += node >= known ? first[i] : 0;
      }
    });
  }

  // Of all nodes that are used.
  RawVector<PointSortKey> findPlaces()
  {
    const std::size_t known = parts_.nodes.at.size();
    std::vector<std::atomic<std::uint8_t>> used(known);
    forEachList([&](std::size_t i) {
      for (const std::uint32_t node : lists_[i].corners)
      {
        node < known ? used[node].store(1, std::memory_order_relaxed) : void();
      }
    });
    std::vector<std::size_t> start(chunks(known, ItemsAChunk) + 1);
    const auto isUsed = [&](std::size_t n) { return used[n].load(std::memory_order_relaxed) != 0; };
    forEach(known, [&](std::uint32_t n) { start[n / ItemsAChunk] += isUsed(n) ? 1 : 0; });
    const std::size_t count = scan(start);
    RawVector<PointSortKey> places(count + vertices_.size());
    forEach(known, [&](std::uint32_t n) {
      if (isUsed(n))
      {
        places[start[n / ItemsAChunk]++] = { parts_.nodes.at[n], n };
      }
    });
    forEach(vertices_.size(), [&](std::uint32_t v) {
      const auto& planes = parts_.boxes.planes;
      const VertexNode& vertex = vertices_[v];
      places[count + v] = { { planes[0][vertex.i], planes[1][vertex.j], planes[2][vertex.k] },
        static_cast<std::uint32_t>(known + v) };
    });
    return places;
  }

  // --- faces of the mesh

  void addFaces()
  {
    std::vector<std::size_t> first; // of faces, by lists; and of corners
    std::vector<std::size_t> firstCorner;
    for (const FaceList& list : lists_)
    {
      first.push_back(list.faces.size());
      firstCorner.push_back(list.corners.size());
    }
    const std::size_t count = scan(first);
    const std::size_t corners = scan(firstCorner);
    store_.faces.reserve(withSpare(count));
    store_.faces.resize(count);
    store_.arenas[0].reserve(2 * corners + 2 * count); // also for the lists of nodes and cells
    store_.arenas[0].resize(corners);
    AsOpened& opened = result_.opened;
    opened.start.resize(count + 1);
    opened.start[0] = 0;
    opened.cellsOf.resize(count);
    opened.turned.resize(count);
    forEachList([&](std::size_t i) {
      FaceList& list = lists_[i];
      sortFaces(list);
      std::size_t f = first[i];
      std::size_t corner = firstCorner[i];
      for (const Listed& face : list.faces)
      {
        setFace(f++, face, list, corner);
        corner += face.end - face.begin;
      }
      list = FaceList();
    });
    opened.corners = store_.arenas[0];
  }

  // By their cells, then by their corners, the first of which is the lowest.
  void sortFaces(FaceList& list) const
  {
    for (std::uint32_t& corner : list.corners)
    {
      corner = nodeOf_[corner];
    }
    const auto corner = [&](std::size_t i) { return list.corners.begin() + std::ptrdiff_t(i); };
    for (const Listed& face : list.faces)
    {
      std::rotate(corner(face.begin), std::min_element(corner(face.begin), corner(face.end)),
        corner(face.end));
    }
    for (auto begin = list.faces.begin(); begin != list.faces.end();)
    {
      const auto end = std::find_if(
        begin, list.faces.end(), [&](const Listed& face) { return face.below != begin->below; });
      std::sort(begin, end, [&](const Listed& x, const Listed& y) {
        return std::lexicographical_compare(
          corner(x.begin), corner(x.end), corner(y.begin), corner(y.end));
      });
      begin = end;
    }
  }

  void setFace(std::size_t f, const Listed& listed, const FaceList& list, std::size_t first)
  {
    const std::uint32_t* const corners = list.corners.data() + listed.begin;
    const std::size_t size = listed.end - listed.begin;
    EditFace face;
    face.below = numbers_[listed.below];
    face.above = listed.above == None ? None : numbers_[listed.above];
    face.number = listed.number;
    face.wall =
      face.above == None && listed.wall == NoBoundary ? wallAtEnd(corners, size) : listed.wall;
    face.corners = listAt(first, size, 0);
    std::copy_n(corners, size, store_.arenas[0].begin() + std::ptrdiff_t(first));
    store_.faces[f] = face;
    result_.opened.start[f + 1] = static_cast<std::uint32_t>(first + size);
    result_.opened.cellsOf[f] = { face.below, face.above };
    result_.opened.turned[f] = listed.turned ? 1 : 0;
  }

  // NoBoundary: it is not at an end of the grid.
  std::int32_t wallAtEnd(const std::uint32_t* corners, std::size_t size) const
  {
    for (std::size_t side = 0; side < 6; ++side)
    {
      const std::size_t axis = side / 2;
      const double at = (side % 2 == 1 ? store_.high : store_.low)[axis];
      if (std::all_of(corners, corners + size,
            [&](std::uint32_t n) { return store_.nodes[n].at[axis] == at; }))
      {
        return wallOfEnd(side);
      }
    }
    return NoBoundary;
  }

  // --- what may change

  void hold()
  {
    result_.opened.facesOf.resize(result_.opened.cells);
    forEach(result_.opened.cells,
      [&](std::uint32_t c) { result_.opened.facesOf[c] = store_.cells[c].faces.size; });
    forEach(store_.nodes.size(), [&](std::uint32_t n) {
      EditNode& node = store_.nodes[n];
      for (const std::uint32_t f : result_.mesh.facesAround(n))
      {
        const EditFace& face = store_.faces[f];
        node.held |= heldBy(face);
        node.atWall = node.atWall || face.wall != NoBoundary;
      }
    });
  }

  // Nodes at an end of the grid may slide in it; where nothing is known of a wall, they stay.
  std::uint8_t heldBy(const EditFace& face) const
  {
    if (face.above != None)
    {
      return result_.mesh.isGhost(face.above) ? HeldFast : std::uint8_t(0);
    }
    const int side = NoBoundary - 1 - face.wall;
    return isWallOfEnd(face.wall) ? static_cast<std::uint8_t>(1 << side / 2)
      : face.wall == NoBoundary   ? HeldFast
                                  : std::uint8_t(0);
  }

  // Cells that touch themselves along an edge, where the surface does, stay as they are.
  void freeze()
  {
    execution_.forEach(keys_.size(), ItemsAChunk, [&](std::size_t begin, std::size_t end) {
      EdgeTable edges; // of a cell, counter-clockwise
      for (auto c = static_cast<std::uint32_t>(begin); c < end; ++c)
      {
        if (!isHexahedron(keys_[c]) && touchesItself(c, edges))
        {
          store_.cells[c].state = CellState::Frozen;
        }
      }
    });
  }

  bool touchesItself(std::uint32_t c, EdgeTable& edges) const
  {
    const EditMesh& mesh = result_.mesh;
    std::size_t count = 0;
    for (const std::uint32_t f : mesh.facesOf(c))
    {
      count += mesh.cornersOf(f).size();
    }
    edges.reset(count);
    bool does = false;
    for (const std::uint32_t f : mesh.facesOf(c))
    {
      const Items corners = mesh.cornersOf(f);
      const bool turned = mesh.face(f).above == c;
      std::uint32_t from = corners[corners.size() - 1];
      for (const std::uint32_t to : corners)
      {
        std::uint32_t& known = turned ? edges.at(to, from) : edges.at(from, to);
        does = does || known != EdgeTable::Fresh;
        known = 0;
        from = to;
      }
    }
    return does;
  }

  // --- measures

  void measure()
  {
    noteMisses(store_, execution_);
    measureAll(store_, execution_);
    const Patches& patches = parts_.patches;
    std::vector<float> missing(patches.missing.empty() ? 0 : patches.size());
    forEach(missing.empty() ? 0 : patches.boxStart.size() - 1, [&](std::uint32_t n) {
      std::fill(missing.begin() + std::ptrdiff_t(patches.boxStart[n]),
        missing.begin() + std::ptrdiff_t(patches.boxStart[n + 1]), patches.missing[n]);
    });
    forEach(store_.faces.size(), [&](std::uint32_t f) {
      EditFace& face = store_.faces[f];
      face.original = face.above == None ? face.area : Vector{};
      if (face.above == None && face.number < missing.size())
      {
        const double most = MostMissing * store_.cells[face.below].edge;
        face.debt = std::clamp(missing[face.number] * store_.level, -most, most) * norm(face.area);
      }
    });
  }

  const MeshParts& parts_;
  EditableWall& result_;
  EditStore& store_;
  Execution& execution_;
  std::vector<CellKey> keys_;
  OpenedCells numbers_;
  std::vector<FaceList> lists_;
  std::vector<VertexNode> vertices_; // numbered behind Nodes
  RawVector<std::uint32_t> nodeOf_;  // in the mesh, of those
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
