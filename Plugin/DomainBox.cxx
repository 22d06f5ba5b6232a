// SPDX-License-Identifier: BSD-3-Clause
#include "DomainBox.h"

#include "PanelValues.h"
#include "Registration.h"
#include "Window.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPVXMLElement.h"
#include "vtkSMDoubleVectorProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <string>
#include <vector>

namespace cartesian
{

namespace
{

constexpr int Outside = 1;    // of Domain
constexpr int FromBounds = 1; // of BoxFrom

using Values = std::vector<double>;

const Values UnitCube{ 0, 1, 0, 1, 0, 1 }; // which the widget moves and stretches

// What is in the panel.
int choiceOf(vtkSMProxy* source, const char* property)
{
  vtkSMPropertyHelper helper(source, property);
  helper.SetUseUnchecked(true);
  return helper.GetAsInt();
}

Values boundsOf(vtkSMProxy* source)
{
  vtkSMPropertyHelper helper(source, "DomainBounds");
  helper.SetUseUnchecked(true);
  return helper.GetDoubleArray();
}

void setBounds(vtkSMProxy* source, const Values& bounds)
{
  vtkSMDoubleVectorProperty::SafeDownCast(source->GetProperty("DomainBounds"))
    ->SetUncheckedElements(bounds.data(), static_cast<unsigned int>(bounds.size()));
}

// Of one source.
class DomainBox : public vtkCommand
{
public:
  static DomainBox* New() { return new DomainBox; }

  void Begin(vtkSMProxy* source, vtkPVXMLElement* hint)
  {
    this->Source = source;
    this->Group = hint->GetAttribute("group");
    this->Name = hint->GetAttribute("name");
    this->Default = boundsOf(source);
    for (const char* property : { "Domain", "BoxFrom", "DomainBounds" })
    {
      source->GetProperty(property)->AddObserver(vtkCommand::UncheckedPropertyModifiedEvent, this);
    }
    this->Sent.note(source);
    source->AddObserver(vtkCommand::UpdateEvent, this);
    observeSelections(source->GetSessionProxyManager(), this);
  }

  void Execute(vtkObject* caller, unsigned long event, void* /*data*/) override
  {
    vtkSMProxy* source = this->Source;
    if (event == vtkCommand::UpdateEvent)
    {
      this->Sent.note(source);
      return;
    }
    if (event == vtkCommand::UncheckedPropertyModifiedEvent && source && !this->Sent.areAll(source))
    {
      return;
    }
    const WithoutUndo withoutUndo;
    if (source && !this->IsBusy && !source->GetSessionProxyManager()->GetInLoadXMLState())
    {
      this->IsBusy = true;
      if (event == vtkCommand::EndInteractionEvent)
      {
        this->FollowWidget(source);
      }
      if (caller == source->GetProperty("BoxFrom"))
      {
        this->BeginWithSurface(source);
      }
      this->IsBusy = false;
    }
    this->Show(source);
    if (!source && event == vtkCommand::CurrentChangedEvent)
    {
      caller->RemoveObserver(this); // the source was deleted
    }
  }

private:
  void BeginWithSurface(vtkSMProxy* source) const
  {
    const int applied = vtkSMPropertyHelper(source, "BoxFrom").GetAsInt();
    if (applied == FromBounds || choiceOf(source, "BoxFrom") != FromBounds ||
      boundsOf(source) != this->Default)
    {
      return;
    }
    vtkSmartPointer<vtkSMProxy> other;
    other.TakeReference(
      source->GetSessionProxyManager()->NewProxy(this->Group.c_str(), this->Name.c_str()));
    other->SetLocation(source->GetLocation());
    takeFromPanel(source, other);
    other->UpdateVTKObjects();
    other->UpdatePropertyInformation(other->GetProperty("BoxAroundSurface"));
    const Values box = vtkSMPropertyHelper(other, "BoxAroundSurface").GetDoubleArray();
    if (box[0] < box[1])
    {
      setBounds(source, box);
    }
  }

  void FollowWidget(vtkSMProxy* source) const
  {
    const Values low = vtkSMPropertyHelper(this->Widget, "Position").GetDoubleArray();
    const Values lengths = vtkSMPropertyHelper(this->Widget, "Scale").GetDoubleArray();
    setBounds(source,
      { low[0], low[0] + lengths[0], low[1], low[1] + lengths[1], low[2], low[2] + lengths[2] });
  }

  static bool IsWanted(vtkSMProxy* source)
  {
    vtkSMSessionProxyManager* proxies = source->GetSessionProxyManager();
    return !proxies->GetInLoadXMLState() && selectedSource(proxies) == source &&
      choiceOf(source, "Domain") == Outside && choiceOf(source, "BoxFrom") == FromBounds;
  }

  void Show(vtkSMProxy* source)
  {
    vtkSMRenderViewProxy* view =
      source && IsWanted(source) ? activeWindow(source->GetSessionProxyManager()) : nullptr;
    if (this->Widget && this->View != view)
    {
      if (this->View)
      {
        removeHidden(this->Widget, this->View);
        this->View->StillRender();
      }
      this->Widget = nullptr;
    }
    this->View = view;
    if (!view)
    {
      return;
    }
    const bool isNew = !this->Widget;
    if (isNew)
    {
      this->Widget.TakeReference(
        view->GetSessionProxyManager()->NewProxy("representations", "BoxWidgetRepresentation"));
      vtkSMPropertyHelper(this->Widget, "UseReferenceBounds").Set(1);
      vtkSMPropertyHelper(this->Widget, "ReferenceBounds").Set(UnitCube.data(), 6);
      vtkSMPropertyHelper(this->Widget, "RotationEnabled").Set(0);
      vtkSMPropertyHelper(this->Widget, "Visibility").Set(1);
      vtkSMPropertyHelper(this->Widget, "Enabled").Set(1);
      this->Widget->AddObserver(vtkCommand::EndInteractionEvent, this);
    }
    const Values box = boundsOf(source);
    vtkSMPropertyHelper(this->Widget, "Position").Set(Values{ box[0], box[2], box[4] }.data(), 3);
    vtkSMPropertyHelper(this->Widget, "Scale")
      .Set(Values{ box[1] - box[0], box[3] - box[2], box[5] - box[4] }.data(), 3);
    this->Widget->UpdateVTKObjects();
    if (isNew)
    {
      addHidden(this->Widget, view);
    }
    view->StillRender();
  }

  vtkWeakPointer<vtkSMProxy> Source;
  std::string Group; // of the proxy that knows the box around the surface
  std::string Name;
  Values Default; // of the bounds
  SentValues Sent;
  bool IsBusy = false;
  vtkSmartPointer<vtkSMProxy> Widget;
  vtkWeakPointer<vtkSMRenderViewProxy> View; // that has the widget
};

void watchBox(vtkSMProxy* source, const std::string& group)
{
  vtkPVXMLElement* hints = source->GetHints();
  vtkPVXMLElement* hint = hints ? hints->FindNestedElementByName("DomainBox") : nullptr;
  if (hint && group == "sources")
  {
    vtkNew<DomainBox> box;
    box->Begin(source, hint);
  }
}

}

void watchDomainBoxes()
{
  onRegistered<watchBox>();
}

}
