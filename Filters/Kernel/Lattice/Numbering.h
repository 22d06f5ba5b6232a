// SPDX-License-Identifier: BSD-3-Clause
// Numbers points by sorting (section 7.1): equal points get equal ids, no matter which boxes use
// them.
//
// Points are sorted by rows of the global mesh, and by x, y, z within each row. A point belongs to
// the row of global boxes whose lower planes it is on or above.
#pragma once

#include "Base/Sorting.h"

#include "Lattice/Meshlines.h"

namespace cartesian
{

struct PointUse
{
  Point point;
  std::uint32_t row;
  std::uint32_t slot; // identifies the use; unique

  bool operator<(const PointUse& other) const { return point < other.point; }
};

// The row of a point that lies in or on a global box with the indices j and k.
inline std::uint32_t rowOfPoint(
  const Point& p, const Meshlines& planes, std::uint32_t j, std::uint32_t k)
{
  const std::uint32_t up = p[1] >= planes[1][j + 1] ? 1 : 0;
  const std::uint32_t back = p[2] >= planes[2][k + 1] ? 1 : 0;
  return static_cast<std::uint32_t>(j + up + (k + back) * planes[1].size());
}

inline std::size_t pointRows(const Meshlines& planes)
{
  return planes[1].size() * planes[2].size();
}

struct Numbering
{
  std::vector<Point> points;         // distinct
  RawVector<std::uint32_t> ofSlot;   // the id of each slot's point
  std::vector<std::size_t> rowStart; // first id of each row, and the end
};

// Slots count from 0 in each chunk: makes them count on from chunk to chunk.
void offsetSlots(std::vector<std::vector<PointUse>>& uses);

// The slots of all chunks together must be 0 to n - 1. Empties the chunks.
Numbering numberPoints(
  std::vector<std::vector<PointUse>>& uses, std::size_t rows, Execution& execution);

// Numbers a few points in the order in which they are first added: a hash table that keeps its
// storage.
class LocalPoints
{
public:
  void clear();
  std::uint32_t add(const Point& point);
  const std::vector<Point>& points() const { return points_; }

private:
  std::size_t slotOf(const Point& point) const;
  void grow();

  std::vector<Point> points_;
  std::vector<std::uint32_t>
    table_; // index in points_; valid if the slot's epoch is the current one
  std::vector<std::uint32_t> epochs_;
  std::uint32_t epoch_ = 0;
};

}
