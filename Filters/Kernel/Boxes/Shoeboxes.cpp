// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/Shoeboxes.h"

namespace cartesian
{

namespace
{

constexpr std::size_t TrianglesAChunk = 2048;
constexpr std::size_t RowsAChunk = 2; // few rows of large boxes may have most of the surface

// The boxes [first, last] of a row that a triangle passes through.
struct RowSpan
{
  std::uint32_t row;
  std::uint32_t triangle;
  std::uint32_t first;
  std::uint32_t last;

  // A triangle has only one span in each row.
  bool operator<(const RowSpan& other) const { return triangle < other.triangle; }
};

// The boxes of a row through which a triangle's piece passes.
void findSpan(const Fragment& piece, const Meshlines& planes, std::int64_t j, std::int64_t k,
  std::size_t triangle, std::vector<RowSpan>& found)
{
  const auto nj = static_cast<std::int64_t>(planes[1].size()) - 1;
  const auto nk = static_cast<std::int64_t>(planes[2].size()) - 1;
  const auto ni = static_cast<std::int64_t>(planes[0].size()) - 1;
  if (j < 0 || k < 0 || j >= nj || k >= nk)
  {
    return;
  }
  const auto [least, most] = rangeOf(piece, 0);
  const std::int64_t first = std::max<std::int64_t>(0, intervalOf(planes[0], least));
  const std::int64_t last = std::min(ni - 1, intervalOf(planes[0], most));
  if (first <= last)
  {
    found.push_back({ static_cast<std::uint32_t>(j + k * nj), static_cast<std::uint32_t>(triangle),
      static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last) });
  }
}

// How many triangles pass through each box of a row.
class RowCounts
{
public:
  explicit RowCounts(std::size_t boxes)
    : counts_(boxes)
  {
  }

  // Calls visit(i, count) for boxes of count > 0, in order.
  template <class Visitor>
  void forEachBox(const RowSpan* begin, const RowSpan* end, Visitor&& visit)
  {
    std::uint32_t first = ~0u;
    std::uint32_t last = 0;
    for (const RowSpan* s = begin; s != end; ++s)
    {
      first = std::min(first, s->first);
      last = std::max(last, s->last);
      for (std::uint32_t i = s->first; i <= s->last; ++i)
      {
        ++counts_[i];
      }
    }
    for (std::uint32_t i = first; begin != end && i <= last; ++i)
    {
      if (counts_[i] > 0)
      {
        visit(i, counts_[i]);
        counts_[i] = 0;
      }
    }
  }

private:
  std::vector<std::uint32_t> counts_;
};

// The boxes of a row in `boxes`, from box `next` on; `cursor` holds a slot for each i.
void fillRow(const Buckets<RowSpan>& spans, std::size_t row, RowCounts& counts,
  std::vector<std::size_t>& cursor, Shoeboxes& boxes)
{
  std::size_t next = boxes.rowStart[row];
  counts.forEachBox(spans.begin(row), spans.end(row), [&](std::uint32_t i, std::uint32_t) {
    boxes.column[next] = i;
    cursor[i] = boxes.triangleStart[next];
    ++next;
  });
  for (const RowSpan* s = spans.begin(row); s != spans.end(row); ++s)
  {
    for (std::uint32_t i = s->first; i <= s->last; ++i)
    {
      boxes.triangle[cursor[i]++] = s->triangle;
    }
  }
}

Shoeboxes boxesOfRows(const Buckets<RowSpan>& spans, std::size_t boxesAlongX, Execution& execution)
{
  Shoeboxes boxes;
  const std::size_t rows = spans.start.size() - 1;
  boxes.rowStart.assign(rows + 1, 0);
  execution.forEach(rows, RowsAChunk, [&](std::size_t begin, std::size_t end) {
    RowCounts counts(boxesAlongX);
    for (std::size_t row = begin; row < end; ++row)
    {
      counts.forEachBox(spans.begin(row), spans.end(row),
        [&](std::uint32_t, std::uint32_t) { ++boxes.rowStart[row]; });
    }
  });
  const std::size_t count = scan(boxes.rowStart);
  boxes.column.resize(count);
  boxes.triangleStart.assign(count + 1, 0);
  execution.forEach(rows, RowsAChunk, [&](std::size_t begin, std::size_t end) {
    RowCounts counts(boxesAlongX);
    for (std::size_t row = begin; row < end; ++row)
    {
      std::size_t next = boxes.rowStart[row];
      counts.forEachBox(spans.begin(row), spans.end(row),
        [&](std::uint32_t, std::uint32_t n) { boxes.triangleStart[next++] = n; });
    }
  });
  boxes.triangle.resize(scan(boxes.triangleStart));
  execution.forEach(rows, RowsAChunk, [&](std::size_t begin, std::size_t end) {
    RowCounts counts(boxesAlongX);
    std::vector<std::size_t> cursor(boxesAlongX);
    for (std::size_t row = begin; row < end; ++row)
    {
      fillRow(spans, row, counts, cursor, boxes);
    }
  });
  return boxes;
}

}

Shoeboxes fillShoeboxes(const Surface& surface, const Meshlines& planes, Execution& execution)
{
  const RowAxes axes = RowsAlong[0];
  const std::size_t count = surface.triangles.size();
  std::vector<std::vector<RowSpan>> spans(chunks(count, TrianglesAChunk));
  execution.nextLoop(0.2);
  execution.forEach(count, TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
    {
      forEachRowPiece(surface.corners(t), axes, planes,
        [&](std::int64_t j, std::int64_t k, const Fragment& piece) {
          findSpan(piece, planes, j, k, t, spans[begin / TrianglesAChunk]);
        });
    }
  });
  const std::size_t rows = (planes[1].size() - 1) * (planes[2].size() - 1);
  const Buckets<RowSpan> byRow = sortIntoBuckets(
    spans, rows, [](const RowSpan& s) { return s.row; }, execution);
  return boxesOfRows(byRow, planes[0].size() - 1, execution);
}

}
