// SPDX-License-Identifier: BSD-3-Clause
#include "OutputsDomain.h"

#include "vtkClientServerInterpreter.h"
#include "vtkClientServerInterpreterInitializer.h"
#include "vtkObjectFactory.h"
#include "vtkPVXMLElement.h"
#include "vtkSMDomain.h"
#include "vtkSMProxy.h"
#include "vtkSMUncheckedPropertyHelper.h"

#include <set>
#include <sstream>
#include <string>

class vtkSMOutputsDomain : public vtkSMDomain
{
public:
  static vtkSMOutputsDomain* New();
  vtkTypeMacro(vtkSMOutputsDomain, vtkSMDomain);

  int IsInDomain(vtkSMProperty* property) override
  {
    const vtkSMUncheckedPropertyHelper input(property);
    vtkSMProxy* const source = input.GetNumberOfElements() == 1 ? input.GetAsProxy() : nullptr;
    return source && this->Names.count(source->GetXMLName()) == 1 &&
        input.GetOutputPort() >= this->First
      ? vtkSMDomain::IN_DOMAIN
      : vtkSMDomain::NOT_IN_DOMAIN;
  }

protected:
  vtkSMOutputsDomain() = default;
  ~vtkSMOutputsDomain() override = default;

  int ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element) override
  {
    std::istringstream names(element->GetAttributeOrEmpty("of"));
    for (std::string name; names >> name;)
    {
      this->Names.insert(name);
    }
    int first = 0;
    element->GetScalarAttribute("first", &first);
    this->First = static_cast<unsigned int>(first);
    return this->Superclass::ReadXMLAttributes(property, element);
  }

private:
  vtkSMOutputsDomain(const vtkSMOutputsDomain&) = delete;
  void operator=(const vtkSMOutputsDomain&) = delete;

  std::set<std::string> Names;
  unsigned int First = 0;
};
vtkStandardNewMacro(vtkSMOutputsDomain);

void cartesian::registerOutputsDomain()
{
  vtkClientServerInterpreterInitializer::GetGlobalInterpreter()->AddNewInstanceFunction(
    "vtkSMOutputsDomain", [](void*) -> vtkObjectBase* { return vtkSMOutputsDomain::New(); });
}
