// SPDX-License-Identifier: BSD-3-Clause
// Hints in the XML of a source.
#pragma once

#include "vtkPVXMLElement.h"
#include "vtkSMProxy.h"

#include <cstring>

namespace cartesian
{

// The source's hint of this name for a port; null: none.
inline vtkPVXMLElement* hintOf(vtkSMProxy* source, int port, const char* name)
{
  vtkPVXMLElement* hints = source->GetHints();
  for (unsigned int i = 0; hints && i < hints->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* hint = hints->GetNestedElement(i);
    int of = 0;
    if (std::strcmp(hint->GetName(), name) == 0 && hint->GetScalarAttribute("port", &of) != 0 &&
      of == port)
    {
      return hint;
    }
  }
  return nullptr;
}

}
