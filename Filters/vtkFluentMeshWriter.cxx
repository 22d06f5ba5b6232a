// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFluentMeshWriter.h"

#include "FoamFromVTK.h"
#include "Formats/FluentFile.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkFluentMeshWriter);

void vtkFluentMeshWriter::WriteMesh(cartesian::WholeMesh& whole)
{
  cartesian::writeFluent(whole.mesh, whole.regions, this->FileName);
}
