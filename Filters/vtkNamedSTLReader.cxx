// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNamedSTLReader.h"

#include "BoundaryNames.h"
#include "ReportErrors.h"
#include "SurfaceFromVTK.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include "vtksys/FStream.hxx"

#include <array>
#include <limits>
#include <sstream>
#include <vector>

namespace
{

// Longer ones are binary data.
constexpr int LongestLine = 1000;

// Of the first `most` solids of an ASCII file; none of a binary one. (vtkSTLReader's own header
// leaves out solids without a name.)
std::vector<std::string> SolidNames(const char* file, std::size_t most)
{
  std::vector<std::string> names;
  vtksys::ifstream stream(file, std::ios::binary);
  std::array<char, LongestLine> line;
  while (names.size() < most && stream.getline(line.data(), LongestLine))
  {
    std::istringstream words(line.data());
    std::string keyword;
    std::string name;
    words >> keyword >> std::ws;
    if (keyword == "solid")
    {
      std::getline(words, name);
      names.push_back(name.substr(0, name.find_last_not_of(" \t\r") + 1));
    }
    else if (names.empty())
    {
      break;
    }
  }
  return names;
}

}

vtkStandardNewMacro(vtkNamedSTLReader);

vtkNamedSTLReader::vtkNamedSTLReader()
{
  this->ScalarTagsOn();
}

int vtkNamedSTLReader::CanReadFile(const char* name)
{
  const std::vector<std::string> names = SolidNames(name, 2);
  return names.size() == 2 && names[0].size() + names[1].size() > 0;
}

int vtkNamedSTLReader::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  if (!this->Superclass::RequestData(request, input, output))
  {
    return 0;
  }
  const auto nameSolids = [&] {
    vtkPolyData* surface = vtkPolyData::GetData(output);
    const std::vector<std::string> names =
      SolidNames(this->GetFileName(), std::numeric_limits<std::size_t>::max());
    vtkDataArray* labels = surface->GetCellData()->GetArray(cartesian::StlSolids);
    // A binary file has neither.
    if (labels && labels->GetRange()[1] < static_cast<double>(names.size()))
    {
      cartesian::setBoundaryNames(surface, cartesian::uniteNames(names, labels));
    }
  };
  cartesian::reportErrors(nameSolids, [this](unsigned long code, const std::string& message) {
    this->SetErrorCode(code);
    vtkErrorMacro(<< message);
  });
  return 1;
}

void vtkNamedSTLReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
