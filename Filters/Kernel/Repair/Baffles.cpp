// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/Baffles.h"

#include "Base/Error.h"
#include "Repair/BaffleRims.h"
#include "Repair/JoinedSides.h"
#include "Repair/RadialEdgeSort.h"
#include "Surface/Places.h"
#include "Surface/SurfaceEdges.h"

#include <algorithm>
#include <map>

namespace cartesian
{

namespace
{

// Rims follow curved walls.
constexpr double LargestSagitta = 0.25;

const Baffle* baffleOf(std::int32_t boundary, const std::vector<Baffle>& baffles)
{
  const auto found = std::find_if(
    baffles.begin(), baffles.end(), [&](const Baffle& b) { return b.boundary == boundary; });
  return found == baffles.end() ? nullptr : &*found;
}

// One region and its sheets: first the triangles of its surface, then those of the sheets.
class RegionDivider
{
public:
  RegionDivider(const Surface& both, std::size_t walls, std::string name, Execution& execution)
    : both_(both)
    , walls_(walls)
    , name_(std::move(name))
    , pieces_(piecesOf(both))
    , pieceOf_(both.triangles.size())
    , sides_(both, pieces_, execution)
  {
    for (std::uint32_t p = 0; p < pieces_.size(); ++p)
    {
      for (const std::uint32_t t : pieces_[p].triangles)
      {
        pieceOf_[t] = p;
      }
    }
    requireInside(execution);
  }

  // Appends the surfaces of the parts, numbered from `first`, and returns their number. 0: a sheet does not divide
  // the region.
  std::int32_t run(const std::vector<Baffle>& baffles, std::int32_t first, Surface& result)
  {
    if (!isDivided())
    {
      return 0;
    }
    const std::int32_t parts = numberParts();
    for (std::uint32_t t = 0; t < both_.triangles.size(); ++t)
    {
      result.append(both_, t);
      result.region.back() = first + partOf(spaceBeside(t, false));
      if (isOfSheet(t))
      {
        result.append(both_, t);
        std::swap(result.triangles.back()[1], result.triangles.back()[2]);
        result.boundary.back() = baffleOf(both_.boundary[t], baffles)->back;
        result.region.back() = first + partOf(spaceBeside(t, true));
      }
    }
    return parts;
  }

private:
  bool isOfSheet(std::uint32_t t) const { return t >= walls_; }

  std::uint32_t spaceBeside(std::uint32_t t, bool front)
  {
    const std::uint32_t piece = pieceOf_[t];
    return sides_.beside(piece, front == faceAlike(both_.triangles[t], pieces_[piece].vertices));
  }

  [[noreturn]] void refuse(std::uint32_t t, const std::string& what) const
  {
    throw Error(Fault::FlawedSurface,
      "A baffle in region " + name_ + " " + what + " near " + placeOf(both_, middleOf(both_, t)) +
        ". Shift it a little there, or divide it into other triangles.");
  }

  // Around edges of sheets.
  void requireInside(Execution& execution) const
  {
    RadialEdgeSort fan(both_.vertices);
    SurfaceEdges(both_, execution)
      .forEach([&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
        fan.start(lower, begin->upper);
        bool anySheet = false;
        for (const EdgeUse* use = begin; use != end; ++use)
        {
          fan.add(use->triangle(), both_.triangles[use->triangle()], use->down());
          anySheet = anySheet || isOfSheet(use->triangle());
        }
        if (anySheet)
        {
          requireInside(fan);
        }
      });
  }

  void requireInside(RadialEdgeSort& fan) const
  {
    fan.forEachSpace([&](const RadialEdgeSort::IncidentTriangle& one,
                       const RadialEdgeSort::IncidentTriangle& next) {
      const std::uint32_t last = std::max(one.triangle, next.triangle);
      if (one.triangle != next.triangle && fan.coincide(one, next))
      {
        refuse(last, "lies on a wall or another baffle");
      }
      const bool isOutsideOne = !isOfSheet(one.triangle) && !one.down;
      const bool isOutsideNext = !isOfSheet(next.triangle) && next.down;
      if (isOutsideOne != isOutsideNext)
      {
        refuse(last, "lies outside of it");
      }
    });
  }

  bool isDivided()
  {
    for (auto t = static_cast<std::uint32_t>(walls_); t < both_.triangles.size(); ++t)
    {
      if (spaceBeside(t, false) == spaceBeside(t, true))
      {
        return false;
      }
    }
    return true;
  }

  // The spaces beside sheets, in order of their first walls. Returns their number.
  std::int32_t numberParts()
  {
    for (auto t = static_cast<std::uint32_t>(walls_); t < both_.triangles.size(); ++t)
    {
      part_[spaceBeside(t, false)] = Unnumbered;
      part_[spaceBeside(t, true)] = Unnumbered;
    }
    std::int32_t parts = 0;
    const auto add = [&](std::int32_t& part) { part = part == Unnumbered ? parts++ : part; };
    for (std::uint32_t t = 0; t < walls_; ++t)
    {
      if (const auto part = part_.find(spaceBeside(t, false)); part != part_.end())
      {
        add(part->second);
      }
    }
    for (auto& [space, part] : part_)
    {
      add(part); // with sheets all around
    }
    return parts;
  }

  // Other bodies of the region belong to the first.
  std::int32_t partOf(std::uint32_t space) const
  {
    const auto part = part_.find(space);
    return part == part_.end() ? 0 : part->second;
  }

  static constexpr std::int32_t Unnumbered = -1;

  const Surface& both_;
  std::size_t walls_;
  std::string name_;
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> pieceOf_; // of each triangle
  JoinedSides sides_;
  std::map<std::uint32_t, std::int32_t> part_; // of spaces beside sheets
};

// Takes triangles out of a surface.
template <class IsTaken>
Surface take(Surface& surface, IsTaken&& isTaken)
{
  Surface left;
  Surface taken = surface.withoutTriangles();
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    if (isTaken(t))
    {
      taken.append(surface, t);
    }
    else
    {
      left.append(surface, t);
      left.ofSheet.push_back(surface.isOfSheet(t) ? 1 : 0);
    }
  }
  surface.takeTriangles(left);
  if (!surface.ofSheet.empty())
  {
    surface.ofSheet.swap(left.ofSheet);
  }
  return taken;
}

}

Surface takeBaffles(Surface& surface, const std::vector<Baffle>& baffles)
{
  return take(
    surface, [&](std::size_t t) { return baffleOf(surface.boundary[t], baffles) != nullptr; });
}

std::optional<RegionParts> divideByBaffles(Surface& surface, Surface sheets,
  const std::vector<Baffle>& baffles, std::int32_t regions, double tolerance,
  const std::vector<std::string>& names, Execution& execution)
{
  const auto nameOf = [&](std::int32_t region) {
    const auto n = static_cast<std::size_t>(region - FirstRegion);
    return n < names.size() ? "\"" + names[n] + "\"" : std::to_string(region);
  };
  if (!joinRims(surface, sheets, { tolerance, LargestSagitta }, execution).all)
  {
    return std::nullopt;
  }
  Surface result;
  result.lattice = surface.lattice;
  result.vertices = surface.vertices;
  RegionParts parts;
  for (std::int32_t region = FirstRegion; region < FirstRegion + regions; ++region)
  {
    Surface both = surface.withoutTriangles();
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
      if (surface.region[t] == region)
      {
        both.append(surface, t);
      }
    }
    const std::size_t walls = both.triangles.size();
    for (std::size_t t = 0; t < sheets.triangles.size(); ++t)
    {
      if (sheets.region[t] == region)
      {
        both.append(sheets, t);
      }
    }
    const bool isDivided = walls < both.triangles.size();
    const auto first = FirstRegion + static_cast<std::int32_t>(parts.given.size());
    std::int32_t count = 1;
    if (isDivided)
    {
      count = RegionDivider(both, walls, nameOf(region), execution).run(baffles, first, result);
      if (count == 0)
      {
        return std::nullopt;
      }
    }
    for (std::size_t t = 0; !isDivided && t < walls; ++t)
    {
      result.append(both, t);
      result.region.back() = first;
    }
    parts.given.insert(parts.given.end(), static_cast<std::size_t>(count), region);
  }
  surface = std::move(result);
  return parts;
}

void doubleSheets(Surface& surface, const std::vector<Baffle>& baffles,
  const std::vector<std::uint8_t>& open, double tolerance, Execution& execution)
{
  const bool hasRegions = !surface.region.empty();
  surface.region.resize(surface.triangles.size(), FirstRegion);
  Surface sheets = take(surface, [&](std::size_t t) {
    return (t < open.size() && open[t] != 0) || baffleOf(surface.boundary[t], baffles);
  });
  joinRims(surface, sheets, { tolerance, LargestSagitta }, execution);
  surface.ofSheet.assign(surface.triangles.size(), 0);
  for (std::size_t t = 0; t < sheets.triangles.size(); ++t)
  {
    surface.append(sheets, t);
    if (const Baffle* const baffle = baffleOf(sheets.boundary[t], baffles))
    {
      surface.boundary.back() = baffle->back;
    }
    surface.append(sheets, t);
    std::swap(surface.triangles.back()[1], surface.triangles.back()[2]);
  }
  if (!hasRegions)
  {
    surface.region.clear();
  }
  surface.ofSheet.resize(surface.triangles.size(), 1);
}

}
