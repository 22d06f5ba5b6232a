// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/Imprint.h"

#include "Repair/TriangleDivision.h"
#include "Repair/TrianglePairs.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace cartesian
{

namespace
{

// Where three regions meet in one plane, one round puts vertices where the next has to look. More than a few
// are needed only where rounding keeps bending walls that are not parallel to an axis.
constexpr int MostRounds = 8;

using Ends = std::array<std::uint32_t, 2>; // of an edge, the lower first

Ends endsOf(std::uint32_t p, std::uint32_t q)
{
  return { std::min(p, q), std::max(p, q) };
}

// The odd level nearest to level + numerator / denominator.
Level oddLevelAt(Level level, Wide numerator, Wide denominator)
{
  const Wide twice = 2 * denominator;
  const Wide number = static_cast<Wide>(level) * denominator + numerator; // of 1 / denominator
  Wide half = number / twice;
  half -= number % twice < 0 ? 1 : 0;
  return static_cast<Level>(2 * half + 1);
}

// One round of imprinting.
class Imprinter
{
public:
  Imprinter(Surface& surface, Execution& execution)
    : surface_(surface)
    , execution_(execution)
  {
    for (std::uint32_t v = 0; v < surface.vertices.size(); ++v)
    {
      vertexAt_[surface.vertices[v]] = v;
    }
  }

  // Returns false if there is nothing to do.
  bool run()
  {
    for (const TrianglePair& pair : findPairs(surface_, execution_).pairs)
    {
      if (pair.contact == Contact::Overlap &&
        surface_.region[pair.first] != surface_.region[pair.second] &&
        !areSame(pair.first, pair.second))
      {
        compare(pair.first, pair.second);
      }
    }
    if (marks_.empty())
    {
      return false;
    }
    divide();
    return true;
  }

private:
  // What divides a triangle.
  struct Marks
  {
    std::vector<std::uint32_t> points; // inside
    std::vector<Ends> edges;
  };

  bool areSame(std::uint32_t s, std::uint32_t t) const
  {
    auto a = surface_.triangles[s];
    auto b = surface_.triangles[t];
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    return a == b;
  }

  // Along which the triangle's projection is largest.
  int axisOf(std::uint32_t t) const
  {
    const std::array<Wide, 3> normal = exactNormal(surface_.corners(t));
    const auto size = [&](int axis) {
      const Wide x = normal[static_cast<std::size_t>(axis)];
      return x < 0 ? -x : x;
    };
    int best = 0;
    for (const int axis : { 1, 2 })
    {
      best = size(axis) > size(best) ? axis : best;
    }
    return best;
  }

  PlanePoint at(std::uint32_t v) const { return flatten(surface_.vertices[v], axis_); }
  Wide turnOf(std::uint32_t p, std::uint32_t q, std::uint32_t r) const
  {
    return turn(at(p), at(q), at(r));
  }

  // Whether a vertex lies in a triangle or on its border.
  bool isIn(std::uint32_t t, std::uint32_t v) const
  {
    const auto& c = surface_.triangles[t];
    const int way = sign(turnOf(c[0], c[1], c[2]));
    bool in = true;
    for (std::size_t i = 0; i < 3; ++i)
    {
      in = in && way * sign(turnOf(c[i], c[(i + 1) % 3], v)) >= 0;
    }
    return in;
  }

  // Whether a vertex lies on an edge, not at its ends.
  bool isOn(std::uint32_t p, std::uint32_t q, std::uint32_t v) const
  {
    const PlanePoint a = at(p);
    const PlanePoint b = at(q);
    const PlanePoint x = at(v);
    return v != p && v != q && turn(a, b, x) == 0 && std::min(a.a, b.a) <= x.a &&
      x.a <= std::max(a.a, b.a) && std::min(a.b, b.b) <= x.b && x.b <= std::max(a.b, b.b);
  }

  // The vertex where two edges cross, made if need be; none if they do not.
  bool crossing(Ends e, Ends f, std::uint32_t& vertex)
  {
    if (f < e)
    {
      std::swap(e, f); // the same for all triangles at these edges
    }
    const Wide from = turnOf(f[0], f[1], e[0]);
    const Wide to = turnOf(f[0], f[1], e[1]);
    if (sign(from) * sign(to) >= 0 ||
      sign(turnOf(e[0], e[1], f[0])) * sign(turnOf(e[0], e[1], f[1])) >= 0)
    {
      return false;
    }
    const Wide whole = from < 0 ? to - from : from - to;
    const Wide part = from < 0 ? -from : from;
    const Point p = surface_.vertices[e[0]];
    const Point q = surface_.vertices[e[1]];
    Point place;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto way = static_cast<Wide>(q[axis]) - static_cast<Wide>(p[axis]);
      place[axis] = oddLevelAt(p[axis], way * part, whole);
    }
    const auto [known, isNew] =
      vertexAt_.emplace(place, static_cast<std::uint32_t>(surface_.vertices.size()));
    if (isNew)
    {
      surface_.vertices.push_back(place);
    }
    vertex = known->second;
    return true;
  }

  void addOnEdge(const Ends& edge, std::uint32_t vertex)
  {
    std::vector<std::uint32_t>& points = onEdge_[edge];
    if (vertex != edge[0] && vertex != edge[1] &&
      std::find(points.begin(), points.end(), vertex) == points.end())
    {
      points.push_back(vertex);
    }
  }

  // Two triangles that overlap in one plane: marks what each leaves on the other.
  void compare(std::uint32_t s, std::uint32_t t)
  {
    axis_ = axisOf(s);
    std::vector<std::uint32_t> shared; // corners of what both cover
    const auto share = [&](std::uint32_t v) {
      if (std::find(shared.begin(), shared.end(), v) == shared.end())
      {
        shared.push_back(v);
      }
    };
    const auto cornersIn = [&](std::uint32_t from, std::uint32_t in) {
      for (const std::uint32_t v : surface_.triangles[from])
      {
        if (isIn(in, v))
        {
          share(v);
        }
      }
    };
    cornersIn(s, t);
    cornersIn(t, s);
    forEachEdge(s, [&](const Ends& e) {
      forEachEdge(t, [&](const Ends& f) {
        std::uint32_t vertex = 0;
        if (crossing(e, f, vertex))
        {
          share(vertex);
          addOnEdge(e, vertex);
          addOnEdge(f, vertex);
        }
        for (const std::size_t end : { 0, 1 })
        {
          if (isOn(e[0], e[1], f[end]))
          {
            addOnEdge(e, f[end]);
          }
          if (isOn(f[0], f[1], e[end]))
          {
            addOnEdge(f, e[end]);
          }
        }
      });
    });
    if (shared.size() > 2)
    {
      mark(shared, marks_[s]);
      mark(shared, marks_[t]);
    }
  }

  template <class Visitor>
  void forEachEdge(std::uint32_t t, Visitor&& visit) const
  {
    const auto& c = surface_.triangles[t];
    for (std::size_t i = 0; i < 3; ++i)
    {
      visit(endsOf(c[i], c[(i + 1) % 3]));
    }
  }

  // The border of a convex polygon, and edges from its lowest corner to the others.
  void mark(std::vector<std::uint32_t> corners, Marks& marks) const
  {
    const std::uint32_t first =
      *std::min_element(corners.begin(), corners.end(), [&](std::uint32_t a, std::uint32_t b) {
        return surface_.vertices[a] < surface_.vertices[b];
      });
    marks.points.insert(marks.points.end(), corners.begin(), corners.end());
    double x = 0;
    double y = 0;
    for (const std::uint32_t v : corners)
    {
      x += static_cast<double>(at(v).a) / static_cast<double>(corners.size());
      y += static_cast<double>(at(v).b) / static_cast<double>(corners.size());
    }
    const auto angle = [&](std::uint32_t v) {
      return std::atan2(static_cast<double>(at(v).b) - y, static_cast<double>(at(v).a) - x);
    };
    std::sort(corners.begin(), corners.end(),
      [&](std::uint32_t a, std::uint32_t b) { return angle(a) < angle(b); });
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      marks.edges.push_back(endsOf(corners[i], corners[(i + 1) % corners.size()]));
    }
    for (const std::uint32_t v : corners)
    {
      if (v != first)
      {
        marks.edges.push_back(endsOf(first, v));
      }
    }
  }

  // Points of an edge, from `from` on.
  std::vector<std::uint32_t> pointsOn(std::uint32_t from, std::uint32_t to) const
  {
    const auto found = onEdge_.find(endsOf(from, to));
    if (found == onEdge_.end())
    {
      return {};
    }
    std::vector<std::uint32_t> points = found->second;
    const auto along = [&](std::uint32_t v) {
      const Vector way = minus(surface_.vertices[v], surface_.vertices[from]);
      return dot(way, minus(surface_.vertices[to], surface_.vertices[from]));
    };
    std::sort(points.begin(), points.end(),
      [&](std::uint32_t a, std::uint32_t b) { return along(a) < along(b); });
    return points;
  }

  void divide()
  {
    Surface divided;
    const auto add = [&](const std::array<std::uint32_t, 3>& triangle, std::uint32_t like) {
      divided.triangles.push_back(triangle);
      divided.boundary.push_back(surface_.boundary[like]);
      divided.given.push_back(surface_.given[like]);
      divided.region.push_back(surface_.region[like]);
    };
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
    {
      const auto marks = marks_.find(t);
      const auto& c = surface_.triangles[t];
      std::array<std::vector<std::uint32_t>, 3> onEdges;
      bool isDivided = marks != marks_.end();
      for (std::size_t i = 0; i < 3; ++i)
      {
        onEdges[i] = pointsOn(c[i], c[(i + 1) % 3]);
        isDivided = isDivided || !onEdges[i].empty();
      }
      if (!isDivided)
      {
        add(c, t);
        continue;
      }
      TriangleDivision division(surface_.vertices, c, axisOf(t));
      for (std::size_t i = 0; i < 3; ++i)
      {
        division.divideEdge(i, onEdges[i]);
      }
      if (marks != marks_.end())
      {
        divideAt(marks->second, division);
      }
      for (const auto& part : division.triangles())
      {
        add(part, t);
      }
    }
    surface_.triangles.swap(divided.triangles);
    surface_.boundary.swap(divided.boundary);
    surface_.given.swap(divided.given);
    surface_.region.swap(divided.region);
  }

  static void divideAt(const Marks& marks, TriangleDivision& division)
  {
    for (const std::uint32_t point : marks.points)
    {
      division.addPoint(point);
    }
    for (const Ends& edge : marks.edges)
    {
      division.addEdge(edge[0], edge[1]);
    }
  }

  Surface& surface_;
  Execution& execution_;
  int axis_ = 0;
  std::map<Point, std::uint32_t> vertexAt_;
  std::map<Ends, std::vector<std::uint32_t>> onEdge_;
  std::map<std::uint32_t, Marks> marks_; // of triangles
};

}

void imprint(Surface& surface, Execution& execution)
{
  for (int round = 0; round < MostRounds && Imprinter(surface, execution).run(); ++round)
  {
  }
}

}
