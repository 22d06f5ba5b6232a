// SPDX-License-Identifier: BSD-3-Clause
#include "OlderStates.h"

#include "PanelRows.h"

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

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

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

// As rows of the table of boundaries, where the user sees them. A row of a boundary's own would replace those with
// patterns: then they stay as they are, and the filter warns.
void moveRefinedBoundaries(vtkSMProxy* proxy)
{
  if (!proxy->GetProperty("RefinedBoundaries"))
  {
    return;
  }
  vtkSMPropertyHelper chosen(proxy, "RefinedBoundaries");
  vtkSMPropertyHelper names(proxy, "BoundaryNames");
  std::vector<std::string> rows;
  for (unsigned int i = 0; i < names.GetNumberOfElements(); ++i)
  {
    rows.emplace_back(names.GetAsString(i));
    if (rows.back().find_first_of("*?") != std::string::npos)
    {
      return;
    }
  }
  const int depth = vtkSMPropertyHelper(proxy, "RefinedBoundaryDepth").GetAsInt();
  bool isMoved = false;
  for (unsigned int i = 0; i + 1 < chosen.GetNumberOfElements(); i += 2)
  {
    if (std::atoi(chosen.GetAsString(i + 1)) == 0)
    {
      continue;
    }
    isMoved = true;
    const auto row = static_cast<unsigned int>(
      std::find(rows.begin(), rows.end(), chosen.GetAsString(i)) - rows.begin());
    if (row == rows.size())
    {
      rows.emplace_back(chosen.GetAsString(i));
      names.Set(row, rows.back().c_str());
    }
    completeTables(proxy);
    if (vtkSMPropertyHelper depths(proxy, "BoundaryDepths"); depths.GetAsInt(row) < 0)
    {
      depths.Set(row, depth);
    }
  }
  chosen.RemoveAllValues();
  if (isMoved)
  {
    vtkWarningWithObjectMacro(proxy,
      "Refined Boundaries, which is deprecated, became rows of the table "
      "Boundaries: save the state again.");
  }
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
  moveRefinedBoundaries(proxy);
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
