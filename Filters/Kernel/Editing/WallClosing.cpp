// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/EditableWall.h"
#include "Polyhedra/CellGeometry.h"

#include <algorithm>
#include <tuple>

namespace cartesian
{

namespace
{

constexpr std::size_t CellsAChunk = 1024;

class Closing
{
public:
  Closing(
    const EditableWall& edited, const Boxes& boxes, Sides& sides, Nodes& nodes, WallMesh& wall)
    : edited_(edited)
    , mesh_(edited.mesh)
    , boxes_(boxes)
    , sides_(sides)
    , nodes_(nodes)
    , wall_(wall)
  {
  }

  void run(Execution& execution)
  {
    findMoved();
    findChanged();
    const std::vector<std::uint32_t> before = promote();
    writeNodes();
    writeFaces();
    writeCells(before);
    findCellsOfFaces(execution);
    listSidesOfHexahedra();
  }

private:
  // Of the nodes and faces of cells that changed, in Nodes and WallFaces.
  struct NewNumbers
  {
    std::vector<std::uint32_t> nodes;
    std::vector<std::uint32_t> faces;
    std::uint32_t firstMade = 0; // of faces
  };

  // --- what changed

  void findMoved()
  {
    moved_.assign(mesh_.nodeCount(), 0);
    for (std::uint32_t n = 0; n < edited_.opened.nodes; ++n)
    {
      const std::uint32_t number = mesh_.node(n).number;
      moved_[n] =
        !mesh_.node(n).gone && number != None && !areSame(edited_.placeOf(n), nodes_.at[number]);
    }
    const auto& planes = boxes_.planes;
    for (const VertexNode& vertex : edited_.opened.onVertices)
    {
      const Point before{ planes[0][vertex.i], planes[1][vertex.j], planes[2][vertex.k] };
      moved_[vertex.node] =
        !mesh_.node(vertex.node).gone && !areSame(edited_.placeOf(vertex.node), before);
    }
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
    std::vector<std::uint32_t> faces(edited_.opened.cells); // how many each cell had
    for (const auto& cells : edited_.opened.cellsOf)
    {
      for (const std::uint32_t c : cells)
      {
        if (c < faces.size())
        {
          ++faces[c];
        }
      }
    }
    rewritten_.assign(wall_.size(), 0);
    for (std::uint32_t c = 0; c < mesh_.cellCount(); ++c)
    {
      const EditCell& cell = mesh_.cell(c);
      const bool isNew = c >= edited_.opened.cells;
      if (mesh_.isGhost(c) || (!isNew && !hasChanged(c, faces[c])))
      {
        continue;
      }
      if (!cell.gone)
      {
        written_.push_back(c);
      }
      if (!isNew && isHexahedron(cell.number))
      {
        promoted_.push_back(boxOfHexahedron(cell.number));
      }
      else if (!isNew)
      {
        rewritten_[cell.number] = 1;
      }
    }
    std::sort(written_.begin(), written_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::make_pair(mesh_.cell(a).home, orderOf(a)) <
        std::make_pair(mesh_.cell(b).home, orderOf(b));
    });
    std::sort(promoted_.begin(), promoted_.end());
  }

  bool hasChanged(std::uint32_t c, std::size_t facesBefore) const
  {
    const Items faces = mesh_.facesOf(c);
    return mesh_.cell(c).gone || faces.size() != facesBefore ||
      std::any_of(faces.begin(), faces.end(), [&](std::uint32_t f) {
        const Items corners = mesh_.cornersOf(f);
        return !isAsOpened(f) ||
          (edited_.opened.cellsOf[f][0] != c && edited_.opened.cellsOf[f][1] != c) ||
          std::any_of(
            corners.begin(), corners.end(), [&](std::uint32_t n) { return moved_[n] != 0; });
      });
  }

  // Among the cells of a box: as they were, then those made by edits.
  std::uint64_t orderOf(std::uint32_t c) const
  {
    return c < edited_.opened.cells ? mesh_.cell(c).number : std::uint64_t(FirstOfCuts) + c;
  }

  // --- nodes and faces

  template <class Visitor>
  void forEachWrittenFace(Visitor&& visit) const
  {
    for (const std::uint32_t c : written_)
    {
      for (const std::uint32_t f : mesh_.facesOf(c))
      {
        visit(f);
      }
    }
  }

  void writeNodes()
  {
    std::vector<std::uint8_t> used(mesh_.nodeCount());
    forEachWrittenFace([&](std::uint32_t f) {
      for (const std::uint32_t n : mesh_.cornersOf(f))
      {
        used[n] = 1;
      }
    });
    numbers_.nodes.assign(mesh_.nodeCount(), None);
    for (std::uint32_t n = 0; n < mesh_.nodeCount(); ++n)
    {
      std::uint32_t& number = numbers_.nodes[n];
      number = mesh_.node(n).number;
      if (number != None && moved_[n])
      {
        nodes_.at[number] = edited_.placeOf(n);
      }
      else if (number == None && used[n])
      {
        number = static_cast<std::uint32_t>(nodes_.at.size());
        nodes_.at.push_back(edited_.placeOf(n));
        if (n >= edited_.opened.nodes)
        {
          nodes_.ofCuts.push_back(number);
        }
      }
    }
    for (VertexNode vertex : edited_.opened.onVertices)
    {
      if (used[vertex.node])
      {
        vertex.node = numbers_.nodes[vertex.node];
        nodes_.moreVertices.push_back(vertex);
      }
    }
    std::sort(nodes_.moreVertices.begin(), nodes_.moreVertices.end());
    std::sort(nodes_.ofCuts.begin(), nodes_.ofCuts.end(),
      [&](std::uint32_t a, std::uint32_t b) { return nodes_.at[a] < nodes_.at[b]; });
  }

  void writeFaces()
  {
    std::vector<std::uint8_t> used(mesh_.faceCount());
    forEachWrittenFace([&](std::uint32_t f) { used[f] = 1; });
    numbers_.faces.assign(mesh_.faceCount(), None);
    numbers_.firstMade = static_cast<std::uint32_t>(wall_.faces.size());
    for (std::uint32_t f = 0; f < mesh_.faceCount(); ++f)
    {
      const EditFace& face = mesh_.face(f);
      if (!used[f])
      {
        continue;
      }
      if (face.number != None && isAsOpened(f))
      {
        numbers_.faces[f] = face.number;
        continue;
      }
      numbers_.faces[f] = static_cast<std::uint32_t>(wall_.faces.size());
      for (const std::uint32_t n : mesh_.cornersOf(f))
      {
        wall_.faces.corners.push_back(numbers_.nodes[n]);
      }
      wall_.faces.add({ keyBeyond(face.below), keyBeyond(face.above) }, boundaryOf(face));
    }
  }

  // Of a hexahedron that stays one, or None.
  CellKey keyBeyond(std::uint32_t c) const
  {
    const CellKey key = c == None || (c >= edited_.opened.cells && !mesh_.isGhost(c))
      ? CellKey(None)
      : mesh_.cell(c).number;
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
  std::vector<std::uint32_t> promote()
  {
    const std::vector<std::uint32_t> polyhedral = std::move(sides_.polyhedral);
    const std::vector<std::uint32_t> patchBox = std::move(sides_.patchBox);
    const std::vector<std::size_t> ownStart = std::move(sides_.ownStart);
    const std::vector<std::size_t> boxStart = std::move(sides_.boxStart);
    std::vector<std::uint32_t> before;
    std::size_t n = 0;
    const auto put = [&](std::uint32_t box, std::uint32_t patches, std::uint32_t old) {
      sides_.ordinal[box] = static_cast<std::uint32_t>(before.size());
      before.push_back(old);
      sides_.polyhedral.push_back(box);
      sides_.patchBox.push_back(patches);
      sides_.ownStart.push_back(ownStart[n]);
      sides_.boxStart.push_back(boxStart[n]);
    };
    sides_.polyhedral.clear();
    sides_.patchBox.clear();
    sides_.ownStart.clear();
    sides_.boxStart.clear();
    auto next = promoted_.begin();
    for (; n < polyhedral.size(); ++n)
    {
      for (; next != promoted_.end() && *next < polyhedral[n]; ++next)
      {
        put(*next, None, None);
      }
      put(polyhedral[n], patchBox[n], static_cast<std::uint32_t>(n));
    }
    for (; next != promoted_.end(); ++next)
    {
      put(*next, None, None);
    }
    sides_.ownStart.push_back(ownStart.back());
    sides_.boxStart.push_back(boxStart.back());
    return before;
  }

  // `before`: as promote() returns it.
  void writeCells(const std::vector<std::uint32_t>& before)
  {
    const WallMesh old = takeCells();
    wall_.cells.reserve(old.cells.size() + promoted_.size());
    wall_.uses.reserve(old.uses.size());
    auto next = written_.begin();
    const auto writeUpTo = [&](std::uint32_t box, std::uint64_t order) {
      for (; next != written_.end() && mesh_.cell(*next).home == box && orderOf(*next) <= order;
           ++next)
      {
        writeCell(*next);
      }
    };
    for (std::size_t n = 0; n < before.size(); ++n)
    {
      const std::uint32_t m = before[n];
      const std::uint32_t box = sides_.polyhedral[n];
      wall_.boxStart.push_back(wall_.cells.size());
      wall_.flawed.push_back(m == None ? std::uint8_t(0) : old.flawed[m]);
      for (std::size_t c = m == None ? 0 : old.boxStart[m]; m != None && c < old.boxStart[m + 1];
           ++c)
      {
        writeUpTo(box, c);
        if (!rewritten_[c])
        {
          Cell cell = old.cells[c];
          cell.firstUse = wall_.uses.size();
          wall_.cells.push_back(cell);
          old.forEachUse(c, [&](const FaceUse& use) { wall_.uses.push_back(use); });
        }
      }
      writeUpTo(box, ~std::uint64_t(0));
    }
    wall_.boxStart.push_back(wall_.cells.size());
    Cell end{};
    end.firstUse = wall_.uses.size();
    wall_.cells.push_back(end);
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

  void writeCell(std::uint32_t c)
  {
    const EditCell& edited = mesh_.cell(c);
    Cell cell{};
    cell.box = edited.home;
    cell.boundary = edited.wall;
    cell.region = edited.region;
    cell.volumeFraction = shareOf(c);
    cell.firstUse = wall_.uses.size();
    cell.reach = reachOf(c);
    wall_.cells.push_back(cell);
    for (const std::uint32_t f : mesh_.facesOf(c))
    {
      const bool isAbove = mesh_.face(f).above == c;
      const bool isMade = numbers_.faces[f] >= numbers_.firstMade;
      wall_.uses.emplace_back(
        numbers_.faces[f], isAbove != (!isMade && edited_.opened.turned[f] != 0));
    }
  }

  // Of its box's volume: as its faces' triangles enclose it, unlike EditCell's, which is a solver's.
  double shareOf(std::uint32_t c) const
  {
    const Box box = boxes_.box(mesh_.cell(c).home);
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

  // The layers of global boxes that a cell's nodes are in, below and above its own.
  std::array<std::uint8_t, 2> reachOf(std::uint32_t c) const
  {
    Level low = ~Level(0);
    Level high = 0;
    for (const std::uint32_t f : mesh_.facesOf(c))
    {
      for (const std::uint32_t n : mesh_.cornersOf(f))
      {
        const Level level = edited_.placeOf(n)[2];
        low = std::min(low, level);
        high = std::max(high, level);
      }
    }
    const std::vector<Level>& planes = boxes_.planes[2];
    const std::uint32_t layer = boxes_.globalOf(boxes_.packed[mesh_.cell(c).home]).index[2];
    std::array<std::uint8_t, 2> reach{ 0, 0 };
    while (planes[layer - reach[0]] > low && layer > reach[0])
    {
      ++reach[0];
    }
    while (layer + reach[1] + 1u < planes.size() - 1 && planes[layer + reach[1] + 1u] < high)
    {
      ++reach[1];
    }
    return reach;
  }

  // --- what lies on both sides of faces

  bool isStillHexahedron(CellKey key) const
  {
    return isHexahedron(key) && sides_.polyhedralOrdinal(boxOfHexahedron(key)) == None;
  }

  void findCellsOfFaces(Execution& execution)
  {
    WallFaces& faces = wall_.faces;
    execution.forEach(faces.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f)
      {
        for (CellKey& key : faces.cells[f])
        {
          key = isStillHexahedron(key) ? key : CellKey(None);
        }
      }
    });
    execution.forEach(wall_.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c)
      {
        wall_.forEachUse(c,
          [&](const FaceUse& use) { faces.cells[use.face][use.turned] = static_cast<CellKey>(c); });
      }
    });
  }

  // Hexahedra have kept their nodes: which side a face lies on is known by its place.
  void listSidesOfHexahedra()
  {
    const WallFaces& faces = wall_.faces;
    for (std::uint32_t f = numbers_.firstMade; f < faces.size(); ++f)
    {
      for (const CellKey key : faces.cells[f])
      {
        if (isHexahedron(key))
        {
          const std::uint32_t box = boxOfHexahedron(key);
          wall_.hexahedronSides.push_back({ box, sideOf(box, f), f });
        }
      }
    }
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
  const EditMesh& mesh_;
  const Boxes& boxes_;
  Sides& sides_;
  Nodes& nodes_;
  WallMesh& wall_;
  std::vector<std::uint8_t> moved_;     // nodes
  std::vector<std::uint8_t> rewritten_; // cells of the wall mesh that changed or went
  std::vector<std::uint32_t> written_;  // cells that changed, in the order of boxes
  std::vector<std::uint32_t> promoted_; // boxes of hexahedra that changed, in order
  NewNumbers numbers_;
};

}

void closeWall(const EditableWall& edited, const Boxes& boxes, Sides& sides, Nodes& nodes,
  WallMesh& wall, Execution& execution)
{
  Closing(edited, boxes, sides, nodes, wall).run(execution);
}

}
