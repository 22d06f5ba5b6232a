// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/RefinedRegion.h"

#include "Base/Error.h"
#include "Repair/SurfaceCheck.h"

#include <cmath>

namespace cartesian
{

namespace
{

Lattice latticeFor(const RefinementRegion& region, const Lattice& ofGrid, const Meshlines& planes)
{
  Bounds bounds = boundsOf(region.surface);
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds.include(axis, ofGrid.position(axis, planes[axis].front()));
    bounds.include(axis, ofGrid.position(axis, planes[axis].back()));
  }
  return Lattice(bounds);
}

Meshlines planesOn(const Lattice& own, const Meshlines& planes, const Lattice& ofGrid)
{
  Meshlines result;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const Level level : planes[axis])
    {
      const Level plane = own.plane(axis, ofGrid.position(axis, level));
      result[axis].push_back(
        result[axis].empty() ? plane : std::max(plane, result[axis].back() + 2));
    }
  }
  return result;
}

Surface closedSurface(const RefinementRegion& region, const Lattice& lattice, Execution& execution)
{
  Surface closed = onLattice(region.surface, lattice, execution);
  const SurfaceCheck surfaceCheck = check(SurfaceEdges(closed, execution), execution);
  if (!surfaceCheck.closed())
  {
    throw Error(Fault::FlawedSurface,
      "The surface of Refinement Regions has " + std::to_string(surfaceCheck.openEdges) +
        " open edges: connect closed surfaces only.");
  }
  return closed;
}

// Calls visit(number, position) for the 2^level cubed parts of a global box, x fastest.
template <class Visitor>
void forEachCube(int level, Visitor&& visit)
{
  const std::size_t n = std::size_t(1) << level;
  std::array<std::size_t, 3> at;
  std::size_t number = 0;
  for (at[2] = 0; at[2] < n; ++at[2])
  {
    for (at[1] = 0; at[1] < n; ++at[1])
    {
      for (at[0] = 0; at[0] < n; ++at[0])
      {
        visit(number++, at);
      }
    }
  }
}

// The number of the part of this level that contains the unit at this position.
std::size_t cubeAround(const std::array<std::size_t, 3>& at, int unitDepth, int level)
{
  const int shift = unitDepth - level;
  return at[0] >> shift | at[1] >> shift << level | at[2] >> shift << 2 * level;
}

}

RefinedRegion::RefinedRegion(const RefinementRegion& region, const Lattice& lattice,
  const Meshlines& planes, Execution& execution)
  : RefinedRegion(region, lattice, latticeFor(region, lattice, planes), planes, execution)
{
}

RefinedRegion::RefinedRegion(const RefinementRegion& region, const Lattice& ofGrid,
  const Lattice& own, const Meshlines& planes, Execution& execution)
  : depth_(region.depth)
  , surface_(closedSurface(region, own, execution))
  , planes_(planesOn(own, planes, ofGrid))
  , shoeboxes_(fillShoeboxes(surface_, planes_, execution))
  , statuses_(surface_, planes_, shoeboxes_, execution)
  , touched_(static_cast<std::int64_t>(planes[0].size()) - 1,
      static_cast<std::int64_t>(planes[1].size()) - 1,
      static_cast<std::int64_t>(planes[2].size()) - 1)
{
  low_ = high_ = surface_.vertices.front();
  for (const Point& p : surface_.vertices)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      low_[axis] = std::min(low_[axis], p[axis]);
      high_[axis] = std::max(high_[axis], p[axis]);
    }
  }
  for (std::uint32_t k = 0; k + 1 < planes[2].size(); ++k)
  {
    for (std::uint32_t j = 0; j + 1 < planes[1].size(); ++j)
    {
      statuses_.forEachBox(j, k, [&](std::uint32_t i, BoxStatus) { touched_.insert(i, j, k); });
    }
  }
}

TriangleRange RefinedRegion::trianglesOf(std::int64_t i, std::int64_t j, std::int64_t k) const
{
  const auto row = static_cast<std::size_t>(j + k * (std::int64_t(planes_[1].size()) - 1));
  return shoeboxes_.triangles(row, static_cast<std::uint32_t>(i));
}

// Whether a global box cannot be divided on the region's lattice, which is coarser than the grid's
// if the region is far larger.
bool RefinedRegion::isTooThin(std::int64_t i, std::int64_t j, std::int64_t k) const
{
  const std::array<std::int64_t, 3> at = { i, j, k };
  bool result = false;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto low = static_cast<std::size_t>(at[axis]);
    result = result || planes_[axis][low + 1] - planes_[axis][low] < leastWidth(depth_);
  }
  return result;
}

// Most borders pass through the middle of a global box; but a region may be far smaller.
double RefinedRegion::shareOf(std::int64_t i, std::int64_t j, std::int64_t k) const
{
  constexpr double OfABorder = 0.5;
  const std::array<std::int64_t, 3> at = { i, j, k };
  double share = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto n = static_cast<std::size_t>(at[axis]);
    const double low = planes_[axis][n];
    const double width = planes_[axis][n + 1] - low;
    const double common =
      std::min(low + width, double(high_[axis])) - std::max(low, double(low_[axis]));
    share *= std::min(1.0, std::max(0.0, common) / width + std::ldexp(1, -depth_));
  }
  return std::min(OfABorder, share);
}

BoxStatus RefinedRegion::status(std::int64_t i, std::int64_t j, std::int64_t k) const
{
  if (!touched_.contains(i, j, k))
  {
    return BoxStatus::Outside;
  }
  const TriangleRange triangles = trianglesOf(i, j, k);
  const bool whole = triangles.first == triangles.second || isTooThin(i, j, k);
  return whole ? BoxStatus::Inside : BoxStatus::Intersected;
}

RefinedRegion::Part RefinedRegion::in(const std::array<std::uint32_t, 3>& index) const
{
  const TriangleRange triangles = trianglesOf(index[0], index[1], index[2]);
  return { this, { triangles.first, triangles.second }, statuses_.lowCorner(index) };
}

void RefinedRegion::raise(const Part& part, const std::array<std::uint32_t, 3>& index,
  const Cube& cube, int bits, UnitStatuses& statuses, std::vector<std::uint8_t>& forced) const
{
  const int finest = std::min(depth_ - cube.level, bits);
  statuses.compute(surface_,
    { part.triangles.data(), part.triangles.data() + part.triangles.size() }, planes_, index, cube,
    finest, part.low);
  // Of each level from the deepest up: whether the region touches the boxes of that level.
  std::vector<bool> touched;
  for (const BoxStatus status : statuses.units())
  {
    touched.push_back(status != BoxStatus::Outside);
  }
  for (int level = finest; level > 0; --level)
  {
    const auto depth = static_cast<std::uint8_t>(level == finest ? depth_ : cube.level + level);
    std::vector<bool> coarser(std::size_t(1) << 3 * (level - 1));
    forEachCube(bits, [&](std::size_t unit, const std::array<std::size_t, 3>& at) {
      if (touched[cubeAround(at, bits, level)])
      {
        forced[unit] = std::max(forced[unit], depth);
        coarser[cubeAround(at, bits, level - 1)] = true;
      }
    });
    touched.swap(coarser);
  }
}

}
