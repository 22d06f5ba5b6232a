// SPDX-License-Identifier: BSD-3-Clause
// Numbering is sorting (section 7.1): equal points get equal ids, whoever needs them.
//
// Points are sorted row by row of the global mesh, each row by x, y, z. A point belongs to the
// row of global boxes whose lower planes it is on or above.
#pragma once

#include "Base/Sorting.h"

#include "Lattice/Meshlines.h"

namespace cartesian
{

struct PointUse
{
  Point point;
  std::uint32_t row;
  std::uint32_t slot; // who asks: any number, each once

  bool operator<(const PointUse& other) const { return point < other.point; }
};

// Row of a point that lies in or on global box (j, k) of its row.
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
  RawVector<std::uint32_t> ofSlot;   // id of each slot's point
  std::vector<std::size_t> rowStart; // first id of each row, and the end
};

// Makes slots that count from 0 in each chunk count on from chunk to chunk.
void offsetSlots(std::vector<std::vector<PointUse>>& uses);

// Slots of all chunks together are 0 to n - 1. Empties the chunks.
Numbering numberPoints(
  std::vector<std::vector<PointUse>>& uses, std::size_t rows, Execution& execution);

// Few points to and fro between their levels and the order in which they first came.
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
  std::vector<std::uint32_t> table_; // index in points_, where the epoch is this one
  std::vector<std::uint32_t> epochs_;
  std::uint32_t epoch_ = 0;
};

}
