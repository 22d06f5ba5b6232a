// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/Nesting.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cartesian
{

namespace
{

// Of the samples of what lies in something, at least one in so many lies there clearly: bodies that are nearly the same
// touch nearly everywhere, and neither lies in the other.
constexpr long long SamplesByInside = 4;

class NestingFinder
{
public:
  NestingFinder(
    const SheetShapes& shapes, const RayParityVotes& votes, const ComponentIntersections& crossings)
    : shapes_(shapes)
    , votes_(votes)
    , crossings_(crossings)
  {
    for (std::uint32_t s = 0; s < shapes.volume.size(); ++s)
    {
      if (votes.samples[s] > 0)
      {
        closed_.push_back(s);
      }
    }
    std::sort(closed_.begin(), closed_.end(),
      [&](std::uint32_t a, std::uint32_t b) { return isLarger(a, b); });
  }

  std::vector<int> run() const
  {
    std::vector<int> depth(shapes_.volume.size());
    for (const std::uint32_t sheet : closed_)
    {
      for (auto at = votes_.nesting.lower_bound({ sheet, 0 });
           at != votes_.nesting.end() && at->first[0] == sheet; ++at)
      {
        const std::uint32_t other = at->first[1];
        if (isIn(sheet, other) || isAmongThingsIn(sheet, other))
        {
          depth[sheet] = std::max(depth[sheet], 1 + (other == AllOpenSheets ? 0 : depth[other]));
        }
      }
    }
    return depth;
  }

private:
  double sizeOf(std::uint32_t sheet) const { return std::abs(shapes_.volume[sheet]); }

  bool isLarger(std::uint32_t a, std::uint32_t b) const
  {
    return sizeOf(a) != sizeOf(b) ? sizeOf(a) > sizeOf(b) : a < b;
  }

  // Whether more than this part of a sheet lies in another.
  bool isMostlyIn(std::uint32_t sheet, std::uint32_t other, int part, int ofParts) const
  {
    const auto found = votes_.nesting.find({ sheet, other });
    if (found == votes_.nesting.end())
    {
      return false;
    }
    const auto& [inside, unknown] = found->second;
    return SamplesByInside * inside > votes_.samples[sheet] &&
      ofParts * inside > part * (votes_.samples[sheet] - unknown);
  }

  bool areGivenAlike(std::uint32_t a, std::uint32_t b) const
  {
    return shapes_.givenWay[a] != 0 && shapes_.givenWay[a] == shapes_.givenWay[b];
  }

  bool isIn(std::uint32_t sheet, std::uint32_t other) const
  {
    if (other == AllOpenSheets)
    {
      return isMostlyIn(sheet, other, 3, 4);
    }
    if (!isLarger(other, sheet))
    {
      return false;
    }
    if (!crossings_.cross(sheet, other))
    {
      // Others differ by little more than the file's precision.
      return isMostlyIn(sheet, other, 3, 4);
    }
    const bool isKnown = shapes_.givenWay[sheet] != 0 && shapes_.givenWay[other] != 0;
    return !areGivenAlike(sheet, other) &&
      (isKnown ? isMostlyIn(sheet, other, 1, 2) : isMostlyIn(sheet, other, 3, 4));
  }

  // Whether a sheet passes through another, and meets things that lie in that and were given alike.
  bool isAmongThingsIn(std::uint32_t sheet, std::uint32_t other) const
  {
    if (other == AllOpenSheets || !isLarger(other, sheet) || !crossings_.cross(sheet, other) ||
      !isMostlyIn(sheet, other, 1, 2))
    {
      return false;
    }
    return std::any_of(closed_.begin(), closed_.end(), [&](std::uint32_t thing) {
      return thing != sheet && thing != other && meet(sheet, thing) &&
        areGivenAlike(sheet, thing) && !crossings_.cross(thing, other) && isIn(thing, other);
    });
  }

  bool meet(std::uint32_t a, std::uint32_t b) const
  {
    const auto found = votes_.nesting.find({ a, b });
    return crossings_.meet(a, b) || (found != votes_.nesting.end() && found->second.unknown > 0);
  }

  const SheetShapes& shapes_;
  const RayParityVotes& votes_;
  const ComponentIntersections& crossings_;
  std::vector<std::uint32_t> closed_; // sheets, the larger ones first, in which others may lie
};

}

std::vector<int> depthsOf(
  const SheetShapes& shapes, const RayParityVotes& votes, const ComponentIntersections& crossings)
{
  return NestingFinder(shapes, votes, crossings).run();
}

}
