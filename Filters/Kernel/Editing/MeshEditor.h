// SPDX-License-Identifier: BSD-3-Clause
// Edits of a mesh (EditMesh.h). A journal keeps what records were before they changed: any edit is undone bit for bit.
#pragma once

#include "Editing/EditMesh.h"
#include "Editing/Zeroes.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace cartesian
{

// What edits since the last commit have changed.
struct EditDelta
{
  double cost = 0;   // of all faces and cells
  double volume = 0; // behind the walls
  double interRegionVolume =
    0;                 // behind faces between regions: what that with the lower number gets
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
struct DirtySets
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

// An editor: of the whole mesh, or of one zone.
class MeshEditor : public MeshView
{
public:
  // Of a mesh of its own.
  MeshEditor();

  // Of a zone; what it makes has these numbers, and its lists are in this arena.
  MeshEditor(EditMesh& mesh, std::uint32_t zone, std::uint16_t arena, FreeSlots slots);

  // From now on of another zone, with lists in another arena.
  void enter(std::uint32_t zone, std::uint16_t arena, FreeSlots slots);

  // --- building: before the first mark, of a mesh of its own

  std::uint32_t addNode(const EditNode& node);
  std::uint32_t addCell(const EditCell& cell);
  std::uint32_t addFace(EditFace face, const std::uint32_t* corners, std::size_t size);
  void connect();
  EditMesh& mesh() { return *edited_; }
  using MeshView::mesh;

  // For measures, and to set what the journal does not have to know.
  // NOLINTBEGIN(readability-make-member-function-const): what changes is behind pointers
  EditNode& rawNode(std::uint32_t i) { return edited_->nodes[i]; }
  EditFace& rawFace(std::uint32_t i) { return edited_->faces[i]; }
  EditCell& rawCell(std::uint32_t i) { return edited_->cells[i]; }
  // NOLINTEND(readability-make-member-function-const)

  // --- the journal

  struct Mark
  {
    std::size_t nodeRecords, faceRecords, cellRecords;
    std::size_t nodes, faces, cells, arena; // used slots; the arena's size
    EditDelta delta;
    std::uint32_t epoch;
    std::uint32_t epochs; // how many there were
  };

  // Marks nest: the inner is undone or kept before the outer. Where one is set, nothing is dirty.
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

  EditNode& changeNode(std::uint32_t i) { return change(edited_->nodes, journal_.nodes, i); }
  EditFace& changeFace(std::uint32_t i) { return change(edited_->faces, journal_.faces, i); }
  EditCell& changeCell(std::uint32_t i) { return change(edited_->cells, journal_.cells, i); }

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

  EditDelta delta;
  DirtySets dirty;

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
  RawVector<std::uint32_t>& arena() { return edited_->arenas[arena_]; }
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

  explicit MeshEditor(std::unique_ptr<EditMesh> own);

  std::unique_ptr<EditMesh> own_;
  EditMesh* edited_;
  std::uint16_t arena_ = 0;
  FreeSlots slots_;
  Journal journal_;
  Stamps stamps_;
  static constexpr std::size_t MostItems = std::size_t(1) << 24;
  std::size_t mostItems_ = MostItems; // of the arena, before lists are moved together
};

}
