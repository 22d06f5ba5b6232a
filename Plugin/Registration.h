// SPDX-License-Identifier: BSD-3-Clause
// Proxies that ParaView registers: sources, representations, legends.
#pragma once

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkSMProxyManager.h"

#include <string>

namespace cartesian
{

// Whether there is ParaView's window, instead of scripts alone: Qt's connections with an object end with it.
inline bool isInWindow()
{
  return vtkSMProxyManager::GetProxyManager()->HasObserver(vtkCommand::DeleteEvent) != 0;
}

// From now on calls Action(proxy, group) for each.
template <void (*Action)(vtkSMProxy*, const std::string&)>
void onRegistered()
{
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback([](vtkObject*, unsigned long, void*, void* data) {
    using Registered = vtkSMProxyManager::RegisteredProxyInformation;
    const auto* registered = static_cast<const Registered*>(data);
    if (registered->Type == Registered::PROXY && registered->Proxy)
    {
      Action(registered->Proxy, registered->GroupName);
    }
  });
  vtkSMProxyManager::GetProxyManager()->AddObserver(vtkCommand::RegisterEvent, command);
}

}
