// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPeriodicBoundaries
 * @brief gives two boundaries of a mesh the same faces, for periodic flow
 *
 * Input: a mesh of vtkCartesianMesher or vtkFlatMesh. Output: the same mesh, whose boundaries First and Second are a periodic pair: of
 * type cyclic, where each face of one has one of the other with corners in the same places, moved or turned; or of type
 * cyclicAMI, with faces of their own and the same area. For several pairs, place several of these filters behind each other.
 *
 * One boundary is the other moved, or turned around an axis. To have the same faces, both must be flat: faces are then divided where
 * the other side has edges. The outline of the second moves onto that of the first, and points near it with it; others move along the
 * side to those of the first, by a quarter of the distance to the next at most. Cells behind get the same points on their edges. The
 * whole mesh must be on one rank.
 *
 * All arrays stay but those of points. Field data: BoundaryOfFaces, BoundaryIds, BoundaryNames and BoundaryTypes as they are now; and
 * PeriodicPairs (double, 12 components): the ids of both boundaries; then how the first comes to lie on the second: translation (3),
 * direction of an axis (3), a point on it (3), degrees.
 *
 * Errors: BadParameter (no such boundary, twice the same, an axis of length 0), BadMesh (of the same faces: the first side is not flat, the sides
 * are not the same; cells were changed since the mesh was made).
 *
 * @sa vtkPolyMeshWriter
 */
#ifndef vtkPeriodicBoundaries_h
#define vtkPeriodicBoundaries_h

#include "vtkCartesianAlgorithm.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro

#include <string> // for std::string

class VTKCARTESIANMESHERFILTERS_EXPORT vtkPeriodicBoundaries : public vtkCartesianAlgorithm
{
public:
  static vtkPeriodicBoundaries* New();
  vtkTypeMacro(vtkPeriodicBoundaries, vtkCartesianAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The names of the boundaries. Points of the first stay where they are.
   */
  vtkSetMacro(FirstBoundary, std::string);
  vtkGetMacro(FirstBoundary, std::string);
  vtkSetMacro(SecondBoundary, std::string);
  vtkGetMacro(SecondBoundary, std::string);
  ///@}

  enum Motions
  {
    Translation = 0,
    Rotation = 1
  };

  ///@{
  /**
   * How the first comes to lie on the second: Translation (0, the default), or Rotation (1) around an axis. How far is found
   * from where they are.
   */
  vtkSetMacro(Motion, int);
  vtkGetMacro(Motion, int);
  ///@}

  ///@{
  /**
   * The axis of a rotation: its direction, of any length above 0 (default: z), and a point on it.
   */
  vtkSetVector3Macro(Axis, double);
  vtkGetVector3Macro(Axis, double);
  vtkSetVector3Macro(AxisOrigin, double);
  vtkGetVector3Macro(AxisOrigin, double);
  ///@}

  enum FacesOfPairs
  {
    Same = 0,
    Own = 1
  };

  ///@{
  /**
   * Same (0, the default): of type cyclic; Own (1): of type cyclicAMI, with the faces that each has; only the
   * outline of the second moves onto that of the first, so that their areas are the same.
   */
  vtkSetMacro(Faces, int);
  vtkGetMacro(Faces, int);
  ///@}

protected:
  vtkPeriodicBoundaries() = default;
  ~vtkPeriodicBoundaries() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  std::string FirstBoundary;
  std::string SecondBoundary;
  int Motion = Translation;
  double Axis[3] = { 0, 0, 1 };
  double AxisOrigin[3] = { 0, 0, 0 };
  int Faces = Same;

  vtkPeriodicBoundaries(const vtkPeriodicBoundaries&) = delete;
  void operator=(const vtkPeriodicBoundaries&) = delete;
};

#endif
