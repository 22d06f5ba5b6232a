// SPDX-License-Identifier: BSD-3-Clause
// The cells at the wall as one mesh that is edited in place (sections 4.10 and 4.11): nodes, faces, cells, and which
// of them touch. A journal keeps what records were before they changed: any edit is undone bit for bit.
//
// Corners of faces and faces of nodes and cells are lists in one arena, never changed but written anew behind the
// others: to undo, the records get their old lists back, and the arena is cut.
//
// Lengths are in units of a power of two of lattice levels (EditMesh::unit), from an origin of its own: both are exact.
#pragma once

#include "Base/Execution.h"
#include "Base/RawVector.h"
#include "Boxes/LocalBox.h"
#include "Cells/SmallCellSpec.h"
#include "Editing/SharpRule.h"
#include "Lattice/Vector.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
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
  Ghost   // only its centre and volume are here, and those of its faces that others have
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
  Vector along{};    // OnSurface: the wall's normal; OnEdge: the edge's direction
  Vector home{};     // where it lay on the surface when its direction was found
  float leash = 0;   // how far it may move from there along the wall
  float strayed = 0; // how far the wall may have moved at it, by simplification
  ItemList faces;
  std::uint32_t epoch = 0;
  std::uint32_t number = None; // in Nodes; None: made here
  NodeKind kind = NodeKind::Free;
  std::uint8_t held =
    0; // bits: 1 << axis: it stays on its plane across x, y, z (the ends of a domain); 7: fixed
  bool atWall = false;
  bool gone = false;
};

// All axes: a node that stays where it is.
constexpr std::uint8_t HeldFast = 7;

// Where a wall is made of a face inside, its nodes may move so far along it, in boxes.
constexpr float LeashOfNewWalls = 0.1F;

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
  double debt = 0;   // the volume that the mesh should have more there
  float strayed = 0; // as of nodes
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
  std::uint32_t number = None; // in WallFaces; None: made here
  bool gone = false;
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
  double box = 1;              // the volume of its box
  double edge = 1;             // ... and that of a cube's edge
  std::uint32_t number = None; // a CellKey, or None: made here
  std::uint32_t home = None;   // its box (Boxes)
  std::int32_t wall = 0;       // of its largest part of the surface
  std::int32_t region = 0;
};

struct EditCell : CellOrigin
{
  Vector centre{};
  double volume = 0;
  double cost = 0;
  ItemList faces;
  std::uint32_t epoch = 0;
  std::uint32_t zone = 0; // which editor may change it (EditMesh::zone), or None
  std::int16_t misses =
    0; // Euler's formula, by 2 for each handle (CellClosure.h): not by more later on
  CellState state = CellState::Free;
  bool gone = false;
  bool strains = false; // solvers (WallObjective.h)
  bool touches = false; // itself along an edge, as frozen cells do: it may
};

// What edits since the last commit have changed.
struct Ledger
{
  double cost = 0;     // of all faces and cells
  double volume = 0;   // behind the walls
  double across = 0;   // behind faces between regions: what that with the lower number gets
  double fidelity = 0; // charges for what the wall lost
  int failures = 0;    // of faces: the sum of EditFace::fails
  int strains = 0;     // faces and cells that strain solvers
  int inverted = 0;    // sides of faces, and
  int skew = 0;        // faces, that checkMesh refuses

  void count(const EditFace& face, int sign)
  {
    failures += sign * int(face.fails);
    strains += sign * int(face.strains);
    inverted += sign * int(face.inverted);
    skew += sign * int(face.skew);
  }
};

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

// Zeroes by number, of which only the pages that are written take memory: each editor has some for the whole mesh.
template <class T>
class Zeroes
{
public:
  T& operator[](std::uint32_t i)
  {
    if (i >= size_)
    {
      grow(i);
    }
    return at_.get()[i];
  }
  T at(std::uint32_t i) const { return i < size_ ? at_.get()[i] : T(0); }

private:
  struct Free
  {
    void operator()(T* at) const { std::free(at); }
  };
  using Array = std::unique_ptr<T, Free>;

  void grow(std::uint32_t i)
  {
    const std::size_t size = std::size_t(i) + i / 2 + 1024;
    Array grown(static_cast<T*>(std::calloc(size, sizeof(T))));
    if (!grown)
    {
      throw std::bad_alloc();
    }
    std::copy_n(at_.get(), size_, grown.get());
    at_ = std::move(grown);
    size_ = size;
  }

  Array at_;
  std::size_t size_ = 0;
};

// Numbers, each once, until they are cleared.
class MarkedSet
{
public:
  void add(std::uint32_t i)
  {
    if (std::uint8_t& mark = marks_[i]; mark == 0)
    {
      mark = 1;
      items_.push_back(i);
    }
  }
  bool contains(std::uint32_t i) const { return marks_.at(i) != 0; }
  std::size_t size() const { return items_.size(); }
  std::uint32_t operator[](std::size_t i) const { return items_[i]; }
  std::vector<std::uint32_t>::const_iterator begin() const { return items_.begin(); }
  std::vector<std::uint32_t>::const_iterator end() const { return items_.end(); }
  void clear()
  {
    for (const std::uint32_t i : items_)
    {
      marks_[i] = 0;
    }
    items_.clear();
  }

private:
  Zeroes<std::uint8_t> marks_;
  std::vector<std::uint32_t> items_;
};

// What has to be measured again, and tested.
struct Unsettled
{
  MarkedSet faces;  // of other corners, or with a corner that moved
  MarkedSet cells;  // with such a face
  MarkedSet shapes; // cells with other faces, or with a face of other corners

  void clear()
  {
    faces.clear();
    cells.clear();
    shapes.clear();
  }
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

// The mesh itself, which several editors may change at the same time: each in a zone of its own (EditZones.h).
struct EditStore
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

// An editor: of the whole mesh, or of one zone.
class EditMesh
{
public:
  // Of a mesh of its own.
  EditMesh();

  // Of a zone; what it makes has these numbers, and its lists are in this arena.
  EditMesh(EditStore& store, std::uint32_t zone, std::uint16_t arena, FreeSlots slots);

  // --- reading

  std::size_t nodeCount() const { return store_->nodes.size(); }
  std::size_t faceCount() const { return store_->faces.size(); }
  std::size_t cellCount() const { return store_->cells.size(); }
  const EditNode& node(std::uint32_t i) const { return store_->nodes[i]; }
  const EditFace& face(std::uint32_t i) const { return store_->faces[i]; }
  const EditCell& cell(std::uint32_t i) const { return store_->cells[i]; }
  double level() const { return store_->level; }
  const SharpRule& sharp() const { return store_->sharp; }
  double wantedShare() const { return store_->wantedShare; }
  const Vector& low() const { return store_->low; }
  const Vector& high() const { return store_->high; }

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
    return wall >= 0 && i < store_->layered.size() && store_->layered[i] != 0;
  }
  bool isGhost(std::uint32_t c) const { return cell(c).state == CellState::Ghost; }

  // Whether a cell is there, and this editor may change it.
  bool isFree(std::uint32_t c) const
  {
    return !cell(c).gone && cell(c).zone == zone_ && cell(c).state == CellState::Free;
  }

  // Also of a record in the journal.
  Items itemsOf(const ItemList& list) const
  {
    const std::uint32_t* base = store_->arenas[list.arena].data();
    return { base + list.first, base + list.first + list.size };
  }

  // --- building: before the first mark, of a mesh of its own

  std::uint32_t addNode(const EditNode& node);
  std::uint32_t addCell(const EditCell& cell);
  std::uint32_t addFace(EditFace face, const std::uint32_t* corners, std::size_t size);
  void connect();
  EditStore& store() { return *store_; }
  const EditStore& store() const { return *store_; }

  // For measures, and to set what the journal does not have to know.
  // NOLINTBEGIN(readability-make-member-function-const): what changes is behind pointers
  EditNode& rawNode(std::uint32_t i) { return store_->nodes[i]; }
  EditFace& rawFace(std::uint32_t i) { return store_->faces[i]; }
  EditCell& rawCell(std::uint32_t i) { return store_->cells[i]; }
  // NOLINTEND(readability-make-member-function-const)

  // --- the journal

  struct Mark
  {
    std::size_t nodeRecords, faceRecords, cellRecords;
    std::size_t nodes, faces, cells, arena; // used slots; the arena's size
    Ledger ledger;
    std::uint32_t epoch;
    std::uint32_t epochs; // how many there were
  };

  // Marks nest: the inner is undone or kept before the outer. Where one is set, nothing is unsettled.
  Mark mark();
  void undo(const Mark& mark);

  // Goes on after an inner mark whose changes are kept.
  void keep(const Mark& inner);

  // All changes stay; without marks.
  void commit();

  // Gives back what old lists take, once that is much; after a commit. `zone`: all cells of this editor's but those it made.
  void reclaim(Items zone);

  // What nodes, faces and cells were at the marks: number and record, the oldest first. Those made since were gone.
  template <class Record>
  using Records = std::vector<std::pair<std::uint32_t, Record>>;
  const Records<EditNode>& nodeRecords() const { return journal_.nodes; }
  const Records<EditFace>& faceRecords() const { return journal_.faces; }
  const Records<EditCell>& cellRecords() const { return journal_.cells; }

  // Whether a record is the oldest of its face since a mark (Mark::epochs), or the last commit: later ones are of edits
  // within an edit.
  static bool isOldest(const EditFace& record, std::uint32_t since = 0)
  {
    return record.epoch <= since;
  }

  // --- changing

  EditNode& changeNode(std::uint32_t i) { return change(store_->nodes, journal_.nodes, i); }
  EditFace& changeFace(std::uint32_t i) { return change(store_->faces, journal_.faces, i); }
  EditCell& changeCell(std::uint32_t i) { return change(store_->cells, journal_.cells, i); }

  // New ones, with their places in the lists of corners and cells; None: there is no slot for them any more.
  std::uint32_t makeNode(const EditNode& node);
  std::uint32_t makeFace(const EditFace& face, const std::uint32_t* corners, std::size_t size);
  std::uint32_t makeCell(const EditCell& cell);

  // Gives a face other corners; the lists of nodes follow.
  void setCorners(std::uint32_t f, const std::uint32_t* corners, std::size_t size);

  // Gives a cell these faces; those know it already.
  void setFaces(std::uint32_t c, const std::uint32_t* faces, std::size_t size);
  void addFaceTo(std::uint32_t c, std::uint32_t f);

  // Makes a face one of another cell, on the same side. That cell's list does not follow.
  void giveFace(std::uint32_t f, std::uint32_t from, std::uint32_t to);

  // Takes a face from its nodes and, unless `cellsFollow` is false, cells. A node without faces goes.
  void removeFace(std::uint32_t f, bool cellsFollow = true);
  void removeCell(std::uint32_t c);

  void moveNode(std::uint32_t n, const Vector& to);

  Ledger ledger;
  Unsettled unsettled;

  // Nodes seen in a search of its own: a new stamp begins another. Whether this one is seen for the first time.
  std::uint32_t newStamp() { return ++stamps_.last; }
  bool stampNode(std::uint32_t n, std::uint32_t stamp)
  {
    std::uint32_t& last = stamps_.ofNodes[n];
    const bool isNew = last != stamp;
    last = stamp;
    return isNew;
  }

  // Cells made by this editor, with those that are gone again.
  Items madeCells() const
  {
    const std::uint32_t* first = slots_.cells.numbers.data();
    return { first, first + slots_.cells.used };
  }

  // With those that are used.
  FreeSlots takeSlots() { return std::move(slots_); }

private:
  struct Journal
  {
    Records<EditNode> nodes;
    Records<EditFace> faces;
    Records<EditCell> cells;
    std::uint32_t epoch = 1; // since the last mark that is set
    std::uint32_t epochs = 1;
    int marks = 0; // how many are set
  };

  struct Stamps
  {
    Zeroes<std::uint32_t> ofNodes;
    std::uint32_t last = 0;
  };

  template <class Record>
  Record& change(RecordVector<Record>& all, Records<Record>& records, std::uint32_t i)
  {
    Record& record = all[i];
    if (journal_.marks > 0 && record.epoch != journal_.epoch)
    {
      records.emplace_back(i, record);
      record.epoch = journal_.epoch;
    }
    return record;
  }

  template <class Record>
  std::uint32_t takeSlot(RecordVector<Record>& all, Slots& slots);

  // A copy with an empty list, or None.
  template <class Record>
  std::uint32_t make(
    const Record& record, RecordVector<Record>& all, Slots& slots, Records<Record>& records);

  // NOLINTNEXTLINE(readability-make-member-function-const): the same
  RawVector<std::uint32_t>& arena() { return store_->arenas[arena_]; }
  ItemList store(const std::uint32_t* items, std::size_t size);
  ItemList without(const ItemList& list, std::uint32_t item);
  ItemList with(const ItemList& list, std::uint32_t item);

  // Calls visit(item) for those of a list that another does not have. Most edits change a few of many corners: what both
  // begin and end with is passed over, or the time would grow with the square of their number.
  template <class Visitor>
  void forEachBeyond(const ItemList& list, const ItemList& other, Visitor&& visit) const
  {
    const std::size_t both = std::min(list.size, other.size);
    std::size_t first = 0;
    while (first < both && itemsOf(list)[first] == itemsOf(other)[first])
    {
      ++first;
    }
    std::size_t last = 0; // from the ends
    while (first + last < both &&
      itemsOf(list)[list.size - 1 - last] == itemsOf(other)[other.size - 1 - last])
    {
      ++last;
    }
    for (std::size_t i = first; i < list.size - last; ++i)
    {
      const Items others = itemsOf(other); // anew: visits may move lists
      if (const std::uint32_t n = itemsOf(list)[i];
          std::find(others.begin(), others.end(), n) == others.end())
      {
        visit(n);
      }
    }
  }

  void moveLists(std::uint32_t c, RawVector<std::uint32_t>& to, MarkedSet& nodes, MarkedSet& faces);
  void moveList(ItemList& list, RawVector<std::uint32_t>& to) const;

  std::unique_ptr<EditStore> own_;
  EditStore* store_;
  std::uint32_t zone_ = 0;
  std::uint16_t arena_ = 0;
  FreeSlots slots_;
  Journal journal_;
  Stamps stamps_;
  std::size_t mostItems_ = std::size_t(1) << 24; // of the arena, before lists are moved together
};

}
