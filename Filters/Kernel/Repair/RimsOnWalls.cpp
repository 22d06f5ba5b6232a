// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/RimsOnWalls.h"

#include "Repair/BaffleRims.h"
#include "Repair/NearbyTriangles.h"
#include "Repair/OpenPieces.h"

#include <algorithm>
#include <map>

namespace cartesian
{

namespace
{

// Walls may bend away from an edge of a rim by this part of its length.
constexpr double LargestSagitta = 0.25;

void include(const Vector& place, double aside, Bounds& bounds)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds.include(axis, place[static_cast<std::size_t>(axis)] - aside);
    bounds.include(axis, place[static_cast<std::size_t>(axis)] + aside);
  }
}

bool meets(const Corners& c, const Bounds& bounds)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto [least, most] = std::minmax({ c[0][axis], c[1][axis], c[2][axis] });
    if (double(most) < bounds.low[axis] || double(least) > bounds.high[axis])
    {
      return false;
    }
  }
  return true;
}

class RimsOnWalls
{
public:
  RimsOnWalls(Surface& surface, double tolerance, Execution& execution)
    : surface_(surface)
    , tolerance_(tolerance)
    , execution_(execution)
    , pieces_(openPiecesOf(surface, {}, execution))
  {
    for (std::size_t p = 0; p < pieces_.size(); ++p)
    {
      for (const std::uint32_t t : pieces_[p].triangles)
      {
        pieceOf_[surface.given[t]] = p;
      }
    }
  }

  void run()
  {
    surface_.region.assign(surface_.triangles.size(), FirstRegion);
    for (const std::size_t piece : piecesOnWalls())
    {
      join(piece);
    }
    surface_.region.clear();
  }

private:
  bool isOf(std::size_t piece, std::uint32_t given) const
  {
    const auto found = pieceOf_.find(given);
    return found != pieceOf_.end() && found->second == piece;
  }

  // With a corner of a rim near something else.
  std::vector<std::size_t> piecesOnWalls() const
  {
    const NearbyTriangles nearby(surface_, execution_);
    std::vector<std::size_t> found;
    for (std::size_t p = 0; p < pieces_.size(); ++p)
    {
      const auto isOnWall = [&](const auto& edge) {
        return nearby.isAnyNear(toVector(surface_.vertices[edge[0]]), tolerance_,
          [&](std::uint32_t t) { return !isOf(p, surface_.given[t]); });
      };
      if (std::any_of(pieces_[p].rim.begin(), pieces_[p].rim.end(), isOnWall))
      {
        found.push_back(p);
      }
    }
    return found;
  }

  // Divides the walls near the rims of a piece, and the piece.
  void join(std::size_t piece)
  {
    Bounds bounds = Bounds::none();
    for (const auto& [from, to] : pieces_[piece].rim)
    {
      const Vector start = toVector(surface_.vertices[from]);
      const Vector end = toVector(surface_.vertices[to]);
      const double aside = tolerance_ + LargestSagitta * norm(minus(end, start));
      include(start, aside, bounds);
      include(end, aside, bounds);
    }
    Surface walls = surface_.withoutTriangles();
    Surface own = walls;
    Surface rest = walls;
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
    {
      const bool isOwn = isOf(piece, surface_.given[t]);
      const bool isNear = !isOwn && meets(surface_.corners(t), bounds);
      (isOwn ? own : (isNear ? walls : rest)).append(surface_, t);
    }
    if (walls.triangles.empty())
    {
      return;
    }
    joinRims(walls, own, { tolerance_, LargestSagitta }, execution_);
    for (const Surface* from : { &walls, &own })
    {
      for (std::size_t t = 0; t < from->triangles.size(); ++t)
      {
        rest.append(*from, t);
      }
    }
    surface_.vertices.swap(walls.vertices);
    surface_.takeTriangles(rest);
  }

  Surface& surface_;
  double tolerance_;
  Execution& execution_;
  std::vector<OpenPiece> pieces_;
  std::map<std::uint32_t, std::size_t> pieceOf_; // by the triangle's number in the view
};

}

void joinRimsToWalls(Surface& surface, double tolerance, Execution& execution)
{
  RimsOnWalls(surface, tolerance, execution).run();
}

}
