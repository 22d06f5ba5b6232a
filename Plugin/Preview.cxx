// SPDX-License-Identifier: BSD-3-Clause
#include "Preview.h"

#include "PanelValues.h"
#include "PreviewScene.h"
#include "Registration.h"
#include "Window.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPVXMLElement.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <memory>
#include <string>

namespace cartesian
{

namespace
{

// Of one source.
class Look : public vtkCommand
{
public:
  static Look* New() { return new Look; }

  void Begin(vtkSMProxy* source, vtkPVXMLElement* hint)
  {
    this->Source = source;
    this->Group = hint->GetAttribute("group");
    this->Name = hint->GetAttribute("name");
    forEachProperty(source, [this](const char* /*name*/, vtkSMProperty* changing) {
      changing->AddObserver(vtkCommand::UncheckedPropertyModifiedEvent, this);
    });
    source->AddObserver(vtkCommand::UpdateEvent, this);
    source->AddObserver(vtkCommand::UpdateDataEvent, this);
    observeSelections(source->GetSessionProxyManager(), this);
    this->Sent.note(source);
    this->IsApplied = source->GetSessionProxyManager()->GetInLoadXMLState();
  }

  void Execute(vtkObject* caller, unsigned long event, void* /*data*/) override
  {
    if (event == vtkCommand::UpdateEvent)
    {
      this->Sent.note(this->Source);
    }
    if (event == vtkCommand::UncheckedPropertyModifiedEvent && this->Source &&
      !this->Sent.areAll(this->Source))
    {
      return;
    }
    this->IsApplied = this->IsApplied || event == vtkCommand::UpdateDataEvent;
    const WithoutUndo withoutUndo;
    this->Update(
      event != vtkCommand::UpdateEvent); // sources that are applied later may be above this one
    if (!this->Source && event == vtkCommand::CurrentChangedEvent)
    {
      caller->RemoveObserver(this); // the source was deleted
    }
  }

private:
  bool IsWanted(vtkSMSessionProxyManager* proxies)
  {
    vtkSMPropertyHelper preview(this->Source, "Preview");
    preview.SetUseUnchecked(true);
    return preview.GetAsInt() != 0 && !proxies->GetInLoadXMLState() &&
      selectedSource(proxies) == this->Source && this->Source->GetObjectsCreated() &&
      (!this->IsApplied || textOf(this->Source, true) != textOf(this->Source, false));
  }

  void Update(bool draws)
  {
    vtkSMSessionProxyManager* proxies =
      this->Source ? this->Source->GetSessionProxyManager() : nullptr;
    vtkSMRenderViewProxy* view =
      proxies && this->IsWanted(proxies) ? activeWindow(proxies) : nullptr;
    if (this->Scene && this->Scene->view() != view)
    {
      const vtkSmartPointer<vtkSMRenderViewProxy> before = this->Scene->view();
      this->Scene.reset();
      if (before && draws)
      {
        before->StillRender();
      }
    }
    if (!view || !draws)
    {
      return;
    }
    const std::string typed = textOf(this->Source, true);
    if (this->Scene && typed == this->Shown)
    {
      return;
    }
    if (!this->Scene)
    {
      vtkSmartPointer<vtkSMProxy> preview;
      preview.TakeReference(proxies->NewProxy(this->Group.c_str(), this->Name.c_str()));
      preview->SetLocation(this->Source->GetLocation());
      takeFromPanel(this->Source, preview);
      preview->UpdateVTKObjects();
      this->Scene =
        std::make_unique<PreviewScene>(vtkSMSourceProxy::SafeDownCast(preview), this->Source, view);
    }
    this->Shown = typed;
    takeFromPanel(this->Source, this->Scene->preview());
    this->Scene->preview()->UpdateVTKObjects();
    this->Scene->draw();
  }

  vtkWeakPointer<vtkSMProxy> Source;
  std::string Group; // of the proxy that makes the preview
  std::string Name;
  SentValues Sent;
  std::string Shown; // the values of the preview
  bool IsApplied = false;
  std::unique_ptr<PreviewScene> Scene;
};

void showPreviewOf(vtkSMProxy* source, const std::string& group)
{
  vtkPVXMLElement* hints = source->GetHints();
  vtkPVXMLElement* hint = hints ? hints->FindNestedElementByName("Preview") : nullptr;
  if (hint && group == "sources")
  {
    vtkNew<Look> look;
    look->Begin(source, hint);
  }
}

}

void showPreviews()
{
  onRegistered<showPreviewOf>();
}

}
