// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/Baffles.h"

#include "Base/DisjointSets.h"
#include "Base/Error.h"
#include "Base/Rings.h"
#include "Lattice/Vector.h"
#include "Repair/BaffleRims.h"
#include "Surface/LineCrossings.h"
#include "Surface/Places.h"
#include "Surface/SurfaceEdges.h"

#include <algorithm>
#include <map>

namespace cartesian
{

namespace
{

constexpr std::uint32_t None = ~0u;

// Rims follow curved walls.
constexpr double LargestSagitta = 0.25;

const Baffle* baffleOf(std::int32_t boundary, const std::vector<Baffle>& baffles)
{
  const auto found = std::find_if(
    baffles.begin(), baffles.end(), [&](const Baffle& b) { return b.boundary == boundary; });
  return found == baffles.end() ? nullptr : &*found;
}

// 1: d lies left of the plane through a, b and c, as one looks from a to b with c to the right; -1: right of it.
int sideOf(const Point& a, const Point& b, const Point& c, const Point& d)
{
  std::array<Wide, 3> u;
  std::array<Wide, 3> v;
  std::array<Wide, 3> w;
  for (std::size_t i = 0; i < 3; ++i)
  {
    u[i] = Wide(b[i]) - a[i];
    v[i] = Wide(c[i]) - a[i];
    w[i] = Wide(d[i]) - a[i];
  }
  const Wide volume = (u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] +
    (u[0] * v[1] - u[1] * v[0]) * w[2];
  return volume > 0 ? 1 : (volume < 0 ? -1 : 0);
}

// One region and its sheets: first the triangles of its surface, then those of the sheets.
class RegionDivider
{
public:
  RegionDivider(Surface both, std::size_t walls, std::string name)
    : both_(std::move(both))
    , walls_(walls)
    , name_(std::move(name))
    , sides_(both_.triangles.size() + (both_.triangles.size() - walls))
  {
  }

  // Appends the surfaces of the parts, numbered from `first`, and returns their number. 0: a sheet does not divide
  // the region.
  std::int32_t run(
    const std::vector<Baffle>& baffles, std::int32_t first, Surface& result, Execution& execution)
  {
    SurfaceEdges(both_, execution)
      .forEach([&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
        connect(lower, begin, end);
      });
    if (!isDivided())
    {
      return 0;
    }
    numberParts();
    for (std::uint32_t t = 0; t < both_.triangles.size(); ++t)
    {
      const bool isSheet = t >= walls_;
      result.append(both_, t);
      result.region.back() = first + partOf(behind(t));
      if (isSheet)
      {
        result.append(both_, t);
        std::swap(result.triangles.back()[1], result.triangles.back()[2]);
        result.boundary.back() = baffleOf(both_.boundary[t], baffles)->back;
        result.region.back() = first + partOf(front(t));
      }
    }
    return parts_;
  }

private:
  // The two sides of a triangle, by number; outside has none.
  static std::uint32_t behind(std::uint32_t t) { return t; }
  std::uint32_t front(std::uint32_t t) const
  {
    return t < walls_ ? None : static_cast<std::uint32_t>(both_.triangles.size() + (t - walls_));
  }

  [[noreturn]] void refuse(std::uint32_t t, const std::string& what) const
  {
    throw Error(Fault::FlawedSurface,
      "A baffle in region " + name_ + " " + what + " near " + placeOf(both_, middleOf(both_, t)) +
        ". Shift it a little there, or divide it into other triangles.");
  }

  const Point& apexOf(std::uint32_t t, std::uint32_t a, std::uint32_t b) const
  {
    const auto& c = both_.triangles[t];
    return both_.vertices[*std::find_if(
      c.begin(), c.end(), [&](std::uint32_t v) { return v != a && v != b; })];
  }

  // Unites the sides that face each other at an edge.
  void connect(std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end)
  {
    std::vector<EdgeUse> uses(begin, end);
    if (std::none_of(begin, end, [&](const EdgeUse& use) { return use.triangle() >= walls_; }))
    {
      for (const EdgeUse& use : uses)
      {
        sides_.unite(behind(begin->triangle()), behind(use.triangle()));
      }
      return;
    }
    sortAround(lower, begin->upper, uses);
    for (std::size_t i = 0; i < uses.size(); ++i)
    {
      const EdgeUse& use = uses[i];
      const EdgeUse& next = following(uses, i);
      const std::uint32_t left = use.down() ? behind(use.triangle()) : front(use.triangle());
      const std::uint32_t right = next.down() ? front(next.triangle()) : behind(next.triangle());
      if ((left == None) != (right == None))
      {
        refuse(std::max(use.triangle(), next.triangle()), "lies outside of it");
      }
      if (left != None)
      {
        sides_.unite(left, right);
      }
    }
  }

  // Counter-clockwise, as one looks down from the upper end.
  void sortAround(std::uint32_t a, std::uint32_t b, std::vector<EdgeUse>& uses) const
  {
    const Point& from = both_.vertices[a];
    const Point& to = both_.vertices[b];
    const Point& first = apexOf(uses[0].triangle(), a, b);
    const auto isOpposite = [&](const Point& p) {
      const Vector along = unit(minus(to, from));
      const auto across = [&](const Vector& v) { return minus(v, scaled(along, dot(v, along))); };
      return dot(across(minus(first, from)), across(minus(p, from))) < 0;
    };
    // 0: as the first, 1: the first half turn from there, 2: opposite, 3: the second half.
    const auto sector = [&](const EdgeUse& use) {
      const Point& apex = apexOf(use.triangle(), a, b);
      const int side = sideOf(from, to, first, apex);
      return side > 0 ? 1 : (side < 0 ? 3 : (isOpposite(apex) ? 2 : 0));
    };
    std::sort(uses.begin(), uses.end(), [&](const EdgeUse& x, const EdgeUse& y) {
      const int s = sector(x);
      const int t = sector(y);
      return s != t ? s < t
                    : sideOf(from, to, apexOf(x.triangle(), a, b), apexOf(y.triangle(), a, b)) > 0;
    });
    for (std::size_t i = 0; i + 1 < uses.size(); ++i)
    {
      if (sector(uses[i]) == sector(uses[i + 1]) &&
        sideOf(from, to, apexOf(uses[i].triangle(), a, b), apexOf(uses[i + 1].triangle(), a, b)) ==
          0)
      {
        refuse(
          std::max(uses[i].triangle(), uses[i + 1].triangle()), "lies on a wall or another baffle");
      }
    }
  }

  bool isDivided()
  {
    for (auto t = static_cast<std::uint32_t>(walls_); t < both_.triangles.size(); ++t)
    {
      if (sides_.find(behind(t)) == sides_.find(front(t)))
      {
        return false;
      }
    }
    return true;
  }

  // Those with sheets around them; then cavities are put into them, and other bodies into the first.
  void numberParts()
  {
    const auto count = static_cast<std::uint32_t>(both_.triangles.size());
    std::vector<std::uint32_t> roots;
    for (auto t = static_cast<std::uint32_t>(walls_); t < count; ++t)
    {
      roots.push_back(sides_.find(behind(t)));
      roots.push_back(sides_.find(front(t)));
    }
    std::sort(roots.begin(), roots.end());
    roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
    for (const std::uint32_t root : roots)
    {
      number_[root] = parts_++;
    }
    for (std::uint32_t t = 0; t < walls_; ++t)
    {
      const std::uint32_t root = sides_.find(behind(t));
      if (number_.count(root) == 0)
      {
        number_[root] = partAround(t);
      }
    }
  }

  // The part in which a shell without sheets lies, found by a line from it to the end of the grid.
  std::int32_t partAround(std::uint32_t shell)
  {
    const Point& start = both_.vertices[both_.triangles[shell][0]];
    const std::vector<Level> middles{ start[1] + 1 };
    const std::vector<Level> outers{ start[2] + 1 };
    std::map<std::int32_t, int> turns;
    const auto cross = [&](std::uint32_t t, std::uint32_t side, int way) {
      const auto part = number_.find(sides_.find(side));
      if (part == number_.end())
      {
        return;
      }
      forEachLineCrossing(both_.corners(t), RowsAlong[0], middles, outers,
        [&](std::size_t, std::size_t, const Point& p, bool up) {
          turns[part->second] += p[0] < start[0] ? (up ? -way : way) : 0;
        });
    };
    for (std::uint32_t t = 0; t < both_.triangles.size(); ++t)
    {
      cross(t, behind(t), 1);
      if (t >= walls_)
      {
        cross(t, front(t), -1);
      }
    }
    for (const auto& [part, count] : turns)
    {
      if (count > 0)
      {
        return part;
      }
    }
    return 0;
  }

  std::int32_t partOf(std::uint32_t side) { return number_.at(sides_.find(side)); }

  Surface both_;
  std::size_t walls_;
  std::string name_;
  DisjointSets sides_;
  std::map<std::uint32_t, std::int32_t> number_; // of the part that a set of sides is around
  std::int32_t parts_ = 0;
};

// Takes triangles out of a surface.
template <class IsTaken>
Surface take(Surface& surface, IsTaken&& isTaken)
{
  Surface left;
  Surface taken;
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
  taken.lattice = surface.lattice;
  taken.vertices = surface.vertices;
  surface.triangles.swap(left.triangles);
  surface.boundary.swap(left.boundary);
  surface.given.swap(left.given);
  surface.region.swap(left.region);
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
    Surface both;
    both.lattice = surface.lattice;
    both.vertices = surface.vertices;
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
      count = RegionDivider(both, walls, nameOf(region)).run(baffles, first, result, execution);
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
