// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPatcher
 * @brief cuts a surface into patches, each of which lies in one box
 *
 * Inputs: port 0 a closed surface (vtkPolyData), port 1 the boxes of vtkCartesianBoxer
 * (vtkUnstructuredGrid). Output: the patches (vtkPolyData), a watertight surface.
 *
 * Cell arrays of the output: BoundaryId (int: the boundary that a patch belongs to), BoxId (its
 * box's cell in the grid of boxes), SurfaceCell (the cell of the surface that it is a part of).
 * Section 4.7 of the paper.
 *
 * Errors: EmptySurface, BadCoordinate, MissingArray (no Boundary Array of that name, or boxes that
 * Cartesian Boxer did not make, or not for this surface).
 *
 * @sa vtkCartesianBoxer vtkCellAssembler vtkCartesianMesher
 */
#ifndef vtkPatcher_h
#define vtkPatcher_h

#include "vtkCartesianAlgorithm.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro

#include <string> // for std::string

class VTKCARTESIANMESHERFILTERS_EXPORT vtkPatcher : public vtkCartesianAlgorithm
{
public:
  static vtkPatcher* New();
  vtkTypeMacro(vtkPatcher, vtkCartesianAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How patches are made.
   */
  enum PatchMethods
  {
    ExactFit = 0 ///< the surface itself, cut at the sides of the boxes
  };

  ///@{
  /**
   * Cell array of the surface that numbers its boundaries. Empty, the default: the one that a
   * reader made for the solids that an STL file names, if there is one, else one boundary.
   */
  vtkSetMacro(BoundaryArray, std::string);
  vtkGetMacro(BoundaryArray, std::string);
  ///@}

  ///@{
  /**
   * How patches are made; ExactFit, the default, is the only method so far.
   */
  vtkSetClampMacro(PatchMethod, int, ExactFit, ExactFit);
  vtkGetMacro(PatchMethod, int);
  ///@}

protected:
  vtkPatcher();
  ~vtkPatcher() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  std::string BoundaryArray;
  int PatchMethod = ExactFit;

private:
  vtkPatcher(const vtkPatcher&) = delete;
  void operator=(const vtkPatcher&) = delete;
};

#endif
