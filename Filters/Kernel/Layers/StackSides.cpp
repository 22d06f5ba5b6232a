// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/StackSides.h"

#include "Base/ForEachItem.h"

#include <algorithm>
#include <limits>

namespace cartesian
{

namespace
{

// How far edges under one side may be from the straight line, by its height: its middle sees all of it.
constexpr double MostSag = 0.5;

// Sides lower than this part of their length are straighter in proportion: the centre of a long strip that bends a little
// is far from its middle.
constexpr double LowByLength = 0.02;

}

StackSides::StackSides(const LayeredWall& wall, const LayerHeights& heights,
  const StackCells& cells, Execution& execution)
  : wall_(wall)
  , heights_(heights)
  , cells_(cells)
  , inner_(heights.layers() * wall.beyond.size())
{
  forEachItem(wall.layered.size(), execution, [&](std::size_t f) {
    if (wall.hasStack(f))
    {
      divideFace(f);
    }
  });
}

// Whether the edges before and after a corner do.
bool StackSides::leadAlike(std::size_t face, std::size_t i) const
{
  const std::size_t before = i + wall_.corners(face) - 1;
  const std::size_t a = wall_.faceBeyond(face, before);
  const std::size_t b = wall_.faceBeyond(face, i);
  if (a == face || b == face || wall_.parts[wall_.node(face, i)] == 0)
  {
    return false;
  }
  if (!wall_.layered[a] && !wall_.layered[b])
  {
    return wall_.of.boundary[a] == wall_.of.boundary[b];
  }
  return a == b &&
    wall_.opposite[wall_.corner(face, before)] ==
    wall_.cornerAfter(a, wall_.opposite[wall_.corner(face, i)]);
}

// Two faces with stacks share the sides between them: the first one determines them.
void StackSides::divideFace(std::size_t face)
{
  const std::size_t corners = wall_.corners(face);
  std::size_t first = 0;
  while (first < corners && leadAlike(face, first))
  {
    ++first;
  }
  for (std::size_t i = first; i < first + corners;)
  {
    Run run{ face, i % corners, 1 };
    while (run.edges < corners && leadAlike(face, i + run.edges))
    {
      ++run.edges;
    }
    const std::size_t other = wall_.faceBeyond(face, i);
    if (run.edges > 1 && (!wall_.layered[other] || other > face))
    {
      for (std::size_t k = 0; k < heights_.layers(); ++k)
      {
        divide(run, k);
      }
    }
    i += run.edges;
  }
}

void StackSides::divide(const Run& run, std::size_t k)
{
  std::uint8_t* const inner = &inner_[k * wall_.beyond.size()];
  for (std::size_t done = 0; done < run.edges;)
  {
    Run part{ run.face, run.first + done, 1 };
    for (; done + part.edges < run.edges; ++part.edges)
    {
      if (const Run longer{ part.face, part.first, part.edges + 1 }; !isStraight(longer, k))
      {
        break;
      }
    }
    for (std::size_t i = part.first + 1; i < part.first + part.edges; ++i)
    {
      inner[wall_.corner(run.face, i)] = 1;
      const std::size_t other = wall_.faceBeyond(run.face, i - 1);
      if (wall_.layered[other])
      {
        inner[wall_.opposite[wall_.corner(run.face, i - 1)]] = 1;
      }
    }
    done += part.edges;
  }
}

bool StackSides::isStraight(const Run& part, std::size_t k) const
{
  const auto at = [&](std::size_t i) -> const Vector& {
    return wall_.place[wall_.node(part.face, part.first + i)];
  };
  if (wall_.parts[wall_.node(part.face, part.first)] == 0 &&
    wall_.parts[wall_.node(part.face, part.first + part.edges)] == 0)
  {
    return false; // the cell would have three faces: it, the base and the top
  }
  const Vector chord = unit(minus(at(part.edges), at(0)));
  const double height = thicknessOf(part, k);
  const double length = norm(minus(at(part.edges), at(0)));
  const double most = MostSag * height * std::min(1.0, height / (LowByLength * length));
  bool isStraight = dot(minus(at(1), at(0)), chord) > 0;
  for (std::size_t i = 1; i < part.edges; ++i)
  {
    isStraight = isStraight && norm(cross(minus(at(i), at(0)), chord)) <= most &&
      dot(minus(at(i + 1), at(i)), chord) > 0;
  }
  return isStraight;
}

// Of the side that begins with a layer, where it is thinnest between the ends.
double StackSides::thicknessOf(const Run& part, std::size_t k) const
{
  const std::size_t begin =
    heights_.layers() - cells_.endOfSide(part.face, part.first % wall_.corners(part.face), k);
  const std::size_t end = heights_.layers() - k;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < part.edges; ++i)
  {
    const std::size_t n = wall_.node(part.face, part.first + i);
    const double taken = wall_.parts[n];
    least = std::min(least,
      norm(wall_.way[n]) *
        (heights_.at(taken, end, wall_.isFlat[n]) - heights_.at(taken, begin, wall_.isFlat[n])));
  }
  return least;
}

}
