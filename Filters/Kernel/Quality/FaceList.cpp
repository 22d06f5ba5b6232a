// SPDX-License-Identifier: BSD-3-Clause
#include "Quality/FaceList.h"

#include "Base/Error.h"
#include "Base/Sorting.h"
#include "Quality/FaceCorners.h"

#include <array>
#include <limits>

namespace cartesian
{

namespace
{

constexpr std::size_t CellsAChunk = 1024;
constexpr std::size_t BucketsAChunk = 1024;

// In place of a neighbour.
constexpr std::uint32_t None = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint32_t Clash = None - 1;

// A face with its three lowest points as key: equal faces have these in common.
struct NamedFace
{
  std::array<std::uint32_t, 3> lowest;
  std::uint32_t face;

  bool operator<(const NamedFace& other) const
  {
    return lowest != other.lowest ? lowest < other.lowest : face < other.face;
  }
};

class Matcher
{
public:
  Matcher(const CellFaces& cells, Execution& execution);

  // The cell on the other side of each face, or None, or Clash.
  RawVector<std::uint32_t> neighbours(std::size_t pointCount, Execution& execution);

private:
  NamedFace named(std::size_t face) const;
  void matchRun(const NamedFace* begin, const NamedFace* end);
  void match(std::uint32_t face, std::uint32_t other);
  bool same(std::uint32_t face, std::uint32_t other, bool turned) const;

  const std::uint32_t* corners(std::size_t face) const
  {
    return cells_.corners.data() + cells_.firstCorner[face];
  }
  std::size_t size(std::size_t face) const
  {
    return cells_.firstCorner[face + 1] - cells_.firstCorner[face];
  }

  const CellFaces& cells_;
  RawVector<std::uint32_t> cellOf_;
  RawVector<std::uint32_t> neighbours_;
};

Matcher::Matcher(const CellFaces& cells, Execution& execution)
  : cells_(cells)
  , cellOf_(cells.faceCount())
  , neighbours_(cells.faceCount())
{
  execution.forEach(cells.cellCount(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c)
    {
      for (std::size_t f = cells.firstFace[c]; f < cells.firstFace[c + 1]; ++f)
      {
        cellOf_[f] = static_cast<std::uint32_t>(c);
        neighbours_[f] = None;
      }
    }
  });
}

NamedFace Matcher::named(std::size_t face) const
{
  NamedFace result{ { None, None, None }, static_cast<std::uint32_t>(face) };
  auto& [first, second, third] = result.lowest;
  for (std::size_t i = 0; i < size(face); ++i)
  {
    const std::uint32_t point = corners(face)[i];
    if (point < first)
    {
      third = second;
      second = first;
      first = point;
    }
    else if (point < second)
    {
      third = second;
      second = point;
    }
    else if (point < third)
    {
      third = point;
    }
  }
  return result;
}

bool Matcher::same(std::uint32_t face, std::uint32_t other, bool turned) const
{
  const std::size_t count = size(face);
  if (size(other) != count)
  {
    return false;
  }
  const std::uint32_t* const a = corners(face);
  const std::uint32_t* const b = corners(other);
  for (std::size_t shift = 0; shift < count; ++shift) // a face may have a point twice
  {
    std::size_t i = 0;
    while (i < count && a[i] == b[(shift + (turned ? count - i : i)) % count])
    {
      ++i;
    }
    if (i == count)
    {
      return true;
    }
  }
  return false;
}

void Matcher::match(std::uint32_t face, std::uint32_t other)
{
  // A cell may contain a wall without thickness: both its sides are boundary.
  if (cellOf_[face] == cellOf_[other])
  {
    return;
  }
  const bool fits = same(face, other, true);
  if (!fits && !same(face, other, false))
  {
    return;
  }
  const bool clash = !fits || neighbours_[face] != None || neighbours_[other] != None;
  neighbours_[face] = clash ? Clash : cellOf_[other];
  neighbours_[other] = clash ? Clash : cellOf_[face];
}

void Matcher::matchRun(const NamedFace* begin, const NamedFace* end)
{
  for (const NamedFace* a = begin; a != end; ++a)
  {
    for (const NamedFace* b = a + 1; b != end; ++b)
    {
      match(a->face, b->face);
    }
  }
}

RawVector<std::uint32_t> Matcher::neighbours(std::size_t pointCount, Execution& execution)
{
  std::vector<std::vector<NamedFace>> chunkItems(chunks(cells_.faceCount(), CellsAChunk));
  execution.forEach(cells_.faceCount(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    std::vector<NamedFace>& items = chunkItems[begin / CellsAChunk];
    items.reserve(end - begin);
    for (std::size_t f = begin; f < end; ++f)
    {
      items.push_back(named(f));
    }
  });
  const Buckets<NamedFace> byPoint = sortIntoBuckets(
    chunkItems, pointCount, [](const NamedFace& item) { return item.lowest[0]; }, execution);
  execution.nextLoop(0.9);
  execution.forEach(pointCount, BucketsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t point = begin; point < end; ++point)
    {
      const NamedFace* const last = byPoint.end(point);
      for (const NamedFace* run = byPoint.begin(point); run != last;)
      {
        const NamedFace* const next = std::find_if(
          run, last, [run](const NamedFace& item) { return item.lowest != run->lowest; });
        matchRun(run, next);
        run = next;
      }
    }
  });
  return std::move(neighbours_);
}

// No cell beyond, or several.
bool isOuter(std::uint32_t neighbour)
{
  return neighbour >= Clash;
}

void refuseClashes(const CellFaces& cells, const RawVector<std::uint32_t>& neighbours)
{
  const auto clash = std::find(neighbours.begin(), neighbours.end(), Clash);
  if (clash == neighbours.end())
  {
    return;
  }
  const auto face = static_cast<std::size_t>(clash - neighbours.begin());
  const auto next = std::upper_bound(cells.firstFace.begin(), cells.firstFace.end(), face);
  const auto cell = next - cells.firstFace.begin() - 1;
  throw Error(Fault::BadMesh,
    "Face " + std::to_string(face - *(next - 1)) + " of cell " + std::to_string(cell) +
      " is also a face of another cell on the same side: cells overlap, or not all faces of one "
      "point outwards. Filters that cut polyhedra, such as Clip, make such cells: write the mesh "
      "as it was before the filter.");
}

// Where the inner and the boundary faces of a cell begin in a FaceList.
struct Places
{
  std::size_t inner;
  std::size_t boundary;
};

void placeFaces(const CellFaces& cells, const RawVector<std::uint32_t>& neighbours,
  std::size_t cell, const Places& begin, FaceList& list)
{
  Places next = begin;
  for (std::size_t f = cells.firstFace[cell]; f < cells.firstFace[cell + 1]; ++f)
  {
    if (isOuter(neighbours[f]))
    {
      list.face[next.boundary++] = static_cast<std::uint32_t>(f);
    }
    else if (neighbours[f] > cell)
    {
      list.face[next.inner++] = static_cast<std::uint32_t>(f);
    }
  }
  std::sort(list.face.data() + begin.inner, list.face.data() + next.inner,
    [&](std::uint32_t a, std::uint32_t b) {
      return neighbours[a] != neighbours[b] ? neighbours[a] < neighbours[b] : a < b;
    });
  std::transform(list.face.data() + begin.inner, list.face.data() + next.inner,
    list.neighbour.data() + begin.inner, [&](std::uint32_t f) { return neighbours[f]; });
  const auto owner = static_cast<std::uint32_t>(cell);
  std::fill(list.owner.data() + begin.inner, list.owner.data() + next.inner, owner);
  std::fill(list.owner.data() + begin.boundary, list.owner.data() + next.boundary, owner);
}

}

void turnOutward(CellFaces& cells, const double* points, Execution& execution)
{
  const FaceCorners faces(cells, points);
  const auto volume = [&](std::size_t cell) {
    const Vector from = faces.corner(cells.firstFace[cell], 0);
    double sum = 0;
    for (std::size_t f = cells.firstFace[cell]; f < cells.firstFace[cell + 1]; ++f)
    {
      const auto corner = [&](std::size_t i) { return minus(faces.corner(f, i), from); };
      sum += measureCone(faces.size(f), corner).volume;
    }
    return sum;
  };
  execution.forEach(cells.cellCount(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c)
    {
      if (cells.firstFace[c] == cells.firstFace[c + 1] || !(volume(c) < 0))
      {
        continue;
      }
      for (std::size_t f = cells.firstFace[c]; f < cells.firstFace[c + 1]; ++f)
      {
        using Difference = RawVector<std::uint32_t>::difference_type;
        std::reverse(cells.corners.begin() + static_cast<Difference>(cells.firstCorner[f]),
          cells.corners.begin() + static_cast<Difference>(cells.firstCorner[f + 1]));
      }
    }
  });
}

FaceList listFaces(
  const CellFaces& cells, std::size_t pointCount, Clashes clashes, Execution& execution)
{
  if (std::max({ cells.cellCount(), cells.faceCount(), pointCount }) >= Clash)
  {
    throw Error(
      Fault::BadMesh, "The mesh has more faces than can be numbered in 32 bits: make it coarser.");
  }
  const RawVector<std::uint32_t> neighbours =
    Matcher(cells, execution).neighbours(pointCount, execution);
  if (clashes == Clashes::Refused)
  {
    refuseClashes(cells, neighbours);
  }

  std::vector<std::size_t> inner(cells.cellCount() + 1);
  std::vector<std::size_t> boundary(cells.cellCount() + 1);
  execution.forEach(cells.cellCount(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c)
    {
      const auto first = neighbours.begin() + static_cast<std::ptrdiff_t>(cells.firstFace[c]);
      const auto last = neighbours.begin() + static_cast<std::ptrdiff_t>(cells.firstFace[c + 1]);
      boundary[c] = static_cast<std::size_t>(std::count_if(first, last, isOuter));
      inner[c] = static_cast<std::size_t>(
        std::count_if(first, last, [c](std::uint32_t n) { return !isOuter(n) && n > c; }));
    }
  });
  const std::size_t innerCount = scan(inner);
  const std::size_t count = innerCount + scan(boundary);

  FaceList list;
  list.face.resize(count);
  list.owner.resize(count);
  list.neighbour.resize(innerCount);
  execution.forEach(cells.cellCount(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c)
    {
      placeFaces(cells, neighbours, c, { inner[c], innerCount + boundary[c] }, list);
    }
  });
  return list;
}

std::size_t faceBeyond(const CellFaces& cells, std::size_t face, std::uint32_t cell)
{
  const auto cornersOf = [&](std::size_t f) {
    std::vector<std::uint32_t> corners(
      cells.corners.begin() + static_cast<std::ptrdiff_t>(cells.firstCorner[f]),
      cells.corners.begin() + static_cast<std::ptrdiff_t>(cells.firstCorner[f + 1]));
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  const std::vector<std::uint32_t> corners = cornersOf(face);
  std::size_t other = cells.firstFace[cell];
  while (other < cells.firstFace[cell + 1] && cornersOf(other) != corners)
  {
    ++other;
  }
  return other;
}

void openFaces(const CellFaces& cells, const std::vector<std::size_t>& inner, FaceList& list)
{
  if (inner.empty())
  {
    return;
  }
  std::vector<std::array<std::uint32_t, 2>> outer; // cells and faces
  for (std::size_t i = list.neighbour.size(); i < list.face.size(); ++i)
  {
    outer.push_back({ list.owner[i], list.face[i] });
  }
  FaceList opened;
  auto next = inner.begin();
  for (std::size_t i = 0; i < list.neighbour.size(); ++i)
  {
    if (next != inner.end() && *next == i)
    {
      ++next;
      outer.push_back({ list.owner[i], list.face[i] });
      outer.push_back({ list.neighbour[i],
        static_cast<std::uint32_t>(faceBeyond(cells, list.face[i], list.neighbour[i])) });
      continue;
    }
    opened.face.push_back(list.face[i]);
    opened.owner.push_back(list.owner[i]);
    opened.neighbour.push_back(list.neighbour[i]);
  }
  std::sort(outer.begin(), outer.end());
  for (const auto& [cell, face] : outer)
  {
    opened.face.push_back(face);
    opened.owner.push_back(cell);
  }
  list = std::move(opened);
}

std::vector<std::size_t> sortByPatch(
  FaceList& list, const std::vector<std::uint32_t>& patch, std::size_t patchCount)
{
  const std::size_t inner = list.neighbour.size();
  std::vector<std::size_t> count(patchCount);
  for (const std::uint32_t p : patch)
  {
    ++count[p];
  }
  std::vector<std::size_t> next = count;
  scan(next);
  const auto outer = static_cast<std::ptrdiff_t>(inner);
  const std::vector<std::uint32_t> face(list.face.begin() + outer, list.face.end());
  const std::vector<std::uint32_t> owner(list.owner.begin() + outer, list.owner.end());
  for (std::size_t i = 0; i < patch.size(); ++i)
  {
    const std::size_t to = inner + next[patch[i]]++;
    list.face[to] = face[i];
    list.owner[to] = owner[i];
  }
  return count;
}

}
