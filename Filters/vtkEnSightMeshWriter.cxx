// SPDX-License-Identifier: BSD-3-Clause
#include "vtkEnSightMeshWriter.h"

#include "FoamFromVTK.h"
#include "Formats/EnSightFiles.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkEnSightMeshWriter);

void vtkEnSightMeshWriter::WriteMesh(cartesian::WholeMesh& whole)
{
  cartesian::writeEnSight(whole.mesh, whole.regions, this->FileName);
}
