// SPDX-License-Identifier: BSD-3-Clause
// The cells at the wall as one mesh that is edited in place (sections 4.10 and 4.11, MeshEditor.h): nodes, faces, cells, and
// which of them touch.
//
// Corners of faces and faces of nodes and cells are lists in one arena, never changed but written anew behind the
// others: to undo, the records get their old lists back, and the arena is cut.
//
// Lengths are in units of a power of two of lattice levels (MeshEditor::level), from an origin of its own: both are exact.
#pragma once

#include "Base/Execution.h"
#include "Base/RawVector.h"
#include "Boxes/LocalBox.h"
#include "Cells/SmallCellSpec.h"
#include "Editing/EditBlockDivision.h"
#include "Editing/SharpRule.h"
#include "Lattice/Vector.h"

#include <cstdint>
#include <new>
#include <utility>
#include <vector>

namespace cartesian
{

// In order of rank: of two nodes that become one, that with the higher kind stays where it is.
enum class NodeKind : std::uint8_t
{
  Free,      // inside the mesh
  OnSurface, // of the wall
  OnEdge,    // a sharp edge of the wall, or a border between boundaries
  Corner     // where such edges end or meet
};

enum class CellState : std::uint8_t
{
  Free,   // to change
  Frozen, // it touches itself along an edge, where the surface does: nothing of it changes unless solvers refuse it
  Ghost   // never edited; whole boxes: of hexahedra only those faces are here that others have, too
};

// Of items in one of the arenas.
struct ItemList
{
  std::uint32_t first = 0;
  std::uint16_t size = 0;
  std::uint16_t arena = 0;
};

// Throws if it does not fit.
ItemList listAt(std::size_t first, std::size_t size, std::uint16_t arena);

struct EditNode
{
  Vector at{};
  Vector along{};                 // OnSurface: the wall's normal; OnEdge: the edge's direction
  Vector referencePosition{};     // where it lay on the surface when its direction was found
  float maxDisplacement = 0;      // how far it may move from there along the wall
  float accumulatedDeviation = 0; // how far the wall may have moved at it, by simplification
  ItemList faces;
  std::uint32_t epoch = 0;
  std::uint32_t number = None; // in Nodes; None: made here
  NodeKind kind = NodeKind::Free;
  std::uint8_t constrainedAxes =
    0; // bits: 1 << axis: it stays on its plane across x, y, z (the ends of a domain); 7: fixed
  bool atWall = false;
  bool gone = false;
};

// All axes: a node that stays where it is.
constexpr std::uint8_t AllAxes = 7;

// Where a wall is made of a face inside, its nodes may move so far along it, in boxes.
constexpr float DisplacementOfNewWalls = 0.1F;

// As measured (WallObjective.h).
struct FaceShape
{
  Vector centre{};
  Vector area{};  // positive out of the cell below
  float star = 1; // the smallest triangle around the mean of the corners, by the mean one
  float warp = 0; // 1 - its area by the sum of these triangles'
};

// What a wall stands for.
struct WallPart
{
  Vector original{}; // the area of what the surface had there (unchanged by edits, except joins)
  double behind = 0; // the volume between it and the origin
  double volumeDeficit = 0;       // the volume that the mesh should have more there
  float accumulatedDeviation = 0; // as of nodes
};

// The corners are counter-clockwise as seen from above, from outside the cell below.
struct EditFace
  : FaceShape
  , WallPart
{
  double cost = 0;
  ItemList corners;
  std::uint32_t below = None;
  std::uint32_t above = None; // or None: a wall
  std::int32_t wall = -1;     // Walls.h: of a wall, or between two regions
  std::uint32_t epoch = 0;
  bool gone = false;
  bool shaped = false;    // made by edits, or with other corners since, or a wall
  std::uint8_t fails = 0; // limits of solvers (WallObjective.h)
  bool strains = false;
  std::uint8_t inverted = 0; // refused by checkMesh: sides
  bool skew = false;         // ... too
};

// Whether a face is part of what the surface became: a wall, or between two regions, and so a wall of both.
inline bool isSurface(const EditFace& face)
{
  return face.above == None || face.wall >= 0;
}

// Where a cell is from.
struct CellOrigin
{
  double boxVolume = 1;          // the volume of its box
  double edge = 1;               // ... and that of a cube's edge
  std::uint32_t number = None;   // a CellKey, or None: made here
  std::uint32_t boxIndex = None; // its box (Boxes)
  BoxPlace place;
  std::int32_t wall = 0; // of its largest part of the surface
  std::int32_t region = 0;
};

struct EditCell : CellOrigin
{
  Vector centre{};
  double volume = 0;
  double cost = 0;
  ItemList faces;
  std::uint32_t epoch = 0;
  std::uint32_t zone = 0; // which editor may change it (MeshView::zone), or None
  std::int16_t eulerDefect =
    0; // Euler's formula, by 2 for each handle (CellClosure.h): not by more later on
  CellState state = CellState::Free;
  bool gone = false;
  bool strains = false; // solvers (WallObjective.h)
  bool touches = false; // itself along an edge, as frozen cells do: it may
};

inline ItemList& listOf(EditNode& node)
{
  return node.faces;
}
inline ItemList& listOf(EditFace& face)
{
  return face.corners;
}
inline ItemList& listOf(EditCell& cell)
{
  return cell.faces;
}

// Items of a list in the arena; no longer valid once the mesh changes.
struct Items
{
  const std::uint32_t* first;
  const std::uint32_t* last;

  const std::uint32_t* begin() const { return first; }
  const std::uint32_t* end() const { return last; }
  std::size_t size() const { return static_cast<std::size_t>(last - first); }
  std::uint32_t operator[](std::size_t i) const { return first[i]; }
};

// Numbers of records that are gone, for what is made: the first are taken first.
struct Slots
{
  std::vector<std::uint32_t> numbers;
  std::size_t used = 0;
};

struct FreeSlots
{
  Slots nodes;
  Slots faces;
  Slots cells;
};

// Leaves new records unset: all threads write them.
template <class Record>
struct UnsetAllocator : RawAllocator<Record>
{
  template <class U>
  struct rebind // NOLINT(readability-identifier-naming): the standard's name
  {
    using other = UnsetAllocator<U>;
  };

  template <class U, class... Arguments>
  void construct(U* at, Arguments&&... arguments)
  {
    if constexpr (sizeof...(Arguments) > 0)
    {
      ::new (static_cast<void*>(at)) U{ std::forward<Arguments>(arguments)... };
    }
  }
};

template <class Record>
using RecordVector = std::vector<Record, UnsetAllocator<Record>>;

// The mesh itself, which several editors may change at the same time: each in a zone of its own (EditBlocks.h).
struct EditMesh
{
  static constexpr double Beyond = 1e30;

  RecordVector<EditNode> nodes;
  RecordVector<EditFace> faces;
  RecordVector<EditCell> cells;
  std::vector<RawVector<std::uint32_t>> arenas{
    {}
  };                // the first, which only compact() changes; each editor's
  FreeSlots spare;  // all unused
  double level = 1; // the length of a lattice level: a power of two
  SharpRule sharp;
  double wantedShare = 0.35; // of its box: of cells that are large enough
  SmallCellSpec small;       // which cells go at any cost
  std::vector<std::uint8_t>
    layered; // of each wall's index, whether it will have layers; none beyond

  // The ends of the grid, which nothing leaves.
  Vector low{ -Beyond, -Beyond, -Beyond };
  Vector high{ Beyond, Beyond, Beyond };

  // Lists the faces of cells and nodes, once all faces are there; marks nodes at walls.
  void connect(Execution& execution);

  // Puts all lists into the first arena, in the order of nodes, faces and cells; the others go.
  void compact(Execution& execution);

  // Gives the memory back: of so much of it, this takes a while.
  void release(Execution& execution);
};

// What is read of it. Cheap to copy; holds nothing itself.
class MeshView
{
public:
  explicit MeshView(const EditMesh& mesh, std::uint32_t zone = 0)
    : mesh_(&mesh)
    , zone_(zone)
  {
  }

  std::size_t nodeCount() const { return mesh_->nodes.size(); }
  std::size_t faceCount() const { return mesh_->faces.size(); }
  std::size_t cellCount() const { return mesh_->cells.size(); }
  const EditNode& node(std::uint32_t i) const { return mesh_->nodes[i]; }
  const EditFace& face(std::uint32_t i) const { return mesh_->faces[i]; }
  const EditCell& cell(std::uint32_t i) const { return mesh_->cells[i]; }
  double level() const { return mesh_->level; }
  const SharpRule& sharp() const { return mesh_->sharp; }
  double wantedShare() const { return mesh_->wantedShare; }
  const Vector& low() const { return mesh_->low; }
  const Vector& high() const { return mesh_->high; }

  Items cornersOf(std::uint32_t f) const { return itemsOf(face(f).corners); }
  Items facesOf(std::uint32_t c) const { return itemsOf(cell(c).faces); }
  Items facesAround(std::uint32_t n) const { return itemsOf(node(n).faces); }

  const Vector& corner(std::uint32_t f, std::size_t i) const
  {
    return node(itemsOf(face(f).corners)[i]).at;
  }

  // Calls visit(cell) for all cells that share a node with a cell, itself too; for some several times.
  template <class Visitor>
  void forEachCellAround(std::uint32_t c, Visitor&& visit) const
  {
    for (const std::uint32_t f : facesOf(c))
    {
      for (const std::uint32_t n : cornersOf(f))
      {
        for (const std::uint32_t g : facesAround(n))
        {
          visit(face(g).below);
          isWall(g) ? void() : visit(face(g).above);
        }
      }
    }
  }

  // The cell on the other side of a cell's face, or None.
  std::uint32_t beyond(std::uint32_t f, std::uint32_t c) const
  {
    return face(f).below == c ? face(f).above : face(f).below;
  }
  bool isWall(std::uint32_t f) const { return face(f).above == None; }

  // The edge of a cube of the volume of a box at a node.
  double edgeAt(std::uint32_t n) const { return cell(face(facesAround(n)[0]).below).edge; }
  bool isSurface(std::uint32_t f) const { return cartesian::isSurface(face(f)); }

  // Which way a face of the surface looks: -1 where it is between two regions and out of that with the higher number.
  double signOf(const EditFace& face) const
  {
    return face.above == None || cell(face.below).region < cell(face.above).region ? 1 : -1;
  }
  double signOf(std::uint32_t f) const { return signOf(face(f)); }
  bool hasLayers(std::int32_t wall) const
  {
    const auto i = static_cast<std::size_t>(wall);
    return wall >= 0 && i < mesh_->layered.size() && mesh_->layered[i] != 0;
  }
  bool isGhost(std::uint32_t c) const { return cell(c).state == CellState::Ghost; }

  // Also of a record in the journal.
  Items itemsOf(const ItemList& list) const
  {
    const std::uint32_t* base = mesh_->arenas[list.arena].data();
    return { base + list.first, base + list.first + list.size };
  }

  // Whether a cell is there, and of this zone.
  bool isFree(std::uint32_t c) const
  {
    return !cell(c).gone && cell(c).zone == zone_ && cell(c).state == CellState::Free;
  }

  // Whether all cells of a face are.
  bool areCellsFree(std::uint32_t f) const
  {
    return isFree(face(f).below) && (isWall(f) || isFree(face(f).above));
  }

  const EditMesh& mesh() const { return *mesh_; }
  std::uint32_t zone() const { return zone_; }

protected:
  void setZone(std::uint32_t zone) { zone_ = zone; }

private:
  const EditMesh* mesh_;
  std::uint32_t zone_;
};

}
