// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/WantedSizes.h"

#include "Lattice/ExactFit.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

constexpr std::size_t GlobalsAChunk = 64;

// Planes of the mesh that a field is of may be those of this one, except for rounding: what is thinner than this part
// of a box overlaps it no more than its neighbour.
constexpr double LeastOverlap = 1e-6;

// Of edges: planes are on even levels, and step aside.
constexpr double Rounding = 1e-6;

// A prescribed size, by its number among the triangles or the boxes of the field, and a global box that it may
// overlap.
struct Wish
{
  std::uint64_t global;
  std::uint32_t asker;

  bool operator<(const Wish& other) const
  {
    return global != other.global ? global < other.global : asker < other.asker;
  }
};

double longestEdge(const Octant& octant, const Meshlines& planes)
{
  const Point low = lowOf(octant, planes);
  const Point high = highOf(octant, planes);
  return std::max({ high[0] - low[0], high[1] - low[1], high[2] - low[2] });
}

// Triangles of the surface.
class SizedTriangles
{
public:
  SizedTriangles(const SizingSpec& spec, const Surface& surface, const Shoeboxes& shoeboxes,
    const Meshlines& planes)
    : sizes_(spec.sizeOfTriangle)
    , surface_(surface)
    , shoeboxes_(shoeboxes)
    , planes_(planes)
  {
  }

  double size(std::uint32_t t) const
  {
    return t < surface_.given.size() ? sizes_[surface_.given[t]] / surface_.lattice.step() : 0;
  }

  std::vector<Wish> wishes() const
  {
    std::vector<Wish> result;
    const std::uint64_t across = planes_[0].size() - 1;
    for (std::size_t row = 0; row + 1 < shoeboxes_.rowStart.size(); ++row)
    {
      for (std::size_t b = shoeboxes_.rowStart[row]; b < shoeboxes_.rowStart[row + 1]; ++b)
      {
        for (std::size_t i = shoeboxes_.triangleStart[b]; i < shoeboxes_.triangleStart[b + 1]; ++i)
        {
          if (const std::uint32_t t = shoeboxes_.triangle[i]; size(t) > 0)
          {
            result.push_back({ shoeboxes_.column[b] + across * row, t });
          }
        }
      }
    }
    return result;
  }

  bool overlaps(std::uint32_t t, const Octant& octant) const
  {
    return clip(surface_.corners(t), lowOf(octant, planes_), highOf(octant, planes_)).size > 0;
  }

private:
  const std::vector<double>& sizes_;
  const Surface& surface_;
  const Shoeboxes& shoeboxes_;
  const Meshlines& planes_;
};

// Boxes around the cells or points of a field.
class SizedBoxes
{
public:
  SizedBoxes(const SizingSpec& spec, const Lattice& lattice, const Meshlines& planes)
    : planes_(planes)
  {
    boxes_.reserve(spec.sizes.size());
    for (const WantedSize& wanted : spec.sizes)
    {
      WantedSize box{ {}, {}, wanted.size / lattice.step() };
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double origin = lattice.origin()[axis];
        box.low[axis] = (wanted.low[axis] - origin) / lattice.step();
        box.high[axis] = (wanted.high[axis] - origin) / lattice.step();
      }
      boxes_.push_back(box);
    }
  }

  double size(std::uint32_t b) const { return boxes_[b].size; }

  std::vector<Wish> wishes() const
  {
    std::vector<Wish> result;
    for (std::uint32_t b = 0; b < boxes_.size(); ++b)
    {
      std::array<std::size_t, 3> first{};
      std::array<std::size_t, 3> end{};
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        first[axis] = intervalAround(axis, boxes_[b].low[axis]);
        end[axis] = intervalAround(axis, boxes_[b].high[axis]) + 1;
      }
      for (std::size_t k = first[2]; k < end[2]; ++k)
      {
        for (std::size_t j = first[1]; j < end[1]; ++j)
        {
          for (std::size_t i = first[0]; i < end[0]; ++i)
          {
            result.push_back(
              { i + (planes_[0].size() - 1) * (j + (planes_[1].size() - 1) * k), b });
          }
        }
      }
    }
    return result;
  }

  bool overlaps(std::uint32_t b, const Octant& octant) const
  {
    const Point low = lowOf(octant, planes_);
    const Point high = highOf(octant, planes_);
    bool overlap = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double least = LeastOverlap * (double(high[axis]) - low[axis]);
      const double from = boxes_[b].low[axis];
      const double to = boxes_[b].high[axis];
      const bool isFlat = to - from <= least;
      overlap = overlap &&
        (isFlat ? from >= low[axis] && from < high[axis]
                : std::min<double>(to, high[axis]) - std::max<double>(from, low[axis]) > least);
    }
    return overlap;
  }

private:
  // The number of the global box along an axis, the first or last for what is beyond.
  std::size_t intervalAround(std::size_t axis, double level) const
  {
    const std::vector<Level>& planes = planes_[axis];
    const auto after = std::upper_bound(planes.begin() + 1, planes.end() - 1, level);
    return static_cast<std::size_t>(after - planes.begin()) - 1;
  }

  const Meshlines& planes_;
  std::vector<WantedSize> boxes_; // in levels
};

template <class Askers>
class Search
{
public:
  Search(const Askers& askers, int largestDepth, const Meshlines& planes, const Octants& octants)
    : askers_(askers)
    , largestDepth_(largestDepth)
    , planes_(planes)
    , octants_(octants)
  {
  }

  std::vector<std::vector<Octants::Key>> find(Execution& execution) const
  {
    std::vector<Wish> wishes = askers_.wishes();
    std::sort(wishes.begin(), wishes.end());
    std::vector<std::size_t> start; // of each global box's wishes, and the end
    for (std::size_t i = 0; i < wishes.size(); ++i)
    {
      if (i == 0 || wishes[i].global != wishes[i - 1].global)
      {
        start.push_back(i);
      }
    }
    const std::size_t globals = start.size();
    start.push_back(wishes.size());
    std::vector<std::vector<Octants::Key>> found(chunks(globals, GlobalsAChunk));
    execution.forEach(globals, GlobalsAChunk, [&](std::size_t begin, std::size_t end) {
      std::array<std::vector<std::uint32_t>, DeepestLevel + 1> ofLevel;
      for (std::size_t g = begin; g < end; ++g)
      {
        ofLevel[0].clear();
        const Octant octant = globalBox(wishes[start[g]].global);
        for (std::size_t i = start[g]; i < start[g + 1]; ++i)
        {
          addIfSmaller(wishes[i].asker, octant, ofLevel[0]);
        }
        divide(octant, ofLevel, found[begin / GlobalsAChunk]);
      }
    });
    return found;
  }

private:
  using Contents = std::array<std::vector<std::uint32_t>, DeepestLevel + 1>;

  Octant globalBox(std::uint64_t number) const
  {
    const std::uint64_t alongX = planes_[0].size() - 1;
    const std::uint64_t alongY = planes_[1].size() - 1;
    return { { static_cast<std::uint32_t>(number % alongX),
      static_cast<std::uint32_t>(number / alongX % alongY),
      static_cast<std::uint32_t>(number / alongX / alongY) } };
  }

  // Prescribed sizes that are smaller than the octant and overlap it.
  void addIfSmaller(
    std::uint32_t asker, const Octant& octant, std::vector<std::uint32_t>& content) const
  {
    if (askers_.size(asker) * (1 + Rounding) < longestEdge(octant, planes_) &&
      askers_.overlaps(asker, octant))
    {
      content.push_back(asker);
    }
  }

  // The contents of an octant require smaller ones.
  void divide(const Octant& octant, Contents& ofLevel, std::vector<Octants::Key>& found) const
  {
    const std::vector<std::uint32_t>& here = ofLevel[static_cast<std::size_t>(octant.level)];
    if (octant.level >= largestDepth_ || here.empty())
    {
      return;
    }
    for (unsigned which = 0; which < 8; ++which)
    {
      const Octant part = octant.part(which);
      std::vector<std::uint32_t>& content = ofLevel[static_cast<std::size_t>(part.level)];
      content.clear();
      bool any = false;
      for (const std::uint32_t asker : here)
      {
        any = any || askers_.overlaps(asker, part);
        addIfSmaller(asker, part, content);
      }
      if (any)
      {
        found.push_back(octants_.keyOf(part));
        divide(part, ofLevel, found);
      }
    }
  }

  const Askers& askers_;
  const int largestDepth_;
  const Meshlines& planes_;
  const Octants& octants_;
};

template <class Askers>
void add(const Askers& askers, const SizingSpec& spec, const Meshlines& planes, Octants& octants,
  Execution& execution)
{
  std::vector<std::vector<Octants::Key>> found =
    Search(askers, spec.largestDepth, planes, octants).find(execution);
  octants.add(found);
}

}

void addWantedSizes(const SizingSpec& spec, const Surface& surface, const Shoeboxes& shoeboxes,
  const Meshlines& planes, Octants& octants, Execution& execution)
{
  if (!spec.sizeOfTriangle.empty())
  {
    add(SizedTriangles(spec, surface, shoeboxes, planes), spec, planes, octants, execution);
  }
  if (!spec.sizes.empty())
  {
    add(SizedBoxes(spec, surface.lattice, planes), spec, planes, octants, execution);
  }
}

}
