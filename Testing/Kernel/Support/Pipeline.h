// From a triangle soup to the arrays of a mesh in one call, as the filters do it.
#pragma once

#include "Mesher/Mesher.h"
#include "Mesher/Messages.h"
#include "Mesher/Statistics.h"
#include "Support/Shapes.h"

#include <gtest/gtest.h>

#include <map>

namespace cartesian
{

// All arrays that Mesh writes, with cells in order of their numbers, and the meshlines.
struct MeshArrays
{
  static constexpr unsigned char Hexahedron = 12;
  static constexpr unsigned char Polyhedron = 42;

  std::vector<double> points;
  std::vector<Id> offsets;
  std::vector<Id> connectivity;
  std::vector<unsigned char> types;
  std::vector<Id> faceStart;
  std::vector<Id> faceStream;
  std::vector<int> globalBox;
  std::vector<unsigned char> level;
  std::vector<int> region;
  std::vector<double> volumeFraction;

  std::vector<Id> boundaryStart;
  std::vector<Id> boundaryPoints; // the mesh's
  std::vector<Id> boundaryCell;
  std::vector<std::int32_t> boundaryIndex;

  std::array<std::vector<double>, 3> meshlines;
  double step; // of the lattice

  std::size_t cells() const { return types.size(); }

  bool operator==(const MeshArrays& other) const;
};

MeshArrays arraysOf(const OutputMesh& mesh, const Boxes& boxes, Execution& execution);

// A mesh and its layers as one, without volume fractions; cells of stacks have the data of those below them.
MeshArrays withLayers(MeshArrays mesh, const BoundaryLayers& layers);

std::map<std::string, double> statisticsOf(const Assembly& assembly);

struct BoxedSurface
{
  Boxes boxes;
  Shoeboxes shoeboxes;
  std::string warnings;
};

struct Meshed
{
  PreparedSurface prepared;
  BoxedSurface boxed;
  Patches patches;
  MeshArrays mesh;
  std::vector<std::uint32_t> flawedBoxes;
  std::map<std::string, double> statistics;
};

constexpr double PlentyOfMemory = 100; // GiB

// The user's defaults, in one thread.
struct TestOptions : Options
{
  int threads = 1;
};

PatchSpec exactFit();

// Tests rely on exact volumes and areas: patches are the surface itself, and cells are neither merged nor
// split; only those smaller than the ratio, or without volume, are removed.
TestOptions asTheyAre(
  double smallCellRatio = 0, const RefinementSpec& refinement = {}, int threads = 1);

GridSpec cellsOf(double size);
GridSpec cellsAlongLongest(const Soup& soup, double cells);
RefinementSpec depth(int levels); // everywhere

PreparedSurface prepare(const Soup& soup, const GridSpec& grid, Execution& execution,
  double memoryLimit = PlentyOfMemory);
PreparedSurface prepare(
  const Soup& soup, const GridSpec& grid, double memoryLimit = PlentyOfMemory);

BoxedSurface boxSurface(
  const PreparedSurface& prepared, const RefinementSpec& refinement, Execution& execution);

// In each direction, two to all of the planes between the levels 0 and 2 * width + 2.
Meshlines randomPlanes(unsigned seed, int width);

// A surface whose coordinates are odd levels, cut by these planes.
PreparedSurface prepareOnLevels(const Soup& soup, const Meshlines& planes);

// All steps up to the mesh that is written, in one part.
std::unique_ptr<Assembly> assembledOf(
  const Soup& soup, const GridSpec& grid, const TestOptions& options, Execution& execution);

// The cells as they are cut, before edits.
std::unique_ptr<Assembly> cutCellsOf(
  const Soup& soup, const GridSpec& grid, const TestOptions& options, Execution& execution);

Meshed meshPrepared(const PreparedSurface& prepared, const TestOptions& options = asTheyAre());
Meshed meshOf(const Soup& soup, const GridSpec& grid, const TestOptions& options = asTheyAre());

// For parametrised tests.
inline std::string nameOf(const ::testing::TestParamInfo<NamedShape>& info)
{
  return info.param.name;
}

// The winding around each vertex of the global mesh, from the crossings below it along `axis`; x
// varies fastest.
std::vector<Winding> windings(const Surface& surface, const Meshlines& planes, int axis);

Shoeboxes shoeboxesOf(const Surface& surface, const Meshlines& planes);

}
