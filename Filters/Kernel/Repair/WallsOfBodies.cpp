// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/WallsOfBodies.h"

#include "Repair/Spaces.h"
#include "Repair/ThinSheets.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

namespace cartesian
{

namespace
{

class WallFinder
{
public:
  WallFinder(const Surface& surface, const Bodies& bodies)
    : surface_(surface)
    , bodies_(bodies)
  {
  }

  Surface run(const std::vector<Piece>& pieces, const Spaces& spaces)
  {
    Surface result;
    result.lattice = surface_.lattice;
    result.vertices = surface_.vertices;
    for (std::size_t p = 0; p < pieces.size(); ++p)
    {
      addWall(pieces[p], regionsBeside(spaces, p), result);
    }
    return result;
  }

  // Triangles with several spaces of one region beside them.
  std::vector<std::uint32_t> inside(const std::vector<Piece>& pieces, const Spaces& spaces) const
  {
    std::vector<std::uint32_t> all;
    for (std::size_t p = 0; p < pieces.size(); ++p)
    {
      const auto& [behind, front] = spaces.beside[p];
      const auto [own, other] = regionsBeside(spaces, p);
      if (spaces.turns[behind] != spaces.turns[front] && own == other)
      {
        all.insert(all.end(), pieces[p].triangles.begin(), pieces[p].triangles.end());
      }
    }
    return all;
  }

private:
  // Behind a piece and in front.
  std::array<std::int32_t, 2> regionsBeside(const Spaces& spaces, std::size_t piece) const
  {
    const auto& [behind, front] = spaces.beside[piece];
    return { regionOf(spaces.turns[behind]), regionOf(spaces.turns[front]) };
  }

  // The first one that winds around a space.
  std::int32_t regionOf(const std::vector<std::int32_t>& turns) const
  {
    for (std::int32_t r = FirstRegion; r <= bodies_.regions; ++r)
    {
      if (turns[static_cast<std::size_t>(r)] + bodies_.around > 0)
      {
        return r;
      }
    }
    return OutsideRegion;
  }

  // `region`: behind the piece and in front.
  void addWall(const Piece& piece, std::array<std::int32_t, 2> region, Surface& result)
  {
    if (region[0] == region[1])
    {
      addSheet(piece, region[0], result);
      return;
    }
    std::array<std::uint32_t, 3> vertices = piece.vertices;
    if (region[0] == OutsideRegion || (region[1] != OutsideRegion && region[1] < region[0]))
    {
      std::swap(region[0], region[1]);
      std::swap(vertices[1], vertices[2]);
    }
    const std::uint32_t source = sourceOf(piece, vertices, region[0]);
    std::swap(vertices[1], vertices[2]);
    const Wall wall{ region[0], region[1], surface_.boundary[source],
      region[1] == OutsideRegion ? NoBoundary
                                 : surface_.boundary[sourceOf(piece, vertices, region[1])] };
    std::swap(vertices[1], vertices[2]);
    add(vertices, wall, source, result);
    result.ofSheet.push_back(0);
  }

  void add(const std::array<std::uint32_t, 3>& vertices, const Wall& wall, std::uint32_t source,
    Surface& result)
  {
    result.triangles.push_back(vertices);
    result.boundary.push_back(numberOf(wall, result));
    result.given.push_back(source < surface_.given.size() ? surface_.given[source] : ClosesAHole);
  }

  // In both directions, where it is in a space that is meshed.
  void addSheet(const Piece& piece, std::int32_t region, Surface& result)
  {
    const std::int32_t sheets = surface_.region[piece.triangles.back()];
    if (sheets <= bodies_.regions || !isMeshed(region, sheets - bodies_.regions))
    {
      return;
    }
    std::array<std::uint32_t, 3> vertices = piece.vertices;
    for (int direction = 0; direction < 2; ++direction)
    {
      const std::uint32_t source = sourceOf(piece, vertices, sheets);
      add(
        vertices, { region, OutsideRegion, surface_.boundary[source], NoBoundary }, source, result);
      result.ofSheet.push_back(1);
      std::swap(vertices[1], vertices[2]);
    }
  }

  bool isMeshed(std::int32_t region, std::int32_t given) const
  {
    if (region == OutsideRegion)
    {
      return bodies_.meshed != MeshedSide::Inside;
    }
    const std::int32_t own = bodies_.given.empty()
      ? region
      : bodies_.given[static_cast<std::size_t>(region - FirstRegion)];
    return bodies_.meshed != MeshedSide::Outside && own == given;
  }

  // The triangle whose boundary a region has there: its own that points out of it, its own, or any other's.
  std::uint32_t sourceOf(
    const Piece& piece, const std::array<std::uint32_t, 3>& outward, std::int32_t region) const
  {
    return *std::min_element(
      piece.triangles.begin(), piece.triangles.end(), [&](std::uint32_t a, std::uint32_t b) {
        const auto rank = [&](std::uint32_t t) {
          return std::make_tuple(surface_.region[t] != region,
            !faceAlike(surface_.triangles[t], outward), surface_.boundary[t], t);
        };
        return rank(a) < rank(b);
      });
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
  const Bodies& bodies_;
  std::map<std::tuple<std::int32_t, std::int32_t, std::int32_t, std::int32_t>, std::int32_t>
    numbers_; // of walls
};

// Shells of sheets are holes in the meshed space, and bodies outside it.
void giveSidesToSheets(Surface& walls, MeshedSide side, Execution& execution)
{
  MeshedSides meshed;
  for (const std::int32_t boundary : walls.boundary)
  {
    const auto isMeshed = [&](std::int32_t region) -> std::uint8_t {
      return (region == OutsideRegion) == (side == MeshedSide::Outside) ? 1 : 0;
    };
    meshed.push_back(
      { isMeshed(walls.walls.behind(boundary)), isMeshed(walls.walls.front(boundary)) });
  }
  const SurfaceEdges edges(walls, execution);
  const std::vector<SheetPair> sheets =
    findSheets(walls, SheetHandling::LeaveOut, edges, findDuplicates(walls, edges, execution));
  giveSides(walls, edges, sheets, meshed);
  for (std::size_t t = 0; t < walls.ofSheet.size(); ++t)
  {
    if (walls.ofSheet[t] != 0 && walls.walls.behind(walls.boundary[t]) != OutsideRegion)
    {
      std::swap(walls.triangles[t][1], walls.triangles[t][2]);
    }
  }
}

}

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
  for (auto& t : surface.triangles)
  {
    t = { place[t[0]], place[t[1]], place[t[2]] };
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  }
  const Surface given = surface;
  std::vector<std::uint32_t> triangles(given.triangles.size());
  std::iota(triangles.begin(), triangles.end(), 0);
  std::sort(triangles.begin(), triangles.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::make_tuple(given.given[a] == ClosesAHole, given.triangles[a]) <
      std::make_tuple(given.given[b] == ClosesAHole, given.triangles[b]);
  });
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    surface.triangles[i] = given.triangles[triangles[i]];
    surface.boundary[i] = given.boundary[triangles[i]];
    surface.given[i] = given.given[triangles[i]];
    surface.ofSheet[i] = given.ofSheet[triangles[i]];
  }
  while (!surface.given.empty() && surface.given.back() == ClosesAHole)
  {
    surface.given.pop_back();
  }
}

Surface wallsOf(const Surface& arranged, const Bodies& bodies, std::vector<std::uint32_t>& crossing,
  Execution& execution, std::vector<std::uint32_t>* inside)
{
  const std::vector<Piece> pieces = piecesOf(arranged);
  const std::int32_t last =
    std::max(bodies.regions, *std::max_element(arranged.region.begin(), arranged.region.end()));
  const Spaces spaces = findSpaces(arranged, pieces, last, execution);
  if (inside)
  {
    *inside = WallFinder(arranged, bodies).inside(pieces, spaces);
  }
  crossing.clear();
  for (const std::uint32_t p : spaces.contradictions)
  {
    crossing.push_back(pieces[p].triangles[0]);
  }
  return wallsBetween(arranged, bodies, pieces, spaces, execution);
}

Surface wallsBetween(const Surface& arranged, const Bodies& bodies,
  const std::vector<Piece>& pieces, const Spaces& spaces, Execution& execution)
{
  Surface walls = WallFinder(arranged, bodies).run(pieces, spaces);
  walls.rounding = arranged.rounding;
  sortByPlace(walls);
  if (std::find(walls.ofSheet.begin(), walls.ofSheet.end(), 1) != walls.ofSheet.end())
  {
    giveSidesToSheets(walls, bodies.meshed, execution);
  }
  return walls;
}

void takeWalls(Surface& surface, Surface walls)
{
  for (std::int32_t& boundary : walls.boundary)
  {
    boundary = walls.walls.boundary(boundary);
  }
  surface.triangles.swap(walls.triangles);
  surface.vertices.swap(walls.vertices);
  surface.boundary.swap(walls.boundary);
  surface.given.swap(walls.given);
  surface.ofSheet.swap(walls.ofSheet);
  surface.region.clear();
}

bool unite(Surface& surface, const Bodies& bodies, std::vector<std::uint32_t>& crossing,
  Execution& execution, std::vector<std::uint32_t>* inside)
{
  Surface walls = wallsOf(surface, bodies, crossing, execution, inside);
  if (!crossing.empty() || walls.triangles.empty())
  {
    return false;
  }
  takeWalls(surface, std::move(walls));
  return true;
}

}
