// SPDX-License-Identifier: BSD-3-Clause
#include "FlowView.h"

#include "MiddleSlice.h"
#include "PortHints.h"
#include "Registration.h"
#include "Window.h"

#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPVDataInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTransferFunctionManager.h"
#include "vtkWeakPointer.h"

#include <array>
#include <cstddef>
#include <string>

namespace cartesian
{

namespace
{

using Direction = std::array<double, 3>;

// Of the camera, as seen from the bodies.
constexpr double Upstream = 0.9;
constexpr double Beside = 1.1;
constexpr double Above = 0.55;

constexpr int Outside = 1;

int choiceOf(vtkSMProxy* source, const char* property)
{
  return vtkSMPropertyHelper(source, property).GetAsInt();
}

// A side or direction: 0 is plus x or xMin, 1 minus x or xMax, and so on.
Direction alongSide(int side)
{
  Direction direction{};
  direction[static_cast<std::size_t>(side / 2)] = side % 2 == 0 ? 1 : -1;
  return direction;
}

// Away from the ground; without one z, or y where the flow or a plane of symmetry is across z.
Direction upOf(vtkSMProxy* source, const Direction& flow)
{
  constexpr int PlusY = 2;
  constexpr int PlusZ = 4;
  constexpr int AcrossZ = 3;
  if (const int ground = choiceOf(source, "Ground"); ground > 0)
  {
    return alongSide(ground - 1);
  }
  return alongSide(flow[2] != 0 || choiceOf(source, "Half") == AcrossZ ? PlusY : PlusZ);
}

// What is kept of a body cut in halves is above the plane.
Direction besideOf(vtkSMProxy* source, const Direction& flow, const Direction& up)
{
  if (const int half = choiceOf(source, "Half"); half > 0)
  {
    return alongSide(2 * (half - 1));
  }
  Direction beside{};
  vtkMath::Cross(flow.data(), up.data(), beside.data());
  return beside;
}

void look(vtkSMRenderViewProxy* view, vtkSMSourceProxy* source)
{
  const vtkSMPropertyHelper input(source, "Input");
  auto* const body = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  if (!body)
  {
    return;
  }
  const Direction flow = alongSide(choiceOf(source, "FlowDirection"));
  const Direction up = upOf(source, flow);
  const Direction beside = besideOf(source, flow, up);
  Direction position{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    position[axis] = Beside * beside[axis] + Above * up[axis] - Upstream * flow[axis];
  }
  vtkSMPropertyHelper(view, "CameraFocalPoint").Set(Direction{}.data(), 3);
  vtkSMPropertyHelper(view, "CameraPosition").Set(position.data(), 3);
  vtkSMPropertyHelper(view, "CameraViewUp").Set(up.data(), 3);
  view->UpdateVTKObjects();
  std::array<double, 6> bounds;
  body->GetDataInformation(input.GetOutputPort())->GetBounds(bounds.data());
  view->ResetCamera(bounds.data());
  if (choiceOf(source, "Half") == 0) // else there is the plane of symmetry
  {
    const Direction middle{ (bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2,
      (bounds[4] + bounds[5]) / 2 };
    showMiddleSlice(source, view, middle, beside);
  }
}

void colourBy(vtkSMProxy* representation, const char* array)
{
  vtkSMPropertyHelper(representation, "ColorArrayName", true)
    .SetInputArrayToProcess(vtkDataObject::CELL, array);
  representation->UpdateVTKObjects();
}

// Of one representation that is hidden at first: ParaView would show the legend of its colours.
class ColoursOnceSeen : public vtkCommand
{
public:
  static ColoursOnceSeen* New() { return new ColoursOnceSeen; }

  void Begin(vtkSMProxy* representation)
  {
    this->Representation = representation;
    this->Array = vtkSMPropertyHelper(representation, "ColorArrayName", true).GetAsString(4);
    colourBy(representation, "");
    representation->GetProperty("Visibility")->AddObserver(vtkCommand::ModifiedEvent, this);
  }

  void Execute(vtkObject* visibility, unsigned long /*event*/, void* /*data*/) override
  {
    if (this->Representation &&
      vtkSMPropertyHelper(this->Representation, "Visibility").GetAsInt() != 0)
    {
      visibility->RemoveObserver(this);
      vtkSMProxy* const colours = vtkNew<vtkSMTransferFunctionManager>()->GetColorTransferFunction(
        this->Array.c_str(), this->Representation->GetSessionProxyManager());
      vtkSMPropertyHelper(this->Representation, "LookupTable", true).Set(colours);
      colourBy(this->Representation, this->Array.c_str());
    }
  }

private:
  vtkWeakPointer<vtkSMProxy> Representation;
  std::string Array;
};

void prepare(vtkSMProxy* representation, const std::string& group)
{
  vtkSMSessionProxyManager* const proxies = representation->GetSessionProxyManager();
  if (group != "representations" || proxies->GetInLoadXMLState())
  {
    return;
  }
  const auto [source, port] = inputOf(representation);
  vtkPVXMLElement* const hint = source ? hintOf(source, port, "FlowView") : nullptr;
  vtkSMRenderViewProxy* const view = hint ? activeWindow(proxies) : nullptr;
  if (!view || choiceOf(source, "Domain") != Outside)
  {
    return;
  }
  int shows = 1;
  hint->GetScalarAttribute("show", &shows);
  if (shows == 0)
  {
    vtkSMPropertyHelper(representation, "Visibility").Set(0);
    vtkNew<ColoursOnceSeen>()->Begin(representation);
  }
  else
  {
    look(view, source);
  }
}

}

void watchFlowViews()
{
  onRegistered<prepare>();
}

}
