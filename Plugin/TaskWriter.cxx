// SPDX-License-Identifier: BSD-3-Clause
#include "TaskWriter.h"

#include "TaskCad.h"
#include "TaskSources.h"
#include "TaskTables.h"
#include "WriterProxies.h"

#include "vtkClientServerInterpreter.h"
#include "vtkClientServerInterpreterInitializer.h"
#include "vtkClientServerStream.h"
#include "vtkObjectFactory.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMWriterProxy.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <stdexcept>
#include <string>

namespace cartesian
{

namespace
{

// As a task file names it: relative to its folder, if the file is in there.
std::string fromTask(const std::string& path, const std::string& task)
{
  const std::filesystem::path relative =
    std::filesystem::path(path).lexically_relative(std::filesystem::path(task).parent_path());
  return relative.empty() || *relative.begin() == ".." ? path : relative.generic_string();
}

std::string list(const std::vector<std::string>& texts)
{
  std::string all;
  for (const std::string& text : texts)
  {
    all += (all.empty() ? "" : ", ") + tomlText(text);
  }
  return "[" + all + "]";
}

// One Split Surface: a table, and those of its rows.
std::vector<TaskTable> splitOf(vtkSMProxy* split, const std::string& input)
{
  if (vtkSMPropertyHelper(split, "Selection").GetAsProxy())
  {
    refuse(split, "has a Selection, which a task cannot say: use Selected Cells", input);
  }
  constexpr std::array<const char*, 2> NotInTasks{ "split_by", "number_of_threads" };
  // Also where it is the default: an empty table would not be written.
  std::vector<TaskTable> tables{ { "surface.split", true,
    { { "split_by", valueOf(split->GetProperty("SplitBy")) } } } };
  for (const TaskTable& table : tablesOf(split))
  {
    if (table.isRow)
    {
      tables.push_back({ "surface.split." + table.name, true, table.entries });
      continue;
    }
    std::copy_if(table.entries.begin(), table.entries.end(),
      std::back_inserter(tables.front().entries), [&](const auto& entry) {
        return std::find(NotInTasks.begin(), NotInTasks.end(), entry.first) == NotInTasks.end();
      });
  }
  return tables;
}

void addSurface(std::vector<TaskTable>& tables, vtkSMProxy* mesher, const std::string& task)
{
  const vtkSMPropertyHelper input(mesher, "Input");
  const std::string of = "Input of " + nameInBrowser(mesher);
  vtkSMProxy* source = input.GetAsProxy();
  unsigned int port = input.GetOutputPort();
  std::vector<TaskTable> splits;
  while (std::strcmp(source->GetXMLName(), "SplitSurface") == 0)
  {
    const std::vector<TaskTable> before = splitOf(source, of);
    splits.insert(splits.begin(), before.begin(), before.end());
    const vtkSMPropertyHelper next(source, "Input");
    port = next.GetOutputPort();
    source = next.GetAsProxy();
  }
  const std::vector<TaskFile> files = filesOf(source, port, of);
  std::vector<std::string> paths;
  std::vector<std::string> names;
  bool areStems = true;
  for (const TaskFile& file : files)
  {
    paths.push_back(fromTask(file.path, task));
    names.push_back(file.name);
    areStems = areStems && file.name == std::filesystem::path(file.path).stem().string();
  }
  auto& entries = tableCalled(tables, "surface").entries;
  const bool areBlocks = !files.front().name.empty();
  if (areBlocks && (!areStems || files.size() == 1))
  {
    entries.emplace(entries.begin(), "names", list(names));
  }
  // A task with a target y+ and no unit is older than units.
  if (vtkSMPropertyHelper(mesher, "TargetYPlus").GetAsDouble() > 0 &&
    vtkSMPropertyHelper(mesher, "LengthUnit").GetAsInt() == 0)
  {
    entries.emplace_back("length_unit", tomlText("From Input"));
  }
  entries.emplace(entries.begin(), "file", areBlocks ? list(paths) : tomlText(paths.front()));
  tables.insert(tables.end(), splits.begin(), splits.end());
}

void addSizeField(std::vector<TaskTable>& tables, vtkSMProxy* mesher, const std::string& task)
{
  const vtkSMPropertyHelper field(mesher, "SizeField");
  if (field.GetNumberOfElements() > 0 && field.GetAsProxy())
  {
    const std::string path =
      fileOf(field.GetAsProxy(), field.GetOutputPort(), "Size Field of " + nameInBrowser(mesher));
    tableCalled(tables, "refinement")
      .entries.emplace_back("size_field", tomlText(fromTask(path, task)));
  }
}

// A zone of a shape, or of a file; `depth`: of those that have none of their own.
TaskTable zoneOf(vtkSMProxy* zone, unsigned int port, vtkSMProperty* depth,
  const std::string& input, const std::string& task)
{
  TaskTable table{ "regions", true, {} };
  const auto add = [&](vtkSMProperty* property) {
    table.entries.emplace_back(keyOf(property->GetXMLLabel()), valueOf(property));
  };
  const bool isRegion = std::strcmp(zone->GetXMLName(), "RefinementRegion") == 0;
  const auto addFile = [&](const std::string& path) {
    table.entries.emplace_back("file", tomlText(fromTask(path, task)));
  };
  if (!isRegion)
  {
    addFile(fileOf(zone, port, input));
  }
  else if (vtkSMPropertyHelper(zone, "Shape").GetAsInt() == InputShape)
  {
    const vtkSMPropertyHelper surface(zone, "Input");
    addFile(
      fileOf(surface.GetAsProxy(), surface.GetOutputPort(), "Input of " + nameInBrowser(zone)));
  }
  else
  {
    add(zone->GetProperty("Shape"));
    const bool isBox = vtkSMPropertyHelper(zone, "Shape").GetAsInt() == 0;
    for (const char* place : isBox ? std::vector<const char*>{ "Position", "Rotation", "Length" }
                                   : std::vector<const char*>{ "Center", "Radius" })
    {
      add(zone->GetProperty(place));
    }
  }
  vtkSMProperty* const own = isRegion ? zone->GetProperty("Depth") : depth;
  table.entries.emplace_back("depth", valueOf(own));
  return table;
}

void addZones(std::vector<TaskTable>& tables, vtkSMProxy* mesher, const std::string& task)
{
  const vtkSMPropertyHelper zones(mesher, "RefinementRegions");
  for (unsigned int i = 0; i < zones.GetNumberOfElements(); ++i)
  {
    tables.push_back(zoneOf(zones.GetAsProxy(i), zones.GetOutputPort(i),
      mesher->GetProperty("RegionDepth"), "Refinement Regions of " + nameInBrowser(mesher), task));
  }
}

// The settings of the case that the window saved last of the mesh, in [case] and its tables of rows; none: the defaults.
std::vector<TaskTable> caseOf(vtkSMProxy* mesher)
{
  vtkSmartPointer<vtkSMProxy> writer;
  writer.TakeReference(mesher->GetSessionProxyManager()->NewProxy("writers", "PolyMeshWriter"));
  vtkSMPropertyHelper(writer, "Input").Set(mesher, 0);
  recallSettings(writer);
  std::vector<TaskTable> tables{ { "case", false, {} } };
  for (const TaskTable& table : tablesOf(writer))
  {
    if (table.isRow)
    {
      tables.push_back(table);
      continue;
    }
    std::copy_if(table.entries.begin(), table.entries.end(),
      std::back_inserter(tables.front().entries),
      [](const auto& entry) { return entry.first != "file_name" && entry.first != "pieces"; });
  }
  return tables;
}

// The whole task; throws std::runtime_error where a task cannot say what there is.
std::string taskOf(vtkSMProxy* mesher, const std::string& task)
{
  std::vector<TaskTable> tables = tablesOf(mesher);
  addSurface(tables, mesher, task);
  addSizeField(tables, mesher, task);
  addZones(tables, mesher, task);
  const std::filesystem::path file(task);
  const std::string stem = file.stem().string();
  const std::vector<TaskTable> ofCase = caseOf(mesher);
  tables.push_back({ "output", false,
    { { "mesh",
      ofCase.front().entries.empty() ? tomlText(stem + ".vtu")
                                     : list({ stem + ".vtu", stem + "/case.foam" }) } } });
  tables.insert(tables.end(), ofCase.begin(), ofCase.end());
  tables.push_back(cadTable(mesher));
  return "# The settings of " + nameInBrowser(mesher) + ". cartesian-mesher " +
    file.filename().string() +
    " makes the same mesh; cartesian-mesher --template explains all keys.\n" + textOf(tables);
}

}

}

class vtkSMTaskWriterProxy : public vtkSMWriterProxy
{
public:
  static vtkSMTaskWriterProxy* New();
  vtkTypeMacro(vtkSMTaskWriterProxy, vtkSMWriterProxy);

  // The superclass would update the mesh.
  void UpdatePipeline() override
  {
    const std::string file =
      std::filesystem::absolute(vtkSMPropertyHelper(this, "FileName").GetAsString()).string();
    try
    {
      const std::string text =
        cartesian::taskOf(vtkSMPropertyHelper(this, "Input").GetAsProxy(), file);
      vtkSMPropertyHelper(this, "Text").Set(text.c_str());
    }
    catch (const std::runtime_error& error)
    {
      vtkErrorMacro(<< file << " is not written. " << error.what());
      return;
    }
    this->UpdateVTKObjects();
    vtkClientServerStream stream;
    stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "Write"
           << vtkClientServerStream::End;
    this->ExecuteStream(stream);
  }
  void UpdatePipeline(double /*time*/) override { this->UpdatePipeline(); }

protected:
  vtkSMTaskWriterProxy() = default;
  ~vtkSMTaskWriterProxy() override = default;

private:
  vtkSMTaskWriterProxy(const vtkSMTaskWriterProxy&) = delete;
  void operator=(const vtkSMTaskWriterProxy&) = delete;
};
vtkStandardNewMacro(vtkSMTaskWriterProxy);

void cartesian::registerTaskWriter()
{
  vtkClientServerInterpreterInitializer::GetGlobalInterpreter()->AddNewInstanceFunction(
    "vtkSMTaskWriterProxy", [](void*) -> vtkObjectBase* { return vtkSMTaskWriterProxy::New(); });
}
