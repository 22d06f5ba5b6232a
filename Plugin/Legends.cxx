// SPDX-License-Identifier: BSD-3-Clause
#include "Legends.h"

#include "Base/Words.h"
#include "CategoryColours.h"
#include "Quality/QualityMeasures.h"
#include "Registration.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace cartesian
{

namespace
{

// With more names than MostNames it has none, as they would hide the view.
constexpr unsigned int MostLargeNames = 8;
constexpr unsigned int MostNames = 24;
constexpr int SmallFont = 12;
constexpr double LongLegend = 0.5; // of the view

bool isNamed(const std::string& array)
{
  return std::find(Arrays.begin(), Arrays.end(), array) != Arrays.end();
}

bool isMeasure(const std::string& array)
{
  return array == "RefinementLevel" ||
    std::any_of(MeasureSpecs.begin(), MeasureSpecs.end(),
      [&](const MeasureSpec& spec) { return array == spec.name; });
}

// In words; BoundaryName: Boundary.
std::string titleOf(const std::string& array)
{
  return wordsOf(array.substr(0, array.rfind("Name")));
}

// ParaView makes a range of it, by a few roundings.
bool isSingle(double first, double last)
{
  constexpr double Roundings = 5e-4;
  return last - first <= Roundings * std::abs(first) || last < 1e-30;
}

// Of one legend of a measure.
class SingleValue : public vtkCommand
{
public:
  static SingleValue* New() { return new SingleValue; }

  void Begin(vtkSMProxy* legend, vtkSMProxy* colours)
  {
    this->Legend = legend;
    colours->GetProperty("RGBPoints")->AddObserver(vtkCommand::ModifiedEvent, this);
    this->Execute(colours->GetProperty("RGBPoints"), vtkCommand::ModifiedEvent, nullptr);
  }

  void Execute(vtkObject* points, unsigned long /*event*/, void* /*data*/) override
  {
    constexpr std::size_t PerPoint = 4; // value, red, green, blue
    const std::vector<double> all =
      vtkSMPropertyHelper(vtkSMProperty::SafeDownCast(points)).GetDoubleArray();
    if (!this->Legend || all.size() < PerPoint)
    {
      return;
    }
    const double value = all.front();
    const bool isOne = isSingle(value, all[all.size() - PerPoint]);
    if (isOne || this->IsOne)
    {
      vtkSMPropertyHelper(this->Legend, "UseCustomLabels").Set(isOne ? 1 : 0);
      vtkSMPropertyHelper(this->Legend, "CustomLabels").Set(&value, isOne ? 1 : 0);
      vtkSMPropertyHelper(this->Legend, "AddRangeLabels").Set(isOne ? 0 : 1);
      this->Legend->UpdateVTKObjects();
    }
    this->IsOne = isOne;
  }

private:
  vtkWeakPointer<vtkSMProxy> Legend;
  bool IsOne = false;
};

void fitNames(vtkSMProxy* legend, unsigned int names)
{
  if (names > MostLargeNames)
  {
    vtkSMPropertyHelper(legend, "LabelFontSize").Set(SmallFont);
    vtkSMPropertyHelper(legend, "ScalarBarLength").Set(LongLegend);
    vtkSMPropertyHelper(legend, "DrawAnnotations").Set(names > MostNames ? 0 : 1);
  }
}

void prepareLegend(vtkSMProxy* legend, const std::string& group)
{
  vtkSMSessionProxyManager* const proxies = legend->GetSessionProxyManager();
  vtkSMProxy* const colours = group == "scalar_bars" && !proxies->GetInLoadXMLState()
    ? vtkSMPropertyHelper(legend, "LookupTable", true).GetAsProxy()
    : nullptr;
  const char* const registered = colours ? proxies->GetProxyName(ColoursGroup, colours) : nullptr;
  const std::string name = registered ? registered : "";
  const std::string array = name.substr(0, name.find('.'));
  if (!isNamed(array) && !isMeasure(array))
  {
    return;
  }
  vtkSMPropertyHelper(legend, "Title").Set(titleOf(array).c_str());
  vtkSMPropertyHelper(legend, "ComponentTitle").Set("");
  if (isNamed(array))
  {
    fitNames(legend, vtkSMPropertyHelper(colours, "Annotations").GetNumberOfElements() / 2);
  }
  else
  {
    vtkNew<SingleValue>()->Begin(legend, colours);
  }
  legend->UpdateVTKObjects();
}

}

void watchLegends()
{
  onRegistered<prepareLegend>();
}

}
