// SPDX-License-Identifier: BSD-3-Clause
#include "TaskCad.h"

#include "TaskSources.h"

#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <stdexcept>
#include <vector>

namespace cartesian
{

namespace
{

// Those whose files a task names: of a refinement region that is a box or a sphere, the input is none of them.
void collectReaders(vtkSMProxy* proxy, std::vector<vtkSMProxy*>& readers)
{
  if (isCadReader(proxy))
  {
    if (std::find(readers.begin(), readers.end(), proxy) == readers.end())
    {
      readers.push_back(proxy);
    }
    return;
  }
  if (std::strcmp(proxy->GetXMLName(), "RefinementRegion") == 0 &&
    vtkSMPropertyHelper(proxy, "Shape").GetAsInt() != InputShape)
  {
    return;
  }
  for (unsigned int i = 0; i < proxy->GetNumberOfProducers(); ++i)
  {
    collectReaders(proxy->GetProducerProxy(i), readers);
  }
}

// Whether a task derives it from the cell size (Task/task.py).
bool isDeflectionOfCells(vtkSMProxy* mesher)
{
  const auto isEmpty = [&](const char* lines) {
    return vtkSMPropertyHelper(mesher, lines).GetNumberOfElements() == 0;
  };
  return vtkSMPropertyHelper(mesher, "CellSize").GetAsDouble() > 0 && isEmpty("MeshlinesX") &&
    isEmpty("MeshlinesY") && isEmpty("MeshlinesZ");
}

// What became of the default, which depends on the file.
double deflectionOf(vtkSMProxy* reader, const std::string& input)
{
  auto* const source = vtkSMSourceProxy::SafeDownCast(reader);
  source->UpdatePipeline();
  vtkPVArrayInformation* const array =
    source->GetDataInformation()->GetFieldDataInformation()->GetArrayInformation("Deflection");
  if (!array)
  {
    refuse(reader, "cannot be read, so that its Deflection is not known", input);
  }
  return array->GetComponentRange(0)[0];
}

[[noreturn]] void refuseDifferent(vtkSMProxy* reader, const std::string& setting, vtkSMProxy* other)
{
  throw std::runtime_error(nameInBrowser(reader) + " has another " + setting + " than " +
    nameInBrowser(other) +
    ", and a task reads all CAD files alike: give both the same, or save the output of one (File > "
    "Save Data) "
    "and open that file instead.");
}

}

bool isCadReader(vtkSMProxy* source)
{
  return std::strcmp(source->GetXMLName(), "CADReader") == 0;
}

TaskTable cadTable(vtkSMProxy* mesher)
{
  TaskTable table{ "cad", false, {} };
  std::vector<vtkSMProxy*> readers;
  collectReaders(mesher, readers);
  if (readers.empty())
  {
    return table;
  }
  const std::string input = "Input of " + nameInBrowser(mesher);
  vtkSMProxy* const first = readers.front();
  for (vtkSMProxy* const reader : readers)
  {
    if (const std::string setting = differingSetting(reader, first); !setting.empty())
    {
      refuseDifferent(reader, setting, first);
    }
  }
  for (const TaskTable& group : tablesOf(first))
  {
    std::copy_if(group.entries.begin(), group.entries.end(), std::back_inserter(table.entries),
      [](const auto& entry) { return entry.first != "file_name"; });
  }
  if (!hasDefault(first, "Deflection") || !isDeflectionOfCells(mesher))
  {
    return table;
  }
  const double deflection = deflectionOf(first, input);
  for (vtkSMProxy* const reader : readers)
  {
    if (deflectionOf(reader, input) != deflection)
    {
      refuseDifferent(reader, "Deflection (its default depends on the size)", first);
    }
  }
  table.entries.emplace_back("deflection", tomlNumber(deflection));
  return table;
}

}
