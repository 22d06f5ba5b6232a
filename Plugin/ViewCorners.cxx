// SPDX-License-Identifier: BSD-3-Clause
#include "ViewCorners.h"

#include "PortHints.h"
#include "Registration.h"
#include "Window.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"
#include "vtkWeakPointer.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr int SmallFont = 12;
constexpr const char* Corner = "WindowLocation";

int cornerOf(vtkSMProxy* representation)
{
  return vtkSMPropertyHelper(representation, Corner).GetAsInt();
}

bool isSmallText(vtkSMProxy* representation)
{
  const auto [source, port] =
    representation->GetProperty(Corner) ? inputOf(representation) : Output{};
  return source && hintOf(source, port, "SmallText");
}

// Where the user has drawn it to, it stays.
void place(vtkSMProxy* text, vtkSMProxy* view)
{
  if (cornerOf(text) != 0)
  {
    vtkSMPropertyHelper(text, Corner)
      .Set(freeCorner(view, text, { UpperLeft, UpperCentre, LowerCentre }));
    text->UpdateVTKObjects();
  }
}

// Of one legend.
class Yielding : public vtkCommand
{
public:
  static Yielding* New() { return new Yielding; }

  void Begin(vtkSMProxy* legend)
  {
    this->Legend = legend;
    for (const char* property : { Corner, "Visibility" })
    {
      legend->GetProperty(property)->AddObserver(vtkCommand::ModifiedEvent, this);
    }
  }

  void Execute(vtkObject* /*caller*/, unsigned long /*event*/, void* /*data*/) override
  {
    vtkSMProxy* const view = this->Legend ? vtkSMViewProxy::FindView(this->Legend) : nullptr;
    if (!view || view->GetSessionProxyManager()->GetInLoadXMLState())
    {
      return;
    }
    const vtkSMPropertyHelper shown(view, "Representations");
    for (unsigned int i = 0; i < shown.GetNumberOfElements(); ++i)
    {
      if (isSmallText(shown.GetAsProxy(i)))
      {
        place(shown.GetAsProxy(i), view);
      }
    }
  }

private:
  vtkWeakPointer<vtkSMProxy> Legend;
};

void prepareText(vtkSMProxy* text)
{
  vtkSMPropertyHelper(text, Corner).Set(UpperLeft);
  vtkSMPropertyHelper(text, "Justification", true).Set("Left");
  vtkSMPropertyHelper(text, "FontSize", true).Set(SmallFont);
  if (vtkSMProxy* const view = activeView(text->GetSessionProxyManager()))
  {
    place(text, view);
  }
  text->UpdateVTKObjects();
}

void prepareNew(vtkSMProxy* representation, const std::string& group)
{
  if (group == "scalar_bars")
  {
    vtkNew<Yielding>()->Begin(representation);
  }
  else if (group == "representations" &&
    !representation->GetSessionProxyManager()->GetInLoadXMLState() && isSmallText(representation))
  {
    prepareText(representation);
  }
}

}

ViewCorner freeCorner(vtkSMProxy* view, vtkSMProxy* forThis, const std::vector<ViewCorner>& corners)
{
  const auto isFree = [&](ViewCorner corner) {
    for (const char* list : { "Representations", "HiddenRepresentations" })
    {
      const vtkSMPropertyHelper shown(view, list);
      for (unsigned int i = 0; i < shown.GetNumberOfElements(); ++i)
      {
        vtkSMProxy* const other = shown.GetAsProxy(i);
        if (other != forThis && other->GetProperty(Corner) && cornerOf(other) == corner &&
          vtkSMPropertyHelper(other, "Visibility").GetAsInt() != 0)
        {
          return false;
        }
      }
    }
    return true;
  };
  const auto found = std::find_if(corners.begin(), corners.end(), isFree);
  return found == corners.end() ? corners.front() : *found;
}

void watchTexts()
{
  onRegistered<prepareNew>();
}

}
