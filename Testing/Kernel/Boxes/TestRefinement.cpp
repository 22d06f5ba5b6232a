// Refinement: boxes are as the specification demands, however its kinds are combined.
#include "Base/Error.h"
#include "Support/Effort.h"
#include "Support/MeshChecker.h"

#include <cmath>
#include <map>

namespace cartesian
{
namespace
{

std::vector<Box> placed(const Boxes& boxes)
{
  std::vector<Box> all;
  for (const PackedBox& box : boxes.packed)
  {
    all.push_back(boxes.placed(box));
  }
  return all;
}

double volumeOfBox(const Box& box)
{
  return (double(box.high[0]) - box.low[0]) * (double(box.high[1]) - box.low[1]) *
    (double(box.high[2]) - box.low[2]);
}

// The volume that two boxes share.
double common(const Box& a, const Box& b)
{
  double volume = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double low = std::max(a.low[axis], b.low[axis]);
    const double high = std::min(a.high[axis], b.high[axis]);
    volume *= std::max(0.0, high - low);
  }
  return volume;
}

RefinementSpec randomSpec(std::mt19937& random, const Meshlines& planes, std::int32_t boundaries)
{
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  RefinementSpec spec;
  spec.depth = below(3);
  for (int n = below(3); n > 0; --n)
  {
    RefinementBlock block;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const int most = static_cast<int>(planes[axis].size()) - 1;
      block.first[axis] = below(most);
      block.last[axis] = block.first[axis] + below(most - static_cast<int>(block.first[axis]));
    }
    block.allowed = below(4);
    block.forced = below(3);
    spec.blocks.push_back(block);
  }
  for (int n = below(3); n > 0; --n)
  {
    spec.boundaries.push_back({ below(boundaries), below(4), below(3), below(2) == 1 });
  }
  return spec;
}

// The forced depth of a global box by its blocks and boundaries, found box by box.
int forcedDepth(const RefinementSpec& spec, const PreparedSurface& prepared,
  const Shoeboxes& shoeboxes, const std::array<std::uint32_t, 3>& at)
{
  int forced = 0;
  for (const RefinementBlock& block : spec.blocks)
  {
    bool in = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      in = in && block.first[axis] <= at[axis] && at[axis] <= block.last[axis];
    }
    forced = in ? block.forced : forced;
  }
  const std::size_t nj = prepared.planes[1].size() - 1;
  for (const BoundaryRefinement& row : spec.boundaries)
  {
    std::uint32_t nearest = ~0u;
    for (std::size_t r = 0; r + 1 < shoeboxes.rowStart.size(); ++r)
    {
      for (std::size_t b = shoeboxes.rowStart[r]; b < shoeboxes.rowStart[r + 1]; ++b)
      {
        for (std::size_t t = shoeboxes.triangleStart[b]; t < shoeboxes.triangleStart[b + 1]; ++t)
        {
          if (prepared.surface.boundary[shoeboxes.triangle[t]] == row.boundary)
          {
            const std::array<std::size_t, 3> there = { shoeboxes.column[b], r % nj, r / nj };
            std::uint32_t away = 0;
            for (std::size_t axis = 0; axis < 3; ++axis)
            {
              const auto d = std::abs(static_cast<std::int64_t>(there[axis]) - at[axis]);
              away = std::max(away, static_cast<std::uint32_t>(d));
            }
            nearest = std::min(nearest, away);
          }
        }
      }
    }
    if (row.blendLayers > 0 && nearest != ~0u)
    {
      const int start = row.depth - (row.blendBelow ? 1 : 0);
      forced = std::max(forced, start - static_cast<int>(nearest) / row.blendLayers);
    }
  }
  return std::max(forced, 0);
}

// The allowed depth of a global box that the surface passes through, by its blocks and boundaries, found
// triangle by triangle.
int allowedDepth(const RefinementSpec& spec, const PreparedSurface& prepared,
  const std::array<std::size_t, 3>& at, std::size_t begin, std::size_t end, const Shoeboxes& boxes)
{
  int allowed = spec.depth;
  for (const RefinementBlock& block : spec.blocks)
  {
    bool in = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto index = static_cast<std::int64_t>(at[axis]);
      in = in && block.first[axis] <= index && index <= block.last[axis];
    }
    allowed = in ? block.allowed : allowed;
  }
  for (const BoundaryRefinement& row : spec.boundaries)
  {
    for (std::size_t t = begin; t < end; ++t)
    {
      const bool isIts = prepared.surface.boundary[boxes.triangle[t]] == row.boundary;
      allowed = std::max(allowed, isIts ? row.depth : 0);
    }
  }
  return allowed;
}

// How deep boxes of each global box may be at most: as deep as it asks for itself, or one less for each
// global box between it and one that asks for more (balance). Cases without regions.
class MostDepths
{
public:
  MostDepths(
    const RefinementSpec& spec, const PreparedSurface& prepared, const Shoeboxes& shoeboxes)
  {
    const std::size_t ni = prepared.planes[0].size() - 1;
    const std::size_t nj = prepared.planes[1].size() - 1;
    const std::size_t nk = prepared.planes[2].size() - 1;
    for (std::size_t g = 0; g < ni * nj * nk; ++g)
    {
      const std::array<std::uint32_t, 3> at = { static_cast<std::uint32_t>(g % ni),
        static_cast<std::uint32_t>(g / ni % nj), static_cast<std::uint32_t>(g / ni / nj) };
      forced_[at] = own_[at] = forcedDepth(spec, prepared, shoeboxes, at);
    }
    for (std::size_t r = 0; r + 1 < shoeboxes.rowStart.size(); ++r)
    {
      for (std::size_t b = shoeboxes.rowStart[r]; b < shoeboxes.rowStart[r + 1]; ++b)
      {
        const std::array<std::size_t, 3> at = { shoeboxes.column[b], r % nj, r / nj };
        int& own = own_[{ static_cast<std::uint32_t>(at[0]), static_cast<std::uint32_t>(at[1]),
          static_cast<std::uint32_t>(at[2]) }];
        own = std::max(own,
          allowedDepth(spec, prepared, at, shoeboxes.triangleStart[b],
            shoeboxes.triangleStart[b + 1], shoeboxes));
      }
    }
  }

  using Index = std::array<std::uint32_t, 3>;
  int forced(const Index& at) const { return forced_.at(at); }

  // What it asks for itself.
  int own(const Index& at) const { return own_.at(at); }

  int most(const Index& at)
  {
    const auto [found, isNew] = most_.try_emplace(at, 0);
    for (auto other = own_.begin(); isNew && other != own_.end(); ++other)
    {
      int away = 0;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        away = std::max(away, std::abs(int(other->first[axis]) - int(at[axis])));
      }
      found->second = std::max(found->second, other->second - away);
    }
    return found->second;
  }

private:
  std::map<Index, int> forced_;
  std::map<Index, int> own_;
  std::map<Index, int> most_;
};

TEST(Refinement, RandomSpecificationsHold)
{
  std::mt19937 random(3);
  for (unsigned n = 0; n < repeats(24); ++n)
  {
    const Soup soup = n % 3 == 0
      ? box({ 0, 0, 0 }, { 1, 0.7, 0.4 }).turned()
      : (n % 3 == 1 ? bumpySphere(static_cast<unsigned>(random()), 6) : torus(12, 1, 0.3));
    const std::int32_t boundaries = n % 3 == 0 ? 6 : 1;
    TestOptions options = asTheyAre();
    const GridSpec grid = cellsAlongLongest(soup, 4.5);
    const PreparedSurface prepared = prepare(soup, grid);
    options.refinement = randomSpec(random, prepared.planes, boundaries);
    const Soup region =
      box({ 0, 0, 0 }, { 0.4, 0.3, 0.5 }).turned().moved(soup.points[n % soup.points.size()]);
    const bool hasRegion = n % 4 > 0;
    if (hasRegion)
    {
      options.refinement.regions.push_back({ region.view(), static_cast<int>(n % 4) });
    }
    const Meshed meshed = meshPrepared(prepared, options);
    SCOPED_TRACE("case " + std::to_string(n));

    const std::vector<Box> boxes = placed(meshed.boxed.boxes);
    MostDepths depths(options.refinement, prepared, meshed.boxed.shoeboxes);
    double twice = 0;
    for (std::size_t a = 0; a < boxes.size(); ++a)
    {
      for (std::size_t b = 0; b < a; ++b)
      {
        twice += common(boxes[a], boxes[b]);
      }
      const auto& global = meshed.boxed.boxes.globalOf(boxes[a]).index;
      const auto& level = boxes[a].level;
      ASSERT_GE(std::min({ level[0], level[1], level[2] }), depths.forced(global));
      const int deepest = std::max({ int(level[0]), int(level[1]), int(level[2]) });
      ASSERT_LE(deepest, std::max(depths.most(global), hasRegion ? int(n % 4) : 0));
      if (boxes[a].status == BoxStatus::Intersected)
      {
        ASSERT_GE(deepest, depths.own(global)) << "the surface is resolved to the allowed depth";
      }
    }
    EXPECT_EQ(twice, 0) << "boxes overlap";
    EXPECT_TRUE(isValid(meshed.mesh));
    EXPECT_TRUE(fills(meshed.mesh, soup));
  }
}

TEST(Refinement, ABoundaryBelowTheDepthEverywhereChangesNothing)
{
  TestOptions options = asTheyAre(0, depth(2));
  const std::size_t boxes = meshOf(sphere(6, 1), cellsOf(0.3), options).boxed.boxes.packed.size();
  options.refinement.boundaries.push_back({ 0, 1, 0, false });
  EXPECT_EQ(meshOf(sphere(6, 1), cellsOf(0.3), options).boxed.boxes.packed.size(), boxes);
}

TEST(Refinement, BoxesOfABlockFillTheirGlobalBoxes)
{
  TestOptions options = asTheyAre();
  options.refinement.blocks.push_back({ { 1, 1, 1 }, { 2, 2, 2 }, 2, 2 });
  const Meshed meshed = meshOf(cube(), cellsOf(0.2), options);
  std::map<std::uint32_t, double> volume;
  std::map<std::uint32_t, int> count;
  for (const Box& b : placed(meshed.boxed.boxes))
  {
    volume[b.global] += volumeOfBox(b);
    ++count[b.global];
  }
  int refined = 0;
  for (const auto& [global, sum] : volume)
  {
    const auto& at = meshed.boxed.boxes.globals[global].index;
    double whole = 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      whole *=
        double(meshed.prepared.planes[axis][at[axis] + 1]) - meshed.prepared.planes[axis][at[axis]];
    }
    EXPECT_EQ(sum, whole);
    refined += count[global] == 64;
  }
  EXPECT_EQ(refined, 8);
}

TEST(Refinement, LaterBlocksWinAndBoundariesOnlyDeepen)
{
  const Soup soup = cube();
  const PreparedSurface prepared = prepare(soup, cellsOf(0.2));
  const Shoeboxes shoeboxes = shoeboxesOf(prepared.surface, prepared.planes);
  RefinementSpec spec;
  spec.depth = 1;
  spec.blocks.push_back({ { 0, 0, 0 }, { 4, 4, 4 }, 3, 2 });
  spec.blocks.push_back({ { 0, 2, 2 }, { 2, 2, 2 }, 2, 1 });
  spec.boundaries.push_back({ 0, 1, 1, false }); // the low x face: allowed 1, forced 1
  Execution execution;
  const Refinement refinement(spec, prepared.surface, shoeboxes, prepared.planes, execution);
  EXPECT_EQ(refinement.at(4, 4, 4).allowed, 3);
  EXPECT_EQ(refinement.at(4, 4, 4).forced, 2);
  EXPECT_EQ(refinement.at(2, 2, 2).allowed, 2);
  EXPECT_EQ(refinement.at(2, 2, 2).forced, 1);
  EXPECT_EQ(refinement.at(0, 2, 2).allowed, 2); // the boundary never decreases it
  EXPECT_EQ(refinement.at(0, 2, 2).forced, 1);
  EXPECT_EQ(refinement.at(0, 0, 0).forced, 2); // never decreased
}

TEST(Refinement, BlendsInLayers)
{
  const PreparedSurface prepared = prepare(cube(), cellsOf(0.1));
  const Shoeboxes shoeboxes = shoeboxesOf(prepared.surface, prepared.planes);
  Execution execution;
  for (const bool below : { false, true })
  {
    RefinementSpec spec;
    spec.boundaries.push_back({ 0, 3, 2, below });
    const Refinement refinement(spec, prepared.surface, shoeboxes, prepared.planes, execution);
    const std::vector<int> expected =
      below ? std::vector<int>{ 2, 2, 1, 1, 0, 0 } : std::vector<int>{ 3, 3, 2, 2, 1, 1, 0, 0 };
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      EXPECT_EQ(refinement.at(static_cast<std::int64_t>(i), 5, 5).forced, expected[i]) << i;
    }
    EXPECT_EQ(refinement.at(0, 5, 5).allowed, 3);
  }
}

TEST(Refinement, RegionsRefineWhatLiesInThem)
{
  TestOptions options = asTheyAre();
  const Soup ball = sphere(6, 0.2).moved({ 0.5, 0.5, 0.5 });
  const Soup far = box({ -3, 0.9, 0.9 }, { 5, 3, 3 }); // reaches beyond the domain
  options.refinement.regions.push_back({ ball.view(), 2 });
  options.refinement.regions.push_back({ far.view(), 1 });
  const Meshed meshed = meshOf(cube(), cellsOf(0.1), options);
  for (const PackedBox& b : meshed.boxed.boxes.packed)
  {
    const auto& at = meshed.boxed.boxes.globalOf(b).index;
    const bool middle = at[0] == 5 && at[1] == 5 && at[2] == 5;
    const bool corner = at[1] == 9 && at[2] == 9;
    const std::uint8_t least = std::min({ b.level[0], b.level[1], b.level[2] });
    EXPECT_GE(least, middle ? 2 : (corner ? 1 : 0));
  }
  EXPECT_TRUE(isValid(meshed.mesh));
  EXPECT_TRUE(fills(meshed.mesh, cube()));
}

// Where its border passes through global boxes, too: boxes shrink towards the region, but only
// those that it touches must reach its depth.
TEST(Refinement, RegionsRefineOnlyTheBoxesThatTheyTouch)
{
  constexpr int Depth = 3;
  const Vector middle = { 0.52, 0.47, 0.49 };
  constexpr double Radius = 0.3;
  const Soup ball = sphere(12, Radius).moved(middle);
  TestOptions options = asTheyAre();
  options.refinement.regions.push_back({ ball.view(), Depth });
  const Meshed meshed = meshOf(cube(), cellsOf(0.2), options);
  const Lattice& lattice = meshed.prepared.surface.lattice;
  std::array<int, Depth + 1> count{};
  for (const Box& b : placed(meshed.boxed.boxes))
  {
    double nearest = 0; // squares of distances
    double size = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double low = lattice.position(axis, b.low[axis]);
      const double high = lattice.position(axis, b.high[axis]);
      const auto a = static_cast<std::size_t>(axis);
      nearest += std::pow(std::max({ low - middle[a], middle[a] - high, 0. }), 2);
      size += std::pow(high - low, 2);
    }
    const int least = std::min({ b.level[0], b.level[1], b.level[2] });
    ++count[static_cast<std::size_t>(least)];
    if (std::sqrt(nearest) < 0.95 * Radius)
    {
      EXPECT_EQ(least, Depth);
    }
    else if (std::sqrt(nearest) > Radius + 2 * std::sqrt(size))
    {
      EXPECT_LT(least, Depth);
    }
  }
  EXPECT_GT(*std::min_element(count.begin(), count.end()), 0);
  // All boxes of that depth in the ball, and one layer around it.
  const double boxesInBall = 4 / 3. * 3.1416 * std::pow(Radius * 8 / 0.2, 3);
  EXPECT_LT(count[Depth], 1.4 * boxesInBall);
  EXPECT_TRUE(isValid(meshed.mesh));
}

TEST(Refinement, SameMeshForAnyNumberOfThreads)
{
  const Soup soup = bumpySphere(5, 8);
  TestOptions options = asTheyAre();
  options.refinement = depth(3);
  options.refinement.boundaries.push_back({ 0, 3, 1, false });
  const Meshed one = meshOf(soup, cellsAlongLongest(soup, 6), options);
  for (const int threads : cases({ 2, 3, 8 }))
  {
    options.threads = threads;
    EXPECT_TRUE(meshOf(soup, cellsAlongLongest(soup, 6), options).mesh == one.mesh);
  }
}

void expectFault(const RefinementSpec& spec, Fault fault, const std::string& words)
{
  TestOptions options = asTheyAre();
  options.refinement = spec;
  try
  {
    meshOf(cube(), cellsOf(0.2), options);
    ADD_FAILURE() << "no error with \"" << words << "\"";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.fault, fault);
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(Refinement, ErrorsNameWhatIsWrong)
{
  RefinementSpec spec;
  spec.depth = DeepestLevel + 1;
  expectFault(spec, Fault::BadParameter, "Refinement Depth is 13");
  spec = {};
  spec.blocks.push_back({ { 0, 3, 0 }, { 1, 2, 1 }, 1, 0 });
  expectFault(spec, Fault::BadParameter, "J from 3 to 2");
  spec = {};
  spec.boundaries.push_back({ 17, 1, 0, false });
  expectFault(spec, Fault::BadParameter, "no boundary 17");
  spec = {};
  spec.boundaries.push_back({ 0, 1, -1, false });
  expectFault(spec, Fault::BadParameter, "negative");
  Soup open = cube();
  open.triangles.pop_back();
  spec = {};
  spec.regions.push_back({ open.view(), 1 });
  expectFault(spec, Fault::FlawedSurface, "open edges");
}

TEST(Refinement, RangesBeyondTheGridAreClippedWithAWarning)
{
  TestOptions options = asTheyAre();
  options.refinement.blocks.push_back({ { 3, -2, 0 }, { 40, 1, 0 }, 1, 1 });
  const Meshed meshed = meshOf(cube(), cellsOf(0.2), options);
  EXPECT_NE(meshed.boxed.warnings.find("row 0"), std::string::npos) << meshed.boxed.warnings;
  EXPECT_NE(meshed.boxed.warnings.find("I from 3 to 40"), std::string::npos);
  EXPECT_TRUE(isValid(meshed.mesh));
  EXPECT_GT(meshed.boxed.boxes.packed.size(), 125u);
}

TEST(Refinement, TooManyBoxesAreRefusedBeforeTheyAreBuilt)
{
  const Soup soup = cube();
  PreparedSurface prepared = prepare(soup, cellsOf(0.05));
  prepared.memoryLimit = { 1e8 };
  TestOptions options = asTheyAre();
  options.refinement.blocks.push_back({ { 0, 0, 0 }, { 19, 19, 19 }, 6, 6 });
  try
  {
    meshPrepared(prepared, options);
    FAIL() << "no error";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.fault, Fault::TooManyBoxes);
    EXPECT_NE(std::string(error.what()).find("boxes"), std::string::npos);
  }
}

}
}
