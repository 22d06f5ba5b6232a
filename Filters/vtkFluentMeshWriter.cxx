// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFluentMeshWriter.h"

#include "FoamFromVTK.h"
#include "Formats/FluentFile.h"
#include "OpenFoam/CyclicFaces.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkFluentMeshWriter);

void vtkFluentMeshWriter::WriteMesh(cartesian::WholeMesh& whole)
{
  cartesian::orderCyclicFaces(whole.mesh);
  std::string changes;
  for (const cartesian::ChangedName& name :
    cartesian::writeFluent(whole.mesh, whole.regions, this->FileName))
  {
    changes += (changes.empty() ? "" : ", ") + name.given + " is " + name.written;
  }
  if (!changes.empty())
  {
    vtkWarningMacro("Fluent allows only letters of ASCII, digits, -, . and _ in names, each once: "
      << changes << ". To choose them yourself, use Boundary Merged Names.");
  }
}
