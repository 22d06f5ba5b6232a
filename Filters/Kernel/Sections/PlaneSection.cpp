// SPDX-License-Identifier: BSD-3-Clause
#include "Sections/PlaneSection.h"

#include "Base/EdgeTable.h"
#include "Base/Sorting.h"
#include "Polyhedra/CellGeometry.h"
#include "Sections/PolygonBridges.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t CellsAChunk = 1024;

// An edge that crosses the plane, from its lower point to its upper one by number.
struct Edge
{
  std::uint32_t lower;
  std::uint32_t upper;

  bool operator==(const Edge& other) const { return lower == other.lower && upper == other.upper; }
  bool operator<(const Edge& other) const
  {
    return lower != other.lower ? lower < other.lower : upper < other.upper;
  }
};

// The section of a face: from an edge that goes down, seen around it from outside, to one that goes up.
struct Segment
{
  Edge from;
  Edge to;

  bool operator<(const Segment& other) const { return from < other.from; }
};

struct Crossing
{
  double along; // the line in which the face meets the plane
  bool isUp;
  Edge edge;
};

// Polygons of a chunk of cells, whose corners are edges.
struct Loops
{
  std::vector<std::size_t> size; // of each
  std::vector<std::uint32_t> cell;
  std::vector<Edge> corners;
};

class Cutter
{
public:
  Cutter(const CellFaces& cells, const double* points, const double* heights, const Vector& normal)
    : cells_(cells)
    , points_(points)
    , heights_(heights)
    , normal_(normal)
  {
  }

  void cut(std::size_t cell, Loops& loops)
  {
    segments_.clear();
    for (std::size_t face = cells_.firstFace[cell]; face < cells_.firstFace[cell + 1]; ++face)
    {
      cutFace(face);
    }
    if (!segments_.empty())
    {
      link(static_cast<std::uint32_t>(cell), loops);
    }
  }

  static PlaneSection::Place placeOf(const Edge& edge, const double* heights)
  {
    const double a = heights[edge.lower];
    const double b = heights[edge.upper];
    if (a == 0 || b == 0)
    {
      const std::uint32_t point = a == 0 ? edge.lower : edge.upper;
      return { point, point, 0 };
    }
    return { edge.lower, edge.upper, a / (a - b) };
  }

private:
  bool isAbove(std::uint32_t point) const { return heights_[point] >= 0; }

  void cutFace(std::size_t face)
  {
    const std::uint32_t* const corners = cells_.corners.data() + cells_.firstCorner[face];
    const std::size_t size = cells_.firstCorner[face + 1] - cells_.firstCorner[face];
    crossings_.clear();
    for (std::size_t i = 0; i < size; ++i)
    {
      const std::uint32_t a = corners[i];
      const std::uint32_t b = corners[i + 1 == size ? 0 : i + 1];
      if (isAbove(a) != isAbove(b))
      {
        crossings_.push_back({ 0, isAbove(b), { std::min(a, b), std::max(a, b) } });
      }
    }
    if (crossings_.size() > 2)
    {
      sortAlongFace(face, size);
    }
    for (std::size_t i = 0; i < crossings_.size(); i += 2)
    {
      const bool begins = !crossings_[i].isUp;
      segments_.push_back(
        { crossings_[begins ? i : i + 1].edge, crossings_[begins ? i + 1 : i].edge });
    }
  }

  // So that each two that follow one another begin and end a part of the section. Ways down and up alternate along the
  // line, and where rounding has it otherwise, they are made to.
  void sortAlongFace(std::size_t face, std::size_t size)
  {
    const auto corner = [&](std::size_t i) {
      return at(cells_.corners[cells_.firstCorner[face] + i]);
    };
    const Vector line = cross(normal_, measureFace(size, corner).area);
    for (Crossing& crossing : crossings_)
    {
      crossing.along = dot(line, place(crossing.edge));
    }
    std::stable_sort(crossings_.begin(), crossings_.end(),
      [](const Crossing& a, const Crossing& b) { return a.along < b.along; });
    for (std::size_t i = 0; i < crossings_.size(); ++i)
    {
      const auto next = std::find_if(crossings_.begin() + static_cast<std::ptrdiff_t>(i),
        crossings_.end(), [&](const Crossing& crossing) { return crossing.isUp == (i % 2 == 1); });
      std::rotate(crossings_.begin() + static_cast<std::ptrdiff_t>(i), next, next + 1);
    }
  }

  Vector at(std::uint32_t point) const
  {
    const double* p = points_ + 3 * std::size_t(point);
    return { p[0], p[1], p[2] };
  }

  Vector place(const Edge& edge) const
  {
    const PlaneSection::Place where = placeOf(edge, heights_);
    const Vector from = at(where.from);
    return plus(from, scaled(minus(at(where.to), from), where.part));
  }

  // Each edge that a segment ends at begins another.
  void link(std::uint32_t cell, Loops& loops)
  {
    std::sort(segments_.begin(), segments_.end());
    done_.assign(segments_.size(), 0);
    rings_.clear();
    for (std::size_t first = 0; first < segments_.size(); ++first)
    {
      std::vector<Edge> ring;
      for (std::size_t i = first; i < segments_.size() && done_[i] == 0; i = after(segments_[i]))
      {
        done_[i] = 1;
        add(segments_[i].from, ring);
      }
      while (ring.size() > 1 && isSamePlace(ring.front(), ring.back()))
      {
        ring.pop_back();
      }
      if (ring.size() > 2)
      {
        rings_.push_back(std::move(ring));
      }
    }
    if (rings_.size() > 1)
    {
      joinHoles();
    }
    for (const std::vector<Edge>& ring : rings_)
    {
      loops.size.push_back(ring.size());
      loops.cell.push_back(cell);
      loops.corners.insert(loops.corners.end(), ring.begin(), ring.end());
    }
  }

  std::size_t after(const Segment& segment) const
  {
    auto next = std::lower_bound(segments_.begin(), segments_.end(), Segment{ segment.to, {} });
    while (next != segments_.end() && next->from == segment.to &&
      done_[static_cast<std::size_t>(next - segments_.begin())] != 0)
    {
      ++next;
    }
    return next != segments_.end() && next->from == segment.to
      ? static_cast<std::size_t>(next - segments_.begin())
      : segments_.size();
  }

  bool isSamePlace(const Edge& a, const Edge& b) const
  {
    const PlaneSection::Place p = placeOf(a, heights_);
    const PlaneSection::Place q = placeOf(b, heights_);
    return p.from == q.from && p.to == q.to;
  }

  void add(const Edge& edge, std::vector<Edge>& ring) const
  {
    if (ring.empty() || !isSamePlace(ring.back(), edge))
    {
      ring.push_back(edge);
    }
  }

  void joinHoles()
  {
    std::vector<std::vector<Vector>> places;
    for (const std::vector<Edge>& ring : rings_)
    {
      places.emplace_back();
      for (const Edge& edge : ring)
      {
        places.back().push_back(place(edge));
      }
    }
    std::vector<std::vector<Edge>> joined;
    for (const Bridged& polygon : bridgeHoles(places, normal_))
    {
      joined.emplace_back();
      for (const auto& [ring, corner] : polygon)
      {
        joined.back().push_back(rings_[ring][corner]);
      }
    }
    rings_ = std::move(joined);
  }

  const CellFaces& cells_;
  const double* points_;
  const double* heights_;
  Vector normal_;
  std::vector<Crossing> crossings_;
  std::vector<Segment> segments_;
  std::vector<std::uint8_t> done_;
  std::vector<std::vector<Edge>> rings_;
};

// Numbers places in the order in which polygons have them.
PlaneSection numbered(const std::vector<Loops>& parts, const double* heights)
{
  std::size_t corners = 0;
  for (const Loops& part : parts)
  {
    corners += part.corners.size();
  }
  PlaneSection section;
  section.corners.reserve(corners);
  EdgeTable table;
  table.reset(corners);
  for (const Loops& part : parts)
  {
    auto corner = part.corners.begin();
    for (std::size_t i = 0; i < part.size.size(); ++i)
    {
      for (std::size_t j = 0; j < part.size[i]; ++j, ++corner)
      {
        const PlaneSection::Place place = Cutter::placeOf(*corner, heights);
        std::uint32_t& number = table.at(place.from, place.to);
        if (number == EdgeTable::Fresh)
        {
          number = static_cast<std::uint32_t>(section.places.size());
          section.places.push_back(place);
        }
        section.corners.push_back(number);
      }
      section.firstCorner.push_back(section.corners.size());
      section.cell.push_back(part.cell[i]);
    }
  }
  return section;
}

}

PlaneSection planeSection(const CellFaces& cells, const double* points, const double* heights,
  const Vector& normal, Execution& execution)
{
  std::vector<Loops> parts(chunks(cells.cellCount(), CellsAChunk));
  execution.nextLoop(0.7);
  execution.forEach(cells.cellCount(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    Cutter cutter(cells, points, heights, normal);
    for (std::size_t cell = begin; cell < end; ++cell)
    {
      cutter.cut(cell, parts[begin / CellsAChunk]);
    }
  });
  return numbered(parts, heights);
}

}
