// SPDX-License-Identifier: BSD-3-Clause
#include "RenewedNames.h"

#include "CategoryColours.h"
#include "Registration.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkSMProxyIterator.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"

#include <map>
#include <set>
#include <string>
#include <utility>

namespace cartesian
{

namespace
{

// Values of an array that any source has now.
std::set<std::string> valuesOfAll(const std::string& array, vtkSMSessionProxyManager* proxies)
{
  std::set<std::string> values;
  vtkNew<vtkSMProxyIterator> sources;
  sources->SetSessionProxyManager(proxies);
  sources->SetModeToOneGroup();
  for (sources->Begin("sources"); !sources->IsAtEnd(); sources->Next())
  {
    if (sources->GetProxy()->GetProperty("LegendInfo"))
    {
      for (const Category& category : categoriesOf(sources->GetProxy(), array))
      {
        values.insert(category.value);
      }
    }
  }
  return values;
}

// Of one source.
class Renewal : public vtkCommand
{
public:
  static Renewal* New() { return new Renewal; }

  void Execute(vtkObject* caller, unsigned long /*event*/, void* /*data*/) override
  {
    auto* source = vtkSMSourceProxy::SafeDownCast(caller);
    vtkSMSessionProxyManager* proxies = source->GetSessionProxyManager();
    for (const char* array : Arrays)
    {
      const std::set<std::string> gone = this->Gone(array, source);
      if (vtkSMProxy* colours = proxies->GetProxy(ColoursGroup, nameOfColours(array).c_str()))
      {
        removeCategories(colours, gone);
        addCategories(colours, source, array);
      }
    }
  }

private:
  // Values that were there before the last update.
  std::set<std::string> Gone(const std::string& array, vtkSMProxy* source)
  {
    std::set<std::string> gone;
    std::swap(gone, this->Had[array]);
    for (const Category& category : categoriesOf(source, array))
    {
      this->Had[array].insert(category.value);
    }
    for (const std::string& value : valuesOfAll(array, source->GetSessionProxyManager()))
    {
      gone.erase(value);
    }
    return gone;
  }

  std::map<std::string, std::set<std::string>> Had; // values of arrays
};

void watchSource(vtkSMProxy* source, const std::string& group)
{
  if (group == "sources" && source->GetProperty("LegendInfo"))
  {
    source->AddObserver(vtkCommand::UpdateDataEvent, vtkNew<Renewal>());
  }
}

}

void watchNames()
{
  onRegistered<watchSource>();
}

}
