// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/TrianglePairs.h"

#include "Base/Rings.h"
#include "Repair/TrianglePlane.h"
#include "Repair/TriangleTree.h"

#include <algorithm>
#include <atomic>
#include <numeric>

namespace cartesian
{

namespace
{

constexpr std::size_t TestsAChunk = 1 << 16;

// Of each triangle at first, which few exceed.
constexpr std::size_t FirstTests = 64;

// In all, or FirstTests of each triangle where that is more.
constexpr std::size_t MostTests = 10000000;

using CornerSides = std::array<int, 3>; // of a triangle's corners relative to a plane

// The orientation of the triangle abc projected along `axis`.
int turnAlong(const Point& a, const Point& b, const Point& c, int axis)
{
  return sign(turn(flatten(a, axis), flatten(b, axis), flatten(c, axis)));
}

// Whether an edge of `a` separates it from `b`; the two are coplanar.
bool separates(const Corners& a, const Corners& b, int axis)
{
  for (int i = 0; i < 3; ++i)
  {
    const Point& p = a[i];
    const Point& q = following(a, i);
    const int inner = turnAlong(p, q, preceding(a, i), axis);
    if (turnAlong(p, q, b[0], axis) * inner <= 0 && turnAlong(p, q, b[1], axis) * inner <= 0 &&
      turnAlong(p, q, b[2], axis) * inner <= 0)
    {
      return true;
    }
  }
  return false;
}

bool overlap(const Corners& a, const Corners& b)
{
  const std::array<Wide, 3> normal = exactNormal(a);
  int axis = 0;
  while (normal[axis] == 0)
  {
    ++axis;
  }
  return !separates(a, b, axis) && !separates(b, a, axis);
}

// Whether the corners of one are nearly in the plane of the other, and they overlap as seen along an axis.
bool overlapNearly(const Corners& a, const Corners& b, double distance)
{
  const auto isIn = [&](const Corners& t, const TrianglePlane& plane) {
    return plane.distanceTo(t[0]) <= distance && plane.distanceTo(t[1]) <= distance &&
      plane.distanceTo(t[2]) <= distance;
  };
  if (!isIn(a, TrianglePlane(b)) && !isIn(b, TrianglePlane(a)))
  {
    return false;
  }
  const int axis = axisAcross(a);
  return !separates(a, b, axis) && !separates(b, a, axis);
}

// Whether a corner lies on one side of the plane and the others do not.
bool isAlone(const CornerSides& sides, std::size_t i)
{
  return sides[i] != 0 && following(sides, i) != sides[i] && preceding(sides, i) != sides[i];
}

// Whether a triangle shares more than a point with the plane, but is not contained in it.
bool meetsPlane(const CornerSides& sides)
{
  return isAlone(sides, 0) || isAlone(sides, 1) || isAlone(sides, 2);
}

// Rotates a triangle so that its first corner lies alone on one side of the other's plane, and
// orients the other so that its normal points to that side.
void putAloneAbove(Corners& t, const CornerSides& sides, Corners& other, CornerSides& sidesOfOther)
{
  std::size_t i = 0;
  while (!isAlone(sides, i))
  {
    ++i;
  }
  t = { t[i], following(t, i), preceding(t, i) };
  if (sides[i] < 0)
  {
    std::swap(other[1], other[2]);
    std::swap(sidesOfOther[1], sidesOfOther[2]);
  }
}

// Whether two triangles cross, each of which meets the other's plane.
bool cross(Corners a, Corners b, CornerSides ofA, CornerSides ofB)
{
  // The line common to both planes meets each triangle in a segment from its edge 0-1 to its edge
  // 0-2.
  putAloneAbove(a, ofA, b, ofB);
  putAloneAbove(b, ofB, a, ofA);
  return orientation(a[0], a[1], b[0], b[1]) < 0 && orientation(a[0], a[2], b[2], b[0]) < 0;
}

using Vertices = std::array<std::uint32_t, 3>;

bool has(const Vertices& triangle, std::uint32_t v)
{
  return v == triangle[0] || v == triangle[1] || v == triangle[2];
}

// On which sides of a plane the corners of `a` lie; corners shared with the plane's own triangle
// lie on it.
CornerSides sidesOf(
  const Corners& a, const Vertices& vertices, const TrianglePlane& plane, const Vertices& own)
{
  CornerSides sides{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    sides[i] = has(own, vertices[i]) ? 0 : plane.sideOf(a[i]);
  }
  return sides;
}

// The two points where a triangle's edges pass through another's plane.
std::vector<Vector> meetPlane(const Corners& t, const Corners& other)
{
  const TrianglePlane plane(other);
  std::array<double, 3> height;
  for (std::size_t i = 0; i < 3; ++i)
  {
    height[i] = static_cast<double>(plane.exactHeight(t[i]));
  }
  std::vector<Vector> places;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t j = (i + 1) % 3;
    if (height[i] == 0)
    {
      places.push_back(toVector(t[i]));
    }
    if (height[i] * height[j] < 0)
    {
      const double part = height[i] / (height[i] - height[j]);
      Vector p = toVector(t[i]);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        p[axis] += part * (double(t[j][axis]) - p[axis]);
      }
      places.push_back(p);
    }
  }
  return places;
}

Contact contactOf(
  const Surface& surface, const NearlyFlat* nearly, std::uint32_t a, std::uint32_t b)
{
  if (nearly && !nearly->isNew.empty() && nearly->isNew[a] == 0 && nearly->isNew[b] == 0)
  {
    return Contact::Apart;
  }
  const Contact contact = contactOf(surface, a, b);
  return nearly && contact != Contact::Overlap && nearly->body[a] != nearly->body[b] &&
      overlapNearly(surface.corners(a), surface.corners(b), nearly->distance)
    ? Contact::Overlap
    : contact;
}

// Counts pairs until there are enough. Whether there are, in the end, does not depend on threads.
class PairCount
{
public:
  PairCount(const Surface& surface, const NearlyFlat* nearly)
    : surface_(surface)
    , enough_(nearly ? nearly->enough : std::numeric_limits<std::size_t>::max())
  {
  }

  bool isEnough() const { return count_ >= enough_; }

  // Those from `first` on, each of which is added once.
  void add(const std::vector<TrianglePair>& pairs, std::size_t first)
  {
    count_ +=
      static_cast<std::size_t>(std::count_if(pairs.begin() + static_cast<std::ptrdiff_t>(first),
        pairs.end(), [&](const TrianglePair& pair) { return !haveSameCorners(surface_, pair); }));
  }

private:
  const Surface& surface_;
  std::size_t enough_;
  std::atomic<std::size_t> count_{ 0 };
};

struct PairSearch
{
  std::vector<TrianglePair> pairs;
  std::vector<std::size_t> unfinished; // places of triangles with more neighbours
  std::size_t tests = 0;

  void add(const PairSearch& other)
  {
    pairs.insert(pairs.end(), other.pairs.begin(), other.pairs.end());
    unfinished.insert(unfinished.end(), other.unfinished.begin(), other.unfinished.end());
    tests += other.tests;
  }
};

// Which neighbours of a triangle are compared with it, in the order in which the tree has them.
struct Neighbours
{
  std::size_t from;
  std::size_t to;
};

// Compares the triangles at some places of the tree with some of their neighbours each.
PairSearch search(const Surface& surface, const NearlyFlat* nearly, const TriangleTree& tree,
  const std::vector<std::size_t>& places, const Neighbours& which, PairCount& count,
  Execution& execution)
{
  const std::size_t grain = std::max<std::size_t>(1, TestsAChunk / which.to);
  std::vector<PairSearch> parts(chunks(places.size(), grain));
  execution.forEach(places.size(), grain, [&](std::size_t begin, std::size_t end) {
    PairSearch& part = parts[begin / grain];
    for (std::size_t i = begin; i < end && !count.isEnough(); ++i)
    {
      const std::uint32_t t = tree.triangle(places[i]);
      const std::size_t first = part.pairs.size();
      std::size_t seen = 0;
      bool finished = true;
      tree.forEachLarger(places[i], [&](std::uint32_t other) {
        if (seen == which.to)
        {
          finished = false;
          return false;
        }
        ++seen;
        const Contact contact =
          seen > which.from ? contactOf(surface, nearly, t, other) : Contact::Apart;
        if (contact != Contact::Apart)
        {
          part.pairs.push_back({ std::min(t, other), std::max(t, other), contact });
        }
        return true;
      });
      part.tests += seen;
      count.add(part.pairs, first);
      if (!finished)
      {
        part.unfinished.push_back(places[i]);
      }
    }
  });
  PairSearch all;
  for (const PairSearch& part : parts)
  {
    all.add(part);
  }
  return all;
}

TrianglePairs findAll(
  const Surface& surface, const NearlyFlat* nearly, const TriangleTree& tree, Execution& execution)
{
  std::vector<std::size_t> places(tree.size());
  std::iota(places.begin(), places.end(), 0);
  execution.nextLoop(0.7);
  PairCount count(surface, nearly);
  PairSearch found = search(surface, nearly, tree, places, { 0, FirstTests }, count, execution);
  if (!found.unfinished.empty() && !count.isEnough())
  {
    // Around the pole of a sphere all triangles are neighbours: the tests that others need not are theirs.
    const std::size_t left = std::max(MostTests, FirstTests * tree.size()) - found.tests;
    places = std::move(found.unfinished);
    found.unfinished.clear();
    execution.nextLoop(0.7);
    const Neighbours others{ FirstTests, std::max(FirstTests, left / places.size()) };
    found.add(search(surface, nearly, tree, places, others, count, execution));
  }
  std::sort(found.pairs.begin(), found.pairs.end());
  TrianglePairs all{ std::move(found.pairs), {} };
  for (const std::size_t place : found.unfinished)
  {
    all.givenUp.push_back(tree.triangle(place));
  }
  std::sort(all.givenUp.begin(), all.givenUp.end());
  return all;
}

// Those of which one at least is new.
TrianglePairs findNew(const Surface& surface, const NearlyFlat& nearly, Execution& execution)
{
  const TriangleTree tree(surface, execution);
  std::vector<std::uint32_t> triangles;
  for (std::size_t place = 0; place < tree.size(); ++place)
  {
    if (nearly.isNew[tree.triangle(place)] != 0)
    {
      triangles.push_back(tree.triangle(place));
    }
  }
  constexpr std::size_t grain = TestsAChunk / FirstTests;
  std::vector<std::vector<TrianglePair>> parts(chunks(triangles.size(), grain));
  PairCount count(surface, &nearly);
  execution.nextLoop(0.7);
  execution.forEach(triangles.size(), grain, [&](std::size_t begin, std::size_t end) {
    std::vector<TrianglePair>& pairs = parts[begin / grain];
    for (std::size_t i = begin; i < end && !count.isEnough(); ++i)
    {
      const std::size_t first = pairs.size();
      const std::uint32_t t = triangles[i];
      const Corners c = surface.corners(t);
      Vector low = toVector(c[0]);
      Vector high = low;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        low[axis] = std::min({ c[0][axis], c[1][axis], c[2][axis] }) - nearly.distance;
        high[axis] = std::max({ c[0][axis], c[1][axis], c[2][axis] }) + nearly.distance;
      }
      tree.forEachWithin(low, high, [&](std::uint32_t other) {
        if (other != t && (other > t || nearly.isNew[other] == 0))
        {
          const Contact contact = contactOf(surface, &nearly, t, other);
          if (contact != Contact::Apart)
          {
            pairs.push_back({ std::min(t, other), std::max(t, other), contact });
          }
        }
      });
      count.add(pairs, first);
    }
  });
  TrianglePairs all;
  for (const std::vector<TrianglePair>& part : parts)
  {
    all.pairs.insert(all.pairs.end(), part.begin(), part.end());
  }
  std::sort(all.pairs.begin(), all.pairs.end());
  return all;
}

}

Contact contactOf(const Surface& surface, std::uint32_t a, std::uint32_t b)
{
  const Vertices& va = surface.triangles[a];
  const Vertices& vb = surface.triangles[b];
  const Corners ca = surface.corners(a);
  const Corners cb = surface.corners(b);
  const CornerSides ofA = sidesOf(ca, va, TrianglePlane(cb), vb);
  if (ofA == CornerSides{ 0, 0, 0 })
  {
    return overlap(ca, cb) ? Contact::Overlap : Contact::Apart;
  }
  const int common = has(vb, va[0]) + has(vb, va[1]) + has(vb, va[2]);
  if (common > 1 || !meetsPlane(ofA))
  {
    return Contact::Apart;
  }
  const CornerSides ofB = sidesOf(cb, vb, TrianglePlane(ca), va);
  return meetsPlane(ofB) && cross(ca, cb, ofA, ofB) ? Contact::Crossing : Contact::Apart;
}

bool haveSameCorners(const Surface& surface, const TrianglePair& pair)
{
  const Vertices& s = surface.triangles[pair.first];
  const Vertices& t = surface.triangles[pair.second];
  return has(s, t[0]) && has(s, t[1]) && has(s, t[2]);
}

std::array<Vector, 2> sharedSegment(const Corners& a, const Corners& b)
{
  std::vector<Vector> places = meetPlane(a, b);
  for (const Vector& p : meetPlane(b, a))
  {
    places.push_back(p);
  }
  // All four lie on one line; the inner two are shared.
  const Vector along =
    cross(cross(minus(a[1], a[0]), minus(a[2], a[0])), cross(minus(b[1], b[0]), minus(b[2], b[0])));
  std::sort(places.begin(), places.end(),
    [&](const Vector& p, const Vector& q) { return dot(p, along) < dot(q, along); });
  return { places[places.size() / 2 - 1], places[places.size() / 2] };
}

TrianglePairs findPairs(const Surface& surface, Execution& execution)
{
  return findPairs(surface, TriangleTree(surface, execution), execution);
}

TrianglePairs findPairs(const Surface& surface, const TriangleTree& tree, Execution& execution)
{
  return findAll(surface, nullptr, tree, execution);
}

TrianglePairs findPairs(const Surface& surface, const NearlyFlat& nearly, Execution& execution)
{
  // To look at all triangles, each at larger ones only, is faster where many are new.
  constexpr std::size_t many = 8; // one in so many
  const auto news =
    static_cast<std::size_t>(std::count(nearly.isNew.begin(), nearly.isNew.end(), 1));
  return many * news > nearly.isNew.size() || nearly.isNew.empty()
    ? findAll(surface, &nearly, TriangleTree(surface, execution), execution)
    : findNew(surface, nearly, execution);
}

}
