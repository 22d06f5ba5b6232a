// SPDX-License-Identifier: BSD-3-Clause
#include "CoveringOutputs.h"

#include "PortHints.h"
#include "Registration.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPVXMLElement.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkWeakPointer.h"

#include <string>

namespace cartesian
{

namespace
{

bool isVisible(vtkSMProxy* representation)
{
  return vtkSMPropertyHelper(representation, "Visibility").GetAsInt() != 0;
}

void hide(vtkSMProxy* representation)
{
  vtkSMPropertyHelper(representation, "Visibility").Set(0);
  representation->UpdateVTKObjects();
}

// Hides one representation as soon as another is hidden, once.
class HideWith : public vtkCommand
{
public:
  static HideWith* New() { return new HideWith; }

  void Begin(vtkSMProxy* first, vtkSMProxy* second)
  {
    this->First = first;
    this->Second = second;
    first->GetProperty("Visibility")->AddObserver(vtkCommand::ModifiedEvent, this);
  }

  void Execute(vtkObject* /*caller*/, unsigned long /*event*/, void* /*data*/) override
  {
    if (this->First && this->Second && !isVisible(this->First))
    {
      hide(this->Second);
      this->Second = nullptr;
    }
  }

private:
  vtkWeakPointer<vtkSMProxy> First;
  vtkWeakPointer<vtkSMProxy> Second;
};

// In the active view; null: none.
vtkSMProxy* representationOf(const Output& output)
{
  vtkSMProxySelectionModel* const active =
    output.source->GetSessionProxyManager()->GetSelectionModel("ActiveView");
  vtkSMProxy* const view = active ? active->GetCurrentProxy() : nullptr;
  if (!view || !view->GetProperty("Representations"))
  {
    return nullptr;
  }
  const vtkSMPropertyHelper representations(view, "Representations");
  for (unsigned int i = 0; i < representations.GetNumberOfElements(); ++i)
  {
    const Output shown = inputOf(representations.GetAsProxy(i));
    if (shown.source == output.source && shown.port == output.port)
    {
      return representations.GetAsProxy(i);
    }
  }
  return nullptr;
}

// `from`: an output that a filter, new to the view, takes the place of.
void hideCovering(const Output& from)
{
  for (int port = 0; port < static_cast<int>(from.source->GetNumberOfOutputPorts()); ++port)
  {
    vtkPVXMLElement* const hint = hintOf(from.source, port, "Covers");
    int what = -1;
    if (!hint || hint->GetScalarAttribute("what", &what) == 0 || what != from.port)
    {
      continue;
    }
    vtkSMProxy* const replaced = representationOf(from);
    vtkSMProxy* const covering = representationOf({ from.source, port });
    if (replaced && covering && isVisible(replaced))
    {
      vtkNew<HideWith> both;
      both->Begin(replaced, covering);
    }
    else if (replaced && covering)
    {
      hide(covering);
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
  if (group != "representations" || proxy->GetSessionProxyManager()->GetInLoadXMLState())
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
