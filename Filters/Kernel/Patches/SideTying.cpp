// SPDX-License-Identifier: BSD-3-Clause
#include "Patches/SideTying.h"

#include "Lattice/Vector.h"

#include <numeric>

namespace cartesian
{

namespace
{

// Segments that one chord may replace: the time to check them grows with their number.
constexpr std::size_t MostReplaced = 256;

double cosineOf(double degrees)
{
  return std::cos(radians(degrees));
}

double distance(const Point& p, const Point& q)
{
  const Vector d = minus(p, q);
  return std::sqrt(dot(d, d));
}

}

SideTying::SideTying(const Surface& surface, const Features& features, const Boxes& boxes,
  const PlaneClearance& clearance, const std::vector<PatchReason>& reasons, const PatchSpec& spec)
  : surface_(surface)
  , features_(features)
  , boxes_(boxes)
  , clearance_(clearance)
  , reasons_(reasons)
  , spec_(spec)
  , mergeCosine_(cosineOf(spec.mergeAngle))
  , featureCosine_(cosineOf(spec.featureAngle))
  , pairs_(features, boxes)
{
}

void SideTying::tie(std::uint32_t b, BoxSurface& piece)
{
  const Box box = boxes_.box(b);
  chords_.clear();
  onto_.resize(piece.points.size());
  for (std::uint32_t i = 0; i < onto_.size(); ++i)
  {
    onto_[i] = i;
  }
  short_.assign(piece.points.size(), 0);
  pairs_.find(box, piece, spec_.method == PatchMethod::MarchingCubes);
  leaving_.assign(piece.points.size(), None);
  arrivals_.assign(piece.points.size(), 0);
  departures_.assign(piece.points.size(), 0);

  // The segments of one part of a side are those that face the same box.
  segments_ = piece.segments;
  const std::array<std::uint32_t, 4> none{ None, None, None, None };
  std::array<std::array<std::uint32_t, 4>, 6> across{ none, none, none, none, none, none };
  std::array<bool, 6> known{};
  for (Segment& s : segments_)
  {
    auto& there = across[s.side];
    if (!known[s.side])
    {
      known[s.side] = true;
      there = facing(boxes_, box, s.side / 2, s.side % 2 == 1);
    }
    s.quarter = static_cast<std::uint8_t>(
      std::find(there.begin(), there.end(), there[s.quarter]) - there.begin());
  }
  sortByPart();
  const bool exactHere = reasons_[b] != PatchReason::MarchingCubes;
  for (const Segment* first = segments_.data(); first != segments_.data() + segments_.size();)
  {
    const Segment* last = first;
    while (last != segments_.data() + segments_.size() && last->side == first->side &&
      last->quarter == first->quarter)
    {
      ++last;
    }
    shortest_ = shortestEdge(box, first->side / 2);
    const std::uint32_t other = across[first->side][first->quarter];
    tiePart(piece, first, last, exactHere,
      other == None ? exactHere : reasons_[other] != PatchReason::MarchingCubes);
    first = last;
  }
}

// Keeps the order of the segments in each part.
void SideTying::sortByPart()
{
  const auto partOf = [](const Segment& s) { return std::size_t(4) * s.side + s.quarter; };
  std::array<std::size_t, 4 * 6 + 1> next{};
  for (const Segment& s : segments_)
  {
    ++next[partOf(s) + 1];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  sorted_.resize(segments_.size());
  for (const Segment& s : segments_)
  {
    sorted_[next[partOf(s)]++] = s;
  }
  segments_.swap(sorted_);
}

// Shortest edge on the sides perpendicular to `axis`: the same for both boxes of a side.
double SideTying::shortestEdge(const Box& box, int axis) const
{
  Level least = ~Level(0);
  for (const int other : { (axis + 1) % 3, (axis + 2) % 3 })
  {
    const auto o = static_cast<std::size_t>(other);
    least = std::min(least, clearance_.of(o, boxes_.globalOf(box).index[o]));
  }
  return least;
}

void SideTying::tiePart(
  BoxSurface& piece, const Segment* begin, const Segment* end, bool exactHere, bool exactThere)
{
  axis_ = begin->side / 2;
  exactHere_ = exactHere;
  exactThere_ = exactThere;
  const bool upper = begin->side % 2 == 1;
  moved_.clear();
  partNodes_.clear();
  flatNodes_.clear();
  for (const Segment* s = begin; s != end; ++s)
  {
    leaving_[s->from] = static_cast<std::uint32_t>(s - begin);
    ++departures_[s->from];
    ++arrivals_[s->to];
    partNodes_.push_back(s->from);
    partNodes_.push_back(s->to);
  }
  done_.assign(static_cast<std::size_t>(end - begin), 0);
  for (const Segment* s = begin; s != end; ++s)
  {
    if (isFixed(piece, s->from) && pairs_.partnerOf(s->from) == None)
    {
      followPolyline(piece, begin, static_cast<std::uint32_t>(s - begin));
      finishPolyline(piece, upper);
    }
  }
  for (const Segment* s = begin; s != end; ++s)
  {
    if (done_[static_cast<std::size_t>(s - begin)] == 0 && (exactHere_ || exactThere_))
    {
      followPolyline(piece, begin, static_cast<std::uint32_t>(s - begin));
      finishPolyline(piece, upper);
    }
  }
  for (const auto& [node, at] : moved_)
  {
    piece.points[node] = at;
  }
  for (const std::uint32_t node : partNodes_)
  {
    leaving_[node] = None;
    arrivals_[node] = 0;
    departures_[node] = 0;
  }
}

// Whether a polyline ends at a node: at edges of boxes, and where the surface touches itself.
bool SideTying::isFixed(const BoxSurface& piece, std::uint32_t node) const
{
  return planeCount(piece.points[node]) >= 2 || arrivals_[node] != 1 || departures_[node] != 1;
}

void SideTying::followPolyline(BoxSurface& piece, const Segment* begin, std::uint32_t first)
{
  line_.nodes.assign(1, begin[first].from);
  line_.triangles.clear();
  std::uint32_t s = first;
  while (s != None && done_[s] == 0)
  {
    done_[s] = 1;
    line_.nodes.push_back(begin[s].to);
    line_.triangles.push_back(begin[s].triangle);
    std::uint32_t node = begin[s].to;
    if (isFixed(piece, node))
    {
      node = pairs_.partnerOf(node); // goes on from there
      if (node == None)
      {
        return;
      }
    }
    s = leaving_[node];
  }
}

void SideTying::finishPolyline(BoxSurface& piece, bool upper)
{
  // Both boxes work on the polyline as the box below the side sees it.
  if (!upper)
  {
    std::reverse(line_.nodes.begin(), line_.nodes.end());
    std::reverse(line_.triangles.begin(), line_.triangles.end());
  }
  if (line_.nodes.front() == line_.nodes.back())
  {
    startAtFirstTriangle();
  }
  const std::size_t count = line_.nodes.size();
  line_.keep.assign(count, 0);
  line_.keep.front() = line_.keep.back() = 1;
  const bool exact = exactHere_ || exactThere_;
  if (exact)
  {
    std::fill(line_.keep.begin(), line_.keep.end(), 1);
    dropShort(piece);
    dropSimilar(piece);
  }
  if (endsShareLine(piece))
  {
    keepFarthest(piece);
  }
  else if (exactHere_ != exactThere_ && spec_.tying == Tying::MoveNodes)
  {
    moveOntoChord(piece);
  }
  addChords(piece, upper);
}

void SideTying::addChords(const BoxSurface& piece, bool upper)
{
  std::size_t last = 0;
  for (std::size_t i = 1; i < line_.nodes.size(); ++i)
  {
    if (line_.keep[i] == 0)
    {
      continue;
    }
    const std::uint32_t from = line_.nodes[last];
    const std::uint32_t to = line_.nodes[i];
    for (std::size_t k = last + 1; k < i; ++k)
    {
      const Point& p = piece.points[line_.nodes[k]];
      onto_[line_.nodes[k]] =
        distance(p, piece.points[from]) <= distance(p, piece.points[to]) ? from : to;
    }
    Chord chord{ from, to, line_.triangles[last], line_.triangles[i - 1] };
    if (!upper)
    {
      std::swap(chord.from, chord.to);
      std::swap(chord.firstTriangle, chord.lastTriangle);
    }
    chords_.push_back(chord);
    last = i;
  }
}

// Lets a closed polyline begin at a place that both boxes agree on.
void SideTying::startAtFirstTriangle()
{
  const auto first = std::min_element(line_.triangles.begin(), line_.triangles.end());
  const std::ptrdiff_t by = first - line_.triangles.begin();
  std::rotate(line_.triangles.begin(), first, line_.triangles.end());
  line_.nodes.pop_back();
  std::rotate(line_.nodes.begin(), line_.nodes.begin() + by, line_.nodes.end());
  line_.nodes.push_back(line_.nodes.front());
}

// Whether a straight line between the ends of the polyline would run along the border of the side.
bool SideTying::endsShareLine(const BoxSurface& piece) const
{
  const Point& p = piece.points[line_.nodes.front()];
  const Point& q = piece.points[line_.nodes.back()];
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<std::size_t>(axis);
    if (axis != axis_ && p[a] == q[a] && onPlane(p[a]))
    {
      return true;
    }
  }
  return false;
}

// Keeps a third node, without which the polyline would enclose nothing.
void SideTying::keepFarthest(const BoxSurface& piece)
{
  if (std::count(line_.keep.begin(), line_.keep.end(), 1) > 2)
  {
    return;
  }
  const PlanePoint p = flat(piece, line_.nodes.front());
  const PlanePoint q = flat(piece, line_.nodes.back());
  Wide farthest = 0;
  std::size_t best = 0;
  for (std::size_t i = 1; i + 1 < line_.nodes.size(); ++i)
  {
    const Wide area = turn(p, q, flat(piece, line_.nodes[i]));
    if ((area < 0 ? -area : area) > farthest)
    {
      farthest = area < 0 ? -area : area;
      best = i;
    }
  }
  if (best > 0)
  {
    line_.keep[best] = 1;
  }
}

// Drops nodes that are closer to the one before than the shortest edge, or to the end.
void SideTying::dropShort(const BoxSurface& piece)
{
  const std::size_t end = line_.nodes.size() - 1;
  std::size_t last = 0;
  for (std::size_t i = 1; i < end; ++i)
  {
    const Point& p = piece.points[line_.nodes[i]];
    const bool tooShort = distance(piece.points[line_.nodes[last]], p) < shortest_ ||
      distance(p, piece.points[line_.nodes[end]]) < shortest_;
    line_.keep[i] = tooShort ? 0 : 1;
    short_[line_.nodes[i]] = tooShort ? 1 : 0;
    last = tooShort ? last : i;
  }
}

// Drops all nodes between each node that stays and the farthest one that a chord may reach.
void SideTying::dropSimilar(const BoxSurface& piece)
{
  const std::size_t end = line_.nodes.size() - 1;
  std::size_t from = 0;
  std::size_t before = 0; // the last node reached
  for (std::size_t i = 1; i <= end; ++i)
  {
    if (line_.keep[i] == 0)
    {
      continue;
    }
    if (before != from)
    {
      if (i - from <= MostReplaced && mayReplace(piece, from, before, i))
      {
        line_.keep[before] = 0;
      }
      else
      {
        from = before;
      }
    }
    before = i;
  }
}

// Whether the chord from node i to node j may replace the segments between; `before`: the last node
// between them that was kept so far.
bool SideTying::mayReplace(
  const BoxSurface& piece, std::size_t i, std::size_t before, std::size_t j)
{
  if (isFeature(piece, before))
  {
    return false;
  }
  const Vector chord = minus(piece.points[line_.nodes[j]], piece.points[line_.nodes[i]]);
  const double length = std::sqrt(dot(chord, chord));
  const Vector& first = features_.normal[line_.triangles[i]];
  for (std::size_t k = i; k < j; ++k)
  {
    const Vector& normal = features_.normal[line_.triangles[k]];
    const Vector part = minus(piece.points[line_.nodes[k + 1]], piece.points[line_.nodes[k]]);
    const double partLength = std::sqrt(dot(part, part));
    if (partLength >= shortest_ && !features_.isFold(line_.triangles[k]) &&
      (dot(normal, first) < mergeCosine_ || dot(part, chord) < mergeCosine_ * length * partLength))
    {
      return false;
    }
  }
  return length >= shortest_ && !passesOver(piece, i, before, j);
}

bool SideTying::isFeature(const BoxSurface& piece, std::size_t node) const
{
  const std::uint32_t a = line_.triangles[node - 1];
  const std::uint32_t b = line_.triangles[node];
  const Point& p = piece.points[line_.nodes[node]];
  return surface_.boundary[a] != surface_.boundary[b] || isSharp(piece, node) ||
    isNextToFeature(p, a) || isNextToFeature(p, b);
}

// Where the surface knows its sharp edges, so do its points, and no angle is asked.
bool SideTying::isSharp(const BoxSurface& piece, std::size_t node) const
{
  if (surface_.knownEdges)
  {
    return !piece.kinds.empty() && piece.kinds[line_.nodes[node]] >= PointKind::OnEdge;
  }
  const std::uint32_t a = line_.triangles[node - 1];
  const std::uint32_t b = line_.triangles[node];
  return !features_.isFold(a) && !features_.isFold(b) &&
    dot(features_.normal[a], features_.normal[b]) < featureCosine_;
}

// A feature may run along a side, just beyond it; then the polyline follows it.
bool SideTying::isNextToFeature(const Point& p, std::uint32_t triangle) const
{
  const Corners corners = surface_.corners(triangle);
  for (unsigned i = 0; i < 3; ++i)
  {
    if (features_.endsIn(triangle, i) && distance(p, corners[i]) < 4 * shortest_)
    {
      return true;
    }
  }
  return false;
}

void SideTying::listFlatNodes(const BoxSurface& piece)
{
  for (const std::uint32_t node : partNodes_)
  {
    flatNodes_.push_back({ flat(piece, node), node });
  }
  std::sort(flatNodes_.begin(), flatNodes_.end(),
    [](const FlatNode& p, const FlatNode& q) { return p.at.a < q.at.a; });
}

// Whether another node lies in the triangle between the chords to the node before and to this one.
bool SideTying::passesOver(
  const BoxSurface& piece, std::size_t i, std::size_t before, std::size_t j)
{
  if (flatNodes_.empty())
  {
    listFlatNodes(piece);
  }
  const PlanePoint a = flat(piece, line_.nodes[i]);
  const PlanePoint b = flat(piece, line_.nodes[before]);
  const PlanePoint c = flat(piece, line_.nodes[j]);
  const int way = sign(turn(a, b, c));
  if (way == 0)
  {
    return false;
  }
  const auto begin = line_.nodes.begin() + static_cast<std::ptrdiff_t>(i);
  const auto end = line_.nodes.begin() + static_cast<std::ptrdiff_t>(j) + 1;
  const auto [least, most] = std::minmax({ a.a, b.a, c.a });
  return std::any_of(std::lower_bound(flatNodes_.begin(), flatNodes_.end(), least,
                       [](const FlatNode& node, std::int64_t level) { return node.at.a < level; }),
    std::upper_bound(flatNodes_.begin(), flatNodes_.end(), most,
      [](std::int64_t level, const FlatNode& node) { return level < node.at.a; }),
    [&](const FlatNode& node) {
      return way * sign(turn(a, b, node.at)) >= 0 && way * sign(turn(b, c, node.at)) >= 0 &&
        way * sign(turn(c, a, node.at)) >= 0 && std::find(begin, end, node.node) == end;
    });
}

// Equation 5: divides the straight line in the same proportions as the polyline.
void SideTying::moveOntoChord(const BoxSurface& piece)
{
  const Point from = piece.points[line_.nodes.front()];
  const Vector chord = minus(piece.points[line_.nodes.back()], from);
  double whole = 0;
  const auto forEachPart = [&](auto&& visit) {
    Point before = from;
    for (std::size_t i = 1; i < line_.nodes.size(); ++i)
    {
      if (line_.keep[i] != 0)
      {
        const Point here = piece.points[line_.nodes[i]];
        visit(i, distance(before, here));
        before = here;
      }
    }
  };
  forEachPart([&](std::size_t, double length) { whole += length; });
  double along = 0;
  forEachPart([&](std::size_t i, double length) {
    along += length;
    if (i + 1 < line_.nodes.size())
    {
      Point p = piece.points[line_.nodes[i]];
      for (std::size_t a = 0; a < 3; ++a)
      {
        p[a] = static_cast<int>(a) == axis_ ? p[a] : oddLevel(from[a] + chord[a] * along / whole);
      }
      moved_.emplace_back(line_.nodes[i], p);
    }
  });
}

}
