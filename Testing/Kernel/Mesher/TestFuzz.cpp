// Random closed surfaces where almost everything is degenerate: always a valid mesh or a refusal.
#include "Base/Error.h"
#include "Support/Effort.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

// How many inputs of a test were meshed.
class Tally
{
public:
  void add(bool meshed)
  {
    ++all_;
    meshed_ += meshed ? 1 : 0;
  }

  // At least this part of them; some random tetrahedra are flat, others the lattice loses. Floors are an eighth below
  // what is meshed today.
  void expect(double share) const
  {
    EXPECT_GE(static_cast<double>(meshed_), share * static_cast<double>(all_)) << all_ << " inputs";
    EXPECT_GT(meshed_, 0U);
  }

private:
  std::size_t all_ = 0;
  std::size_t meshed_ = 0;
};

// A mesh, or a refusal of a surface that encloses nothing. Returns how many boxes are flawed.
std::size_t expectValid(
  Tally& tally, const Soup& soup, const Meshlines& planes, const TestOptions& options = asTheyAre())
{
  try
  {
    const Meshed meshed = meshPrepared(prepareOnLevels(soup, planes), options);
    EXPECT_TRUE(isValid(meshed.mesh));
    tally.add(true);
    return meshed.flawedBoxes.size();
  }
  catch (const Error& error)
  {
    EXPECT_TRUE(error.fault == Fault::FlawedSurface || error.fault == Fault::EmptySurface)
      << error.what();
    tally.add(false);
    return 0;
  }
}

Meshlines scaled(Meshlines planes, Level by)
{
  for (auto& levels : planes)
  {
    for (Level& level : levels)
    {
      level *= by;
    }
  }
  return planes;
}

// The corners of a coarse lattice, each moved by a level or three.
Soup nearCoarseLattice(unsigned seed, int count, int width, double spacing)
{
  std::mt19937 random(seed);
  return randomTetrahedra(seed, count, width).each([&](const Vector& p) {
    Vector q{};
    for (int axis = 0; axis < 3; ++axis)
    {
      q[axis] = (p[axis] - 1) / 2 * spacing + (random() % 2 ? 1 : -1) + spacing;
    }
    return q;
  });
}

}

TEST(Fuzz, OneTetrahedronOnATinyLattice)
{
  Tally tally;
  for (unsigned seed = 0; seed < repeats(400); ++seed)
  {
    SCOPED_TRACE(seed);
    const int width = 1 + static_cast<int>(seed % 12);
    EXPECT_EQ(expectValid(tally, randomTetrahedra(seed, 1, width), randomPlanes(seed, width)), 0U);
  }
  tally.expect(0.6);
}

TEST(Fuzz, TetrahedraThatOverlapOnATinyLattice)
{
  Tally tally;
  for (unsigned seed = 0; seed < repeats(250); ++seed)
  {
    SCOPED_TRACE(seed);
    const int width = 1 + static_cast<int>(seed % 12);
    const Soup soup = randomTetrahedra(seed, 2 + static_cast<int>(seed % 7), width);
    expectValid(tally, soup, randomPlanes(seed, width),
      asTheyAre(seed % 2 ? 0 : 1e-3, {}, 1 + static_cast<int>(seed % 3)));
  }
  tally.expect(0.85);
}

// Unions of cubes of the lattice, with walls one level beside the planes.
TEST(Fuzz, VoxelsOnATinyLattice)
{
  Tally tally;
  for (unsigned seed = 0; seed < repeats(150); ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const int n = 2 + static_cast<int>(seed % 4);
    std::vector<double> lines;
    for (int i = 0; i <= n; ++i)
    {
      lines.push_back(2 * i + 1);
    }
    std::vector<bool> in(static_cast<std::size_t>(n * n * n));
    for (std::size_t i = 0; i < in.size(); ++i)
    {
      in[i] = random() % 2 == 0;
    }
    const Soup soup = voxels({ lines, lines, lines },
      [&](int i, int j, int k) { return in[static_cast<std::size_t>(i + n * (j + n * k))]; });
    if (!soup.triangles.empty())
    {
      EXPECT_EQ(expectValid(tally, soup, randomPlanes(seed, n)), 0U);
    }
  }
  tally.expect(1);
}

// Planes of refined boxes pass within a level of vertices.
TEST(Fuzz, RefinedBoxesOnALatticeNotMuchFiner)
{
  Tally tally;
  for (unsigned seed = 0; seed < repeats(100); ++seed)
  {
    SCOPED_TRACE(seed);
    const int width = 2 + static_cast<int>(seed % 7);
    const Soup soup = nearCoarseLattice(seed, 1 + static_cast<int>(seed % 4), width, 32);
    const Meshlines planes = scaled(randomPlanes(seed, (width + 3) / 4), 64);
    expectValid(tally, soup, planes, asTheyAre(0, depth(1 + static_cast<int>(seed % 3))));
  }
  tally.expect(0.65);
}

// Without any triangle being wrong by itself: some are missing, some are turned.
TEST(Fuzz, OpenSoupsOnATinyLattice)
{
  Tally tally;
  for (unsigned seed = 0; seed < repeats(200); ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const int width = 1 + static_cast<int>(seed % 12);
    Soup soup = randomTetrahedra(seed, 3, width);
    soup.triangles.erase(soup.triangles.begin() + random() % 12);
    std::swap(soup.triangles[random() % 11][0], soup.triangles[random() % 11][1]);
    expectValid(tally, soup, randomPlanes(seed, width));
  }
  tally.expect(0.8);
}

// Clean surfaces through the front door, on a lattice as coarse as double precision makes it there.
TEST(Fuzz, StarPolyhedraFarAway)
{
  Tally tally;
  for (unsigned seed = 0; seed < repeats(20); ++seed)
  {
    SCOPED_TRACE(seed);
    const Soup soup = starPolyhedron(seed, 2).scaled(1 << (seed % 10)).moved({ 4e15, -3e15, 1e10 });
    try
    {
      EXPECT_TRUE(isValid(meshOf(soup, cellsAlongLongest(soup, 1 + seed % 5)).mesh));
      tally.add(true);
    }
    catch (const Error& error)
    {
      EXPECT_TRUE(error.fault == Fault::BadCellSize || error.fault == Fault::FlawedSurface)
        << error.what();
      tally.add(false);
    }
  }
  tally.expect(0.75);
}
