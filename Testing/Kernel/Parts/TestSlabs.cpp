// What slabs promise: cells change in one slab of a stage only, and no part sees less than it needs.
#include "Parts/Slabs.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

bool contains(Layers outer, Layers inner)
{
  return outer.begin <= inner.begin && inner.end <= outer.end;
}

}

TEST(Slabs, OfAStageChangeDisjointLayersThatTheySee)
{
  for (std::uint32_t all = 1; all < 80; ++all)
  {
    for (const std::vector<Slab>& stage : slabsFor({ 0, all }, all))
    {
      std::uint32_t end = 0;
      for (const Slab& slab : stage)
      {
        EXPECT_TRUE(contains(slab.layers, slab.free));
        EXPECT_TRUE(contains(slab.free, slab.acting));
        EXPECT_LE(end, slab.free.begin);
        end = slab.free.end;
      }
      EXPECT_LE(end, all);
    }
  }
}

TEST(Slabs, ActOnEveryLayer)
{
  for (std::uint32_t all = 1; all < 80; ++all)
  {
    std::vector<bool> acted(all);
    for (const std::vector<Slab>& stage : slabsFor({ 0, all }, all))
    {
      for (const Slab& slab : stage)
      {
        std::fill(acted.begin() + slab.acting.begin, acted.begin() + slab.acting.end, true);
      }
    }
    EXPECT_EQ(std::count(acted.begin(), acted.end(), false), 0) << all;
  }
}

// The slabs of a part are slabs of the whole grid: parts agree with the whole on what they are.
TEST(Slabs, OfAPartAreThoseOfTheWhole)
{
  const std::uint32_t all = 57;
  const auto whole = slabsFor({ 0, all }, all);
  for (std::uint32_t begin = 0; begin < all; ++begin)
  {
    for (std::uint32_t end = begin + 1; end <= all; ++end)
    {
      const auto slabs = slabsFor({ begin, end }, all);
      for (std::size_t stage = 0; stage < ShapingStages; ++stage)
      {
        for (const Slab& slab : slabs[stage])
        {
          EXPECT_EQ(std::count_if(whole[stage].begin(), whole[stage].end(),
                      [&](const Slab& other) {
                        return slab.layers.begin == other.layers.begin &&
                          slab.layers.end == other.layers.end;
                      }),
            1);
        }
      }
    }
  }
}

TEST(Slabs, LargerPartsAndMoreStepsNeedNoFewerLayers)
{
  const std::uint32_t all = 57;
  for (const LaterSteps& steps : { LaterSteps{ false, false }, LaterSteps{ true, false },
         LaterSteps{ false, true }, LaterSteps{ true, true } })
  {
    for (std::uint32_t begin = 0; begin < all; ++begin)
    {
      for (std::uint32_t end = begin + 1; end <= all; ++end)
      {
        const Layers needed = layersForCells({ begin, end }, steps, all);
        EXPECT_TRUE(contains(needed, { begin, end }));
        EXPECT_LE(needed.end, all);
        EXPECT_TRUE(
          contains(layersForCells({ begin, std::min(end + 1, all) }, steps, all), needed));
        EXPECT_TRUE(contains(layersForCells({ begin, end }, { true, true }, all), needed));
      }
    }
  }
}

// A cell that is fixed in part could have faults beside what changes, and nobody could mend it.
TEST(Slabs, OfTheSecondStageMayChangeAllOrNothingOfACellThatDoesNotStraddle)
{
  for (std::uint32_t all = 11; all < 60; ++all)
  {
    const auto stages = slabsFor({ 0, all }, all);
    for (const Slab& slab : stages[1])
    {
      for (std::uint32_t layer = 0; layer + 1 < all; ++layer)
      {
        const Layers cell{ layer, layer + 2 };
        const bool isBeside = cell.end <= slab.free.begin || cell.begin >= slab.free.end;
        EXPECT_TRUE(straddlesStages(cell, all) || isBeside || contains(slab.free, cell))
          << layer << " of " << all;
      }
    }
  }
}
