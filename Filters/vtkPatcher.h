// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPatcher
 * @brief cuts a surface into patches (the boundary faces of a mesh), each in one box
 *
 * Inputs: port 0 a closed surface (vtkPolyData), port 1 the boxes of vtkCartesianBoxer
 * (vtkUnstructuredGrid). Output: the patches (vtkPolyData), a watertight surface.
 *
 * Cell arrays of the output: BoundaryId (int: the boundary that a patch belongs to), BoxId (its box's cell in the
 * grid of boxes), SurfaceCell (the cell of the surface that it is part of, or closest to), PatchReason (unsigned
 * char: the method of its box: 0 Marching Cubes; Exact Fit because 1 an edge of the box is crossed more than once, 2
 * the surface meets a side in a closed polyline, 3 a sharp feature passes through or the surface turns within the box
 * by more than twice Feature Angle, 4 there are several boundaries, 5 the surface in the box is not a set of discs, 6
 * of Patch Method), EnclosedVolume (double: of the connected piece of the surface that it belongs to; Cell Assembler
 * uses it to tell small bodies from fragments that the grid cuts off), VolumeGap (double: how far the patches of its
 * box would have to move outwards to enclose the surface's volume there; Cell Assembler moves them). Point array:
 * PointKind (unsigned char: 1 on the surface, 2 on a sharp edge or a border between boundaries, 3 a corner). Field data, for
 * vtkCellAssembler: FeatureAngle (double), SurfaceVolume (double: the part of the domain that the surface encloses;
 * 0: not known). Sections 4.7, 4.8 and A2 of the paper.
 *
 * Errors: EmptySurface, BadCoordinate, MissingArray (no Boundary Array of that name, or boxes that
 * Cartesian Boxer did not make, or not for this surface), BadParameter (an angle).
 *
 * @sa vtkCartesianBoxer vtkCellAssembler vtkCartesianMesher
 */
#ifndef vtkPatcher_h
#define vtkPatcher_h

#include "vtkCartesianAlgorithm.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro
#include "vtkCartesianProperties.h"          // for vtkPatchPropertiesMacro

#include <string> // for std::string

class VTKCARTESIANMESHERFILTERS_EXPORT vtkPatcher : public vtkCartesianAlgorithm
{
public:
  static vtkPatcher* New();
  vtkTypeMacro(vtkPatcher, vtkCartesianAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkPatchPropertiesMacro();

public:
  ///@{
  /**
   * Cell array of the surface that numbers its boundaries. Empty, the default: the one that a reader made for the
   * named solids of an STL file, if any, else one boundary.
   */
  vtkSetMacro(BoundaryArray, std::string);
  vtkGetMacro(BoundaryArray, std::string);
  ///@}

protected:
  vtkPatcher();
  ~vtkPatcher() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  std::string BoundaryArray;

private:
  vtkPatcher(const vtkPatcher&) = delete;
  void operator=(const vtkPatcher&) = delete;
};

#endif
