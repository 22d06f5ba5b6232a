// SPDX-License-Identifier: BSD-3-Clause
#include "Mesher/ReachedFluid.h"

#include "Mesher/LeakPath.h"
#include "Mesher/Mesher.h"
#include "Repair/DomainBox.h"
#include "Repair/OpenRims.h"
#include "Repair/ReachedSpaces.h"
#include "Repair/RimsOnWalls.h"

#include <algorithm>
#include <array>

namespace cartesian
{

namespace
{

// Rims this near to a side of the box end there, in levels: of terrain, whose last row may be missing, a global box.
double nearOfTerrain(const PreparedSurface& prepared)
{
  return smallestBoxSide(prepared, 0);
}

class FluidReacher
{
public:
  FluidReacher(const PreparedSurface& prepared, const Options& options, Execution& execution)
    : prepared_(prepared)
    , options_(options)
    , execution_(execution)
    , surface_(prepared.surface)
    , side_(smallestBoxSide(prepared, depthAtSurface(options)))
    , isOfSheet_(prepared.surface.vertices.size())
  {
    const std::vector<std::uint8_t>& open = prepared.openSheets.isOfOne;
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
    {
      for (const std::uint32_t v : surface_.triangles[t])
      {
        const bool is = (t < open.size() && open[t] != 0) || isBaffle(surface_.boundary[t]);
        isOfSheet_[v] = is ? 1 : isOfSheet_[v];
      }
    }
  }

  std::optional<ReachedFluid> run(PreparedSurface& prepared)
  {
    fluid_.openEdges = openEdgesOf(surface_, execution_).size();
    if (fluid_.openEdges == 0)
    {
      return std::nullopt;
    }
    ReachSpec spec{ placesOnLattice(options_.domain.keepPoints, surface_.lattice, prepared_.planes),
      {}, options_.baffles, std::nullopt, std::nullopt };
    findTerrain();
    if (spec.points.empty() && fluid_.seenFrom == DomainSide::NoSide)
    {
      return std::nullopt;
    }
    SurfaceRepair repair;
    repair.loose = dropLoose(surface_, SurfaceEdges(surface_, execution_));
    const double tolerance =
      std::max(options_.contactTolerance / surface_.lattice.step(), CrackSpec::PartOfBox * side_);
    joinRimsToWalls(surface_, tolerance, execution_);
    if (options_.domain.isOutside())
    {
      continueRims(tolerance);
    }
    repair.holes = closeNarrowHoles(surface_, side_, isOfSheet_, prepared_.planes, execution_);
    repair.crossing = std::make_shared<const Surface>(surface_);
    if (options_.domain.isOutside())
    {
      spec.firstOfBox = addSides(surface_, prepared_.planes);
      if (fluid_.seenFrom != DomainSide::NoSide)
      {
        spec.seenFrom = *spec.firstOfBox + 2 * (static_cast<std::size_t>(fluid_.seenFrom) - 1);
      }
    }
    keepOut(spec);
    const Reach reach = keepReached(surface_, spec, execution_);
    if (reach.keptOut)
    {
      tellLeak(reach);
    }
    if (!reach.hasWalls)
    {
      return std::nullopt;
    }
    prepared.repair = std::move(repair);
    prepared.surface = std::move(surface_);
    prepared.openSheets = {};
    return fluid_;
  }

private:
  // What is beyond a domain box is not meshed.
  void keepOut(ReachSpec& spec)
  {
    keepOut_ = keepOutOnLattice(options_.domain.keepOut, surface_, prepared_.planes);
    const auto isNowhere = [&](const KeepPoint& point) {
      return point.isBeyond && options_.domain.isOutside();
    };
    keepOut_.erase(std::remove_if(keepOut_.begin(), keepOut_.end(), isNowhere), keepOut_.end());
    for (const KeepPoint& point : keepOut_)
    {
      spec.keepOut.push_back(point.isBeyond ? std::nullopt : std::optional(point.at));
    }
  }

  // Without a domain box the way may lead around the surface, where there is room.
  [[noreturn]] void tellLeak(const Reach& reach)
  {
    const std::vector<KeepPoint> points =
      onLattice(options_.domain.keepPoints, surface_, prepared_.planes);
    LeakSearch search(prepared_.planes,
      options_.domain.isOutside() ? 0 : roomAround(prepared_.planes), side_,
      prepared_.memoryLimit.bytes);
    search.from = reach.from ? &points[*reach.from] : nullptr;
    search.to = &keepOut_[*reach.keptOut];
    cartesian::tellLeak(surface_, search, execution_);
  }

  void findTerrain()
  {
    const DomainSpec& domain = options_.domain;
    const std::vector<Terrain> found = domain.isOutside()
      ? cartesian::findTerrain(surface_, prepared_.planes, nearOfTerrain(prepared_), execution_)
      : std::vector<Terrain>();
    axisOfTerrain_.assign(
      1 + std::size_t(*std::max_element(surface_.given.begin(), surface_.given.end())), NoAxis);
    for (const Terrain& terrain : found)
    {
      for (const std::uint32_t t : terrain.triangles)
      {
        axisOfTerrain_[surface_.given[t]] = static_cast<std::uint8_t>(terrain.axis);
      }
    }
    if (found.size() != 1 || !domain.keepPoints.empty() ||
      isBaffle(surface_.boundary[found[0].triangle]))
    {
      return;
    }
    const Terrain& terrain = found[0];
    const auto low = static_cast<std::size_t>(2 * terrain.axis + 1); // as in DomainSide
    const auto ground = static_cast<std::size_t>(domain.ground);
    const bool isAbove = ground == low || (ground != low + 1 && terrain.facesUp);
    fluid_.terrain = surface_.boundary[terrain.triangle];
    fluid_.seenFrom = static_cast<DomainSide>(isAbove ? low + 1 : low);
  }

  // Both sides of these are walls, as the user said.
  bool isBaffle(std::int32_t boundary) const
  {
    return std::any_of(options_.baffles.begin(), options_.baffles.end(),
      [&](const Baffle& baffle) { return baffle.boundary == boundary; });
  }

  // Those of terrain around its axis.
  void continueRims(double tolerance)
  {
    std::array<std::vector<std::uint32_t>, NoAxis + 1> triangles;
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
    {
      triangles[axisOfTerrain_[surface_.given[t]]].push_back(t);
    }
    for (std::size_t axis = 0; axis < NoAxis; ++axis)
    {
      continueToSides(
        surface_, prepared_.planes, nearOfTerrain(prepared_), triangles[axis], axis, execution_);
    }
    continueToSides(surface_, prepared_.planes, tolerance, triangles[NoAxis], NoAxis, execution_);
  }

  const PreparedSurface& prepared_;
  const Options& options_;
  Execution& execution_;
  Surface surface_;
  double side_;                             // of the smallest box at the surface, levels
  std::vector<std::uint8_t> isOfSheet_;     // vertices of the surface given
  std::vector<std::uint8_t> axisOfTerrain_; // or NoAxis; by the triangle's number in the view
  std::vector<KeepPoint> keepOut_;
  ReachedFluid fluid_;
};

}

bool mayNeedSides(const PreparedSurface& prepared, const Options& options, Execution& execution)
{
  const DomainSpec& domain = options.domain;
  const bool mayLeak = !domain.keepPoints.empty() && !domain.keepOut.empty();
  if (!(domain.isOutside() || mayLeak) || openEdgesOf(prepared.surface, execution).empty())
  {
    return false;
  }
  return !domain.keepPoints.empty() ||
    !findTerrain(prepared.surface, prepared.planes, nearOfTerrain(prepared), execution).empty();
}

std::optional<ReachedFluid> reachFluid(
  PreparedSurface& prepared, const Options& options, Execution& execution)
{
  const bool mayReach =
    options.domain.isOutside() ? prepared.hasRoom : !options.domain.keepPoints.empty();
  return mayReach ? FluidReacher(prepared, options, execution).run(prepared) : std::nullopt;
}

}
