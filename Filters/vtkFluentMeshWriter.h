// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFluentMeshWriter
 * @brief writes an unstructured grid as a Fluent mesh (.msh) of polyhedra with named boundaries
 *
 * Input, several processes and errors: see vtkWholeMeshWriter. The format is the ASCII one of the appendix "Mesh File
 * Format" of ANSYS Fluent's user's guide. Each region is a cell zone, each boundary a face zone with its name, of
 * type wall, symmetry, velocity-inlet or pressure-outlet, by its type or, without one, by its name. Coordinates are
 * written without loss.
 *
 * @sa vtkPolyMeshWriter vtkCGNSMeshWriter
 */
#ifndef vtkFluentMeshWriter_h
#define vtkFluentMeshWriter_h

#include "vtkWholeMeshWriter.h"

class VTKCARTESIANMESHERFILTERS_EXPORT vtkFluentMeshWriter : public vtkWholeMeshWriter
{
public:
  static vtkFluentMeshWriter* New();
  vtkTypeMacro(vtkFluentMeshWriter, vtkWholeMeshWriter);

protected:
  vtkFluentMeshWriter() = default;
  ~vtkFluentMeshWriter() override = default;

  void WriteMesh(cartesian::WholeMesh& whole) override;

private:
  vtkFluentMeshWriter(const vtkFluentMeshWriter&) = delete;
  void operator=(const vtkFluentMeshWriter&) = delete;
};

#endif
