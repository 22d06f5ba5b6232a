// SPDX-License-Identifier: BSD-3-Clause
#include "PanelValues.h"

#include "vtkSMDoubleVectorProperty.h"
#include "vtkSMIntVectorProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMProxy.h"
#include "vtkSMStringVectorProperty.h"
#include "vtkSmartPointer.h"
#include "vtkVariant.h"

#include <vector>

namespace cartesian
{

namespace
{

template <class Number>
void takeNumbers(vtkSMProperty* panel, vtkSMProperty* property)
{
  vtkSMPropertyHelper from(panel);
  from.SetUseUnchecked(true);
  const std::vector<Number> numbers = from.GetArray<Number>();
  vtkSMPropertyHelper(property).Set(numbers.data(), static_cast<unsigned int>(numbers.size()));
}

void takeFromPanel(vtkSMProperty* panel, vtkSMProperty* property)
{
  if (auto* texts = vtkSMStringVectorProperty::SafeDownCast(panel))
  {
    vtkSMStringVectorProperty::SafeDownCast(property)->SetElements(texts->GetUncheckedElements());
  }
  else if (vtkSMDoubleVectorProperty::SafeDownCast(panel))
  {
    takeNumbers<double>(panel, property);
  }
  else if (vtkSMIntVectorProperty::SafeDownCast(panel))
  {
    takeNumbers<int>(panel, property);
  }
  else
  {
    property->Copy(panel);
  }
}

}

void forEachProperty(
  vtkSMProxy* proxy, const std::function<void(const char*, vtkSMProperty*)>& action)
{
  vtkSmartPointer<vtkSMPropertyIterator> properties;
  properties.TakeReference(proxy->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    if (properties->GetProperty()->GetInformationOnly() == 0)
    {
      action(properties->GetKey(), properties->GetProperty());
    }
  }
}

std::string textOf(vtkSMProxy* proxy, bool inPanel)
{
  std::string text;
  forEachProperty(proxy, [&](const char* name, vtkSMProperty* property) {
    if (vtkSMVectorProperty::SafeDownCast(property))
    {
      vtkSMPropertyHelper helper(proxy, name);
      helper.SetUseUnchecked(inPanel);
      text += name;
      for (unsigned int i = 0; i < helper.GetNumberOfElements(); ++i)
      {
        text += "\n" + helper.GetAsVariant(i).ToString();
      }
      text += "\n\n";
    }
  });
  return text;
}

void takeFromPanel(vtkSMProxy* source, vtkSMProxy* other)
{
  forEachProperty(source, [other](const char* name, vtkSMProperty* panel) {
    if (vtkSMProperty* const property = other->GetProperty(name))
    {
      takeFromPanel(panel, property);
    }
  });
}

}
