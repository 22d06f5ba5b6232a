// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNamedOBJReader.h"

#include "Base/Error.h"
#include "BoundaryNames.h"
#include "PlainObj.h"
#include "ReportErrors.h"
#include "SurfaceFromVTK.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include "vtksys/FStream.hxx"

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace
{

// Groups that have faces, in order of the file, or objects; vtkOBJReader only counts them.
struct Groups
{
  std::vector<std::string> names;
  std::vector<int> ofFace; // index of its name
};

// The first word of a line, and what follows.
std::pair<std::string_view, std::string_view> Parted(std::string_view line)
{
  constexpr std::string_view space = " \t\r\v\f";
  const auto trimmed = [&](std::string_view words) {
    const std::size_t begin = std::min(words.find_first_not_of(space), words.size());
    return words.substr(begin, words.find_last_not_of(space) + 1 - begin);
  };
  const std::string_view words = trimmed(line);
  const std::size_t end = std::min(words.find_first_of(space), words.size());
  return { words.substr(0, end), trimmed(words.substr(end)) };
}

// Of lines with this keyword, g or o. Stops after `most` groups.
Groups ReadParts(const char* file, std::size_t most, const std::string& part)
{
  Groups groups;
  vtksys::ifstream stream(file, std::ios::binary);
  std::string line;
  std::string name;
  bool isNew = true;
  while (std::getline(stream, line))
  {
    const auto [keyword, next] = Parted(line);
    if (keyword == part)
    {
      isNew = isNew || next != name;
      name = next;
    }
    else if (keyword == "f")
    {
      if (isNew && groups.names.size() == most)
      {
        break;
      }
      if (isNew)
      {
        groups.names.push_back(name);
        isNew = false;
      }
      groups.ofFace.push_back(static_cast<int>(groups.names.size()) - 1);
    }
  }
  return groups;
}

bool HaveNames(const Groups& groups)
{
  return std::any_of(groups.names.begin(), groups.names.end(),
    [](const std::string& name) { return !name.empty(); });
}

// Groups, or objects in a file in which no group has a name.
Groups ReadGroups(const char* file, std::size_t most)
{
  Groups groups = ReadParts(file, most, "g");
  return HaveNames(groups) ? groups : ReadParts(file, most, "o");
}

// The cell array of the faces' groups; a vtkPolyData has vertices and lines before them.
vtkSmartPointer<vtkIntArray> LabelsOf(const Groups& groups, vtkPolyData* surface)
{
  const auto faces = static_cast<vtkIdType>(groups.ofFace.size());
  if (faces != surface->GetNumberOfPolys())
  {
    throw cartesian::Error(cartesian::Fault::MissingArray,
      "The file has " + std::to_string(faces) + " face lines, but " +
        std::to_string(surface->GetNumberOfPolys()) +
        " faces could be read: their groups are unknown. Use ParaView's Wavefront OBJ Reader "
        "instead.");
  }
  auto labels = vtkSmartPointer<vtkIntArray>::New();
  labels->SetName(cartesian::BoundaryIdArray);
  labels->SetNumberOfValues(surface->GetNumberOfCells());
  labels->FillValue(0);
  for (vtkIdType face = 0; face < faces; ++face)
  {
    labels->SetValue(
      surface->GetNumberOfCells() - faces + face, groups.ofFace[static_cast<std::size_t>(face)]);
  }
  return labels;
}

}

vtkStandardNewMacro(vtkNamedOBJReader);

int vtkNamedOBJReader::CanReadFile(const char* name)
{
  return HaveNames(ReadGroups(name, 2)) ? 1 : 0;
}

int vtkNamedOBJReader::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  cartesian::Execution execution(cartesian::Execution::AllCores);
  if (!cartesian::readPlainObj(this->GetFileName(), vtkPolyData::GetData(output), execution) &&
    !this->Superclass::RequestData(request, input, output))
  {
    return 0;
  }
  const auto nameGroups = [&] {
    vtkPolyData* surface = vtkPolyData::GetData(output);
    const Groups groups = ReadGroups(this->GetFileName(), std::numeric_limits<std::size_t>::max());
    if (!groups.names.empty())
    {
      const auto labels = LabelsOf(groups, surface);
      cartesian::setBoundaryNames(surface, cartesian::uniteNames(groups.names, labels));
      surface->GetCellData()->AddArray(labels);
    }
  };
  cartesian::reportErrors(nameGroups, [this](unsigned long code, const std::string& message) {
    this->SetErrorCode(code);
    vtkErrorMacro(<< message);
  });
  return 1;
}

void vtkNamedOBJReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
