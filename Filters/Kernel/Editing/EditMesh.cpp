// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/EditMesh.h"

#include <algorithm>

namespace cartesian
{

namespace
{

template <class Record>
void restore(
  std::vector<Record>& all, EditMesh::Records<Record>& records, std::size_t count, std::size_t size)
{
  for (; records.size() > count; records.pop_back())
  {
    if (records.back().first < size)
    {
      all[records.back().first] = records.back().second;
    }
  }
  all.resize(size);
}

template <class Record>
void openLists(std::vector<Record>& all, std::uint32_t& next)
{
  for (Record& record : all)
  {
    record.faces.first = next;
    next += record.faces.size;
    record.faces.size = 0;
  }
}

}

// --- building

// Lists of the faces of nodes and cells take nearly twice the room of the corners.
void EditMesh::reserve(std::size_t nodes, std::size_t faces, std::size_t cells, std::size_t corners)
{
  nodes_.reserve(nodes);
  faces_.reserve(faces);
  cells_.reserve(cells);
  arena_.reserve(2 * corners + 2 * faces);
}

std::uint32_t EditMesh::addNode(const EditNode& node)
{
  nodes_.push_back(node);
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

std::uint32_t EditMesh::addCell(const EditCell& cell)
{
  cells_.push_back(cell);
  return static_cast<std::uint32_t>(cells_.size() - 1);
}

std::uint32_t EditMesh::addFace(EditFace face, const std::uint32_t* corners, std::size_t size)
{
  face.corners = store(corners, size);
  faces_.push_back(face);
  return static_cast<std::uint32_t>(faces_.size() - 1);
}

void EditMesh::connect()
{
  const auto forEachOwner = [&](const EditFace& face, auto&& visit) {
    for (const std::uint32_t c : { face.below, face.above })
    {
      if (c != None)
      {
        visit(cells_[c].faces);
      }
    }
    for (const std::uint32_t n : itemsOf(face.corners))
    {
      visit(nodes_[n].faces);
    }
  };
  for (const EditFace& face : faces_)
  {
    forEachOwner(face, [](ItemList& list) { ++list.size; });
  }
  auto next = static_cast<std::uint32_t>(arena_.size());
  openLists(cells_, next);
  openLists(nodes_, next);
  arena_.resize(next);
  for (std::uint32_t f = 0; f < faces_.size(); ++f)
  {
    forEachOwner(faces_[f], [&](ItemList& list) { arena_[list.first + list.size++] = f; });
    if (isWall(f))
    {
      for (const std::uint32_t n : cornersOf(f))
      {
        nodes_[n].atWall = true;
      }
    }
  }
}

// --- the journal

EditMesh::Mark EditMesh::mark()
{
  const Mark mark{ nodeRecords_.size(), faceRecords_.size(), cellRecords_.size(), nodes_.size(),
    faces_.size(), cells_.size(), arena_.size(), ledger, epoch_ };
  epoch_ = ++epochs_;
  ++marks_;
  return mark;
}

void EditMesh::undo(const Mark& mark)
{
  restore(nodes_, nodeRecords_, mark.nodeRecords, mark.nodes);
  restore(faces_, faceRecords_, mark.faceRecords, mark.faces);
  restore(cells_, cellRecords_, mark.cellRecords, mark.cells);
  arena_.resize(mark.arena);
  ledger = mark.ledger;
  unsettled.clear();
  keep(mark);
}

void EditMesh::keep(const Mark& inner)
{
  epoch_ = inner.epoch;
  --marks_;
}

void EditMesh::commit()
{
  nodeRecords_.clear();
  faceRecords_.clear();
  cellRecords_.clear();
  ledger = Ledger();
  unsettled.clear();
  marks_ = 0;
}

// --- lists

ItemList EditMesh::store(const std::uint32_t* items, std::size_t size)
{
  const auto first = static_cast<std::uint32_t>(arena_.size());
  arena_.insert(arena_.end(), items, items + size);
  return { first, static_cast<std::uint32_t>(size) };
}

ItemList EditMesh::without(const ItemList& list, std::uint32_t item)
{
  const auto first = static_cast<std::uint32_t>(arena_.size());
  arena_.resize(arena_.size() + list.size);
  std::uint32_t* to = arena_.data() + first;
  const std::uint32_t* from = arena_.data() + list.first;
  for (std::uint32_t i = 0; i < list.size; ++i)
  {
    if (from[i] != item)
    {
      *to++ = from[i];
    }
  }
  const auto end = static_cast<std::uint32_t>(to - arena_.data());
  arena_.resize(end);
  return { first, end - first };
}

ItemList EditMesh::with(const ItemList& list, std::uint32_t item)
{
  const auto first = static_cast<std::uint32_t>(arena_.size());
  arena_.resize(arena_.size() + list.size + 1);
  std::copy_n(arena_.data() + list.first, list.size, arena_.data() + first);
  arena_.back() = item;
  return { first, list.size + 1 };
}

// --- changing

std::uint32_t EditMesh::makeNode(EditNode node)
{
  node.epoch = epoch_;
  return addNode(node);
}

std::uint32_t EditMesh::makeCell(EditCell cell)
{
  cell.epoch = epoch_;
  const std::uint32_t c = addCell(cell);
  unsettled.cells.add(c);
  unsettled.shapes.add(c);
  return c;
}

std::uint32_t EditMesh::makeFace(EditFace face, const std::uint32_t* corners, std::size_t size)
{
  face.epoch = epoch_;
  const std::uint32_t f = addFace(face, corners, size);
  for (const std::uint32_t n : Items{ corners, corners + size })
  {
    EditNode& node = changeNode(n);
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
  const auto isIn = [&](std::uint32_t n, const ItemList& list) {
    const Items items = itemsOf(list);
    return std::find(items.begin(), items.end(), n) != items.end();
  };
  for (std::uint32_t i = 0; i < old.size; ++i)
  {
    if (const std::uint32_t n = arena_[old.first + i]; !isIn(n, face.corners))
    {
      EditNode& node = changeNode(n);
      node.faces = without(node.faces, f);
      node.gone = node.faces.size == 0;
    }
  }
  for (std::uint32_t i = 0; i < face.corners.size; ++i)
  {
    if (const std::uint32_t n = arena_[face.corners.first + i]; !isIn(n, old))
    {
      EditNode& node = changeNode(n);
      node.faces = with(node.faces, f);
    }
  }
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
  ledger.failures -= face.fails ? 1 : 0;
  face.fails = false;
  face.cost = 0;
  if (isWall(f))
  {
    ledger.volume -= face.behind;
  }
  face.gone = true;
  for (std::uint32_t i = 0; i < face.corners.size; ++i)
  {
    EditNode& node = changeNode(arena_[face.corners.first + i]);
    node.faces = without(node.faces, f);
    node.gone = node.faces.size == 0;
  }
  for (const std::uint32_t c : { face.below, face.above })
  {
    if (cellsFollow && c != None && !cells_[c].gone)
    {
      EditCell& cell = changeCell(c);
      cell.faces = without(cell.faces, f);
      unsettled.cells.add(c);
      unsettled.shapes.add(c);
    }
  }
}

void EditMesh::removeCell(std::uint32_t c)
{
  EditCell& cell = changeCell(c);
  ledger.cost -= cell.cost;
  ledger.failures -= cell.fails ? 1 : 0;
  cell.fails = false;
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

bool EditMesh::stampNode(std::uint32_t n, std::uint32_t stamp)
{
  if (n >= nodeStamps_.size())
  {
    nodeStamps_.resize(nodes_.size() + nodes_.size() / 8 + 64, 0);
  }
  const bool isNew = nodeStamps_[n] != stamp;
  nodeStamps_[n] = stamp;
  return isNew;
}

}
