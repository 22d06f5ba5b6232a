// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/WallClosing.h"

#include "Base/Sorting.h"
#include "Polyhedra/CellGeometry.h"

#include <algorithm>
#include <tuple>

namespace cartesian
{

namespace
{

constexpr std::size_t ItemsAChunk = 1024;

// A polyhedron. Among the cells of a box: as they were cut, then those made by edits.
struct Polyhedron
{
  std::uint32_t box;
  std::uint32_t cell; // or None: removed before any edit
  std::uint64_t order;

  bool operator<(const Polyhedron& other) const
  {
    return std::tie(box, order) < std::tie(other.box, other.order);
  }
};

class Closing
{
public:
  Closing(const EditableWall& edited, const Boxes& boxes, const Walls& walls, Sides& sides,
    Nodes& nodes, WallMesh& wall, Execution& execution)
    : edited_(edited)
    , mesh_(edited.mesh)
    , boxes_(boxes)
    , walls_(walls)
    , sides_(sides)
    , nodes_(nodes)
    , wall_(wall)
    , execution_(execution)
  {
  }

  void run()
  {
    findCells();
    promote();
    writeCells();
    findFaces();
    writeNodes();
    wall_.faces.start.assign(1, 0);
    writeFaces(false);
    wall_.faces.firstShaped = static_cast<std::uint32_t>(wall_.faces.size());
    writeFaces(true);
    writeUses();
  }

private:
  // In the wall mesh.
  struct Numbers
  {
    RawVector<CellKey> cells; // None: gone
    RawVector<std::uint32_t> faces;
    RawVector<std::uint32_t> nodes; // in Nodes
  };

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

  // Where each chunk's part begins, if sizeOf(i) is the size of an item's; and the end.
  template <class Size>
  std::vector<std::size_t> startOfChunks(std::size_t count, Size&& sizeOf)
  {
    std::vector<std::size_t> start(chunks(count, ItemsAChunk) + 1);
    forEach(count, [&](std::uint32_t i) { start[i / ItemsAChunk] += sizeOf(i); });
    scan(start);
    return start;
  }

  // --- cells

  // Hexahedra that edits left as they were stay so; all else are polyhedra.
  void findCells()
  {
    const std::size_t count = mesh_.cellCount();
    numbers_.cells.resize(count);
    std::vector<std::vector<Polyhedron>> polyhedra(chunks(count, ItemsAChunk));
    std::vector<std::vector<std::uint32_t>> promoted(polyhedra.size());
    forEach(count, [&](std::uint32_t c) {
      const EditCell& cell = mesh_.cell(c);
      const bool wasHexahedron = isHexahedron(cell.number);
      numbers_.cells[c] = None;
      if (wasHexahedron && (mesh_.isGhost(c) || isWholeBox(c)))
      {
        numbers_.cells[c] = cell.number;
        return;
      }
      if (wasHexahedron)
      {
        promoted[c / ItemsAChunk].push_back(boxOfHexahedron(cell.number));
      }
      if (!cell.gone)
      {
        const bool isMade = cell.number == None;
        polyhedra[c / ItemsAChunk].push_back(
          { cell.boxIndex, c, isMade ? std::uint64_t(EndOfKeys) + c : cell.number });
      }
    });
    promoted_ = concatenated(promoted);
    polyhedra_ = concatenated(polyhedra);
    for (std::uint32_t c = 0; c < wall_.size(); ++c)
    {
      if (wall_.cells[c].removed)
      {
        polyhedra_.push_back({ wall_.cells[c].box, None, c });
      }
    }
    sortAll(promoted_, execution_);
    sortAll(polyhedra_, execution_);
  }

  // Not if it only is as it was again: what it became part of may have other cells in its box.
  bool isWholeBox(std::uint32_t c) const
  {
    const Box box = boxes_.box(mesh_.cell(c).boxIndex);
    const auto isCorner = [&](std::uint32_t n) {
      const Point place = edited_.placeOf(n);
      bool is = true;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        is = is && (place[axis] == box.low[axis] || place[axis] == box.high[axis]);
      }
      return is;
    };
    const Items faces = mesh_.facesOf(c);
    return !mesh_.cell(c).gone && faces.size() == 6 &&
      std::all_of(faces.begin(), faces.end(), [&](std::uint32_t f) {
        const Items corners = mesh_.cornersOf(f);
        return !mesh_.face(f).shaped && corners.size() == 4 &&
          std::all_of(corners.begin(), corners.end(), isCorner);
      });
  }

  // Lists changed hexahedra among the polyhedral boxes.
  void promote()
  {
    const std::vector<std::uint32_t> polyhedral = std::move(sides_.polyhedral);
    const std::vector<std::uint32_t> patchBox = std::move(sides_.patchBox);
    const std::vector<std::uint8_t> flawed = std::move(wall_.flawed);
    const std::size_t count = polyhedral.size() + promoted_.size();
    sides_.polyhedral.resize(count);
    sides_.patchBox.assign(count, None);
    wall_.flawed.assign(count, 0);
    const auto lowerIn = [](const std::vector<std::uint32_t>& boxes, std::uint32_t box) {
      return static_cast<std::size_t>(
        std::lower_bound(boxes.begin(), boxes.end(), box) - boxes.begin());
    };
    const auto put = [&](std::size_t at, std::uint32_t box) {
      sides_.ordinal[box] = static_cast<std::uint32_t>(at);
      sides_.polyhedral[at] = box;
    };
    forEach(polyhedral.size(), [&](std::uint32_t n) {
      const std::size_t at = n + lowerIn(promoted_, polyhedral[n]);
      put(at, polyhedral[n]);
      sides_.patchBox[at] = patchBox[n];
      wall_.flawed[at] = flawed[n];
    });
    forEach(promoted_.size(),
      [&](std::uint32_t i) { put(i + lowerIn(polyhedral, promoted_[i]), promoted_[i]); });
  }

  void writeCells()
  {
    const std::vector<Cell> old = std::move(wall_.cells);
    const std::size_t count = polyhedra_.size();
    const auto sizeOf = [&](std::uint32_t i) {
      const std::uint32_t c = polyhedra_[i].cell;
      return c == None ? std::size_t(0) : mesh_.facesOf(c).size();
    };
    std::vector<std::size_t> firstUse = startOfChunks(count, sizeOf);
    wall_.cells.assign(count + 1, Cell{});
    wall_.cells[count].firstUse = firstUse.back();
    forEach(count, [&](std::uint32_t i) {
      const auto& [box, c, order] = polyhedra_[i];
      const bool isAsCut = order < old.size() && (c == None || mesh_.isGhost(c));
      Cell& cell = wall_.cells[i];
      cell = isAsCut ? old[order] : cellOf(c);
      cell.firstUse = firstUse[i / ItemsAChunk];
      firstUse[i / ItemsAChunk] += sizeOf(i);
      c == None ? void() : void(numbers_.cells[c] = i);
    });
    wall_.boxStart.resize(sides_.polyhedral.size() + 1);
    forEach(wall_.boxStart.size(), [&](std::uint32_t n) {
      const auto first = n == sides_.polyhedral.size()
        ? polyhedra_.end()
        : std::lower_bound(
            polyhedra_.begin(), polyhedra_.end(), Polyhedron{ sides_.polyhedral[n], 0, 0 });
      wall_.boxStart[n] = static_cast<std::size_t>(first - polyhedra_.begin());
    });
  }

  Cell cellOf(std::uint32_t c) const
  {
    const EditCell& edited = mesh_.cell(c);
    Cell cell{};
    cell.box = edited.boxIndex;
    cell.boundary = edited.wall;
    cell.region = edited.region;
    cell.volumeFraction = shareOf(c);
    return cell;
  }

  // Of its box's volume: as its faces' triangles enclose it, unlike EditCell's, which is a solver's.
  double shareOf(std::uint32_t c) const
  {
    const Box box = boxes_.box(mesh_.cell(c).boxIndex);
    const Vector low = edited_.inside(box.low);
    const Vector size = minus(edited_.inside(box.high), low);
    double volume = 0;
    for (const std::uint32_t f : mesh_.facesOf(c))
    {
      const Cone cone = measureCone(
        mesh_.face(f).corners.size, [&](std::size_t i) { return minus(mesh_.corner(f, i), low); });
      volume += mesh_.face(f).below == c ? cone.volume : -cone.volume;
    }
    return volume / (size[0] * size[1] * size[2]);
  }

  // --- nodes and faces

  bool isPolyhedron(std::uint32_t c) const
  {
    return c != None && numbers_.cells[c] < FirstHexahedron;
  }

  // Those of polyhedra; of hexahedra, those without a cell beyond, but a box.
  void findFaces()
  {
    isWritten_.resize(mesh_.faceCount());
    forEach(isWritten_.size(), [&](std::uint32_t f) {
      const EditFace& face = mesh_.face(f);
      isWritten_[f] = !face.gone &&
        (isPolyhedron(face.below) || isPolyhedron(face.above) ||
          (face.above == None && hasBoxBeyond(f)));
    });
  }

  // Of a hexahedron: hexahedra keep their nodes, so which side a face lies on is known by its place.
  bool hasBoxBeyond(std::uint32_t f) const
  {
    const std::uint32_t b = mesh_.cell(mesh_.face(f).below).boxIndex;
    const Box box = boxes_.box(b);
    const Items corners = mesh_.cornersOf(f);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (const bool upper : { false, true })
      {
        const Level level = upper ? box.high[axis] : box.low[axis];
        if (std::all_of(corners.begin(), corners.end(),
              [&](std::uint32_t n) { return edited_.placeOf(n)[axis] == level; }))
        {
          return facing(boxes_, boxes_.packed[b], static_cast<int>(axis), upper)[0] != None;
        }
      }
    }
    return false;
  }

  bool isUsed(std::uint32_t n) const
  {
    const Items faces = mesh_.facesAround(n);
    return !mesh_.node(n).gone &&
      std::any_of(faces.begin(), faces.end(), [&](std::uint32_t f) { return isWritten_[f] != 0; });
  }

  void writeNodes()
  {
    const std::size_t count = mesh_.nodeCount();
    const auto isNew = [&](std::uint32_t n) { return mesh_.node(n).number == None && isUsed(n); };
    std::vector<std::size_t> next =
      startOfChunks(count, [&](std::uint32_t n) { return isNew(n) ? 1 : 0; });
    const auto first = static_cast<std::uint32_t>(nodes_.at.size());
    nodes_.at.resize(first + next.back());
    numbers_.nodes.resize(count);
    std::vector<std::vector<std::uint32_t>> made(next.size());
    forEach(count, [&](std::uint32_t n) {
      std::uint32_t& number = numbers_.nodes[n];
      number = mesh_.node(n).number;
      if (isNew(n))
      {
        number = first + static_cast<std::uint32_t>(next[n / ItemsAChunk]++);
        if (n >= edited_.nodes)
        {
          made[n / ItemsAChunk].push_back(number);
        }
      }
      if (number != None && !mesh_.node(n).gone)
      {
        nodes_.at[number] = edited_.placeOf(n);
      }
    });
    listNodes(concatenated(made));
  }

  // `made`: at no vertex of the global mesh.
  void listNodes(const std::vector<std::uint32_t>& made)
  {
    for (VertexNode vertex : edited_.onVertices)
    {
      if (numbers_.nodes[vertex.node] != None)
      {
        vertex.node = numbers_.nodes[vertex.node];
        nodes_.moreVertices.push_back(vertex);
      }
    }
    sortAll(nodes_.moreVertices, execution_);
    nodes_.ofCuts.insert(nodes_.ofCuts.end(), made.begin(), made.end());
    std::sort(nodes_.ofCuts.begin(), nodes_.ofCuts.end(),
      [&](std::uint32_t a, std::uint32_t b) { return nodes_.at[a] < nodes_.at[b]; });
  }

  // Those that edits have changed, or the others.
  void writeFaces(bool shaped)
  {
    WallFaces& faces = wall_.faces;
    const std::size_t count = mesh_.faceCount();
    const auto isOne = [&](std::uint32_t f) {
      return isWritten_[f] != 0 && mesh_.face(f).shaped == shaped;
    };
    std::vector<std::size_t> next =
      startOfChunks(count, [&](std::uint32_t f) { return isOne(f) ? 1 : 0; });
    std::vector<std::size_t> nextCorner = startOfChunks(
      count, [&](std::uint32_t f) { return isOne(f) ? mesh_.face(f).corners.size : 0; });
    const std::size_t first = faces.size();
    const std::size_t firstCorner = faces.corners.size();
    faces.start.resize(first + next.back() + 1);
    faces.cells.resize(first + next.back());
    faces.boundary.resize(first + next.back());
    faces.corners.resize(firstCorner + nextCorner.back());
    numbers_.faces.resize(count);
    forEach(count, [&](std::uint32_t f) {
      if (isOne(f))
      {
        const std::size_t number = first + next[f / ItemsAChunk]++;
        std::size_t& corner = nextCorner[f / ItemsAChunk];
        numbers_.faces[f] = static_cast<std::uint32_t>(number);
        writeFace(f, number, firstCorner + corner);
        corner += mesh_.face(f).corners.size;
      }
    });
  }

  void writeFace(std::uint32_t f, std::size_t number, std::size_t firstCorner)
  {
    WallFaces& faces = wall_.faces;
    const EditFace& face = mesh_.face(f);
    const auto keyOf = [&](std::uint32_t c) { return c == None ? None : numbers_.cells[c]; };
    const auto begin = faces.corners.begin() + std::ptrdiff_t(firstCorner);
    auto end = begin;
    for (const std::uint32_t n : mesh_.cornersOf(f))
    {
      *end++ = numbers_.nodes[n];
    }
    faces.start[number + 1] = static_cast<std::uint32_t>(firstCorner + face.corners.size);
    faces.cells[number] = { keyOf(face.below), keyOf(face.above) };
    faces.boundary[number] = boundaryOf(face);
    if (looksBack(face))
    {
      std::reverse(begin, end);
      std::swap(faces.cells[number][0], faces.cells[number][1]);
    }
  }

  // A wall between two regions has that in front below it: in WallFaces it will be that behind.
  bool looksBack(const EditFace& face) const
  {
    return face.above != None && face.wall >= 0 &&
      mesh_.cell(face.below).region != walls_.behind(face.wall);
  }

  // What lies at an end of the grid is known by its place (Boundary.h).
  std::int32_t boundaryOf(const EditFace& face) const
  {
    const bool isInside =
      face.above != None && mesh_.cell(face.above).region == mesh_.cell(face.below).region;
    return isInside || isWallOfEnd(face.wall) ? NoBoundary : face.wall;
  }

  void writeUses()
  {
    wall_.uses.resize(wall_.cells.back().firstUse);
    forEach(polyhedra_.size(), [&](std::uint32_t i) {
      std::size_t next = wall_.cells[i].firstUse;
      const std::uint32_t c = polyhedra_[i].cell;
      for (const std::uint32_t f : c == None ? Items{ nullptr, nullptr } : mesh_.facesOf(c))
      {
        const bool isAbove = mesh_.face(f).above == c;
        wall_.uses[next++] = { numbers_.faces[f], isAbove != looksBack(mesh_.face(f)) };
      }
    });
  }

  const EditableWall& edited_;
  const MeshView& mesh_;
  const Boxes& boxes_;
  const Walls& walls_;
  Sides& sides_;
  Nodes& nodes_;
  WallMesh& wall_;
  Execution& execution_;
  std::vector<Polyhedron> polyhedra_;   // in order
  std::vector<std::uint32_t> promoted_; // boxes of hexahedra that changed, in order
  std::vector<std::uint8_t> isWritten_; // faces
  Numbers numbers_;
};

}

void closeWall(const EditableWall& edited, const Boxes& boxes, const Walls& walls, Sides& sides,
  Nodes& nodes, WallMesh& wall, Execution& execution)
{
  Closing(edited, boxes, walls, sides, nodes, wall, execution).run();
}

}
