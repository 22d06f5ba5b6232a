// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/UnitedBodies.h"

#include "Repair/Arrangement.h"
#include "Repair/RayCrossings.h"
#include "Repair/Snapping.h"
#include "Repair/TrianglePairs.h"
#include "Surface/Components.h"
#include "Surface/Places.h"

#include <map>
#include <optional>

namespace cartesian
{

namespace
{

// As Spaces.h takes them: bodies, and sheets as a body without volume.
Surface withFlatSheets(const Surface& surface, const std::vector<DroppedTriangle>& sheets)
{
  Surface result = surface;
  result.ofSheet.clear();
  result.byParity.clear();
  result.region.assign(surface.triangles.size(), FirstRegion);
  for (const DroppedTriangle& sheet : sheets)
  {
    result.triangles[sheet.triangle] = sheet.vertices;
    result.region[sheet.triangle] = regionOfSheets(FirstRegion, FirstRegion);
  }
  // Triangles added by the division are dropped; those that close holes come last, and have no number.
  std::size_t kept = 0;
  std::size_t given = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    if (!surface.isOfSheet(t) || result.region[t] != FirstRegion)
    {
      result.triangles[kept] = result.triangles[t];
      result.boundary[kept] = result.boundary[t];
      result.region[kept] = result.region[t];
      if (t < surface.given.size())
      {
        result.given[kept] = result.given[t];
        ++given;
      }
      ++kept;
    }
  }
  result.triangles.resize(kept);
  result.boundary.resize(kept);
  result.region.resize(kept);
  result.given.resize(given);
  return result;
}

// Joins surfaces. Where vertices of two are at the same place, they are the same.
class SurfaceJoin
{
public:
  explicit SurfaceJoin(const Surface& like)
    : like_(like)
  {
  }

  void add(const Surface& from, std::size_t triangle)
  {
    std::array<std::uint32_t, 3> vertices{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Point& place = from.vertices[from.triangles[triangle][i]];
      vertices[i] =
        number_.emplace(place, static_cast<std::uint32_t>(vertices_.size())).first->second;
      if (vertices[i] == vertices_.size())
      {
        vertices_.push_back(place);
      }
    }
    triangles_.push_back(vertices);
    boundary_.push_back(from.boundary[triangle]);
    given_.push_back(triangle < from.given.size() ? from.given[triangle] : ClosesAHole);
    ofSheet_.push_back(from.isOfSheet(triangle) ? 1 : 0);
  }

  Surface finish()
  {
    Surface result = like_;
    result.vertices.swap(vertices_);
    result.triangles.swap(triangles_);
    result.boundary.swap(boundary_);
    result.given.swap(given_);
    result.ofSheet.swap(ofSheet_);
    result.byParity.clear();
    sortByPlace(result);
    return result;
  }

private:
  const Surface& like_;
  std::map<Point, std::uint32_t> number_;
  std::vector<Point> vertices_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<std::int32_t> boundary_;
  std::vector<std::uint32_t> given_;
  std::vector<std::uint8_t> ofSheet_;
};

struct Trial
{
  bool isUnited = false;
  std::optional<Vector> crossing; // where what is beside triangles is not sure, levels
  bool isGivenUp = false;         // another attempt would take as long
  std::vector<std::uint32_t>
    inside = {}; // triangles, by their given numbers, of which something is inside a body
};

// Of a surface's triangles by their given numbers, those of some others.
std::vector<std::uint32_t> givenOf(
  const Surface& surface, const std::vector<std::uint32_t>& triangles)
{
  std::vector<std::uint32_t> given;
  for (const std::uint32_t t : triangles)
  {
    if (t < surface.given.size())
    {
      given.push_back(surface.given[t]);
    }
  }
  return given;
}

Trial tryToUnite(
  Surface& surface, const Placing& placing, const Bodies& bodies, Execution& execution)
{
  if (!canBeArranged(surface, placing))
  {
    return {};
  }
  Surface arranged = surface;
  if (!arrange(arranged, placing, execution))
  {
    return { false, middleOf(surface, 0), true };
  }
  if (!keepsVolume(surface, arranged, placing))
  {
    return { false, middleOf(surface, 0), false };
  }
  std::vector<std::uint32_t> crossing;
  std::vector<std::uint32_t> inside;
  Surface united = arranged;
  if (unite(united, bodies, crossing, execution, &inside))
  {
    surface = std::move(united);
    return { true, std::nullopt, false, givenOf(arranged, inside) };
  }
  return crossing.empty() ? Trial{} : Trial{ false, middleOf(arranged, crossing[0]), false };
}

// A mark for each triangle of bodies that is not among some, which are given by the user's numbers.
std::vector<std::uint8_t> allBut(std::vector<std::uint32_t> some, const Surface& surface)
{
  std::sort(some.begin(), some.end());
  std::vector<std::uint8_t> marks(surface.triangles.size(), 1);
  for (std::size_t t = 0; t < surface.given.size(); ++t)
  {
    const bool isOne = std::binary_search(some.begin(), some.end(), surface.given[t]);
    marks[t] = isOne || surface.isOfSheet(t) ? 0 : 1;
  }
  return marks;
}

// Tries in other ways what was refused, until one succeeds.
void tryOnceMore(Surface& surface, const Bodies& bodies, Trial& trial, Execution& execution)
{
  const std::array<Placing, 4> others = otherPlacingsOf(surface);
  if (surface.rounding > 1)
  {
    // By the precision of the lattice: nearly coplanar faces are then taken as they are given.
    surface.rounding = 1;
    trial = tryToUnite(surface, placingOf(surface), bodies, execution);
  }
  for (std::size_t i = 0; i < others.size() && trial.crossing && !trial.isGivenUp; ++i)
  {
    const Trial next = tryToUnite(surface, others[i], bodies, execution);
    if (next.isUnited || next.isGivenUp)
    {
      trial = next;
    }
  }
}

class GroupUniter
{
public:
  GroupUniter(const Surface& surface, const Surface& flat,
    const std::vector<DroppedTriangle>& sheets, Execution& execution)
    : surface_(surface)
    , flat_(flat)
    , groups_(connectedComponents(surface))
    , tree_(surface, execution)
  {
    for (const DroppedTriangle& sheet : sheets)
    {
      for (const std::uint32_t v : sheet.vertices)
      {
        groups_.unite(v, surface.triangles[sheet.triangle][0]);
      }
    }
    joinWhereTheyMeet(execution);
  }

  // Replaces the surface by one of its groups united, and of the others; false where there are only such. `whole`: of
  // an attempt to unite all groups at once.
  bool run(Surface& result, const std::optional<Trial>& whole, UnitedBodies& united,
    MeshedSide meshed, Execution& execution)
  {
    std::vector<std::uint32_t> inside;
    SurfaceJoin join(surface_);
    std::vector<std::uint8_t> isDone(surface_.vertices.size()); // by the groups' roots
    const auto groups = trianglesOfGroups();
    for (const auto& [root, triangles] : groups)
    {
      Surface part = partOf(flat_, triangles);
      const Bodies bodies{ FirstRegion, {}, meshed, around(root) };
      Trial trial =
        whole && groups.size() == 1 ? *whole : tryToUnite(part, placingOf(part), bodies, execution);
      if (!trial.isUnited && !trial.isGivenUp)
      {
        tryOnceMore(part, bodies, trial, execution);
      }
      if (trial.crossing)
      {
        united.refused.push_back(*trial.crossing);
      }
      isDone[root] = trial.isUnited ? 1 : 0;
      inside.insert(inside.end(), trial.inside.begin(), trial.inside.end());
      for (std::size_t t = 0; trial.isUnited && t < part.triangles.size(); ++t)
      {
        join.add(part, t);
      }
    }
    if (std::find(isDone.begin(), isDone.end(), 1) == isDone.end())
    {
      return false;
    }
    united.touching = allBut(inside, surface_);
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
    {
      const auto& vertices = surface_.triangles[t];
      if (!namesAVertexTwice(vertices) && isDone[groups_.find(vertices[0])] == 0)
      {
        join.add(surface_, t);
        united.touching[t] = 0;
      }
    }
    result = join.finish();
    return true;
  }

private:
  void joinWhereTheyMeet(Execution& execution)
  {
    NearlyFlat nearly{ {}, placingOf(flat_).together, {} };
    for (const auto& t : flat_.triangles)
    {
      nearly.body.push_back(groups_.find(t[0]));
    }
    meets_.resize(flat_.vertices.size());
    const std::vector<TrianglePair> pairs = findPairs(flat_, nearly, execution).pairs;
    for (const TrianglePair& pair : pairs)
    {
      groups_.unite(flat_.triangles[pair.first][0], flat_.triangles[pair.second][0]);
    }
    for (const TrianglePair& pair : pairs)
    {
      meets_[groups_.find(flat_.triangles[pair.first][0])] = 1;
    }
  }

  // Of groups of bodies that cross or touch and are oriented.
  std::map<std::uint32_t, std::vector<std::uint32_t>> trianglesOfGroups()
  {
    std::vector<std::uint8_t> isOriented(flat_.vertices.size(), 1);
    for (std::size_t t = 0; t < surface_.byParity.size(); ++t)
    {
      if (surface_.byParity[t] != 0)
      {
        isOriented[groups_.find(surface_.triangles[t][0])] = 0;
      }
    }
    std::map<std::uint32_t, std::vector<std::uint32_t>> groups;
    for (std::uint32_t t = 0; t < flat_.triangles.size(); ++t)
    {
      const std::uint32_t root = groups_.find(flat_.triangles[t][0]);
      if (meets_[root] != 0 && isOriented[root] != 0 && !namesAVertexTwice(flat_.triangles[t]))
      {
        groups[root].push_back(t);
      }
    }
    return groups;
  }

  // How often the other groups wind around one, by the line to one of its vertices.
  std::int32_t around(std::uint32_t root)
  {
    const Point& at = surface_.vertices[root];
    Winding winding;
    for (const RayCrossing& crossing :
      crossingsOf(surface_, tree_, 0, { at[0], at[1] / 2 * 2, at[2] / 2 * 2 }))
    {
      const std::uint32_t t = crossing.triangle;
      if (crossing.level < at[0] && groups_.find(surface_.triangles[t][0]) != root)
      {
        winding.add(surface_.crossing(t, crossing.up));
      }
    }
    return winding.turns + (winding.odd ? 1 : 0);
  }

  const Surface& surface_;
  const Surface& flat_;
  DisjointSets groups_;             // of vertices
  std::vector<std::uint8_t> meets_; // of the groups' roots: whether bodies cross or touch
  TriangleTree tree_;
};

}

UnitedBodies uniteBodies(Surface& surface, const std::vector<DroppedTriangle>& sheets,
  MeshedSide meshed, Execution& execution)
{
  auto before = std::make_shared<Surface>(std::move(surface));
  const Surface flat = withFlatSheets(*before, sheets);
  std::optional<Trial> whole;
  if (before->byParity.empty())
  {
    surface = flat;
    whole = tryToUnite(surface, placingOf(surface), { FirstRegion, {}, meshed }, execution);
    if (whole->isUnited)
    {
      return { before, {}, allBut(whole->inside, *before) };
    }
  }
  UnitedBodies united;
  if (GroupUniter(*before, flat, sheets, execution).run(surface, whole, united, meshed, execution))
  {
    united.before = before;
  }
  else
  {
    surface = std::move(*before);
  }
  return united;
}

}
