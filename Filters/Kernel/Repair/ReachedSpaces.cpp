// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/ReachedSpaces.h"

#include "Repair/Arrangement.h"
#include "Repair/ManifoldComponents.h"
#include "Repair/WallsOfBodies.h"
#include "Surface/Places.h"

#include <algorithm>
#include <map>

namespace cartesian
{

namespace
{

constexpr std::int32_t Sheets = regionOfSheets(FirstRegion, FirstRegion);

// With all triangles as those of sheets, but those of the box, and baffles with the back's boundary on their backs. Those of
// one part face the same way, baffles as they are given.
Surface soupOf(const Surface& surface, const ReachSpec& spec, Execution& execution)
{
  const SurfaceEdges edges(surface, execution);
  const ManifoldComponents parts(surface, edges, execution);
  Surface soup;
  soup.lattice = surface.lattice;
  soup.rounding = surface.rounding;
  soup.vertices = surface.vertices;
  const auto add = [&](std::size_t t, std::int32_t boundary, bool turned) {
    soup.triangles.push_back(surface.triangles[t]);
    if (turned)
    {
      std::swap(soup.triangles.back()[1], soup.triangles.back()[2]);
    }
    soup.boundary.push_back(boundary);
    soup.region.push_back(
      spec.firstOfBox && t >= *spec.firstOfBox ? std::int32_t(FirstRegion) : Sheets);
    soup.given.push_back(t < surface.given.size() ? surface.given[t] : ClosesAHole);
  };
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    if (namesAVertexTwice(surface.triangles[t]))
    {
      continue;
    }
    const auto baffle = std::find_if(spec.baffles.begin(), spec.baffles.end(),
      [&](const Baffle& b) { return b.boundary == surface.boundary[t]; });
    add(t, surface.boundary[t], baffle != spec.baffles.end() || parts.turned(t));
    if (baffle != spec.baffles.end())
    {
      add(t, baffle->back, false);
    }
  }
  return soup;
}

// As pieces of sheets that the box or something far away has on both sides are no walls.
class FluidFinder
{
public:
  FluidFinder(const Surface& surface, const ReachSpec& spec, Execution& execution)
    : surface_(surface)
    , spec_(spec)
    , arranged_(soupOf(surface, spec, execution))
    , execution_(execution)
  {
  }

  Reach run(Surface& result)
  {
    // Far from the origin files round much; what is nearly coplanar is then taken as it is given.
    arranged_.rounding = canBeArranged(arranged_, placingOf(arranged_)) ? arranged_.rounding : 1;
    const Placing placing = placingOf(arranged_);
    if (!canBeArranged(arranged_, placing) || !arrange(arranged_, placing, execution_))
    {
      return {};
    }
    const std::vector<Piece> pieces = piecesOf(arranged_);
    JoinedSides sides(arranged_, pieces, execution_);
    std::map<std::uint32_t, bool> isFluid; // spaces that are reached
    for (const Point& point : spec_.points)
    {
      isFluid[sides.at(point)] = true;
    }
    if (const auto seen = seenPiece(pieces))
    {
      isFluid[sides.beside(*seen, false)] = true;
    }
    if (const Reach reach = reachOfKeptOut(sides, isFluid); reach.keptOut)
    {
      return reach;
    }
    if (isFluid.count(sides.farAway()) != 0)
    {
      return {};
    }
    const Spaces spaces = spacesOf(pieces, sides, isFluid);
    const bool isBox = spec_.firstOfBox.has_value();
    Surface walls =
      wallsBetween(arranged_, { FirstRegion, {}, isBox ? MeshedSide::Outside : MeshedSide::Inside },
        pieces, spaces, execution_);
    if (walls.triangles.empty())
    {
      return {};
    }
    takeWalls(result, std::move(walls));
    nameOneSided(result);
    return { true };
  }

private:
  Reach reachOfKeptOut(JoinedSides& sides, const std::map<std::uint32_t, bool>& isFluid) const
  {
    for (std::size_t i = 0; i < spec_.keepOut.size(); ++i)
    {
      const std::optional<Point>& out = spec_.keepOut[i];
      const std::uint32_t space = out ? sides.at(*out) : sides.farAway();
      if (isFluid.count(space) != 0)
      {
        const auto from = std::find_if(spec_.points.begin(), spec_.points.end(),
          [&](const Point& point) { return sides.at(point) == space; });
        const auto number = static_cast<std::size_t>(from - spec_.points.begin());
        return { false, i, number < spec_.points.size() ? std::optional(number) : std::nullopt };
      }
    }
    return {};
  }

  // The largest piece of the triangle of the box that the fluid is seen from.
  std::optional<std::uint32_t> seenPiece(const std::vector<Piece>& pieces) const
  {
    std::optional<std::uint32_t> best;
    double most = 0;
    for (std::uint32_t p = 0; spec_.seenFrom && p < pieces.size(); ++p)
    {
      for (const std::uint32_t t : pieces[p].triangles)
      {
        const double area = areaOf(arranged_, t);
        if (isOfBox(t) && isOnSeenSide(arranged_.corners(t)) && area > most)
        {
          best = p;
          most = area;
        }
      }
    }
    return best;
  }

  bool isOfBox(std::uint32_t t) const { return arranged_.region[t] == FirstRegion; }

  // Sides of the box lie across axes.
  bool isOnSeenSide(const Corners& c) const
  {
    const Corners seen = surface_.corners(*spec_.seenFrom);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const Level level = seen[0][axis];
      const auto isAt = [&](const Point& p) { return p[axis] == level; };
      if (std::all_of(seen.begin(), seen.end(), isAt))
      {
        return std::all_of(c.begin(), c.end(), isAt);
      }
    }
    return false;
  }

  // As bodies wind around them: the fluid is a body, or all else is where there is a box. What is far away on both sides of
  // a piece makes it one of the box.
  Spaces spacesOf(const std::vector<Piece>& pieces, JoinedSides& sides,
    const std::map<std::uint32_t, bool>& isFluid)
  {
    const bool isBox = spec_.firstOfBox.has_value();
    const std::uint32_t farAway = sides.farAway();
    Spaces spaces;
    spaces.turns = { { 0, 0 }, { 0, 1 } };
    for (std::uint32_t p = 0; p < pieces.size(); ++p)
    {
      const std::array<std::uint32_t, 2> space{ sides.beside(p, false), sides.beside(p, true) };
      const auto isIn = [&](std::uint32_t s) {
        return isBox ? isFluid.count(s) == 0 && s != farAway : isFluid.count(s) != 0;
      };
      spaces.beside.push_back({ isIn(space[0]) ? 1U : 0U, isIn(space[1]) ? 1U : 0U });
      const bool isBeyond = isBox && space[0] == farAway && space[1] == farAway;
      for (const std::uint32_t t : pieces[p].triangles)
      {
        arranged_.region[t] = isBeyond ? std::int32_t(FirstRegion) : arranged_.region[t];
      }
    }
    return spaces;
  }

  // Of baffles with the fluid on one side only there is no back.
  void nameOneSided(Surface& walls) const
  {
    for (std::size_t t = 0; t < walls.triangles.size(); ++t)
    {
      for (const Baffle& baffle : spec_.baffles)
      {
        if (walls.boundary[t] == baffle.back && !walls.isOfSheet(t))
        {
          walls.boundary[t] = baffle.boundary;
        }
      }
    }
  }

  const Surface& surface_;
  const ReachSpec& spec_;
  Surface arranged_;
  Execution& execution_;
};

}

Reach keepReached(Surface& surface, const ReachSpec& spec, Execution& execution)
{
  Surface reached = surface;
  const Reach reach = FluidFinder(surface, spec, execution).run(reached);
  if (reach.hasWalls)
  {
    surface = std::move(reached);
    surface.byParity.clear();
  }
  return reach;
}

}
