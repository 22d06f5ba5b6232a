// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkQualityHistogram
 * @brief how many cells of a mesh have which quality, with the limit
 *
 * Input: any unstructured grid of linear cells. Outputs, both vtkTable: port 0 "Histogram", to be drawn as lines over
 * its first column, which is called as the measure: Cells, the outline of the histogram (half a cell where there are
 * none, so that it can be drawn logarithmically), and for a measure with a limit a column called by that, a vertical
 * line; elsewhere NaN. Port 1 "Bins": Low and High, the ends of each bin, and Cells (id type), exact: their sum is the
 * number of cells (of First Layer Height: of cells of first layers), as each counts once with the worst value of its
 * faces. Values at an end count in the bin above, the largest in the last.
 *
 * The field data of both: the array Limit (double), if there is one, that of vtkFiniteVolumeQuality. On several
 * processes all cells count, and the first has the tables.
 *
 * Errors: BadMesh (cells with curved edges, or too many points); MissingArray: the mesh has no VolumeFraction or no
 * Layer, which meshes of vtkCartesianMesher have (the latter with layers).
 *
 * @sa vtkFiniteVolumeQuality vtkMeshSummary
 */
#ifndef vtkQualityHistogram_h
#define vtkQualityHistogram_h

#include "vtkCartesianAlgorithm.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro

class VTKCARTESIANMESHERFILTERS_EXPORT vtkQualityHistogram : public vtkCartesianAlgorithm
{
public:
  static vtkQualityHistogram* New();
  vtkTypeMacro(vtkQualityHistogram, vtkCartesianAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What is counted: 0 to 13, the measures of vtkFiniteVolumeQuality in the order of its table; 14, VolumeFraction of the
   * mesh; 15, the height of first layers: volume by area on the wall, in the units of the mesh. Default 7, Skewness.
   */
  vtkSetClampMacro(Measure, int, 0, 15);
  vtkGetMacro(Measure, int);
  ///@}

  ///@{
  /**
   * Number of bins; 1 to 10000, default 50.
   */
  vtkSetClampMacro(Bins, int, 1, 10000);
  vtkGetMacro(Bins, int);
  ///@}

  ///@{
  /**
   * After an update: the measure, in words and with its limit, for the axis of a chart.
   */
  const char* GetAxisTitle() const { return this->AxisTitle.c_str(); }
  ///@}

protected:
  vtkQualityHistogram();
  ~vtkQualityHistogram() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  int Measure = 7;
  int Bins = 50;

private:
  std::string AxisTitle;

  vtkQualityHistogram(const vtkQualityHistogram&) = delete;
  void operator=(const vtkQualityHistogram&) = delete;
};

#endif
