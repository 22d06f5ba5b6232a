// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/Regions.h"

#include "Base/DisjointSets.h"
#include "Base/Error.h"
#include "Repair/Imprint.h"
#include "Repair/SurfaceRepair.h"
#include "Repair/TrianglePairs.h"
#include "Surface/LineCrossings.h"
#include "Surface/Places.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

namespace cartesian
{

namespace
{

// Triangles of a sheet that are tried before one is found through which a line passes that meets no other
// surface at the same level.
constexpr std::size_t MostTried = 256;

std::string nameOf(std::int32_t region, const std::vector<std::string>& names)
{
  const auto n = static_cast<std::size_t>(region - FirstRegion);
  return n < names.size() ? "\"" + names[n] + "\"" : std::to_string(region);
}

// The surface of one region, oriented.
Surface surfaceOf(const Surface& all, std::int32_t region, const Meshlines& planes,
  const std::vector<std::string>& names, Execution& execution)
{
  Surface own;
  own.lattice = all.lattice;
  own.vertices = all.vertices;
  for (std::size_t t = 0; t < all.triangles.size(); ++t)
  {
    if (all.region[t] == region)
    {
      own.triangles.push_back(all.triangles[t]);
      own.boundary.push_back(all.boundary[t]);
      own.given.push_back(all.given[t]);
      own.region.push_back(region);
    }
  }
  const std::string name = "The surface of region " + nameOf(region, names);
  if (own.triangles.empty())
  {
    throw Error(Fault::FlawedSurface, name + " has no triangles.");
  }
  const SurfaceRepair repaired = repair(own, planes, execution);
  if (!repaired.check.oriented())
  {
    const auto& flaw = repaired.check.places.front();
    throw Error(Fault::FlawedSurface,
      name + " is not closed at " + placeOf(own, middleOf(own, flaw.triangle)) +
        ": with several regions, each needs a closed surface. Close it.");
  }
  return own;
}

void append(const Surface& from, Surface& to)
{
  for (std::size_t t = 0; t < from.triangles.size(); ++t)
  {
    if (!namesAVertexTwice(from.triangles[t]))
    {
      to.triangles.push_back(from.triangles[t]);
      to.boundary.push_back(from.boundary[t]);
      to.given.push_back(from.given[t]);
      to.region.push_back(from.region[t]);
    }
  }
}

// A place with triangles of one or more regions.
struct Piece
{
  std::array<std::uint32_t, 3> vertices; // as the first of its triangles has them
  std::vector<std::uint32_t> triangles;
};

// Finds the walls. Borrows the surface of all regions: closed, oriented, imprinted.
class WallFinder
{
public:
  WallFinder(const Surface& surface, std::int32_t regions)
    : surface_(surface)
    , regions_(regions)
  {
  }

  Surface run(Execution& execution)
  {
    listPieces();
    listSheets(execution);
    Surface result;
    result.lattice = surface_.lattice;
    result.vertices = surface_.vertices;
    for (const auto& sheet : sheets_)
    {
      const std::vector<std::uint8_t> around = regionsAround(sheet);
      for (const std::uint32_t piece : sheet)
      {
        addWall(pieces_[piece], around, result);
      }
    }
    return result;
  }

private:
  static std::array<std::uint32_t, 3> sorted(std::array<std::uint32_t, 3> v)
  {
    std::sort(v.begin(), v.end());
    return v;
  }

  void listPieces()
  {
    std::vector<std::uint32_t> order(surface_.triangles.size());
    for (std::uint32_t t = 0; t < order.size(); ++t)
    {
      order[t] = t;
    }
    const auto key = [&](std::uint32_t t) {
      return std::make_tuple(sorted(surface_.triangles[t]), surface_.region[t]);
    };
    std::sort(order.begin(), order.end(),
      [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    for (const std::uint32_t t : order)
    {
      if (pieces_.empty() || sorted(pieces_.back().vertices) != sorted(surface_.triangles[t]))
      {
        pieces_.push_back({ surface_.triangles[t], {} });
      }
      pieces_.back().triangles.push_back(t);
    }
  }

  bool haveSameRegions(std::uint32_t a, std::uint32_t b) const
  {
    const auto& p = pieces_[a].triangles;
    const auto& q = pieces_[b].triangles;
    return std::equal(p.begin(), p.end(), q.begin(), q.end(),
      [&](std::uint32_t s, std::uint32_t t) { return surface_.region[s] == surface_.region[t]; });
  }

  // Pieces of the same regions, connected across edges that no others have: all have the same regions around.
  void listSheets(Execution& execution)
  {
    Surface flat;
    flat.vertices = surface_.vertices;
    for (const Piece& piece : pieces_)
    {
      flat.triangles.push_back(piece.vertices);
    }
    DisjointSets sets(pieces_.size());
    SurfaceEdges(flat, execution)
      .forEach([&](std::uint32_t, const EdgeUse* begin, const EdgeUse* end) {
        if (end - begin == 2 && haveSameRegions(begin->triangle(), begin[1].triangle()))
        {
          sets.unite(begin->triangle(), begin[1].triangle());
        }
      });
    std::map<std::uint32_t, std::vector<std::uint32_t>> byRoot;
    for (std::uint32_t p = 0; p < pieces_.size(); ++p)
    {
      byRoot[sets.find(p)].push_back(p);
    }
    for (auto& [root, pieces] : byRoot)
    {
      sheets_.push_back(std::move(pieces));
    }
  }

  bool isOf(const Piece& piece, std::int32_t region) const
  {
    return std::any_of(piece.triangles.begin(), piece.triangles.end(),
      [&](std::uint32_t t) { return surface_.region[t] == region; });
  }

  double areaOf(std::uint32_t piece) const
  {
    const Corners c = surface_.corners(pieces_[piece].triangles[0]);
    return norm(cross(minus(c[1], c[0]), minus(c[2], c[0])));
  }

  // Of the regions whose surface the sheet is no part of: whether it lies inside.
  std::vector<std::uint8_t> regionsAround(std::vector<std::uint32_t> sheet) const
  {
    const std::size_t count = std::min(sheet.size(), MostTried);
    std::partial_sort(sheet.begin(), sheet.begin() + static_cast<std::ptrdiff_t>(count),
      sheet.end(), [&](std::uint32_t a, std::uint32_t b) {
        const double x = areaOf(a);
        const double y = areaOf(b);
        return x != y ? x > y : a < b;
      });
    std::vector<std::uint8_t> inside;
    for (std::size_t i = 0; i < count; ++i)
    {
      if (lookAlongLine(pieces_[sheet[i]], inside))
      {
        break;
      }
    }
    return inside;
  }

  // Follows the line through the middle of a piece; false where it misses the piece, or others are at the
  // same level.
  bool lookAlongLine(const Piece& piece, std::vector<std::uint8_t>& inside) const
  {
    const Corners corners = surface_.corners(piece.triangles[0]);
    const std::array<Wide, 3> normal = exactNormal(corners);
    std::size_t along = 0;
    for (std::size_t axis = 1; axis < 3; ++axis)
    {
      const auto size = [&](std::size_t a) { return normal[a] < 0 ? -normal[a] : normal[a]; };
      along = size(axis) > size(along) ? axis : along;
    }
    const RowAxes& axes = RowsAlong[along];
    const Vector middle = middleOf(surface_, piece.triangles[0]);
    const auto even = [&](int axis) {
      return static_cast<Level>(middle[static_cast<std::size_t>(axis)] / 2) * 2;
    };
    const std::vector<Level> middles{ even(axes.middle) };
    const std::vector<Level> outers{ even(axes.outer) };
    Level own = 0;
    bool isHit = false;
    forEachLineCrossing(
      corners, axes, middles, outers, [&](std::size_t, std::size_t, const Point& p, bool) {
        own = p[along];
        isHit = true;
      });
    if (!isHit)
    {
      return false;
    }
    std::vector<int> turns(static_cast<std::size_t>(regions_) + 1);
    bool isClear = true;
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
    {
      forEachLineCrossing(surface_.corners(t), axes, middles, outers,
        [&](std::size_t, std::size_t, const Point& p, bool up) {
          const auto region = static_cast<std::size_t>(surface_.region[t]);
          isClear = isClear && (p[along] != own || isOf(piece, surface_.region[t]));
          turns[region] += p[along] < own ? (up ? -1 : 1) : 0;
        });
    }
    inside.assign(turns.size(), 0);
    for (std::size_t region = 0; region < turns.size(); ++region)
    {
      inside[region] = turns[region] > 0 ? 1 : 0;
    }
    return isClear;
  }

  void addWall(const Piece& piece, const std::vector<std::uint8_t>& around, Surface& result)
  {
    // The first region behind and in front of the piece, as the first triangle sees it.
    std::array<std::int32_t, 2> region{ OutsideRegion, OutsideRegion };
    for (std::int32_t r = regions_; r >= FirstRegion; --r)
    {
      const bool isAround = !around.empty() && around[static_cast<std::size_t>(r)] != 0;
      std::array<bool, 2> is{ isAround, isAround };
      if (isOf(piece, r))
      {
        is = isBeside(piece, r);
      }
      region = { is[0] ? r : region[0], is[1] ? r : region[1] };
    }
    if (region[0] == region[1])
    {
      return;
    }
    const bool turned =
      region[0] == OutsideRegion || (region[1] != OutsideRegion && region[1] < region[0]);
    std::array<std::uint32_t, 3> vertices = piece.vertices;
    if (turned)
    {
      std::swap(region[0], region[1]);
      std::swap(vertices[1], vertices[2]);
    }
    const std::uint32_t source = sourceOf(piece, region[0]);
    const Wall wall{ region[0], region[1], surface_.boundary[source],
      region[1] == OutsideRegion ? NoBoundary : surface_.boundary[sourceOf(piece, region[1])] };
    result.triangles.push_back(vertices);
    result.boundary.push_back(numberOf(wall, result));
    result.given.push_back(surface_.given[source]);
  }

  // Whether a region of which the piece is a wall lies behind it, or in front.
  std::array<bool, 2> isBeside(const Piece& piece, std::int32_t region) const
  {
    std::array<bool, 2> is{ false, false };
    for (const std::uint32_t t : piece.triangles)
    {
      if (surface_.region[t] == region)
      {
        is[faceAlike(surface_.triangles[t], piece.vertices) ? 0 : 1] = true;
      }
    }
    return is;
  }

  // Whether two triangles of the same vertices have the same normal.
  static bool faceAlike(
    const std::array<std::uint32_t, 3>& a, const std::array<std::uint32_t, 3>& b)
  {
    const auto at = std::find(a.begin(), a.end(), b[0]) - a.begin();
    return a[static_cast<std::size_t>(at + 1) % 3] == b[1];
  }

  // The triangle of a region, or else of any other, whose boundary the region has there.
  std::uint32_t sourceOf(const Piece& piece, std::int32_t region) const
  {
    const auto own = std::find_if(piece.triangles.begin(), piece.triangles.end(),
      [&](std::uint32_t t) { return surface_.region[t] == region; });
    return own == piece.triangles.end() ? piece.triangles[0] : *own;
  }

  std::int32_t numberOf(const Wall& wall, Surface& result)
  {
    const auto [at, isNew] = numbers_.emplace(
      std::make_tuple(wall.behind, wall.front, wall.boundary, wall.boundaryInFront),
      static_cast<std::int32_t>(result.walls.all.size()));
    if (isNew)
    {
      result.walls.all.push_back(wall);
    }
    return at->second;
  }

  const Surface& surface_;
  std::int32_t regions_;
  std::vector<Piece> pieces_;
  std::vector<std::vector<std::uint32_t>> sheets_; // pieces
  std::map<std::tuple<std::int32_t, std::int32_t, std::int32_t, std::int32_t>, std::int32_t>
    numbers_; // of walls
};

// Puts vertices in order of their places, and triangles in order of vertices, as onLattice() does.
void sortByPlace(Surface& surface)
{
  std::vector<std::uint32_t> order(surface.vertices.size());
  std::vector<std::uint32_t> place(order.size());
  std::iota(order.begin(), order.end(), 0);
  const std::vector<Point> at = surface.vertices;
  std::sort(
    order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return at[a] < at[b]; });
  for (std::uint32_t i = 0; i < order.size(); ++i)
  {
    place[order[i]] = i;
    surface.vertices[i] = at[order[i]];
  }
  const Surface given = surface;
  std::vector<std::uint32_t> triangles(given.triangles.size());
  std::iota(triangles.begin(), triangles.end(), 0);
  for (auto& t : surface.triangles)
  {
    t = { place[t[0]], place[t[1]], place[t[2]] };
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  }
  const std::vector<std::array<std::uint32_t, 3>> renamed = surface.triangles;
  std::sort(triangles.begin(), triangles.end(),
    [&](std::uint32_t a, std::uint32_t b) { return renamed[a] < renamed[b]; });
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    surface.triangles[i] = renamed[triangles[i]];
    surface.boundary[i] = given.boundary[triangles[i]];
    surface.given[i] = given.given[triangles[i]];
  }
}

bool haveSameVertices(const Surface& surface, std::uint32_t s, std::uint32_t t)
{
  const auto& a = surface.triangles[s];
  const auto& b = surface.triangles[t];
  return std::is_permutation(a.begin(), a.end(), b.begin());
}

std::vector<std::string> namesOfParts(
  const std::vector<std::int32_t>& given, const std::vector<std::string>& names)
{
  std::vector<std::string> result;
  for (const std::int32_t region : given)
  {
    const auto n = static_cast<std::size_t>(region - FirstRegion);
    result.push_back(n < names.size() ? names[n] : std::to_string(region));
  }
  return result;
}

// Those that pass through each other have no common edge there.
void requireApart(
  const Surface& surface, const std::vector<std::string>& names, Execution& execution)
{
  for (const TrianglePair& pair : findPairs(surface, execution).pairs)
  {
    const std::int32_t a = surface.region[pair.first];
    const std::int32_t b = surface.region[pair.second];
    if (a != b && !haveSameVertices(surface, pair.first, pair.second))
    {
      throw Error(Fault::FlawedSurface,
        "The surfaces of regions " + nameOf(std::min(a, b), names) + " and " +
          nameOf(std::max(a, b), names) + " pass through each other near " +
          placeOf(surface, middleOf(surface, pair.first)) +
          ": only regions that touch in common planes or triangles, or lie in one another, can be "
          "separated. Cut one out of the other, or choose a Contact Tolerance that is larger than "
          "what is between walls that ought to touch.");
    }
  }
}

}

std::vector<ClosedContact> separateRegions(
  Surface& surface, const Meshlines& planes, const RegionSpec& spec, Execution& execution)
{
  requireInRange(RegionSpec::ContactTolerances, spec.contactTolerance, "Contact Tolerance");
  std::vector<std::string> names = spec.names;
  std::int32_t regions = *std::max_element(surface.region.begin(), surface.region.end());
  const Surface sheets = takeBaffles(surface, spec.baffles);
  Surface all;
  all.lattice = surface.lattice;
  all.vertices = surface.vertices;
  for (std::int32_t region = FirstRegion; region <= regions; ++region)
  {
    append(surfaceOf(surface, region, planes, names, execution), all);
  }
  std::vector<ClosedContact> closed;
  if (spec.contactTolerance > 0)
  {
    closed = closeContacts(all, regions, spec.contactTolerance / surface.lattice.step(), execution);
  }
  std::vector<std::int32_t> given;
  if (!sheets.triangles.empty())
  {
    const double tolerance = spec.contactTolerance / surface.lattice.step();
    given = divideByBaffles(all, sheets, spec.baffles, regions, tolerance, names, execution).given;
    regions = static_cast<std::int32_t>(given.size());
    names = namesOfParts(given, names);
  }
  imprint(all, execution);
  requireApart(all, names, execution);
  surface = WallFinder(all, regions).run(execution);
  surface.walls.given = given;
  sortByPlace(surface);
  for (std::int32_t region = FirstRegion; region <= regions; ++region)
  {
    const auto isOf = [&](
                        const Wall& wall) { return wall.behind == region || wall.front == region; };
    if (std::none_of(surface.walls.all.begin(), surface.walls.all.end(), isOf))
    {
      throw Error(Fault::FlawedSurface,
        "Nothing is left of region " + nameOf(region, names) +
          ": it lies in those before it. Put it before them, or leave it out.");
    }
  }
  return closed;
}

}
