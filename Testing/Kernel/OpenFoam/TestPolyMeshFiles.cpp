// A mesh written as an OpenFOAM case; TestFoam.py reads more of it.

#include "Base/Error.h"
#include "OpenFoam/PolyMeshFiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <sstream>

using namespace cartesian;

namespace
{

namespace fs = std::filesystem;

// An empty folder of each test's own.
class PolyMesh : public testing::Test
{
protected:
  PolyMesh()
    : folder(fs::path(testing::TempDir()) /
        testing::UnitTest::GetInstance()->current_test_info()->name())
  {
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  ~PolyMesh() override { fs::remove_all(folder); }

  // A tetrahedron of two patches.
  static FoamMesh tetrahedron(const std::string& first, const std::vector<double>& points)
  {
    CellFaces cells;
    cells.firstFace = { 0, 4 };
    cells.firstCorner = { 0, 3, 6, 9, 12 };
    cells.corners = { 0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2 };
    FaceList faces;
    faces.face = { 0, 1, 2, 3 };
    faces.owner = { 0, 0, 0, 0 };
    Execution execution;
    return foamMesh(points, cells, faces, { { first, 1 }, { "wall", 3 } }, execution);
  }

  fs::path write(FoamFormat format, const std::string& first = "a",
    const std::vector<double>& points = { 0, 0, 0, 0.1, 0, 0, 0, 1e-9, 0, 0, 0, 1 }) const
  {
    PolyMeshFiles files(folder, format);
    Execution execution(4);
    files.write(tetrahedron(first, points), {}, execution);
    const std::vector<fs::path> kept = files.replace();
    return kept.empty() ? fs::path() : kept.front();
  }

  // Without the header.
  std::string read(const fs::path& name, const fs::path& location = "constant/polyMesh") const
  {
    std::ifstream file(folder / location / name);
    std::stringstream text;
    text << file.rdbuf();
    return text.str().substr(text.str().find("}\n\n") + 3);
  }

  fs::path folder;
};

}

TEST_F(PolyMesh, AsciiIsWhatOpenFOAMReads)
{
  EXPECT_EQ(write(FoamFormat::Ascii), "");
  EXPECT_EQ(read("points"), "4\n(\n(0 0 0)\n(0.1 0 0)\n(0 1e-09 0)\n(0 0 1)\n)\n");
  EXPECT_EQ(read("faces"), "4\n(\n3(0 2 1)\n3(0 1 3)\n3(1 2 3)\n3(0 3 2)\n)\n");
  EXPECT_EQ(read("owner"), "4\n(\n0\n0\n0\n0\n)\n");
  EXPECT_EQ(read("neighbour"), "0\n(\n)\n");
  EXPECT_NE(read("boundary").find("wall;\n        nFaces          3;\n        startFace       1;"),
    std::string::npos);
}

TEST_F(PolyMesh, AsciiReadsBackAsTheSameNumbers)
{
  const std::vector<double> points = { 1. / 3, std::nextafter(1., 2), -0.1, 1e-300, 387.5356812,
    -1.20052e-15, 5e-324, 123456789.123456789, 2. / 3, 1e22, 4 * std::atan(1.), -0. };
  write(FoamFormat::Ascii, "a", points);
  std::string text = read("points").substr(1);
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c == '(' || c == ')'; }, ' ');
  const char* next = text.c_str();
  for (const double expected : points)
  {
    char* end = nullptr;
    const double found = std::strtod(next, &end);
    EXPECT_EQ(std::memcmp(&found, &expected, sizeof(double)), 0) << found << " for " << expected;
    next = end;
  }
}

// controlDict says how many digits OpenFOAM's programs write when they move or renumber the mesh.
TEST_F(PolyMesh, ProgramsWriteAllDigits)
{
  write(FoamFormat::Ascii);
  EXPECT_NE(read("controlDict", "system").find("writePrecision  17;"), std::string::npos);
}

TEST_F(PolyMesh, BinaryHasNoBracketsAroundNothing)
{
  write(FoamFormat::Binary);
  EXPECT_EQ(read("neighbour"), "0\n\n");
  EXPECT_EQ(read("owner"), std::string("4\n(") + std::string(16, '\0') + ")\n");
  EXPECT_EQ(read("points").size(), std::string("4\n()\n").size() + 12 * sizeof(double));
}

TEST_F(PolyMesh, AMeshOfOtherPatchesIsKept)
{
  write(FoamFormat::Ascii);
  EXPECT_EQ(write(FoamFormat::Binary), "");
  EXPECT_EQ(write(FoamFormat::Ascii, "b"), folder / "constant" / "polyMesh.old");
  EXPECT_EQ(write(FoamFormat::Ascii, "c"), folder / "constant" / "polyMesh.old2");
  EXPECT_FALSE(fs::exists(folder / "constant" / "polyMesh.unfinished"));
}

TEST_F(PolyMesh, WhatIsNotPutInItsPlaceLeavesNothing)
{
  const FoamMesh mesh = tetrahedron("a", std::vector<double>(12));
  Execution execution;
  {
    PolyMeshFiles files(folder, FoamFormat::Ascii, { 1, 2 });
    files.write(mesh, "gas", execution);
    EXPECT_EQ(files.meshes().front().region, "gas");
  }
  EXPECT_TRUE(fs::is_empty(folder));
  write(FoamFormat::Ascii);
  PolyMeshFiles(folder, FoamFormat::Ascii).write(mesh, {}, execution);
  EXPECT_FALSE(fs::exists(folder / "constant/polyMesh.unfinished"));
  EXPECT_EQ(read("points"), "4\n(\n(0 0 0)\n(0.1 0 0)\n(0 1e-09 0)\n(0 0 1)\n)\n");
}

TEST_F(PolyMesh, AFileInTheWayIsAnError)
{
  std::ofstream(folder / "constant") << "mine";
  try
  {
    write(FoamFormat::Ascii);
    ADD_FAILURE() << "no error";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.fault, Fault::CannotWrite);
  }
}

TEST_F(PolyMesh, WordsHaveNoBracketsAndDoNotStartAsNumbers)
{
  EXPECT_EQ(foamWord("inlet_1"), "inlet_1");
  EXPECT_EQ(foamWord("a b/c;{\"$#}"), "a_b_c______");
  EXPECT_EQ(foamWord("1"), "_1");
  EXPECT_EQ(foamWord("-x"), "_-x");
  EXPECT_EQ(foamWord(""), "_");
  EXPECT_EQ(foamWord(std::string(2000, 'x')), std::string(LongestWord, 'x'));
  EXPECT_EQ(
    foamWord(std::string(LongestWord - 1, 'x') + "\u00e9"), std::string(LongestWord - 1, 'x'));
}
