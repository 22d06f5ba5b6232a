// SPDX-License-Identifier: BSD-3-Clause
#include "PanelLibrary.h"

#include "Registration.h"

#include "vtkOutputWindow.h"

#include <string>

#include <dlfcn.h>

namespace cartesian
{

namespace
{

void load()
{
  void* const library = dlopen("libCartesianMesherPanel.so", RTLD_NOW | RTLD_LOCAL);
  void* const add = library ? dlsym(library, "cartesianAddPanelWidgets") : nullptr;
  if (add)
  {
    reinterpret_cast<void (*)()>(add)();
    return;
  }
  const std::string text = std::string("The panel has no list of boundaries: ") + dlerror() +
    ". Install CartesianMesher anew.";
  vtkOutputWindowDisplayErrorText(text.c_str());
}

// When the plugin is loaded, the window may not be there yet: panels need something that is registered.
void loadOnce(vtkSMProxy* /*proxy*/, const std::string& /*group*/)
{
  static bool isLoaded = false;
  if (!isLoaded && isInWindow())
  {
    isLoaded = true;
    load();
  }
}

}

void loadPanelWidgets()
{
  onRegistered<loadOnce>();
}

}
