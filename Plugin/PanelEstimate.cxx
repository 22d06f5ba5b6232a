// SPDX-License-Identifier: BSD-3-Clause
#include "PanelEstimate.h"

#include "PanelValues.h"
#include "Registration.h"

#include "vtkClientServerStream.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPVXMLElement.h"
#include "vtkSMProperty.h"
#include "vtkSMProxy.h"
#include "vtkSMSession.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <sstream>
#include <string>
#include <vector>

namespace cartesian
{

namespace
{

// Of one source: asks another of its kind, which has the values in the panel.
class Follow : public vtkCommand
{
public:
  static Follow* New() { return new Follow; }

  void Begin(vtkSMProxy* source, vtkPVXMLElement* hint)
  {
    this->Source = source;
    this->Properties = { hint->GetAttribute("property") };
    const char* also = hint->GetAttribute("also");
    std::istringstream others(also ? also : "");
    for (std::string name; others >> name;)
    {
      this->Properties.push_back(name);
    }
    this->Command = hint->GetAttribute("command");
    forEachProperty(source, [this](const char* /*name*/, vtkSMProperty* changing) {
      changing->AddObserver(vtkCommand::UncheckedPropertyModifiedEvent, this);
    });
  }

  void Execute(vtkObject* /*caller*/, unsigned long /*event*/, void* /*data*/) override
  {
    vtkSMProxy* source = this->Source;
    if (!source || !source->GetObjectsCreated() ||
      source->GetSessionProxyManager()->GetInLoadXMLState())
    {
      return;
    }
    const std::string applied = textOf(source, false);
    std::string typed = textOf(source, true);
    if (typed == applied)
    {
      typed.clear();
    }
    if (typed == this->Typed)
    {
      return;
    }
    this->Typed = typed;
    if (!typed.empty())
    {
      this->Applied = applied;
      this->Estimate(source);
    }
    else if (applied == this->Applied) // taken back; ParaView itself asks after Apply
    {
      for (const std::string& property : this->Properties)
      {
        source->UpdatePropertyInformation(source->GetProperty(property.c_str()));
      }
    }
  }

private:
  void Estimate(vtkSMProxy* source) const
  {
    vtkSmartPointer<vtkSMProxy> other;
    other.TakeReference(
      source->GetSessionProxyManager()->NewProxy(source->GetXMLGroup(), source->GetXMLName()));
    other->SetLocation(source->GetLocation());
    takeFromPanel(source, other);
    other->UpdateVTKObjects();
    vtkClientServerStream command;
    command << vtkClientServerStream::Invoke << VTKOBJECT(other) << this->Command
            << vtkClientServerStream::End;
    other->GetSession()->ExecuteStream(other->GetLocation(), command);
    for (const std::string& property : this->Properties)
    {
      vtkSMProperty* estimate = other->GetProperty(property.c_str());
      other->UpdatePropertyInformation(estimate);
      source->GetProperty(property.c_str())->Copy(estimate);
    }
  }

  vtkWeakPointer<vtkSMProxy> Source;
  std::vector<std::string> Properties; // that show the estimate
  std::string Command;
  std::string Typed;   // the values that the property is of; empty: those that were applied
  std::string Applied; // those that were when the last ones were typed
};

void followPanel(vtkSMProxy* source, const std::string& group)
{
  vtkPVXMLElement* hints = source->GetHints();
  vtkPVXMLElement* hint = hints ? hints->FindNestedElementByName("Estimate") : nullptr;
  if (hint && group == "sources")
  {
    vtkNew<Follow> follow;
    follow->Begin(source, hint);
  }
}

}

void watchPanels()
{
  onRegistered<followPanel>();
}

}
