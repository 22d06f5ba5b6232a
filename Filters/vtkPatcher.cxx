// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatcher.h"

#include "Base/Error.h"
#include "BoundaryNames.h"
#include "BoxesVTK.h"
#include "FieldData.h"
#include "FilterOptions.h"
#include "Mesher/Mesher.h"
#include "PatchesVTK.h"
#include "SurfaceFromVTK.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

namespace
{

[[noreturn]] void throwMisplaced()
{
  throw cartesian::Error(cartesian::Fault::MissingArray,
    "The surface does not lie in the boxes: connect the surface that the boxes were made for.");
}

// Levels of the lattice are no more than 32 bits hold.
void checkPlace(const cartesian::Bounds& surface, const cartesian::Lattice& lattice)
{
  constexpr auto Last = static_cast<cartesian::Level>(cartesian::LevelsOfTheDomain);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (surface.low[axis] < lattice.position(axis, 0) ||
      surface.high[axis] > lattice.position(axis, Last))
    {
      throwMisplaced();
    }
  }
}

}

vtkStandardNewMacro(vtkPatcher);

vtkPatcher::vtkPatcher()
{
  this->SetNumberOfInputPorts(2);
}

int vtkPatcher::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    AcceptAnything(info);
  }
  else
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  }
  return 1;
}

int vtkPatcher::FillOutputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

int vtkPatcher::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  if (IsLeftToFirstProcess(request, output))
  {
    return 1;
  }
  this->Run(0, 1, [&](cartesian::Execution& execution) {
    execution.stage("Shoeboxes", 0, cartesian::AfterBoxes);
    cartesian::SurfaceFromVTK source(vtkDataObject::GetData(input[0]), this->BoundaryArray);
    source.leaveOutOpenBodies({}); // as the boxes
    const cartesian::Boxes boxes = cartesian::boxesFromVTK(vtkUnstructuredGrid::GetData(input[1]));
    checkPlace(cartesian::boundsOf(source.view()), boxes.lattice);
    cartesian::Surface surface = cartesian::onLattice(source.view(), boxes.lattice, execution);
    cartesian::repair(surface, boxes.planes, {}, execution);
    const cartesian::Shoeboxes shoeboxes =
      cartesian::fillShoeboxes(surface, boxes.planes, execution);
    execution.stage("Patches", cartesian::AfterBoxes, 1);
    cartesian::Options options;
    cartesian::setPatchOptions(this, options);
    const cartesian::Patches patches =
      cartesian::generatePatches(surface, boxes, shoeboxes, options.patches, execution);
    if (patches.size() == 0)
    {
      throwMisplaced();
    }
    cartesian::toVTK(
      patches, boxes, cartesian::cellsOf(surface, source.cells()), vtkPolyData::GetData(output));
    cartesian::setBoundaryNames(vtkDataObject::GetData(output), source.names());
    cartesian::setField(
      vtkDataObject::GetData(output), cartesian::FeatureAngleField, { this->FeatureAngle });
    cartesian::setField(
      vtkDataObject::GetData(output), cartesian::SurfaceVolumeField, { patches.surfaceVolume });
  });
  return 1;
}

void vtkPatcher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "BoundaryArray: " << this->BoundaryArray << "\n";
  cartesian::printPatchProperties(this, os, indent);
}
