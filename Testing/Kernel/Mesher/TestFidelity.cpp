// With the default properties the boundary of the mesh is the surface: inside it and around it, turned or not, in volume,
// in the area of each boundary, in distance both ways, in sharp edges, and in where its faces look.
#include "Base/Error.h"
#include "Mesher/KnownFidelityFaults.h"
#include "Support/Fidelity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <set>
#include <sstream>

using namespace cartesian;

namespace
{

constexpr double Margin = 0.3; // of the surface's longest side, around it in a flow domain
constexpr std::int32_t FirstSide = 100;

struct Turn
{
  const char* name;
  Soup (*of)(const Soup& soup);
};

constexpr std::array<Turn, 4> Turns{ {
  { "as it is", [](const Soup& soup) { return soup; } },
  { "by 20", [](const Soup& soup) { return soup.turned(2, 20); } },
  { "by 10, 20, 30",
    [](const Soup& soup) { return soup.turned(0, 10).turned(1, 20).turned(2, 30); } },
  { "by any angles", [](const Soup& soup) { return soup.turned(); } },
} };

constexpr double Coarse = 10; // boxes along the longest side
constexpr double Fine = 25;
constexpr std::size_t TurnOfFine = 2;

// What a mesh may be off by.
struct Tolerance
{
  double volume;   // relative
  double area;     // likewise
  double distance; // boxes
};

// Boxes can meet flat walls.
constexpr Tolerance OfFlatWalls{ 1e-3, 1e-3, 0.1 };

// Curved ones they meet to the second order of the box by this radius; of facets, edges that turn by less than Feature
// Angle are cut off.
const std::map<std::string, double> Radii{ { "Sphere", 1 }, { "FarAway", 1 },
  { "TinyAndFarAway", 1e-6 }, { "NestedSpheres", 0.6 }, { "TwoSpheres", 0.5 }, { "Torus", 1 },
  { "BumpySphere", 0.7 }, { "Tiny", 0.7e-6 } };

Tolerance toleranceOf(const std::string& shape, double box)
{
  const auto radius = Radii.find(shape);
  if (radius == Radii.end())
  {
    return OfFlatWalls;
  }
  const double order = std::pow(box / radius->second, 2);
  return { 0.5 * order, 0.8 * order, 0.25 };
}

struct Case
{
  NamedShape shape;
  Domain domain;
  double cells; // along the longest side
  Turn turn;

  std::string name() const
  {
    return shape.name + (domain == Domain::Inside ? ", inside, 1/" : ", outside, 1/") +
      std::to_string(static_cast<int>(cells)) + ", " + turn.name;
  }
};

std::vector<Case> casesOf(const NamedShape& shape)
{
  std::vector<Case> cases;
  for (const Domain domain : { Domain::Inside, Domain::Outside })
  {
    for (const Turn& turn : Turns)
    {
      cases.push_back({ shape, domain, Coarse, turn });
    }
    cases.push_back({ shape, domain, Fine, Turns[TurnOfFine] });
  }
  return cases;
}

Bounds boxAround(const Soup& soup)
{
  Bounds box{ soup.low(), soup.high() };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    box.low[axis] -= Margin * soup.longest();
    box.high[axis] += Margin * soup.longest();
  }
  return box;
}

// Throws Error where there is no mesh.
Fidelity measured(const Soup& soup, double box, Domain domain)
{
  TestOptions options;
  std::optional<Bounds> around;
  if (domain == Domain::Outside)
  {
    around = boxAround(soup);
    options.domain.domain = domain;
    options.domain.boxFrom = BoxSource::Bounds;
    options.domain.bounds = *around;
    for (std::int32_t side = 0; side < 6; ++side)
    {
      options.domain.sides[static_cast<std::size_t>(side)] = FirstSide + side;
    }
  }
  const MeshArrays mesh = meshOf(soup, cellsOf(box), options).mesh;
  return fidelityOf(mesh, soup, box, options.patches.featureAngle, around);
}

// What is wrong, by its name in the list of known faults, and how much.
std::map<std::string, double> faultsOf(const Case& of)
{
  const Soup soup = of.turn.of(of.shape.soup);
  const double box = soup.longest() / of.cells;
  const Tolerance most = toleranceOf(of.shape.name, box);
  std::map<std::string, double> faults;
  const auto require = [&](bool fine, const char* name, double value) {
    if (!fine)
    {
      faults[name] = value;
    }
  };
  try
  {
    const Fidelity found = measured(soup, box, of.domain);
    const double off = std::max(found.boundaryOff, found.surfaceOff);
    require(std::abs(found.volume) <= most.volume, "volume", found.volume);
    require(found.worstArea() <= most.area, "area", found.worstArea());
    require(off <= most.distance, "distance", off);
    require(found.edgesKept > 1 - 1e-9, "edges", found.edgesKept);
    require(found.leaning == 0, "leaning", double(found.leaning));
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.fault, Fault::FlawedSurface) << error.what();
    faults["mesh"] = 0;
  }
  return faults;
}

std::set<std::string> knownFaultsOf(const Case& of)
{
  const auto row = KnownFidelityFaults.find(of.name());
  std::istringstream words(row == KnownFidelityFaults.end() ? "" : row->second);
  return { std::istream_iterator<std::string>(words), {} };
}

std::string rowOf(const Case& of, const std::map<std::string, double>& faults)
{
  std::string row;
  for (const auto& [name, value] : faults)
  {
    row += (row.empty() ? "" : " ") + name;
  }
  return "{ \"" + of.name() + "\", \"" + row + "\" },";
}

class FidelityOf : public ::testing::TestWithParam<NamedShape>
{
};

}

TEST_P(FidelityOf, TheBoundaryIsTheSurface)
{
  for (const Case& of : casesOf(GetParam()))
  {
    const std::map<std::string, double> faults = faultsOf(of);
    std::set<std::string> known = knownFaultsOf(of);
    for (const auto& [name, value] : faults)
    {
      EXPECT_EQ(known.erase(name), 1U) << of.name() << ": " << name << " " << value;
    }
    for (const std::string& name : known)
    {
      ADD_FAILURE() << of.name() << ": " << name
                    << " holds now: remove it from the list of known faults";
    }
    if (HasNonfatalFailure() && !faults.empty())
    {
      std::cout << "now: " << rowOf(of, faults) << '\n';
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, FidelityOf, ::testing::ValuesIn(cleanShapes()), nameOf);

TEST(FidelityOf, KnownFaultsAreOfCases)
{
  std::set<std::string> names;
  for (const NamedShape& shape : cleanShapes())
  {
    for (const Case& of : casesOf(shape))
    {
      names.insert(of.name());
    }
  }
  for (const auto& [name, faults] : KnownFidelityFaults)
  {
    EXPECT_EQ(names.count(name), 1U) << name;
  }
}
