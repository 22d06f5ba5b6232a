// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/WallOpening.h"

#include "Base/Sorting.h"
#include "Editing/CellClosure.h"
#include "Editing/EditMeasures.h"
#include "Editing/NearWallSelection.h"
#include "Editing/NodeKinds.h"
#include "Editing/OpenedFaces.h"
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

class Opening
{
public:
  Opening(const MeshParts& parts, EditableWall& result, Execution& execution)
    : parts_(parts)
    , result_(result)
    , mesh_(result.mesh.mesh())
    , execution_(execution)
    , keys_(cellsToEdit(parts, execution))
    , numbers_(parts, execution)
  {
  }

  void run(double featureAngle)
  {
    mesh_.sharp = SharpRule(featureAngle, parts_.patches.knowsEdges);
    chooseUnit();
    addCells();
    findMissing();
    faces_ = listOpenedFaces(parts_, keys_, numbers_, execution_);
    addGhosts();
    addNodes();
    addFaces();
    mesh_.connect(execution_);
    hold();
    freeze();
    measure();
    findNodeKinds(
      mesh_, { parts_.nodes.kinds, parts_.patches.knowsEdges }, featureAngle, execution_);
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
    execution_.forEach(faces_.lists.size(), 1, [&](std::size_t i, std::size_t) { visit(i); });
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
    std::vector<double> least(chunks(keys_.size(), ItemsAChunk), HUGE_VAL); // volume
    forEach(keys_.size(), [&](std::uint32_t c) {
      double& ofChunk = least[c / ItemsAChunk];
      ofChunk = std::min(ofChunk, volumeOf(parts_.boxes.box(boxOf(parts_.wall, keys_[c]))));
    });
    mesh_.level = keys_.empty()
      ? 1
      : std::ldexp(1.0, -std::ilogb(std::cbrt(*std::min_element(least.begin(), least.end()))));
    mesh_.low = Vector{};
    mesh_.high = result_.inside(end);
  }

  void addCells()
  {
    mesh_.cells.reserve(withSpare(keys_.size()));
    mesh_.cells.resize(keys_.size());
    forEach(keys_.size(), [&](std::uint32_t c) { setCell(c, keys_[c], CellState::Free); });
    result_.cells = static_cast<std::uint32_t>(keys_.size());
  }

  // With room for what edits make: it takes no memory before.
  static std::size_t withSpare(std::size_t count) { return 2 * count; }

  BoxPlace placeOf(const PackedBox& box) const
  {
    BoxPlace place;
    place.level = *std::max_element(box.level.begin(), box.level.end());
    const FinePoint low = parts_.boxes.fineLow(box);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      place.at[axis] = static_cast<std::uint32_t>(low[axis] >> (DeepestLevel - place.level));
    }
    return place;
  }

  void setCell(std::uint32_t c, CellKey key, CellState state)
  {
    const std::uint32_t box = boxOf(parts_.wall, key);
    const Box at = parts_.boxes.box(box);
    const Vector low = result_.inside(at.low);
    const Vector high = result_.inside(at.high);
    const Vector size = minus(high, low);
    EditCell cell;
    cell.centre = scaled(plus(low, high), 0.5);
    cell.boxVolume = size[0] * size[1] * size[2];
    cell.volume = cell.boxVolume;
    cell.edge = std::cbrt(cell.boxVolume);
    cell.number = key;
    cell.boxIndex = box;
    cell.place = placeOf(at);
    cell.state = state;
    cell.wall = isHexahedron(key) ? NoBoundary : parts_.wall.cells[key].boundary;
    cell.region = isHexahedron(key) ? parts_.boxes.regionOf(box) : parts_.wall.cells[key].region;
    mesh_.cells[c] = cell;
    numbers_[key] = c;
  }

  // Each is all of its box: cells of intersected boxes are no ghosts.
  void addGhosts()
  {
    const std::vector<CellKey> ghosts = takeGhosts(faces_, execution_);
    mesh_.cells.resize(keys_.size() + ghosts.size());
    forEach(ghosts.size(),
      [&](std::uint32_t i) { setCell(result_.cells + i, ghosts[i], CellState::Ghost); });
  }

  // --- nodes

  // In the order of their places; corners then have their numbers. No two share a place, except vertices that several
  // lists have.
  void addNodes()
  {
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
    mesh_.nodes.reserve(withSpare(count));
    mesh_.nodes.resize(count);
    nodeOf_.resize(parts_.nodes.at.size() + faces_.vertices.size());
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
    result_.onVertices = concatenated(onVertices);
    result_.nodes = static_cast<std::uint32_t>(count);
  }

  void setNode(const PointSortKey& place, std::vector<VertexNode>& onVertices)
  {
    const std::size_t known = parts_.nodes.at.size();
    const std::uint32_t from = place.number();
    const std::uint32_t n = nodeOf_[from];
    EditNode node;
    node.at = result_.inside(place.point());
    node.referencePosition = node.at;
    node.number = from < known ? from : std::uint32_t(None);
    mesh_.nodes[n] = node;
    if (from >= known)
    {
      onVertices.push_back(faces_.vertices[from - known]);
      onVertices.back().node = n;
    }
  }

  // Of all nodes that are used.
  RawVector<PointSortKey> findPlaces()
  {
    const std::size_t known = parts_.nodes.at.size();
    std::vector<std::atomic<std::uint8_t>> used(known);
    forEachList([&](std::size_t i) {
      for (const std::uint32_t node : faces_.lists[i].corners)
      {
        node < known ? used[node].store(1, std::memory_order_relaxed) : void();
      }
    });
    std::vector<std::size_t> start(chunks(known, ItemsAChunk) + 1);
    const auto isUsed = [&](std::size_t n) { return used[n].load(std::memory_order_relaxed) != 0; };
    forEach(known, [&](std::uint32_t n) { start[n / ItemsAChunk] += isUsed(n) ? 1 : 0; });
    const std::size_t count = scan(start);
    RawVector<PointSortKey> places(count + faces_.vertices.size());
    forEach(known, [&](std::uint32_t n) {
      if (isUsed(n))
      {
        places[start[n / ItemsAChunk]++] = { parts_.nodes.at[n], n };
      }
    });
    forEach(faces_.vertices.size(), [&](std::uint32_t v) {
      const auto& planes = parts_.boxes.planes;
      const VertexNode& vertex = faces_.vertices[v];
      places[count + v] = { { planes[0][vertex.i], planes[1][vertex.j], planes[2][vertex.k] },
        static_cast<std::uint32_t>(known + v) };
    });
    return places;
  }

  // --- faces of the mesh

  // Of patches, and of the faces that those between regions became (Interfaces.h), in the order of their numbers.
  void findMissing()
  {
    const Patches& patches = parts_.patches;
    const WallFaces& faces = parts_.wall.faces;
    missing_.resize(patches.missing.empty() ? 0 : faces.size());
    forEach(missing_.empty() ? 0 : patches.boxStart.size() - 1, [&](std::uint32_t n) {
      std::fill(missing_.begin() + std::ptrdiff_t(patches.boxStart[n]),
        missing_.begin() + std::ptrdiff_t(patches.boxStart[n + 1]), patches.missing[n]);
    });
    std::size_t next = faces.firstInterface();
    for (std::size_t p = 0; !missing_.empty() && p < faces.firstOfSides(); ++p)
    {
      if (patches.walls.isInterface(faces.boundary[p]))
      {
        missing_[next++] = missing_[p];
      }
    }
  }

  void addFaces()
  {
    std::vector<std::size_t> first; // of faces, by lists; and of corners
    std::vector<std::size_t> firstCorner;
    for (const OpenedFaceList& list : faces_.lists)
    {
      first.push_back(list.faces.size());
      firstCorner.push_back(list.corners.size());
    }
    const std::size_t count = scan(first);
    const std::size_t corners = scan(firstCorner);
    mesh_.faces.reserve(withSpare(count));
    mesh_.faces.resize(count);
    mesh_.arenas[0].reserve(2 * corners + 2 * count); // also for the lists of nodes and cells
    mesh_.arenas[0].resize(corners);
    forEachList([&](std::size_t i) {
      OpenedFaceList& list = faces_.lists[i];
      sortFaces(list, nodeOf_);
      std::size_t f = first[i];
      std::size_t corner = firstCorner[i];
      for (const OpenedFace& face : list.faces)
      {
        setFace(f++, face, list, corner);
        corner += face.end - face.begin;
      }
      list = OpenedFaceList();
    });
  }

  void setFace(
    std::size_t f, const OpenedFace& listed, const OpenedFaceList& list, std::size_t first)
  {
    const std::uint32_t* const corners = list.corners.data() + listed.begin;
    const std::size_t size = listed.end - listed.begin;
    EditFace face;
    face.below = numbers_[listed.below];
    face.above = listed.above == None ? None : numbers_[listed.above];
    face.wall =
      face.above == None && listed.wall == NoBoundary ? wallAtEnd(corners, size) : listed.wall;
    face.corners = listAt(first, size, 0);
    face.volumeDeficit = listed.number < missing_.size() ? missing_[listed.number] : 0; // for now
    std::copy_n(corners, size, mesh_.arenas[0].begin() + std::ptrdiff_t(first));
    mesh_.faces[f] = face;
  }

  // NoBoundary: it is not at an end of the grid.
  std::int32_t wallAtEnd(const std::uint32_t* corners, std::size_t size) const
  {
    for (std::size_t side = 0; side < 6; ++side)
    {
      const std::size_t axis = side / 2;
      const double at = (side % 2 == 1 ? mesh_.high : mesh_.low)[axis];
      if (std::all_of(corners, corners + size,
            [&](std::uint32_t n) { return mesh_.nodes[n].at[axis] == at; }))
      {
        return wallOfEnd(side);
      }
    }
    return NoBoundary;
  }

  // --- what may change

  void hold()
  {
    forEach(mesh_.nodes.size(), [&](std::uint32_t n) {
      EditNode& node = mesh_.nodes[n];
      for (const std::uint32_t f : result_.mesh.facesAround(n))
      {
        const EditFace& face = mesh_.faces[f];
        node.constrainedAxes |= heldBy(face);
        node.atWall = node.atWall || face.wall != NoBoundary;
      }
    });
  }

  // Nodes at an end of the grid may slide in it; where nothing is known of a wall, they stay.
  std::uint8_t heldBy(const EditFace& face) const
  {
    if (result_.mesh.isGhost(face.below))
    {
      return AllAxes;
    }
    if (face.above != None)
    {
      return result_.mesh.isGhost(face.above) ? AllAxes : std::uint8_t(0);
    }
    return isWallOfEnd(face.wall) ? static_cast<std::uint8_t>(1 << (face.wall - FirstOfEnds) / 2)
      : face.wall == NoBoundary   ? AllAxes
                                  : std::uint8_t(0);
  }

  void freeze()
  {
    forEach(keys_.size(), [&](std::uint32_t c) {
      if (!isHexahedron(keys_[c]) && touchesItself(result_.mesh, c))
      {
        mesh_.cells[c].state = CellState::Frozen;
        mesh_.cells[c].touches = true;
      }
    });
  }

  // --- measures

  void measure()
  {
    noteEulerDefects(mesh_, execution_);
    measureAll(mesh_, execution_);
    const Patches& patches = parts_.patches;
    forEach(mesh_.faces.size(), [&](std::uint32_t f) {
      EditFace& face = mesh_.faces[f];
      face.original = isSurface(face) ? face.area : Vector{};
      if (face.volumeDeficit != 0)
      {
        const EditCell& below = mesh_.cells[face.below];
        const double most = MostMissing * below.edge;
        const bool isBehind = face.above == None || below.region == patches.walls.behind(face.wall);
        face.volumeDeficit = std::clamp(face.volumeDeficit * mesh_.level, -most, most) *
          norm(face.area) * (isBehind ? 1 : -1);
      }
    });
  }

  const MeshParts& parts_;
  EditableWall& result_;
  EditMesh& mesh_;
  Execution& execution_;
  std::vector<CellKey> keys_;
  OpenedCells numbers_;
  OpenedFaces faces_;               // vertices are numbered behind Nodes
  RawVector<std::uint32_t> nodeOf_; // in the mesh, of both
  std::vector<float> missing_;      // of faces in WallFaces: what patches lack, in levels
};

// Of each wall's index, whether it has layers on any side.
std::vector<std::uint8_t> findLayered(const WallLayerSpec& layers, const MeshParts& parts)
{
  const std::vector<std::int32_t>& of = parts.wall.faces.boundary;
  const std::int32_t count = of.empty() ? 0 : *std::max_element(of.begin(), of.end()) + 1;
  std::vector<std::uint8_t> layered(static_cast<std::size_t>(count));
  for (std::int32_t wall = 0; wall < count; ++wall)
  {
    layered[static_cast<std::size_t>(wall)] =
      hasLayersOn(layers, parts.patches.walls, wall) ? 1 : 0;
  }
  return layered;
}

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

EditableWall openWall(const MeshParts& parts, const OpeningSpec& spec, Execution& execution)
{
  EditableWall result;
  if (spec.layers)
  {
    result.mesh.mesh().layered = findLayered(*spec.layers, parts);
  }
  Opening(parts, result, execution).run(spec.featureAngle);
  return result;
}

}
