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

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <optional>
#include <set>
#include <sstream>
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

// What vtkSTLWriter calls each solid: no name.
constexpr const char* NameByVTK = "Visualization Toolkit generated SLA File";

constexpr const char* FirstWords = "facet normal"; // of a triangle

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
  bool isDialect = false;  // perhaps: words are not where vtkSTLReader looks for them
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
  const bool hasFacet = vtksys::SystemTools::LowerCase(begin).find(FirstWords) != std::string::npos;
  return begin.size() + 1 == LongestLine && !hasFacet &&
    (keyword == "solid" || keyword == "endsolid");
}

// Signs of a file whose words are not where vtkSTLReader looks for them.
class OddWords
{
public:
  void addLine(const std::string& line) { isOdd_ = isOdd_ || line.find('\r') < line.size() - 1; }

  void addKeyword(const std::string& keyword)
  {
    isOdd_ = isOdd_ || keyword == "end";
    isEnded_ = keyword != "solid" && (isEnded_ || keyword == "endsolid");
    if (keyword == "endloop" || keyword == "endfacet")
    {
      ends_.insert(keyword);
    }
  }

  bool found() const { return isOdd_; }
  bool foundAtEnd() const { return isOdd_ || !isEnded_ || ends_.size() < 2; }

private:
  bool isOdd_ = false;
  bool isEnded_ = true; // the last solid
  std::set<std::string> ends_;
};

Solids ReadSolids(const char* file, std::size_t most)
{
  Solids solids;
  vtksys::ifstream stream(file, std::ios::binary);
  std::string line;
  std::size_t number = 0;
  OddWords odd;
  for (bool isText = false; solids.names.size() < most;)
  {
    ++number;
    if (!GetLine(stream, line))
    {
      solids.tooLong = IsLongName(line) ? number : 0;
      solids.isDialect = odd.foundAtEnd();
      return solids;
    }
    odd.addLine(line);
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
    odd.addKeyword(keyword);
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
  solids.isDialect = odd.found();
  return solids;
}

constexpr std::size_t HeaderBytes = 80;
constexpr std::uint64_t BytesOfATriangle = 50;

// What a binary file says of itself.
struct BinaryFile
{
  std::uint64_t claimed = 0; // triangles, by its header
  std::uint64_t held = 0;    // by its length
  bool isExact = false;      // both agree: whatever its header says, it is no text
};

// None of a file that is text, or too short. That a header begins with "solid" does not matter if the length is right.
std::optional<BinaryFile> ReadBinary(const char* file)
{
  std::array<unsigned char, HeaderBytes + 4> head;
  vtksys::ifstream stream(file, std::ios::binary);
  if (!stream.read(reinterpret_cast<char*>(head.data()), head.size()))
  {
    return {};
  }
  BinaryFile binary;
  for (std::size_t byte = 0; byte < 4; ++byte)
  {
    binary.claimed |= std::uint64_t(head[HeaderBytes + byte]) << 8 * byte;
  }
  const std::uint64_t length = vtksys::SystemTools::FileLength(file) - head.size();
  binary.held = length / BytesOfATriangle;
  binary.isExact = binary.claimed * BytesOfATriangle == length;
  // Text may have names that seem binary, but no zeros.
  std::array<char, 512> begin{};
  stream.seekg(0);
  stream.read(begin.data(), begin.size());
  char* const end = begin.data() + stream.gcount();
  const bool isBinary = binary.isExact || std::find(begin.data(), end, '\0') != end;
  return isBinary ? std::optional(binary) : std::nullopt;
}

// Whether vtkSTLReader would request more memory than there is.
bool IsAbsurd(const BinaryFile& binary)
{
  constexpr std::uint64_t Slack = 1000;
  return binary.claimed > 2 * binary.held + Slack &&
    binary.claimed <= std::uint64_t(std::numeric_limits<int>::max());
}

bool BeginsWithSolid(const char* file)
{
  std::array<char, 5> word{};
  vtksys::ifstream stream(file, std::ios::binary);
  stream.read(word.data(), word.size());
  return vtksys::SystemTools::LowerCase({ word.data(), word.size() }) == "solid";
}

// Why a file cannot be read, or nothing.
std::string FaultOf(
  const std::string& file, const Solids& solids, const std::optional<BinaryFile>& binary)
{
  if (binary && IsAbsurd(*binary))
  {
    return file + " claims to have " + std::to_string(binary->claimed) +
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
bool CopyWithoutNames(const char* file, const std::string& copy)
{
  vtksys::ifstream stream(file, std::ios::binary);
  vtksys::ofstream output(copy.c_str(), std::ios::binary);
  std::string line;
  while (output && GetLine(stream, line))
  {
    const std::string keyword = Split(line).first;
    const bool named = keyword == "solid" || keyword == "endsolid";
    output << (named ? keyword : line) << '\n';
  }
  return static_cast<bool>(output.flush());
}

// Copies a binary file without its header, whose text vtkSTLReader would take for an ASCII file.
bool CopyWithoutHeader(const char* file, const std::string& copy)
{
  vtksys::ifstream stream(file, std::ios::binary);
  vtksys::ofstream output(copy.c_str(), std::ios::binary);
  stream.seekg(HeaderBytes);
  output << std::string(HeaderBytes, '\0') << stream.rdbuf();
  return static_cast<bool>(output.flush());
}

// Reads ASCII files whose words are not in the lines where vtkSTLReader looks for them: with other line ends, all in one
// line, with "end loop" for "endloop", without ends. Writes them as vtkSTLReader wants them, without names.
class Dialect
{
public:
  // Nothing if the file is none.
  static std::optional<Dialect> read(const char* file)
  {
    vtksys::ifstream stream(file, std::ios::binary);
    std::stringstream text;
    text << stream.rdbuf();
    Dialect dialect(text.str());
    const bool isSuitable = dialect.readAll() && !dialect.names.empty() && dialect.facets_ > 0;
    return isSuitable ? std::optional(std::move(dialect)) : std::nullopt;
  }

  bool writeTo(const std::string& copy) const
  {
    vtksys::ofstream output(copy.c_str(), std::ios::binary);
    output << written_;
    return static_cast<bool>(output.flush());
  }

  std::vector<std::string> names;

private:
  explicit Dialect(std::string text)
    : text_(std::move(text))
  {
  }

  // The next word in lower case; empty at the end.
  std::string word()
  {
    const std::size_t begin = std::min(text_.find_first_not_of(" \t\r\n\v\f", at_), text_.size());
    at_ = std::min(text_.find_first_of(" \t\r\n\v\f", begin), text_.size());
    return vtksys::SystemTools::LowerCase(text_.substr(begin, at_ - begin));
  }

  // Up to the end of the line, or the first facet in it.
  std::string name()
  {
    const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
    const std::string rest = text_.substr(at_, end - at_);
    const std::size_t facet = vtksys::SystemTools::LowerCase(rest).find(FirstWords);
    at_ = facet == std::string::npos ? end : at_ + facet;
    return Split("name " + rest.substr(0, facet)).second;
  }

  // The next solid may be in the same line.
  void skipName()
  {
    const std::size_t begin = std::min(text_.find_first_not_of(Blanks, at_), text_.size());
    if (text_.compare(begin, last_.size(), last_) == 0)
    {
      at_ = begin + last_.size();
      return;
    }
    name();
  }

  bool numbers(const std::string& before)
  {
    written_ += before;
    for (int i = 0; i < 3; ++i)
    {
      const std::string number = word();
      char* end = nullptr;
      std::strtod(number.c_str(), &end);
      if (number.empty() || *end != '\0')
      {
        return false;
      }
      written_ += " " + number;
    }
    written_ += "\n";
    return true;
  }

  bool readFacet()
  {
    bool isFacet =
      word() == "normal" && numbers("facet normal") && word() == "outer" && word() == "loop";
    written_ += "outer loop\n";
    for (int i = 0; i < 3 && isFacet; ++i)
    {
      isFacet = word() == "vertex" && numbers("vertex");
    }
    written_ += "endloop\nendfacet\n";
    ++facets_;
    return isFacet;
  }

  bool readAll()
  {
    for (std::string next = word(); !next.empty(); next = word())
    {
      next = next == "end" ? "end" + word() : next;
      if (next == "solid")
      {
        written_ += names.empty() ? "solid\n" : "endsolid\nsolid\n";
        last_ = name();
        names.push_back(cartesian::toUtf8(last_));
      }
      else if (next == "endsolid")
      {
        skipName();
      }
      else if (names.empty() ||
        (next == "facet" ? !readFacet() : next != "endloop" && next != "endfacet"))
      {
        return false;
      }
    }
    written_ += "endsolid\n";
    return true;
  }

  std::string text_;
  std::size_t at_ = 0;
  std::size_t facets_ = 0;
  std::string last_; // name of a solid
  std::string written_;
};

// What kind of file it is that these solids seem to be in.
struct FileKind
{
  std::optional<Dialect> dialect;
  std::optional<BinaryFile> binary;
};

FileKind KindOf(const char* file, const Solids& solids)
{
  FileKind kind;
  const bool isOdd = solids.tooLong == 0 && (solids.names.empty() || solids.isDialect);
  kind.binary = ReadBinary(file);
  kind.dialect =
    isOdd && !(kind.binary && kind.binary->isExact) ? Dialect::read(file) : std::nullopt;
  if (kind.binary && !kind.binary->isExact && (kind.dialect || !isOdd))
  {
    kind.binary.reset();
  }
  return kind;
}

using CopyFile = std::function<bool(const std::string& to)>;

// How to make a copy that vtkSTLReader reads; empty if it reads the file itself.
CopyFile CopierOf(const char* file, const FileKind& kind, const Solids& solids)
{
  if (kind.binary)
  {
    return BeginsWithSolid(file)
      ? [=](const std::string& to) { return CopyWithoutHeader(file, to); }
      : CopyFile();
  }
  if (kind.dialect)
  {
    return [&](const std::string& to) { return kind.dialect->writeTo(to); };
  }
  return solids.suitVTK ? CopyFile()
                        : [=](const std::string& to) { return CopyWithoutNames(file, to); };
}

// Of a binary file that is cut off; else nothing.
std::string DescribeMissing(const std::string& file, const std::optional<BinaryFile>& binary)
{
  if (!binary || binary->claimed <= binary->held)
  {
    return {};
  }
  return file + " is cut off: its header says " + std::to_string(binary->claimed) +
    " triangles, but there are " + std::to_string(binary->held) +
    ". Export or copy it again, or the surface lacks the others.";
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
  const FileKind kind = KindOf(name, first);
  if (kind.binary)
  {
    return BeginsWithSolid(name) || kind.binary->claimed > kind.binary->held ? 1 : 0;
  }
  const bool named = std::any_of(first.names.begin(), first.names.end(),
    [](const std::string& solid) { return !solid.empty() && solid != NameByVTK; });
  return named || !first.suitVTK || first.tooLong > 0 || kind.dialect;
}

int vtkNamedSTLReader::ReadCopy(
  const std::function<bool(const std::string&)>& write, vtkPolyData* surface)
{
  const TemporaryFile copy;
  if (!copy.exists() || !write(copy.name()))
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

int vtkNamedSTLReader::Refuse(unsigned long code, const std::string& why)
{
  this->SetErrorCode(code);
  vtkErrorMacro(<< why);
  return 0;
}

int vtkNamedSTLReader::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  const char* file = this->GetFileName();
  if (!file)
  {
    return this->Superclass::RequestData(request, input, output);
  }
  Solids solids = ReadSolids(file, std::numeric_limits<std::size_t>::max());
  const FileKind kind = KindOf(file, solids);
  if (kind.binary || kind.dialect)
  {
    solids = {};
    solids.names = kind.dialect ? kind.dialect->names : solids.names;
  }
  const std::string fault = FaultOf(file, solids, kind.binary);
  if (!fault.empty())
  {
    return this->Refuse(vtkErrorCode::FileFormatError, fault);
  }
  if (const std::string missing = DescribeMissing(file, kind.binary); !missing.empty())
  {
    vtkWarningMacro(<< missing);
  }
  vtkPolyData* surface = vtkPolyData::GetData(output);
  const CopyFile copy = CopierOf(file, kind, solids);
  if (!(copy ? this->ReadCopy(copy, surface)
             : this->Superclass::RequestData(request, input, output)))
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
  cartesian::reportErrors(nameSolids,
    [this](unsigned long code, const std::string& message) { this->Refuse(code, message); });
  return 1;
}

void vtkNamedSTLReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
