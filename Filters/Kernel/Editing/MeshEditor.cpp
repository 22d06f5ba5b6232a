// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/MeshEditor.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace cartesian
{

namespace
{

template <class Record>
void restore(RecordVector<Record>& all, MeshEditor::Records<Record>& records, std::size_t count)
{
  for (; records.size() > count; records.pop_back())
  {
    all[records.back().first] = records.back().second;
  }
}

// So that no other editor takes them for records of its own epoch.
template <class Record>
void forget(RecordVector<Record>& all, MeshEditor::Records<Record>& records)
{
  for (const auto& record : records)
  {
    all[record.first].epoch = 0;
  }
  records.clear();
}

}

MeshEditor::MeshEditor()
  : MeshEditor(std::make_unique<EditMesh>())
{
}

MeshEditor::MeshEditor(std::unique_ptr<EditMesh> own)
  : MeshView(*own)
  , own_(std::move(own))
  , edited_(own_.get())
{
}

MeshEditor::MeshEditor(EditMesh& mesh, std::uint32_t zone, std::uint16_t arena, FreeSlots slots)
  : MeshView(mesh, zone)
  , edited_(&mesh)
  , arena_(arena)
  , slots_(std::move(slots))
{
}

void MeshEditor::enter(std::uint32_t zone, std::uint16_t arena, FreeSlots slots)
{
  setZone(zone);
  arena_ = arena;
  slots_ = std::move(slots);
  mostItems_ = MostItems;
}

std::uint32_t MeshEditor::addNode(const EditNode& node)
{
  edited_->nodes.push_back(node);
  return static_cast<std::uint32_t>(nodeCount() - 1);
}

std::uint32_t MeshEditor::addCell(const EditCell& cell)
{
  edited_->cells.push_back(cell);
  return static_cast<std::uint32_t>(cellCount() - 1);
}

std::uint32_t MeshEditor::addFace(EditFace face, const std::uint32_t* corners, std::size_t size)
{
  face.corners = store(corners, size);
  edited_->faces.push_back(face);
  return static_cast<std::uint32_t>(faceCount() - 1);
}

void MeshEditor::connect()
{
  Execution execution;
  edited_->connect(execution);
}

// --- the journal

MeshEditor::Mark MeshEditor::mark()
{
  const Mark mark{ journal_.nodes.size(), journal_.faces.size(), journal_.cells.size(),
    slots_.nodes.used, slots_.faces.used, slots_.cells.used, arena().size(), delta, journal_.epoch,
    journal_.epochs };
  journal_.epoch = ++journal_.epochs;
  ++journal_.marks;
  return mark;
}

void MeshEditor::undo(const Mark& mark)
{
  restore(edited_->nodes, journal_.nodes, mark.nodeRecords);
  restore(edited_->faces, journal_.faces, mark.faceRecords);
  restore(edited_->cells, journal_.cells, mark.cellRecords);
  slots_.nodes.used = mark.nodes;
  slots_.faces.used = mark.faces;
  slots_.cells.used = mark.cells;
  arena().resize(mark.arena);
  delta = mark.delta;
  dirty.clear();
  keep(mark);
}

void MeshEditor::keep(const Mark& inner)
{
  journal_.epoch = inner.epoch;
  --journal_.marks;
}

void MeshEditor::commit()
{
  forget(edited_->nodes, journal_.nodes);
  forget(edited_->faces, journal_.faces);
  forget(edited_->cells, journal_.cells);
  delta = EditDelta();
  dirty.clear();
  journal_.marks = 0;
}

// --- lists

void MeshEditor::reclaim(Items zone)
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
void MeshEditor::moveLists(
  std::uint32_t c, RawVector<std::uint32_t>& to, MarkedSet& nodes, MarkedSet& faces)
{
  EditCell& cell = edited_->cells[c];
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
        moveList(edited_->nodes[n].faces, to);
      }
    }
    moveList(edited_->faces[f].corners, to);
  }
  cell.gone ? void() : moveList(cell.faces, to);
}

void MeshEditor::moveList(ItemList& list, RawVector<std::uint32_t>& to) const
{
  if (list.arena == arena_)
  {
    const Items items = itemsOf(list);
    list.first = static_cast<std::uint32_t>(to.size());
    to.insert(to.end(), items.begin(), items.end());
  }
}

ItemList MeshEditor::store(const std::uint32_t* items, std::size_t size)
{
  RawVector<std::uint32_t>& to = arena();
  const std::size_t first = to.size();
  to.insert(to.end(), items, items + size);
  return listAt(first, size, arena_);
}

ItemList MeshEditor::without(const ItemList& list, std::uint32_t item)
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

ItemList MeshEditor::with(const ItemList& list, std::uint32_t item)
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
std::uint32_t MeshEditor::takeSlot(RecordVector<Record>& all, Slots& slots)
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
std::uint32_t MeshEditor::make(
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

std::uint32_t MeshEditor::makeNode(const EditNode& node)
{
  return make(node, edited_->nodes, slots_.nodes, journal_.nodes);
}

std::uint32_t MeshEditor::makeCell(const EditCell& cell)
{
  const std::uint32_t c = make(cell, edited_->cells, slots_.cells, journal_.cells);
  if (c != None)
  {
    rawCell(c).zone = zone();
    dirty.cells.add(c);
    dirty.shapes.add(c);
  }
  return c;
}

std::uint32_t MeshEditor::makeFace(
  const EditFace& face, const std::uint32_t* corners, std::size_t size)
{
  const std::uint32_t f = make(face, edited_->faces, slots_.faces, journal_.faces);
  if (f == None)
  {
    return None;
  }
  rawFace(f).corners = store(corners, size);
  rawFace(f).shaped = true;
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
  dirty.faces.add(f);
  return f;
}

void MeshEditor::setCorners(std::uint32_t f, const std::uint32_t* corners, std::size_t size)
{
  EditFace& face = changeFace(f);
  const ItemList old = face.corners;
  face.corners = store(corners, size);
  face.shaped = true;
  forEachBeyond(old, face.corners, [&](std::uint32_t n) {
    EditNode& node = changeNode(n);
    node.faces = without(node.faces, f);
    node.gone = node.faces.size == 0;
  });
  forEachBeyond(face.corners, old, [&](std::uint32_t n) {
    EditNode& node = changeNode(n);
    node.faces = with(node.faces, f);
  });
  dirty.faces.add(f);
  for (const std::uint32_t c : { face.below, face.above })
  {
    if (c != None)
    {
      dirty.shapes.add(c);
    }
  }
}

void MeshEditor::setFaces(std::uint32_t c, const std::uint32_t* faces, std::size_t size)
{
  changeCell(c).faces = store(faces, size);
  dirty.cells.add(c);
  dirty.shapes.add(c);
}

void MeshEditor::addFaceTo(std::uint32_t c, std::uint32_t f)
{
  EditCell& cell = changeCell(c);
  cell.faces = with(cell.faces, f);
  dirty.cells.add(c);
  dirty.shapes.add(c);
}

void MeshEditor::giveFace(std::uint32_t f, std::uint32_t from, std::uint32_t to)
{
  EditFace& face = changeFace(f);
  (face.below == from ? face.below : face.above) = to;
}

void MeshEditor::removeFace(std::uint32_t f, bool cellsFollow)
{
  EditFace& face = changeFace(f);
  delta.cost -= face.cost;
  delta.count(face, -1);
  face.fails = 0;
  face.strains = false;
  face.inverted = 0;
  face.skew = false;
  face.cost = 0;
  if (isSurface(f))
  {
    (isWall(f) ? delta.volume : delta.interRegionVolume) -= signOf(face) * face.behind;
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
      dirty.cells.add(c);
      dirty.shapes.add(c);
    }
  }
}

void MeshEditor::removeCell(std::uint32_t c)
{
  EditCell& cell = changeCell(c);
  delta.cost -= cell.cost;
  delta.strains -= cell.strains ? 1 : 0;
  cell.strains = false;
  cell.cost = 0;
  cell.gone = true;
  cell.faces.size = 0;
}

void MeshEditor::moveNode(std::uint32_t n, const Vector& to)
{
  changeNode(n).at = to;
  for (const std::uint32_t f : facesAround(n))
  {
    dirty.faces.add(f);
  }
}

}
