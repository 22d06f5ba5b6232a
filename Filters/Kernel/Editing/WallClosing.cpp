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

// A cell that changed. Among the cells of a box: as they were, then those made by edits.
struct Written
{
  std::uint32_t box;
  std::uint32_t cell;
  std::uint64_t order;

  bool operator<(const Written& other) const
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
    findMoved();
    findChanged();
    const RawVector<std::uint32_t> before = promote();
    writeNodes();
    writeFaces();
    writeCells(before);
    findCellsOfFaces();
    listSidesOfHexahedra();
  }

private:
  // Of what was opened, and what edits made.
  struct Changes
  {
    std::vector<std::uint8_t> moved;     // nodes
    std::vector<std::uint8_t> rewritten; // cells of the wall mesh that changed or went
    std::vector<std::uint8_t> isWritten; // cells that changed
    std::vector<Written> written;        // these, in order
    std::vector<std::uint32_t> promoted; // boxes of hexahedra that changed, in order
  };

  // Of the nodes and faces of cells that changed, in Nodes and WallFaces.
  struct NewNumbers
  {
    RawVector<std::uint32_t> nodes;
    RawVector<std::uint32_t> faces; // those of no such cell have any
    std::uint32_t firstMade = 0;    // of faces
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

  // Where each chunk's part begins, if visit(i) is the size of an item's; and the end.
  template <class Size>
  std::vector<std::size_t> startOfChunks(std::size_t count, Size&& sizeOf)
  {
    std::vector<std::size_t> start(chunks(count, ItemsAChunk) + 1);
    forEach(count, [&](std::uint32_t i) { start[i / ItemsAChunk] += sizeOf(i); });
    scan(start);
    return start;
  }

  // --- what changed

  void findMoved()
  {
    changes_.moved.assign(mesh_.nodeCount(), 0);
    forEach(edited_.opened.nodes, [&](std::uint32_t n) {
      const std::uint32_t number = mesh_.node(n).number;
      changes_.moved[n] =
        !mesh_.node(n).gone && number != None && !areSame(edited_.placeOf(n), nodes_.at[number]);
    });
    const auto& onVertices = edited_.opened.onVertices;
    forEach(onVertices.size(), [&](std::uint32_t i) {
      const auto& planes = boxes_.planes;
      const VertexNode& vertex = onVertices[i];
      const Point before{ planes[0][vertex.i], planes[1][vertex.j], planes[2][vertex.k] };
      changes_.moved[vertex.node] =
        !mesh_.node(vertex.node).gone && !areSame(edited_.placeOf(vertex.node), before);
    });
  }

  bool hasCornersAsOpened(std::uint32_t f) const
  {
    const auto& start = edited_.opened.start;
    const Items corners = mesh_.cornersOf(f);
    const auto before = edited_.opened.corners.begin();
    return std::equal(corners.begin(), corners.end(), before + std::ptrdiff_t(start[f]),
      before + std::ptrdiff_t(start[f + 1]));
  }

  // It has the corners that it had, and is a wall, or between two cells, as it was.
  bool isAsOpened(std::uint32_t f) const
  {
    const AsOpened& opened = edited_.opened;
    return f < opened.cellsOf.size() && (opened.cellsOf[f][1] == None) == mesh_.isWall(f) &&
      hasCornersAsOpened(f);
  }

  void findChanged()
  {
    changes_.rewritten.assign(wall_.size(), 0);
    changes_.isWritten.assign(mesh_.cellCount(), 0);
    const std::size_t count = chunks(mesh_.cellCount(), ItemsAChunk);
    std::vector<std::vector<Written>> written(count);
    std::vector<std::vector<std::uint32_t>> promoted(count);
    forEach(mesh_.cellCount(), [&](std::uint32_t c) {
      const EditCell& cell = mesh_.cell(c);
      const bool isNew = !wasOpened(c);
      if (mesh_.isGhost(c) || (!isNew && !hasChanged(c)))
      {
        return;
      }
      if (!cell.gone)
      {
        changes_.isWritten[c] = 1;
        written[c / ItemsAChunk].push_back({ cell.boxIndex, c, orderOf(c) });
      }
      if (!isNew && isHexahedron(cell.number))
      {
        promoted[c / ItemsAChunk].push_back(boxOfHexahedron(cell.number));
      }
      else if (!isNew)
      {
        changes_.rewritten[cell.number] = 1;
      }
    });
    changes_.written = concatenated(written);
    changes_.promoted = concatenated(promoted);
    sortAll(changes_.written, execution_);
    sortAll(changes_.promoted, execution_);
  }

  bool wasOpened(std::uint32_t c) const { return c < edited_.opened.cells; }

  bool hasChanged(std::uint32_t c) const
  {
    const Items faces = mesh_.facesOf(c);
    return mesh_.cell(c).gone || faces.size() != edited_.opened.facesOf[c] ||
      std::any_of(faces.begin(), faces.end(), [&](std::uint32_t f) {
        const Items corners = mesh_.cornersOf(f);
        return !isAsOpened(f) ||
          (edited_.opened.cellsOf[f][0] != c && edited_.opened.cellsOf[f][1] != c) ||
          std::any_of(corners.begin(), corners.end(),
            [&](std::uint32_t n) { return changes_.moved[n] != 0; });
      });
  }

  std::uint64_t orderOf(std::uint32_t c) const
  {
    return wasOpened(c) ? mesh_.cell(c).number : std::uint64_t(EndOfKeys) + c;
  }

  // --- nodes and faces

  bool isWrittenFace(std::uint32_t f) const
  {
    const EditFace& face = mesh_.face(f);
    return !face.gone &&
      (changes_.isWritten[face.below] != 0 ||
        (face.above != None && changes_.isWritten[face.above] != 0));
  }

  bool isWrittenNode(std::uint32_t n) const
  {
    const Items faces = mesh_.facesAround(n);
    return !mesh_.node(n).gone &&
      std::any_of(faces.begin(), faces.end(), [&](std::uint32_t f) { return isWrittenFace(f); });
  }

  void writeNodes()
  {
    const std::size_t count = mesh_.nodeCount();
    const auto isNew = [&](std::uint32_t n) {
      return mesh_.node(n).number == None && isWrittenNode(n);
    };
    std::vector<std::size_t> next =
      startOfChunks(count, [&](std::uint32_t n) { return isNew(n) ? 1 : 0; });
    const auto first = static_cast<std::uint32_t>(nodes_.at.size());
    nodes_.at.resize(first + next.back());
    numbers_.nodes.resize(count);
    std::vector<std::vector<std::uint32_t>> made(next.size());
    forEach(count, [&](std::uint32_t n) {
      std::uint32_t& number = numbers_.nodes[n];
      number = mesh_.node(n).number;
      if (number != None && changes_.moved[n])
      {
        nodes_.at[number] = edited_.placeOf(n);
      }
      else if (isNew(n))
      {
        number = first + static_cast<std::uint32_t>(next[n / ItemsAChunk]++);
        nodes_.at[number] = edited_.placeOf(n);
        if (n >= edited_.opened.nodes)
        {
          made[n / ItemsAChunk].push_back(number);
        }
      }
    });
    listNodes(concatenated(made));
  }

  // `made`: at no vertex of the global mesh.
  void listNodes(const std::vector<std::uint32_t>& made)
  {
    for (VertexNode vertex : edited_.opened.onVertices)
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

  bool keepsNumber(std::uint32_t f) const { return mesh_.face(f).number != None && isAsOpened(f); }

  void writeFaces()
  {
    WallFaces& faces = wall_.faces;
    const std::size_t count = mesh_.faceCount();
    const auto isMade = [&](std::uint32_t f) { return isWrittenFace(f) && !keepsNumber(f); };
    std::vector<std::size_t> next =
      startOfChunks(count, [&](std::uint32_t f) { return isMade(f) ? 1 : 0; });
    std::vector<std::size_t> nextCorner = startOfChunks(
      count, [&](std::uint32_t f) { return isMade(f) ? mesh_.face(f).corners.size : 0; });
    const std::size_t first = faces.size();
    const std::size_t firstCorner = faces.corners.size();
    numbers_.firstMade = static_cast<std::uint32_t>(first);
    faces.start.resize(first + next.back() + 1);
    faces.cells.resize(first + next.back());
    faces.boundary.resize(first + next.back());
    faces.corners.resize(firstCorner + nextCorner.back());
    numbers_.faces.resize(count);
    forEach(count, [&](std::uint32_t f) {
      const EditFace& face = mesh_.face(f);
      numbers_.faces[f] = face.number;
      if (isMade(f))
      {
        const std::size_t made = first + next[f / ItemsAChunk]++;
        std::size_t& corner = nextCorner[f / ItemsAChunk];
        const std::size_t begin = firstCorner + corner;
        for (const std::uint32_t n : mesh_.cornersOf(f))
        {
          faces.corners[firstCorner + corner++] = numbers_.nodes[n];
        }
        numbers_.faces[f] = static_cast<std::uint32_t>(made);
        faces.start[made + 1] = static_cast<std::uint32_t>(firstCorner + corner);
        faces.cells[made] = { keyBeyond(face.below), keyBeyond(face.above) };
        if (looksBack(face))
        {
          std::reverse(faces.corners.begin() + std::ptrdiff_t(begin),
            faces.corners.begin() + std::ptrdiff_t(firstCorner + corner));
          std::swap(faces.cells[made][0], faces.cells[made][1]);
        }
        faces.boundary[made] = boundaryOf(face);
      }
    });
  }

  // A wall between two regions has that in front below it: in WallFaces it will be that behind.
  bool looksBack(const EditFace& face) const
  {
    return face.above != None && face.wall >= 0 &&
      mesh_.cell(face.below).region != walls_.behind(face.wall);
  }

  // Of a hexahedron that stays one, or None.
  CellKey keyBeyond(std::uint32_t c) const
  {
    const CellKey key =
      c == None || (!wasOpened(c) && !mesh_.isGhost(c)) ? CellKey(None) : mesh_.cell(c).number;
    return isStillHexahedron(key) ? key : CellKey(None);
  }

  // What lies at an end of the grid is known by its place (Boundary.h).
  std::int32_t boundaryOf(const EditFace& face) const
  {
    const bool isInside = face.above != None && !mesh_.isGhost(face.above) &&
      mesh_.cell(face.above).region == mesh_.cell(face.below).region;
    return isInside || isWallOfEnd(face.wall) ? NoBoundary : face.wall;
  }

  // --- cells

  // Lists changed hexahedra among the polyhedral boxes; returns which of the old list each is, or None.
  RawVector<std::uint32_t> promote()
  {
    const std::vector<std::uint32_t> polyhedral = std::move(sides_.polyhedral);
    const std::vector<std::uint32_t> patchBox = std::move(sides_.patchBox);
    const std::vector<std::size_t> ownStart = std::move(sides_.ownStart);
    const std::vector<std::size_t> boxStart = std::move(sides_.boxStart);
    const std::size_t count = polyhedral.size() + changes_.promoted.size();
    RawVector<std::uint32_t> before(count);
    sides_.polyhedral.resize(count);
    sides_.patchBox.resize(count);
    sides_.ownStart.resize(count + 1, ownStart.back());
    sides_.boxStart.resize(count + 1, boxStart.back());
    const auto put = [&](std::size_t at, std::uint32_t box, std::uint32_t old, std::size_t n) {
      sides_.ordinal[box] = static_cast<std::uint32_t>(at);
      before[at] = old;
      sides_.polyhedral[at] = box;
      sides_.patchBox[at] = old == None ? None : patchBox[old];
      sides_.ownStart[at] = ownStart[n];
      sides_.boxStart[at] = boxStart[n];
    };
    forEach(polyhedral.size(), [&](std::uint32_t n) {
      put(n + lowerIn(changes_.promoted, polyhedral[n]), polyhedral[n], n, n);
    });
    forEach(changes_.promoted.size(), [&](std::uint32_t i) {
      const std::size_t n = lowerIn(polyhedral, changes_.promoted[i]);
      put(i + n, changes_.promoted[i], None, n);
    });
    return before;
  }

  // How many are lower.
  static std::size_t lowerIn(const std::vector<std::uint32_t>& boxes, std::uint32_t box)
  {
    return static_cast<std::size_t>(
      std::lower_bound(boxes.begin(), boxes.end(), box) - boxes.begin());
  }

  // `before`: as promote() returns it.
  void writeCells(const RawVector<std::uint32_t>& before)
  {
    const WallMesh old = takeCells();
    const std::size_t count = before.size();
    wall_.boxStart.resize(count + 1);
    wall_.flawed.resize(count);
    std::vector<std::size_t> firstUse(chunks(count, ItemsAChunk) + 1);
    std::vector<std::size_t> firstCell(firstUse.size());
    forEach(count, [&](std::uint32_t n) {
      const std::size_t chunk = n / ItemsAChunk;
      forEachCellIn(n, before[n], old, [&](std::size_t size, std::uint32_t, std::uint32_t) {
        ++firstCell[chunk];
        firstUse[chunk] += size;
      });
    });
    const std::size_t cells = scan(firstCell);
    const std::size_t uses = scan(firstUse);
    wall_.cells.resize(cells + 1);
    wall_.uses.resize(uses);
    forEach(count, [&](std::uint32_t n) {
      const std::size_t chunk = n / ItemsAChunk;
      wall_.boxStart[n] = firstCell[chunk];
      wall_.flawed[n] = before[n] == None ? std::uint8_t(0) : old.flawed[before[n]];
      forEachCellIn(n, before[n], old, [&](std::size_t size, std::uint32_t was, std::uint32_t c) {
        Cell& cell = wall_.cells[firstCell[chunk]++];
        cell = c == None ? old.cells[was] : cellOf(c);
        cell.firstUse = firstUse[chunk];
        writeUses(old, was, c, cell.firstUse);
        firstUse[chunk] += size;
      });
    });
    wall_.boxStart[count] = cells;
    wall_.cells[cells] = Cell{};
    wall_.cells[cells].firstUse = uses;
  }

  // Calls visit(number of faces, number in the old mesh or None, number in this one or None) for the cells of a box, in
  // order. `m`: its number among the old polyhedral ones, or None.
  template <class Visitor>
  void forEachCellIn(std::uint32_t n, std::uint32_t m, const WallMesh& old, Visitor&& visit) const
  {
    const std::uint32_t box = sides_.polyhedral[n];
    auto next =
      std::lower_bound(changes_.written.begin(), changes_.written.end(), Written{ box, 0, 0 });
    const auto visitUpTo = [&](std::uint64_t order) {
      for (; next != changes_.written.end() && next->box == box && next->order <= order; ++next)
      {
        visit(mesh_.facesOf(next->cell).size(), None, next->cell);
      }
    };
    const std::size_t end = m == None ? 0 : old.boxStart[m + 1];
    for (std::size_t c = m == None ? 0 : old.boxStart[m]; c < end; ++c)
    {
      visitUpTo(c);
      if (!changes_.rewritten[c])
      {
        visit(
          old.cells[c + 1].firstUse - old.cells[c].firstUse, static_cast<std::uint32_t>(c), None);
      }
    }
    visitUpTo(~std::uint64_t(0));
  }

  // All but the faces.
  WallMesh takeCells()
  {
    WallMesh old;
    old.cells.swap(wall_.cells);
    old.uses.swap(wall_.uses);
    old.boxStart.swap(wall_.boxStart);
    old.flawed.swap(wall_.flawed);
    return old;
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

  // Of a cell as it was, or of one that changed.
  void writeUses(const WallMesh& old, std::uint32_t was, std::uint32_t c, std::size_t first)
  {
    if (c == None)
    {
      old.forEachUse(was, [&](const FaceUse& use) { wall_.uses[first++] = use; });
      return;
    }
    for (const std::uint32_t f : mesh_.facesOf(c))
    {
      const bool isAbove = mesh_.face(f).above == c;
      const bool isMade = numbers_.faces[f] >= numbers_.firstMade;
      const bool isTurned = isMade ? looksBack(mesh_.face(f)) : edited_.opened.turned[f] != 0;
      wall_.uses[first++] = { numbers_.faces[f], isAbove != isTurned };
    }
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
      Vector area{};
      const Vector mean = forEachStarTriangle(
        mesh_.face(f).corners.size, [&](std::size_t i) { return mesh_.corner(f, i); },
        [&](const Vector&, const Vector&, const Vector& part) { area = plus(area, part); });
      volume += dot(minus(mean, low), area) * (mesh_.face(f).below == c ? 1 : -1) / 3;
    }
    return volume / (size[0] * size[1] * size[2]);
  }

  // --- what lies on both sides of faces

  bool isStillHexahedron(CellKey key) const
  {
    return isHexahedron(key) && sides_.polyhedralOrdinal(boxOfHexahedron(key)) == None;
  }

  void findCellsOfFaces()
  {
    WallFaces& faces = wall_.faces;
    forEach(faces.size(), [&](std::uint32_t f) {
      for (CellKey& key : faces.cells[f])
      {
        key = isStillHexahedron(key) ? key : CellKey(None);
      }
    });
    forEach(wall_.size(), [&](std::uint32_t c) {
      wall_.forEachUse(c, [&](const FaceUse& use) { faces.cells[use.face][use.turned] = c; });
    });
  }

  // Hexahedra have kept their nodes: which side a face lies on is known by its place.
  void listSidesOfHexahedra()
  {
    const WallFaces& faces = wall_.faces;
    const std::size_t count = faces.size() - numbers_.firstMade;
    std::vector<std::vector<HexahedronSide>> ofChunks(chunks(count, ItemsAChunk));
    forEach(count, [&](std::uint32_t i) {
      const std::uint32_t f = numbers_.firstMade + i;
      for (const CellKey key : faces.cells[f])
      {
        if (isHexahedron(key))
        {
          const std::uint32_t box = boxOfHexahedron(key);
          ofChunks[i / ItemsAChunk].push_back({ box, sideOf(box, f), f });
        }
      }
    });
    const std::vector<HexahedronSide> made = concatenated(ofChunks);
    wall_.hexahedronSides.insert(wall_.hexahedronSides.end(), made.begin(), made.end());
    std::sort(wall_.hexahedronSides.begin(), wall_.hexahedronSides.end(),
      [](const HexahedronSide& x, const HexahedronSide& y) {
        return std::make_pair(x.box, x.side) < std::make_pair(y.box, y.side);
      });
  }

  std::uint32_t sideOf(std::uint32_t b, std::uint32_t f) const
  {
    const Box box = boxes_.box(b);
    std::uint32_t side = 0;
    for (; side < 5; ++side)
    {
      const Level level = side % 2 == 1 ? box.high[side / 2] : box.low[side / 2];
      bool all = true;
      wall_.faces.forEachNode(
        { f, false }, [&](std::uint32_t node) { all = all && nodes_.at[node][side / 2] == level; });
      if (all)
      {
        break;
      }
    }
    return side;
  }

  const EditableWall& edited_;
  const MeshView& mesh_;
  const Boxes& boxes_;
  const Walls& walls_;
  Sides& sides_;
  Nodes& nodes_;
  WallMesh& wall_;
  Execution& execution_;
  Changes changes_;
  NewNumbers numbers_;
};

}

void closeWall(const EditableWall& edited, const Boxes& boxes, const Walls& walls, Sides& sides,
  Nodes& nodes, WallMesh& wall, Execution& execution)
{
  Closing(edited, boxes, walls, sides, nodes, wall, execution).run();
}

}
