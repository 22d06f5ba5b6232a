// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/SpaceOwners.h"

#include "Repair/JoinedSides.h"
#include "Surface/Places.h"

#include <algorithm>
#include <map>

namespace cartesian
{

namespace
{

// As a part of the area of all.
constexpr double MostContradicting = 1e-5;

// Which spaces are whose.
class SpaceOwners
{
public:
  SpaceOwners(const Surface& surface, const std::vector<Piece>& pieces, std::int32_t regions,
    Execution& execution)
    : surface_(surface)
    , pieces_(pieces)
    , regions_(regions)
    , sides_(surface, pieces, execution)
    , owner_(2 * pieces.size() + 1)
  {
  }

  Spaces find()
  {
    for (std::int32_t region = FirstRegion; region <= regions_; ++region)
    {
      findSpacesOf(region);
    }
    return spaces();
  }

private:
  double areaOfPiece(std::uint32_t piece) const
  {
    return areaOf(surface_, pieces_[piece].triangles.front());
  }

  std::int32_t netOf(std::uint32_t piece, std::int32_t region) const
  {
    std::int32_t net = 0;
    for (const std::uint32_t t : pieces_[piece].triangles)
    {
      if (surface_.region[t] == region || surface_.region[t] == regionOfCurtains(region, regions_))
      {
        net += faceAlike(surface_.triangles[t], pieces_[piece].vertices) ? 1 : -1;
      }
    }
    return net;
  }

  // Spaces that no earlier region has are joined across the walls of others; the area of a region's own walls, those
  // that point out of a space less those that point into it, tells.
  void findSpacesOf(std::int32_t region)
  {
    DisjointSets spaces(owner_.size());
    std::vector<std::int32_t> net(pieces_.size());
    for (std::uint32_t p = 0; p < pieces_.size(); ++p)
    {
      const auto [behind, front] = beside(p);
      net[p] = netOf(p, region);
      if (net[p] == 0 && owner_[behind] == OutsideRegion && owner_[front] == OutsideRegion)
      {
        spaces.unite(behind, front);
      }
    }
    std::vector<double> inside(owner_.size());
    for (std::uint32_t p = 0; p < pieces_.size(); ++p)
    {
      const auto [behind, front] = beside(p);
      const double area = net[p] * areaOfPiece(p);
      inside[spaces.find(behind)] += area;
      inside[spaces.find(front)] -= area;
    }
    const std::uint32_t around = spaces.find(sides_.farAway());
    for (std::uint32_t s = 0; s < owner_.size(); ++s)
    {
      const std::uint32_t space = spaces.find(s);
      if (owner_[s] == OutsideRegion && space != around && inside[space] > 0)
      {
        owner_[s] = region;
      }
    }
  }

  std::array<std::uint32_t, 2> beside(std::uint32_t piece)
  {
    return { sides_.beside(piece, false), sides_.beside(piece, true) };
  }

  // The pieces of regions that have no space of their own behind them, or one in front: unless these are slivers.
  std::vector<std::uint32_t> contradictions()
  {
    std::vector<std::uint32_t> all;
    double whole = 0;
    double part = 0;
    for (std::uint32_t p = 0; p < pieces_.size(); ++p)
    {
      const double area = areaOfPiece(p);
      whole += area;
      if (contradicts(p))
      {
        all.push_back(p);
        part += area;
      }
    }
    return part > MostContradicting * whole ? all : std::vector<std::uint32_t>();
  }

  bool contradicts(std::uint32_t piece)
  {
    const std::array<std::uint32_t, 2> both = beside(piece);
    return std::any_of(
      pieces_[piece].triangles.begin(), pieces_[piece].triangles.end(), [&](std::uint32_t t) {
        const std::int32_t region = surface_.region[t];
        const bool isForward = faceAlike(surface_.triangles[t], pieces_[piece].vertices);
        const std::int32_t own = owner_[both[isForward ? 0 : 1]];
        const std::int32_t other = owner_[both[isForward ? 1 : 0]];
        return region <= regions_ && netOf(piece, region) != 0 &&
          (own == OutsideRegion || own > region || other == region);
      });
  }

  Spaces spaces()
  {
    Spaces result;
    std::map<std::uint32_t, std::uint32_t> number;
    for (std::uint32_t p = 0; p < pieces_.size(); ++p)
    {
      result.beside.push_back({});
      for (std::size_t i = 0; i < 2; ++i)
      {
        const std::uint32_t space = beside(p)[i];
        const auto [at, isNew] = number.emplace(space, static_cast<std::uint32_t>(number.size()));
        if (isNew)
        {
          result.turns.emplace_back(static_cast<std::size_t>(regions_) + 1);
          result.turns.back()[static_cast<std::size_t>(owner_[space])] = 1;
        }
        result.beside.back()[i] = at->second;
      }
    }
    result.contradictions = contradictions();
    return result;
  }

  const Surface& surface_;
  const std::vector<Piece>& pieces_;
  std::int32_t regions_;
  JoinedSides sides_;
  std::vector<std::int32_t> owner_; // of spaces, as their sides name them
};

}

Spaces findOwners(const Surface& arranged, const std::vector<Piece>& pieces, std::int32_t regions,
  Execution& execution)
{
  return SpaceOwners(arranged, pieces, regions, execution).find();
}

}
