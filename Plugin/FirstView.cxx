// SPDX-License-Identifier: BSD-3-Clause
#include "FirstView.h"

#include "CategoryColours.h"
#include "PortHints.h"
#include "Registration.h"

#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTransferFunctionManager.h"

#include <algorithm>
#include <string>
#include <vector>

namespace cartesian
{

namespace
{

constexpr double LineWidthOfDefects = 4;
constexpr double ColourOfEdges = 0.25;

// The window's editor of colours does not survive those without an opacity function, as older states have them.
void completeColours(vtkSMProxy* colours)
{
  vtkSMSessionProxyManager* proxies = colours->GetSessionProxyManager();
  const char* name = proxies->GetProxyName(ColoursGroup, colours);
  const auto* array = std::find_if(std::begin(Arrays), std::end(Arrays),
    [&](const char* known) { return name && nameOfColours(known) == name; });
  vtkSMPropertyHelper opacity(colours, "ScalarOpacityFunction");
  if (array != std::end(Arrays) && !opacity.GetAsProxy())
  {
    opacity.Set(
      vtkNew<vtkSMTransferFunctionManager>()->GetOpacityTransferFunction(*array, proxies));
    colours->UpdateVTKObjects();
  }
}

vtkSMProxy* coloursOf(const std::string& array, vtkSMSessionProxyManager* proxies)
{
  return vtkNew<vtkSMTransferFunctionManager>()->GetColorTransferFunction(array.c_str(), proxies);
}

void prepareColours(vtkSMProxy* representation, vtkSMSourceProxy* source, const std::string& array)
{
  vtkSMSessionProxyManager* proxies = representation->GetSessionProxyManager();
  if (categoriesOf(source, Regions).size() > 1)
  {
    addCategories(coloursOf(Regions, proxies), source, Regions);
  }
  const std::size_t fewest = array == Boundaries ? 2 : 1;
  const bool hasColours = categoriesOf(source, array).size() >= fewest;
  if (hasColours)
  {
    addCategories(coloursOf(array, proxies), source, array);
  }
  vtkSMPropertyHelper(representation, "ColorArrayName", true)
    .SetInputArrayToProcess(vtkDataObject::CELL, hasColours ? array.c_str() : "");
  const std::vector<double> edges(3, ColourOfEdges);
  vtkSMPropertyHelper(representation, "EdgeColor", true).Set(edges.data(), 3);
  if (array == Defects)
  {
    vtkSMPropertyHelper(representation, "LineWidth", true).Set(LineWidthOfDefects);
  }
  representation->UpdateVTKObjects();
}

void prepare(vtkSMProxy* representation)
{
  const auto [source, port] = inputOf(representation);
  if (!source)
  {
    return;
  }
  if (vtkPVXMLElement* hint = hintOf(source, port, "Colours"))
  {
    prepareColours(representation, source, hint->GetAttribute("array"));
  }
}

void prepareNew(vtkSMProxy* proxy, const std::string& group)
{
  if (proxy->GetSessionProxyManager()->GetInLoadXMLState())
  {
    if (group == ColoursGroup)
    {
      completeColours(proxy);
    }
    return;
  }
  if (group == "representations")
  {
    prepare(proxy);
  }
}

}

void watchViews()
{
  onRegistered<prepareNew>();
}

}
