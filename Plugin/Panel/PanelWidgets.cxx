// SPDX-License-Identifier: BSD-3-Clause
#include "PanelWidgets.h"

#include "BoundaryTable.h"
#include "CellsOfSelection.h"
#include "UntracedButton.h"

#include "pqApplicationCore.h"
#include "pqInterfaceTracker.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyGroup.h"

#include <cstring>

namespace cartesian
{

namespace
{

bool isCalled(const char* widget, const char* name)
{
  return widget && std::strcmp(widget, name) == 0;
}

}

pqPropertyWidget* PanelWidgets::createWidgetForProperty(
  vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
{
  const char* const widget = property->GetPanelWidget();
  if (isCalled(widget, "CellsOfSelection"))
  {
    return new CellsOfSelection(proxy, property, parent);
  }
  return isCalled(widget, "UntracedButton") ? new UntracedButton(proxy, property, parent) : nullptr;
}

pqPropertyWidget* PanelWidgets::createWidgetForPropertyGroup(
  vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent)
{
  return isCalled(group->GetPanelWidget(), "BoundaryTable")
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
