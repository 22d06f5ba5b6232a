// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeshSummary
 * @brief summarises a mesh, and shows its worst cells
 *
 * Input: any unstructured grid of linear cells. Outputs: port 0 "Summary" (vtkTable with the string arrays Brief and
 * Text, one value each), whose brief text ParaView shows in the view; port 1 "Worst Cells" (vtkUnstructuredGrid): the
 * NumberOfWorstCells worst cells by Measure, with all arrays of the input, the measures of vtkFiniteVolumeQuality, and
 * Rank (int, 1 being the worst); port 2 "Failing Cells": those of vtkFiniteVolumeQuality, and what OpenFOAM's checkMesh
 * fails, except layers that are only long.
 *
 * The text says whether OpenFOAM accepts all cells and how many fail, the numbers of cells and points, the volume, and
 * the worst value of each measure with its limit and place, the nearest to its limit first (the brief text: of three
 * measures); for meshes of vtkCartesianMesher also boundaries and regions, and what was relaxed, merged, left out and
 * rebuilt, if anything. On several processes each has the worst and failing cells of its part, and the first has the
 * text for all.
 *
 * Errors: BadMesh (cells with curved edges, or too many points).
 *
 * @sa vtkFiniteVolumeQuality vtkCartesianMesher
 */
#ifndef vtkMeshSummary_h
#define vtkMeshSummary_h

#include "vtkCartesianAlgorithm.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro

#include <string> // for the text

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

  /**
   * After an update, the whole text.
   */
  const char* GetText() const { return this->Text.c_str(); }

  /**
   * After an update, that of vtkFiniteVolumeQuality with its default limits.
   */
  const char* GetWorstMeasure() const { return this->WorstMeasure; }

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
  std::string Text;
  const char* WorstMeasure = "Skewness";

  vtkMeshSummary(const vtkMeshSummary&) = delete;
  void operator=(const vtkMeshSummary&) = delete;
};

#endif
