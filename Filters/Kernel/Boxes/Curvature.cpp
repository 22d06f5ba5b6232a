// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/Curvature.h"

#include "Base/DisjointSets.h"
#include "Boxes/OctantSearch.h"
#include "Surface/Features.h"
#include "Surface/SurfaceEdges.h"

namespace cartesian
{

namespace
{

// The contents of an octant.
struct Content
{
  std::vector<std::uint32_t> triangles; // ascending
  bool sharp = false;                   // a sharp edge passes through
};

struct Scratch
{
  std::array<Content, DeepestLevel + 1> ofLevel;
  std::vector<std::pair<std::uint32_t, std::uint32_t>>
    corners;                // their fans, and which triangle it is
  DisjointSets sheets;      // triangles that have fans in common
  std::vector<Vector> sums; // of normals, by sheet
};

class Bends
{
public:
  Bends(const BendSpec& spec, const Surface& surface, const Meshlines& planes,
    const Octants& octants, Execution& execution)
    : spec_(spec)
    , surface_(surface)
    , planes_(planes)
    , octants_(octants)
    , features_(findFeatures(surface, spec.featureAngle, execution))
    , leastCosine_(std::cos(radians(spec.angle)))
    , halfCosine_(std::cos(radians(spec.angle / 2)))
  {
    if (spec.angle > 0)
    {
      findFans(execution);
    }
  }

  void find(const Octant& global, const TriangleRange& triangles, Scratch& scratch,
    std::vector<Octants::Key>& found) const
  {
    gather(global, triangles, scratch.ofLevel[0]);
    divide(global, spec_.depths(global.global), scratch, found);
  }

private:
  // A fan is the corners of triangles around a vertex, as far as smooth edges connect them.
  void findFans(Execution& execution)
  {
    const std::size_t triangles = surface_.triangles.size();
    DisjointSets corners(3 * triangles);
    const SurfaceEdges edges(surface_, execution);
    edges.forEach([&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
      if (end - begin == 2 && !isSharp(lower, begin[0]) && !isSharp(lower, begin[1]))
      {
        for (const std::uint32_t vertex : { lower, begin->upper })
        {
          corners.unite(
            cornerAt(begin[0].triangle(), vertex), cornerAt(begin[1].triangle(), vertex));
        }
      }
    });
    fans_.resize(triangles);
    for (std::uint32_t t = 0; t < triangles; ++t)
    {
      fans_[t] = { corners.find(3 * t), corners.find(3 * t + 1), corners.find(3 * t + 2) };
    }
  }

  std::uint32_t cornerAt(std::uint32_t t, std::uint32_t vertex) const
  {
    const auto& corners = surface_.triangles[t];
    return 3 * t + (corners[1] == vertex ? 1 : 0) + (corners[2] == vertex ? 2 : 0);
  }

  bool isSharp(std::uint32_t lower, const EdgeUse& use) const
  {
    const std::uint32_t t = use.triangle();
    return features_.isSharp(t, cornerAt(t, use.down() ? use.upper : lower) - 3 * t);
  }

  void gather(const Octant& octant, const TriangleRange& triangles, Content& content) const
  {
    content.triangles.clear();
    content.sharp = false;
    const Point low = lowOf(octant, planes_);
    const Point high = highOf(octant, planes_);
    for (const std::uint32_t* t = triangles.first; t != triangles.second; ++t)
    {
      const Corners corners = surface_.corners(*t);
      if (!looksAt(*t) || isBeside(corners, low, high))
      {
        continue;
      }
      const Fragment fragment = clip(corners, low, high);
      if (fragment.size > 0)
      {
        content.triangles.push_back(*t);
        content.sharp = content.sharp || hasSharpSide(*t, fragment);
      }
    }
  }

  bool looksAt(std::uint32_t t) const { return spec_.looksAt.empty() || spec_.looksAt[t] != 0; }

  static bool isBeside(const Corners& c, const Point& low, const Point& high)
  {
    bool beside = false;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto [least, most] = std::minmax({ c[0][axis], c[1][axis], c[2][axis] });
      beside = beside || most < low[axis] || least > high[axis];
    }
    return beside;
  }

  bool hasSharpSide(std::uint32_t t, const Fragment& fragment) const
  {
    bool sharp = false;
    for (std::size_t i = 0; i < static_cast<std::size_t>(fragment.size); ++i)
    {
      sharp = sharp ||
        (fragment.side[i] < Fragment::FirstPlane && features_.isSharp(t, fragment.side[i]));
    }
    return sharp;
  }

  // `depths`: there are such boxes anyway, and the largest for the angle.
  void divide(const Octant& octant, const std::pair<int, int>& depths, Scratch& scratch,
    std::vector<Octants::Key>& found) const
  {
    const Content& here = scratch.ofLevel[static_cast<std::size_t>(octant.level)];
    const bool isForSharp = here.sharp && octant.level < spec_.featureDepth;
    if (!isForSharp && (octant.level >= depths.second || !bends(here, scratch)))
    {
      return;
    }
    const TriangleRange triangles{ here.triangles.data(),
      here.triangles.data() + here.triangles.size() };
    for (unsigned which = 0; which < 8; ++which)
    {
      const Octant part = octant.part(which);
      Content& content = scratch.ofLevel[static_cast<std::size_t>(part.level)];
      gather(part, triangles, content);
      if (!content.triangles.empty())
      {
        if (part.level > depths.first)
        {
          found.push_back(octants_.keyOf(part));
        }
        divide(part, depths, scratch, found);
      }
    }
  }

  // Of two normals that are too far apart, one is more than half as far from any third.
  bool bends(const Content& content, Scratch& scratch) const
  {
    const std::vector<std::uint32_t>& triangles = content.triangles;
    if (spec_.angle <= 0)
    {
      return false;
    }
    findSheets(triangles, scratch);
    for (std::uint32_t a = 0; a < triangles.size(); ++a)
    {
      const Vector& normal = features_.normal[triangles[a]];
      const std::uint32_t sheet = scratch.sheets.find(a);
      if (dot(normal, unit(scratch.sums[sheet])) >= halfCosine_ || dot(normal, normal) == 0)
      {
        continue;
      }
      for (std::uint32_t b = 0; b < triangles.size(); ++b)
      {
        const Vector& other = features_.normal[triangles[b]];
        if (scratch.sheets.find(b) == sheet && dot(other, other) > 0 &&
          dot(normal, other) < leastCosine_)
        {
          return true;
        }
      }
    }
    return false;
  }

  void findSheets(const std::vector<std::uint32_t>& triangles, Scratch& scratch) const
  {
    scratch.corners.clear();
    for (std::uint32_t a = 0; a < triangles.size(); ++a)
    {
      for (const std::uint32_t fan : fans_[triangles[a]])
      {
        scratch.corners.emplace_back(fan, a);
      }
    }
    std::sort(scratch.corners.begin(), scratch.corners.end());
    scratch.sheets.reset(triangles.size());
    for (std::size_t i = 1; i < scratch.corners.size(); ++i)
    {
      if (scratch.corners[i].first == scratch.corners[i - 1].first)
      {
        scratch.sheets.unite(scratch.corners[i].second, scratch.corners[i - 1].second);
      }
    }
    scratch.sums.assign(triangles.size(), {});
    for (std::uint32_t a = 0; a < triangles.size(); ++a)
    {
      Vector& sum = scratch.sums[scratch.sheets.find(a)];
      sum = plus(sum, features_.normal[triangles[a]]);
    }
  }

  const BendSpec& spec_;
  const Surface& surface_;
  const Meshlines& planes_;
  const Octants& octants_;
  const Features features_;
  const double leastCosine_;
  const double halfCosine_;
  std::vector<std::array<std::uint32_t, 3>> fans_; // of each triangle's corners
};

}

void addBends(const BendSpec& spec, const Surface& surface, const Shoeboxes& shoeboxes,
  const Meshlines& planes, Octants& octants, Execution& execution)
{
  const Bends bends(spec, surface, planes, octants, execution);
  std::vector<std::vector<Octants::Key>> found = findOctants<Scratch>(shoeboxes, planes, execution,
    [&](const std::array<std::uint32_t, 3>& box, const TriangleRange& triangles, Scratch& scratch,
      std::vector<Octants::Key>& mine) { bends.find({ box }, triangles, scratch, mine); });
  octants.add(found);
}

}
