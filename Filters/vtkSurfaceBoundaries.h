// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceBoundaries
 * @brief lists the boundaries of a surface that vtkCartesianMesher gets, and shows some
 *
 * Inputs and properties: those of vtkCartesianMesher, of which those count that tell boundaries apart. Output: a vtkPolyData,
 * the triangles of the chosen boundaries, on both sides of the surface, so near that they cover it.
 *
 * Errors are not reported, as the mesher itself will report them: then nothing is listed and shown. On several ranks the
 * first one knows all.
 *
 * @sa vtkCartesianMesher
 */
#ifndef vtkSurfaceBoundaries_h
#define vtkSurfaceBoundaries_h

#include "vtkCartesianMesher.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string
#include <vector> // for std::vector

class VTKCARTESIANMESHERFILTERS_EXPORT vtkSurfaceBoundaries : public vtkCartesianMesher
{
public:
  static vtkSurfaceBoundaries* New();
  vtkTypeMacro(vtkSurfaceBoundaries, vtkCartesianMesher);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Of the last update, in rows of three texts: the name, the area in user units and the number of triangles, which are
   * empty without triangles, as those of a side of the box around the surface.
   */
  vtkStringArray* GetList();

  ///@{
  /**
   * Names of the boundaries to show, or patterns with * and ?.
   */
  void SetNumberOfShown(int number);
  void SetShown(int row, const char* name);
  ///@}

  ///@{
  /**
   * Two points, and, after an update, the first boundary on the way from one to the other; empty if there is none.
   */
  vtkSetVector6Macro(Way, double);
  vtkGetVector6Macro(Way, double);
  const char* GetBoundaryOnWay();
  ///@}

protected:
  vtkSurfaceBoundaries();
  ~vtkSurfaceBoundaries() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkSurfaceBoundaries(const vtkSurfaceBoundaries&) = delete;
  void operator=(const vtkSurfaceBoundaries&) = delete;

  void ReadAnew(vtkDataObject* data);

  std::vector<std::string> Shown;
  double Way[6] = { 0, 0, 0, 0, 0, 0 };
  std::unique_ptr<cartesian::SurfaceFromVTK> Surface; // null: cannot be read
  vtkNew<vtkStringArray> List;
  std::string BoundaryOnWay;
};

#endif
