// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/BoxGeneration.h"

#include "Base/Error.h"
#include "Boxes/Balance.h"
#include "Boxes/FewestBoxes.h"
#include "Boxes/UnitStatuses.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t RowsAChunk = 16;
constexpr std::size_t GlobalsAChunk = 64;

// Divides global boxes; undivided ones keep an empty list of parts.
class BoxGenerator
{
public:
  BoxGenerator(const Surface& surface, const Meshlines& planes, const Shoeboxes& shoeboxes,
    const Refinement& refinement, const GlobalStatuses& statuses, Layers core, Layers layers,
    Execution& execution)
    : surface_(surface)
    , planes_(planes)
    , shoeboxes_(shoeboxes)
    , refinement_(refinement)
    , statuses_(statuses)
    , layers_(layers)
    , execution_(execution)
  {
    boxes_.lattice = surface.lattice;
    boxes_.planes = planes;
    boxes_.planes.planeLevel = std::max(planes.planeLevel, refinement.deepest());
    boxes_.core = core;
    boxes_.ends = surface.ends;
  }

  // `kept`: the layers that stay once the boxes are balanced.
  Boxes generate(Layers kept)
  {
    listGlobals();
    if (refinement_.any())
    {
      findDepths();
      divide();
      for (int level = refinement_.deepest(); level > 0; --level)
      {
        for (int layer = 1; layer < refinement_.transitionLayers(); ++layer)
        {
          flatten();
          balance(growthOf(level));
        }
        if (level > 1)
        {
          flatten();
          balance(balanceOf(level - 1));
        }
      }
    }
    leaveOutAllBut(kept);
    flatten();
    if (surface_.walls.any())
    {
      findRegions();
    }
    return std::move(boxes_);
  }

private:
  template <class Visitor>
  void forEachRow(Visitor&& visit)
  {
    const std::size_t rowsAlongY = planes_[1].size() - 1;
    const std::size_t first = boxes_.row(0, layers_.begin);
    const std::size_t count = boxes_.row(0, layers_.end) - first;
    execution_.forEach(count, RowsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = first + begin; row < first + end; ++row)
      {
        visit(row, static_cast<std::uint32_t>(row % rowsAlongY),
          static_cast<std::uint32_t>(row / rowsAlongY));
      }
    });
  }

  template <class Visitor>
  void forEachGlobal(Visitor&& visit)
  {
    execution_.forEach(statusOf_.size(), GlobalsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t g = begin; g < end; ++g)
      {
        visit(g);
      }
    });
  }

  void listGlobals()
  {
    boxes_.rowStart.assign((planes_[1].size() - 1) * (planes_[2].size() - 1) + 1, 0);
    forEachRow([&](std::size_t row, std::uint32_t j, std::uint32_t k) {
      statuses_.forEachBox(j, k, [&](std::uint32_t, BoxStatus) { ++boxes_.rowStart[row]; });
    });
    const std::size_t count = scan(boxes_.rowStart);
    if (count >= None)
    {
      throw Error(Fault::TooManyBoxes,
        "The mesh has more boxes than can be numbered in 32 bits: choose a larger Cell Size.");
    }
    boxes_.globals.resize(count + 1);
    boxes_.globals.back() = { { 0, 0, 0 }, 0, None, 0, 0 };
    statusOf_.resize(count);
    forEachRow([&](std::size_t row, std::uint32_t j, std::uint32_t k) {
      std::size_t next = boxes_.rowStart[row];
      statuses_.forEachBox(j, k, [&](std::uint32_t i, BoxStatus status) {
        boxes_.globals[next] = { { i, j, k }, 0, None, 0, 0 };
        statusOf_[next++] = status;
      });
    });
  }

  TriangleRange trianglesOf(const GlobalBox& global) const
  {
    return shoeboxes_.triangles(boxes_.row(global.index[1], global.index[2]), global.index[0]);
  }

  std::uint8_t cornersOf(std::size_t g) const
  {
    const auto& at = boxes_.globals[g].index;
    return statuses_.corners(at[0], at[1], at[2], statusOf_[g]);
  }

  void findDepths()
  {
    depths_.resize(statusOf_.size());
    parts_.resize(statusOf_.size());
    forEachGlobal([&](std::size_t g) {
      const auto& at = boxes_.globals[g].index;
      depths_[g] = refinement_.at(at[0], at[1], at[2]);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const Level size = planes_[axis][at[axis] + 1] - planes_[axis][at[axis]];
        const Level least =
          std::max(leastWidth(depths_[g].deepest()), Level(2) << refinement_.deepest());
        if (depths_[g].deepest() > 0 && size < least)
        {
          throw Error(Fault::BadParameter,
            "Global box " + std::to_string(at[0]) + ", " + std::to_string(at[1]) + ", " +
              std::to_string(at[2]) + " is too thin to be divided on this lattice, which has " +
              number(LevelsOfTheDomain) +
              " levels along the whole grid: choose a larger Cell Size, refine less, or make the "
              "domain smaller.");
        }
      }
    });
  }

  // What the division of a global box needs.
  struct DivisionScratch
  {
    FewestBoxes search;
    UnitStatuses statuses;
    UnitStatuses ofRegion;
    std::vector<BoxStatus> units;
    std::vector<std::uint8_t> forced;
  };

  void divide()
  {
    execution_.nextLoop(0.8);
    execution_.forEach(statusOf_.size(), GlobalsAChunk, [&](std::size_t begin, std::size_t end) {
      DivisionScratch scratch;
      for (std::size_t g = begin; g < end; ++g)
      {
        const bool intersected = statusOf_[g] == BoxStatus::Intersected;
        if (depths_[g].inPart() || (intersected && depths_[g].allowed > 0))
        {
          divideByUnits(g, scratch);
        }
        else if (depths_[g].forced > 0)
        {
          divideEvenly(depths_[g].forced, parts_[g]);
        }
      }
    });
  }

  void divideByUnits(std::size_t g, DivisionScratch& scratch)
  {
    const GlobalBox& global = boxes_.globals[g];
    const Depths& depths = depths_[g];
    refinement_.forcedOfUnits(global.index, depths, scratch.ofRegion, scratch.forced);
    if (statusOf_[g] != BoxStatus::Intersected)
    {
      scratch.units.assign(scratch.forced.size(), statusOf_[g]);
      scratch.search.search(depths.deepest(), depths.allowed, scratch.units, scratch.forced);
      scratch.search.collect(parts_[g]);
      return;
    }
    scratch.statuses.compute(surface_, trianglesOf(global), planes_, global.index, depths.deepest(),
      statuses_.lowCorner(global.index));
    scratch.search.search(
      depths.deepest(), depths.allowed, scratch.statuses.units(), scratch.forced);
    scratch.search.collect(parts_[g]);
    for (LocalBox& box : parts_[g])
    {
      box.corners = scratch.statuses.corners(box.offset, box.level);
    }
  }

  static void divideEvenly(int depth, std::vector<LocalBox>& parts)
  {
    const auto level = static_cast<std::uint8_t>(depth);
    const std::int64_t step = FinePerBox >> depth;
    for (std::int64_t z = 0; z < FinePerBox; z += step)
    {
      for (std::int64_t y = 0; y < FinePerBox; y += step)
      {
        for (std::int64_t x = 0; x < FinePerBox; x += step)
        {
          parts.push_back({ { static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
                              static_cast<std::uint16_t>(z) },
            { level, level, level }, BoxStatus::Inside, AllCorners });
        }
      }
    }
  }

  void leaveOutAllBut(Layers kept)
  {
    const std::size_t first = boxes_.rowStart[boxes_.row(0, kept.begin)];
    const std::size_t end = boxes_.rowStart[boxes_.row(0, kept.end)];
    const auto slice = [&](auto& ofGlobals) {
      if (!ofGlobals.empty())
      {
        ofGlobals.erase(ofGlobals.begin() + std::ptrdiff_t(end), ofGlobals.end());
        ofGlobals.erase(ofGlobals.begin(), ofGlobals.begin() + std::ptrdiff_t(first));
      }
    };
    slice(boxes_.globals);
    boxes_.globals.push_back({ { 0, 0, 0 }, 0, None, 0, 0 });
    slice(statusOf_);
    slice(parts_);
    for (std::size_t& start : boxes_.rowStart)
    {
      start = std::clamp(start, first, end) - first;
    }
  }

  // Lists the parts of all global boxes in boxes_.
  void flatten()
  {
    std::uint32_t next = 0;
    for (std::size_t g = 0; g < parts_.size(); ++g)
    {
      boxes_.globals[g].firstBox = next;
      next += static_cast<std::uint32_t>(isDivided(g) ? parts_[g].size() : 1);
    }
    boxes_.globals.back().firstBox = parts_.empty() ? std::uint32_t(statusOf_.size()) : next;
    boxes_.packed.resize(boxes_.globals.back().firstBox);
    forEachGlobal([&](std::size_t g) { flatten(g); });
    if (!parts_.empty())
    {
      boxes_.listUnits();
    }
  }

  // The regions of all corners of all boxes.
  void findRegions()
  {
    boxes_.regions.resize(boxes_.packed.size());
    forEachGlobal([&](std::size_t g) {
      for (std::uint32_t b = boxes_.globals[g].firstBox; b < boxes_.globals[g + 1].firstBox; ++b)
      {
        for (unsigned corner = 0; corner < 8; ++corner)
        {
          boxes_.regions[b][corner] = regionAt(g, boxes_.box(b), corner);
        }
      }
    });
  }

  std::int32_t regionAt(std::size_t g, const Box& box, unsigned corner) const
  {
    const auto& at = boxes_.globals[g].index;
    std::array<std::uint32_t, 3> vertex = at;
    bool isVertex = true; // of the global mesh
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      const std::int64_t fine = box.offset[axis] +
        ((corner >> axis & 1) != 0 ? Boxes::fineSize(box, static_cast<int>(axis)) : 0);
      isVertex = isVertex && fine % FinePerBox == 0;
      vertex[axis] += fine == FinePerBox ? 1 : 0;
    }
    if (isVertex)
    {
      return statuses_.lowCorner(vertex).region();
    }
    const Point low = { planes_[0][at[0]], planes_[1][at[1]], planes_[2][at[2]] };
    return windingAt(
      surface_, trianglesOf(boxes_.globals[g]), low, statuses_.lowCorner(at), cornerOf(box, corner))
      .region();
  }

  bool isDivided(std::size_t g) const { return !parts_.empty() && !parts_[g].empty(); }

  void flatten(std::size_t g)
  {
    GlobalBox& global = boxes_.globals[g];
    global.firstBox = parts_.empty() ? std::uint32_t(g) : global.firstBox;
    std::uint32_t next = global.firstBox;
    if (!isDivided(g))
    {
      boxes_.packed[next] = packed(g, { { 0, 0, 0 }, { 0, 0, 0 }, statusOf_[g], cornersOf(g) });
      return;
    }
    std::sort(parts_[g].begin(), parts_[g].end(), [](const LocalBox& a, const LocalBox& b) {
      return std::lexicographical_compare(
        a.offset.rbegin(), a.offset.rend(), b.offset.rbegin(), b.offset.rend());
    });
    for (const LocalBox& part : parts_[g])
    {
      global.depth = std::max({ global.depth, part.level[0], part.level[1], part.level[2] });
      boxes_.packed[next++] = packed(g, part);
    }
  }

  static PackedBox packed(std::size_t g, const LocalBox& part)
  {
    return { static_cast<std::uint32_t>(g), part.offset, part.level, part.corners, part.status };
  }

  // One pass (Balance.h).
  void balance(const BalancePass& pass)
  {
    forEachGlobal([&](std::size_t g) {
      const std::uint32_t first = boxes_.globals[g].firstBox;
      const std::uint32_t end = boxes_.globals[g + 1].firstBox;
      std::vector<LocalBox> parts;
      bool changed = false;
      for (std::uint32_t b = first; b < end; ++b)
      {
        const PackedBox& box = boxes_.packed[b];
        changed |= balance(g, { box.offset, box.level, box.status, box.corners }, pass, parts);
      }
      if (changed)
      {
        parts_[g].swap(parts);
      }
    });
  }

  // Appends what a pass makes of a box, without parts that are outside; true if it was halved.
  bool balance(
    std::size_t g, const LocalBox& box, const BalancePass& pass, std::vector<LocalBox>& parts) const
  {
    const unsigned axes = axesToHalve(boxes_, packed(g, box), pass);
    if (axes == 0)
    {
      parts.push_back(box);
      return false;
    }
    for (unsigned upper = 0; upper < 8; ++upper)
    {
      if ((upper & ~axes) != 0)
      {
        continue; // not halved along one of these axes
      }
      const LocalBox part = partOf(g, box, axes, upper);
      if (part.status != BoxStatus::Outside)
      {
        balance(g, part, pass, parts);
      }
    }
    return true;
  }

  // The part of a box that is halved along these axes on the upper sides of some of them.
  LocalBox partOf(std::size_t g, const LocalBox& whole, unsigned axes, unsigned upper) const
  {
    LocalBox part = whole;
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      if ((axes >> axis & 1) != 0)
      {
        part = halfOf(part, axis, (upper >> axis & 1) != 0);
      }
    }
    if (whole.status == BoxStatus::Intersected)
    {
      findStatus(g, part);
    }
    return part;
  }

  void findStatus(std::size_t g, LocalBox& part) const
  {
    const Box box = boxes_.placed(packed(g, part));
    const TriangleRange triangles = trianglesOf(boxes_.globals[g]);
    const auto& at = boxes_.globals[g].index;
    const Point corner = { planes_[0][at[0]], planes_[1][at[1]], planes_[2][at[2]] };
    const Winding low = statuses_.lowCorner(at);
    unsigned bits = 0;
    for (unsigned c = 0; c < 8; ++c)
    {
      const bool in = windingAt(surface_, triangles, corner, low, cornerOf(box, c)).inside();
      bits |= static_cast<unsigned>(in) << c;
    }
    part.corners = static_cast<std::uint8_t>(bits);
    part.status = (bits & 1) != 0 ? BoxStatus::Inside : BoxStatus::Outside;
    for (const std::uint32_t* t = triangles.first; t != triangles.second; ++t)
    {
      if (clip(surface_.corners(*t), box.low, box.high).size > 0)
      {
        part.status = BoxStatus::Intersected;
        return;
      }
    }
  }

  const Surface& surface_;
  const Meshlines& planes_;
  const Shoeboxes& shoeboxes_;
  const Refinement& refinement_;
  const GlobalStatuses& statuses_;
  Layers layers_;
  Execution& execution_;
  Boxes boxes_;
  RawVector<BoxStatus> statusOf_; // of global boxes
  std::vector<Depths> depths_;
  std::vector<std::vector<LocalBox>> parts_; // of divided global boxes
};

}

Boxes generateBoxes(const Surface& surface, const Meshlines& planes, const Shoeboxes& shoeboxes,
  const Refinement& refinement, const GlobalStatuses& statuses, Layers core, Layers kept,
  Execution& execution)
{
  const auto end = static_cast<std::uint32_t>(planes[2].size() - 1);
  const Layers layers =
    kept.grown(balanceReach(refinement.deepest(), refinement.transitionLayers()), end);
  return BoxGenerator(surface, planes, shoeboxes, refinement, statuses, core, layers, execution)
    .generate(kept);
}

}
