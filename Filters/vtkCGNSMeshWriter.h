// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCGNSMeshWriter
 * @brief writes an unstructured grid as a CGNS file of polyhedra with named boundaries
 *
 * Input, several processes and errors: see vtkWholeMeshWriter. The file has one base, Base. Each region is a zone
 * (without regions: one zone called Zone) with the sections Faces (NGON_n) and Cells (NFACE_n). Each boundary is a
 * family with its name and a FamilyBC of type BCWall, BCSymmetryPlane, BCInflow, BCOutflow or BCGeneral, by its type
 * or, without one, by its name; the zones' boundary conditions of that name are FamilySpecified, on FaceCenter.
 * Regions are connected face by face (Abutting1to1).
 *
 * @sa vtkPolyMeshWriter
 */
#ifndef vtkCGNSMeshWriter_h
#define vtkCGNSMeshWriter_h

#include "vtkWholeMeshWriter.h"

class VTKCARTESIANMESHERFILTERS_EXPORT vtkCGNSMeshWriter : public vtkWholeMeshWriter
{
public:
  static vtkCGNSMeshWriter* New();
  vtkTypeMacro(vtkCGNSMeshWriter, vtkWholeMeshWriter);

protected:
  vtkCGNSMeshWriter() = default;
  ~vtkCGNSMeshWriter() override = default;

  void WriteMesh(cartesian::WholeMesh& whole) override;

private:
  vtkCGNSMeshWriter(const vtkCGNSMeshWriter&) = delete;
  void operator=(const vtkCGNSMeshWriter&) = delete;
};

#endif
