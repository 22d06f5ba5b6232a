// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCGNSMeshWriter.h"

#include "CgnsFile.h"
#include "FoamFromVTK.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkCGNSMeshWriter);

void vtkCGNSMeshWriter::WriteMesh(cartesian::WholeMesh& whole)
{
  for (const cartesian::FoamPatch& patch : whole.mesh.patches)
  {
    if (patch.pair > 0)
    {
      vtkWarningMacro("The periodic boundaries \""
        << patch.name << "\" and \"" << patch.partner
        << "\" are ordinary ones in a CGNS file: make them a pair in the solver.");
    }
  }
  std::vector<cartesian::CgnsZone> zones;
  const cartesian::FoamZoning zoning = cartesian::separateMeshes(whole.regions);
  for (std::uint32_t region = 0; region < whole.regions.names.size(); ++region)
  {
    zones.push_back({ whole.regions.names[region],
      cartesian::meshOfRegion(whole.mesh, whole.regions, zoning, region) });
  }
  if (zones.empty())
  {
    zones.push_back({ "Zone", std::move(whole.mesh) });
  }
  cartesian::writeCgns(zones, this->FileName);
}
