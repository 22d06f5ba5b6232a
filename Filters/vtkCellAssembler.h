// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCellAssembler
 * @brief builds the cells of the mesh from boxes and patches
 *
 * Inputs: port 0 the boxes of vtkCartesianBoxer (vtkUnstructuredGrid), port 1 the patches of
 * vtkPatcher (vtkPolyData). Outputs: port 0 "Mesh" (vtkUnstructuredGrid), port 1 "Boundary"
 * (vtkPolyData), the faces of the mesh that only one cell has. Sections 4.9 and 4.10 and part B of
 * section 6 of the paper.
 *
 * Mesh: hexahedra and polyhedra with outward faces. Cell arrays GlobalBox (int, components I, J, K),
 * Region (int, from 1), VolumeFraction (double: volume by that of the cell's box; beyond 1 after merging). Field data: the statistics, one
 * array of one number each (Cells, Hexahedra, Polyhedra, Points, BoundaryFaces, BoxesInside,
 * BoxesIntersected, BoxesByExactFit, BoxesRebuilt, BoxesFlawed, Patches, SmallCellsRemoved,
 * SmallCellsMerged, CellsSplit, CellsWithJoinedFaces (boundary faces of any angle made one),
 * RefusedPartsCarved and RefusedCellsRemoved (what solvers would refuse),
 * IsolatedCells, VoidsInsideCells, FoldsLeftOut), and numbers of cells as in vtkFiniteVolumeQuality:
 * BoundaryAngleFailures, InnerAngleFailures, OpennessFailures, VolumeFailures.
 * For vtkPolyMeshWriter: cell array CellId (number of the cell) and field data array
 * BoundaryOfFaces (components Cell, Face, BoundaryId: a row for each boundary face).
 *
 * Boundary: cell arrays BoundaryId (int; -1 where no patch was), OwnerCell (cell of the mesh),
 * FaceArea (double, 3: the vector area by star triangulation, equation 1: outwards, so that those of a
 * cell's faces sum up to 0), FaceCentre (double, 3), IPPatch (unsigned char: 1 for faces made of several that
 * met at an angle, section 4.11; one is made only where its centre satisfies the angle condition); point
 * array MeshPointId (point of the mesh).
 *
 * Where the patches of a box do not close, the box and those next to it get others, by Marching Cubes
 * from the statuses of corners (BoxesRebuilt). Boxes that do not close even so are left out
 * (BoxesFlawed): their neighbours' faces become boundary.
 *
 * Errors: MissingArray (inputs that do not belong together), BadParameter; FlawedSurface with a valid
 * output where any box was made anew or left out.
 *
 * @sa vtkCartesianBoxer vtkPatcher vtkCartesianMesher
 */
#ifndef vtkCellAssembler_h
#define vtkCellAssembler_h

#include "vtkCartesianAlgorithm.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro

class VTKCARTESIANMESHERFILTERS_EXPORT vtkCellAssembler : public vtkCartesianAlgorithm
{
public:
  static vtkCellAssembler* New();
  vtkTypeMacro(vtkCellAssembler, vtkCartesianAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Edges shorter than this fraction of their box collapse, so that hardly any small cell is left
   * (4.10): 0 (none) to 0.3; default 0.1. Corners of boxes move onto the surface; nodes of the surface
   * move along it only.
   */
  vtkSetMacro(CollapseRatio, double);
  vtkGetMacro(CollapseRatio, double);
  ///@}

  /**
   * What becomes of small cells (4.10); default Merge.
   */
  enum SmallCellsModes
  {
    Remove = 0, ///< left out; their inner faces become boundary faces of their neighbours
    Merge = 1   ///< a part of the neighbour across the largest area; the volume is kept
  };

  ///@{
  vtkSetClampMacro(SmallCells, int, Remove, Merge);
  vtkGetMacro(SmallCells, int);
  ///@}

  ///@{
  /**
   * With Merge: cells smaller than this fraction of their box are merged: 0 (none) to less than 1;
   * default 0.015.
   */
  vtkSetMacro(MergeRatio, double);
  vtkGetMacro(MergeRatio, double);
  ///@}

  ///@{
  /**
   * Cut cells that fail an angle condition of section 3 along their concave edges (4.11); default
   * on.
   */
  vtkSetMacro(SplitConcaveCells, bool);
  vtkGetMacro(SplitConcaveCells, bool);
  vtkBooleanMacro(SplitConcaveCells, bool);
  ///@}

  ///@{
  /**
   * Cells smaller than this fraction of their box are left out: 0 (none but those without volume)
   * to less than 1; default 0.001.
   */
  vtkSetMacro(SmallCellRatio, double);
  vtkGetMacro(SmallCellRatio, double);
  ///@}

  ///@{
  /**
   * Where concave cells are split and the patches are not exact: what solvers would refuse (section 3,
   * checkMesh) and nothing mends is left out, up to as many volumes of its box; default 4. 0: none
   * is. Boundaries with a small cell ratio of their own keep larger ones.
   */
  vtkSetMacro(RefusedCellRatio, double);
  vtkGetMacro(RefusedCellRatio, double);
  ///@}

  ///@{
  /**
   * What is special about boundaries, by name, a row each: the type that vtkPolyMeshWriter gives the
   * patch (automatic, patch, wall, symmetry, symmetryPlane, empty), and what stands for
   * SmallCellRatio in cells whose patches are mostly of it (section 4.10). As many types and ratios
   * as names, or none. "no_surface" is where there is no patch.
   */
  void SetNumberOfBoundaryNames(int number) { this->Resize(this->BoundaryNames, number); }
  void SetBoundaryName(int row, const char* name);
  void SetNumberOfBoundaryTypes(int number) { this->Resize(this->BoundaryTypes, number); }
  void SetBoundaryType(int row, const char* type);
  void SetNumberOfBoundarySmallCellRatios(int number)
  {
    this->Resize(this->BoundaryRatios, number);
  }
  void SetBoundarySmallCellRatio(int row, double ratio);
  ///@}

protected:
  vtkCellAssembler();
  ~vtkCellAssembler() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  double CollapseRatio = 0.1;
  int SmallCells = Merge;
  double MergeRatio = 0.015;
  double SmallCellRatio = 1e-3;
  bool SplitConcaveCells = true;
  double RefusedCellRatio = 4;
  std::vector<std::string> BoundaryNames;
  std::vector<std::string> BoundaryTypes;
  std::vector<double> BoundaryRatios;

private:
  vtkCellAssembler(const vtkCellAssembler&) = delete;
  void operator=(const vtkCellAssembler&) = delete;
};

#endif
