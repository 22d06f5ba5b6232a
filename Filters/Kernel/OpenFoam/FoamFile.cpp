// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/FoamFile.h"

#include "Base/Error.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>

namespace cartesian
{

namespace
{

// In every header, to recognise our own files.
constexpr const char* Mark = "// Written by Cartesian Mesher";

constexpr std::size_t BufferBytes = 1 << 20;

}

FoamFile::FoamFile(const std::filesystem::path& path, FoamFormat format, const Header& header)
  : path_(path)
  , format_(format)
  , file_(path, std::ios::binary)
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

void FoamFile::text(const std::string& words)
{
  buffer_ += words;
  flush(BufferBytes);
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
      buffer_ += '\n';
    }
    flush(BufferBytes);
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
        buffer_ += axis == 0 ? '(' : ' ';
        decimal(numbers[3 * i + axis]);
      }
    }
    if (format_ == FoamFormat::Ascii)
    {
      buffer_ += ")\n";
    }
    flush(BufferBytes);
  }
  end(count);
}

void FoamFile::labelLists(
  const std::vector<std::size_t>& start, const std::vector<std::uint32_t>& labelsOfAll)
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
      buffer_ += j == start[i] ? '(' : ' ';
      decimal(labelsOfAll[j]);
    }
    buffer_ += ")\n";
    flush(BufferBytes);
  }
  end(start.size() - 1);
}

void FoamFile::close()
{
  flush(0);
  file_.close();
  if (!file_)
  {
    throw Error(Fault::CannotWrite,
      "Cannot write " + path_.string() + " (" + std::strerror(errno) +
        "): choose another folder, or make room.");
  }
}

bool FoamFile::isOurs(const std::filesystem::path& path)
{
  std::ifstream file(path);
  std::string line;
  return std::getline(file, line) && line == Mark;
}

template <class Value>
void FoamFile::decimal(Value value)
{
  std::array<char, 32> digits;
  buffer_.append(
    digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

template <class Value>
void FoamFile::raw(Value value)
{
  std::array<char, sizeof(Value)> bytes;
  std::memcpy(bytes.data(), &value, sizeof(Value));
  buffer_.append(bytes.data(), bytes.size());
}

void FoamFile::begin(std::size_t count)
{
  decimal(count);
  buffer_ += '\n';
  // OpenFOAM expects no brackets around an empty binary list.
  if (count > 0 || format_ == FoamFormat::Ascii)
  {
    buffer_ += format_ == FoamFormat::Binary ? "(" : "(\n";
  }
}

void FoamFile::end(std::size_t count)
{
  buffer_ += count > 0 || format_ == FoamFormat::Ascii ? ")\n" : "\n";
}

void FoamFile::flush(std::size_t least)
{
  if (buffer_.size() >= least)
  {
    file_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    buffer_.clear();
  }
}

}
