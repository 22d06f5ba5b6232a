// SPDX-License-Identifier: BSD-3-Clause
#include "WriterProxies.h"

#include "CaseProposal.h"
#include "PortHints.h"
#include "Registration.h"
#include "Scripts.h"
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
#include <utility>
#include <vector>

namespace cartesian
{

namespace
{

using Values = std::map<std::string, std::vector<vtkVariant>>; // of properties, by name

// By kind of writer and mesh.
using Written = std::pair<std::string, std::string>;

std::map<Written, Values>& lastWritten()
{
  static std::map<Written, Values> values;
  return values;
}

Written keyOf(vtkSMProxy* writer)
{
  const Output mesh = inputOf(writer);
  return { writer->GetXMLName(),
    mesh.source ? std::string(mesh.source->GetGlobalIDAsString()) + ":" + std::to_string(mesh.port)
                : "" };
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

void setValues(vtkSMProxy* writer, const Values& values)
{
  forEachSetting(writer, [&](const char* name, vtkSMProperty* property) {
    vtkSMPropertyHelper to(property);
    unsigned int i = 0;
    const auto found = values.find(name);
    for (const vtkVariant& value :
      found == values.end() ? std::vector<vtkVariant>{} : found->second)
    {
      vtkSMStringVectorProperty::SafeDownCast(property) ? to.Set(i, value.ToString().c_str())
                                                        : to.Set(i, value.ToDouble());
      ++i;
    }
  });
}

}

bool recallSettings(vtkSMProxy* writer)
{
  const auto last = lastWritten().find(keyOf(writer));
  if (last == lastWritten().end())
  {
    return false;
  }
  setValues(writer, last->second);
  return true;
}

}

class vtkSMRememberingWriterProxy : public vtkSMPWriterProxy
{
public:
  static vtkSMRememberingWriterProxy* New();
  vtkTypeMacro(vtkSMRememberingWriterProxy, vtkSMPWriterProxy);

  void UpdatePipeline() override
  {
    vtkSMPropertyHelper file(this, "FileName");
    const std::string chosen = file.GetAsString();
    const bool isNew = vtkSMPropertyHelper(this, "NewFolder").GetAsInt() != 0;
    file.Set((isNew ? cartesian::inNewFolder(chosen) : chosen).c_str());
    this->UpdateVTKObjects();
    this->Superclass::UpdatePipeline();
    file.Set(chosen.c_str());
    if (cartesian::isInWindow())
    {
      cartesian::lastWritten()[cartesian::keyOf(this)] = cartesian::valuesOf(this);
    }
  }
  using Superclass::UpdatePipeline;

protected:
  vtkSMRememberingWriterProxy() = default;
  ~vtkSMRememberingWriterProxy() override = default;

  int ReadXMLAttributes(vtkSMSessionProxyManager* proxies, vtkPVXMLElement* element) override
  {
    const int isRead = this->Superclass::ReadXMLAttributes(proxies, element);
    for (const char* name : { "FileName", "Input" })
    {
      this->GetProperty(name)->AddObserver(
        vtkCommand::ModifiedEvent, this, &vtkSMRememberingWriterProxy::Begin);
    }
    return isRead;
  }

private:
  // Once it has a file name and a mesh: what is set before is reset to defaults, what is set after is the user's.
  void Begin()
  {
    if (this->HasBegun || !cartesian::inputOf(this).source ||
      std::string(vtkSMPropertyHelper(this, "FileName").GetAsString()).empty())
    {
      return;
    }
    this->HasBegun = true;
    if (cartesian::isInWindow() && !cartesian::isInScript())
    {
      cartesian::proposeFolder(this);
      if (!cartesian::recallSettings(this))
      {
        cartesian::proposeSetup(this);
      }
    }
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
