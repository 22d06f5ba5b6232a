// SPDX-License-Identifier: BSD-3-Clause
#include "WriterProxies.h"

#include "PortHints.h"
#include "Registration.h"
#include "TaskSources.h"

#include "vtkClientServerInterpreter.h"
#include "vtkClientServerInterpreterInitializer.h"
#include "vtkObjectFactory.h"
#include "vtkPVXMLElement.h"
#include "vtkSMInputProperty.h"
#include "vtkSMOutputPort.h"
#include "vtkSMPWriterProxy.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMStringVectorProperty.h"
#include "vtkSMVectorProperty.h"
#include "vtkSmartPointer.h"
#include "vtkVariant.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace cartesian
{

namespace
{

using Values = std::map<std::string, std::vector<vtkVariant>>; // of properties, by name

// By kind of writer.
std::map<std::string, Values>& lastWritten()
{
  static std::map<std::string, Values> values;
  return values;
}

// Those that a user sees in the dialog.
void forEachSetting(
  vtkSMProxy* writer, const std::function<void(const char*, vtkSMProperty*)>& action)
{
  vtkSmartPointer<vtkSMPropertyIterator> properties;
  properties.TakeReference(writer->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    vtkSMProperty* const property = properties->GetProperty();
    vtkPVXMLElement* const hints = property->GetHints();
    const std::string visibility = property->GetPanelVisibility();
    if (vtkSMVectorProperty::SafeDownCast(property) && !property->GetIsInternal() &&
      visibility != "never" && !(hints && hints->FindNestedElementByName("NotRemembered")))
    {
      action(properties->GetKey(), property);
    }
  }
}

Values valuesOf(vtkSMProxy* writer)
{
  Values values;
  forEachSetting(writer, [&](const char* name, vtkSMProperty* property) {
    const vtkSMPropertyHelper from(property);
    for (unsigned int i = 0; i < from.GetNumberOfElements(); ++i)
    {
      values[name].push_back(from.GetAsVariant(i));
    }
  });
  return values;
}

void setValues(vtkSMProxy* writer, Values values)
{
  forEachSetting(writer, [&](const char* name, vtkSMProperty* property) {
    vtkSMPropertyHelper to(property);
    unsigned int i = 0;
    for (const vtkVariant& value : values[name])
    {
      vtkSMStringVectorProperty::SafeDownCast(property) ? to.Set(i, value.ToString().c_str())
                                                        : to.Set(i, value.ToDouble());
      ++i;
    }
  });
}

}

}

class vtkSMRememberingWriterProxy : public vtkSMPWriterProxy
{
public:
  static vtkSMRememberingWriterProxy* New();
  vtkTypeMacro(vtkSMRememberingWriterProxy, vtkSMPWriterProxy);

  void UpdatePipeline() override
  {
    this->Superclass::UpdatePipeline();
    if (cartesian::isInWindow())
    {
      cartesian::lastWritten()[this->GetXMLName()] = cartesian::valuesOf(this);
    }
  }
  using Superclass::UpdatePipeline;

protected:
  vtkSMRememberingWriterProxy() = default;
  ~vtkSMRememberingWriterProxy() override = default;

  int ReadXMLAttributes(vtkSMSessionProxyManager* proxies, vtkPVXMLElement* element) override
  {
    const int isRead = this->Superclass::ReadXMLAttributes(proxies, element);
    this->GetProperty("FileName")
      ->AddObserver(vtkCommand::ModifiedEvent, this, &vtkSMRememberingWriterProxy::Begin);
    return isRead;
  }

private:
  // Once it has a file name: what is set before is reset to defaults, what is set after is the user's.
  void Begin()
  {
    const auto last = cartesian::lastWritten().find(this->GetXMLName());
    if (!this->HasBegun && cartesian::isInWindow() && last != cartesian::lastWritten().end())
    {
      cartesian::setValues(this, last->second);
    }
    this->HasBegun = true;
  }

  bool HasBegun = false;

  vtkSMRememberingWriterProxy(const vtkSMRememberingWriterProxy&) = delete;
  void operator=(const vtkSMRememberingWriterProxy&) = delete;
};
vtkStandardNewMacro(vtkSMRememberingWriterProxy);

class vtkSMRefusingWriterProxy : public vtkSMWriterProxy
{
public:
  static vtkSMRefusingWriterProxy* New();
  vtkTypeMacro(vtkSMRefusingWriterProxy, vtkSMWriterProxy);

  void UpdatePipeline() override
  {
    const cartesian::Output input = cartesian::inputOf(this);
    vtkErrorMacro(<< vtkSMPropertyHelper(this, "FileName").GetAsString()
                  << " is not written: the output "
                  << input.source->GetOutputPortName(static_cast<unsigned int>(input.port))
                  << " of " << cartesian::nameInBrowser(input.source)
                  << " is a surface, without cells. Select its output "
                  << input.source->GetOutputPortName(0U)
                  << " in the Pipeline Browser and save that: the boundaries are in it.");
  }
  void UpdatePipeline(double /*time*/) override { this->UpdatePipeline(); }

protected:
  vtkSMRefusingWriterProxy() = default;
  ~vtkSMRefusingWriterProxy() override = default;

private:
  vtkSMRefusingWriterProxy(const vtkSMRefusingWriterProxy&) = delete;
  void operator=(const vtkSMRefusingWriterProxy&) = delete;
};
vtkStandardNewMacro(vtkSMRefusingWriterProxy);

void cartesian::registerWriterProxies()
{
  vtkClientServerInterpreter* interpreter =
    vtkClientServerInterpreterInitializer::GetGlobalInterpreter();
  interpreter->AddNewInstanceFunction("vtkSMRememberingWriterProxy",
    [](void*) -> vtkObjectBase* { return vtkSMRememberingWriterProxy::New(); });
  interpreter->AddNewInstanceFunction("vtkSMRefusingWriterProxy",
    [](void*) -> vtkObjectBase* { return vtkSMRefusingWriterProxy::New(); });
}
