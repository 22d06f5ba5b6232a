// The order in which a surface lists its points and triangles, and the corner that a triangle starts from, mean
// nothing: the mesh is the same to the last bit.
#include "Base/Error.h"
#include "Support/DataFile.h"
#include "Support/Effort.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace cartesian;

namespace
{

template <class Item>
std::vector<Item> permuted(const std::vector<Item>& items, const std::vector<std::uint32_t>& order)
{
  std::vector<Item> result;
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    result.push_back(items[order[i]]);
  }
  return result;
}

std::vector<std::uint32_t> randomOrder(std::size_t count, std::mt19937& random)
{
  std::vector<std::uint32_t> order(count);
  for (std::uint32_t i = 0; i < count; ++i)
  {
    order[i] = i;
  }
  std::shuffle(order.begin(), order.end(), random);
  return order;
}

Soup shuffled(const Soup& soup, unsigned seed)
{
  std::mt19937 random(seed);
  const std::vector<std::uint32_t> points = randomOrder(soup.points.size(), random);
  const std::vector<std::uint32_t> triangles = randomOrder(soup.triangles.size(), random);
  std::vector<std::uint32_t> numberOf(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i)
  {
    numberOf[points[i]] = i;
  }
  Soup result;
  result.points = permuted(soup.points, points);
  result.triangles = permuted(soup.triangles, triangles);
  result.boundary = permuted(soup.boundary, soup.boundary.empty() ? points : triangles);
  for (auto& triangle : result.triangles)
  {
    for (std::uint32_t& corner : triangle)
    {
      corner = numberOf[corner];
    }
    std::rotate(triangle.begin(), triangle.begin() + random() % 3, triangle.end());
  }
  return result;
}

struct Case
{
  NamedShape shape;
  double cells; // along its longest side
  int depth;
  PatchMethod method = PatchMethod::Automatic;
};

std::ostream& operator<<(std::ostream& stream, const Case& c)
{
  return stream << c.shape.name << ", " << c.cells << " cells, depth " << c.depth << ", method "
                << static_cast<int>(c.method);
}

// Triangles are missing, flipped, there twice, and without area.
Soup flawed(Soup soup, unsigned seed)
{
  std::mt19937 random(seed);
  const auto any = [&]() -> auto&
  {
    return soup.triangles[random() % soup.triangles.size()];
  };
  for (int i = 0; i < 5; ++i)
  {
    std::swap(any()[0], any()[1]);
    auto& flipped = any();
    std::swap(flipped[0], flipped[1]);
    const auto twice = any();
    any() = twice;
    auto& flat = any();
    flat[0] = flat[1];
  }
  soup.boundary.clear();
  return soup;
}

std::vector<Case> allCases()
{
  std::vector<Case> all;
  for (const NamedShape& shape : cleanShapes())
  {
    all.push_back({ shape, 12, 0 });
  }
  for (unsigned seed = 1; seed <= repeats(4); ++seed)
  {
    all.push_back(
      { { "BumpySphere", bumpySphere(seed, 9).turned() }, 14, static_cast<int>(seed % 2) });
    all.push_back({ { "StarPolyhedron", starPolyhedron(seed, 6) }, 11, 0 });
  }
  for (const char* const name : { "cino_spot.obj", "kcl_exhaust_header_lumens.stl",
         "tm_featuretype_occ.stl", "tm_not_convex.obj" })
  {
    all.push_back({ readData(name), 14, 0 });
    all.push_back({ readData(name), 6, 1 });
  }
  // Far more detail than boxes: hundreds of triangles in each.
  const Soup detailed = bumpySphere(5, RepeatedLess == 1 ? 60 : 24).turned();
  for (const PatchMethod method : { PatchMethod::Automatic, PatchMethod::ExactFit })
  {
    all.push_back({ { "DetailedBumpySphere", detailed }, 8, 0, method });
    all.push_back(
      { { "FlawedBumpySphere", flawed(bumpySphere(6, 12).turned(), 1) }, 9, 0, method });
    all.push_back({ { "KleinBottle", kleinBottle(20) }, 12, 0, method });
    for (unsigned seed = 1; seed <= repeats(6); ++seed)
    {
      all.push_back({ { "Tetrahedra", randomTetrahedra(seed, 6, 9).turned() }, 6, 1, method });
    }
  }
  for (const NamedShape& shape : RepeatedLess == 1 ? cleanShapes() : std::vector<NamedShape>())
  {
    all.push_back({ shape, 7, 0, PatchMethod::ExactFit });
  }
  return all;
}

// The mesh, or why there is none.
struct Outcome
{
  MeshArrays mesh{};
  std::string error;
};

Outcome outcomeOf(const Soup& soup, const Case& c)
{
  TestOptions options;
  options.refinement = depth(c.depth);
  options.patches.method = c.method;
  Outcome outcome;
  try
  {
    outcome.mesh = meshOf(soup, cellsOf(c.shape.soup.longest() / c.cells), options).mesh;
  }
  catch (const Error& error)
  {
    outcome.error = error.what();
  }
  return outcome;
}

}

TEST(Order, OfTheInputDoesNotMatter)
{
  std::size_t meshed = 0;
  const std::vector<Case> all = allCases();
  for (const Case& c : all)
  {
    const Outcome expected = outcomeOf(c.shape.soup, c);
    meshed += expected.error.empty() ? 1 : 0;
    for (unsigned seed = 1; seed <= 2; ++seed)
    {
      const Outcome found = outcomeOf(shuffled(c.shape.soup, seed), c);
      EXPECT_EQ(found.error, expected.error) << c;
      EXPECT_EQ(found.mesh.cells(), expected.mesh.cells()) << c;
      EXPECT_TRUE(found.mesh == expected.mesh) << c;
    }
  }
  EXPECT_GT(meshed, all.size() * 9 / 10);
}
