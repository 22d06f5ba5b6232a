// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFlatMesh
 * @brief makes a mesh one cell across, for flow in a plane or around an axis
 *
 * Input: a mesh of vtkCartesianMesher, or any vtkUnstructuredGrid of linear cells, whose lower side along an axis is flat: where
 * a box ends, say. Output: a vtkUnstructuredGrid of one polyhedron for each cell that has faces there, swept from
 * these: in a straight line, as flow in a plane needs it, or around an axis, as a wedge. All that the mesh has there
 * stays: boundaries, layers, regions, baffles.
 *
 * Cell arrays are copied from the cell that a face was of, but CellId, which is new; VolumeFraction and global ids are dropped. Field
 * data: RegionNames and RegionsAreZones if there; BoundaryOfFaces, BoundaryIds, BoundaryNames and BoundaryTypes (BoundaryOfFaces.h), of the boundaries
 * that are left, and of two more, front and back, of type empty, or of a wedge, wedge. A side on the axis has no faces.
 *
 * Errors: BadParameter (a value out of its range, faces on both sides of the axis, an axis across the side), BadMesh
 * (cells with curved edges, cells that were changed since the mesh was made).
 *
 * @sa vtkPolyMeshWriter
 */
#ifndef vtkFlatMesh_h
#define vtkFlatMesh_h

#include "vtkCartesianAlgorithm.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro

class VTKCARTESIANMESHERFILTERS_EXPORT vtkFlatMesh : public vtkCartesianAlgorithm
{
public:
  static vtkFlatMesh* New();
  vtkTypeMacro(vtkFlatMesh, vtkCartesianAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The axis (0 x, 1 y, 2 z, the default) that the mesh gets one cell across along, from its lower side.
   */
  vtkSetMacro(Across, int);
  vtkGetMacro(Across, int);
  ///@}

  enum Shapes
  {
    Plane = 0,
    Wedge = 1
  };

  ///@{
  /**
   * Plane (0, the default) or Wedge (1).
   */
  vtkSetMacro(Shape, int);
  vtkGetMacro(Shape, int);
  ///@}

  ///@{
  /**
   * Of a plane mesh, in user units, 0 or more; 0, the default: the mean side of its faces.
   */
  vtkSetMacro(Thickness, double);
  vtkGetMacro(Thickness, double);
  ///@}

  ///@{
  /**
   * The direction of a wedge's axis (0 x, the default, 1 y, 2 z), another than Across, and a point on it. The wedge is as far
   * before as behind the plane through it.
   */
  vtkSetMacro(Axis, int);
  vtkGetMacro(Axis, int);
  vtkSetVector3Macro(AxisOrigin, double);
  vtkGetVector3Macro(AxisOrigin, double);
  ///@}

  ///@{
  /**
   * Between a wedge's front and back, in degrees: more than 0, less than 90. Default: 5.
   */
  vtkSetMacro(WedgeAngle, double);
  vtkGetMacro(WedgeAngle, double);
  ///@}

protected:
  vtkFlatMesh() = default;
  ~vtkFlatMesh() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  int Across = 2;
  int Shape = Plane;
  double Thickness = 0;
  int Axis = 0;
  double AxisOrigin[3] = { 0, 0, 0 };
  double WedgeAngle = 5;

  vtkFlatMesh(const vtkFlatMesh&) = delete;
  void operator=(const vtkFlatMesh&) = delete;
};

#endif
