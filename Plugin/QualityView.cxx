// SPDX-License-Identifier: BSD-3-Clause
#include "QualityView.h"

#include "PortHints.h"
#include "Quality/QualityMeasures.h"
#include "Registration.h"

#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMOutputPort.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyIterator.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTransferFunctionManager.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace cartesian
{

namespace
{

constexpr double OpacityAroundCells = 0.2;
constexpr double Around = 2; // as many cells are seen beside them

bool isSmallWorse(const std::string& measure)
{
  const auto* const spec = std::find_if(MeasureSpecs.begin(), MeasureSpecs.end(),
    [&](const MeasureSpec& known) { return known.name == measure; });
  return spec != MeasureSpecs.end() && !spec->largeIsWorse;
}

// Without vtkSMTransferFunctionProxy, whose header wants development packages that ParaView 6.1's does not bring.
void invert(vtkSMProxy* colours)
{
  vtkSMPropertyHelper points(colours, "RGBPoints"); // value, red, green, blue
  const std::vector<double> before = points.GetDoubleArray();
  std::vector<double> after;
  for (std::size_t end = before.size(); end >= 4; end -= 4)
  {
    after.push_back(before.front() + before[before.size() - 4] - before[end - 4]);
    after.insert(after.end(), before.begin() + static_cast<std::ptrdiff_t>(end) - 3,
      before.begin() + static_cast<std::ptrdiff_t>(end));
  }
  points.Set(after.data(), static_cast<unsigned int>(after.size()));
  colours->UpdateVTKObjects();
}

// Red is worst.
void prepareColours(const std::string& measure, vtkSMSessionProxyManager* proxies)
{
  const bool isNew = !proxies->GetProxy("lookup_tables", (measure + ".PVLookupTable").c_str());
  vtkSMProxy* colours =
    vtkNew<vtkSMTransferFunctionManager>()->GetColorTransferFunction(measure.c_str(), proxies);
  if (isNew && isSmallWorse(measure))
  {
    invert(colours);
  }
}

std::vector<vtkSMRenderViewProxy*> renderViews(vtkSMSessionProxyManager* proxies)
{
  std::vector<vtkSMRenderViewProxy*> views;
  vtkNew<vtkSMProxyIterator> iterator;
  iterator->SetSessionProxyManager(proxies);
  iterator->SetModeToOneGroup();
  for (iterator->Begin("views"); !iterator->IsAtEnd(); iterator->Next())
  {
    if (auto* view = vtkSMRenderViewProxy::SafeDownCast(iterator->GetProxy()))
    {
      views.push_back(view);
    }
  }
  return views;
}

// The active one, if it is of three dimensions; else any of these; null: there is none.
vtkSMRenderViewProxy* viewFor(vtkSMSessionProxyManager* proxies)
{
  vtkSMProxySelectionModel* active = proxies->GetSelectionModel("ActiveView");
  auto* view = vtkSMRenderViewProxy::SafeDownCast(active ? active->GetCurrentProxy() : nullptr);
  const std::vector<vtkSMRenderViewProxy*> views = renderViews(proxies);
  return view ? view : views.empty() ? nullptr : views.front();
}

// The boundary of a mesh lies in the cells' surface.
void hideBoundary(vtkSMSourceProxy* source)
{
  vtkSMRenderViewProxy* view = viewFor(source->GetSessionProxyManager());
  auto* mesher = vtkSMSourceProxy::SafeDownCast(vtkSMPropertyHelper(source, "Input").GetAsProxy());
  for (unsigned int port = 0; view && mesher && port < mesher->GetNumberOfOutputPorts(); ++port)
  {
    vtkPVXMLElement* hint = hintOf(mesher, static_cast<int>(port), "Colours");
    if (hint && hint->GetAttribute("array") == std::string("BoundaryName") &&
      view->FindRepresentation(mesher, static_cast<int>(port)))
    {
      vtkNew<vtkSMParaViewPipelineControllerWithRendering>()->Hide(
        mesher, static_cast<int>(port), view);
    }
  }
}

// The information that a hint of a source names.
std::string told(vtkSMSourceProxy* source, const char* property)
{
  source->UpdatePropertyInformation(source->GetProperty(property));
  return vtkSMPropertyHelper(source, property).GetAsString();
}

void colourByWorst(vtkSMProxy* representation, vtkSMSourceProxy* source, vtkPVXMLElement* hint)
{
  const std::string measure = told(source, hint->GetAttribute("property"));
  prepareColours(measure, representation->GetSessionProxyManager());
  vtkSMPropertyHelper(representation, "ColorArrayName", true)
    .SetInputArrayToProcess(vtkDataObject::CELL, measure.c_str());
  representation->UpdateVTKObjects();
  hideBoundary(source);
}

// The chart that a new representation comes into: one that is empty, else the last.
vtkSMProxy* chartFor(vtkSMSessionProxyManager* proxies)
{
  vtkSMProxy* last = nullptr;
  vtkNew<vtkSMProxyIterator> iterator;
  iterator->SetSessionProxyManager(proxies);
  iterator->SetModeToOneGroup();
  for (iterator->Begin("views"); !iterator->IsAtEnd(); iterator->Next())
  {
    vtkSMProxy* view = iterator->GetProxy();
    if (view->GetXMLName() == std::string("XYChartView"))
    {
      last = view;
      if (vtkSMPropertyHelper(view, "Representations").GetNumberOfElements() == 0)
      {
        return view;
      }
    }
  }
  return last;
}

// Over the column of the measure, with axes that say what they are; a single cell is as well seen as thousands.
void setChart(vtkSMProxy* representation, const std::string& title, vtkSMProxy* chart)
{
  const std::string measure = title.substr(0, title.find(" ("));
  vtkSMPropertyHelper(representation, "UseIndexForXAxis", true).Set(0);
  vtkSMPropertyHelper(representation, "XArrayName", true).Set(measure.c_str());
  // Not the measure itself, over itself.
  std::vector<std::string> series{ measure, "0", "Cells", "1" };
  if (measure != title) // (limit)
  {
    const std::size_t begin = measure.size() + 2;
    series.insert(series.end(), { title.substr(begin, title.size() - begin - 1), "1" });
  }
  vtkSMPropertyHelper visible(representation, "SeriesVisibility", true);
  visible.SetNumberOfElements(static_cast<unsigned int>(series.size()));
  for (unsigned int i = 0; i < series.size(); ++i)
  {
    visible.Set(i, series[i].c_str());
  }
  representation->UpdateVTKObjects();
  if (chart)
  {
    vtkSMPropertyHelper(chart, "BottomAxisTitle", true).Set(title.c_str());
    vtkSMPropertyHelper(chart, "LeftAxisTitle", true).Set("Cells");
    vtkSMPropertyHelper(chart, "LeftAxisLogScale", true).Set(1);
    chart->UpdateVTKObjects();
  }
}

// The chart of a representation after its source has another measure.
class ChartOfMeasure : public vtkCommand
{
public:
  static ChartOfMeasure* New() { return new ChartOfMeasure; }

  void Begin(vtkSMProxy* representation, vtkSMSourceProxy* source, const char* property)
  {
    this->Representation = representation;
    this->Property = property;
    this->Title = told(source, property);
    setChart(representation, this->Title, chartFor(representation->GetSessionProxyManager()));
    source->AddObserver(vtkCommand::UpdateDataEvent, this);
  }

  void Execute(vtkObject* caller, unsigned long /*event*/, void* /*data*/) override
  {
    vtkSMProxy* representation = this->Representation;
    if (representation)
    {
      const std::string title =
        told(vtkSMSourceProxy::SafeDownCast(caller), this->Property.c_str());
      if (title != this->Title)
      {
        this->Title = title;
        setChart(representation, title, vtkSMViewProxy::FindView(representation));
      }
    }
  }

private:
  vtkWeakPointer<vtkSMProxy> Representation;
  std::string Property;
  std::string Title;
};

void prepare(vtkSMProxy* representation)
{
  const vtkSMPropertyHelper input(representation, "Input", true);
  auto* source =
    input.GetNumberOfElements() == 1 ? vtkSMSourceProxy::SafeDownCast(input.GetAsProxy()) : nullptr;
  const auto port = source ? static_cast<int>(input.GetOutputPort()) : 0;
  if (vtkPVXMLElement* hint = source ? hintOf(source, port, "WorstMeasure") : nullptr)
  {
    colourByWorst(representation, source, hint);
  }
  if (vtkPVXMLElement* hint = source ? hintOf(source, port, "Chart") : nullptr)
  {
    vtkNew<ChartOfMeasure> chart;
    chart->Begin(representation, source, hint->GetAttribute("title"));
  }
}

// Lets what the source shows beside the cells be looked through, and hides other sources; texts stay.
void clearView(vtkSMViewProxy* view, vtkSMSourceProxy* source, vtkSMProxy* cells)
{
  vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
  const vtkSMPropertyHelper shown(view, "Representations");
  for (unsigned int i = 0; i < shown.GetNumberOfElements(); ++i)
  {
    vtkSMProxy* representation = shown.GetAsProxy(i);
    if (!representation || representation == cells ||
      !representation->GetProperty("ColorArrayName"))
    {
      continue;
    }
    if (vtkSMPropertyHelper(representation, "Input").GetAsProxy() == source)
    {
      vtkSMPropertyHelper(representation, "Opacity").Set(OpacityAroundCells);
      representation->UpdateVTKObjects();
    }
    else
    {
      controller->Hide(representation, view);
    }
  }
}

void lookAt(vtkSMRenderViewProxy* view, vtkPVDataInformation* cells)
{
  std::array<double, 6> room;
  cells->GetBounds(room.data());
  vtkPVArrayInformation* volumes =
    cells->GetCellDataInformation()->GetArrayInformation(MeasureSpecs[Volume].name);
  const double side = volumes ? std::cbrt(std::max(0.0, volumes->GetComponentRange(0)[1])) : 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    room[2 * axis] -= Around * side;
    room[2 * axis + 1] += Around * side;
  }
  view->ResetCamera(room.data());
}

void colourRed(vtkSMProxy* cells)
{
  constexpr std::array<double, 3> Red{ 0.85, 0.1, 0.1 };
  vtkSMPropertyHelper(cells, "ColorArrayName", true)
    .SetInputArrayToProcess(vtkDataObject::CELL, "");
  for (const char* colour : { "AmbientColor", "DiffuseColor" })
  {
    vtkSMPropertyHelper(cells, colour, true).Set(Red.data(), Red.size());
  }
  cells->UpdateVTKObjects();
}

void show(vtkSMSourceProxy* source, unsigned int port)
{
  source->UpdatePipeline();
  vtkPVDataInformation* cells = source->GetOutputPort(port)->GetDataInformation();
  if (cells->GetNumberOfCells() == 0)
  {
    vtkOutputWindowDisplayText("No cell fails: there are none to show.\n");
    return;
  }
  vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
  vtkSMRenderViewProxy* view = viewFor(source->GetSessionProxyManager());
  if (!view)
  {
    return;
  }
  const bool isNew = !view->FindRepresentation(source, static_cast<int>(port));
  vtkSMProxy* representation = controller->Show(source, static_cast<int>(port), view);
  if (isNew)
  {
    colourRed(representation);
  }
  clearView(view, source, representation);
  view->Update();
  lookAt(view, cells);
  view->StillRender();
}

// Of one source and its button.
class Button : public vtkCommand
{
public:
  static Button* New() { return new Button; }

  void Begin(vtkSMSourceProxy* source, vtkPVXMLElement* hint)
  {
    int port = 0;
    if (hint->GetScalarAttribute("port", &port) != 0)
    {
      this->Source = source;
      this->Property = hint->GetAttribute("property");
      this->Port = static_cast<unsigned int>(port);
      source->AddObserver(vtkCommand::UpdatePropertyEvent, this);
    }
  }

  void Execute(vtkObject* /*caller*/, unsigned long /*event*/, void* property) override
  {
    vtkSMSourceProxy* source = this->Source;
    if (source && this->Property == static_cast<const char*>(property))
    {
      show(source, this->Port);
    }
  }

private:
  vtkWeakPointer<vtkSMSourceProxy> Source;
  std::string Property;
  unsigned int Port = 0;
};

void prepareNew(vtkSMProxy* proxy, const std::string& group)
{
  auto* source = vtkSMSourceProxy::SafeDownCast(proxy);
  vtkPVXMLElement* hints = proxy->GetHints();
  vtkPVXMLElement* button = hints ? hints->FindNestedElementByName("ShowCells") : nullptr;
  if (group == "sources" && source && button)
  {
    vtkNew<Button> command;
    command->Begin(source, button);
  }
  else if (group == "representations" && !proxy->GetSessionProxyManager()->GetInLoadXMLState())
  {
    prepare(proxy);
  }
}

}

void watchQuality()
{
  onRegistered<prepareNew>();
}

}
