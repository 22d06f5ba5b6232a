// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNamedSTLReader.h"

#include "BoundaryNames.h"
#include "ReportErrors.h"
#include "SurfaceFromVTK.h"

#include "Utf8.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include "vtksys/FStream.hxx"
#include "vtksys/SystemTools.hxx"

#include <array>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>
#include <system_error>
#include <vector>

#include <unistd.h>

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

// False at the end, or if the next line is too long; then `line` is its beginning.
bool GetLine(std::istream& stream, std::string& line)
{
  static thread_local std::vector<char> buffer(LongestLine);
  const bool isLine = static_cast<bool>(stream.getline(buffer.data(), LongestLine));
  line = buffer.data();
  return isLine;
}

// Of the first `most` solids of an ASCII file; none of a binary one. (vtkSTLReader's own header
// leaves out solids without a name.)
struct Solids
{
  std::vector<std::string> names;
  bool suitVTK = true;     // vtkSTLReader would read the file
  std::size_t tooLong = 0; // the line, from 1, whose name is too long to be read; 0: none
};

// Whether a line may come next after the first solid: of a binary file, which may begin with "solid"
// too, it does not.
bool FollowsSolid(const std::string& keyword)
{
  return keyword == "facet" || keyword == "endsolid" || keyword == "color";
}

// Whether a line that is too long to be read has a name: binary data have zeros.
bool IsLongName(const std::string& begin)
{
  const std::string keyword = Split(begin).first;
  return begin.size() + 1 == LongestLine && (keyword == "solid" || keyword == "endsolid");
}

Solids ReadSolids(const char* file, std::size_t most)
{
  Solids solids;
  vtksys::ifstream stream(file, std::ios::binary);
  std::string line;
  std::size_t number = 0;
  for (bool isText = false; solids.names.size() < most;)
  {
    ++number;
    if (!GetLine(stream, line))
    {
      solids.tooLong = IsLongName(line) ? number : 0;
      break;
    }
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

// The number of triangles in a binary file's header, if it exceeds the file's contents so far that vtkSTLReader would
// request more memory than there is; else 0.
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

// Why a file cannot be read, or nothing.
std::string FaultOf(const std::string& file, const Solids& solids)
{
  if (const std::uint32_t count = solids.names.empty() ? AbsurdCount(file.c_str()) : 0)
  {
    return file + " claims to have " + std::to_string(count) +
      " triangles, far more than its size allows: it is damaged, or not an STL file. Export it "
      "again.";
  }
  if (solids.tooLong > 0)
  {
    return "Line " + std::to_string(solids.tooLong) + " of " + file + " has more than " +
      std::to_string(LongestLine - 1) + " characters: shorten the name of the solid.";
  }
  return {};
}

// A uniquely named temporary file that exists as long as this object.
class TemporaryFile
{
public:
  TemporaryFile()
  {
    std::error_code none;
    name_ = (std::filesystem::temp_directory_path(none) / "cartesianmesherXXXXXX").string();
    const int descriptor = mkstemp(name_.data());
    exists_ = descriptor >= 0 && close(descriptor) == 0;
  }
  ~TemporaryFile()
  {
    if (exists_)
    {
      std::remove(name_.c_str());
    }
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  bool exists() const { return exists_; }
  const std::string& name() const { return name_; }

private:
  std::string name_;
  bool exists_ = false;
};

// Copies an ASCII file without the names of its solids. False if the copy cannot be written.
bool CopyWithoutNames(const char* file, const TemporaryFile& copy)
{
  vtksys::ifstream stream(file, std::ios::binary);
  vtksys::ofstream output(copy.name().c_str(), std::ios::binary);
  std::string line;
  while (output && GetLine(stream, line))
  {
    const std::string keyword = Split(line).first;
    const bool named = keyword == "solid" || keyword == "endsolid";
    output << (named ? keyword : line) << '\n';
  }
  return copy.exists() && output.flush();
}

// Turns a reader's message about a file's copy into one about the file.
void Keep(vtkObject* /*reader*/, unsigned long /*event*/, void* kept, void* text)
{
  *static_cast<std::string*>(kept) += static_cast<const char*>(text);
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
  return named || !first.suitVTK || first.tooLong > 0 ||
    (first.names.empty() && AbsurdCount(name) > 0);
}

int vtkNamedSTLReader::ReadWithoutNames(vtkPolyData* surface)
{
  const TemporaryFile copy;
  if (!CopyWithoutNames(this->GetFileName(), copy))
  {
    this->SetErrorCode(vtkErrorCode::OutOfDiskSpaceError);
    vtkErrorMacro("Cannot write a temporary copy of "
      << this->GetFileName() << " without solid names: free space in the temporary folder.");
    return 0;
  }
  std::string errors;
  vtkNew<vtkCallbackCommand> keep;
  keep->SetCallback(Keep);
  keep->SetClientData(&errors);
  vtkNew<vtkSTLReader> reader;
  reader->AddObserver(vtkCommand::ErrorEvent, keep);
  reader->SetFileName(copy.name().c_str());
  reader->ScalarTagsOn();
  reader->Update();
  if (!errors.empty())
  {
    vtksys::SystemTools::ReplaceString(errors, copy.name(), this->GetFileName());
    this->SetErrorCode(reader->GetErrorCode());
    vtkErrorMacro(<< errors);
    return 0;
  }
  surface->ShallowCopy(reader->GetOutput());
  return 1;
}

int vtkNamedSTLReader::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  const char* file = this->GetFileName();
  const Solids solids = file ? ReadSolids(file, std::numeric_limits<std::size_t>::max()) : Solids();
  const std::string fault = file ? FaultOf(file, solids) : std::string();
  if (!fault.empty())
  {
    this->SetErrorCode(vtkErrorCode::FileFormatError);
    vtkErrorMacro(<< fault);
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
