// SPDX-License-Identifier: BSD-3-Clause
#include "PanelRows.h"

#include "Registration.h"

#include "vtkPVXMLElement.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMStringVectorProperty.h"
#include "vtkSMVectorProperty.h"

#include <algorithm>

namespace cartesian
{

namespace
{

vtkSMVectorProperty* columnOf(vtkSMPropertyGroup* table, unsigned int i)
{
  return vtkSMVectorProperty::SafeDownCast(table->GetProperty(i));
}

unsigned int rowsOf(vtkSMVectorProperty* column)
{
  return column->GetNumberOfElements() /
    static_cast<unsigned int>(column->GetNumberOfElementsPerCommand());
}

// So that there are as many; `usual`: the property of a new row.
void addRows(vtkSMVectorProperty* column, vtkSMProperty* usual, unsigned int rows)
{
  const vtkSMPropertyHelper from(usual);
  vtkSMPropertyHelper to(column);
  const unsigned int width = from.GetNumberOfElements();
  for (unsigned int i = rowsOf(column) * width; i < rows * width; ++i)
  {
    if (vtkSMStringVectorProperty::SafeDownCast(column))
    {
      to.Set(i, from.GetAsString(i % width));
    }
    else
    {
      to.Set(i, from.GetAsDouble(i % width));
    }
  }
}

void complete(vtkSMPropertyGroup* table, vtkSMProxy* row)
{
  unsigned int rows = 0;
  for (unsigned int i = 0; i < table->GetNumberOfProperties(); ++i)
  {
    rows = std::max(rows, rowsOf(columnOf(table, i)));
  }
  for (unsigned int i = 0; i < table->GetNumberOfProperties(); ++i)
  {
    vtkSMVectorProperty* column = columnOf(table, i);
    addRows(column, row->GetProperty(table->GetFunction(column)), rows);
  }
}

void completeOnLoading(vtkSMProxy* source, const std::string& /*group*/)
{
  vtkPVXMLElement* hints = source->GetHints();
  if (hints && hints->FindNestedElementByName("CompleteRows") &&
    source->GetSessionProxyManager()->GetInLoadXMLState())
  {
    completeTables(source);
  }
}

}

void completeTables(vtkSMProxy* source)
{
  for (std::size_t i = 0; i < source->GetNumberOfPropertyGroups(); ++i)
  {
    vtkSMPropertyGroup* group = source->GetPropertyGroup(i);
    vtkPVXMLElement* row = group->GetHints()
      ? group->GetHints()->FindNestedElementByName("PropertyCollectionWidgetPrototype")
      : nullptr;
    if (row)
    {
      complete(group,
        source->GetSessionProxyManager()->GetPrototypeProxy(
          row->GetAttribute("group"), row->GetAttribute("name")));
    }
  }
}

void completeRowsOfStates()
{
  onRegistered<completeOnLoading>();
}

}
