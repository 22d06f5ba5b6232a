// SPDX-License-Identifier: BSD-3-Clause
#include "Polyhedra/PolyhedronCut.h"

#include "Base/DisjointSets.h"
#include "Base/EdgeTable.h"
#include "Lattice/StarPolygons.h"
#include "Polyhedra/CellGeometry.h"

#include <algorithm>
#include <iterator>

namespace cartesian
{

namespace
{

using Index = std::uint32_t;
using EdgeKey = std::pair<Index, Index>; // lower node first

constexpr Index NoPoint = ~Index(0);

EdgeKey keyOf(Index from, Index to)
{
  return { std::min(from, to), std::max(from, to) };
}

class Cutter
{
public:
  Cutter(const Polyhedron& cell, const CutPlane& plane, CellCut& cut)
    : cell_(cell)
    , plane_(plane)
    , cut_(cut)
  {
  }

  bool run()
  {
    cut_.points.clear();
    cut_.faces.clear();
    cut_.corners.clear();
    cut_.faces.reserve(2 * cell_.faces());
    cut_.corners.reserve(2 * cell_.corners.size());
    sides_.reserve(2 * cell_.faces());
    findSigns();
    if (!hasBothSides())
    {
      return false;
    }
    snapNodes();
    if (!hasBothSides() || !addPoints())
    {
      return false;
    }
    for (std::size_t f = 0; f < cell_.faces(); ++f)
    {
      if (!divideFace(f))
      {
        return false;
      }
    }
    return closeCut() && allDistinct() && findParts();
  }

private:
  // --- where the plane meets the cell

  void findSigns()
  {
    distance_.resize(cell_.nodes.size());
    for (std::size_t n = 0; n < distance_.size(); ++n)
    {
      distance_[n] = dot(minus(cell_.nodes[n], plane_.at), plane_.normal);
      if (std::abs(distance_[n]) < RoundingLevels)
      {
        distance_[n] = 0;
      }
    }
    for (const Index n : plane_.through)
    {
      distance_[n] = 0;
    }
  }

  int sign(Index node) const { return (distance_[node] > 0) - (distance_[node] < 0); }

  Vector meetingPoint(Index from, Index to) const
  {
    const double t = distance_[from] / (distance_[from] - distance_[to]);
    return plus(cell_.nodes[from], scaled(minus(cell_.nodes[to], cell_.nodes[from]), t));
  }

  // Calls visit(from, to) for the edges of a face.
  template <class Visitor>
  void forEachEdge(std::size_t face, Visitor&& visit) const
  {
    Index from = cell_.corners[cell_.start[face + 1] - 1];
    for (std::size_t i = cell_.start[face]; i < cell_.start[face + 1]; ++i)
    {
      visit(from, cell_.corners[i]);
      from = cell_.corners[i];
    }
  }

  // The paper measures the two edges of the cutting polygon that meet in the end vertex; each runs
  // across a face.
  void snapNodes()
  {
    std::vector<std::pair<EdgeKey, double>> lengths;
    std::vector<Vector> ends;
    for (std::size_t f = 0; f < cell_.faces(); ++f)
    {
      ends.clear();
      forEachEdge(f, [&](Index from, Index to) {
        if (sign(from) * sign(to) < 0)
        {
          ends.push_back(meetingPoint(from, to));
        }
        else if (sign(to) == 0)
        {
          ends.push_back(cell_.nodes[to]);
        }
      });
      double length = 0;
      for (const Vector& end : ends)
      {
        length = std::max(length, norm(minus(end, ends.front())));
      }
      forEachEdge(f, [&](Index from, Index to) {
        if (sign(from) * sign(to) < 0)
        {
          lengths.emplace_back(keyOf(from, to), length);
        }
      });
    }
    std::sort(lengths.begin(), lengths.end());
    for (std::size_t i = 0; i < lengths.size(); ++i)
    {
      const auto& [edge, length] = lengths[i];
      if (i > 0 && lengths[i - 1].first == edge)
      {
        continue; // the shorter one counts
      }
      const bool first = std::abs(distance_[edge.first]) <= std::abs(distance_[edge.second]);
      const Index nearest = first ? edge.first : edge.second;
      if (std::abs(distance_[nearest]) < SnapSlope * length)
      {
        snapped_.push_back(nearest);
      }
    }
    for (const Index node : snapped_)
    {
      distance_[node] = 0;
    }
  }

  bool isOnPlane(Index n) const { return n >= cell_.nodes.size() || distance_[n] == 0; }

  bool hasBothSides() const
  {
    const auto above = [](double d) { return d > 0; };
    const auto below = [](double d) { return d < 0; };
    return std::any_of(distance_.begin(), distance_.end(), above) &&
      std::any_of(distance_.begin(), distance_.end(), below);
  }

  static bool same(const Vector& p, const Vector& q)
  {
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
  }

  Vector node(Index n) const
  {
    return n < cell_.nodes.size() ? cell_.nodes[n] : cut_.points[n - cell_.nodes.size()].at;
  }

  // False where rounding takes a point onto a node.
  bool addPoints()
  {
    bool good = true;
    for (std::size_t f = 0; f < cell_.faces(); ++f)
    {
      forEachEdge(f, [&](Index from, Index to) {
        const EdgeKey edge = keyOf(from, to);
        if (sign(from) * sign(to) < 0 && pointOn(edge) == NoPoint)
        {
          Vector at = meetingPoint(edge.first, edge.second);
          for (double& x : at)
          {
            x = std::round(x);
          }
          good = good && !same(at, cell_.nodes[from]) && !same(at, cell_.nodes[to]);
          cut_.points.push_back({ edge.first, edge.second, at });
        }
      });
    }
    return good;
  }

  // There are not many.
  Index pointOn(const EdgeKey& edge) const
  {
    for (std::size_t i = 0; i < cut_.points.size(); ++i)
    {
      if (cut_.points[i].low == edge.first && cut_.points[i].high == edge.second)
      {
        return static_cast<Index>(cell_.nodes.size() + i);
      }
    }
    return NoPoint;
  }

  // --- faces into pieces

  // The face's corners and the points on its edges, with the signs of their places.
  void listRing(std::size_t face)
  {
    ring_.clear();
    signs_.clear();
    forEachEdge(face, [&](Index from, Index to) {
      if (sign(from) * sign(to) < 0)
      {
        ring_.push_back(pointOn(keyOf(from, to)));
        signs_.push_back(0);
      }
      ring_.push_back(to);
      signs_.push_back(sign(to));
    });
  }

  // Places in the ring where it passes from one side to the other: of several on the plane, the
  // first.
  std::vector<std::size_t> passages() const
  {
    std::vector<std::size_t> result;
    const std::size_t n = ring_.size();
    const auto first = static_cast<std::size_t>(
      std::find_if(signs_.begin(), signs_.end(), [](int s) { return s != 0; }) - signs_.begin());
    int side = signs_[first];
    std::size_t zero = n;
    for (std::size_t step = 1; step <= n; ++step)
    {
      const std::size_t i = (first + step) % n;
      if (signs_[i] == 0)
      {
        zero = zero == n ? i : zero;
        continue;
      }
      if (signs_[i] != side)
      {
        result.push_back(zero);
        side = signs_[i];
      }
      zero = n;
    }
    return result;
  }

  Vector areaOf(const std::vector<Index>& ring) const
  {
    Vector twice{ 0, 0, 0 };
    const Vector base = node(ring[0]);
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    {
      twice = plus(twice, cross(minus(node(ring[i]), base), minus(node(ring[i + 1]), base)));
    }
    return twice;
  }

  bool divideFace(std::size_t face)
  {
    listRing(face);
    const bool flat = std::all_of(signs_.begin(), signs_.end(), [](int s) { return s == 0; });
    const int any = flat ? 0 : *std::find_if(signs_.begin(), signs_.end(), [](int s) { return s; });
    const auto source = static_cast<Index>(face);
    if (flat)
    {
      addPiece(ring_, source, dot(areaOf(ring_), plane_.normal) > 0 ? -1 : 1);
      return true;
    }
    std::vector<std::size_t> cuts = passages();
    if (cuts.empty())
    {
      addPiece(ring_, source, any);
      return true;
    }
    // Along the line in which the plane meets the face, every other stretch lies in the face.
    const Vector along = cross(plane_.normal, areaOf(ring_));
    std::sort(cuts.begin(), cuts.end(), [&](std::size_t x, std::size_t y) {
      const double a = dot(node(ring_[x]), along);
      const double b = dot(node(ring_[y]), along);
      return a != b ? a < b : x < y;
    });
    std::vector<std::vector<Index>> pieces;
    pieces.reserve(1 + cuts.size() / 2);
    pieces.push_back(ring_);
    for (std::size_t i = 0; i + 1 < cuts.size(); i += 2)
    {
      if (!splitBetween(ring_[cuts[i]], ring_[cuts[i + 1]], pieces))
      {
        return false;
      }
    }
    // A stretch that lies outside, as snapped nodes may have it, would turn a piece over.
    const Vector area = areaOf(ring_);
    return std::all_of(pieces.begin(), pieces.end(), [&](const std::vector<Index>& piece) {
      const int side = sideOf(piece);
      return side != 0 && dot(areaOf(piece), area) > 0 && addStars(piece, source, side);
    });
  }

  static bool splitBetween(Index p, Index q, std::vector<std::vector<Index>>& pieces)
  {
    for (std::vector<Index>& piece : pieces)
    {
      const auto atP = std::find(piece.begin(), piece.end(), p);
      const auto atQ = std::find(piece.begin(), piece.end(), q);
      if (p != q && atP != piece.end() && atQ != piece.end())
      {
        std::rotate(piece.begin(), atP, piece.end());
        const auto split = std::find(piece.begin(), piece.end(), q);
        std::vector<Index> rest(split, piece.end());
        rest.push_back(p);
        piece.erase(split + 1, piece.end());
        if (piece.size() < 3 || rest.size() < 3)
        {
          return false;
        }
        pieces.push_back(std::move(rest));
        return true;
      }
    }
    return false;
  }

  // 1 or -1: the side of the plane that a piece lies on; 0: on both.
  int sideOf(const std::vector<Index>& piece) const
  {
    int side = 0;
    for (const Index n : piece)
    {
      const int s = n < cell_.nodes.size() ? sign(n) : 0;
      if (s * side < 0)
      {
        return 0;
      }
      side = s != 0 ? s : side;
    }
    return side;
  }

  void addPiece(const std::vector<Index>& corners, Index source, int side)
  {
    const std::size_t begin = cut_.corners.size();
    cut_.corners.insert(cut_.corners.end(), corners.begin(), corners.end());
    cut_.faces.push_back({ begin, cut_.corners.size(), source, 0, 0 });
    sides_.push_back(side);
  }

  // A polygon as it appears along the axis that it is most perpendicular to.
  FlatPolygon flattened(const std::vector<Index>& corners, const Vector& normal, bool& turned) const
  {
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
    {
      axis = std::abs(normal[i]) > std::abs(normal[axis]) ? i : axis;
    }
    turned = normal[axis] < 0;
    FlatPolygon polygon;
    polygon.nodes.reserve(corners.size());
    polygon.at.reserve(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      const Index n = corners[turned ? corners.size() - 1 - i : i];
      const Vector p = node(n);
      polygon.nodes.push_back(n);
      polygon.at.push_back({ static_cast<std::int64_t>(p[(axis + 1) % 3]),
        static_cast<std::int64_t>(p[(axis + 2) % 3]) });
    }
    return polygon;
  }

  // Adds a piece of a face, or as many as have star triangulations.
  bool addStars(const std::vector<Index>& corners, Index source, int side)
  {
    bool turned = false;
    const Vector normal = source == CellCut::NoSource ? plane_.normal : areaOf(corners);
    stars_.clear();
    splitIntoStars(flattened(corners, normal, turned), stars_);
    for (FlatPolygon& star : stars_)
    {
      if (turned)
      {
        std::reverse(star.nodes.begin(), star.nodes.end());
      }
      if (!isStar(star.at) || isFolded(star.nodes))
      {
        return false;
      }
      addPiece(star.nodes, source, side);
    }
    return true;
  }

  // Pieces of bent faces may have a star along the axis and none along their own normal.
  bool isFolded(const std::vector<Index>& corners) const
  {
    const auto at = [&](std::size_t i) { return node(corners[i]); };
    return smallestOfStar(corners.size(), at, scaled(areaOf(corners), 0.5)) < -RoundingOfAreas;
  }

  // --- the cutting faces

  // The edges of the pieces below the plane that no other of them has: their loops, the other way
  // round, are cutting faces.
  bool closeCut()
  {
    // Elsewhere the cell is closed: only edges on the plane count.
    std::vector<std::pair<EdgeKey, int>> runs; // 1: from the lower node; -1: from the higher
    for (std::size_t f = 0; f < cut_.faces.size(); ++f)
    {
      if (sides_[f] > 0)
      {
        continue;
      }
      const CellCut::FaceCorners corners = cut_.cornersOf(cut_.faces[f]);
      Index from = corners[corners.size() - 1];
      for (const Index to : corners)
      {
        if (isOnPlane(from) && isOnPlane(to))
        {
          runs.emplace_back(keyOf(from, to), from < to ? 1 : -1);
        }
        from = to;
      }
    }
    std::sort(runs.begin(), runs.end());
    std::vector<std::pair<Index, Index>> next; // of a node on a cutting face
    for (auto run = runs.begin(); run != runs.end();)
    {
      const EdgeKey edge = run->first;
      int sum = 0;
      for (; run != runs.end() && run->first == edge; ++run)
      {
        sum += run->second;
      }
      const bool up = sum > 0; // the piece runs from the lower node: the cut from the higher
      if (std::abs(sum) > 1)
      {
        return false;
      }
      if (sum != 0)
      {
        next.emplace_back(up ? edge.second : edge.first, up ? edge.first : edge.second);
      }
    }
    return addLoops(next);
  }

  // `next`: pairs of nodes that follow each other; false where one has two that do.
  bool addLoops(std::vector<std::pair<Index, Index>>& next)
  {
    std::sort(next.begin(), next.end());
    const auto sameNode = [](const auto& x, const auto& y) { return x.first == y.first; };
    if (std::adjacent_find(next.begin(), next.end(), sameNode) != next.end())
    {
      return false;
    }
    std::vector<std::uint8_t> done(next.size());
    for (std::size_t first = 0; first < next.size(); ++first)
    {
      std::vector<Index> loop;
      for (std::size_t i = first; i < next.size() && !done[i];)
      {
        done[i] = 1;
        loop.push_back(next[i].first);
        const auto at =
          std::lower_bound(next.begin(), next.end(), std::make_pair(next[i].second, Index(0)));
        const bool found = at != next.end() && at->first == next[i].second;
        i = found ? static_cast<std::size_t>(at - next.begin()) : next.size();
      }
      if (loop.empty())
      {
        continue;
      }
      // A loop the other way round is a hole of another.
      if (loop.size() < 3 || !(dot(areaOf(loop), plane_.normal) > 0) ||
        !addStars(loop, CellCut::NoSource, -1))
      {
        return false;
      }
    }
    return true;
  }

  // Two faces between the same nodes are a part of no thickness.
  bool allDistinct() const
  {
    using Sums = std::array<std::uint64_t, 3>; // equal for the same nodes, seldom for others
    std::vector<std::pair<Sums, std::size_t>> order;
    for (std::size_t f = 0; f < cut_.faces.size(); ++f)
    {
      const CellCut::FaceCorners corners = cut_.cornersOf(cut_.faces[f]);
      Sums sums{ corners.size(), 0, 0 };
      for (const std::uint64_t corner : corners)
      {
        sums[1] += corner;
        sums[2] += corner * corner;
      }
      order.emplace_back(sums, f);
    }
    std::sort(order.begin(), order.end());
    return std::adjacent_find(order.begin(), order.end(), [&](const auto& x, const auto& y) {
      const CellCut::FaceCorners corners = cut_.cornersOf(cut_.faces[x.second]);
      return x.first == y.first &&
        std::is_permutation(
          corners.begin(), corners.end(), cut_.cornersOf(cut_.faces[y.second]).begin());
    }) == order.end();
  }

  // --- the parts

  // Faces that share an edge belong together, on either side. Cutting faces are there twice: below
  // as themselves, above with numbers of their own.
  bool findParts()
  {
    const auto count = static_cast<Index>(cut_.faces.size());
    sets_.reset(2 * std::size_t(count));
    edges_.reset(2 * cut_.corners.size());
    const auto list = [&](Index f, Index as, int side) {
      const CellCut::FaceCorners corners = cut_.cornersOf(cut_.faces[f]);
      Index from = corners[corners.size() - 1];
      for (const Index to : corners)
      {
        const EdgeKey edge = keyOf(from, to);
        Index& first = edges_.at(edge.first, edge.second, side > 0 ? 1 : 0);
        if (first == EdgeTable::Fresh)
        {
          first = as;
        }
        sets_.unite(as, first);
        from = to;
      }
    };
    for (Index f = 0; f < count; ++f)
    {
      list(f, f, sides_[f]);
      if (cut_.faces[f].source == CellCut::NoSource)
      {
        list(f, count + f, 1);
      }
    }
    number_.assign(2 * std::size_t(count), NoPoint);
    cut_.parts = 0;
    const auto partOf = [&](Index f) {
      Index& number = number_[sets_.find(f)];
      number = number == NoPoint ? cut_.parts++ : number;
      return number;
    };
    for (Index f = 0; f < count; ++f)
    {
      CellCut::Face& face = cut_.faces[f];
      face.below = face.above = partOf(f);
      if (face.source == CellCut::NoSource)
      {
        face.above = partOf(count + f);
      }
    }
    return cut_.parts > 1;
  }

  // What is closer to the plane than this is on it: points are rounded to whole numbers.
  static constexpr double RoundingLevels = 2;

  const Polyhedron& cell_;
  const CutPlane& plane_;
  CellCut& cut_;
  std::vector<double> distance_; // of nodes from the plane; 0: on it
  std::vector<Index> snapped_;
  std::vector<Index> ring_;
  std::vector<int> signs_;
  std::vector<int> sides_; // of each face of the cut
  std::vector<FlatPolygon> stars_;
  DisjointSets sets_; // of the cut's faces
  std::vector<Index> number_;
  EdgeTable edges_; // the first face at each, on each side of the plane
};

}

bool cutCell(const Polyhedron& cell, const CutPlane& plane, CellCut& cut)
{
  return Cutter(cell, plane, cut).run();
}

Polyhedron partOf(const Polyhedron& cell, const CellCut& cut, std::uint32_t part)
{
  Polyhedron result;
  result.reserve(cell.nodes.size() + cut.points.size(), cut.faces.size(), cut.corners.size());
  result.nodes.assign(cell.nodes.begin(), cell.nodes.end());
  for (const CellCut::NewNode& point : cut.points)
  {
    result.nodes.push_back(point.at);
  }
  for (const CellCut::Face& face : cut.faces)
  {
    const bool inner = face.source == CellCut::NoSource;
    const CellCut::FaceCorners corners = cut.cornersOf(face);
    if (face.below == part)
    {
      result.corners.insert(result.corners.end(), corners.begin(), corners.end());
      result.closeFace(!inner && cell.isBoundary[face.source]);
    }
    else if (inner && face.above == part)
    {
      result.corners.insert(result.corners.end(), std::make_reverse_iterator(corners.end()),
        std::make_reverse_iterator(corners.begin()));
      result.closeFace(false);
    }
  }
  return result;
}

}
