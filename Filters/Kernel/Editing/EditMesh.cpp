// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/EditMesh.h"

#include "Base/Error.h"
#include "Base/Sorting.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <numeric>

namespace cartesian
{

namespace
{

constexpr std::size_t RecordsAChunk = 4096;

template <class Record>
void restore(RecordVector<Record>& all, EditMesh::Records<Record>& records, std::size_t count)
{
  for (; records.size() > count; records.pop_back())
  {
    all[records.back().first] = records.back().second;
  }
}

// So that no other editor takes them for records of its own epoch.
template <class Record>
void forget(RecordVector<Record>& all, EditMesh::Records<Record>& records)
{
  for (const auto& record : records)
  {
    all[record.first].epoch = 0;
  }
  records.clear();
}

ItemList& listOf(EditNode& node)
{
  return node.faces;
}
ItemList& listOf(EditFace& face)
{
  return face.corners;
}
ItemList& listOf(EditCell& cell)
{
  return cell.faces;
}

// Copies the lists of all records behind those that are in an arena already.
template <class Record>
void copyLists(RecordVector<Record>& all, const std::vector<RawVector<std::uint32_t>>& arenas,
  RawVector<std::uint32_t>& to, Execution& execution)
{
  std::vector<std::size_t> start(chunks(all.size(), RecordsAChunk) + 1, 0);
  execution.forEach(all.size(), RecordsAChunk, [&](std::size_t begin, std::size_t end) {
    std::size_t size = 0;
    for (std::size_t i = begin; i < end; ++i)
    {
      size += all[i].gone ? 0 : listOf(all[i]).size;
    }
    start[begin / RecordsAChunk + 1] = size;
  });
  start[0] = to.size();
  std::partial_sum(start.begin(), start.end(), start.begin());
  to.resize(start.back());
  execution.forEach(all.size(), RecordsAChunk, [&](std::size_t begin, std::size_t end) {
    std::size_t at = start[begin / RecordsAChunk];
    for (std::size_t i = begin; i < end; ++i)
    {
      ItemList& list = listOf(all[i]);
      list.size = all[i].gone ? std::uint16_t(0) : list.size;
      const std::uint32_t* from = arenas[list.arena].data() + list.first;
      std::copy_n(from, list.size, to.begin() + static_cast<std::ptrdiff_t>(at));
      list.first = static_cast<std::uint32_t>(at);
      list.arena = 0;
      at += list.size;
    }
  });
}

}

// A cell of 65,536 faces, or lists of a hundred million cells, do not fit.
ItemList listAt(std::size_t first, std::size_t size, std::uint16_t arena)
{
  if (first + size > std::numeric_limits<std::uint32_t>::max() ||
    size > std::numeric_limits<std::uint16_t>::max())
  {
    throw Error(Fault::TooManyBoxes,
      "A cell at the surface has too many faces, or there are too many such cells, to improve "
      "them. Try smaller cells or "
      "fewer triangles in the first case, larger cells in the second.");
  }
  return { static_cast<std::uint32_t>(first), static_cast<std::uint16_t>(size), arena };
}

// --- the mesh

void EditStore::connect(Execution& execution)
{
  const auto cornersOf = [&](const EditFace& face) {
    const std::uint32_t* first = arenas[0].data() + face.corners.first;
    return Items{ first, first + face.corners.size };
  };
  const auto lists = fillBuckets<std::uint32_t>(
    faces.size(), RecordsAChunk, cells.size() + nodes.size(),
    [&](std::size_t begin, std::size_t end, auto&& add) {
      for (auto f = static_cast<std::uint32_t>(begin); f < end; ++f)
      {
        for (const std::uint32_t c : { faces[f].below, faces[f].above })
        {
          c != None ? add(c, f) : void();
        }
        for (const std::uint32_t n : cornersOf(faces[f]))
        {
          add(cells.size() + n, f);
        }
      }
    },
    execution);
  const std::size_t first = arenas[0].size();
  arenas[0].resize(first + lists.items.size());
  const auto copy = [&](std::size_t list) {
    std::copy(lists.begin(list), lists.end(list),
      arenas[0].begin() + static_cast<std::ptrdiff_t>(first + lists.start[list]));
    return listAt(first + lists.start[list], lists.start[list + 1] - lists.start[list], 0);
  };
  execution.forEach(cells.size(), RecordsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c)
    {
      cells[c].faces = copy(c);
    }
  });
  execution.forEach(nodes.size(), RecordsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      const std::size_t list = cells.size() + n;
      nodes[n].faces = copy(list);
      nodes[n].atWall = std::any_of(
        lists.begin(list), lists.end(list), [&](std::uint32_t f) { return isSurface(faces[f]); });
    }
  });
}

void EditStore::compact(Execution& execution)
{
  RawVector<std::uint32_t> whole;
  whole.reserve(arenas[0].size());
  copyLists(nodes, arenas, whole, execution);
  copyLists(faces, arenas, whole, execution);
  copyLists(cells, arenas, whole, execution);
  arenas.resize(1);
  arenas[0] = std::move(whole);
}

void EditStore::release(Execution& execution)
{
  const std::array<std::function<void()>, 4> parts{ [&] { faces = {}; }, [&] { nodes = {}; },
    [&] { cells = {}; }, [&] { arenas = {}; } };
  execution.forEach(parts.size(), 1, [&](std::size_t i, std::size_t) { parts[i](); });
}

EditMesh::EditMesh()
  : own_(std::make_unique<EditStore>())
  , store_(own_.get())
{
}

EditMesh::EditMesh(EditStore& store, std::uint32_t zone, std::uint16_t arena, FreeSlots slots)
  : store_(&store)
  , zone_(zone)
  , arena_(arena)
  , slots_(std::move(slots))
{
}

std::uint32_t EditMesh::addNode(const EditNode& node)
{
  store_->nodes.push_back(node);
  return static_cast<std::uint32_t>(nodeCount() - 1);
}

std::uint32_t EditMesh::addCell(const EditCell& cell)
{
  store_->cells.push_back(cell);
  return static_cast<std::uint32_t>(cellCount() - 1);
}

std::uint32_t EditMesh::addFace(EditFace face, const std::uint32_t* corners, std::size_t size)
{
  face.corners = store(corners, size);
  store_->faces.push_back(face);
  return static_cast<std::uint32_t>(faceCount() - 1);
}

void EditMesh::connect()
{
  Execution execution;
  store_->connect(execution);
}

// --- the journal

EditMesh::Mark EditMesh::mark()
{
  const Mark mark{ journal_.nodes.size(), journal_.faces.size(), journal_.cells.size(),
    slots_.nodes.used, slots_.faces.used, slots_.cells.used, arena().size(), ledger, journal_.epoch,
    journal_.epochs };
  journal_.epoch = ++journal_.epochs;
  ++journal_.marks;
  return mark;
}

void EditMesh::undo(const Mark& mark)
{
  restore(store_->nodes, journal_.nodes, mark.nodeRecords);
  restore(store_->faces, journal_.faces, mark.faceRecords);
  restore(store_->cells, journal_.cells, mark.cellRecords);
  slots_.nodes.used = mark.nodes;
  slots_.faces.used = mark.faces;
  slots_.cells.used = mark.cells;
  arena().resize(mark.arena);
  ledger = mark.ledger;
  unsettled.clear();
  keep(mark);
}

void EditMesh::keep(const Mark& inner)
{
  journal_.epoch = inner.epoch;
  --journal_.marks;
}

void EditMesh::commit()
{
  forget(store_->nodes, journal_.nodes);
  forget(store_->faces, journal_.faces);
  forget(store_->cells, journal_.cells);
  ledger = Ledger();
  unsettled.clear();
  journal_.marks = 0;
}

// --- lists

void EditMesh::reclaim(Items zone)
{
  if (arena_ == 0 || arena().size() < mostItems_)
  {
    return;
  }
  RawVector<std::uint32_t> kept;
  MarkedSet nodes;
  MarkedSet faces;
  for (const Items cells : { zone, madeCells() })
  {
    for (const std::uint32_t c : cells)
    {
      moveLists(c, kept, nodes, faces);
    }
  }
  arena().swap(kept);
  mostItems_ = std::max(mostItems_, 2 * arena().size());
}

// Of a cell, its faces and their nodes, each once: an editor changes no others.
void EditMesh::moveLists(
  std::uint32_t c, RawVector<std::uint32_t>& to, MarkedSet& nodes, MarkedSet& faces)
{
  EditCell& cell = store_->cells[c];
  for (const std::uint32_t f : cell.gone ? Items{ nullptr, nullptr } : facesOf(c))
  {
    if (faces.contains(f))
    {
      continue;
    }
    faces.add(f);
    for (const std::uint32_t n : cornersOf(f))
    {
      if (!nodes.contains(n))
      {
        nodes.add(n);
        moveList(store_->nodes[n].faces, to);
      }
    }
    moveList(store_->faces[f].corners, to);
  }
  cell.gone ? void() : moveList(cell.faces, to);
}

void EditMesh::moveList(ItemList& list, RawVector<std::uint32_t>& to) const
{
  if (list.arena == arena_)
  {
    const Items items = itemsOf(list);
    list.first = static_cast<std::uint32_t>(to.size());
    to.insert(to.end(), items.begin(), items.end());
  }
}

ItemList EditMesh::store(const std::uint32_t* items, std::size_t size)
{
  RawVector<std::uint32_t>& to = arena();
  const std::size_t first = to.size();
  to.insert(to.end(), items, items + size);
  return listAt(first, size, arena_);
}

ItemList EditMesh::without(const ItemList& list, std::uint32_t item)
{
  RawVector<std::uint32_t>& all = arena();
  const std::size_t first = all.size();
  all.resize(first + list.size);
  const Items items = itemsOf(list);
  const auto end = std::remove_copy(
    items.begin(), items.end(), all.begin() + static_cast<std::ptrdiff_t>(first), item);
  all.erase(end, all.end());
  return listAt(first, all.size() - first, arena_);
}

ItemList EditMesh::with(const ItemList& list, std::uint32_t item)
{
  RawVector<std::uint32_t>& all = arena();
  const std::size_t first = all.size();
  all.resize(first + list.size + 1);
  const Items items = itemsOf(list);
  std::copy(items.begin(), items.end(), all.begin() + static_cast<std::ptrdiff_t>(first));
  all.back() = item;
  return listAt(first, list.size + 1U, arena_);
}

// --- changing

template <class Record>
std::uint32_t EditMesh::takeSlot(RecordVector<Record>& all, Slots& slots)
{
  if (slots.used == slots.numbers.size())
  {
    if (!own_)
    {
      return None;
    }
    slots.numbers.push_back(static_cast<std::uint32_t>(all.size()));
    all.emplace_back(Record()).gone = true;
  }
  return slots.numbers[slots.used++];
}

template <class Record>
std::uint32_t EditMesh::make(
  const Record& record, RecordVector<Record>& all, Slots& slots, Records<Record>& records)
{
  const std::uint32_t i = takeSlot(all, slots);
  if (i != None)
  {
    Record& made = change(all, records, i);
    const std::uint32_t epoch = made.epoch;
    made = record;
    made.epoch = epoch;
    listOf(made).size = 0;
  }
  return i;
}

std::uint32_t EditMesh::makeNode(const EditNode& node)
{
  return make(node, store_->nodes, slots_.nodes, journal_.nodes);
}

std::uint32_t EditMesh::makeCell(const EditCell& cell)
{
  const std::uint32_t c = make(cell, store_->cells, slots_.cells, journal_.cells);
  if (c != None)
  {
    rawCell(c).zone = zone_;
    unsettled.cells.add(c);
    unsettled.shapes.add(c);
  }
  return c;
}

std::uint32_t EditMesh::makeFace(
  const EditFace& face, const std::uint32_t* corners, std::size_t size)
{
  const std::uint32_t f = make(face, store_->faces, slots_.faces, journal_.faces);
  if (f == None)
  {
    return None;
  }
  rawFace(f).corners = store(corners, size);
  for (std::size_t i = 0; i < size; ++i)
  {
    EditNode& node = changeNode(corners[i]);
    node.faces = with(node.faces, f);
  }
  for (const std::uint32_t c : { face.below, face.above })
  {
    if (c != None)
    {
      addFaceTo(c, f);
    }
  }
  unsettled.faces.add(f);
  return f;
}

void EditMesh::setCorners(std::uint32_t f, const std::uint32_t* corners, std::size_t size)
{
  EditFace& face = changeFace(f);
  const ItemList old = face.corners;
  face.corners = store(corners, size);
  forEachBeyond(old, face.corners, [&](std::uint32_t n) {
    EditNode& node = changeNode(n);
    node.faces = without(node.faces, f);
    node.gone = node.faces.size == 0;
  });
  forEachBeyond(face.corners, old, [&](std::uint32_t n) {
    EditNode& node = changeNode(n);
    node.faces = with(node.faces, f);
  });
  unsettled.faces.add(f);
  for (const std::uint32_t c : { face.below, face.above })
  {
    if (c != None)
    {
      unsettled.shapes.add(c);
    }
  }
}

void EditMesh::setFaces(std::uint32_t c, const std::uint32_t* faces, std::size_t size)
{
  changeCell(c).faces = store(faces, size);
  unsettled.cells.add(c);
  unsettled.shapes.add(c);
}

void EditMesh::addFaceTo(std::uint32_t c, std::uint32_t f)
{
  EditCell& cell = changeCell(c);
  cell.faces = with(cell.faces, f);
  unsettled.cells.add(c);
  unsettled.shapes.add(c);
}

void EditMesh::giveFace(std::uint32_t f, std::uint32_t from, std::uint32_t to)
{
  EditFace& face = changeFace(f);
  (face.below == from ? face.below : face.above) = to;
}

void EditMesh::removeFace(std::uint32_t f, bool cellsFollow)
{
  EditFace& face = changeFace(f);
  ledger.cost -= face.cost;
  ledger.count(face, -1);
  face.fails = 0;
  face.strains = false;
  face.inverted = 0;
  face.skew = false;
  face.cost = 0;
  if (isSurface(f))
  {
    (isWall(f) ? ledger.volume : ledger.across) -= signOf(face) * face.behind;
  }
  face.gone = true;
  for (std::uint32_t i = 0; i < face.corners.size; ++i)
  {
    EditNode& node = changeNode(itemsOf(face.corners)[i]);
    node.faces = without(node.faces, f);
    node.gone = node.faces.size == 0;
  }
  for (const std::uint32_t c : { face.below, face.above })
  {
    if (cellsFollow && c != None && !cell(c).gone)
    {
      EditCell& its = changeCell(c);
      its.faces = without(its.faces, f);
      unsettled.cells.add(c);
      unsettled.shapes.add(c);
    }
  }
}

void EditMesh::removeCell(std::uint32_t c)
{
  EditCell& cell = changeCell(c);
  ledger.cost -= cell.cost;
  ledger.strains -= cell.strains ? 1 : 0;
  cell.strains = false;
  cell.cost = 0;
  cell.gone = true;
  cell.faces.size = 0;
}

void EditMesh::moveNode(std::uint32_t n, const Vector& to)
{
  changeNode(n).at = to;
  for (const std::uint32_t f : facesAround(n))
  {
    unsettled.faces.add(f);
  }
}

}
