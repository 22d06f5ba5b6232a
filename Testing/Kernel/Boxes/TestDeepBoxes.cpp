// Boxes that are halved more often than one block can: a tree of blocks.
#include "Support/Effort.h"
#include "Support/Pipeline.h"

#include <random>

namespace cartesian
{
namespace
{

// Boxes of one size at the surface, whatever their depth.
constexpr double AtTheSurface = 1. / 16;

double sizeAt(int depth)
{
  return AtTheSurface * (1 << depth);
}

BoxedSurface boxed(const Soup& soup, int levels)
{
  Execution execution;
  return boxSurface(prepare(soup, cellsOf(sizeAt(levels))), depth(levels), execution);
}

TEST(DeepBoxes, AreFoundWhereTheyAre)
{
  for (const int levels : { 3, 4, 5, 6, 7, 10, 12 })
  {
    SCOPED_TRACE("depth " + std::to_string(levels));
    Boxes boxes = boxed(bumpySphere(3, 12), levels).boxes;
    const auto expectFound = [&] {
      for (std::uint32_t b = 0; b < boxes.packed.size(); ++b)
      {
        const PackedBox& box = boxes.packed[b];
        const FinePoint low = boxes.fineLow(box);
        for (unsigned corner = 0; corner < 8; ++corner)
        {
          FinePoint in = low;
          for (int axis = 0; axis < 3; ++axis)
          {
            in[static_cast<std::size_t>(axis)] +=
              (corner >> axis & 1) != 0 ? Boxes::fineSize(box, axis) - 1 : 0;
          }
          std::int64_t size = 0;
          ASSERT_EQ(boxes.boxAt(in, box.global, size), b);
        }
      }
    };
    expectFound();
    // As of boxes that are read from a file: the whole tree at once.
    Execution execution(2);
    ASSERT_TRUE(boxes.plantTree(execution));
    expectFound();
    boxes.packed.push_back(boxes.packed.back());
    ++boxes.globals.back().firstBox;
    EXPECT_FALSE(boxes.plantTree(execution)) << "two boxes overlap";
  }
}

// Where the surface passes, boxes are as small as without blocks. Elsewhere there are few: at most 2 % more than of
// three halvings, which a single block finds.
TEST(DeepBoxes, AreHardlyMoreThanOfASingleBlock)
{
  const Soup soup = bumpySphere(3, 24);
  const auto intersectedOf = [](const Boxes& boxes) {
    return std::count_if(boxes.packed.begin(), boxes.packed.end(),
      [](const PackedBox& box) { return box.status == BoxStatus::Intersected; });
  };
  const Boxes three = boxed(soup, 3).boxes;
  for (const int levels : { 4, 5, 6 })
  {
    const Boxes deep = boxed(soup, levels).boxes;
    EXPECT_NEAR(double(intersectedOf(deep)), double(intersectedOf(three)),
      0.01 * double(intersectedOf(three)))
      << levels;
    EXPECT_LE(double(deep.packed.size()), 1.02 * double(three.packed.size())) << levels;
  }
}

TEST(DeepBoxes, CoverWhatIsInside)
{
  const Soup soup = sphere(12, 1);
  const Boxes boxes = boxed(soup, 9).boxes;
  std::mt19937 random(5);
  std::uniform_real_distribution<> along(-1, 1);
  for (unsigned n = 0; n < repeats(3000); ++n)
  {
    const Vector p = { along(random), along(random), along(random) };
    if (std::hypot(p[0], p[1], p[2]) > 0.9) // inside the triangles
    {
      continue;
    }
    FinePoint fine;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const Level level = boxes.lattice.plane(static_cast<int>(axis), p[axis]);
      const std::int64_t i = intervalOf(boxes.planes[axis], level);
      std::int64_t part = 0;
      for (std::int64_t step = FinePerBox / 2; step > 0; step /= 2)
      {
        part += planeAt(boxes.planes, axis, std::size_t(i), part + step) <= level ? step : 0;
      }
      fine[axis] = i * FinePerBox + part;
    }
    std::int64_t size = 0;
    EXPECT_NE(boxes.boxAt(fine, 0, size), None);
  }
}

TEST(DeepBoxes, GiveMeshesOfTheExactVolume)
{
  const Soup soup = bumpySphere(3, 12);
  for (const int levels : { 4, 8, 12 })
  {
    const Meshed meshed = meshOf(soup, cellsOf(sizeAt(levels)), asTheyAre(0, depth(levels)));
    constexpr double MoreThanTheArea = 20;
    EXPECT_NEAR(meshed.statistics.at("MeshVolume"), meshed.statistics.at("SurfaceVolume"),
      std::max(1e-9, MoreThanTheArea * meshed.mesh.step)) // points may be rounded by a level
      << levels;
    EXPECT_TRUE(meshed.flawedBoxes.empty()) << levels;
  }
}

// Regions and sizes that reach into some parts of a block only.
TEST(DeepBoxes, AreTheSameForAnyNumberOfThreads)
{
  const Soup soup = bumpySphere(3, 12);
  const Soup ball = sphere(4, 0.05).moved({ 0.7, 0.1, 0.2 });
  TestOptions options = asTheyAre(0, depth(4));
  options.refinement.regions.push_back({ ball.view(), 9 });
  options.refinement.sizing.featureDepth = 6;
  const MeshArrays one = meshOf(soup, cellsOf(sizeAt(5)), options).mesh;
  options.threads = 3;
  EXPECT_TRUE(one == meshOf(soup, cellsOf(sizeAt(5)), options).mesh);
}

}
}
