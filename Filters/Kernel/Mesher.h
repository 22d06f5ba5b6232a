// The whole meshing task, step by step (section 6): what the filters run.
//
//   surface --prepareSurface--> Surface, Meshlines     steps 2, 3, 4
//           --boxSurface------> Boxes, Shoeboxes       steps 5, 7, 8   (Cartesian Boxer)
//           --generatePatches-> Patches                A1              (Patcher)
//           --Assembly--------> Sides, InnerFaces,     9, A3, B1-B4    (Cell Assembler)
//                               Cells, Mesh            11-13
#pragma once

#include "BoxGeneration.h"
#include "CellShaping.h"
#include "FlawedBoxes.h"
#include "Mesh.h"
#include "SurfaceDefects.h"

#include <memory>

namespace cartesian
{

// Where each stage ends, as a part of all work: measured on a mesh of 1.9 million cells with default
// properties.
constexpr double AfterSurface = 0.005;
constexpr double AfterDefects = 0.01; // while Boxes begin where Surface ends
constexpr double AfterBoxes = 0.035;
constexpr double AfterPatches = 0.12;
constexpr double AfterSides = 0.23;
constexpr double AfterInnerFaces = 0.26;
constexpr double AfterCells = 0.305;
constexpr double AfterShortEdges = 0.4;
constexpr double AfterShaping = 0.92;
constexpr double AfterNumbering = 0.955;

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
// `parts` that the mesh is made in (Division.h). Throws Error: EmptySurface, BadCoordinate,
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

  const Mesh& mesh() const { return *mesh_; }

  // Intersected boxes that have no cells because the surface does not close in them, and neither do
  // patches made anew (FlawedBoxes.h).
  std::vector<std::uint32_t> flawedBoxes() const;

  // How many boxes have patches made anew.
  std::size_t rebuiltBoxes() const;

  // Both in words, with places, or nothing.
  std::string describeFlaws() const;

  // Why there is no cell.
  std::string describeNothing() const;

  // The statistics of step 12: names and values. Of a part (Division.h), those of its core: the parts'
  // add up.
  std::vector<std::pair<const char*, double>> statistics() const;

private:
  void findInnerFaces(Execution& execution);
  void assemble(const CellSpec& spec, Execution& execution);
  void rebuildFlawed(const CellSpec& spec, Execution& execution);
  void collapse(const CellSpec& spec, Execution& execution);
  bool keepTurned(std::vector<std::uint8_t>& keeps) const;

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
  std::unique_ptr<Mesh> mesh_;
};

}
