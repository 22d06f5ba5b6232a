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

using Place = PlaneSection::Place;

// What faces' corners and fans' centres have in common: numbers, places and heights. Fans come after the points.
class Ends
{
public:
  Ends(const double* points, const std::vector<double>& heights, const FaceFans& fans,
    const SectionPlane& plane)
    : points_(points)
    , heights_(heights)
    , given_(static_cast<std::uint32_t>(heights.size()))
    , fans_(fans)
  {
    for (const Vector& centre : fans.centres)
    {
      ofFans_.push_back(plane.height(centre));
    }
  }

  std::uint32_t ofFan(std::uint32_t fan) const { return given_ + fan; }
  bool isFan(std::uint32_t end) const { return end >= given_; }
  std::uint32_t fan(std::uint32_t end) const { return end - given_; }
  double height(std::uint32_t end) const { return isFan(end) ? ofFans_[fan(end)] : heights_[end]; }
  bool isAbove(std::uint32_t end) const { return height(end) >= 0; }
  std::uint32_t given() const { return given_; }

  Vector at(std::uint32_t end) const
  {
    if (isFan(end))
    {
      return fans_.centres[fan(end)];
    }
    const double* p = points_ + 3 * std::size_t(end);
    return { p[0], p[1], p[2] };
  }

  Place place(const Edge& edge) const
  {
    const double a = height(edge.lower);
    const double b = height(edge.upper);
    if (a == 0 || b == 0)
    {
      const std::uint32_t end = a == 0 ? edge.lower : edge.upper;
      return { end, end, 0 };
    }
    return { edge.lower, edge.upper, a / (a - b) };
  }

  Vector at(const Place& place) const
  {
    const Vector from = at(place.from);
    return plus(from, scaled(minus(at(place.to), from), place.part));
  }

private:
  const double* points_;
  const std::vector<double>& heights_;
  std::vector<double> ofFans_;
  std::uint32_t given_;
  const FaceFans& fans_;
};

class Cutter
{
public:
  Cutter(const CellFaces& cells, const Ends& ends, const FaceFans& fans, const Vector& normal)
    : cells_(cells)
    , ends_(ends)
    , fans_(fans)
    , normal_(normal)
  {
  }

  void cut(std::size_t cell, Loops& loops)
  {
    segments_.clear();
    for (std::size_t face = cells_.firstFace[cell]; face < cells_.firstFace[cell + 1]; ++face)
    {
      const std::uint32_t* const corners = cells_.corners.data() + cells_.firstCorner[face];
      const std::size_t size = cells_.firstCorner[face + 1] - cells_.firstCorner[face];
      if (fans_.fanOf[face] == NoPoint)
      {
        cutPolygon(corners, size);
        continue;
      }
      for (std::size_t i = 0; i < size; ++i)
      {
        const std::array<std::uint32_t, 3> triangle{ corners[i], corners[i + 1 == size ? 0 : i + 1],
          ends_.ofFan(fans_.fanOf[face]) };
        cutPolygon(triangle.data(), 3);
      }
    }
    if (!segments_.empty())
    {
      link(static_cast<std::uint32_t>(cell), loops);
    }
  }

private:
  void cutPolygon(const std::uint32_t* corners, std::size_t size)
  {
    crossings_.clear();
    for (std::size_t i = 0; i < size; ++i)
    {
      const std::uint32_t a = corners[i];
      const std::uint32_t b = corners[i + 1 == size ? 0 : i + 1];
      if (ends_.isAbove(a) != ends_.isAbove(b))
      {
        crossings_.push_back({ 0, ends_.isAbove(b), { std::min(a, b), std::max(a, b) } });
      }
    }
    if (crossings_.size() > 2)
    {
      sortAlong(corners, size);
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
  void sortAlong(const std::uint32_t* corners, std::size_t size)
  {
    const auto corner = [&](std::size_t i) { return ends_.at(corners[i]); };
    const Vector line = cross(normal_, measureFace(size, corner).area);
    for (Crossing& crossing : crossings_)
    {
      crossing.along = dot(line, ends_.at(ends_.place(crossing.edge)));
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
    const Place p = ends_.place(a);
    const Place q = ends_.place(b);
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
        places.back().push_back(ends_.at(ends_.place(edge)));
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
  const Ends& ends_;
  const FaceFans& fans_;
  Vector normal_;
  std::vector<Crossing> crossings_;
  std::vector<Segment> segments_;
  std::vector<std::uint8_t> done_;
  std::vector<std::vector<Edge>> rings_;
};

class Numbering
{
public:
  Numbering(const std::vector<Loops>& parts, const Ends& ends)
    : parts_(parts)
    , ends_(ends)
  {
  }

  // Numbers places in the order in which polygons have them.
  PlaneSection number()
  {
    std::size_t corners = 0;
    for (const Loops& part : parts_)
    {
      corners += part.corners.size();
    }
    section_.corners.reserve(corners);
    table_.reset(corners);
    for (const Loops& part : parts_)
    {
      for (const Edge& edge : part.corners)
      {
        section_.corners.push_back(numberOf(edge));
      }
      for (const std::size_t size : part.size)
      {
        section_.firstCorner.push_back(section_.firstCorner.back() + size);
      }
      section_.cell.insert(section_.cell.end(), part.cell.begin(), part.cell.end());
    }
    section_.given = ends_.given();
    return std::move(section_);
  }

private:
  std::uint32_t numberOf(const Edge& edge)
  {
    const Place place = ends_.place(edge);
    std::uint32_t& number = table_.at(place.from, place.to);
    if (number == EdgeTable::Fresh)
    {
      number = static_cast<std::uint32_t>(section_.places.size());
      section_.places.push_back(place);
      section_.points.push_back(ends_.at(place));
    }
    return number;
  }

  const std::vector<Loops>& parts_;
  const Ends& ends_;
  EdgeTable table_;
  PlaneSection section_;
};

// A face that crosses the plane and is not flat.
class IsWarped
{
public:
  explicit IsWarped(const std::vector<double>& heights)
    : heights_(heights)
  {
  }

  bool operator()(const FaceCorners& corners, std::size_t face) const
  {
    const std::size_t size = corners.size(face);
    std::size_t above = 0;
    for (std::size_t i = 0; i < size; ++i)
    {
      above += heights_[corners.id(face, i)] >= 0 ? 1 : 0;
    }
    return size > 3 && above > 0 && above < size &&
      !isFlat(size, [&](std::size_t i) { return corners.corner(face, i); });
  }

private:
  const std::vector<double>& heights_;
};

}

PlaneSection planeSection(const CellFaces& cells, const double* points,
  const std::vector<double>& heights, const SectionPlane& plane, Execution& execution)
{
  const FaceFans fans = findFans(cells, points, IsWarped(heights), execution);
  const Ends ends(points, heights, fans, plane);
  std::vector<Loops> parts(chunks(cells.cellCount(), CellsAChunk));
  execution.forEach(cells.cellCount(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    Cutter cutter(cells, ends, fans, plane.normal);
    for (std::size_t cell = begin; cell < end; ++cell)
    {
      cutter.cut(cell, parts[begin / CellsAChunk]);
    }
  });
  PlaneSection section = Numbering(parts, ends).number();
  section.fans = fans.faces;
  return section;
}

PointSums sumsOf(
  const PlaneSection& section, const CellFaces& cells, const double* points, Execution& execution)
{
  const FaceCorners corners(cells, points);
  return pointSums(section.places.size(), execution, [&] {
    return [&](std::size_t i, std::vector<Term>& terms) {
      terms.clear();
      const auto add = [&](std::uint32_t end, double weight) {
        if (end >= section.given)
        {
          addFace(corners, section.fans[end - section.given], weight, terms);
        }
        else if (weight != 0)
        {
          terms.push_back({ end, weight });
        }
      };
      const PlaneSection::Place& place = section.places[i];
      add(place.from, 1 - place.part);
      add(place.to, place.part);
      merge(terms);
    };
  });
}

}
