// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/SampleRays.h"

#include "Base/Sorting.h"
#include "Surface/LineCrossings.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

constexpr std::size_t TrianglesAChunk = 2048;
constexpr std::size_t SheetsAChunk = 4096;

// Sheets of more triangles are sorted on all threads.
constexpr std::size_t LargeSheet = 1 << 14;
constexpr std::size_t SortedAChunk = 1 << 13;

// How many triangles of a sheet lines are laid through, as a part of all and at least and at most:
// enough to outvote lines that pass through flaws of the surface.
constexpr std::size_t PartOfTriangles = 256;
constexpr std::size_t FewestTriangles = 12;
constexpr std::size_t MostTriangles = 63;

Wide magnitude(Wide x)
{
  return x < 0 ? -x : x;
}

Level evenNear(double level)
{
  return static_cast<Level>(2 * std::llround(level / 2));
}

// Takes the point midway between the triangle's centroid and one of its corners; `line` becomes the
// line of even levels nearest to it. False if that line misses the triangle.
bool findLine(const Corners& c, const RowAxes& axes, std::size_t corner, SampleRay& line)
{
  const auto weighted = [&](int axis) {
    return (double(c[0][axis]) + c[1][axis] + c[2][axis] + 3.0 * c[corner][axis]) / 6;
  };
  const auto [least, most] = std::minmax({ c[0][axes.outer], c[1][axes.outer], c[2][axes.outer] });
  line.outer = evenNear(weighted(axes.outer));
  if (line.outer < least || line.outer > most)
  {
    return false;
  }
  const auto [from, to, up] = crossedLevels(c, axes, line.outer);
  line.middle = evenNear(weighted(axes.middle));
  return line.middle > from && line.middle < to;
}

// Sorts the triangles of each sheet by size and lays lines through the largest.
class LineFinder
{
public:
  LineFinder(const Surface& surface, const ManifoldComponents& sheets, Execution& execution)
    : surface_(surface)
    , best_(surface.triangles.size())
  {
    execution.forEach(best_.size(), TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t)
      {
        best_[t] = largestProjection(t);
      }
    });
    Buckets<std::uint32_t> ofSheet = fillBuckets<std::uint32_t>(
      best_.size(), TrianglesAChunk, best_.size(),
      [&](std::size_t begin, std::size_t end, auto&& add) {
        for (std::size_t t = begin; t < end; ++t)
        {
          add(sheets.of(t), static_cast<std::uint32_t>(t));
        }
      },
      execution);
    sortLarge(ofSheet, execution);
    std::vector<Lines> parts(chunks(best_.size(), SheetsAChunk));
    execution.forEach(best_.size(), SheetsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t s = begin; s < end; ++s)
      {
        addLines(static_cast<std::uint32_t>(s), ofSheet.items.data() + ofSheet.start[s],
          ofSheet.items.data() + ofSheet.start[s + 1], parts[begin / SheetsAChunk]);
      }
    });
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (const Lines& part : parts)
      {
        lines_[axis].insert(lines_[axis].end(), part[axis].begin(), part[axis].end());
      }
    }
  }

  std::array<std::vector<SampleRay>, 3> takeLines() { return std::move(lines_); }

private:
  using Lines = std::array<std::vector<SampleRay>, 3>;

  struct Projection
  {
    Wide area = 0;
    int axis = 0;
  };

  Projection largestProjection(std::size_t triangle) const
  {
    Projection best;
    const std::array<Wide, 3> normal = exactNormal(surface_.corners(triangle));
    for (int axis = 0; axis < 3; ++axis)
    {
      const Wide area = magnitude(normal[axis]);
      best = area > best.area ? Projection{ area, axis } : best;
    }
    return best;
  }

  static std::size_t wantedOf(std::size_t size)
  {
    return std::min(size, std::clamp(size / PartOfTriangles, FewestTriangles, MostTriangles));
  }

  bool isLarger(std::uint32_t a, std::uint32_t b) const
  {
    return best_[a].area != best_[b].area ? best_[a].area > best_[b].area : sorted(a) < sorted(b);
  }

  // Puts the wanted triangles of sheets of many first, found among those of each chunk.
  void sortLarge(Buckets<std::uint32_t>& ofSheet, Execution& execution) const
  {
    const auto compare = [&](std::uint32_t a, std::uint32_t b) { return isLarger(a, b); };
    for (std::size_t s = 0; s < best_.size(); ++s)
    {
      const std::size_t size = ofSheet.start[s + 1] - ofSheet.start[s];
      if (size <= LargeSheet)
      {
        continue;
      }
      std::uint32_t* const triangles = ofSheet.items.data() + ofSheet.start[s];
      std::vector<std::vector<std::uint32_t>> parts(chunks(size, SortedAChunk));
      execution.forEach(size, SortedAChunk, [&](std::size_t begin, std::size_t end) {
        const std::size_t kept = std::min(wantedOf(size), end - begin);
        std::partial_sort(triangles + begin, triangles + begin + kept, triangles + end, compare);
        parts[begin / SortedAChunk].assign(triangles + begin, triangles + begin + kept);
      });
      std::vector<std::uint32_t> all = concatenated(parts);
      std::sort(all.begin(), all.end(), compare);
      std::copy_n(all.begin(), wantedOf(size), triangles);
    }
  }

  void addLines(std::uint32_t sheet, std::uint32_t* begin, std::uint32_t* end, Lines& lines) const
  {
    const auto size = static_cast<std::size_t>(end - begin);
    std::uint32_t* const wantedEnd = begin + wantedOf(size);
    if (size <= LargeSheet)
    {
      std::partial_sort(
        begin, wantedEnd, end, [&](std::uint32_t a, std::uint32_t b) { return isLarger(a, b); });
    }
    for (const std::uint32_t* t = begin; t != wantedEnd; ++t)
    {
      for (std::size_t corner = 0; best_[*t].area > 0 && corner < 3; ++corner)
      {
        SampleRay line{};
        const auto axis = static_cast<std::size_t>(best_[*t].axis);
        if (findLine(surface_.corners(*t), RowsAlong[axis], corner, line))
        {
          line.rank = static_cast<std::size_t>(t - begin);
          line.area = best_[*t].area;
          line.triangle = sorted(*t);
          line.sheet = sheet;
          lines[axis].push_back(line);
        }
      }
    }
  }

  std::array<std::uint32_t, 3> sorted(std::uint32_t triangle) const
  {
    std::array<std::uint32_t, 3> v = surface_.triangles[triangle];
    std::sort(v.begin(), v.end());
    return v;
  }

  const Surface& surface_;
  std::vector<Projection> best_; // of each triangle: its largest projection
  std::array<std::vector<SampleRay>, 3> lines_;
};

}

std::array<std::vector<SampleRay>, 3> findSampleRays(
  const Surface& surface, const ManifoldComponents& sheets, Execution& execution)
{
  return LineFinder(surface, sheets, execution).takeLines();
}

}
