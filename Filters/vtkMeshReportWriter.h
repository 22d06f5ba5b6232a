// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeshReportWriter
 * @brief writes a report of a mesh: one HTML file
 *
 * Input: any unstructured grid of linear cells, best that of vtkCartesianMesher. The file has the verdict of
 * vtkMeshSummary, pictures of the boundary, of a cut and of the failing (or worst) cells, the tables of boundaries and
 * of worst values, histograms of skewness, non-orthogonality, VolumeFraction and heights of first layers (those that
 * the mesh has arrays of), the properties of the filters in front of this writer that differ from their defaults, and
 * their warnings. It needs no other file. Pictures are drawn in memory: no screen is needed. The same mesh gives the
 * same file.
 *
 * @sa vtkMeshSummary vtkFiniteVolumeQuality
 */
#ifndef vtkMeshReportWriter_h
#define vtkMeshReportWriter_h

#include "vtkWholeMeshWriter.h"

class VTKCARTESIANMESHERFILTERS_EXPORT vtkMeshReportWriter : public vtkWholeMeshWriter
{
public:
  static vtkMeshReportWriter* New();
  vtkTypeMacro(vtkMeshReportWriter, vtkWholeMeshWriter);

protected:
  vtkMeshReportWriter() = default;
  ~vtkMeshReportWriter() override = default;

  void WriteGrid(vtkUnstructuredGrid* grid) override;

private:
  vtkMeshReportWriter(const vtkMeshReportWriter&) = delete;
  void operator=(const vtkMeshReportWriter&) = delete;
};

#endif
