// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkDividePolyhedra
 * @brief divides polyhedra into tetrahedra and pyramids, which VTK's filters cut and measure right
 *
 * Input: a vtkUnstructuredGrid of linear cells. The faces of a polyhedron may be turned either way, but all the same.
 * Output: a conforming vtkUnstructuredGrid of the same volume (OpenFOAM's, Kernel/Polyhedra/CellGeometry.h).
 *
 * Cells of VTK's own kinds whose quadrilaterals are flat and convex stay whole. Every other cell is divided around its
 * centre into pyramids over such quadrilaterals, tetrahedra over triangles, and tetrahedra over the fans of other faces
 * around their centres. Points are those of the input, then new ones, in double precision. Cells are in the order of the input's.
 *
 * Cell arrays are copied; OriginalCellId is the input's cell. Point arrays are interpolated, exactly for linear fields.
 * Global ids of points are dropped, those of cells become an ordinary array. Field data, beside the input's: CellsDivided;
 * CellsMoved, which are divided around another point, as their centre does not see all of their faces from inside;
 * CellsNotStarShaped, which have no such point: some of their parts are inside out, so that their volumes still add up;
 * and NotStarShapedCells, their ids.
 *
 * Errors: BadMesh (cells with curved edges, or too many points), TooManyBoxes (the parts exceed the memory limit).
 *
 * @sa vtkSlicePolyhedra
 */
#ifndef vtkDividePolyhedra_h
#define vtkDividePolyhedra_h

#include "vtkCartesianAlgorithm.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro

class VTKCARTESIANMESHERFILTERS_EXPORT vtkDividePolyhedra : public vtkCartesianAlgorithm
{
public:
  static vtkDividePolyhedra* New();
  vtkTypeMacro(vtkDividePolyhedra, vtkCartesianAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Memory that the output may take, in GiB; 0, the default: three quarters of the machine's.
   */
  vtkSetMacro(MemoryLimit, double);
  vtkGetMacro(MemoryLimit, double);
  ///@}

protected:
  vtkDividePolyhedra() = default;
  ~vtkDividePolyhedra() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  double MemoryLimit = 0;

  vtkDividePolyhedra(const vtkDividePolyhedra&) = delete;
  void operator=(const vtkDividePolyhedra&) = delete;
};

#endif
