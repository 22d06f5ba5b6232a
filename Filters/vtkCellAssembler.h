// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCellAssembler
 * @brief builds the cells of the mesh from boxes and patches
 *
 * Inputs: port 0 the boxes of vtkCartesianBoxer (vtkUnstructuredGrid), port 1 the patches of vtkPatcher
 * (vtkPolyData). Outputs: port 0 "Mesh" (vtkUnstructuredGrid), port 1 "Boundary" (vtkPolyData), the faces that belong
 * to only one cell. Sections 4.9 and 4.10 and part B of section 6 of the paper.
 *
 * Mesh: hexahedra and polyhedra with outward faces. Cell arrays GlobalBox (int, components I, J, K), Region (int,
 * from 1), VolumeFraction (double: volume by that of the cell's box; beyond 1 after merging). Field data: the
 * statistics, one array of one number each (Cells, Hexahedra, Polyhedra, Points, BoundaryFaces, BoxesInside,
 * BoxesIntersected, BoxesByExactFit, BoxesRebuilt, BoxesFlawed, Patches, SmallCellsRemoved, SmallCellsMerged,
 * CellsSplit, CellsWithJoinedFaces (faces joined across any angle), RefusedCellsRemoved (failing cells
 * and pieces of any size), FragmentCellsRemoved (cut off by the grid), IsolatedCells, VoidsInsideCells, FoldsLeftOut), and numbers of cells as
 * in vtkFiniteVolumeQuality: BoundaryAngleFailures, InnerAngleFailures, OpennessFailures, VolumeFailures. For
 * vtkPolyMeshWriter: cell array CellId (number of the cell) and field data array BoundaryOfFaces (components Cell,
 * Face, BoundaryId: a row for each boundary face).
 *
 * Boundary: cell arrays BoundaryId (int; -1 where there was no patch), OwnerCell (CellId of the cell), FaceArea
 * (double, 3: the area vector by star triangulation, equation 1: outwards, so that those of a cell's faces sum to 0),
 * FaceCentre (double, 3), IPPatch (unsigned char: 1 for faces joined from several that met at an angle, section 4.11;
 * made only where its centre satisfies the angle condition); point array MeshPointId (point of the mesh).
 *
 * Sharp edges, which the collapse of short edges preserves, are defined by the Feature Angle of the patches (field
 * data FeatureAngle).
 *
 * Where the patches of a box do not close, those of the box and its neighbours are rebuilt by Marching Cubes from the
 * corner statuses (BoxesRebuilt). Boxes that still do not close are left out (BoxesFlawed): their neighbours' faces
 * become boundary.
 *
 * Errors: MissingArray (inputs that do not belong together), BadParameter; FlawedSurface if no cell is left.
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
