// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/OpenSheets.h"

#include "Lattice/Vector.h"
#include "Repair/Holes.h"
#include "Repair/NearbyTriangles.h"
#include "Repair/OpenPieces.h"
#include "Surface/Places.h"
#include "Surface/SurfaceEdges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace cartesian
{

namespace
{

// Lids of a sheet have more than this part of its area.
constexpr double LeastLids = 0.7;

// Rims this close to others are those of one wall, and to walls lie on them: as a part of the root of the piece's area.
constexpr double Crack = 1e-3;

// Walls under an edge of a rim may bend away from it by this part of its length.
constexpr double LargestSagitta = 0.25;

constexpr std::uint32_t None = ~0u;

struct Piece : OpenPiece
{
  double area = 0; // levels squared
  bool isSheet = false;

  double crack() const { return Crack * std::sqrt(area); }
};

// Without baffles.
std::vector<Piece> piecesOf(
  const Surface& surface, const std::vector<Baffle>& baffles, Execution& execution)
{
  std::vector<std::uint8_t> isOfBaffle(surface.triangles.size());
  for (std::size_t t = 0; t < isOfBaffle.size() && !baffles.empty(); ++t)
  {
    isOfBaffle[t] = std::any_of(baffles.begin(), baffles.end(),
      [&](const Baffle& b) { return b.boundary == surface.boundary[t]; });
  }
  std::vector<Piece> pieces;
  for (OpenPiece& open : openPiecesOf(surface, isOfBaffle, execution))
  {
    pieces.push_back({ std::move(open) });
    for (const std::uint32_t t : pieces.back().triangles)
    {
      pieces.back().area += areaOf(surface, t);
    }
  }
  return pieces;
}

bool looksLikeASheet(const Surface& surface, const Piece& piece, SheetHandling handling,
  const Meshlines& planes, Execution& execution)
{
  if (piece.triangles.size() == 1)
  {
    return false;
  }
  Surface own = partOf(surface, piece.triangles);
  const std::vector<Hole> holes = closeHoles(own, SurfaceEdges(own, execution), planes, execution);
  if (handling == SheetHandling::Keep)
  {
    return std::any_of(holes.begin(), holes.end(), [](const Hole& hole) { return hole.leak; });
  }
  double lids = 0;
  for (std::size_t t = piece.triangles.size(); t < own.triangles.size(); ++t)
  {
    lids += areaOf(own, t);
  }
  return lids > LeastLids * piece.area;
}

// What open pieces lie on: triangles of others, and the sides of the domain if there are any.
class Walls
{
public:
  Walls(const Surface& surface, const std::vector<Piece>& pieces, const Meshlines& planes,
    Execution& execution)
    : surface_(surface)
    , planes_(planes)
    , nearby_(surface, execution)
    , pieceOf_(surface.triangles.size(), None)
  {
    for (std::uint32_t p = 0; p < pieces.size(); ++p)
    {
      for (const std::uint32_t t : pieces[p].triangles)
      {
        pieceOf_[t] = p;
      }
    }
  }

  // Whether any but this piece's own are at most this far from a place, in levels.
  bool areNear(const Vector& place, double distance, std::uint32_t piece) const
  {
    return isNearSide(place, distance) ||
      nearby_.isAnyNear(place, distance, [&](std::uint32_t t) { return pieceOf_[t] != piece; });
  }

private:
  bool isNearSide(const Vector& place, double distance) const
  {
    for (std::size_t axis = 0; surface_.around.inside() && axis < 3; ++axis)
    {
      const std::vector<Level>& lines = planes_[axis];
      if (std::min(std::abs(place[axis] - double(lines.front())),
            std::abs(place[axis] - double(lines.back()))) <= distance)
      {
        return true;
      }
    }
    return false;
  }

  const Surface& surface_;
  const Meshlines& planes_;
  NearbyTriangles nearby_;
  std::vector<std::uint32_t> pieceOf_; // by triangle; None: of no open piece
};

bool rimLiesOn(const Walls& walls, const Surface& surface, const Piece& piece, std::uint32_t number,
  double tolerance)
{
  const double near = std::max(tolerance, piece.crack());
  return std::all_of(piece.rim.begin(), piece.rim.end(), [&](const auto& edge) {
    const Vector from = toVector(surface.vertices[edge[0]]);
    const Vector to = toVector(surface.vertices[edge[1]]);
    const double bend = LargestSagitta * norm(minus(to, from));
    return walls.areNear(from, near, number) && walls.areNear(to, near, number) &&
      walls.areNear(scaled(plus(from, to), 0.5), std::max(near, bend), number);
  });
}

// Whether most of the lids' area is nearer to walls than to the piece itself.
bool lidsLieOn(const Walls& walls, const Surface& surface, const Piece& piece, std::uint32_t number,
  const Meshlines& planes, Execution& execution)
{
  Surface own = partOf(surface, piece.triangles);
  closeHoles(own, SurfaceEdges(own, execution), planes, execution);
  double all = 0;
  double onWalls = 0;
  for (std::size_t lid = piece.triangles.size(); lid < own.triangles.size(); ++lid)
  {
    const Vector place = middleOf(own, lid);
    double height = std::numeric_limits<double>::max();
    for (std::size_t t = 0; t < piece.triangles.size(); ++t)
    {
      height = std::min(height, norm(minus(nearestPlace(own.corners(t), place), place)));
    }
    all += areaOf(own, lid);
    onWalls += walls.areNear(place, height, number) ? areaOf(own, lid) : 0;
  }
  return onWalls > all / 2;
}

// Those that are open only on the side they lie on, such as letters on a wall, are bodies.
void dropBodiesOnWalls(const Surface& surface, const OpenSheetSpec& spec, const Meshlines& planes,
  std::vector<Piece>& pieces, Execution& execution)
{
  const Walls walls(surface, pieces, planes, execution);
  for (std::uint32_t p = 0; p < pieces.size(); ++p)
  {
    Piece& piece = pieces[p];
    piece.isSheet = piece.isSheet &&
      !(rimLiesOn(walls, surface, piece, p, spec.tolerance) &&
        lidsLieOn(walls, surface, piece, p, planes, execution));
  }
}

// Those whose whole rims lie along rims of others are none.
void dropPatches(const Surface& surface, std::vector<Piece>& pieces)
{
  Surface rims; // triangles without area
  rims.vertices = surface.vertices;
  std::vector<std::uint32_t> all;
  for (std::uint32_t p = 0; p < pieces.size(); ++p)
  {
    for (const auto& [from, to] : pieces[p].rim)
    {
      all.push_back(static_cast<std::uint32_t>(all.size()));
      rims.triangles.push_back({ from, to, to });
      rims.boundary.push_back(static_cast<std::int32_t>(p));
    }
  }
  const NearbyTriangles nearby(rims, all, 0);
  for (std::uint32_t p = 0; p < pieces.size(); ++p)
  {
    Piece& piece = pieces[p];
    const auto isAlong = [&](std::uint32_t v) {
      return nearby.isAnyNear(toVector(surface.vertices[v]), piece.crack(),
        [&](std::uint32_t t) { return rims.boundary[t] != static_cast<std::int32_t>(p); });
    };
    piece.isSheet = piece.isSheet &&
      !std::all_of(piece.rim.begin(), piece.rim.end(),
        [&](const auto& edge) { return isAlong(edge[0]) && isAlong(edge[1]); });
  }
}

// Regions, or the one of a surface without, that have triangles besides those of sheets.
std::map<std::int32_t, bool> boundedRegions(
  const Surface& surface, const std::vector<std::uint8_t>& isOfOne)
{
  std::map<std::int32_t, bool> bounded;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    bounded[surface.region.empty() ? 0 : surface.region[t]] |=
      isOfOne[t] == 0 && !namesAVertexTwice(surface.triangles[t]);
  }
  return bounded;
}

}

OpenSheets findOpenSheets(const Surface& surface, const OpenSheetSpec& spec,
  const std::vector<Baffle>& baffles, const Meshlines& planes, Execution& execution)
{
  OpenSheets found;
  if (spec.handling == SheetHandling::LeaveOut)
  {
    return found;
  }
  std::vector<Piece> pieces = piecesOf(surface, baffles, execution);
  for (Piece& piece : pieces)
  {
    piece.isSheet = looksLikeASheet(surface, piece, spec.handling, planes, execution);
  }
  const auto isSheet = [](const Piece& piece) { return piece.isSheet; };
  if (std::none_of(pieces.begin(), pieces.end(), isSheet))
  {
    return found;
  }
  dropPatches(surface, pieces);
  if (spec.handling == SheetHandling::Automatic)
  {
    dropBodiesOnWalls(surface, spec, planes, pieces, execution);
  }
  std::vector<std::uint8_t> isOfOne(surface.triangles.size());
  for (const Piece& piece : pieces)
  {
    for (const std::uint32_t t : piece.triangles)
    {
      isOfOne[t] = piece.isSheet ? 1 : 0;
    }
  }
  const std::map<std::int32_t, bool> bounded = boundedRegions(surface, isOfOne);
  for (const Piece& piece : pieces)
  {
    const std::uint32_t first = piece.triangles.front();
    const bool isBounded =
      !spec.boundSpaces || bounded.at(surface.region.empty() ? 0 : surface.region[first]);
    if (piece.isSheet && isBounded)
    {
      found.all.push_back({ first, surface.boundary[first], piece.area, middleOf(surface, first) });
    }
    else if (piece.isSheet)
    {
      ++found.boundNothing;
      std::for_each(
        piece.triangles.begin(), piece.triangles.end(), [&](std::uint32_t t) { isOfOne[t] = 0; });
    }
  }
  if (!found.all.empty())
  {
    found.isOfOne = std::move(isOfOne);
  }
  return found;
}

}
