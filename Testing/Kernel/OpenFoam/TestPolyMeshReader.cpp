// Meshes of OpenFOAM's cases, read back; Package.CaseQuality reads one that another program could have written.

#include "Base/Error.h"
#include "OpenFoam/PolyMeshFiles.h"
#include "OpenFoam/PolyMeshReader.h"
#include "Quality/QualityMeasures.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

using namespace cartesian;

namespace
{

namespace fs = std::filesystem;

// A pyramid on top of a box: volumes 6 and 2.
CellFaces boxAndPyramid()
{
  CellFaces cells;
  cells.firstFace = { 0, 6, 11 };
  for (const std::vector<std::uint32_t>& face : std::vector<std::vector<std::uint32_t>>{
         { 0, 3, 2, 1 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 0, 4, 7 },
         { 4, 5, 6, 7 }, { 4, 7, 6, 5 }, { 4, 5, 8 }, { 5, 6, 8 }, { 6, 7, 8 }, { 7, 4, 8 } })
  {
    cells.firstCorner.push_back(cells.corners.size());
    cells.corners.insert(cells.corners.end(), face.begin(), face.end());
  }
  cells.firstCorner.push_back(cells.corners.size());
  return cells;
}

const std::vector<double> Points = { 0, 0, 0, 1, 0, 0, 1, 2, 0, 0, 2, 0, 0, 0, 3, 1, 0, 3, 1, 2, 3,
  0, 2, 3, 0.5, 1, 6 };

// An empty folder of each test's own, with the mesh.
class PolyMeshReader : public testing::Test
{
protected:
  PolyMeshReader()
    : folder(fs::path(testing::TempDir()) /
        (std::string("reader_") + testing::UnitTest::GetInstance()->current_test_info()->name()))
    , polyMesh(folder / "constant/polyMesh")
  {
    write(FoamFormat::Ascii);
  }
  ~PolyMeshReader() override { fs::remove_all(folder); }

  void write(FoamFormat format)
  {
    fs::remove_all(folder);
    faces = listFaces(cells, Points.size() / 3, Clashes::Refused, execution);
    PolyMeshFiles files(folder, format);
    const std::size_t walls = faces.owner.size() - 1;
    files.write(foamMesh(Points, cells, faces, { { "wall", walls } }, execution), {}, execution);
    files.replace();
  }

  // With what follows the header replaced.
  void replace(const char* name, const std::string& list, const std::string& className)
  {
    std::ofstream(polyMesh / name)
      << "/* another\n program's */ FoamFile { format ascii; class " << className << "; }\n"
      << list;
  }

  void expectRefusal(Fault fault, const std::string& words)
  {
    try
    {
      readPolyMesh(polyMesh);
      ADD_FAILURE() << "nothing was thrown";
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.fault, fault);
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }

  // Of the two cells, as read.
  void expectVolumes()
  {
    const PolyMesh mesh = readPolyMesh(polyMesh);
    const Quality quality = measureQuality(mesh.points.data(), mesh.cells, mesh.faces, execution);
    // One inner face is too few for a gradient.
    EXPECT_EQ(quality.cellFailures, std::vector<std::uint32_t>(2, 1U << Determinant));
    ASSERT_EQ(quality.cells[Volume].size(), 2U);
    EXPECT_DOUBLE_EQ(quality.cells[Volume][0], 6);
    EXPECT_DOUBLE_EQ(quality.cells[Volume][1], 2);
  }

  Execution execution;
  CellFaces cells = boxAndPyramid();
  FaceList faces;
  fs::path folder;
  fs::path polyMesh;
};

}

TEST_F(PolyMeshReader, ReadsWhatWasWritten)
{
  for (const FoamFormat format : { FoamFormat::Ascii, FoamFormat::Binary })
  {
    write(format);
    const PolyMesh mesh = readPolyMesh(polyMesh);
    EXPECT_EQ(mesh.points, Points);
    EXPECT_EQ(mesh.faces.owner, faces.owner);
    EXPECT_EQ(mesh.faces.neighbour, std::vector<std::uint32_t>{ 1 });
    EXPECT_EQ(mesh.cells.firstFace, (RawVector<std::size_t>{ 0, 6, 11 }));
    expectVolumes();
    // Each face is seen from outside its cells: the same list as of the cells themselves.
    const FaceList again = listFaces(mesh.cells, Points.size() / 3, Clashes::Refused, execution);
    EXPECT_EQ(again.owner, faces.owner);
    EXPECT_EQ(again.neighbour, faces.neighbour);
  }
}

TEST_F(PolyMeshReader, ReadsOtherWaysToWriteTheSame)
{
  replace("neighbour", "// all the same\n1{1}\n", "labelList");
  replace("faces", "12 ( 0 4 8 12 16 20 24 27 30 33 36 36 )",
    "faceCompactList"); // too many, then the right ones
  expectRefusal(Fault::CannotRead, "a number is missing");
  replace("faces",
    "11\n( 0 4 8 12 16 20 24 27 30 33 36 )\n36(4 5 6 7 0 3 2 1 0 1 5 4 1 2 6 5 2 3 7 6 3 0 4 7 4 5 "
    "8 "
    "5 6 8 6 7 8 7 4 8)",
    "faceCompactList");
  expectVolumes();
}

TEST_F(PolyMeshReader, SaysWhatIsWrongAndWhere)
{
  replace("owner", "10(0 0 0 0 0 0\n1 1 x 1)", "labelList");
  expectRefusal(Fault::CannotRead, "owner: a number is missing, in line 4");
  replace("owner", "4000000000(0)", "labelList");
  expectRefusal(Fault::CannotRead, "a list of 4000000000 items is too long");
  replace("owner", "9(0 0 0 0 0 0 1 1 1)", "labelList");
  expectRefusal(Fault::BadMesh, "10 faces have 9 owners");
  replace("owner", "10(0 0 0 0 0 0 1 1 1 3)", "labelList");
  expectRefusal(Fault::BadMesh, "cell 2 has no face, but there is a cell 3");
  replace("owner", "10{1}", "labelList");
  expectRefusal(Fault::BadMesh, "face 0 has the same cell on both sides");
  replace("points", "2((0 0 0) (1 1 1))", "vectorField");
  expectRefusal(Fault::BadMesh, "a face has the point 8 of 2");
  std::ofstream(polyMesh / "points") << "2((0 0 0) (1 1 1))";
  expectRefusal(Fault::CannotRead, "no header");
  fs::rename(polyMesh / "points", polyMesh / "points.gz");
  expectRefusal(Fault::CannotRead, "Run gunzip");
  fs::remove(polyMesh / "points.gz");
  expectRefusal(Fault::CannotRead, "no such file");
  write(FoamFormat::Binary);
  fs::resize_file(polyMesh / "points", fs::file_size(polyMesh / "points") - 8);
  expectRefusal(Fault::CannotRead, "it ends early");
}
