// SPDX-License-Identifier: BSD-3-Clause
// read-cad FILE UNIT DEFLECTION ANGLE NAMES HEAL GLUE MERGE ENCODING KEEP: reads a CAD file for vtkCADReader, and writes records (Stream.h)
// to its standard output. A process of its own, as Open CASCADE crashes on some damaged files and takes for ever with
// others.
#include "CadFile.h"
#include "CadGlue.h"
#include "CadHeal.h"
#include "CadKinks.h"
#include "CadMerge.h"
#include "CadNames.h"
#include "CadTriangles.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <Standard_Failure.hxx>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fcntl.h>
#include <filesystem>
#include <sys/resource.h>
#include <unistd.h>

namespace
{

using namespace cartesian;

// Writes records. What Open CASCADE prints goes nowhere.
class Output
{
public:
  Output()
    : file_(fdopen(dup(STDOUT_FILENO), "wb"))
  {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    Message::DefaultMessenger()->ChangePrinters().Clear();
  }

  void write(Record record, const std::vector<char>& bytes)
  {
    const std::uint64_t size = bytes.size();
    const char letter = static_cast<char>(record);
    const bool isWritten = std::fwrite(&letter, 1, 1, file_) == 1 &&
      std::fwrite(&size, sizeof size, 1, file_) == 1 &&
      std::fwrite(bytes.data(), 1, bytes.size(), file_) == bytes.size() && std::fflush(file_) == 0;
    if (!isWritten)
    {
      std::_Exit(EXIT_FAILURE); // nobody reads any more
    }
  }

  template <typename T>
  void write(Record record, const T& value)
  {
    Packer packer;
    packer.add(value);
    write(record, packer.bytes());
  }

private:
  std::FILE* file_;
};

// What damaged files ask for may be more than there is: then they are refused, and nothing else is ended for want of
// memory.
void limitMemory()
{
  rlimit limit{};
  getrlimit(RLIMIT_AS, &limit);
  const auto all =
    static_cast<rlim_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
  limit.rlim_cur = std::min(limit.rlim_max, all);
  setrlimit(RLIMIT_AS, &limit);
  const rlimit none{ 0, 0 };
  setrlimit(RLIMIT_CORE, &none);
}

CadOptions optionsFrom(char** words)
{
  CadOptions options;
  options.unit = std::atof(words[0]);
  options.deflection = std::atof(words[1]);
  options.angle = std::atof(words[2]);
  options.names = static_cast<CadNames>(std::atoi(words[3]));
  options.healTolerance = std::atof(words[4]);
  options.gluesSolids = std::atoi(words[5]) != 0;
  options.mergesCoplanar = std::atoi(words[6]) != 0;
  options.encoding = static_cast<CadEncoding>(std::atoi(words[7]));
  options.keepsDamaged = std::atoi(words[8]) != 0;
  return options;
}

// Exact shapes, for triangulation.
void prepare(
  CadFile& file, const std::string& name, const CadOptions& options, const CadReport& report)
{
  heal(file, options, report);
  divideAtKinks(file.parts, options, report);
  if (options.mergesCoplanar)
  {
    mergeCoplanar(file.parts, report);
  }
  numberAlike(file.parts, name);
  if (options.gluesSolids)
  {
    glue(file.parts, options, report);
    numberAlike(file.parts, name);
  }
  else
  {
    noteNeighbours(file.parts, report);
  }
}

std::vector<CadPart> takeTessellated(std::vector<CadPart>& parts)
{
  const auto first = std::stable_partition(
    parts.begin(), parts.end(), [](const CadPart& part) { return !isTessellated(part.shape); });
  std::vector<CadPart> taken(first, parts.end());
  parts.erase(first, parts.end());
  return taken;
}

void read(const std::string& path, const CadOptions& options, Output& output)
{
  CadReport report;
  report.progress = [&](double done) { output.write(Record::Progress, done); };
  report.note = [&](const std::string& text) { output.write(Record::Note, text); };
  report.damage = [&](const std::string& text) { output.write(Record::Damage, text); };
  report.warning = [&](const std::string& text) { output.write(Record::Warning, text); };

  CadFile file = readCadFile(path, options, report);
  const std::string name = std::filesystem::path(path).stem().string();
  const std::vector<CadPart> triangles = takeTessellated(file.parts);
  if (!file.parts.empty())
  {
    prepare(file, name, options, report);
  }
  const std::size_t exact = file.parts.size();
  file.parts.insert(file.parts.end(), triangles.begin(), triangles.end());
  numberAlike(file.parts, name);
  const CadBoundaries boundaries = boundariesOf(file.parts, options.names, report);
  output.write(Record::Names, boundaries.names);
  const auto write = [&](const auto& make, std::size_t begin, std::size_t end) {
    const auto from = std::ptrdiff_t(begin);
    const auto to = std::ptrdiff_t(end);
    const CadBoundaries own{ boundaries.names,
      { boundaries.ofFace.begin() + from, boundaries.ofFace.begin() + to } };
    const std::vector<CadPart> parts(file.parts.begin() + from, file.parts.begin() + to);
    for (CadSolid& solid : make(parts, own, options, report))
    {
      Packer packer;
      solid.visit([&](const auto& value) { packer.add(value); });
      output.write(Record::Solid, packer.bytes());
    }
  };
  if (exact > 0 || triangles.empty()) // an error if there is nothing
  {
    write(triangulate, 0, exact);
  }
  write(trianglesOf, exact, file.parts.size());
  output.write(Record::End, std::vector<char>());
}

}

int main(int count, char** words)
{
  if (count != 11)
  {
    std::fputs("read-cad is started by the CAD Reader of CartesianMesher.\n", stderr);
    return EXIT_FAILURE;
  }
  limitMemory();
  Output output;
  try
  {
    read(words[1], optionsFrom(words + 2), output);
    return EXIT_SUCCESS;
  }
  catch (const CadError& error)
  {
    output.write(Record::Error, words[1] + std::string(" ") + error.what());
  }
  catch (const Standard_Failure& failure)
  {
    output.write(Record::Error,
      std::string(words[1]) + " cannot be read: Open CASCADE gives up (" +
        failure.DynamicType()->Name() + ", " + failure.GetMessageString() +
        "). Export the part again, or in another format.");
  }
  catch (const std::bad_alloc&)
  {
    output.write(Record::Error,
      std::string(words[1]) + " needs more memory than there is: choose a larger Deflection.");
  }
  catch (const std::exception& error)
  {
    output.write(Record::Error, std::string(words[1]) + " cannot be read: " + error.what() + ".");
  }
  // Destructors of what is damaged may crash.
  std::_Exit(EXIT_FAILURE);
}
