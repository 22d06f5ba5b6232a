// Editable meshes of a few cells, made by hand, and what must hold of any.
#pragma once

#include "Editing/EditLoop.h"
#include "Editing/PrimitiveEdits.h"

#include <functional>
#include <random>
#include <string>

namespace cartesian
{

// A box between whole numbers: one cell.
struct TestBox
{
  std::array<int, 3> low;
  std::array<int, 3> high;
  std::int32_t region = 0;
};

std::vector<TestBox> blockOfBoxes(int x, int y, int z, int size = 1);

// A box of two units across, and four of one beside it: its side has five faces' corners in the middle of its edges.
std::vector<TestBox> hangingBoxes();

// Ten around a hole along z, one beside the next.
std::vector<TestBox> ringOfBoxes();

struct TestMeshSpec
{
  std::function<Vector(const Vector&)> place; // where nodes are, of where boxes have them
  std::uint8_t constrainedAxes =
    0; // bits: 1 << axis: nodes of both outer sides across it stay on them
};

// Boxes that fill a region; where they have no neighbour is wall 2 * axis, or 2 * axis + 1 on the upper side; between two
// regions, wall 6. A side must have neighbours everywhere or nowhere. Nodes know what they are from the walls' sharp
// edges. All is measured.
MeshEditor meshOfBoxes(const std::vector<TestBox>& boxes, const TestMeshSpec& spec = {});

MeshEditor copyOf(const MeshEditor& mesh);

// All measures and costs again; costs only.
void measureAgain(MeshEditor& mesh, const ObjectiveSpec& spec = {});
void costAgain(MeshEditor& mesh, const ObjectiveSpec& spec);

// All cells, of which some are looked at (all that are there, by default), as one zone.
class WholeTask
{
public:
  explicit WholeTask(MeshEditor& mesh);
  WholeTask(MeshEditor& mesh, std::vector<std::uint32_t> cells);

  ZoneTask task()
  {
    return { mesh_, memory_, cells_, Items{ all_.data(), all_.data() + all_.size() }, turns_, 1 };
  }

private:
  MeshEditor& mesh_;
  LoopMemory memory_;
  std::vector<std::uint32_t> all_;
  std::vector<std::uint32_t> cells_;
  std::vector<std::uint32_t> turns_;
};

// The loop, for all cells; all steps.
void runLoop(MeshEditor& mesh, const LoopSpec& spec);
void improveWhole(MeshEditor& mesh);

// All lengths times a power of two.
void scaleBy(MeshEditor& mesh, double factor);

// What nodes are, from the walls; original areas and homes are as of now; then costs.
void settleWalls(MeshEditor& mesh);

// A wedge: the upper edge of a box's side goes.
MeshEditor wedge();

// Two boxes, as one cell, whose upper walls bend inwards in the middle by `depth`.
MeshEditor dentedCell(double depth);

// Boxes as one cell: L and U.
MeshEditor cellOfBoxes(const std::vector<TestBox>& boxes);

// Of up to 3 x 3 x 3 boxes of two units, some of them divided into eight, in one region or two, with nodes moved.
MeshEditor randomMesh(std::mt19937& random, double moved = 0.3);

std::uint32_t nodeAt(const MeshView& mesh, const Vector& place); // or None
std::uint32_t wallOf(const MeshView& mesh, std::uint32_t cell, std::int32_t wall);
std::uint32_t faceBetween(const MeshView& mesh, std::uint32_t a, std::uint32_t b);
std::size_t countCells(const MeshView& mesh);
std::size_t countFaces(const MeshView& mesh);

// Of the fans of triangles about the means of its faces' corners.
double volumeOf(const MeshView& mesh, std::uint32_t cell);
double volumeOf(const MeshView& mesh);
double volumeBehindWalls(const MeshView& mesh);
// What the walls owe, positive where the mesh should have more.
double sumOfDeficits(const MeshView& mesh);

double sumOfCosts(const MeshView& mesh);

// The first thing wrong with the mesh, or nothing: each directed edge of a cell's faces once, with its reverse once; its
// faces connected over edges; faces, cells and nodes know each other; no two faces alike; volumes positive; walls where
// regions meet, and nowhere else inside.
std::string faultOf(const MeshEditor& mesh);

// The first difference between two meshes, to the bit, with where lists lie in the arena, or nothing.
std::string differenceOf(const MeshEditor& mesh, const MeshEditor& other);

}
