// Boxes that are rebuilt close again, and others keep their patches.
#include "Cells/Cells.h"
#include "Faces/BoxRebuilding.h"
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

using namespace cartesian;

TEST(BoxRebuilding, ClosesWhatItRebuilds)
{
  const Soup soup = sphere(8, 1).turned();
  Execution execution;
  const PreparedSurface prepared = prepare(soup, cellsAlongLongest(soup, 6));
  const BoxedSurface boxed = boxSurface(prepared, {}, execution);
  const Boxes& boxes = boxed.boxes;
  const Patches patches =
    generatePatches(prepared.surface, boxes, boxed.shoeboxes, exactFit(), execution);
  const Sides sides = findSides(boxes, execution);
  const Nodes nodes = findNodes(boxes, patches, sides, execution);
  const InnerFaces inner = generateInnerFaces(boxes, patches, sides, nodes, execution);
  std::vector<std::uint8_t> flawed = findFlawed(boxes, patches, sides, nodes, inner, execution);
  EXPECT_EQ(std::count(flawed.begin(), flawed.end(), 1), 0);
  flawed[flawed.size() / 2] = 1; // as if it were
  for (const RebuildLevel givenUp :
    { RebuildLevel::Nothing, RebuildLevel::Chords, RebuildLevel::Crossings })
  {
    const RebuiltPatches rebuilt =
      rebuildFlawedBoxes(boxes, patches, sides, nodes, inner, flawed, givenUp, execution);
    EXPECT_EQ(rebuilt.boxes[flawed.size() / 2], 1);
    const Patches& after = rebuilt.patches;
    EXPECT_EQ(after.kinds.size(), after.points.size());
    EXPECT_TRUE(std::equal(patches.kinds.begin(), patches.kinds.end(), after.kinds.begin()));
    const Nodes nodesAfter = findNodes(boxes, after, sides, execution);
    const InnerFaces innerAfter = generateInnerFaces(boxes, after, sides, nodesAfter, execution);
    const auto open = findFlawed(boxes, after, sides, nodesAfter, innerAfter, execution);
    EXPECT_EQ(std::count(open.begin(), open.end(), 1), 0);
    for (std::size_t n = 0; n < sides.polyhedral.size(); ++n)
    {
      const std::uint32_t box = sides.patchBox[n];
      if (box == None || rebuilt.boxes[n] != 0)
      {
        continue;
      }
      const std::size_t count = patches.boxStart[box + 1] - patches.boxStart[box];
      ASSERT_EQ(after.boxStart[box + 1] - after.boxStart[box], count);
      const auto first = patches.triangle.begin() + std::ptrdiff_t(patches.boxStart[box]);
      EXPECT_TRUE(std::equal(first, first + std::ptrdiff_t(count),
        after.triangle.begin() + std::ptrdiff_t(after.boxStart[box])));
    }
  }
}
