// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/ReachedSpaces.h"

#include "Repair/Arrangement.h"
#include "Repair/ManifoldComponents.h"
#include "Repair/TriangleTree.h"
#include "Repair/WallsOfBodies.h"
#include "Surface/LineCrossings.h"
#include "Surface/Places.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace cartesian
{

namespace
{

constexpr std::int32_t Sheets = regionOfSheets(FirstRegion, FirstRegion);

// The sides of pieces, joined where they are next to the same space.
class ReachedSides
{
public:
  ReachedSides(const Surface& arranged, const std::vector<Piece>& pieces, Execution& execution)
    : flat_(flatOf(arranged, pieces))
    , sides_(joinedSides(flat_, execution))
    , tree_(flat_, execution)
    , far_(static_cast<std::uint32_t>(2 * pieces.size()))
  {
    sides_.add();
    placeParts(execution);
  }

  // The space around everything.
  std::uint32_t farAway() { return sides_.find(far_); }

  std::uint32_t beside(std::uint32_t piece, bool front)
  {
    return sides_.find(sideOf(piece, front));
  }

  // The space at a place, on even levels.
  std::uint32_t at(const Point& place)
  {
    std::vector<Crossing> crossings;
    for (std::size_t along = 0; along < 3; ++along)
    {
      if (cross(along, place, crossings))
      {
        break;
      }
    }
    std::uint32_t side = far_;
    for (const Crossing& crossing : crossings)
    {
      side = crossing.level < crossing.of ? crossing.above() : side;
    }
    return sides_.find(side);
  }

private:
  // Of a line and a piece.
  struct Crossing
  {
    Level level;
    std::uint32_t piece;
    bool up;  // the piece's normal points along the line
    Level of; // of the place whose line it is

    std::uint32_t above() const { return sideOf(piece, up); }
    std::uint32_t below() const { return sideOf(piece, !up); }

    bool operator<(const Crossing& other) const
    {
      return level != other.level ? level < other.level : piece < other.piece;
    }
  };

  // All crossings of the line through a place, in order; false where it is not sure which of two comes first.
  bool cross(std::size_t along, const Point& place, std::vector<Crossing>& crossings) const
  {
    const RowAxes& axes = RowsAlong[along];
    const std::vector<Level> middles{ place[static_cast<std::size_t>(axes.middle)] };
    const std::vector<Level> outers{ place[static_cast<std::size_t>(axes.outer)] };
    Vector low = toVector(place);
    Vector high = low;
    low[along] = 0;
    high[along] = std::numeric_limits<Level>::max();
    crossings.clear();
    tree_.forEachWithin(low, high, [&](std::uint32_t piece) {
      forEachLineCrossing(flat_.corners(piece), axes, middles, outers,
        [&](std::size_t, std::size_t, const Point& p, bool up) {
          crossings.push_back({ p[along], piece, up, place[along] });
        });
    });
    std::sort(crossings.begin(), crossings.end());
    return std::adjacent_find(crossings.begin(), crossings.end(),
             [](const Crossing& a, const Crossing& b) { return a.level == b.level; }) ==
      crossings.end();
  }

  // Joins what is next to each other along a line through a piece; false where that misses it, or is not sure.
  bool joinAlongLine(std::uint32_t piece)
  {
    const std::array<Wide, 3> normal = exactNormal(flat_.corners(piece));
    const auto size = [&](std::size_t a) { return normal[a] < 0 ? -normal[a] : normal[a]; };
    std::size_t along = 0;
    for (std::size_t axis = 1; axis < 3; ++axis)
    {
      along = size(axis) > size(along) ? axis : along;
    }
    Point place;
    const Vector middle = middleOf(flat_, piece);
    std::transform(middle.begin(), middle.end(), place.begin(),
      [](double level) { return static_cast<Level>(level / 2) * 2; });
    std::vector<Crossing> crossings;
    if (!cross(along, place, crossings) ||
      std::none_of(crossings.begin(), crossings.end(),
        [&](const Crossing& crossing) { return crossing.piece == piece; }))
    {
      return false;
    }
    std::uint32_t before = far_;
    for (const Crossing& crossing : crossings)
    {
      sides_.unite(before, crossing.below());
      before = crossing.above();
    }
    sides_.unite(before, far_);
    return true;
  }

  // Each part that shares edges, by a line through one of its largest pieces.
  void placeParts(Execution& execution)
  {
    DisjointSets parts(flat_.triangles.size());
    SurfaceEdges(flat_, execution)
      .forEach([&](std::uint32_t, const EdgeUse* begin, const EdgeUse* end) {
        for (const EdgeUse* use = begin + 1; use < end; ++use)
        {
          parts.unite(begin->triangle(), use->triangle());
        }
      });
    std::vector<double> area(flat_.triangles.size());
    for (std::uint32_t p = 0; p < area.size(); ++p)
    {
      const Corners c = flat_.corners(p);
      area[p] = norm(cartesian::cross(minus(c[1], c[0]), minus(c[2], c[0])));
    }
    std::vector<std::uint32_t> order(area.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
      [&](std::uint32_t a, std::uint32_t b) { return area[a] > area[b]; });
    std::vector<std::uint8_t> isPlaced(area.size());
    for (const std::uint32_t piece : order)
    {
      std::uint8_t& is = isPlaced[parts.find(piece)];
      is = is != 0 || joinAlongLine(piece) ? 1 : 0;
    }
  }

  Surface flat_; // a triangle a piece
  DisjointSets sides_;
  TriangleTree tree_;
  std::uint32_t far_;
};

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

  bool run(Surface& result)
  {
    // Far from the origin files round much; what is nearly coplanar is then taken as it is given.
    arranged_.rounding = canBeArranged(arranged_, placingOf(arranged_)) ? arranged_.rounding : 1;
    const Placing placing = placingOf(arranged_);
    if (!canBeArranged(arranged_, placing) || !arrange(arranged_, placing, execution_))
    {
      return false;
    }
    const std::vector<Piece> pieces = piecesOf(arranged_);
    ReachedSides sides(arranged_, pieces, execution_);
    std::map<std::uint32_t, bool> isFluid; // spaces that are reached
    for (const Point& point : spec_.points)
    {
      isFluid[sides.at(point)] = true;
    }
    if (const auto seen = seenPiece(pieces))
    {
      isFluid[sides.beside(*seen, false)] = true;
    }
    if (isFluid.count(sides.farAway()) != 0)
    {
      return false;
    }
    const Spaces spaces = spacesOf(pieces, sides, isFluid);
    const bool isBox = spec_.firstOfBox.has_value();
    Surface walls =
      wallsBetween(arranged_, { FirstRegion, {}, isBox ? MeshedSide::Outside : MeshedSide::Inside },
        pieces, spaces, execution_);
    if (walls.triangles.empty())
    {
      return false;
    }
    takeWalls(result, std::move(walls));
    nameOneSided(result);
    return true;
  }

private:
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
  Spaces spacesOf(const std::vector<Piece>& pieces, ReachedSides& sides,
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

bool keepReached(Surface& surface, const ReachSpec& spec, Execution& execution)
{
  Surface reached = surface;
  if (!FluidFinder(surface, spec, execution).run(reached))
  {
    return false;
  }
  surface = std::move(reached);
  surface.byParity.clear();
  return true;
}

}
