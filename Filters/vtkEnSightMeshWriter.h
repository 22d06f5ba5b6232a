// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkEnSightMeshWriter
 * @brief writes an unstructured grid as EnSight Gold files of polyhedra with named boundaries
 *
 * Input, several processes and errors: see vtkWholeMeshWriter. The format is the binary one of the chapter "EnSight
 * Gold Case File Format" of EnSight's user manual: the named .case file, and the geometry beside it, .geo. Each
 * region is a part of polyhedra (nfaced), each boundary a part of polygons (nsided) with its name. Points have the
 * same ids in all parts. Coordinates have 32 bits, as in all files of that format.
 *
 * @sa vtkPolyMeshWriter vtkCGNSMeshWriter
 */
#ifndef vtkEnSightMeshWriter_h
#define vtkEnSightMeshWriter_h

#include "vtkWholeMeshWriter.h"

class VTKCARTESIANMESHERFILTERS_EXPORT vtkEnSightMeshWriter : public vtkWholeMeshWriter
{
public:
  static vtkEnSightMeshWriter* New();
  vtkTypeMacro(vtkEnSightMeshWriter, vtkWholeMeshWriter);

protected:
  vtkEnSightMeshWriter() = default;
  ~vtkEnSightMeshWriter() override = default;

  void WriteMesh(cartesian::WholeMesh& whole) override;

private:
  vtkEnSightMeshWriter(const vtkEnSightMeshWriter&) = delete;
  void operator=(const vtkEnSightMeshWriter&) = delete;
};

#endif
