// SPDX-License-Identifier: BSD-3-Clause
#include "Collapse/StandOff.h"

#include "Base/Sorting.h"
#include "Polyhedra/CellGeometry.h"

#include <algorithm>
#include <limits>

namespace cartesian
{

namespace
{

constexpr std::size_t FacesAChunk = 1024;

// Parts of the box's shortest edge. Anything nearer is flat up to rounding; nothing moves farther.
constexpr double LeastOff = 4e-6;
constexpr double MostOff = 0.1;

// By how much an edge of a patch may turn, as a tangent; and how far a node may move along another edge.
constexpr double MostTurn = 0.12;
constexpr double MostOfEdge = 0.3;

// Cosines of the angles by which patches (15 degrees) and inner faces (60) may turn: narrow ones would by more.
constexpr double LeastCosine = 0.966;
constexpr double LeastCosineInside = 0.5;

// Of a node of the wall.
struct WallNode
{
  Vector normal{};   // the sum of its patches' areas
  double weight = 0; // the area of those that are chords
  double height = 0; // by weight; once smooth, alone
  bool isKnown = false;
  bool stays = false;
  std::int32_t boundary = NoBoundary;
};

class Mover
{
public:
  Mover(const Boxes& boxes, const Patches& patches, const InnerFaces& inner, double featureAngle,
    const Nodes& nodes)
    : boxes_(boxes)
    , patches_(patches)
    , inner_(inner)
    , leastCosine_(std::cos(radians(featureAngle)))
    , at_(nodes.at)
    , nodes_(nodes.at.size())
  {
  }

  void lookAt(const std::vector<std::uint32_t>& intersected, Execution& execution)
  {
    areas_.resize(patches_.size());
    execution.forEach(patches_.size(), FacesAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p)
      {
        areas_[p] = areaOf(p);
      }
    });
    for (std::size_t n = 0; n < intersected.size(); ++n)
    {
      const Box box = boxes_.box(intersected[n]);
      const Vector size = minus(box.high, box.low);
      const double edge = *std::min_element(size.begin(), size.end());
      for (std::size_t p = patches_.boxStart[n]; p < patches_.boxStart[n + 1]; ++p)
      {
        note(p, heightOf(n, edge), patches_.reason[n] == PatchReason::MarchingCubes);
      }
    }
    std::vector<std::vector<std::uint32_t>> sharp(chunks(patches_.size(), FacesAChunk));
    execution.forEach(patches_.size(), FacesAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p)
      {
        findSharp(p, sharp[begin / FacesAChunk]);
      }
    });
    for (const std::uint32_t node : concatenated(sharp))
    {
      nodes_[node].stays = true;
    }
  }

  // The height of each node; without steps, and short of its neighbours.
  void smooth()
  {
    std::vector<double> heights(nodes_.size());
    std::transform(nodes_.begin(), nodes_.end(), heights.begin(), [](const WallNode& node) {
      return node.stays || node.weight == 0 ? 0 : node.height / node.weight;
    });
    std::vector<double> most(nodes_.size(), std::numeric_limits<double>::infinity());
    forEachEdge(inner_.start, inner_.nodes, [&](std::uint32_t from, std::uint32_t to) {
      const double length = MostOfEdge * norm(minus(at_[from], at_[to]));
      most[from] = std::min(most[from], length);
      most[to] = std::min(most[to], length);
    });
    for (std::size_t i = 0; i < nodes_.size(); ++i)
    {
      heights[i] = std::clamp(heights[i], -most[i], most[i]);
    }
    forEachEdge(patches_.start, patches_.corners, [&](std::uint32_t from, std::uint32_t to) {
      const double turn = MostTurn * norm(minus(at_[from], at_[to]));
      most[from] = std::min(most[from], std::abs(heights[to]) + turn);
      most[to] = std::min(most[to], std::abs(heights[from]) + turn);
    });
    for (std::size_t i = 0; i < nodes_.size(); ++i)
    {
      nodes_[i].height = std::clamp(heights[i], -most[i], most[i]);
    }
  }

  std::vector<Point> moved(Execution& execution) const
  {
    std::vector<Point> to = at_;
    execution.forEach(
      to.size(), FacesAChunk, [&](std::size_t begin, std::size_t end) { move(begin, end, to); });
    return to;
  }

private:
  void move(std::size_t begin, std::size_t end, std::vector<Point>& to) const
  {
    for (std::size_t i = begin; i < end; ++i)
    {
      const Vector way = scaled(unit(nodes_[i].normal), nodes_[i].height);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const auto& planes = boxes_.planes[axis];
        if (to[i][axis] > planes.front() && to[i][axis] < planes.back())
        {
          to[i][axis] = static_cast<Level>(std::clamp(
            std::round(to[i][axis] + way[axis]), planes.front() + 1.0, planes.back() - 1.0));
        }
      }
    }
  }

  double heightOf(std::size_t n, double edge) const
  {
    const double height = patches_.missing.empty() ? 0 : patches_.missing[n];
    return std::abs(height) < LeastOff * edge ? 0
                                              : std::clamp(height, -MostOff * edge, MostOff * edge);
  }

  void note(std::size_t p, double height, bool isChords)
  {
    const Vector& area = areas_[p];
    for (std::size_t c = patches_.start[p]; c < patches_.start[p + 1]; ++c)
    {
      WallNode& node = nodes_[patches_.corners[c]];
      node.stays = node.stays || (node.isKnown && node.boundary != patches_.boundary[p]);
      node.boundary = patches_.boundary[p];
      node.isKnown = true;
      node.normal = plus(node.normal, area);
      if (isChords || height != 0)
      {
        node.weight += norm(area);
        node.height += norm(area) * height;
      }
    }
  }

  // Appends the nodes where the wall turns sharply from a patch.
  void findSharp(std::size_t p, std::vector<std::uint32_t>& sharp) const
  {
    const Vector normal = unit(areas_[p]);
    for (std::size_t c = patches_.start[p]; c < patches_.start[p + 1]; ++c)
    {
      const std::uint32_t node = patches_.corners[c];
      if (!nodes_[node].stays && dot(unit(nodes_[node].normal), normal) < leastCosine_)
      {
        sharp.push_back(node);
      }
    }
  }

  Vector areaOf(std::size_t p) const
  {
    const std::size_t first = patches_.start[p];
    const Point& origin = at_[patches_.corners[first]];
    return measureFace(patches_.start[p + 1] - first, [&](std::size_t i) {
      return minus(at_[patches_.corners[first + i]], origin);
    }).area;
  }

  template <class Starts, class Corners, class Visitor>
  static void forEachEdge(const Starts& start, const Corners& corners, Visitor&& visit)
  {
    for (std::size_t f = 0; f + 1 < start.size(); ++f)
    {
      for (std::size_t c = start[f]; c < start[f + 1]; ++c)
      {
        visit(corners[c > start[f] ? c - 1 : start[f + 1] - 1], corners[c]);
      }
    }
  }

  const Boxes& boxes_;
  const Patches& patches_;
  const InnerFaces& inner_;
  const double leastCosine_;
  const std::vector<Point>& at_;
  std::vector<WallNode> nodes_;
  RawVector<Vector> areas_; // of patches
};

// Patches, or inner faces.
template <class Starts, class Corners>
class MovedFaces
{
public:
  // `leastCosine`: of the angle by which a face may turn.
  MovedFaces(const Starts& start, const Corners& corners, double leastCosine,
    const std::vector<Point>& at, std::vector<Point>& to)
    : start_(start)
    , corners_(corners)
    , leastCosine_(leastCosine)
    , at_(at)
    , to_(to)
  {
  }

  // Finds those that turn by more, or whose star now has an inverted triangle.
  void findBent(Execution& execution)
  {
    bent_.assign(start_.size() - 1, 0);
    execution.forEach(bent_.size(), FacesAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f)
      {
        bent_[f] = moves(f) && isBent(f) ? 1 : 0;
      }
    });
  }

  // Moves their corners back.
  void takeBack()
  {
    for (std::size_t f = 0; f < bent_.size(); ++f)
    {
      for (std::size_t c = start_[f]; bent_[f] && c < start_[f + 1]; ++c)
      {
        to_[corners_[c]] = at_[corners_[c]];
      }
    }
  }

private:
  bool moves(std::size_t f) const
  {
    bool any = false;
    for (std::size_t c = start_[f]; !any && c < start_[f + 1]; ++c)
    {
      any = !areSame(to_[corners_[c]], at_[corners_[c]]);
    }
    return any;
  }

  bool isBent(std::size_t f) const
  {
    const std::size_t first = start_[f];
    const std::size_t size = start_[f + 1] - first;
    const Point& origin = at_[corners_[first]];
    const auto before = [&](std::size_t i) { return minus(at_[corners_[first + i]], origin); };
    const auto after = [&](std::size_t i) { return minus(to_[corners_[first + i]], origin); };
    const Vector was = measureFace(size, before).area;
    const Vector is = measureFace(size, after).area;
    return !(dot(was, is) > leastCosine_ * norm(was) * norm(is)) ||
      smallestOfStar(size, after, is) < std::min(0.0, smallestOfStar(size, before, was));
  }

  const Starts& start_;
  const Corners& corners_;
  const double leastCosine_;
  const std::vector<Point>& at_;
  std::vector<Point>& to_;
  std::vector<std::uint8_t> bent_;
};

}

bool standOff(const Boxes& boxes, const Patches& patches, const InnerFaces& inner,
  double featureAngle, Nodes& nodes, Execution& execution)
{
  Mover mover(boxes, patches, inner, featureAngle, nodes);
  mover.lookAt(intersectedBoxes(boxes, execution), execution);
  mover.smooth();
  std::vector<Point> to = mover.moved(execution);
  MovedFaces ofWall(patches.start, patches.corners, LeastCosine, nodes.at, to);
  MovedFaces ofInside(inner.start, inner.nodes, LeastCosineInside, nodes.at, to);
  ofWall.findBent(execution);
  ofInside.findBent(execution);
  ofWall.takeBack();
  ofInside.takeBack();
  const bool any = to != nodes.at;
  nodes.at = std::move(to);
  return any;
}

}
