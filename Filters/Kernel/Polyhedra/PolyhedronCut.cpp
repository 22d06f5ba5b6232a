// SPDX-License-Identifier: BSD-3-Clause
#include "Polyhedra/PolyhedronCut.h"

#include "Base/DisjointSets.h"
#include "Base/EdgeTable.h"
#include "Base/ObjectPool.h"
#include "Lattice/StarPolygons.h"
#include "Polyhedra/CellGeometry.h"
#include "Polyhedra/PlaneSection.h"

#include <algorithm>
#include <iterator>

namespace cartesian
{

namespace
{

using Index = std::uint32_t;
using Edge = PlaneSection::Edge;

constexpr Index NoNumber = ~Index(0);

// Cuts one cell after the other; keeps its memory.
class CellCutter
{
public:
  bool run(const Polyhedron& cell, const CutPlane& plane, CellCut& cut)
  {
    cell_ = &cell;
    normal_ = plane.normal;
    cut_ = &cut;
    cut.faces.clear();
    cut.corners.clear();
    sides_.clear();
    if (!section_.find(cell, plane, cut.points))
    {
      return false;
    }
    cut.faces.reserve(2 * cell.faces());
    cut.corners.reserve(2 * cell.corners.size());
    for (std::size_t f = 0; f < cell.faces(); ++f)
    {
      if (!divideFace(f))
      {
        return false;
      }
    }
    return closeCut() && allDistinct() && findParts();
  }

private:
  // --- faces into pieces

  // The face's corners and the new nodes on its edges, with their signs.
  void listRing(std::size_t face)
  {
    ring_.clear();
    signs_.clear();
    section_.forEachEdge(face, [&](Index from, Index to) {
      if (section_.crosses(from, to))
      {
        ring_.push_back(section_.newNodeOn(PlaneSection::edgeBetween(from, to)));
        signs_.push_back(0);
      }
      ring_.push_back(to);
      signs_.push_back(section_.sign(to));
    });
  }

  // Lists where the ring passes from one side of the plane to the other: of several consecutive nodes on
  // the plane, the first.
  void listPassages()
  {
    passages_.clear();
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
        passages_.push_back(zero);
        side = signs_[i];
      }
      zero = n;
    }
  }

  const Vector& node(Index n) const { return section_.position(n); }

  // Twice the area.
  Vector twiceAreaOf(const std::vector<Index>& ring) const
  {
    Vector twice{ 0, 0, 0 };
    const Vector& base = node(ring[0]);
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    {
      twice = plus(twice, cross(minus(node(ring[i]), base), minus(node(ring[i + 1]), base)));
    }
    return twice;
  }

  bool divideFace(std::size_t face)
  {
    const auto source = static_cast<Index>(face);
    if (!section_.crosses(face))
    {
      keepFace(source);
      return true;
    }
    listRing(face);
    listPassages();
    // On the line where the plane meets the face, every other segment lies inside the face.
    const Vector area = twiceAreaOf(ring_);
    const Vector along = cross(normal_, area);
    std::sort(passages_.begin(), passages_.end(), [&](std::size_t x, std::size_t y) {
      const double a = dot(node(ring_[x]), along);
      const double b = dot(node(ring_[y]), along);
      return a != b ? a < b : x < y;
    });
    pool_.release(pieces_);
    addRing(ring_.begin(), ring_.end());
    for (std::size_t i = 0; i + 1 < passages_.size(); i += 2)
    {
      if (!splitBetween(ring_[passages_[i]], ring_[passages_[i + 1]]))
      {
        return false;
      }
    }
    // After snapping, a segment may lie outside the face, which turns a piece over.
    return std::all_of(pieces_.begin(), pieces_.end(), [&](const std::vector<Index>& piece) {
      const int side = sideOf(piece);
      return side != 0 && dot(twiceAreaOf(piece), area) > 0 && addStars(piece, source, side);
    });
  }

  // On one side of the plane, or on it.
  void keepFace(Index face)
  {
    const auto begin = cell_->corners.begin() + std::ptrdiff_t(cell_->start[face]);
    const auto end = cell_->corners.begin() + std::ptrdiff_t(cell_->start[face + 1]);
    const auto off = std::find_if(begin, end, [&](Index n) { return !section_.isOnPlane(n); });
    int side = off == end ? 0 : section_.sign(*off);
    if (side == 0)
    {
      ring_.assign(begin, end);
      side = dot(twiceAreaOf(ring_), normal_) > 0 ? -1 : 1;
    }
    addPiece(begin, end, face, side);
  }

  template <class Iterator>
  void addRing(Iterator begin, Iterator end)
  {
    pieces_.push_back(pool_.acquire());
    pieces_.back().assign(begin, end);
  }

  bool splitBetween(Index p, Index q)
  {
    for (std::vector<Index>& piece : pieces_)
    {
      const auto atP = std::find(piece.begin(), piece.end(), p);
      const auto atQ = std::find(piece.begin(), piece.end(), q);
      if (p != q && atP != piece.end() && atQ != piece.end())
      {
        std::rotate(piece.begin(), atP, piece.end());
        const auto split = std::find(piece.begin(), piece.end(), q);
        std::vector<Index> rest = pool_.acquire();
        rest.assign(split, piece.end());
        rest.push_back(p);
        piece.erase(split + 1, piece.end());
        const bool areLoops = piece.size() >= 3 && rest.size() >= 3;
        pieces_.push_back(std::move(rest));
        return areLoops;
      }
    }
    return false;
  }

  // 1 or -1: the side of the plane that a piece lies on; 0: both sides, or neither.
  int sideOf(const std::vector<Index>& piece) const
  {
    int side = 0;
    for (const Index n : piece)
    {
      const int s = section_.sign(n);
      if (s * side < 0)
      {
        return 0;
      }
      side = s != 0 ? s : side;
    }
    return side;
  }

  template <class Iterator>
  void addPiece(Iterator begin, Iterator end, Index source, int side)
  {
    const std::size_t first = cut_->corners.size();
    cut_->corners.insert(cut_->corners.end(), begin, end);
    cut_->faces.push_back({ first, cut_->corners.size(), source, 0, 0 });
    sides_.push_back(side);
  }

  // The polygon projected along the axis nearest to its normal; returns whether that reversed it.
  bool flatten(const std::vector<Index>& corners, const Vector& normal, FlatPolygon& polygon) const
  {
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
    {
      axis = std::abs(normal[i]) > std::abs(normal[axis]) ? i : axis;
    }
    const bool turned = normal[axis] < 0;
    polygon.nodes.clear();
    polygon.at.clear();
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      const Index n = corners[turned ? corners.size() - 1 - i : i];
      const Vector& p = node(n);
      polygon.nodes.push_back(n);
      polygon.at.push_back({ static_cast<std::int64_t>(p[(axis + 1) % 3]),
        static_cast<std::int64_t>(p[(axis + 2) % 3]) });
    }
    return turned;
  }

  // Adds a polygon, split into pieces that have star triangulations; false if that fails.
  bool addStars(const std::vector<Index>& corners, Index source, int side)
  {
    const Vector normal = source == CellCut::NoSource ? normal_ : twiceAreaOf(corners);
    const bool turned = flatten(corners, normal, polygon_);
    return addStars(polygon_, turned, source, side);
  }

  bool addStars(FlatPolygon& polygon, bool turned, Index source, int side)
  {
    if (isWhole(polygon)) // nearly all are
    {
      return addStar(polygon, turned, source, side);
    }
    stars_.clear();
    splitIntoStars(polygon, stars_);
    return std::all_of(stars_.begin(), stars_.end(),
      [&](FlatPolygon& star) { return addStar(star, turned, source, side); });
  }

  bool addStar(FlatPolygon& star, bool turned, Index source, int side)
  {
    if (turned)
    {
      std::reverse(star.nodes.begin(), star.nodes.end());
    }
    // Of more corners those that are whole are stars.
    if ((star.at.size() <= 3 && !isStar(star.at)) || isFolded(star.nodes))
    {
      return false;
    }
    addPiece(star.nodes.begin(), star.nodes.end(), source, side);
    return true;
  }

  // A piece of a warped face may have a star triangulation along the axis but not along its own
  // normal.
  bool isFolded(const std::vector<Index>& corners) const
  {
    const auto at = [&](std::size_t i) -> const Vector& { return node(corners[i]); };
    return smallestOfStar(corners.size(), at, scaled(twiceAreaOf(corners), 0.5)) < -StarRounding;
  }

  // --- the cutting faces

  using EdgeRun = std::pair<Edge, int>; // 1: from the lower node; -1: from the higher

  // Of the pieces below the plane. Off the plane the cell is closed: only edges on the plane matter.
  void listRunsOnPlane()
  {
    runs_.clear();
    for (std::size_t f = 0; f < cut_->faces.size(); ++f)
    {
      if (sides_[f] > 0)
      {
        continue;
      }
      const CellCut::FaceCorners corners = cut_->cornersOf(cut_->faces[f]);
      Index from = corners[corners.size() - 1];
      for (const Index to : corners)
      {
        if (section_.isOnPlane(from) && section_.isOnPlane(to))
        {
          runs_.emplace_back(PlaneSection::edgeBetween(from, to), from < to ? 1 : -1);
        }
        from = to;
      }
    }
    std::sort(runs_.begin(), runs_.end());
  }

  // Edges that only one piece below the plane uses form loops; reversed, these loops are the
  // cutting faces.
  bool closeCut()
  {
    listRunsOnPlane();
    next_.clear();
    for (auto run = runs_.begin(); run != runs_.end();)
    {
      const Edge edge = run->first;
      int sum = 0;
      for (; run != runs_.end() && run->first == edge; ++run)
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
        next_.emplace_back(up ? edge.second : edge.first, up ? edge.first : edge.second);
      }
    }
    return addLoops();
  }

  // False if a node has two successors.
  bool addLoops()
  {
    std::sort(next_.begin(), next_.end());
    const auto sameNode = [](const auto& x, const auto& y) { return x.first == y.first; };
    if (std::adjacent_find(next_.begin(), next_.end(), sameNode) != next_.end())
    {
      return false;
    }
    pool_.release(loops_);
    pool_.release(holes_);
    done_.assign(next_.size(), 0);
    for (std::size_t first = 0; first < next_.size(); ++first)
    {
      if (done_[first])
      {
        continue;
      }
      std::vector<Index> loop = pool_.acquire();
      traceLoop(first, loop);
      const double area = dot(twiceAreaOf(loop), normal_);
      const bool isLoop = loop.size() >= 3 && area != 0;
      (area > 0 ? loops_ : holes_).push_back(std::move(loop));
      if (!isLoop)
      {
        return false;
      }
    }
    return holes_.empty()
      ? std::all_of(loops_.begin(), loops_.end(),
          [&](const std::vector<Index>& loop) { return addStars(loop, CellCut::NoSource, -1); })
      : loops_.size() == 1 && addAround();
  }

  void traceLoop(std::size_t first, std::vector<Index>& loop)
  {
    loop.clear();
    for (std::size_t i = first; i < next_.size() && !done_[i];)
    {
      done_[i] = 1;
      loop.push_back(next_[i].first);
      const auto at =
        std::lower_bound(next_.begin(), next_.end(), std::make_pair(next_[i].second, Index(0)));
      const bool found = at != next_.end() && at->first == next_[i].second;
      i = found ? static_cast<std::size_t>(at - next_.begin()) : next_.size();
    }
  }

  // A cutting face around walls that the plane cuts off within the cell.
  bool addAround()
  {
    const bool turned = flatten(loops_.front(), normal_, polygon_);
    std::vector<FlatPolygon> flat(holes_.size());
    for (std::size_t i = 0; i < holes_.size(); ++i)
    {
      flatten(holes_[i], normal_, flat[i]);
    }
    joinHoles(polygon_, std::move(flat));
    return addStars(polygon_, turned, CellCut::NoSource, -1);
  }

  // Two faces with the same nodes would enclose a part without thickness.
  bool allDistinct()
  {
    order_.clear();
    for (std::size_t f = 0; f < cut_->faces.size(); ++f)
    {
      const CellCut::FaceCorners corners = cut_->cornersOf(cut_->faces[f]);
      Sums sums{ corners.size(), 0, 0 };
      for (const std::uint64_t corner : corners)
      {
        sums[1] += corner;
        sums[2] += corner * corner;
      }
      order_.emplace_back(sums, f);
    }
    std::sort(order_.begin(), order_.end());
    return std::adjacent_find(order_.begin(), order_.end(), [&](const auto& x, const auto& y) {
      const CellCut::FaceCorners corners = cut_->cornersOf(cut_->faces[x.second]);
      return x.first == y.first &&
        std::is_permutation(
          corners.begin(), corners.end(), cut_->cornersOf(cut_->faces[y.second]).begin());
    }) == order_.end();
  }

  // --- the parts

  // On each side of the plane, faces that share an edge belong to the same part. Cutting faces
  // appear twice: below under their own number, above under a second one.
  bool findParts()
  {
    const auto count = static_cast<Index>(cut_->faces.size());
    sets_.reset(2 * std::size_t(count));
    edges_.reset(2 * cut_->corners.size());
    const auto list = [&](Index f, Index as, int side) {
      const CellCut::FaceCorners corners = cut_->cornersOf(cut_->faces[f]);
      Index from = corners[corners.size() - 1];
      for (const Index to : corners)
      {
        const Edge edge = PlaneSection::edgeBetween(from, to);
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
      if (cut_->faces[f].source == CellCut::NoSource)
      {
        list(f, count + f, 1);
      }
    }
    number_.assign(2 * std::size_t(count), NoNumber);
    cut_->parts = 0;
    const auto partOf = [&](Index f) {
      Index& number = number_[sets_.find(f)];
      number = number == NoNumber ? cut_->parts++ : number;
      return number;
    };
    for (Index f = 0; f < count; ++f)
    {
      CellCut::Face& face = cut_->faces[f];
      face.below = face.above = partOf(f);
      if (face.source == CellCut::NoSource)
      {
        face.above = partOf(count + f);
      }
    }
    return cut_->parts > 1;
  }

  using Sums = std::array<std::uint64_t, 3>; // equal for the same nodes, rarely for others

  const Polyhedron* cell_ = nullptr;
  Vector normal_{}; // of the plane
  CellCut* cut_ = nullptr;
  PlaneSection section_;
  std::vector<Index> ring_;
  std::vector<int> signs_;
  std::vector<std::size_t> passages_;
  std::vector<std::vector<Index>> pieces_; // of the face at hand
  std::vector<int> sides_;                 // of each face of the cut
  FlatPolygon polygon_;
  std::vector<FlatPolygon> stars_;
  std::vector<EdgeRun> runs_;
  std::vector<std::pair<Index, Index>> next_; // of a node on a cutting face: it and its successor
  std::vector<std::uint8_t> done_;
  std::vector<std::vector<Index>> loops_;
  std::vector<std::vector<Index>> holes_; // reversed loops
  ObjectPool<std::vector<Index>> pool_;
  std::vector<std::pair<Sums, std::size_t>> order_;
  DisjointSets sets_;         // of the cut's faces
  std::vector<Index> number_; // of each set's part
  EdgeTable edges_;           // the first face at each edge, on each side of the plane
};

}

bool cutCell(const Polyhedron& cell, const CutPlane& plane, CellCut& cut)
{
  thread_local CellCutter cutter;
  return cutter.run(cell, plane, cut);
}

Polyhedron partOf(const Polyhedron& cell, const CellCut& cut, std::uint32_t part)
{
  Polyhedron result;
  takePart(cell, cut, part, result);
  return result;
}

void takePart(const Polyhedron& cell, const CellCut& cut, std::uint32_t part, Polyhedron& result)
{
  result.clear();
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
}

}
