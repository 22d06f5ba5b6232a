// SPDX-License-Identifier: BSD-3-Clause
#include "Window.h"

#include "vtkCommand.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSMOutputPort.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyManager.h"
#include "vtkSMProxyProperty.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMUndoStackBuilder.h"

namespace cartesian
{

namespace
{

constexpr const char* Hidden = "HiddenRepresentations";
constexpr const char* Sources = "ActiveSources";
constexpr const char* Views = "ActiveView";

vtkSMProxy* selected(vtkSMSessionProxyManager* proxies, const char* kind)
{
  vtkSMProxySelectionModel* model = proxies->GetSelectionModel(kind);
  return model ? model->GetCurrentProxy() : nullptr;
}

}

vtkSMProxy* selectedSource(vtkSMSessionProxyManager* proxies)
{
  vtkSMProxy* current = selected(proxies, Sources);
  auto* port = vtkSMOutputPort::SafeDownCast(current);
  return port ? port->GetSourceProxy() : current;
}

vtkSMProxy* activeView(vtkSMSessionProxyManager* proxies)
{
  return selected(proxies, Views);
}

vtkSMRenderViewProxy* activeWindow(vtkSMSessionProxyManager* proxies)
{
  auto* view = vtkSMRenderViewProxy::SafeDownCast(activeView(proxies));
  vtkRenderWindowInteractor* interactor = view ? view->GetInteractor() : nullptr;
  return interactor && interactor->IsA("QVTKInteractor") ? view : nullptr;
}

void observeSelections(vtkSMSessionProxyManager* proxies, vtkCommand* command)
{
  for (const char* kind : { Sources, Views })
  {
    if (vtkSMProxySelectionModel* model = proxies->GetSelectionModel(kind))
    {
      model->AddObserver(vtkCommand::CurrentChangedEvent, command);
    }
  }
}

void addHidden(vtkSMProxy* representation, vtkSMRenderViewProxy* view)
{
  representation->UpdateVTKObjects();
  vtkSMPropertyHelper(view, Hidden).Add(representation);
  view->UpdateVTKObjects();
}

void removeHidden(vtkSMProxy* representation, vtkSMRenderViewProxy* view)
{
  vtkSMPropertyHelper(view, Hidden).Remove(representation);
  view->UpdateVTKObjects();
}

void setPaletteColour(vtkSMProxy* proxy, const char* property, const char* colour)
{
  vtkSMProxy* palette = proxy->GetSessionProxyManager()->GetProxy("settings", "ColorPalette");
  if (palette && palette->GetProperty(colour))
  {
    vtkSMPropertyHelper(proxy, property, true)
      .Set(vtkSMPropertyHelper(palette, colour).GetDoubleArray().data(), 3);
  }
}

WithoutUndo::WithoutUndo()
  : builder_(vtkSMProxyManager::GetProxyManager()->GetUndoStackBuilder())
  , before_(builder_ && builder_->GetIgnoreAllChanges())
{
  if (builder_)
  {
    builder_->SetIgnoreAllChanges(true);
  }
}

WithoutUndo::~WithoutUndo()
{
  if (builder_)
  {
    builder_->SetIgnoreAllChanges(before_);
  }
}

}
