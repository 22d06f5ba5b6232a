// SPDX-License-Identifier: BSD-3-Clause
#include "OlderStates.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkPVXMLElement.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyLocator.h"
#include "vtkSMProxyManager.h"
#include "vtkSmartPointer.h"

#include <cstdlib>
#include <cstring>

namespace cartesian
{

namespace
{

bool has(vtkPVXMLElement* proxy, const char* property)
{
  for (unsigned int i = 0; i < proxy->GetNumberOfNestedElements(); ++i)
  {
    const char* const name = proxy->GetNestedElement(i)->GetAttribute("name");
    if (name && std::strcmp(name, property) == 0)
    {
      return true;
    }
  }
  return false;
}

void complete(vtkSMProxy* proxy, vtkPVXMLElement* inState)
{
  vtkSmartPointer<vtkSMPropertyIterator> properties;
  properties.TakeReference(proxy->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    vtkPVXMLElement* const hints = properties->GetProperty()->GetHints();
    vtkPVXMLElement* const hint = hints ? hints->FindNestedElementByName("OlderStates") : nullptr;
    if (hint && !has(inState, properties->GetKey()))
    {
      vtkSMPropertyHelper(properties->GetProperty()).Set(std::atoi(hint->GetAttribute("value")));
    }
  }
  proxy->UpdateVTKObjects();
}

void completeAll(vtkPVXMLElement* element, vtkSMProxyLocator* proxies)
{
  for (unsigned int i = 0; i < element->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* const nested = element->GetNestedElement(i);
    const char* const id = nested->GetAttribute("id");
    if (std::strcmp(nested->GetName(), "Proxy") != 0)
    {
      completeAll(nested, proxies);
    }
    else if (vtkSMProxy* proxy =
               id ? proxies->LocateProxy(static_cast<vtkTypeUInt32>(std::atoi(id))) : nullptr)
    {
      complete(proxy, nested);
    }
  }
}

}

void completeOlderStates()
{
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback([](vtkObject*, unsigned long, void*, void* data) {
    const auto* state = static_cast<const vtkSMProxyManager::LoadStateInformation*>(data);
    if (state->RootElement && state->ProxyLocator)
    {
      completeAll(state->RootElement, state->ProxyLocator);
    }
  });
  vtkSMProxyManager::GetProxyManager()->AddObserver(vtkCommand::LoadStateEvent, command);
}

}
