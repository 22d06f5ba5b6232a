// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFluentMeshWriter.h"

#include "FoamFromVTK.h"
#include "Formats/FluentFile.h"

#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkFluentMeshWriter);

void vtkFluentMeshWriter::WriteMesh(vtkUnstructuredGrid* grid)
{
  cartesian::Execution execution(0);
  const cartesian::WholeMesh whole = cartesian::wholeMesh(grid, execution);
  if (whole.lostBoundaries)
  {
    vtkWarningMacro(<< cartesian::LostBoundaries);
  }
  this->UpdateProgress(0.5);
  cartesian::writeFluent(whole.mesh, whole.regions, this->FileName);
}
