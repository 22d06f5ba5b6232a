// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/FoamFile.h"

namespace cartesian
{

namespace
{

// In every header, to recognise our own files.
constexpr const char* Mark = "// Written by Cartesian Mesher";

}

FoamFile::FoamFile(const std::filesystem::path& path, FoamFormat format, const Header& header)
  : OutputFile(path)
  , format_(format)
{
  const bool binary = format == FoamFormat::Binary;
  text(std::string(Mark) + "\nFoamFile\n{\n    version     2.0;\n    format      " +
    (binary ? "binary;\n    arch        \"LSB;label=32;scalar=64\";\n" : "ascii;\n") +
    "    class       " + header.className + ";\n");
  if (!header.note.empty())
  {
    text("    note        \"" + header.note + "\";\n");
  }
  text(std::string("    location    \"") + header.location + "\";\n    object      " +
    path.filename().string() + ";\n}\n\n");
}

void FoamFile::labels(std::size_t count, const std::function<std::int32_t(std::size_t)>& label)
{
  begin(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    if (format_ == FoamFormat::Binary)
    {
      raw(label(i));
    }
    else
    {
      decimal(label(i));
      text("\n");
    }
  }
  end(count);
}

void FoamFile::vectors(const std::vector<double>& numbers)
{
  const std::size_t count = numbers.size() / 3;
  begin(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (format_ == FoamFormat::Binary)
      {
        raw(numbers[3 * i + axis]);
      }
      else
      {
        text(axis == 0 ? "(" : " ");
        decimal(numbers[3 * i + axis]);
      }
    }
    if (format_ == FoamFormat::Ascii)
    {
      text(")\n");
    }
  }
  end(count);
}

void FoamFile::labelLists(
  const std::vector<std::size_t>& start, const RawVector<std::uint32_t>& labelsOfAll)
{
  if (format_ == FoamFormat::Binary)
  {
    labels(start.size(), [&](std::size_t i) { return static_cast<std::int32_t>(start[i]); });
    labels(
      labelsOfAll.size(), [&](std::size_t i) { return static_cast<std::int32_t>(labelsOfAll[i]); });
    return;
  }
  begin(start.size() - 1);
  for (std::size_t i = 0; i + 1 < start.size(); ++i)
  {
    decimal(start[i + 1] - start[i]);
    for (std::size_t j = start[i]; j < start[i + 1]; ++j)
    {
      text(j == start[i] ? "(" : " ");
      decimal(labelsOfAll[j]);
    }
    text(")\n");
  }
  end(start.size() - 1);
}

bool FoamFile::isOurs(const std::filesystem::path& path)
{
  std::ifstream file(path);
  std::string line;
  return std::getline(file, line) && line == Mark;
}

void FoamFile::begin(std::size_t count)
{
  decimal(count);
  text("\n");
  // OpenFOAM expects no brackets around an empty binary list.
  if (count > 0 || format_ == FoamFormat::Ascii)
  {
    text(format_ == FoamFormat::Binary ? "(" : "(\n");
  }
}

void FoamFile::end(std::size_t count)
{
  text(count > 0 || format_ == FoamFormat::Ascii ? ")\n" : "\n");
}

}
