// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCartesianBoxer
 * @brief divides the space around a surface into boxes
 *
 * Input: a closed surface (vtkPolyData). Output: the boxes that hold a part of the inside
 * (vtkUnstructuredGrid of voxels; sections 4.1 to 4.5 of the paper).
 *
 * Cell arrays of the output: GlobalBox (int, components I, J, K), Status (1 inside, 2 intersected by
 * the surface), CornerStatus (bit x + 2 y + 4 z: that corner is inside). Field data: LatticeOrigin,
 * LatticeStep, PlanesX, PlanesY, PlanesZ, SurfaceClosed (see Conversion/BoxesVTK.h).
 *
 * Errors: EmptySurface, BadCoordinate, BadCellSize, BadMeshlines, TooManyBoxes; FlawedSurface with a
 * valid output.
 *
 * The boxes lie between meshlines: planes across x, y and z. They are CellSize apart, starting at
 * the surface's bounding box, or where the user puts them.
 *
 * @sa vtkPatcher vtkCellAssembler vtkCartesianMesher
 */
#ifndef vtkCartesianBoxer_h
#define vtkCartesianBoxer_h

#include "vtkCartesianAlgorithm.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro

#include <array>  // for std::array
#include <vector> // for std::vector

namespace cartesian
{
struct PreparedSurface;
class SurfaceFromVTK;
}

class VTKCARTESIANMESHERFILTERS_EXPORT vtkCartesianBoxer : public vtkCartesianAlgorithm
{
public:
  static vtkCartesianBoxer* New();
  vtkTypeMacro(vtkCartesianBoxer, vtkCartesianAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Length of a box's edges, in the surface's units; 0, the default, means 1/50 of the longest
   * side of the surface's bounding box. Meshlines win over it in their direction.
   */
  vtkSetMacro(CellSize, double);
  vtkGetMacro(CellSize, double);
  ///@}

  ///@{
  /**
   * Positions of the planes between boxes across x, y and z, in the surface's units: none (the
   * default, CellSize applies), or two or more that increase.
   */
  void SetNumberOfMeshlinesX(int number) { this->SetNumberOfMeshlines(0, number); }
  void SetNumberOfMeshlinesY(int number) { this->SetNumberOfMeshlines(1, number); }
  void SetNumberOfMeshlinesZ(int number) { this->SetNumberOfMeshlines(2, number); }
  void SetMeshlineX(int i, double position) { this->SetMeshline(0, i, position); }
  void SetMeshlineY(int i, double position) { this->SetMeshline(1, i, position); }
  void SetMeshlineZ(int i, double position) { this->SetMeshline(2, i, position); }
  ///@}

  ///@{
  /**
   * The same with the axis as a number: 0, 1, 2 for x, y, z. An index out of range is an error.
   */
  void SetNumberOfMeshlines(int axis, int number);
  int GetNumberOfMeshlines(int axis);
  void SetMeshline(int axis, int i, double position);
  double GetMeshline(int axis, int i);
  ///@}

  ///@{
  /**
   * Memory that the mesh may need by an estimate made first, in GiB; beyond it the filter refuses
   * with TooManyBoxes. 0, the default, means three quarters of this machine's memory.
   */
  vtkSetClampMacro(MemoryLimit, double, 0, VTK_DOUBLE_MAX);
  vtkGetMacro(MemoryLimit, double);
  ///@}

protected:
  vtkCartesianBoxer() = default;
  ~vtkCartesianBoxer() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  /**
   * The surface on the lattice, checked; flaws are reported.
   */
  cartesian::PreparedSurface Prepare(
    const cartesian::SurfaceFromVTK& surface, cartesian::Execution& execution);

  double CellSize = 0;
  std::array<std::vector<double>, 3> Meshlines;
  double MemoryLimit = 0;

private:
  vtkCartesianBoxer(const vtkCartesianBoxer&) = delete;
  void operator=(const vtkCartesianBoxer&) = delete;

  bool HasMeshline(int axis, int i);
};

#endif
