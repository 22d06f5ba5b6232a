// SPDX-License-Identifier: BSD-3-Clause
#include "Collapse/CollapseChecks.h"

#include <cmath>

namespace cartesian
{

namespace
{

// How far a node may leave the planes of its faces, as a part of the box's shortest edge. Smooth
// surfaces are approximated by a few times as much; edges of the surface keep their places.
constexpr double SmoothError = 2e-2;
constexpr double FeatureError = 2e-5;

// ... in levels: mere rounding.
constexpr double RoundingLevels = 0.9;

// Cosine of the angle that a face may tilt by, and the part of its area by which it may fold back.
constexpr double LeastTilt = 0.5;
constexpr double RoundingOfAreas = 1e-9;

}

CollapseChecks::CollapseChecks(const Boxes& boxes, const EdgeCollapseSpec& spec,
  const Patches& patches, const MergingNodes& merging)
  : boxes_(boxes)
  , spec_(spec)
  , patches_(patches)
  , merging_(merging)
  , featureCosine_(std::cos(radians(spec.featureAngle)))
{
}

// Nodes at the ends of the grid stay there.
bool CollapseChecks::staysOnGrid(const Point& from, const Point& to) const
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto& planes = boxes_.planes[axis];
    const bool atEnd = from[axis] == planes.front() || from[axis] == planes.back();
    if (atEnd && to[axis] != from[axis])
    {
      return false;
    }
  }
  return true;
}

bool CollapseChecks::isOnSurface(std::uint32_t slot)
{
  return merging_.anyFaceAt(slot, [&](std::uint32_t face) {
    if (!merging_.isPatch(face))
    {
      return false;
    }
    merging_.ringOf(face, ring_);
    return ring_.size() > 2 && norm(merging_.areaOf(ring_)) > 0;
  });
}

bool CollapseChecks::mayMove(std::uint32_t slot, const Point& to, double unit)
{
  const Point& from = merging_[slot].at;
  if (!staysOnGrid(from, to))
  {
    return false;
  }
  if (spec_.exact)
  {
    return !isOnSurface(slot);
  }
  normals_.clear();
  borders_.clear();
  double error = 0;
  bool feature = false;
  std::int32_t boundary = NoBoundary;
  merging_.forEachFaceAt(slot, [&](std::uint32_t face) {
    if (!merging_.isPatch(face))
    {
      return;
    }
    merging_.ringOf(face, ring_);
    if (ring_.size() < 3)
    {
      return;
    }
    const Vector normal = cartesian::unit(merging_.areaOf(ring_));
    if (dot(normal, normal) == 0)
    {
      return;
    }
    error = std::max(error, std::abs(dot(minus(to, from), normal)));
    feature = feature || (!normals_.empty() && patches_.boundary[face] != boundary);
    boundary = patches_.boundary[face];
    for (const Vector& other : normals_)
    {
      feature = feature || dot(other, normal) < featureCosine_;
    }
    normals_.push_back(normal);
    listBorders(slot, face);
  });
  error = std::max(error, distanceFromBorders(slot, to));
  return error <= std::max(RoundingLevels, (feature ? FeatureError : SmoothError) * unit);
}

bool CollapseChecks::keepsWalls(std::uint32_t slot, std::uint32_t to)
{
  if (!patches_.walls.any())
  {
    return true;
  }
  listWalls(slot, walls_[0]);
  listWalls(to, walls_[1]);
  return std::includes(walls_[1].begin(), walls_[1].end(), walls_[0].begin(), walls_[0].end());
}

// In order, each once.
void CollapseChecks::listWalls(std::uint32_t slot, std::vector<std::int32_t>& walls)
{
  walls.clear();
  merging_.forEachFaceAt(slot, [&](std::uint32_t face) {
    if (merging_.isPatch(face))
    {
      walls.push_back(patches_.boundary[face]);
    }
  });
  std::sort(walls.begin(), walls.end());
  walls.erase(std::unique(walls.begin(), walls.end()), walls.end());
}

double CollapseChecks::bendAt(std::uint32_t slot)
{
  normals_.clear();
  double least = 1;
  merging_.forEachFaceAt(slot, [&](std::uint32_t face) {
    if (!merging_.isPatch(face))
    {
      return;
    }
    merging_.ringOf(face, ring_);
    if (ring_.size() < 3)
    {
      return;
    }
    const Vector normal = cartesian::unit(merging_.areaOf(ring_));
    for (const Vector& other : normals_)
    {
      least = std::min(least, dot(other, normal));
    }
    normals_.push_back(normal);
  });
  return normals_.empty() ? 2 : least;
}

// Notes the boundaries at the edges of a patch (its corners are in ring_) that end at a node.
void CollapseChecks::listBorders(std::uint32_t slot, std::uint32_t face)
{
  for (std::size_t i = 0; i < ring_.size(); ++i)
  {
    if (ring_[i] == merging_[slot].node)
    {
      for (const std::size_t k :
        { i + 1 < ring_.size() ? i + 1 : 0, i > 0 ? i - 1 : ring_.size() - 1 })
      {
        borders_.emplace_back(ring_[k], patches_.boundary[face]);
      }
    }
  }
}

// How far a place is from the lines along which two boundaries meet at a node.
double CollapseChecks::distanceFromBorders(std::uint32_t slot, const Point& to)
{
  std::sort(borders_.begin(), borders_.end());
  const Vector way = minus(to, merging_[slot].at);
  double distance = 0;
  for (std::size_t i = 0; i + 1 < borders_.size(); ++i)
  {
    if (borders_[i].first == borders_[i + 1].first && borders_[i].second != borders_[i + 1].second)
    {
      const Vector along =
        cartesian::unit(minus(merging_.placeOf(borders_[i].first), merging_[slot].at));
      distance = std::max(distance, norm(cross(way, along)));
    }
  }
  return distance;
}

// Calls visit(node) for the neighbours of a node along the faces around it; they come several times.
template <class Visitor>
void CollapseChecks::forEachNeighbour(std::uint32_t slot, Visitor&& visit)
{
  merging_.forEachFaceAt(slot, [&](std::uint32_t face) {
    merging_.ringOf(face, ring_);
    for (std::size_t i = 0; ring_.size() > 2 && i < ring_.size(); ++i)
    {
      if (ring_[i] == merging_[slot].node)
      {
        visit(ring_[i + 1 < ring_.size() ? i + 1 : 0]);
        visit(ring_[i > 0 ? i - 1 : ring_.size() - 1]);
      }
    }
  });
}

bool CollapseChecks::closesUp(std::uint32_t a, std::uint32_t b)
{
  const std::uint32_t nodeA = merging_[a].node;
  const std::uint32_t nodeB = merging_[b].node;
  near_.clear();
  thirds_.clear();
  merging_.forEachFaceAt(a, [&](std::uint32_t face) {
    merging_.ringOf(face, ring_);
    const bool isTriangle = ring_.size() == 3;
    if (isTriangle && std::find(ring_.begin(), ring_.end(), nodeB) != ring_.end())
    {
      thirds_.insert(thirds_.end(), ring_.begin(), ring_.end());
    }
  });
  forEachNeighbour(a, [&](std::uint32_t node) { near_.push_back(node); });
  bool good = true;
  forEachNeighbour(b, [&](std::uint32_t node) {
    good = good &&
      (node == nodeA || std::find(near_.begin(), near_.end(), node) == near_.end() ||
        std::find(thirds_.begin(), thirds_.end(), node) != thirds_.end());
  });
  return good;
}

// The same for faces with the same corners, in whatever order.
std::uint64_t CollapseChecks::keyOfRing() const
{
  std::uint64_t sum = 0;
  for (const std::uint32_t node : ring_)
  {
    std::uint64_t bits = (node + 1) * 0x9e3779b97f4a7c15u;
    bits = (bits ^ (bits >> 29)) * 0xbf58476d1ce4e5b9u;
    sum += bits ^ (bits >> 32);
  }
  return sum;
}

// Whether a face (its corners are in ring_) is gone, or is star-shaped and still faces the same way.
bool CollapseChecks::isGood(std::uint32_t face) const
{
  if (ring_.size() < 3)
  {
    return true;
  }
  for (std::size_t i = 0; i < ring_.size(); ++i)
  {
    if (std::find(ring_.begin() + static_cast<std::ptrdiff_t>(i) + 1, ring_.end(), ring_[i]) !=
      ring_.end())
    {
      return false;
    }
  }
  const Vector before = merging_.originalArea(face);
  const Vector now = merging_.areaOf(ring_);
  const double size = norm(now);
  if (!(dot(before, now) > LeastTilt * norm(before) * size))
  {
    return false;
  }
  Vector mean{ 0, 0, 0 };
  const Point& origin = merging_.placeOf(ring_[0]);
  for (const std::uint32_t node : ring_)
  {
    mean = plus(mean, minus(merging_.placeOf(node), origin));
  }
  mean = scaled(mean, 1.0 / static_cast<double>(ring_.size()));
  double least = 0;
  for (std::size_t i = 0; i < ring_.size(); ++i)
  {
    const Vector p = minus(minus(merging_.placeOf(ring_[i]), origin), mean);
    const Vector q =
      minus(minus(merging_.placeOf(ring_[i + 1 < ring_.size() ? i + 1 : 0]), origin), mean);
    least = std::min(least, dot(cross(p, q), now));
  }
  return least >= -RoundingOfAreas * size * size;
}

}
