// SPDX-License-Identifier: BSD-3-Clause
#include "PanelWidgets.h"

#include "BoundaryTable.h"

#include "pqApplicationCore.h"
#include "pqInterfaceTracker.h"
#include "vtkSMPropertyGroup.h"

#include <cstring>

namespace cartesian
{

pqPropertyWidget* PanelWidgets::createWidgetForPropertyGroup(
  vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent)
{
  const char* const widget = group->GetPanelWidget();
  return widget && std::strcmp(widget, "BoundaryTable") == 0
    ? new BoundaryTable(proxy, group, parent)
    : nullptr;
}

}

// What PanelLibrary.cxx calls.
extern "C" Q_DECL_EXPORT void cartesianAddPanelWidgets()
{
  if (pqApplicationCore* const core = pqApplicationCore::instance())
  {
    core->interfaceTracker()->addInterface(new cartesian::PanelWidgets(core->interfaceTracker()));
  }
}
