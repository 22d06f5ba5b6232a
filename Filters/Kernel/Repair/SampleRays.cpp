// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/SampleRays.h"

#include "Repair/TrianglePlane.h"
#include "Surface/LineCrossings.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

constexpr std::size_t TrianglesAChunk = 2048;

// How many triangles of a sheet lines are laid through, as a part of all and at least, if there are so many, and at most:
// enough to outvote lines that pass through flaws of the surface.
constexpr std::size_t PartOfTriangles = 256;
constexpr std::size_t FewestTriangles = 12;
constexpr std::size_t MostTriangles = 63;

Level evenNear(double level)
{
  return static_cast<Level>(2 * std::llround(level / 2));
}

// Takes the point midway between the triangle's centroid and one of its corners; `place` becomes the
// nearest one on even levels. False if the line through that misses the triangle.
bool findPlace(const Corners& c, const RowAxes& axes, std::size_t corner, Point& place)
{
  const auto evenAt = [&](int axis) {
    return evenNear((double(c[0][axis]) + c[1][axis] + c[2][axis] + 3.0 * c[corner][axis]) / 6);
  };
  place = {};
  Level& outer = place[static_cast<std::size_t>(axes.outer)];
  Level& middle = place[static_cast<std::size_t>(axes.middle)];
  outer = evenAt(axes.outer);
  const auto [least, most] = std::minmax({ c[0][axes.outer], c[1][axes.outer], c[2][axes.outer] });
  if (outer < least || outer > most)
  {
    return false;
  }
  middle = evenAt(axes.middle);
  const auto [from, to, up] = crossedLevels(c, axes, outer);
  return middle > from && middle < to;
}

// Lays lines through the largest triangles of each sheet.
class RayFinder
{
public:
  RayFinder(const Surface& surface, Execution& execution)
    : surface_(surface)
    , best_(surface.triangles.size())
  {
    execution.forEach(best_.size(), TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t)
      {
        const Corners corners = surface_.corners(t);
        const std::size_t axis = axisOfNormal(corners);
        const Wide area = exactNormal(corners)[axis];
        best_[t] = { area < 0 ? -area : area, axis };
      }
    });
  }

  std::array<std::vector<SampleRay>, 3> run(const ManifoldComponents& sheets)
  {
    for (const Sheet& sheet : largestOf(sheets))
    {
      addRays(sheet);
    }
    return std::move(rays_);
  }

private:
  struct Projection
  {
    Wide area;
    std::size_t axis;
  };

  struct Sheet
  {
    std::uint32_t number;
    std::size_t size = 0;                    // in triangles
    std::vector<std::uint32_t> largest = {}; // triangles

    std::size_t wanted() const
    {
      return std::clamp(size / PartOfTriangles, FewestTriangles, MostTriangles);
    }
  };

  bool isLarger(std::uint32_t a, std::uint32_t b) const
  {
    return best_[a].area != best_[b].area ? best_[a].area > best_[b].area : sorted(a) < sorted(b);
  }

  // All sheets with the wanted number of triangles that have an area, the largest first.
  std::vector<Sheet> largestOf(const ManifoldComponents& sheets) const
  {
    const auto compare = [&](std::uint32_t a, std::uint32_t b) { return isLarger(a, b); };
    std::vector<std::uint32_t> place(best_.size()); // of a sheet, by its first triangle
    std::vector<Sheet> all;
    for (std::uint32_t t = 0; t < place.size(); ++t)
    {
      if (sheets.of(t) == t)
      {
        place[t] = static_cast<std::uint32_t>(all.size());
        all.push_back({ t });
      }
      ++all[place[sheets.of(t)]].size;
    }
    for (std::uint32_t t = 0; t < place.size(); ++t)
    {
      Sheet& sheet = all[place[sheets.of(t)]];
      std::vector<std::uint32_t>& heap = sheet.largest; // the smallest of them at its front
      const bool isFull = heap.size() == sheet.wanted();
      if (best_[t].area == 0 || (isFull && !isLarger(t, heap.front())))
      {
        continue;
      }
      if (isFull)
      {
        std::pop_heap(heap.begin(), heap.end(), compare);
        heap.pop_back();
      }
      heap.push_back(t);
      std::push_heap(heap.begin(), heap.end(), compare);
    }
    for (Sheet& sheet : all)
    {
      std::sort_heap(sheet.largest.begin(), sheet.largest.end(), compare);
    }
    return all;
  }

  void addRays(const Sheet& sheet)
  {
    for (std::size_t rank = 0; rank < sheet.largest.size(); ++rank)
    {
      const std::uint32_t t = sheet.largest[rank];
      const auto [area, axis] = best_[t];
      for (std::size_t corner = 0; corner < 3; ++corner)
      {
        Point place;
        if (findPlace(surface_.corners(t), RowsAlong[axis], corner, place))
        {
          rays_[axis].push_back({ place, rank, area, sheet.number, sorted(t) });
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
  std::array<std::vector<SampleRay>, 3> rays_;
};

}

std::array<std::vector<SampleRay>, 3> findSampleRays(
  const Surface& surface, const ManifoldComponents& sheets, Execution& execution)
{
  return RayFinder(surface, execution).run(sheets);
}

}
