// SPDX-License-Identifier: BSD-3-Clause
#include "GapsInWords.h"

#include "Base/Error.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t MostNamed = 20;

Vector pointOf(const SurfaceView& surface, std::uint32_t point)
{
  const double* at = surface.points + 3 * std::size_t(point);
  return { at[0], at[1], at[2] };
}

std::string inWords(const Vector& place)
{
  return "(" + number(place[0]) + ", " + number(place[1]) + ", " + number(place[2]) + ")";
}

}

std::string nameOfGap(std::ptrdiff_t gap)
{
  return "gap_" + std::to_string(gap + 1);
}

std::string describe(const ClosedGaps& closed, const SurfaceView& surface)
{
  const std::size_t count = closed.gaps.size();
  std::string text = count == 0 ? ""
    : count == 1                ? "1 gap was closed:"
                                : number(double(count)) + " gaps were closed:";
  for (std::size_t i = 0; i < std::min(count, MostNamed); ++i)
  {
    const ClosedGap& gap = closed.gaps[i];
    text += "\n  " + nameOfGap(std::ptrdiff_t(i)) + ", " + number(gap.width) + " wide, of " +
      number(double(gap.rim.size())) + " edges, at " + inWords(pointOf(surface, gap.rim.front()));
  }
  text += count > MostNamed ? "\n  ..." : "";
  const auto add = [&](const std::string& sentence) {
    text += (text.empty() ? "" : "\n") + sentence;
  };
  if (!closed.panes.empty())
  {
    add(number(double(closed.panes.size())) +
      " triangles that close holes between other walls, as panes do, are sheets: both sides are "
      "walls.");
  }
  for (std::size_t i = 0; i < std::min(closed.refused.size(), MostNamed); ++i)
  {
    add("Gaps between parts near " + inWords(closed.refused[i]) +
      " are open still: it is uncertain what strips across them enclose. Choose another width "
      "(Close Gaps), or close them in the surface.");
  }
  return text;
}

void list(const ClosedGaps& closed, const SurfaceView& surface, SurfaceDefects& defects)
{
  for (const ClosedGap& gap : closed.gaps)
  {
    std::vector<Vector> rim;
    for (const std::uint32_t point : gap.rim)
    {
      rim.push_back(pointOf(surface, point));
    }
    addClosedGap(rim, gap.width, defects);
  }
}

}
