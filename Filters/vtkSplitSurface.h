// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSplitSurface
 * @brief divides a surface into named boundaries
 *
 * Input 0: a surface (vtkPolyData, or blocks of it, which become one piece of triangles, and of the lines that
 * are their sharp edges, if those are known: cell array SharpEdge, as in vtkCartesianMesher). Input 1, optional: a selection
 * (vtkSelection) of its cells, beside SelectedCells. Output: the surface, with the cell arrays BoundaryId (int) and
 * BoundaryName (string), which replace STLSolidLabeling, and field data with one value per boundary: BoundaryIds, BoundaryNames, BoundaryFaceCounts,
 * BoundaryAreas (in square units of the surface).
 *
 * Boundaries that the surface has are divided further: no part belongs to two of them. A boundary that is not divided
 * keeps its name. How it is divided and named is in Kernel/Surface/SurfaceSplit.h and Conversion/SplitNames.h.
 *
 * Errors: EmptySurface, BadCoordinate, MissingArray (Boundary Array), BadParameter (a name that is no boundary's, or twice;
 * a selection that has no cell of the surface, or no name; a selected cell that the surface does not have).
 *
 * @sa vtkCartesianMesher vtkNamedSTLReader vtkNamedSTLWriter
 */
#ifndef vtkSplitSurface_h
#define vtkSplitSurface_h

#include "vtkCartesianAlgorithm.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro
#include "vtkCartesianProperties.h"          // for vtkBoundaryNamesMacro
#include "vtkNew.h"                          // for the table

#include <string> // for names
#include <vector> // for rows

class vtkPolyData;
class vtkSelection;
class vtkStringArray;

namespace cartesian
{
class SurfaceParts;
}

class VTKCARTESIANMESHERFILTERS_EXPORT vtkSplitSurface : public vtkCartesianAlgorithm
{
public:
  static vtkSplitSurface* New();
  vtkTypeMacro(vtkSplitSurface, vtkCartesianAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * A selection of cells of the input: they become a boundary.
   */
  void SetSelectionConnection(vtkAlgorithmOutput* selection)
  {
    this->SetInputConnection(1, selection);
  }

  enum SplitByType
  {
    FEATURE_ANGLE,   ///< at edges where the surface turns by more than the feature angle
    FLAT_CAPS,       ///< flat ends of ducts, and the rest of each boundary
    PLANES,          ///< flat parts, those in one plane together, and the rest of each boundary
    CONNECTED_PARTS, ///< parts without a common edge
    BOUNDARIES       ///< not at all: only names and the selection count
  };
  ///@{
  /**
   * What is divided. FLAT_CAPS by default.
   */
  vtkSetClampMacro(SplitBy, int, FEATURE_ANGLE, BOUNDARIES);
  vtkGetMacro(SplitBy, int);
  ///@}

  ///@{
  /**
   * In degrees, 0 to 180; 30 by default.
   */
  vtkSetClampMacro(FeatureAngle, double, 0, 180);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * Names of caps, separated by commas: the largest has the first, and so on; further ones number the last. "cap" by
   * default.
   */
  vtkSetMacro(CapNames, std::string);
  vtkGetMacro(CapNames, std::string);
  ///@}

  ///@{
  /**
   * Cell array of the input that numbers or names its boundaries; Automatic, the default: as in vtkCartesianMesher.
   */
  vtkSetMacro(BoundaryArray, std::string);
  vtkGetMacro(BoundaryArray, std::string);
  ///@}

  ///@{
  /**
   * Cells of the output, which are those of the input in their order, that become a boundary: each at least 0 and less than
   * the number of cells. With a selection, both. None by default.
   */
  void SetNumberOfSelectedCells(int number) { this->Resize(this->SelectedCells, number); }
  void SetSelectedCell(int row, int cell) { this->SetRow(this->SelectedCells, row, cell); }
  ///@}

  ///@{
  /**
   * The boundary that selected cells become, or join. "selected" by default.
   */
  vtkSetMacro(SelectionName, std::string);
  vtkGetMacro(SelectionName, std::string);
  ///@}

  ///@{
  /**
   * Whether all of the patches become it that have a selected cell, instead of the selected cells alone. On by default.
   */
  vtkSetMacro(SelectWholePatches, bool);
  vtkGetMacro(SelectWholePatches, bool);
  vtkBooleanMacro(SelectWholePatches, bool);
  ///@}

  vtkBoundaryNamesMacro();

public:
  ///@{
  /**
   * The new name for each of BoundaryNames, which are names after the division, or patterns; empty: unchanged. Those of
   * one name become one boundary.
   */
  void SetNumberOfBoundaryMergedNames(int number)
  {
    this->Resize(this->BoundaryMergedNames, number);
  }
  void SetBoundaryMergedName(int row, const char* name)
  {
    this->SetRow(this->BoundaryMergedNames, row, std::string(name ? name : ""));
  }
  ///@}

  /**
   * Four texts a row of what the last update has made: boundary, what it was called before it was renamed, area, triangles.
   * The first row has the column titles.
   */
  vtkStringArray* GetFoundBoundaries();

protected:
  vtkSplitSurface();
  ~vtkSplitSurface() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  // By cell of the surface; empty: nothing is to be selected.
  std::vector<bool> Selected(vtkPolyData* surface, vtkSelection* selection) const;

  // Lists the boundaries; `areas`: of the triangles.
  void Describe(
    const cartesian::SurfaceParts& parts, const std::vector<double>& areas, vtkPolyData* output);

  int SplitBy = FLAT_CAPS;
  double FeatureAngle = 30;
  std::string CapNames = "cap";
  std::string BoundaryArray;
  std::vector<int> SelectedCells;
  std::string SelectionName = "selected";
  bool SelectWholePatches = true;
  std::vector<std::string> BoundaryMergedNames;
  vtkNew<vtkStringArray> FoundBoundaries;

  vtkSplitSurface(const vtkSplitSurface&) = delete;
  void operator=(const vtkSplitSurface&) = delete;
};

#endif
