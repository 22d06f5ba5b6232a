// The whole meshing task, step by step (section 6): what the filters run.
//
//   surface --prepareSurface--> Surface, Meshlines     steps 2, 3, 4
//           --boxSurface------> Boxes, Shoeboxes       steps 5, 7, 8   (Cartesian Boxer)
//           --generatePatches-> Patches                A1              (Patcher)
//           --Assembly--------> Sides, InnerFaces,     9, A3, B1-B4    (Cell Assembler)
//                               Cells, Mesh            11-13
#pragma once

#include "Boxes/BoxGeneration.h"
#include "Faces/BoxRebuilding.h"
#include "Mesh/OutputMesh.h"
#include "Repair/SurfaceDefects.h"
#include "Shaping/CellShaping.h"

#include <memory>

namespace cartesian
{

// Where each stage ends, as a part of all work: measured on a mesh of 2 million cells with default
// properties.
constexpr double AfterSurface = 0.01;
constexpr double AfterDefects = 0.02; // while Boxes begin where Surface ends
constexpr double AfterBoxes = 0.065;
constexpr double AfterPatches = 0.245;
constexpr double AfterSides = 0.32;
constexpr double AfterInnerFaces = 0.36;
constexpr double AfterCells = 0.375;
constexpr double AfterShortEdges = 0.53;
constexpr double AfterShaping = 0.83;
constexpr double AfterNumbering = 0.905;

// Leaves out of the progress what `spec` does not ask for; before the first stage.
void planStages(const CellSpec& spec, Execution& execution);

struct PreparedSurface
{
  Surface surface;
  std::size_t trianglesGiven; // what follows closes holes
  SurfaceRepair repair;
  Meshlines planes;
  Bounds bounds;      // of the surface, user units
  double memoryLimit; // bytes
};

// Scaling, Dual Levels, check and repair of the surface. `memoryLimit` in bytes, for each of the
// `parts` that the mesh is made in (Decomposition.h). Throws Error: EmptySurface, BadCoordinate,
// BadCellSize, BadMeshlines, TooManyBoxes.
PreparedSurface prepareSurface(const SurfaceView& view, const GridSpec& grid, double memoryLimit,
  Execution& execution, int parts = 1);

// What was found and repaired, in words with places, or nothing. `cells`: the user's number of each
// triangle given.
std::string describeFlaws(const PreparedSurface& prepared, const std::vector<Id>& cells);

// Where the surface reaches beyond the meshlines, in words, or nothing.
std::string describeOverhang(const PreparedSurface& prepared);

struct BoxedSurface
{
  Boxes boxes;
  Shoeboxes shoeboxes;
  std::string warnings; // rows of the specification that reach beyond the grid, or nothing
};

// Throws Error: BadParameter (of the refinement), TooManyBoxes; of a region's surface EmptySurface,
// BadCoordinate, FlawedSurface.
BoxedSurface boxSurface(
  const PreparedSurface& prepared, const RefinementSpec& spec, Execution& execution);

// Boxes and patches made into a mesh; borrows both. Throws Error: BadParameter, TooManyBoxes,
// FlawedSurface (no cell is left of the whole; a part may have none).
class Assembly
{
public:
  Assembly(const Boxes& boxes, const Patches& patches, const CellSpec& spec, Execution& execution);

  const OutputMesh& mesh() const { return *mesh_; }

  // Intersected boxes that have no cells because the surface does not close in them, and neither do
  // patches made anew (BoxRebuilding.h).
  std::vector<std::uint32_t> flawedBoxes() const;

  // How many boxes have patches made anew.
  std::size_t rebuiltBoxes() const;

  // Both in words, with places, or nothing.
  std::string describeFlaws() const;

  // Why there is no cell.
  std::string describeNothing() const;

  // The statistics of step 12: names and values. Of a part (Decomposition.h), those of its core: the parts'
  // add up.
  std::vector<std::pair<const char*, double>> statistics() const;

private:
  void findInnerFaces(Execution& execution);
  std::vector<std::uint8_t> findFlawed(Execution& execution);
  void rebuildFlawed(std::vector<std::uint8_t>& flawed, Execution& execution);
  void collapse(
    const std::vector<std::uint8_t>& flawed, const CellSpec& spec, Execution& execution);
  Cells assemble(const CellSpec& spec, Execution& execution) const;
  bool keepTurned(std::vector<std::uint8_t>& keeps, const Cells& cells) const;

  const Boxes& boxes_;
  const Patches* patches_; // the caller's, or those in rebuilt_ or collapsed_
  RebuiltPatches rebuilt_;
  double smallCellRatio_;
  Sides sides_;
  Nodes nodes_;
  InnerFaces inner_;
  Patches collapsed_;
  Cells cells_;
  Shaping shaping_;
  std::unique_ptr<OutputMesh> mesh_;
};

}
