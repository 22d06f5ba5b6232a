// SPDX-License-Identifier: BSD-3-Clause
#include "PanelTold.h"

#include "Registration.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkSMSourceProxy.h"

#include <array>
#include <string>

namespace cartesian
{

namespace
{

constexpr std::array<const char*, 4> Told{ "FoundBoundaries", "FoundSolids", "Findings", "Made" };

class Asking : public vtkCommand
{
public:
  static Asking* New() { return new Asking; }

  void Execute(vtkObject* caller, unsigned long /*event*/, void* /*data*/) override
  {
    auto* const source = vtkSMSourceProxy::SafeDownCast(caller);
    for (const char* told : Told)
    {
      if (vtkSMProperty* const property = source->GetProperty(told))
      {
        source->UpdatePropertyInformation(property);
      }
    }
  }
};

void watchSource(vtkSMProxy* source, const std::string& group)
{
  bool tells = false;
  for (const char* told : Told)
  {
    tells = tells || source->GetProperty(told);
  }
  if (group == "sources" && tells)
  {
    source->AddObserver(vtkCommand::UpdateDataEvent, vtkNew<Asking>());
  }
}

}

void watchTold()
{
  onRegistered<watchSource>();
}

}
