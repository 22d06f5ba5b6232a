// Fluent's and EnSight's files of two tetrahedra; TestFluent.py and TestEnSight.py have other programs read meshes.

#include "Base/Error.h"
#include "Formats/AsciiNames.h"
#include "Formats/EnSightFiles.h"
#include "Formats/FacesOfCells.h"
#include "Formats/FluentFile.h"
#include "Formats/UniqueNames.h"

#include <gtest/gtest.h>

#include <sstream>

using namespace cartesian;

namespace
{

namespace fs = std::filesystem;

// Two tetrahedra with a common face, each of a region of its own or both of one.
FoamMesh twoTetrahedra()
{
  return { { 0, 0, 0, 0.1, 0, 0, 0, 1e-9, 0, 0, 0, 1, 0, 0, -1 }, { 0, 3, 6, 9, 12, 15, 18, 21 },
    { 0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2, 0, 4, 1, 1, 4, 2, 0, 2, 4 }, { 0, 0, 0, 0, 1, 1, 1 },
    { 1 }, 2, { { "inlet", 2 }, { "side", 4, "symmetry" } } };
}

class Formats : public testing::Test
{
protected:
  Formats()
    : folder(fs::path(testing::TempDir()) /
        testing::UnitTest::GetInstance()->current_test_info()->name())
  {
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  ~Formats() override { fs::remove_all(folder); }

  std::string read(const fs::path& name) const
  {
    std::ifstream file(folder / name, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
  }

  fs::path folder;
};

}

TEST_F(Formats, FluentNumbersFromOneAndFacesPointIntoTheFirstCell)
{
  writeFluent(twoTetrahedra(), {}, folder / "a.msh");
  EXPECT_EQ(read("a.msh"),
    "(0 \"Written by Cartesian Mesher\")\n(2 3)\n(10 (0 1 5 0 3))\n(10 (1 1 5 1 3)(\n"
    "0 0 0\n0.1 0 0\n0 1e-09 0\n0 0 1\n0 0 -1\n))\n(12 (0 1 2 0 0))\n(12 (2 1 2 1 7))\n"
    "(13 (0 1 7 0 0))\n(13 (3 1 1 2 5)(\n3 2 3 1 1 2\n))\n"
    "(13 (4 2 3 a 5)(\n3 4 2 1 1 0\n3 4 3 2 1 0\n))\n"
    "(13 (5 4 7 7 5)(\n3 3 4 1 1 0\n3 2 5 1 2 0\n3 3 5 2 2 0\n3 5 3 1 2 0\n))\n"
    "(45 (2 fluid cells)())\n(45 (3 interior interior_cells)())\n"
    "(45 (4 velocity-inlet inlet)())\n(45 (5 symmetry side)())\n");
}

TEST_F(Formats, FluentDividesABoundaryOfTwoRegions)
{
  writeFluent(twoTetrahedra(), { { "upper", "inlet" }, { 1, 0 } }, folder / "a.msh");
  const std::string text = read("a.msh");
  // The second cell is of the first region, and a boundary keeps away from a region's name.
  EXPECT_NE(text.find("3 2 3 1 2 1\n"), std::string::npos) << text;
  EXPECT_NE(
    text.find("(45 (2 solid upper)())\n(45 (3 fluid inlet)())\n(45 (4 wall upper_to_inlet)())\n"
              "(45 (5 velocity-inlet inlet_2)())\n(45 (6 symmetry side_upper)())\n"
              "(45 (7 symmetry side_inlet)())\n"),
    std::string::npos)
    << text;
}

// As constant/regionProperties of OpenFOAM cases says.
TEST_F(Formats, FluentTakesRegionsForFluidByTheirNamesToo)
{
  FoamMesh mesh = twoTetrahedra();
  mesh.patches[0].name = "side_1";
  writeFluent(mesh, { { "fluid", "solid" }, { 1, 0 } }, folder / "a.msh");
  const std::string text = read("a.msh");
  EXPECT_NE(text.find("(45 (2 fluid fluid)())\n(45 (3 solid solid)())\n"), std::string::npos)
    << text;
}

// A rotor and the air around it: both are fluid, and nothing is between them.
TEST_F(Formats, FluentHasInnerFacesBetweenZonesOfOneFluid)
{
  FoamRegions regions{ { "fluid", "rotor" }, { 1, 0 } };
  regions.areZones = true;
  writeFluent(twoTetrahedra(), regions, folder / "a.msh");
  const std::string text = read("a.msh");
  EXPECT_NE(text.find("(13 (4 1 1 2 5)("), std::string::npos) << text;
  EXPECT_NE(
    text.find(
      "(45 (2 fluid fluid)())\n(45 (3 fluid rotor)())\n(45 (4 interior fluid_to_rotor)())\n"),
    std::string::npos)
    << text;
}

TEST_F(Formats, FluentTellsWhichNamesItHadToChange)
{
  FoamMesh mesh = twoTetrahedra();
  mesh.patches[0].name = "\u8fdb\u53e3";
  mesh.patches[1].name = "Geh\u00e4use";
  const std::vector<ChangedName> changed = writeFluent(mesh, {}, folder / "a.msh");
  const std::string text = read("a.msh");
  EXPECT_NE(text.find("wall u8fdbu53e3)())\n(45 (5 symmetry Gehaeuse)"), std::string::npos) << text;
  ASSERT_EQ(changed.size(), 2U);
  EXPECT_EQ(changed[0].given, "\u8fdb\u53e3");
  EXPECT_EQ(changed[0].written, "u8fdbu53e3");
  EXPECT_TRUE(writeFluent(twoTetrahedra(), {}, folder / "a.msh").empty());
}

TEST(AsciiNames, AreThoseOfTheLettersElseNumbers)
{
  EXPECT_EQ(asciiName("a_1-b.c:"), "a_1-b.c:");
  EXPECT_EQ(asciiName("\u00c0\u00e9\u00df\u017e\u017f"), "Aesszs");
  EXPECT_EQ(asciiName("\u0391\u03c9 \u0410\u0431\u044f"), "Ao Abya");
  EXPECT_EQ(asciiName("\u00b0\u0180\u0450\U0001f600"), "u00b0u0180u0450u1f600");
}

TEST_F(Formats, EnSightHasAPartOfEachRegionAndPatch)
{
  writeEnSight(twoTetrahedra(), {}, folder / "a b.case");
  EXPECT_EQ(read("a b.case"), "FORMAT\ntype: ensight gold\n\nGEOMETRY\nmodel: a_b.geo\n");
  const auto sizeOfPart = [](std::size_t points, std::size_t numbers) {
    return 4 * 80 + 4 * (2 + 4 * points + numbers);
  };
  // Cells: their number, faces of each, corners of each face, corners. Faces: their number, sizes, corners.
  EXPECT_EQ(read("a_b.geo").size(),
    5 * 80 + sizeOfPart(5, 1 + 2 + 8 + 24) + sizeOfPart(4, 1 + 2 + 6) + sizeOfPart(5, 1 + 4 + 12));
}

TEST_F(Formats, WhatIsThereStaysWhereTheNewFileCannotBeWritten)
{
  fs::create_directories(folder / "a.case");
  EXPECT_THROW(writeEnSight(twoTetrahedra(), {}, folder / "a.case"), Error);
  EXPECT_TRUE(fs::is_directory(folder / "a.case"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
}

TEST(FacesOfCells, AreAscendingAndTurnedForTheNeighbour)
{
  const FacesOfCells cells(twoTetrahedra());
  EXPECT_EQ(cells.start, (std::vector<std::size_t>{ 0, 4, 8 }));
  EXPECT_EQ(cells.uses[4].face, 0U);
  EXPECT_TRUE(cells.uses[4].pointsInward);
  EXPECT_EQ(cells.uses[7].face, 6U);
  EXPECT_FALSE(cells.uses[7].pointsInward);
}

TEST(UniqueNames, AreCutAndNumbered)
{
  UniqueNames names(4);
  EXPECT_EQ(names.of("abcdef"), "abcd");
  EXPECT_EQ(names.of("abcdxx"), "ab_2");
  EXPECT_EQ(names.of("abcdef"), "abcd");
  EXPECT_EQ(names.take("abcdef"), "ab_3");
  UniqueNames others(4);
  others.avoid(names);
  EXPECT_EQ(others.of("abcd"), "ab_4");
}
