// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeshSummary
 * @brief what a mesh is, at a glance, and its worst cells
 *
 * Input: any unstructured grid of linear cells. Outputs: port 0 "Summary" (vtkTable with the string array Text, one
 * value), which ParaView shows in the view; port 1 "Worst Cells" (vtkUnstructuredGrid): the NumberOfWorstCells cells
 * that are worst by Measure, with all arrays of the input, the measures of vtkFiniteVolumeQuality, and Rank (int,
 * from 1, the worst).
 *
 * The text has the numbers of cells and points, the volume, the worst value of each measure and where that is, how
 * many cells fail; and of a mesh of ours its boundaries and regions, and what was relaxed, merged, left out and
 * made anew, as far as there is any. On several processes, which measure their own parts, each has the worst cells of its
 * part, and the first one the text of all.
 *
 * Errors: BadMesh (cells with curved edges, or too many points).
 *
 * @sa vtkFiniteVolumeQuality vtkCartesianMesher
 */
#ifndef vtkMeshSummary_h
#define vtkMeshSummary_h

#include "vtkCartesianAlgorithm.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro

class VTKCARTESIANMESHERFILTERS_EXPORT vtkMeshSummary : public vtkCartesianAlgorithm
{
public:
  static vtkMeshSummary* New();
  vtkTypeMacro(vtkMeshSummary, vtkCartesianAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What the worst cells are chosen by: a measure of vtkFiniteVolumeQuality in the order of its table, from 0, Volume,
   * to 13, Concavity; default 7, Skewness.
   */
  vtkSetClampMacro(Measure, int, 0, 13);
  vtkGetMacro(Measure, int);
  ///@}

  ///@{
  /**
   * How many worst cells there are; 0 or more, default 10.
   */
  vtkSetClampMacro(NumberOfWorstCells, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfWorstCells, int);
  ///@}

protected:
  vtkMeshSummary();
  ~vtkMeshSummary() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  int Measure = 7;
  int NumberOfWorstCells = 10;

private:
  vtkMeshSummary(const vtkMeshSummary&) = delete;
  void operator=(const vtkMeshSummary&) = delete;
};

#endif
