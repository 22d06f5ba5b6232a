// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNamedSTLReader.h"

#include "BoundaryNames.h"
#include "ReportErrors.h"
#include "StlSource.h"
#include "SurfaceFromVTK.h"

#include "Utf8.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkMergePoints.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include "vtksys/FStream.hxx"
#include "vtksys/SystemTools.hxx"

#include <array>
#include <cctype>
#include <cstdio>
#include <limits>
#include <memory>
#include <vector>

namespace
{

// Longer ones are binary data.
constexpr std::size_t LongestLine = 1 << 16;

// vtkSTLReader breaks longer ones in two.
constexpr std::size_t LongestLineOfVTK = 253;

constexpr const char* Blanks = " \t\r\v\f";

// The first word of a line, in lower case, and the rest without blanks around it.
std::pair<std::string, std::string> Split(const std::string& line)
{
  const std::size_t begin = line.find_first_not_of(Blanks);
  if (begin == std::string::npos)
  {
    return {};
  }
  const std::size_t end = std::min(line.find_first_of(Blanks, begin), line.size());
  const std::size_t rest = std::min(line.find_first_not_of(Blanks, end), line.size());
  return { vtksys::SystemTools::LowerCase(line.substr(begin, end - begin)),
    line.substr(rest, line.find_last_not_of(Blanks) + 1 - rest) };
}

// False at the end, or if the next line is none of a text.
bool GetLine(std::istream& stream, std::string& line)
{
  static thread_local std::vector<char> buffer(LongestLine);
  if (!stream.getline(buffer.data(), LongestLine))
  {
    return false;
  }
  line = buffer.data();
  return true;
}

// Of the first `most` solids of an ASCII file; none of a binary one. (vtkSTLReader's own header
// leaves out solids without a name.)
struct Solids
{
  std::vector<std::string> names;
  bool suitVTK = true; // vtkSTLReader would read the file
};

// Whether a line may come next after the first solid: of a binary file, which may begin with "solid"
// too, it does not.
bool FollowsSolid(const std::string& keyword)
{
  return keyword == "facet" || keyword == "endsolid" || keyword == "color";
}

Solids ReadSolids(const char* file, std::size_t most)
{
  Solids solids;
  vtksys::ifstream stream(file, std::ios::binary);
  std::string line;
  for (bool isText = false; solids.names.size() < most && GetLine(stream, line);)
  {
    const int first = std::tolower(line[std::min(line.find_first_not_of(Blanks), line.size())]);
    if (isText && first != 's' && first != 'e')
    {
      continue; // neither solid nor endsolid
    }
    const auto [keyword, name] = Split(line);
    if (keyword.empty())
    {
      continue;
    }
    const bool isSolid = keyword == "solid";
    if (!isText && !(solids.names.empty() ? isSolid : FollowsSolid(keyword)))
    {
      return {};
    }
    isText = !solids.names.empty();
    if (isSolid)
    {
      solids.names.push_back(cartesian::toUtf8(name));
    }
    if (isSolid || keyword == "endsolid")
    {
      solids.suitVTK =
        solids.suitVTK && line.size() <= LongestLineOfVTK && cartesian::isAscii(line);
    }
  }
  return solids;
}

// The number of triangles that a binary file names, where it is so far beyond those that it holds that
// vtkSTLReader would ask for more memory than there is; else 0.
std::uint32_t AbsurdCount(const char* file)
{
  constexpr std::size_t HeaderBytes = 80;
  constexpr std::uint64_t BytesOfATriangle = 50;
  constexpr std::uint64_t Slack = 1000;
  std::array<unsigned char, HeaderBytes + 4> head;
  vtksys::ifstream stream(file, std::ios::binary);
  if (vtksys::SystemTools::DetectFileType(file) != vtksys::SystemTools::FileTypeBinary ||
    !stream.read(reinterpret_cast<char*>(head.data()), head.size()))
  {
    return 0;
  }
  std::uint32_t count = 0;
  for (std::size_t byte = 0; byte < 4; ++byte)
  {
    count |= std::uint32_t(head[HeaderBytes + byte]) << 8 * byte;
  }
  const std::uint64_t held = vtksys::SystemTools::FileLength(file) / BytesOfATriangle;
  return count > 2 * held + Slack && count <= std::uint32_t(std::numeric_limits<int>::max()) ? count
                                                                                             : 0;
}

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

// A temporary file, an ASCII file without the names of its solids. Null if it cannot be written.
File CopyWithoutNames(const char* file)
{
  File copy(std::tmpfile(), std::fclose);
  vtksys::ifstream stream(file, std::ios::binary);
  std::string line;
  bool written = copy != nullptr;
  while (written && GetLine(stream, line))
  {
    const std::string keyword = Split(line).first;
    const bool named = keyword == "solid" || keyword == "endsolid";
    written = std::fputs(((named ? keyword : line) + "\n").c_str(), copy.get()) >= 0;
  }
  if (!written || std::fflush(copy.get()) != 0)
  {
    return { nullptr, std::fclose };
  }
  std::rewind(copy.get());
  return copy;
}

// Points that coincide become one, as vtkSTLReader does it.
void MergePoints(
  vtkPoints* points, vtkCellArray* triangles, vtkFloatArray* labels, vtkPolyData* surface)
{
  vtkNew<vtkPoints> mergedPoints;
  vtkNew<vtkMergePoints> locator;
  locator->InitPointInsertion(mergedPoints, points->GetBounds());
  vtkNew<vtkCellArray> mergedTriangles;
  vtkNew<vtkFloatArray> mergedLabels;
  mergedLabels->SetName(cartesian::StlSolids);
  for (vtkIdType t = 0; t < triangles->GetNumberOfCells(); ++t)
  {
    std::array<vtkIdType, 3> corners;
    for (vtkIdType i = 0; i < 3; ++i)
    {
      locator->InsertUniquePoint(points->GetPoint(3 * t + i), corners[static_cast<std::size_t>(i)]);
    }
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
    {
      mergedTriangles->InsertNextCell(3, corners.data());
      mergedLabels->InsertNextValue(labels->GetValue(t));
    }
  }
  surface->SetPoints(mergedPoints);
  surface->SetPolys(mergedTriangles);
  surface->GetCellData()->SetScalars(mergedLabels);
}

}

vtkStandardNewMacro(vtkNamedSTLReader);

vtkNamedSTLReader::vtkNamedSTLReader()
{
  this->ScalarTagsOn();
}

int vtkNamedSTLReader::CanReadFile(const char* name)
{
  const Solids first = ReadSolids(name, 2);
  const bool named = first.names.size() == 2 && first.names[0].size() + first.names[1].size() > 0;
  return named || !first.suitVTK || (first.names.empty() && AbsurdCount(name) > 0);
}

int vtkNamedSTLReader::ReadWithoutNames(vtkPolyData* surface)
{
  const File copy = CopyWithoutNames(this->GetFileName());
  if (!copy)
  {
    this->SetErrorCode(vtkErrorCode::OutOfDiskSpaceError);
    vtkErrorMacro("There is no room for a temporary copy of " << this->GetFileName()
                                                              << ", without names of solids.");
    return 0;
  }
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkFloatArray> labels;
  if (!this->ReadASCIISTL(cartesian::stlSource(copy.get()), points, triangles, labels))
  {
    return 0;
  }
  MergePoints(points, triangles, labels, surface);
  return 1;
}

int vtkNamedSTLReader::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  const char* file = this->GetFileName();
  const Solids solids = file ? ReadSolids(file, std::numeric_limits<std::size_t>::max()) : Solids();
  if (const std::uint32_t count = file && solids.names.empty() ? AbsurdCount(file) : 0)
  {
    this->SetErrorCode(vtkErrorCode::FileFormatError);
    vtkErrorMacro("" << file << " says that it has " << count
                     << " triangles, many more than its length allows: it is broken, or no STL.");
    return 0;
  }
  vtkPolyData* surface = vtkPolyData::GetData(output);
  if (!(solids.suitVTK ? this->Superclass::RequestData(request, input, output)
                       : this->ReadWithoutNames(surface)))
  {
    return 0;
  }
  const auto nameSolids = [&] {
    vtkDataArray* labels = surface->GetCellData()->GetArray(cartesian::StlSolids);
    // A binary file has neither.
    if (labels && labels->GetRange()[1] < static_cast<double>(solids.names.size()))
    {
      cartesian::setBoundaryNames(surface, cartesian::uniteNames(solids.names, labels));
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
