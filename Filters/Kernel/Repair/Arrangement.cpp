// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/Arrangement.h"

#include "Base/DisjointSets.h"
#include "Base/Rings.h"
#include "Repair/TriangleDivision.h"
#include "Repair/TrianglePairs.h"
#include "Repair/TrianglePlane.h"
#include "Surface/SurfaceEdges.h"

#include <algorithm>
#include <map>
#include <set>

namespace cartesian
{

namespace
{

// Where three triangles meet in a point, one round puts edges where the next has to look. More than a few are needed
// only where rounding keeps bending nearly parallel triangles.
constexpr int MostRounds = 16;

// Rounds end where they leave as much to do as there was, beyond a few.
constexpr std::size_t FewPairs = 100;

// Only slivers with rims of thousands of edges in one plane have more pieces: the search for pairs among these would take
// minutes. Grilles have many by their triangles: one of 40 by 40 bars 100 times as many.
constexpr std::size_t PiecesByTriangle = 6;
constexpr std::size_t FewPieces = 100000;

using Ends = std::array<std::uint32_t, 2>; // of an edge, the lower first
using Triple = std::array<std::uint32_t, 3>;

Ends endsOf(std::uint32_t p, std::uint32_t q)
{
  return { std::min(p, q), std::max(p, q) };
}

bool has(const Triple& triangle, std::uint32_t v)
{
  return v == triangle[0] || v == triangle[1] || v == triangle[2];
}

// Whether a triangle is one of those given, or a piece: made before pairs were last searched for, or since.
enum class Made : std::uint8_t
{
  Given = 0,
  Before = 1,
  SinceSearch = 2,
};

// The points and edges that divide a triangle.
struct Marks
{
  std::vector<std::uint32_t> points; // inside
  std::vector<Ends> edges;
};

// One round.
class Arranger
{
public:
  Arranger(Surface& surface, const Placing& placing, VertexIndex& index, std::vector<Made>& made,
    std::vector<std::uint32_t>& body)
    : surface_(surface)
    , made_(made)
    , body_(body)
    , placing_(placing)
    , index_(index)
    , hasPoints_(surface.vertices.size())
  {
  }

  // Cuts triangles along each other. False where that makes more pieces than so many, seen as soon as there are as many
  // points on edges: where slivers cross slivers, there would be millions.
  bool cut(const std::vector<TrianglePair>& pairs, std::size_t most)
  {
    for (const TrianglePair& pair : pairs)
    {
      compare(pair);
      if (pointsOnEdges_ > most)
      {
        return false;
      }
    }
    for (const auto& [s, t] : overlapping_)
    {
      markEdges(s, t);
      markEdges(t, s);
    }
    crossSegments();
    for (const Segment& segment : segments_)
    {
      markSegment(segment);
    }
    divide();
    return surface_.triangles.size() <= most;
  }

  // A triangle without an area, or a piece thinner than the reach, runs back along its longest edge: the
  // others there get its third corner, and it goes. Returns how many there were. `withGiven`: also examines the
  // given ones.
  std::size_t fold(bool withGiven)
  {
    const bool isMerged = mergeClose();
    std::vector<std::uint32_t> flat;
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
    {
      if (mayBeFlat(t, withGiven) && isFlat(t))
      {
        flat.push_back(t);
      }
    }
    std::set<Ends> taken; // edges of those that go
    for (const std::uint32_t t : flat)
    {
      Triple& c = surface_.triangles[t];
      for (int i = 0; i < 2 && !isLongest(c[0], c[1], c[2]); ++i)
      {
        std::rotate(c.begin(), c.begin() + 1, c.end());
      }
      if (isTouched(t) || taken.count(endsOf(c[0], c[1])) != 0)
      {
        continue; // by another of them: the next time
      }
      for (std::size_t i = 0; i < 3; ++i)
      {
        taken.insert(endsOf(c[i], following(c, i)));
      }
      putOnEdge(endsOf(c[0], c[1]), c[2]);
      c[2] = c[1];
    }
    if (isMerged || !flat.empty())
    {
      divide();
    }
    return flat.size();
  }

private:
  // Whether there was anything.
  bool mergeClose()
  {
    bool any = false;
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
    {
      const Triple& c = surface_.triangles[t];
      for (std::size_t i = 0; i < 3 && made_[t] != Made::Given; ++i)
      {
        any = index_.merge(c[i], following(c, i)) || any;
      }
    }
    for (std::uint32_t t = 0; t < surface_.triangles.size() && any; ++t)
    {
      for (std::uint32_t& v : surface_.triangles[t])
      {
        const std::uint32_t now = index_.vertexFor(v);
        made_[t] = now != v ? Made::SinceSearch : made_[t];
        v = now;
      }
    }
    return any;
  }

  // A vertex of what two triangles share, where it is on one of them.
  struct Place
  {
    int edge = -1;         // from this corner to the next
    bool isInside = false; // neither: at a corner
  };

  // What two triangles share that cross.
  struct Segment
  {
    Ends of;                           // triangles
    Ends ends;                         // vertices
    std::vector<std::uint32_t> points; // vertices: the ends, and others on it
  };

  struct PointsOnEdge
  {
    std::vector<std::uint32_t> points;
    bool areSorted = false; // from the lower end
  };

  void compare(const TrianglePair& pair)
  {
    shared_.clear();
    if (pair.contact == Contact::Overlap)
    {
      meetFlat(pair.first, pair.second);
      overlapping_.push_back({ pair.first, pair.second });
      return;
    }
    meet(pair.first, pair.second);
    meet(pair.second, pair.first);
    if (shared_.size() > 1)
    {
      sortAlong(shared_);
      for (const std::uint32_t t : { pair.first, pair.second })
      {
        segmentsOf_[t].push_back(static_cast<std::uint32_t>(segments_.size()));
      }
      segments_.push_back(
        { { pair.first, pair.second }, { shared_.front(), shared_.back() }, shared_ });
    }
  }

  // Where the corners and edges of `s` meet `t`.
  void meet(std::uint32_t s, std::uint32_t t)
  {
    const Corners cs = surface_.corners(s);
    const Corners ct = surface_.corners(t);
    const TrianglePlane plane(ct);
    const Triple& vs = surface_.triangles[s];
    std::array<int, 3> side{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      const bool isCommon = has(surface_.triangles[t], vs[i]);
      side[i] = isCommon ? 0 : plane.sideOf(cs[i]);
      if (isCommon)
      {
        share(vs[i]);
      }
      else if (side[i] == 0)
      {
        meetInPlane(vs[i], t);
      }
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t j = (i + 1) % 3;
      if (side[i] * side[j] < 0)
      {
        meetEdge(endsOf(vs[i], vs[j]), plane, t);
      }
      else if (side[i] == 0 && side[j] == 0)
      {
        meetEdges(endsOf(vs[i], vs[j]), t, axisAcross(ct));
      }
    }
  }

  // Two coplanar, or nearly coplanar, triangles.
  void meetFlat(std::uint32_t s, std::uint32_t t)
  {
    const int axis = axisAcross(surface_.corners(s));
    for (const auto& [from, to] : { Ends{ s, t }, Ends{ t, s } })
    {
      for (const std::uint32_t v : surface_.triangles[from])
      {
        if (isWithin(v, to))
        {
          put(v, to, Place{ -1, true });
        }
      }
    }
    const Triple& c = surface_.triangles[s];
    for (std::size_t i = 0; i < 3; ++i)
    {
      meetEdges(endsOf(c[i], following(c, i)), t, axis);
    }
  }

  // A vertex in the plane of `t`.
  void meetInPlane(std::uint32_t v, std::uint32_t t)
  {
    Place place;
    place.isInside = true;
    const int axis = axisAcross(surface_.corners(t));
    const Triple& c = surface_.triangles[t];
    const int way = turnOf(c[0], c[1], c[2], axis);
    for (int i = 0; i < 3; ++i)
    {
      const int turn = way * turnOf(c[i], following(c, i), v, axis);
      if (turn < 0)
      {
        return;
      }
      place = turn == 0 ? Place{ i, false } : place;
    }
    share(v);
    put(v, t, place);
  }

  // An edge that passes through the plane of `t`.
  void meetEdge(const Ends& e, const TrianglePlane& plane, std::uint32_t t)
  {
    const Triple& c = surface_.triangles[t];
    const Point& p = surface_.vertices[e[0]];
    const Point& q = surface_.vertices[e[1]];
    int sum = 0;
    int zeros = 0;
    std::array<int, 3> turn{};
    for (int i = 0; i < 3; ++i)
    {
      turn[i] = orientation(p, q, surface_.vertices[c[i]], surface_.vertices[following(c, i)]);
      sum += turn[i];
      zeros += turn[i] == 0 ? 1 : 0;
    }
    if (std::abs(sum) + zeros < 3 || zeros == 3)
    {
      return;
    }
    if (zeros == 2)
    {
      const int corner = turn[0] != 0 ? 2 : (turn[1] != 0 ? 0 : 1);
      share(c[corner]);
      putOnEdge(e, c[corner]);
      return;
    }
    const std::uint32_t v = vertexOn(e, plane.exactHeight(p), plane.exactHeight(q));
    share(v);
    putOnEdge(e, v);
    put(v, t,
      zeros == 0 ? Place{ -1, true } : Place{ turn[0] == 0 ? 0 : (turn[1] == 0 ? 1 : 2), false });
  }

  // An edge in the plane of `t`.
  void meetEdges(const Ends& e, std::uint32_t t, int axis)
  {
    const Triple& c = surface_.triangles[t];
    for (int i = 0; i < 3; ++i)
    {
      const Ends f = endsOf(c[i], following(c, i));
      if (areCrossing(e, f, axis))
      {
        // The same vertex, whichever comes first.
        const Ends& a = std::min(e, f);
        const Ends& b = std::max(e, f);
        const std::uint32_t v =
          vertexOn(a, areaOf(b[0], b[1], a[0], axis), areaOf(b[0], b[1], a[1], axis));
        share(v);
        putOnEdge(e, v);
        putOnEdge(f, v);
      }
    }
  }

  Wide areaOf(std::uint32_t p, std::uint32_t q, std::uint32_t r, int axis) const
  {
    const auto at = [&](std::uint32_t v) { return flatten(surface_.vertices[v], axis); };
    return turn(at(p), at(q), at(r));
  }
  int turnOf(std::uint32_t p, std::uint32_t q, std::uint32_t r, int axis) const
  {
    return sign(areaOf(p, q, r, axis));
  }

  // The vertex between the ends of an edge, whose heights have different signs, made if need be.
  std::uint32_t vertexOn(const Ends& e, Wide from, Wide to)
  {
    const double part = static_cast<double>(from) / static_cast<double>(from - to);
    const Point p = surface_.vertices[e[0]];
    const Point q = surface_.vertices[e[1]];
    Point place;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double way = part * (static_cast<double>(q[axis]) - static_cast<double>(p[axis]));
      place[axis] =
        static_cast<Level>(static_cast<std::int64_t>(p[axis]) + 2 * std::llround(way / 2));
    }
    return index_.at(place);
  }

  double distance(std::uint32_t v, const Ends& edge) const
  {
    const Vector along = minus(surface_.vertices[edge[1]], surface_.vertices[edge[0]]);
    return norm(cross(along, minus(surface_.vertices[v], surface_.vertices[edge[0]]))) /
      norm(along);
  }

  void share(std::uint32_t v)
  {
    if (std::find(shared_.begin(), shared_.end(), v) == shared_.end())
    {
      shared_.push_back(v);
    }
  }

  void putOnEdge(const Ends& edge, std::uint32_t v)
  {
    if (v == edge[0] || v == edge[1])
    {
      return;
    }
    PointsOnEdge& known = onEdge_[edge];
    if (std::find(known.points.begin(), known.points.end(), v) == known.points.end())
    {
      known.points.push_back(v);
      known.areSorted = false;
      ++pointsOnEdges_;
      hasPoints_[edge[0]] = 1;
    }
  }

  void put(std::uint32_t v, std::uint32_t t, Place place)
  {
    const Triple& c = surface_.triangles[t];
    if (has(c, v))
    {
      return;
    }
    if (place.isInside)
    {
      // Rounded, it may be beyond an edge.
      const int axis = axisAcross(surface_.corners(t));
      const int way = turnOf(c[0], c[1], c[2], axis);
      for (int i = 0; i < 3 && place.isInside; ++i)
      {
        const Ends edge = endsOf(c[i], following(c, i));
        place =
          way * turnOf(c[i], following(c, i), v, axis) <= 0 || distance(v, edge) < placing_.reach
          ? Place{ i, false }
          : place;
      }
    }
    if (place.isInside)
    {
      marks_[t].points.push_back(v);
    }
    else if (place.edge >= 0)
    {
      putOnEdge(endsOf(c[place.edge], c[(place.edge + 1) % 3]), v);
    }
  }

  void sortAlong(std::vector<std::uint32_t>& points) const
  {
    std::sort(points.begin(), points.end(), [&](std::uint32_t a, std::uint32_t b) {
      return surface_.vertices[a] < surface_.vertices[b];
    });
  }

  void markSegment(const Segment& segment)
  {
    std::vector<std::uint32_t> points = segment.points;
    const Vector from = toVector(surface_.vertices[segment.ends[0]]);
    const Vector way = minus(toVector(surface_.vertices[segment.ends[1]]), from);
    const auto along = [&](std::uint32_t v) {
      return dot(minus(toVector(surface_.vertices[v]), from), way);
    };
    std::sort(points.begin(), points.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::make_pair(along(a), a) < std::make_pair(along(b), b);
    });
    for (const std::uint32_t t : segment.of)
    {
      for (std::size_t i = 1; i < points.size(); ++i)
      {
        marks_[t].edges.push_back(endsOf(points[i - 1], points[i]));
      }
    }
  }

  // Where three triangles meet in a point, which is found from their planes: it lies on all three segments.
  void crossSegments()
  {
    std::set<Triple> known;
    for (const auto& [t, segments] : segmentsOf_)
    {
      const int axis = axisAcross(surface_.corners(t));
      for (std::size_t i = 0; i < segments.size(); ++i)
      {
        for (std::size_t j = i + 1; j < segments.size(); ++j)
        {
          const Segment& a = segments_[segments[i]];
          const Segment& b = segments_[segments[j]];
          if (areCrossing(a.ends, b.ends, axis))
          {
            Triple three{ t, a.of[a.of[0] == t ? 1 : 0], b.of[b.of[0] == t ? 1 : 0] };
            std::sort(three.begin(), three.end());
            if (known.insert(three).second)
            {
              meetInPoint(three);
            }
          }
        }
      }
    }
  }

  bool areCrossing(const Ends& e, const Ends& f, int axis) const
  {
    return turnOf(e[0], e[1], f[0], axis) * turnOf(e[0], e[1], f[1], axis) < 0 &&
      turnOf(f[0], f[1], e[0], axis) * turnOf(f[0], f[1], e[1], axis) < 0;
  }

  void meetInPoint(const Triple& three)
  {
    const Point base = surface_.vertices[surface_.triangles[three[0]][0]];
    std::array<Vector, 3> normal;
    Vector height;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Corners c = surface_.corners(three[i]);
      normal[i] = unit(cross(minus(c[1], c[0]), minus(c[2], c[0])));
      height[i] = dot(normal[i], minus(c[0], base));
    }
    const double whole = dot(normal[0], cross(normal[1], normal[2]));
    Vector place{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      place =
        plus(place, scaled(cross(following(normal, i), preceding(normal, i)), height[i] / whole));
    }
    std::vector<Segment*> segments;
    for (const std::uint32_t t : three)
    {
      for (const std::uint32_t s : segmentsOf_.at(t))
      {
        Segment& segment = segments_[s];
        if (segment.of[0] == t &&
          std::find(three.begin(), three.end(), segment.of[1]) != three.end())
        {
          segments.push_back(&segment);
        }
      }
    }
    if (!std::all_of(segments.begin(), segments.end(), [&](const Segment* segment) {
          return isBeside(plus(place, toVector(base)), segment->ends);
        }))
    {
      return; // nearly parallel
    }
    Point point;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      point[axis] = static_cast<Level>(
        static_cast<std::int64_t>(base[axis]) + 2 * std::llround(place[axis] / 2));
    }
    const std::uint32_t v = index_.at(point);
    for (const std::uint32_t t : three)
    {
      put(v, t, Place{ -1, true });
    }
    for (Segment* segment : segments)
    {
      if (std::find(segment->points.begin(), segment->points.end(), v) == segment->points.end())
      {
        segment->points.push_back(v);
      }
    }
  }

  // Whether a place is in the box around an edge, or nearly.
  bool isBeside(const Vector& place, const Ends& edge) const
  {
    bool is = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto [low, high] =
        std::minmax(surface_.vertices[edge[0]][axis], surface_.vertices[edge[1]][axis]);
      is = is && place[axis] >= low - placing_.reach && place[axis] <= high + placing_.reach;
    }
    return is;
  }

  // The edges of `s`, in the plane of `t`, as far as they run within that: through what is on them.
  void markEdges(std::uint32_t s, std::uint32_t t)
  {
    const Triple& c = surface_.triangles[s];
    for (std::size_t i = 0; i < 3; ++i)
    {
      std::vector<std::uint32_t> points = pointsOn(c[i], following(c, i));
      points.insert(points.begin(), c[i]);
      points.push_back(following(c, i));
      bool wasWithin = false;
      for (std::size_t k = 0; k < points.size(); ++k)
      {
        const bool is = isWithin(points[k], t);
        if (is && wasWithin)
        {
          marks_[t].edges.push_back(endsOf(points[k - 1], points[k]));
        }
        if (is)
        {
          put(points[k], t, Place{ -1, true });
        }
        wasWithin = is;
      }
    }
  }

  // Whether a vertex is in a triangle or at its border, within the reach.
  bool isWithin(std::uint32_t v, std::uint32_t t) const
  {
    const Triple& c = surface_.triangles[t];
    const Corners corners = surface_.corners(t);
    bool is = true;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double level = surface_.vertices[v][i];
      const auto [low, high] = std::minmax({ corners[0][i], corners[1][i], corners[2][i] });
      is = is && level > low - placing_.reach && level < high + placing_.reach;
    }
    if (!is)
    {
      return false;
    }
    const int axis = axisAcross(corners);
    const int way = turnOf(c[0], c[1], c[2], axis);
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::uint32_t p = c[i];
      const std::uint32_t q = following(c, i);
      is = is && (way * turnOf(p, q, v, axis) >= 0 || distance(v, endsOf(p, q)) < placing_.reach);
    }
    return is;
  }

  // Points of an edge, from `from` on.
  std::vector<std::uint32_t> pointsOn(std::uint32_t from, std::uint32_t to)
  {
    const Ends edge = endsOf(from, to);
    if (edge[0] >= hasPoints_.size() || hasPoints_[edge[0]] == 0)
    {
      return {};
    }
    const auto found = onEdge_.find(edge);
    if (found == onEdge_.end())
    {
      return {};
    }
    PointsOnEdge& known = found->second;
    if (!known.areSorted)
    {
      const Vector way = minus(surface_.vertices[edge[1]], surface_.vertices[edge[0]]);
      const auto place = [&](std::uint32_t v) {
        return std::make_pair(dot(minus(surface_.vertices[v], surface_.vertices[edge[0]]), way), v);
      };
      std::sort(known.points.begin(), known.points.end(),
        [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
      known.areSorted = true;
    }
    std::vector<std::uint32_t> points = known.points;
    if (from != edge[0])
    {
      std::reverse(points.begin(), points.end());
    }
    return points;
  }

  bool isTouched(std::uint32_t t) const
  {
    const Triple& c = surface_.triangles[t];
    bool any = marks_.count(t) != 0;
    for (std::size_t i = 0; i < 3 && !any; ++i)
    {
      const Ends edge = endsOf(c[i], following(c, i));
      any = hasPoints_[edge[0]] != 0 && onEdge_.count(edge) != 0;
    }
    return any;
  }

  bool isLongest(std::uint32_t p, std::uint32_t q, std::uint32_t other) const
  {
    return lengthOf(p, q) >= lengthOf(q, other) && lengthOf(p, q) >= lengthOf(other, p);
  }

  double lengthOf(std::uint32_t p, std::uint32_t q) const
  {
    return norm(minus(surface_.vertices[p], surface_.vertices[q]));
  }

  bool mayBeFlat(std::uint32_t t, bool withGiven) const
  {
    return !namesAVertexTwice(surface_.triangles[t]) && made_[t] != Made::Before &&
      (withGiven || made_[t] != Made::Given);
  }

  bool isFlat(std::uint32_t t) const
  {
    const Corners c = surface_.corners(t);
    if (axisAcross(c) < 0 || made_.empty() || made_[t] == Made::Given)
    {
      return axisAcross(c) < 0;
    }
    const double longest =
      std::max({ norm(minus(c[0], c[1])), norm(minus(c[1], c[2])), norm(minus(c[2], c[0])) });
    return norm(cross(minus(c[1], c[0]), minus(c[2], c[0]))) < placing_.reach * longest;
  }

  void divide()
  {
    Surface divided;
    std::vector<Made> madeNow;
    std::vector<std::uint32_t> body;
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
    {
      if (!namesAVertexTwice(surface_.triangles[t]))
      {
        const Made made =
          isTouched(t) ? Made::SinceSearch : (made_.empty() ? Made::Given : made_[t]);
        for (const Triple& part : partsOf(t))
        {
          if (!namesAVertexTwice(part))
          {
            divided.triangles.push_back(part);
            divided.boundary.push_back(surface_.boundary[t]);
            divided.region.push_back(surface_.region[t]);
            madeNow.push_back(made);
            body.push_back(body_[t]);
          }
        }
      }
      if (t < surface_.given.size())
      {
        divided.given.resize(divided.triangles.size(), surface_.given[t]);
      }
    }
    surface_.triangles.swap(divided.triangles);
    surface_.boundary.swap(divided.boundary);
    surface_.given.swap(divided.given);
    surface_.region.swap(divided.region);
    made_.swap(madeNow);
    body_.swap(body);
  }

  std::vector<Triple> partsOf(std::uint32_t t)
  {
    const Triple& c = surface_.triangles[t];
    if (!isTouched(t))
    {
      return { c };
    }
    TriangleDivision division(surface_.vertices, c, std::max(0, axisAcross(surface_.corners(t))),
      { placing_.reach, placing_.keepsEdges });
    for (std::size_t i = 0; i < 3; ++i)
    {
      division.divideEdge(i, pointsOn(c[i], following(c, i)));
    }
    if (const auto marks = marks_.find(t); marks != marks_.end())
    {
      for (const std::uint32_t point : marks->second.points)
      {
        division.addPoint(point);
      }
      for (const Ends& edge : marks->second.edges)
      {
        division.addEdge(edge[0], edge[1]);
      }
    }
    return division.finish();
  }

  Surface& surface_;
  std::vector<Made>& made_;          // of triangles; empty: all are given
  std::vector<std::uint32_t>& body_; // of triangles: the connected part that they are from
  const Placing& placing_;
  VertexIndex& index_;
  std::vector<std::uint32_t> shared_;
  std::map<Ends, PointsOnEdge> onEdge_;
  std::size_t pointsOnEdges_ = 0;
  std::vector<std::uint8_t> hasPoints_;  // whether an edge from a vertex, its lower one, has points
  std::map<std::uint32_t, Marks> marks_; // of triangles
  std::vector<Ends> overlapping_;        // pairs of triangles
  std::vector<Segment> segments_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> segmentsOf_; // of triangles
};

// Of triangles with other corners.
std::vector<TrianglePair> differing(const Surface& surface, std::vector<TrianglePair> pairs)
{
  const auto areSame = [&](const TrianglePair& pair) { return haveSameCorners(surface, pair); };
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(), areSame), pairs.end());
  return pairs;
}

// What is connected across edges that one region uses twice.
std::vector<std::uint32_t> bodiesOf(const Surface& surface, Execution& execution)
{
  DisjointSets bodies(surface.triangles.size());
  std::vector<std::uint32_t> uses;
  SurfaceEdges(surface, execution)
    .forEach([&](std::uint32_t, const EdgeUse* begin, const EdgeUse* end) {
      uses.clear();
      for (const EdgeUse* use = begin; use != end; ++use)
      {
        uses.push_back(use->triangle());
      }
      const auto region = [&](std::uint32_t t) { return surface.region[t]; };
      std::sort(uses.begin(), uses.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::make_pair(region(a), a) < std::make_pair(region(b), b);
      });
      for (std::size_t i = 0, next = 0; i < uses.size(); i = next)
      {
        while (next < uses.size() && region(uses[next]) == region(uses[i]))
        {
          ++next;
        }
        if (next == i + 2)
        {
          bodies.unite(uses[i], uses[i + 1]);
        }
      }
    });
  std::vector<std::uint32_t> body(surface.triangles.size());
  for (std::uint32_t t = 0; t < body.size(); ++t)
  {
    body[t] = bodies.find(t);
  }
  return body;
}

}

namespace
{

// Whether the surface is large compared with a distance.
bool isLarge(const Surface& surface, double distance)
{
  constexpr double least = 1 << 13; // times as long
  double longest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto [low, high] = std::minmax_element(surface.vertices.begin(), surface.vertices.end(),
      [&](const Point& p, const Point& q) { return p[axis] < q[axis]; });
    longest = low == high ? longest : std::max(longest, double((*high)[axis]) - (*low)[axis]);
  }
  return longest >= least * distance;
}

// Folding divides others, which may be thin then: it goes on as long as it leaves fewer.
void foldAll(Surface& surface, const Placing& placing, VertexIndex& index, std::vector<Made>& made,
  std::vector<std::uint32_t>& body, bool withGiven)
{
  std::size_t before = surface.triangles.size() + 1;
  for (std::size_t thin = before - 1; thin > 0 && thin < before;)
  {
    before = thin;
    thin = Arranger(surface, placing, index, made, body).fold(withGiven);
    withGiven = false;
  }
}

}

bool isFinelyPlaced(const Surface& surface)
{
  return isLarge(surface, placingOf(surface).snap);
}

bool canBeArranged(const Surface& surface, const Placing& placing)
{
  return isLarge(surface, placing.reach);
}

bool keepsVolume(const Surface& given, const Surface& arranged, const Placing& placing)
{
  const double moved =
    std::max(placing.together, placing.reach) * given.lattice.step() * areaOf(given);
  return std::abs(volumeOf(arranged) - volumeOf(given)) <= moved;
}

bool arrange(Surface& surface, Execution& execution)
{
  return arrange(surface, placingOf(surface), execution);
}

bool arrange(Surface& surface, const Placing& placing, Execution& execution)
{
  const std::size_t most = PiecesByTriangle * surface.triangles.size() + FewPieces;
  VertexIndex index(surface.vertices, placing.reach);
  std::vector<Made> made;
  std::vector<std::uint32_t> body = bodiesOf(surface, execution);
  std::vector<TrianglePair> pairs =
    differing(surface, findPairs(surface, { body, placing.together, {} }, execution).pairs);
  std::size_t before = pairs.size() + 1;
  bool isStuck = false; // the last round changed nothing
  for (int round = 0; round < MostRounds && !pairs.empty() && !isStuck &&
       (pairs.size() < before || pairs.size() < FewPairs);
       ++round)
  {
    before = pairs.size();
    const std::array<std::size_t, 2> sizes{ surface.triangles.size(), surface.vertices.size() };
    if (!Arranger(surface, placing, index, made, body).cut(pairs, most))
    {
      return false;
    }
    foldAll(surface, placing, index, made, body, round == 0);
    std::vector<std::uint8_t> isNew(made.size());
    for (std::size_t t = 0; t < made.size(); ++t)
    {
      isNew[t] = made[t] == Made::SinceSearch ? 1 : 0;
      made[t] = made[t] == Made::Given ? Made::Given : Made::Before;
    }
    // As many as there were, and not few: the rounds end, whichever these are.
    const NearlyFlat pieces{ body, placing.piecesTogether, isNew, std::max(before, FewPairs) };
    pairs = differing(surface, findPairs(surface, pieces, execution).pairs);
    isStuck = pairs.size() == before &&
      sizes == std::array<std::size_t, 2>{ surface.triangles.size(), surface.vertices.size() };
  }
  return true;
}

}
