// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSlicePolyhedra
 * @brief sections of cells with planes: one polygon for each connected part of a cell's section
 *
 * Input: a vtkDataSet of linear cells; cells without a volume are left out. Output: a vtkPolyData of polygons, turned to the
 * normal. Points are on the edges of the mesh; polygons of neighbouring cells share them.
 *
 * What lies in the plane counts as above it: a face in it is the section of the cell below. A section with holes is one
 * polygon, joined to each hole by two edges that coincide. The cells of the input's boundary that only touch the plane from above
 * have none.
 *
 * Cell arrays are copied; OriginalCellId is the input's cell. Point arrays are interpolated along edges. With several
 * offsets, PlaneOffset (double) on cells tells of which a polygon is.
 *
 * Errors: BadParameter (a normal without a length), BadMesh (cells with curved edges, or too many points).
 *
 * @sa vtkDividePolyhedra
 */
#ifndef vtkSlicePolyhedra_h
#define vtkSlicePolyhedra_h

#include "vtkCartesianAlgorithm.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro

#include <vector> // for offsets

class VTKCARTESIANMESHERFILTERS_EXPORT vtkSlicePolyhedra : public vtkCartesianAlgorithm
{
public:
  static vtkSlicePolyhedra* New();
  vtkTypeMacro(vtkSlicePolyhedra, vtkCartesianAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * A point of the plane at offset 0, in the units of the mesh; the origin by default.
   */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  ///@}

  ///@{
  /**
   * Of the planes, of any length but 0; along x by default.
   */
  vtkSetVector3Macro(Normal, double);
  vtkGetVector3Macro(Normal, double);
  ///@}

  ///@{
  /**
   * Distances of the planes from the origin along the normal; one plane at 0 by default.
   */
  void SetNumberOfOffsets(int number) { this->Resize(this->Offsets, number); }
  void SetOffset(int row, double offset) { this->SetRow(this->Offsets, row, offset); }
  ///@}

protected:
  vtkSlicePolyhedra() = default;
  ~vtkSlicePolyhedra() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  double Origin[3] = { 0, 0, 0 };
  double Normal[3] = { 1, 0, 0 };
  std::vector<double> Offsets{ 0 };

  vtkSlicePolyhedra(const vtkSlicePolyhedra&) = delete;
  void operator=(const vtkSlicePolyhedra&) = delete;
};

#endif
