// SPDX-License-Identifier: BSD-3-Clause
#include "TaskSources.h"

#include "TaskCad.h"
#include "TaskTables.h"

#include "vtkNew.h"
#include "vtkPVXMLElement.h"
#include "vtkSMCoreUtilities.h"
#include "vtkSMParaViewPipelineController.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyManager.h"
#include "vtkSMReaderFactory.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMVectorProperty.h"
#include "vtkSmartPointer.h"

#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace cartesian
{

void refuse(vtkSMProxy* source, const std::string& why, const std::string& input)
{
  throw std::runtime_error(nameInBrowser(source) + " " + why +
    ": save its output (File > Save Data), open that file, and make it the " + input + ".");
}

std::string differingSetting(vtkSMProxy* reader, vtkSMProxy* other)
{
  const std::string file = vtkSMCoreUtilities::GetFileNameProperty(reader);
  vtkSmartPointer<vtkSMPropertyIterator> properties;
  properties.TakeReference(reader->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    vtkSMProperty* const property = properties->GetProperty();
    if (vtkSMVectorProperty::SafeDownCast(property) && property->GetInformationOnly() == 0 &&
      !property->GetIsInternal() && file != properties->GetKey() &&
      valueOf(property) != valueOf(other->GetProperty(properties->GetKey())))
    {
      return property->GetXMLLabel();
    }
  }
  return "";
}

namespace
{

// As ParaView opens that file by itself.
vtkSmartPointer<vtkSMProxy> usualReader(vtkSMProxy* reader, const std::string& file)
{
  vtkSMReaderFactory* const readers = vtkSMProxyManager::GetProxyManager()->GetReaderFactory();
  if (!readers->CanReadFile(file.c_str(), reader->GetSession()))
  {
    return nullptr;
  }
  vtkSmartPointer<vtkSMProxy> usual;
  usual.TakeReference(reader->GetSessionProxyManager()->NewProxy(
    readers->GetReaderGroup(), readers->GetReaderName()));
  vtkNew<vtkSMParaViewPipelineController> controller;
  controller->PreInitializeProxy(usual);
  vtkSMPropertyHelper(usual, vtkSMCoreUtilities::GetFileNameProperty(usual)).Set(file.c_str());
  controller->PostInitializeProxy(usual);
  return usual;
}

}

std::string nameInBrowser(vtkSMProxy* source)
{
  const char* const name = source->GetSessionProxyManager()->GetProxyName("sources", source);
  return (name ? std::string(name) + " (" : "(") + source->GetXMLLabel() + ")";
}

std::string fileOf(vtkSMProxy* source, unsigned int port, const std::string& input)
{
  vtkPVXMLElement* const hints = source->GetHints();
  const char* const property = hints && hints->FindNestedElementByName("ReaderFactory")
    ? vtkSMCoreUtilities::GetFileNameProperty(source)
    : nullptr;
  if (!property || port > 0)
  {
    refuse(source, "is not a file that was opened, and a task names files only", input);
  }
  const vtkSMPropertyHelper names(source, property);
  if (names.GetNumberOfElements() != 1)
  {
    refuse(source, "reads several files, of which a task cannot choose one", input);
  }
  vtkSMProperty* const times = source->GetProperty("TimestepValues");
  if (times && vtkSMPropertyHelper(times).GetNumberOfElements() > 1)
  {
    refuse(source, "has several time steps, of which a task cannot choose one", input);
  }
  const std::string file = std::filesystem::absolute(names.GetAsString(0)).string();
  const vtkSmartPointer<vtkSMProxy> usual = usualReader(source, file);
  if (!usual || std::strcmp(usual->GetXMLName(), source->GetXMLName()) != 0)
  {
    refuse(source,
      std::string("is opened with ") + source->GetXMLLabel() +
        ", which is not what a task takes (" + (usual ? usual->GetXMLLabel() : "none") + ")",
      input);
  }
  const std::string label = isCadReader(source) ? "" : differingSetting(source, usual);
  if (!label.empty())
  {
    refuse(
      source, "has another " + label + " than a file just opened, which a task cannot say", input);
  }
  return file;
}

std::vector<TaskFile> filesOf(vtkSMProxy* source, unsigned int port, const std::string& input)
{
  if (std::strcmp(source->GetXMLName(), "GroupDataSets") != 0)
  {
    return { { fileOf(source, port, input), "" } };
  }
  if (!hasDefault(source, "OutputType"))
  {
    refuse(source, "has another Output Type than its default, which a task cannot say", input);
  }
  const vtkSMPropertyHelper inputs(source, "Input");
  const vtkSMPropertyHelper names(source, "BlockNames");
  std::vector<TaskFile> files;
  for (unsigned int i = 0; i < inputs.GetNumberOfElements(); ++i)
  {
    files.push_back({ fileOf(inputs.GetAsProxy(i), inputs.GetOutputPort(i), input),
      i < names.GetNumberOfElements() ? names.GetAsString(i) : "" });
  }
  return files;
}

}
