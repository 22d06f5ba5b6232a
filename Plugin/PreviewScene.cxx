// SPDX-License-Identifier: BSD-3-Clause
#include "PreviewScene.h"

#include "ViewCorners.h"
#include "Window.h"

#include "vtkClientServerStream.h"
#include "vtkDataObject.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSession.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"

#include <array>

namespace cartesian
{

namespace
{

// Outputs of vtkMeshPreview.
enum Output
{
  Surface = 0,
  Domain = 1,
  Labels = 2,
  Zones = 3,
};

constexpr const char* DepthArray = "Depth";
constexpr const char* LabelArray = "Label";

constexpr double LineWidth = 2;
constexpr int FontSize = 16;
constexpr int Centred = 1;
constexpr int MostLabels = 1000;

// Of depths 0, 1, ...: grey, then from blue to red and on to violet.
using Rgb = std::array<double, 3>;
constexpr std::array<Rgb, 13> ColoursOfDepths{ { { 0.75, 0.75, 0.75 }, { 0.35, 0.55, 0.9 },
  { 0.3, 0.8, 0.85 }, { 0.4, 0.75, 0.35 }, { 0.95, 0.9, 0.3 }, { 0.95, 0.6, 0.2 },
  { 0.85, 0.25, 0.2 }, { 0.8, 0.35, 0.7 }, { 0.55, 0.3, 0.75 }, { 0.35, 0.2, 0.55 },
  { 0.25, 0.25, 0.3 }, { 0.15, 0.15, 0.15 }, { 0, 0, 0 } } };

void set(vtkSMProxy* proxy, const char* property, double value)
{
  vtkSMPropertyHelper(proxy, property, true).Set(value);
}

void setText(vtkSMProxy* proxy, const char* property, const char* value)
{
  vtkSMPropertyHelper(proxy, property, true).Set(value);
}

}

PreviewScene::PreviewScene(
  vtkSMSourceProxy* preview, vtkSMProxy* source, vtkSMRenderViewProxy* view)
  : preview_(preview)
  , source_(source)
  , view_(view)
{
  vtkSMSessionProxyManager* proxies = view->GetSessionProxyManager();
  colours_.TakeReference(proxies->NewProxy("lookup_tables", "PVLookupTable"));
  set(colours_, "IndexedLookup", 1);
  set(colours_, "AnnotationsInitialized", 1);
  this->addSurface();
  this->addDomain();
  this->addLabels();
  this->addZones();
  this->addLegend();
}

PreviewScene::~PreviewScene()
{
  if (!view_)
  {
    return;
  }
  for (const auto& representation : representations_)
  {
    removeHidden(representation, view_);
  }
  this->showOthers(true);
}

vtkSMRenderViewProxy* PreviewScene::view() const
{
  return view_;
}

// Of an output; -1: of none.
vtkSMProxy* PreviewScene::add(const char* name, int port)
{
  vtkSmartPointer<vtkSMProxy> proxy;
  proxy.TakeReference(view_->GetSessionProxyManager()->NewProxy("representations", name));
  if (port >= 0)
  {
    vtkSMPropertyHelper(proxy, "Input").Set(preview_, static_cast<unsigned int>(port));
  }
  set(proxy, "Pickable", 0);
  representations_.push_back(proxy);
  return proxy;
}

void PreviewScene::addSurface()
{
  surface_ = this->add("GeometryRepresentation", Surface);
  vtkSMPropertyHelper(surface_, "ColorArrayName")
    .SetInputArrayToProcess(vtkDataObject::CELL, DepthArray);
  vtkSMPropertyHelper(surface_, "LookupTable").Set(colours_);
  addHidden(surface_, view_);
}

void PreviewScene::addDomain()
{
  vtkSMProxy* domain = this->add("GeometryRepresentation", Domain);
  set(domain, "LineWidth", LineWidth);
  setPaletteColour(domain, "AmbientColor", "ForegroundColor");
  setPaletteColour(domain, "DiffuseColor", "ForegroundColor");
  addHidden(domain, view_);
}

void PreviewScene::addLabels()
{
  vtkSMProxy* labels = this->add("DataLabelRepresentation", Labels);
  setText(labels, "PointFieldDataArrayName", LabelArray);
  set(labels, "PointLabelVisibility", 1);
  set(labels, "PointLabelFontSize", FontSize);
  set(labels, "PointLabelJustification", Centred);
  set(labels, "MaximumNumberOfLabels", MostLabels);
  setPaletteColour(labels, "PointLabelColor", "TextAnnotationColor");
  addHidden(labels, view_);
}

void PreviewScene::addZones()
{
  vtkSMProxy* zones = this->add("GeometryRepresentation", Zones);
  set(zones, "LineWidth", LineWidth);
  vtkSMPropertyHelper(zones, "ColorArrayName")
    .SetInputArrayToProcess(vtkDataObject::CELL, DepthArray);
  vtkSMPropertyHelper(zones, "LookupTable").Set(colours_);
  addHidden(zones, view_);
}

void PreviewScene::addLegend()
{
  legend_ = this->add("ScalarBarWidgetRepresentation", -1);
  vtkSMPropertyHelper(legend_, "LookupTable").Set(colours_);
  setText(legend_, "Title", "Box Size");
  setText(legend_, "ComponentTitle", "");
  set(legend_, "Visibility", 1);
  setPaletteColour(legend_, "TitleColor", "TextAnnotationColor");
  setPaletteColour(legend_, "LabelColor", "TextAnnotationColor");
  addHidden(legend_, view_);
}

// Only in the view: the user's choice, and the state, stay.
void PreviewScene::showOthers(bool shown)
{
  const auto isOf = [this](vtkSMProxy* source) {
    vtkSMProxy* input =
      source_ ? vtkSMPropertyHelper(source_, "Input", true).GetAsProxy() : nullptr;
    return source && (source == source_ || source == input);
  };
  const vtkSMPropertyHelper all(view_, "Representations");
  for (unsigned int i = 0; i < all.GetNumberOfElements(); ++i)
  {
    vtkSMProxy* other = all.GetAsProxy(i);
    if (other && other->GetProperty("Visibility") && other->GetProperty("Input") &&
      isOf(vtkSMPropertyHelper(other, "Input").GetAsProxy()))
    {
      const int visible = shown ? vtkSMPropertyHelper(other, "Visibility").GetAsInt() : 0;
      vtkClientServerStream command;
      command << vtkClientServerStream::Invoke << VTKOBJECT(other) << "SetVisibility" << visible
              << vtkClientServerStream::End;
      other->GetSession()->ExecuteStream(other->GetLocation(), command);
      other->MarkDirty(nullptr);
    }
  }
}

// The legend: what sizes boxes have.
void PreviewScene::nameSizes()
{
  preview_->UpdatePropertyInformation(preview_->GetProperty("BoxSizes"));
  const vtkSMPropertyHelper sizes(preview_, "BoxSizes");
  vtkSMPropertyHelper annotations(colours_, "Annotations");
  vtkSMPropertyHelper colours(colours_, "IndexedColors");
  annotations.SetNumberOfElements(sizes.GetNumberOfElements());
  colours.SetNumberOfElements(sizes.GetNumberOfElements() / 2 * 3);
  for (unsigned int i = 0; i + 1 < sizes.GetNumberOfElements(); i += 2)
  {
    annotations.Set(i, sizes.GetAsString(i));
    annotations.Set(i + 1,
      (std::string(sizes.GetAsString(i + 1)) + " (depth " + sizes.GetAsString(i) + ")").c_str());
    const Rgb& rgb = ColoursOfDepths.at(static_cast<std::size_t>(std::stoi(sizes.GetAsString(i))));
    for (unsigned int c = 0; c < 3; ++c)
    {
      colours.Set(i / 2 * 3 + c, rgb[c]);
    }
  }
  colours_->UpdateVTKObjects();
  set(legend_, "Visibility", sizes.GetNumberOfElements() > 0 ? 1 : 0);
  set(legend_, "WindowLocation",
    freeCorner(view_, legend_, { UpperRight, LowerRight, UpperLeft, UpperCentre, LowerCentre }));
  legend_->UpdateVTKObjects();
}

bool PreviewScene::has(int output) const
{
  return preview_->GetDataInformation(static_cast<unsigned int>(output))->GetNumberOfCells() > 0;
}

bool PreviewScene::hasSeveralDepths() const
{
  vtkPVArrayInformation* const depths =
    preview_->GetDataInformation(Surface)->GetArrayInformation(DepthArray, vtkDataObject::CELL);
  const double* const range = depths ? depths->GetComponentRange(0) : nullptr;
  return range && range[0] < range[1];
}

void PreviewScene::draw()
{
  preview_->UpdatePipeline();
  this->nameSizes();
  // All in one colour would hide those of boundaries, which tables of these are filled in by.
  const bool several = this->hasSeveralDepths();
  set(surface_, "Visibility", several ? 1 : 0);
  surface_->UpdateVTKObjects();
  this->showOthers(!several);
  // A flow domain is much larger than what was in view.
  const bool isNew = this->has(Domain) && !hadDomain_;
  hadDomain_ = this->has(Domain);
  static_cast<vtkSMProxy*>(view_)->MarkDirty(nullptr);
  if (isNew)
  {
    view_->Update();
    view_->ResetCamera();
  }
  view_->StillRender();
}

}
