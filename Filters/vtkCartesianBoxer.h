// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCartesianBoxer
 * @brief divides the space around a surface into boxes
 *
 * Inputs and errors: see vtkCartesianGridAlgorithm. Output: the boxes that contain part of the inside
 * (vtkUnstructuredGrid of voxels; sections 4.1 to 4.6 of the paper).
 *
 * Cell arrays of the output: GlobalBox (int, components I, J, K), Level and Offset (how often
 * halved along x, y, z, and where in the global box, in parts of which the field data PartsPerBox tells the number), Status (1 inside, 2 intersected by
 * the surface), CornerStatus (bit x + 2 y + 4 z: that corner is inside). Field data: LatticeOrigin,
 * LatticeStep, PlanesX, PlanesY, PlanesZ (see Conversion/BoxesVTK.h).
 *
 * One region, whole, and the inside of the surface only: for several regions, flow domains around bodies, boundary
 * layers, baffles, cell budgets and pieces, use vtkCartesianMesher.
 *
 * @sa vtkPatcher vtkCellAssembler vtkCartesianMesher
 */
#ifndef vtkCartesianBoxer_h
#define vtkCartesianBoxer_h

#include "vtkCartesianGridAlgorithm.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro

class VTKCARTESIANMESHERFILTERS_EXPORT vtkCartesianBoxer : public vtkCartesianGridAlgorithm
{
public:
  static vtkCartesianBoxer* New();
  vtkTypeMacro(vtkCartesianBoxer, vtkCartesianGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkCartesianBoxer() = default;
  ~vtkCartesianBoxer() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkCartesianBoxer(const vtkCartesianBoxer&) = delete;
  void operator=(const vtkCartesianBoxer&) = delete;
};

#endif
