// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeshSummary
 * @brief summarises a mesh, and shows its worst cells
 *
 * Input: any unstructured grid of linear cells. Outputs: port 0 "Summary" (vtkTable with the string array Text, one
 * value), which ParaView shows in the view; port 1 "Worst Cells" (vtkUnstructuredGrid): the NumberOfWorstCells worst
 * cells by Measure, with all arrays of the input, the measures of vtkFiniteVolumeQuality, and Rank (int, 1 being the
 * worst).
 *
 * The text has the numbers of cells and points, the volume, the worst value of each measure and its place, and how
 * many cells fail; for meshes of vtkCartesianMesher also boundaries and regions, and what was relaxed, merged, left
 * out and rebuilt, if anything. On several processes each has the worst cells of its part, and the first has the text
 * for all.
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
   * The measure that defines the worst cells, in the order of the table of vtkFiniteVolumeQuality, from 0, Volume, to
   * 13, Concavity; default 7, Skewness.
   */
  vtkSetClampMacro(Measure, int, 0, 13);
  vtkGetMacro(Measure, int);
  ///@}

  ///@{
  /**
   * Number of worst cells; 0 or more, default 10.
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
