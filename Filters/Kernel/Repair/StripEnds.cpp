// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/StripEnds.h"

#include "Repair/Holes.h"

#include <algorithm>

namespace cartesian
{

namespace
{

class EndCloser
{
public:
  EndCloser(const Surface& surface, std::vector<RimStrip>& strips)
    : whole_(surface)
    , given_(surface.triangles.size())
    , strips_(strips)
  {
    for (std::size_t i = 0; i < strips.size(); ++i)
    {
      const auto& triangles = strips[i].triangles;
      whole_.triangles.insert(whole_.triangles.end(), triangles.begin(), triangles.end());
      stripOf_.resize(stripOf_.size() + triangles.size(), i);
    }
  }

  void close(double widest, Execution& execution)
  {
    for (const std::vector<RimEdge>& loop :
      rimLoopsOf(whole_, SurfaceEdges(whole_, execution), RimTurns::Sharpest))
    {
      if (const std::size_t strip = firstAlong(loop); strip < strips_.size())
      {
        close(loop, widest, strips_[strip]);
      }
    }
  }

private:
  // The number of strips: there is none along it.
  std::size_t firstAlong(const std::vector<RimEdge>& loop) const
  {
    std::size_t first = strips_.size();
    for (const RimEdge& edge : loop)
    {
      if (edge.triangle >= given_)
      {
        first = std::min(first, stripOf_[edge.triangle - given_]);
      }
    }
    return first;
  }

  void close(const std::vector<RimEdge>& loop, double widest, RimStrip& strip) const
  {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    const double width = 4 * fillRim(whole_, loop, triangles) / lengthOf(whole_, loop);
    if (width <= widest)
    {
      strip.triangles.insert(strip.triangles.end(), triangles.begin(), triangles.end());
      strip.width = std::max(strip.width, width);
    }
  }

  Surface whole_; // with the strips
  std::size_t given_;
  std::vector<std::size_t> stripOf_; // of each triangle after those given
  std::vector<RimStrip>& strips_;
};

}

void closeEnds(
  const Surface& surface, double widest, std::vector<RimStrip>& strips, Execution& execution)
{
  if (!strips.empty())
  {
    EndCloser(surface, strips).close(widest, execution);
  }
}

}
