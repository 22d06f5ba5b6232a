// SPDX-License-Identifier: BSD-3-Clause
#include "Patches/BoxSurface.h"

#include "Base/Loops.h"

namespace cartesian
{

namespace
{

// Whether a triangle of the global box may meet this box in it.
bool mayMeet(const Corners& c, const Box& box)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (std::max({ c[0][axis], c[1][axis], c[2][axis] }) < box.low[axis] ||
      std::min({ c[0][axis], c[1][axis], c[2][axis] }) > box.high[axis])
    {
      return false;
    }
  }
  return true;
}

// A corner of a fragment between an edge of the triangle and a plane is on that edge, one between two edges in a vertex.
PointKind kindOfCorner(const Fragment& fragment, int i, const Features& features,
  std::uint32_t triangle, const Surface& surface)
{
  const unsigned side = fragment.side[std::size_t(i)];
  const unsigned before = fragment.side[std::size_t(i > 0 ? i : fragment.size) - 1];
  if (std::max(side, before) < Fragment::FirstPlane)
  {
    return features.ofVertex[surface.triangles[triangle][side]];
  }
  const unsigned lines = features.lines(triangle); // planes have no bits there
  return ((lines >> side | lines >> before) & 1) != 0 ? PointKind::OnEdge : PointKind::OnSurface;
}

}

void BoxSurface::clear()
{
  points.clear();
  kinds.clear();
  sizes.clear();
  corners.clear();
  triangles.clear();
  segments.clear();
  sharp = false;
}

void SideLines::find(const Boxes& boxes, const Box& box)
{
  any_ = false;
  if (boxes.globalOf(box).nearDepth == 0)
  {
    return;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const bool upper : { false, true })
    {
      Cross& cross = crosses_[2 * static_cast<std::size_t>(axis) + (upper ? 1 : 0)];
      const std::array<std::uint32_t, 4> across = facing(boxes, box, axis, upper);
      cross.plane =
        upper ? box.high[static_cast<std::size_t>(axis)] : box.low[static_cast<std::size_t>(axis)];
      cross.u = { across[0] != across[1], across[2] != across[3] };
      cross.v = { across[0] != across[2], across[1] != across[3] };
      any_ = any_ || cross.u[0] || cross.u[1] || cross.v[0] || cross.v[1];
    }
  }
  if (any_)
  {
    const FinePoint low = boxes.fineLow(box);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      middle_[axis] =
        planeAt(boxes.planes, axis, low[axis] + Boxes::fineSize(box, static_cast<int>(axis)) / 2);
    }
  }
}

template <class Visitor>
void SideLines::forEachCrossing(
  const Corners& triangle, const Fragment& fragment, int i, Visitor&& visit) const
{
  const auto n = static_cast<std::size_t>(i);
  if (!any_ || fragment.side[n] < Fragment::FirstPlane)
  {
    return;
  }
  const int axis = fragment.side[n] - Fragment::FirstPlane;
  const Point& p = fragment.corner[n];
  const Point& q = fragment.corner[i + 1 < fragment.size ? n + 1 : 0];
  for (const std::size_t side : { 2u * axis, 2u * axis + 1u })
  {
    const Cross& cross = crosses_[side];
    if (cross.plane != p[static_cast<std::size_t>(axis)])
    {
      continue;
    }
    const std::size_t u = (static_cast<std::size_t>(axis) + 1) % 3;
    const std::size_t v = (static_cast<std::size_t>(axis) + 2) % 3;
    Point atU;
    Point atV;
    const bool crossesU = crossing(triangle, p, q, u, v, cross.u, atU);
    const bool crossesV = crossing(triangle, p, q, v, u, cross.v, atV);
    const bool firstU = crossesU && (!crossesV || (atU[u] < atV[u]) == (p[u] < q[u]));
    if (firstU)
    {
      visit(atU);
    }
    if (crossesV)
    {
      visit(atV);
    }
    if (crossesU && !firstU)
    {
      visit(atU);
    }
  }
}

// Finds where pq crosses the middle line across axis u; false if no neighbours meet along that half of it.
bool SideLines::crossing(const Corners& triangle, const Point& p, const Point& q, std::size_t u,
  std::size_t v, const std::array<bool, 2>& halves, Point& at) const
{
  if ((!halves[0] && !halves[1]) || (p[u] < middle_[u]) == (q[u] < middle_[u]))
  {
    return false;
  }
  at = p;
  at[u] = middle_[u];
  at = crossLine(triangle, static_cast<int>(v), at);
  return halves[at[v] < middle_[v] ? 0 : 1];
}

SurfaceCutter::SurfaceCutter(const Surface& surface, const Features& features, const Boxes& boxes,
  const PlaneClearance* clearance)
  : surface_(surface)
  , features_(features)
  , boxes_(boxes)
  , clearance_(clearance)
{
}

void SurfaceCutter::cut(
  const Box& box, const std::uint32_t* begin, const std::uint32_t* end, BoxSurface& result)
{
  result.clear();
  points_.clear();
  kinds_.clear();
  segments_.clear();
  box_ = &box;
  lines_.find(boxes_, box);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::uint32_t i = boxes_.globalOf(box).index[axis];
    const Level low = boxes_.planes[axis][i];
    const Level high = boxes_.planes[axis][i + 1];
    intervals_[axis] = { low, high, clearance_ ? clearance_->of(axis, i) : 0 };
  }
  for (const std::uint32_t* triangle = begin; triangle != end; ++triangle)
  {
    const Corners corners = surface_.corners(*triangle);
    if (mayMeet(corners, box))
    {
      addPolygons(corners, clip(corners, box.low, box.high), *triangle, result);
    }
  }
  keepNetSegments(result);
  keepUsedPoints(result);
}

// Moves a coordinate that is on no plane away from the planes that may divide boxes. All boxes that have the
// point move it in the same way, whatever their sizes.
std::uint32_t SurfaceCutter::addPoint(const Point& exact)
{
  if (!clearance_)
  {
    return points_.add(exact);
  }
  Point p = exact;
  const auto parts = static_cast<std::uint64_t>(boxes_.planes.partsPerBox());
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (onPlane(p[axis]))
    {
      continue;
    }
    const Interval& interval = intervals_[axis];
    const std::uint64_t width = interval.high - interval.low;
    const std::uint64_t scaled = std::uint64_t(p[axis] - interval.low) * parts;
    const std::uint64_t part = scaled / width;
    const std::uint64_t rest = scaled % width;
    const std::uint64_t enough = (std::uint64_t(interval.clearance) + 4) * parts;
    if (rest > enough && width - rest > enough)
    {
      continue; // far from both, however they are rounded
    }
    const std::uint32_t i = boxes_.globalOf(*box_).index[axis];
    for (const std::uint64_t k : { part, part + 1 })
    {
      const Level plane =
        planeAt(boxes_.planes, axis, i, static_cast<std::int64_t>(k * (FinePerBox / parts)));
      const Level distance = p[axis] > plane ? p[axis] - plane : plane - p[axis];
      if (distance < interval.clearance && 4 * std::uint64_t(interval.clearance) * parts < width)
      {
        p[axis] = p[axis] > plane ? plane + interval.clearance : plane - interval.clearance;
      }
    }
  }
  return points_.add(p);
}

void SurfaceCutter::raiseKind(std::uint32_t point, PointKind kind)
{
  if (point >= kinds_.size())
  {
    kinds_.resize(points_.points().size(), PointKind::OnSurface);
  }
  raise(kinds_[point], kind);
}

// Rounding may make corners of a thin fragment coincide; it then falls into simple loops, or vanishes.
void SurfaceCutter::addPolygons(
  const Corners& corners, const Fragment& fragment, std::uint32_t triangle, BoxSurface& result)
{
  walk_.clear();
  std::uint32_t last = None; // the corner before
  const auto addSegmentTo = [&](std::uint32_t to, int i) {
    if (fragment.side[std::size_t(i)] >= Fragment::FirstPlane)
    {
      const int axis = fragment.side[std::size_t(i)] - Fragment::FirstPlane;
      const bool upper =
        fragment.corner[std::size_t(i)][std::size_t(axis)] == box_->high[std::size_t(axis)];
      addSegment(last, to, triangle, static_cast<std::uint8_t>(2 * axis + (upper ? 1 : 0)));
    }
    else if (last != to && features_.isSharp(triangle, fragment.side[std::size_t(i)]))
    {
      result.sharp = true;
    }
  };
  const bool touchesFeature = features_.touchesFeature(triangle);
  for (int i = 0; i < fragment.size; ++i)
  {
    const std::uint32_t corner = addPoint(fragment.corner[std::size_t(i)]);
    if (touchesFeature)
    {
      const PointKind kind = kindOfCorner(fragment, i, features_, triangle, surface_);
      if (kind != PointKind::OnSurface)
      {
        raiseKind(corner, kind);
      }
    }
    if (i > 0)
    {
      addSegmentTo(corner, i - 1);
    }
    last = corner;
    walk_.push_back(corner);
    lines_.forEachCrossing(corners, fragment, i, [&](const Point& p) {
      const std::uint32_t between = addPoint(p);
      addSegmentTo(between, i);
      last = between;
      walk_.push_back(between);
    });
  }
  if (fragment.size > 0)
  {
    addSegmentTo(walk_.front(), fragment.size - 1);
  }
  forEachSimpleLoop(walk_, [&](const std::uint32_t* begin, const std::uint32_t* end) {
    result.corners.insert(result.corners.end(), begin, end);
    result.sizes.push_back(static_cast<std::uint32_t>(end - begin));
    result.triangles.push_back(triangle);
  });
}

void SurfaceCutter::addSegment(
  std::uint32_t from, std::uint32_t to, std::uint32_t triangle, std::uint8_t side)
{
  if (from == to)
  {
    return;
  }
  std::uint8_t quarter = 0;
  if (lines_.any())
  {
    const std::size_t u = (side / 2u + 1) % 3;
    const std::size_t v = (side / 2u + 2) % 3;
    const Point& p = points_.points()[from];
    const Point& q = points_.points()[to];
    const bool right = std::max(p[u], q[u]) > lines_.middle()[u];
    const bool above = std::max(p[v], q[v]) > lines_.middle()[v];
    quarter = static_cast<std::uint8_t>((right ? 1 : 0) + (above ? 2 : 0));
  }
  segments_.push_back({ from, to, triangle, side, quarter });
}

// Drops segments that run both ways between the same points: they bound nothing.
void SurfaceCutter::keepNetSegments(BoxSurface& result)
{
  next_.assign(points_.points().size(), None);
  bool simple = true;
  for (const Segment& s : segments_)
  {
    simple = simple && next_[s.from] == None;
    next_[s.from] = s.to;
  }
  for (const Segment& s : segments_)
  {
    simple = simple && next_[s.to] != s.from;
  }
  if (!simple)
  {
    const auto lowest = [](const Segment& s) { return std::minmax(s.from, s.to); };
    std::stable_sort(segments_.begin(), segments_.end(),
      [&](const Segment& s, const Segment& t) { return lowest(s) < lowest(t); });
    std::size_t kept = 0;
    for (const Segment& s : segments_)
    {
      // Of segments between the same points, the surplus in one direction is kept.
      if (kept > 0 && segments_[kept - 1].from == s.to && segments_[kept - 1].to == s.from)
      {
        --kept;
      }
      else
      {
        segments_[kept++] = s;
      }
    }
    segments_.resize(kept);
  }
  result.segments = segments_;
}

void SurfaceCutter::keepUsedPoints(BoxSurface& result)
{
  next_.assign(points_.points().size(), None);
  const auto use = [&](std::uint32_t& local) {
    if (next_[local] == None)
    {
      next_[local] = static_cast<std::uint32_t>(result.points.size());
      result.points.push_back(points_.points()[local]);
    }
    local = next_[local];
  };
  for (std::uint32_t& corner : result.corners)
  {
    use(corner);
  }
  for (Segment& segment : result.segments)
  {
    use(segment.from);
    use(segment.to);
  }
  result.kinds.assign(kinds_.empty() ? 0 : result.points.size(), PointKind::OnSurface);
  for (std::size_t i = 0; i < kinds_.size(); ++i)
  {
    if (next_[i] != None)
    {
      result.kinds[next_[i]] = kinds_[i];
    }
  }
}

}
