// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeshPreview
 * @brief shows what vtkCartesianMesher is asked for, in a fraction of the time
 *
 * Inputs and properties: those of vtkCartesianMesher. Outputs, all vtkPolyData and empty where there is nothing to show:
 *
 * Port 0: the triangles of the surface. Cell arrays Depth (int), how many times boxes are halved at the centre of each
 * triangle, and BoxSize (double), the longest edge of these boxes in units of the surface; both 0 for a triangle without
 * an area. No arrays if the surface passes through millions of boxes. Boxes beside smaller ones may be smaller still, for the
 * transition.
 *
 * Port 1: the edges of the box that Domain Outside meshes, where its grid ends; and an arrow along the flow.
 *
 * Port 2: points with the names of the box's sides, and at KeepPoints (point array Label).
 *
 * Port 3: the shapes of refinement zones (cell array Depth), those of BoxesAlongBody included.
 *
 * Errors are not reported: outputs are empty. The work itself will report them. On several ranks the first one makes all.
 *
 * @sa vtkCartesianMesher
 */
#ifndef vtkMeshPreview_h
#define vtkMeshPreview_h

#include "vtkCartesianMesher.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro

class VTKCARTESIANMESHERFILTERS_EXPORT vtkMeshPreview : public vtkCartesianMesher
{
public:
  static vtkMeshPreview* New();
  vtkTypeMacro(vtkMeshPreview, vtkCartesianMesher);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Of the last update: two texts for each Depth of the surface, the depth and the size of boxes, in ascending order.
   */
  vtkStringArray* GetBoxSizes();

protected:
  vtkMeshPreview() = default;
  ~vtkMeshPreview() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkMeshPreview(const vtkMeshPreview&) = delete;
  void operator=(const vtkMeshPreview&) = delete;

  void Show(const cartesian::SurfaceView& surface, const cartesian::Options& options,
    vtkInformationVector* output);

  vtkNew<vtkStringArray> BoxSizes;
};

#endif
