// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryPatches.h"

#include "PanelValues.h"
#include "Window.h"

#include "vtkPVXMLElement.h"
#include "vtkRenderer.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"

#include <algorithm>
#include <array>

namespace cartesian
{

namespace
{

// Where a pixel is at the near or far end of what is seen.
std::array<double, 3> pointAt(vtkRenderer* renderer, int x, int y, double depth)
{
  std::array<double, 4> point{};
  renderer->SetDisplayPoint(x, y, depth);
  renderer->DisplayToWorld();
  renderer->GetWorldPoint(point.data());
  return { point[0] / point[3], point[1] / point[3], point[2] / point[3] };
}

}

BoundaryPatches::BoundaryPatches(vtkSMProxy* source, vtkPVXMLElement* hint)
  : source_(source)
{
  const WithoutUndo withoutUndo;
  vtkSmartPointer<vtkSMProxy> proxy;
  proxy.TakeReference(source->GetSessionProxyManager()->NewProxy(
    hint->GetAttribute("group"), hint->GetAttribute("name")));
  proxy->SetLocation(source->GetLocation());
  patches_ = vtkSMSourceProxy::SafeDownCast(proxy);
}

BoundaryPatches::~BoundaryPatches()
{
  this->hide();
}

bool BoundaryPatches::dependOn(const char* property) const
{
  return patches_->GetProperty(property) != nullptr;
}

std::vector<PatchOfSurface> BoundaryPatches::list()
{
  const WithoutUndo withoutUndo;
  takeFromPanel(source_, patches_);
  if (!vtkSMPropertyHelper(patches_, "Input").GetAsProxy())
  {
    return {};
  }
  patches_->UpdateVTKObjects();
  patches_->UpdatePipeline();
  patches_->UpdatePropertyInformation(patches_->GetProperty("List"));
  const vtkSMPropertyHelper texts(patches_, "List");
  std::vector<PatchOfSurface> list;
  for (unsigned int i = 0; i + 2 < texts.GetNumberOfElements(); i += 3)
  {
    list.push_back({ texts.GetAsString(i), texts.GetAsString(i + 1), texts.GetAsString(i + 2) });
  }
  return list;
}

void BoundaryPatches::light(const std::vector<std::string>& names, vtkSMRenderViewProxy* view)
{
  const WithoutUndo withoutUndo;
  const vtkSmartPointer<vtkSMRenderViewProxy> before = view_.GetPointer();
  if (before && (before != view || names.empty()))
  {
    this->hide();
    before->StillRender();
  }
  vtkSMPropertyHelper shown(patches_, "Shown");
  shown.SetNumberOfElements(static_cast<unsigned int>(names.size()));
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    shown.Set(static_cast<unsigned int>(i), names[i].c_str());
  }
  patches_->UpdateVTKObjects();
  if (view && !names.empty())
  {
    patches_->UpdatePipeline();
    this->show(view);
    static_cast<vtkSMProxy*>(view)->MarkDirty(nullptr);
    view->StillRender();
  }
}

void BoundaryPatches::show(vtkSMRenderViewProxy* view)
{
  if (representation_)
  {
    return;
  }
  representation_.TakeReference(
    view->GetSessionProxyManager()->NewProxy("representations", "GeometryRepresentation"));
  vtkSMPropertyHelper(representation_, "Input").Set(patches_);
  vtkSMPropertyHelper(representation_, "Pickable", true).Set(0);
  setPaletteColour(representation_, "AmbientColor", "SelectionColor");
  setPaletteColour(representation_, "DiffuseColor", "SelectionColor");
  addHidden(representation_, view);
  view_ = view;
}

void BoundaryPatches::hide()
{
  if (view_ && representation_)
  {
    removeHidden(representation_, view_);
  }
  representation_ = nullptr;
  view_ = nullptr;
}

std::string BoundaryPatches::at(vtkSMRenderViewProxy* view, int x, int y)
{
  const WithoutUndo withoutUndo;
  const std::array<double, 3> near = pointAt(view->GetRenderer(), x, y, 0);
  const std::array<double, 3> far = pointAt(view->GetRenderer(), x, y, 1);
  const std::array<double, 6> way{ near[0], near[1], near[2], far[0], far[1], far[2] };
  vtkSMPropertyHelper(patches_, "Way").Set(way.data(), 6);
  patches_->UpdateVTKObjects();
  patches_->UpdatePropertyInformation(patches_->GetProperty("BoundaryOnWay"));
  return vtkSMPropertyHelper(patches_, "BoundaryOnWay").GetAsString();
}

}
