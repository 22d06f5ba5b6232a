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
 * SmallCellsMerged, CellsSplit, CellsWithJoinedFaces (faces of any angle made one),
 * RefusedCellsRemoved (what solvers would refuse), FragmentCellsRemoved (what the grid cuts off),
 * IsolatedCells, VoidsInsideCells, FoldsLeftOut), and numbers of cells as in vtkFiniteVolumeQuality:
 * BoundaryAngleFailures, InnerAngleFailures, OpennessFailures, VolumeFailures.
 * For vtkPolyMeshWriter: cell array CellId (number of the cell) and field data array
 * BoundaryOfFaces (components Cell, Face, BoundaryId: a row for each boundary face).
 *
 * Boundary: cell arrays BoundaryId (int; -1 where no patch was), OwnerCell (CellId of the cell),
 * FaceArea (double, 3: the vector area by star triangulation, equation 1: outwards, so that those of a
 * cell's faces sum up to 0), FaceCentre (double, 3), IPPatch (unsigned char: 1 for faces made of several that
 * met at an angle, section 4.11; one is made only where its centre satisfies the angle condition); point
 * array MeshPointId (point of the mesh).
 *
 * Sharp edges, which the collapse of short edges keeps, are those of the Feature Angle that the patches were
 * made with (field data FeatureAngle).
 *
 * Where the patches of a box do not close, the box and those next to it get others, by Marching Cubes
 * from the statuses of corners (BoxesRebuilt). Boxes that do not close even so are left out
 * (BoxesFlawed): their neighbours' faces become boundary.
 *
 * Errors: MissingArray (inputs that do not belong together), BadParameter; FlawedSurface where no
 * cell is left.
 *
 * @sa vtkCartesianBoxer vtkPatcher vtkCartesianMesher
 */
#ifndef vtkCellAssembler_h
#define vtkCellAssembler_h

#include "vtkCartesianAlgorithm.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro
#include "vtkCartesianProperties.h"          // for vtkCellPropertiesMacro

class VTKCARTESIANMESHERFILTERS_EXPORT vtkCellAssembler : public vtkCartesianAlgorithm
{
public:
  static vtkCellAssembler* New();
  vtkTypeMacro(vtkCellAssembler, vtkCartesianAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkCellPropertiesMacro();
  vtkBoundaryNamesMacro();
  vtkBoundarySettingsMacro();

protected:
  vtkCellAssembler();
  ~vtkCellAssembler() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkCellAssembler(const vtkCellAssembler&) = delete;
  void operator=(const vtkCellAssembler&) = delete;
};

#endif
