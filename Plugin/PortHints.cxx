// SPDX-License-Identifier: BSD-3-Clause
#include "PortHints.h"

#include "vtkPVXMLElement.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"

#include <cstring>

namespace cartesian
{

Output inputOf(vtkSMProxy* consumer)
{
  const vtkSMPropertyHelper input(consumer, "Input", true);
  auto* source =
    input.GetNumberOfElements() == 1 ? vtkSMSourceProxy::SafeDownCast(input.GetAsProxy()) : nullptr;
  return { source, source ? static_cast<int>(input.GetOutputPort()) : 0 };
}

vtkPVXMLElement* hintOf(vtkSMProxy* source, int port, const char* name)
{
  vtkPVXMLElement* hints = source->GetHints();
  for (unsigned int i = 0; hints && i < hints->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* hint = hints->GetNestedElement(i);
    int of = 0;
    hint->GetScalarAttribute("port", &of);
    if (std::strcmp(hint->GetName(), name) == 0 && of == port)
    {
      return hint;
    }
  }
  return nullptr;
}

}
