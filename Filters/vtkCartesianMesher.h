// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCartesianMesher
 * @brief meshes the inside of a closed surface
 *
 * Input: a closed surface (vtkPolyData). Outputs: port 0 "Mesh" (vtkUnstructuredGrid), port 1
 * "Boundary" (vtkPolyData), the faces of the mesh that only one cell has; their arrays are those of
 * vtkCellAssembler, the errors those of all three filters. Port 2 "Defects" (vtkPolyData): see
 * vtkSurfaceInspector.
 *
 * vtkCartesianBoxer, vtkPatcher and vtkCellAssembler in one, with the same result bit for bit: the
 * boxer's properties are inherited, the other two's repeated here.
 *
 * @sa vtkCartesianBoxer vtkPatcher vtkCellAssembler vtkSurfaceInspector
 */
#ifndef vtkCartesianMesher_h
#define vtkCartesianMesher_h

#include "vtkCartesianBoxer.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro

class VTKCARTESIANMESHERFILTERS_EXPORT vtkCartesianMesher : public vtkCartesianBoxer
{
public:
  static vtkCartesianMesher* New();
  vtkTypeMacro(vtkCartesianMesher, vtkCartesianBoxer);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * See vtkPatcher.
   */
  vtkSetClampMacro(PatchMethod, int, 0, 0);
  vtkGetMacro(PatchMethod, int);
  ///@}

  ///@{
  /**
   * See vtkCellAssembler.
   */
  vtkSetMacro(SmallCellRatio, double);
  vtkGetMacro(SmallCellRatio, double);
  ///@}

protected:
  vtkCartesianMesher();
  ~vtkCartesianMesher() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  int PatchMethod = 0;
  double SmallCellRatio = 1e-3;

private:
  vtkCartesianMesher(const vtkCartesianMesher&) = delete;
  void operator=(const vtkCartesianMesher&) = delete;
};

#endif
