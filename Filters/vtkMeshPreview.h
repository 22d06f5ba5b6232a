// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeshPreview
 * @brief shows what vtkCartesianMesher is asked for, in a fraction of the time
 *
 * Inputs and properties: those of vtkCartesianMesher. Outputs, all vtkPolyData and empty where there is nothing to show:
 *
 * Port 0: the triangles of the surface, large ones in pieces. Cell arrays Depth (int), how many times the box at the centre
 * of each is halved, and BoxSize (double), the longest edge of that box in units of the surface. Boxes beside smaller ones may
 * be smaller still, for the transition. Where this would take seconds, there are no arrays (more than 100,000 triangles with
 * refinement by shape or Size Array; millions of boxes) or nothing but the box of port 1 (more than half a million triangles).
 *
 * Port 1: the edges of the box that Domain Outside meshes, where its grid ends; and an arrow along the flow.
 *
 * Port 2: points with the names of the box's sides, and at KeepPoints and KeepOut (point array Label).
 *
 * Port 3: lines of the shapes of refinement zones (cell array Depth), those of BoxesAlongBody included: their sharp edges, or
 * sections if they are round.
 *
 * Errors are not reported, as the work itself will report them: then there are no box sizes and zones, or nothing. On several ranks the first one makes all.
 *
 * @sa vtkCartesianMesher
 */
#ifndef vtkMeshPreview_h
#define vtkMeshPreview_h

#include "vtkCartesianMesher.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro

#include <array> // for std::array

namespace cartesian
{
struct Bounds;
}

class VTKCARTESIANMESHERFILTERS_EXPORT vtkMeshPreview : public vtkCartesianMesher
{
public:
  static vtkMeshPreview* New();
  vtkTypeMacro(vtkMeshPreview, vtkCartesianMesher);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Of the last update: two texts for each Depth of the surface and of zones, the depth and the size of boxes, in ascending order.
   */
  vtkStringArray* GetBoxSizes();

  /**
   * The box that Domain Outside meshes with BoxFrom Surface, without Ground and Half: lower and upper x, y and z. All 0
   * without a surface.
   */
  double* GetBoxAroundSurface() VTK_SIZEHINT(6);

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

  void ShowBoxes(const cartesian::SurfaceFromVTK& surface, vtkInformationVector* output);
  void ShowWithoutBoxes(const cartesian::SurfaceFromVTK& surface, vtkInformationVector* output);
  static void ShowDomain(const cartesian::Bounds& box, const cartesian::DomainSpec& domain,
    vtkInformationVector* output);

  vtkNew<vtkStringArray> BoxSizes;
  std::array<double, 6> BoxAroundSurface{};
};

#endif
