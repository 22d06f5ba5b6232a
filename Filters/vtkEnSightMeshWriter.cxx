// SPDX-License-Identifier: BSD-3-Clause
#include "vtkEnSightMeshWriter.h"

#include "FoamFromVTK.h"
#include "Formats/EnSightFiles.h"

#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkEnSightMeshWriter);

void vtkEnSightMeshWriter::WriteMesh(vtkUnstructuredGrid* grid)
{
  cartesian::Execution execution(0);
  const cartesian::WholeMesh whole = cartesian::wholeMesh(grid, execution);
  if (whole.lostBoundaries)
  {
    vtkWarningMacro(<< cartesian::LostBoundaries);
  }
  this->UpdateProgress(0.5);
  cartesian::writeEnSight(whole.mesh, whole.regions, this->FileName);
}
