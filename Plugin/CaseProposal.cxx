// SPDX-License-Identifier: BSD-3-Clause
#include "CaseProposal.h"

#include "CategoryColours.h"
#include "PortHints.h"

#include "vtkCollection.h"
#include "vtkNew.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkPVFileInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <vector>

namespace cartesian
{

namespace
{

// Values of the property SolverSetup, and of RegionsAs.
constexpr int Incompressible = 1;
constexpr int ConjugateHeat = 2;
constexpr int Zones = 1;

// Of the files and folders in a folder of the server, but hidden ones.
std::set<std::string> namesIn(const std::string& folder, vtkSMSessionProxyManager* proxies)
{
  vtkSmartPointer<vtkSMProxy> helper;
  helper.TakeReference(proxies->NewProxy("misc", "FileInformationHelper"));
  vtkSMPropertyHelper(helper, "Path").Set(folder.c_str());
  vtkSMPropertyHelper(helper, "DirectoryListing").Set(1);
  helper->UpdateVTKObjects();
  vtkNew<vtkPVFileInformation> found;
  found->Initialize();
  helper->GatherInformation(found);
  std::set<std::string> names;
  vtkCollection* const contents = found->GetContents();
  for (int i = 0; i < contents->GetNumberOfItems(); ++i)
  {
    const std::string name =
      vtkPVFileInformation::SafeDownCast(contents->GetItemAsObject(i))->GetName();
    if (!name.empty() && name.front() != '.')
    {
      names.insert(name);
    }
  }
  return names;
}

std::filesystem::path fileOf(vtkSMProxy* writer)
{
  return std::filesystem::u8path(vtkSMPropertyHelper(writer, "FileName").GetAsString());
}

std::set<std::string> namesBeside(const std::filesystem::path& file, vtkSMProxy* writer)
{
  std::set<std::string> names =
    namesIn(file.parent_path().u8string(), writer->GetSessionProxyManager());
  names.erase(file.filename().u8string());
  return names;
}

bool isCase(const std::set<std::string>& names)
{
  return names.count("constant") == 1 || names.count("system") == 1;
}

// Of the mesh that a writer writes.
std::vector<Category> categoriesOfMesh(const Output& mesh, const std::string& array)
{
  return mesh.source->GetProperty("LegendInfo") ? categoriesOf(mesh.source, array)
                                                : std::vector<Category>{};
}

bool hasThrough(const Output& mesh)
{
  const std::vector<Category> boundaries = categoriesOfMesh(mesh, Boundaries);
  const auto has = [&](const std::string& kind) {
    return std::any_of(boundaries.begin(), boundaries.end(),
      [&](const Category& boundary) { return boundary.value.rfind(kind, 0) == 0; });
  };
  return has("inlet") && has("outlet");
}

bool hasFieldData(const Output& mesh, const char* name)
{
  return mesh.source->GetDataInformation(static_cast<unsigned int>(mesh.port))
           ->GetFieldDataInformation()
           ->GetArrayInformation(name) != nullptr;
}

// Zones of one fluid are one mesh.
void proposeSolver(vtkSMProxy* writer, const Output& mesh)
{
  const bool areZones = hasFieldData(mesh, "RegionsAreZones");
  const bool areMeshes = !areZones && categoriesOfMesh(mesh, Regions).size() > 1;
  vtkSMPropertyHelper(writer, "SolverSetup").Set(areMeshes ? ConjugateHeat : Incompressible);
  if (areZones)
  {
    vtkSMPropertyHelper(writer, "RegionsAs").Set(Zones);
  }
}

}

void proposeFolder(vtkSMProxy* writer)
{
  const std::set<std::string> names = namesBeside(fileOf(writer), writer);
  vtkSMPropertyHelper(writer, "NewFolder").Set(!names.empty() && !isCase(names) ? 1 : 0);
}

void proposeSetup(vtkSMProxy* writer)
{
  const Output mesh = inputOf(writer);
  const bool isNew = vtkSMPropertyHelper(writer, "NewFolder").GetAsInt() == 1;
  const std::filesystem::path file = fileOf(writer);
  const std::filesystem::path written =
    isNew ? std::filesystem::u8path(inNewFolder(file.u8string())) : file;
  if ((hasFieldData(mesh, "FlowDirection") || hasThrough(mesh)) &&
    !isCase(namesBeside(written, writer)))
  {
    proposeSolver(writer, mesh);
  }
}

std::string inNewFolder(const std::string& file)
{
  const std::filesystem::path path = std::filesystem::u8path(file);
  return (path.parent_path() / path.stem() / path.filename()).u8string();
}

}
