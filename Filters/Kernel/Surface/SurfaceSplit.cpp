// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/SurfaceSplit.h"

#include "Base/DisjointSets.h"
#include "Surface/Caps.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace cartesian
{

namespace
{

constexpr std::uint32_t None = ~std::uint32_t(0);

// Sizes and places that differ by less, relative to the surface, count as equal when patches are numbered: equal
// ends of a duct must not change their order with the rounding of sums.
constexpr double SameOrder = 1e-7;

double sizeOf(const Bounds& bounds)
{
  Vector diagonal;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    diagonal[axis] = bounds.high[axis] - bounds.low[axis];
  }
  return norm(diagonal);
}

class Splitter
{
public:
  Splitter(const SurfaceView& view, const SplitSpec& spec, Execution& execution)
    : view_(view)
    , spec_(spec)
    , execution_(execution)
    , bounds_(boundsOf(view, execution))
    , surface_(onLattice(view, Lattice(bounds_), execution))
    , edges_(surface_, execution)
    , sets_(surface_.triangles.size())
  {
  }

  SurfaceSplit split()
  {
    execution_.stage("Patches of the surface", 0.5, 1);
    if (spec_.by == SplitBy::ConnectedParts)
    {
      edges_.forEach([&](std::uint32_t /*lower*/, const EdgeUse* begin, const EdgeUse* end) {
        uniteAll(begin, end);
      });
    }
    else if (spec_.by != SplitBy::Boundaries)
    {
      if (spec_.by == SplitBy::FeatureAngle)
      {
        surface_.knownEdges = nullptr;
      }
      features_ = findFeatures(surface_, spec_.featureAngle, execution_);
      edges_.forEach([&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
        uniteSmooth(lower, begin, end);
      });
    }
    uniteThoseWithoutArea();
    number();
    const std::vector<PatchShape> shapes = shapesOf(view_, surface_, patchOf_, patches_.size());
    for (std::size_t patch = 0; patch < patches_.size(); ++patch)
    {
      patches_[patch].area = shapes[patch].size;
      patches_[patch].centre = shapes[patch].centre;
    }
    joinTheRest(shapes);
    return inOrder();
  }

private:
  bool areOfOneBoundary(std::uint32_t a, std::uint32_t b) const
  {
    return surface_.boundary[a] == surface_.boundary[b];
  }

  void uniteAll(const EdgeUse* begin, const EdgeUse* end)
  {
    for (const EdgeUse* a = begin; a != end; ++a)
    {
      for (const EdgeUse* b = a + 1; b != end; ++b)
      {
        if (areOfOneBoundary(a->triangle(), b->triangle()))
        {
          sets_.unite(a->triangle(), b->triangle());
        }
      }
    }
  }

  void uniteSmooth(std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end)
  {
    const bool joins = end - begin == 2 && begin->down() != begin[1].down();
    if (joins && areOfOneBoundary(begin->triangle(), begin[1].triangle()) &&
      !features_.isSharp(begin->triangle(), edgeOf(surface_, *begin, lower)))
    {
      sets_.unite(begin->triangle(), begin[1].triangle());
    }
  }

  bool hasArea(std::uint32_t t) const
  {
    const Corners c = surface_.corners(t);
    const Vector twice = cross(minus(c[1], c[0]), minus(c[2], c[0]));
    return dot(twice, twice) > 0;
  }

  // They belong to a neighbour at their longest edge, or to a triangle at a vertex: an edge that turns at them turns there.
  void uniteThoseWithoutArea()
  {
    std::map<std::uint32_t, std::uint32_t>
      at; // a triangle at each vertex of one that has no neighbours
    std::vector<std::uint32_t> alone;
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
    {
      if (namesAVertexTwice(surface_.triangles[t]))
      {
        alone.push_back(t);
        at.emplace(surface_.triangles[t][0], None);
      }
    }
    for (std::uint32_t t = 0; !at.empty() && t < surface_.triangles.size(); ++t)
    {
      for (const std::uint32_t v : surface_.triangles[t])
      {
        const auto found = at.find(v);
        if (found != at.end() && found->second == None && hasArea(t))
        {
          found->second = t;
        }
      }
    }
    for (const std::uint32_t t : alone)
    {
      const std::uint32_t other = at[surface_.triangles[t][0]];
      if (other != None && areOfOneBoundary(t, other))
      {
        sets_.unite(t, other);
      }
    }
    edges_.forEach([&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
      uniteAtLongestEdge(lower, begin, end);
    });
  }

  void uniteAtLongestEdge(std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end)
  {
    for (const EdgeUse* use = begin; end - begin == 2 && use != end; ++use)
    {
      const std::uint32_t t = use->triangle();
      const std::uint32_t other = begin[use == begin].triangle();
      if (areOfOneBoundary(t, other) && !hasArea(t) && isLongest(t, lower, use->upper))
      {
        sets_.unite(t, other);
      }
    }
  }

  bool isLongest(std::uint32_t t, std::uint32_t a, std::uint32_t b) const
  {
    const auto length = [&](std::uint32_t u, std::uint32_t v) {
      return norm(minus(surface_.vertices[u], surface_.vertices[v]));
    };
    const auto& v = surface_.triangles[t];
    return length(a, b) >= std::max({ length(v[0], v[1]), length(v[1], v[2]), length(v[2], v[0]) });
  }

  // Patches, from the lowest triangle of each. As they are, boundaries need not be connected.
  void number()
  {
    patchOf_.resize(surface_.triangles.size());
    std::vector<std::uint32_t> ofSet(surface_.triangles.size(), None);
    std::map<std::int32_t, std::uint32_t> ofBoundary;
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
    {
      const std::int32_t boundary = surface_.boundary[t];
      std::uint32_t& patch = spec_.by == SplitBy::Boundaries
        ? ofBoundary.emplace(boundary, None).first->second
        : ofSet[sets_.find(t)];
      if (patch == None)
      {
        patch = static_cast<std::uint32_t>(patches_.size());
        patches_.emplace_back();
        patches_.back().boundary = boundary;
      }
      patchOf_[t] = patch;
      ++patches_[patch].triangles;
    }
  }

  // Finds what stands by itself; of the rest each boundary has one patch.
  void joinTheRest(const std::vector<PatchShape>& shapes)
  {
    if (spec_.by != SplitBy::FlatCaps && spec_.by != SplitBy::Planes)
    {
      return;
    }
    std::vector<std::uint32_t> into(shapes.size());
    std::iota(into.begin(), into.end(), 0);
    std::vector<std::uint8_t> stands(shapes.size());
    if (spec_.by == SplitBy::FlatCaps)
    {
      stands = findCaps(surface_, edges_, features_, patchOf_, shapes);
    }
    else
    {
      into = planesOf(shapes, sizeOf(bounds_));
      std::transform(shapes.begin(), shapes.end(), stands.begin(),
        [](const PatchShape& shape) { return shape.isFlat; });
    }
    std::map<std::tuple<std::uint32_t, std::int32_t>, std::uint32_t> target; // None: the rest
    for (std::uint32_t patch = 0; patch < shapes.size(); ++patch)
    {
      patches_[patch].standsAlone = stands[patch] != 0;
      const std::uint32_t key = stands[patch] != 0 ? into[patch] : None;
      into[patch] = target.emplace(std::tuple(key, patches_[patch].boundary), patch).first->second;
    }
    join(into);
  }

  void join(const std::vector<std::uint32_t>& into)
  {
    for (std::uint32_t patch = 0; patch < patches_.size(); ++patch)
    {
      const std::uint32_t other = into[patch];
      if (other == patch)
      {
        continue;
      }
      SurfacePatch& to = patches_[other];
      SurfacePatch& from = patches_[patch];
      const double area = to.area + from.area;
      if (area > 0)
      {
        to.centre =
          scaled(plus(scaled(to.centre, to.area), scaled(from.centre, from.area)), 1 / area);
      }
      to.area = area;
      to.triangles += from.triangles;
      from.triangles = 0;
    }
    for (std::uint32_t& patch : patchOf_)
    {
      patch = into[patch];
    }
  }

  SurfaceSplit inOrder() const
  {
    const double size = std::max(sizeOf(bounds_), 1e-300);
    const auto key = [&](const SurfacePatch& p) {
      const auto place = [&](std::size_t axis) {
        return std::llround((p.centre[axis] - bounds_.low[axis]) / (size * SameOrder));
      };
      return std::tuple(p.boundary, !p.standsAlone,
        -std::llround(p.area / (size * size * SameOrder)), place(0), place(1), place(2));
    };
    std::vector<std::uint32_t> order;
    for (std::uint32_t patch = 0; patch < patches_.size(); ++patch)
    {
      if (patches_[patch].triangles > 0)
      {
        order.push_back(patch);
      }
    }
    std::vector<decltype(key(patches_.front()))> keys;
    std::transform(patches_.begin(), patches_.end(), std::back_inserter(keys), key);
    std::stable_sort(order.begin(), order.end(),
      [&](std::uint32_t a, std::uint32_t b) { return keys[a] < keys[b]; });
    SurfaceSplit result;
    std::vector<std::uint32_t> place(patches_.size());
    for (const std::uint32_t patch : order)
    {
      place[patch] = static_cast<std::uint32_t>(result.patches.size());
      result.patches.push_back(patches_[patch]);
    }
    result.patchOf.resize(patchOf_.size());
    for (std::size_t t = 0; t < patchOf_.size(); ++t)
    {
      result.patchOf[surface_.given[t]] = place[patchOf_[t]];
    }
    return result;
  }

  const SurfaceView& view_;
  const SplitSpec& spec_;
  Execution& execution_;
  Bounds bounds_;
  Surface surface_;
  SurfaceEdges edges_;
  Features features_;
  DisjointSets sets_; // of triangles
  std::vector<std::uint32_t> patchOf_;
  std::vector<SurfacePatch> patches_;
};

}

SurfaceSplit splitSurface(const SurfaceView& view, const SplitSpec& spec, Execution& execution)
{
  execution.stage("Points of the surface", 0, 0.5);
  return Splitter(view, spec, execution).split();
}

}
