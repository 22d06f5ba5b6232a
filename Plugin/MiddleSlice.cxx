// SPDX-License-Identifier: BSD-3-Clause
#include "MiddleSlice.h"

#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSmartPointer.h"

namespace cartesian
{

namespace
{

constexpr double ShadeOfEdges = 0.25;

}

void showMiddleSlice(vtkSMSourceProxy* mesher, vtkSMRenderViewProxy* view,
  const std::array<double, 3>& place, const std::array<double, 3>& normal)
{
  vtkSMSessionProxyManager* const proxies = mesher->GetSessionProxyManager();
  vtkSmartPointer<vtkSMProxy> made;
  made.TakeReference(proxies->NewProxy("filters", "SlicePolyhedra"));
  auto* const slice = vtkSMSourceProxy::SafeDownCast(made);
  vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
  controller->PreInitializeProxy(slice);
  vtkSMPropertyHelper(slice, "Input").Set(mesher);
  controller->PostInitializeProxy(slice);
  vtkSMPropertyHelper(slice, "Origin").Set(place.data(), 3);
  vtkSMPropertyHelper(slice, "Normal").Set(normal.data(), 3);
  slice->UpdateVTKObjects();
  // Not by the controller, which would select it: the panel stays the mesher's.
  proxies->RegisterProxy(
    "sources", proxies->GetUniqueProxyName("sources", "MiddleSlice", false).c_str(), slice);
  vtkSMProxy* const representation = controller->Show(slice, 0, view);
  vtkSMPropertyHelper(representation, "ColorArrayName", true)
    .SetInputArrayToProcess(vtkDataObject::CELL, "");
  const std::array<double, 3> edges{ ShadeOfEdges, ShadeOfEdges, ShadeOfEdges };
  vtkSMPropertyHelper(representation, "EdgeColor", true).Set(edges.data(), 3);
  representation->UpdateVTKObjects();
}

}
