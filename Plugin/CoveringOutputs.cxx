// SPDX-License-Identifier: BSD-3-Clause
#include "CoveringOutputs.h"

#include "PortHints.h"
#include "Registration.h"

#include "vtkNew.h"
#include "vtkPVXMLElement.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"

#include <string>

namespace cartesian
{

namespace
{

// `from`: the output that a filter, new to the active view, has as its input.
void hideCovering(const Output& from)
{
  vtkSMProxySelectionModel* const active =
    from.source->GetSessionProxyManager()->GetSelectionModel("ActiveView");
  auto* const view = active ? vtkSMViewProxy::SafeDownCast(active->GetCurrentProxy()) : nullptr;
  for (int port = 0; view && port < static_cast<int>(from.source->GetNumberOfOutputPorts()); ++port)
  {
    vtkPVXMLElement* const hint = hintOf(from.source, port, "Covers");
    int what = -1;
    if (hint && hint->GetScalarAttribute("what", &what) != 0 && what == from.port)
    {
      vtkNew<vtkSMParaViewPipelineControllerWithRendering>()->Hide(from.source, port, view);
    }
  }
}

bool replacesInput(vtkSMProxy* filter)
{
  vtkPVXMLElement* const hints = filter->GetHints();
  vtkPVXMLElement* const hint = hints ? hints->FindNestedElementByName("Visibility") : nullptr;
  int replaces = 1;
  if (hint)
  {
    hint->GetScalarAttribute("replace_input", &replaces);
  }
  return replaces != 0;
}

void watchNew(vtkSMProxy* proxy, const std::string& group)
{
  if (group != "representations" || proxy->GetSessionProxyManager()->GetInLoadXMLState() ||
    !isInWindow())
  {
    return;
  }
  vtkSMSourceProxy* const filter = inputOf(proxy).source;
  if (!filter || !filter->GetProperty("Input") || !replacesInput(filter))
  {
    return;
  }
  const Output from = inputOf(filter);
  if (from.source)
  {
    hideCovering(from);
  }
}

}

void watchCoveringOutputs()
{
  onRegistered<watchNew>();
}

}
