// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRefinementRegion
 * @brief a box, a sphere or a surface in which Cartesian Mesher refines
 *
 * Output: the closed surface of the shape (vtkPolyData), with the depth as field data RegionDepth
 * (int, one number), for input port 1 of vtkCartesianMesher and vtkCartesianBoxer. Section 4.6 of
 * the paper has blocks of global boxes only.
 *
 * Input, optional, is the shape or ignored: ParaView takes the initial size of a box or a sphere from it.
 *
 * Errors: BadParameter (a length or a radius that is not positive, no surface as input).
 *
 * @sa vtkCartesianBoxer vtkCartesianMesher
 */
#ifndef vtkRefinementRegion_h
#define vtkRefinementRegion_h

#include "vtkCartesianMesherFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

class VTKCARTESIANMESHERFILTERS_EXPORT vtkRefinementRegion : public vtkPolyDataAlgorithm
{
public:
  static vtkRefinementRegion* New();
  vtkTypeMacro(vtkRefinementRegion, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What the refinement zone is.
   */
  enum Shapes
  {
    Box = 0,
    Sphere = 1,
    Input = 2 ///< the input, a closed surface (vtkPolyData, or blocks of them)
  };

  ///@{
  /**
   * Box, the default, Sphere, or Input.
   */
  vtkSetClampMacro(Shape, int, Box, Input);
  vtkGetMacro(Shape, int);
  void SetShapeToBox() { this->SetShape(Box); }
  void SetShapeToSphere() { this->SetShape(Sphere); }
  void SetShapeToInput() { this->SetShape(Input); }
  ///@}

  ///@{
  /**
   * Of a box: the corner that it is rotated about, the rotations about the axes in degrees (z first, then x, then y,
   * as in ParaView's box widget), the lengths of its sides. Default: the unit cube.
   */
  vtkSetVector3Macro(Position, double);
  vtkGetVector3Macro(Position, double);
  vtkSetVector3Macro(Rotation, double);
  vtkGetVector3Macro(Rotation, double);
  vtkSetVector3Macro(Length, double);
  vtkGetVector3Macro(Length, double);
  ///@}

  ///@{
  /**
   * Of a sphere. Default: centre 0, radius 0.5.
   */
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Refinement level of boxes in or at the region: 0 to 12, default 1.
   */
  vtkSetClampMacro(Depth, int, 0, 6);
  vtkGetMacro(Depth, int);
  ///@}

protected:
  vtkRefinementRegion() = default;
  ~vtkRefinementRegion() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  int Shape = Box;
  double Position[3] = { 0, 0, 0 };
  double Rotation[3] = { 0, 0, 0 };
  double Length[3] = { 1, 1, 1 };
  double Center[3] = { 0, 0, 0 };
  double Radius = 0.5;
  int Depth = 1;

private:
  vtkRefinementRegion(const vtkRefinementRegion&) = delete;
  void operator=(const vtkRefinementRegion&) = delete;

  void MakeBox(vtkPolyData* output);
  void MakeSphere(vtkPolyData* output);
};

#endif
