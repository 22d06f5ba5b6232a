// SPDX-License-Identifier: BSD-3-Clause
// Edits of the faces around nodes that may move: a node collapses into another, or two faces of a cell become one. An
// edit is tried out in place, then committed or put back. The faces of cells stay closed, and no two have the same nodes.
#pragma once

#include "Optimisation/ClosedCells.h"

namespace cartesian
{

// A face of the wall mesh that has other corners now.
struct FaceEdit
{
  std::uint32_t face;              // in WallFaces
  std::vector<std::uint32_t> ring; // nodes, as the cell below has it; empty: it is gone
};

// What an edit or a node motion changes: faces, the cells beside them, and all faces of these. Each in order.
struct Surroundings
{
  std::vector<std::uint32_t> faces;
  std::vector<std::uint32_t> cells;
  std::vector<std::uint32_t> facesOfCells;
};

// Of each of many, some numbers: a list that grows goes behind all others.
class NumberLists
{
public:
  struct List
  {
    const std::uint32_t* first;
    const std::uint32_t* last;

    const std::uint32_t* begin() const { return first; }
    const std::uint32_t* end() const { return last; }
    bool empty() const { return first == last; }
  };

  // Calls forEach(add) twice, which calls add(list, number): to count, then to fill.
  template <class ForEach>
  void fill(std::size_t count, ForEach&& forEach);

  List operator[](std::size_t i) const
  {
    return { values_.data() + begin_[i], values_.data() + begin_[i] + size_[i] };
  }

  void set(std::size_t i, const std::vector<std::uint32_t>& numbers);

private:
  std::vector<std::size_t> begin_;
  std::vector<std::size_t> size_;
  std::vector<std::uint32_t> values_;
};

class FaceEdits
{
public:
  // Borrows the mesh, whose faces it changes.
  explicit FaceEdits(NodeMesh& mesh);

  // As they are now, in order; of nodes that may not move, those of this mesh.
  NumberLists::List facesOf(std::uint32_t node) const { return facesOf_[node]; }
  bool isGone(std::uint32_t f) const { return isGone_[f] != 0; }
  bool hasCorner(std::uint32_t f, std::uint32_t node) const;

  // Fills in the cells, and their faces.
  void lookAround(Surroundings& around) const;

  // Whether a face and its cells are of the wall mesh, not implicit, and the cells may change.
  bool mayChange(std::uint32_t f) const;

  // Whether two faces have the same cell or cells, and belong to the same boundary.
  bool areBetweenTheSame(std::uint32_t f, std::uint32_t g) const;

  // Replaces one node by another in all of its faces; those without an area are removed. `around`: the faces of
  // `from`, and what is around them. False: the result is not a valid mesh. Either way commit() or putBack() has to
  // follow.
  bool collapse(std::uint32_t from, std::uint32_t into, const Surroundings& around);

  // The first becomes the union of both. `around`: both. Otherwise the same.
  bool join(std::uint32_t f, std::uint32_t g, const Surroundings& around);

  void commit();
  void putBack();

  // What remains of the faces of the edit, in order.
  const std::vector<std::uint32_t>& remaining() const { return now_.remaining; }

  // Whether all cells of the edit are closed, and no face has the nodes of another.
  bool isSound();

  // All that was committed, in order of faces.
  std::vector<FaceEdit> edits() const;

private:
  using Numbers = std::vector<std::uint32_t>;

  // A part of an array, as it was.
  struct Range
  {
    std::uint32_t begin;
    std::uint32_t end;
    std::size_t kept; // the first of its numbers in kept_
  };

  void copyRing(std::uint32_t f, Numbers& ring) const;
  Range kept(const Numbers& from, std::uint32_t begin, std::uint32_t end);
  void putBack(const Range& range, Numbers& into) const;
  void keep(const Surroundings& around);
  void remove(std::uint32_t f);
  void setRing(std::uint32_t f, const Numbers& ring);
  void listEdges(std::uint32_t f, bool turned);
  bool traceUnion();
  bool areOnlyOf(std::uint32_t node, std::uint32_t f, std::uint32_t g) const;
  bool hasTwin(std::uint32_t f);

  // The present edit, and how all was before it.
  struct Present
  {
    Numbers faces;
    Numbers cells;
    Numbers remaining;
    std::vector<Range> rings; // of faces
    std::vector<Range> uses;  // of cells
    Numbers kept;             // of both, corners first
    std::size_t cornersKept = 0;
    std::size_t corners = 0; // how many there were
  };

  NodeMesh& m_;
  ClosedCells closed_;
  NumberLists facesOf_; // of nodes
  std::vector<std::uint8_t> isEdited_;
  std::vector<std::uint8_t> isGone_;
  Present now_;

  // Kept for their memory:
  Numbers ring_;
  Numbers other_;
  std::vector<std::array<std::uint32_t, 2>> edges_;
  std::vector<std::array<std::uint32_t, 2>> outer_;
};

template <class ForEach>
void NumberLists::fill(std::size_t count, ForEach&& forEach)
{
  begin_.assign(count, 0);
  size_.assign(count, 0);
  forEach([&](std::size_t i, std::uint32_t) { ++size_[i]; });
  std::size_t sum = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    begin_[i] = sum;
    sum += size_[i];
    size_[i] = 0;
  }
  values_.resize(sum);
  forEach([&](std::size_t i, std::uint32_t number) { values_[begin_[i] + size_[i]++] = number; });
}

}
