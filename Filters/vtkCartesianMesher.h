// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCartesianMesher
 * @brief meshes the inside of a closed surface
 *
 * Input: a closed surface (vtkPolyData). Outputs: port 0 "Mesh" (vtkUnstructuredGrid), port 1
 * "Boundary" (vtkPolyData), the faces of the mesh that only one cell has; their arrays are those of
 * vtkCellAssembler, the errors those of all three filters. Port 2 "Defects" (vtkPolyData): see
 * vtkSurfaceInspector; none with several regions. Port 3 "Interfaces" (vtkPolyData): the faces between
 * two regions, with the arrays that Conversion/MeshToVTK.h lists.
 *
 * vtkCartesianBoxer, vtkPatcher and vtkCellAssembler in one, with the same result bit for bit: the
 * boxer's properties are inherited, those shared with the other two are in vtkCartesianProperties.h.
 *
 * Asked for a piece of the mesh, by its rank or by a writer that streams, it makes that piece only: a
 * slab of the grid. Pieces have global ids (cells: CellId, points: GlobalPointIds); together they are
 * the whole mesh, bit for bit. Defects come with piece 0. Every rank has the whole surface,
 * which may come whole or distributed; ghost cells, where asked for, are vtkGhostCellsGenerator's.
 * With InPieces off, piece 0 is the whole mesh.
 *
 * @sa vtkCartesianBoxer vtkPatcher vtkCellAssembler vtkSurfaceInspector
 */
#ifndef vtkCartesianMesher_h
#define vtkCartesianMesher_h

#include "vtkCartesianBoxer.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro
#include "vtkCartesianProperties.h"          // for vtkPatchPropertiesMacro

#include <cstdint> // for std::int32_t
#include <memory> // for std::unique_ptr
#include <vector> // for std::vector

namespace cartesian
{
struct MeshPiece;
class Processes;
}

class VTKCARTESIANMESHERFILTERS_EXPORT vtkCartesianMesher : public vtkCartesianBoxer
{
public:
  static vtkCartesianMesher* New();
  vtkTypeMacro(vtkCartesianMesher, vtkCartesianBoxer);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkPatchPropertiesMacro();
  vtkCellPropertiesMacro();
  vtkBoundarySettingsMacro();

public:
  /**
   * What tells the regions of the mesh apart; One by default.
   */
  enum RegionSources
  {
    One = 0,    // there is one
    Blocks = 1, // each block of the surface at the top is one
    Array = 2,  // triangles with the same value of RegionArray are one
  };

  ///@{
  /**
   * Boundary layers: how many prisms are stacked on each boundary face of a wall; 0, the default: none. A
   * boundary is a wall unless its type is patch, symmetry, symmetryPlane or empty, or, without a type, its
   * name begins with inlet, outlet, cyclic or symmetry.
   */
  vtkSetMacro(Layers, int);
  vtkGetMacro(Layers, int);
  ///@}

  ///@{
  /**
   * Each layer's thickness divided by that of the one nearer to the wall: 1 to 3, default 1.2.
   */
  vtkSetMacro(LayerExpansionRatio, double);
  vtkGetMacro(LayerExpansionRatio, double);
  ///@}

  ///@{
  /**
   * The thickness of the layer at the wall, or else of all together, in units of the surface. Both 0, the
   * default: the last layer is half as thick as a box.
   */
  vtkSetMacro(FirstLayerThickness, double);
  vtkGetMacro(FirstLayerThickness, double);
  vtkSetMacro(LayersThickness, double);
  vtkGetMacro(LayersThickness, double);
  ///@}

  ///@{
  /**
   * Each region needs a closed surface. Regions may touch, in common planes or along the same triangles,
   * or lie in one another; where several are, the first is. Cells of two regions share the faces between.
   */
  vtkSetClampMacro(RegionsFrom, int, One, Array);
  vtkGetMacro(RegionsFrom, int);
  void SetRegionsFromToOne() { this->SetRegionsFrom(One); }
  void SetRegionsFromToBlocks() { this->SetRegionsFrom(Blocks); }
  void SetRegionsFromToArray() { this->SetRegionsFrom(Array); }
  ///@}

  ///@{
  /**
   * Cell array of the surface that numbers or names the regions, in the order in which they first appear.
   */
  vtkSetMacro(RegionArray, std::string);
  vtkGetMacro(RegionArray, std::string);
  ///@}

  ///@{
  /**
   * Walls of two regions that face each other at most this far apart become one: that of the earlier region.
   * In units of the surface; 0, the default: only what touches does.
   */
  vtkSetMacro(ContactTolerance, double);
  vtkGetMacro(ContactTolerance, double);
  ///@}

  ///@{
  /**
   * Whether each rank makes a piece of the mesh; off: the first rank makes all of it. Default: on.
   */
  vtkSetMacro(InPieces, bool);
  vtkGetMacro(InPieces, bool);
  vtkBooleanMacro(InPieces, bool);
  ///@}

  /**
   * In how many pieces the mesh has to be made, one after the other, so that none takes more than
   * MemoryLimit by an estimate; 1 where it cannot be made in pieces. 0 after an error, such as TooManyBoxes where none is small enough.
   */
  int EstimateNumberOfPieces();

protected:
  vtkCartesianMesher();
  ~vtkCartesianMesher() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  cartesian::Options MakeOptions() override;

  bool InPieces = true;
  int Layers = 0;
  double LayerExpansionRatio = 1.2;
  double FirstLayerThickness = 0;
  double LayersThickness = 0;
  std::vector<std::int32_t> BoundariesWithoutLayers; // of the surface being meshed

private:
  vtkCartesianMesher(const vtkCartesianMesher&) = delete;
  void operator=(const vtkCartesianMesher&) = delete;

  struct Task;
  struct Piece;

  void Begin(Task& task, const Piece& piece, const cartesian::Processes& processes,
    vtkInformationVector** input, vtkInformationVector* output, cartesian::Execution& execution);
  static void Make(const Task& task, Piece& piece, cartesian::Execution& execution);
  void CountPiecesBefore(Task& task, const Piece& piece, cartesian::Execution& execution);
  void RequestPieceAlone(Piece& piece, vtkInformationVector** input, vtkInformationVector* output);
  static unsigned long CodeOfAll(
    const std::vector<std::vector<double>>& counts, const cartesian::Processes& processes);
  void RequestPieceOfProcess(Piece& piece, const cartesian::Processes& processes,
    vtkInformationVector** input, vtkInformationVector* output);
  void Write(const Task& task, const Piece& piece, const cartesian::MeshPiece& place,
    vtkInformationVector* output, cartesian::Execution& execution);

  std::unique_ptr<Task> Kept; // from piece to piece, where this process makes all
};

#endif
