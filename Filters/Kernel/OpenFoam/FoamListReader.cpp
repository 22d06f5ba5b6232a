// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/FoamListReader.h"

#include "Base/Error.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>

namespace cartesian
{

namespace
{

constexpr const char* Blank = " \t\r\n";
constexpr std::size_t ShortestItem = 2; // a digit and a blank

}

FoamListReader::FoamListReader(const std::filesystem::path& path)
  : path_(path)
{
  std::ifstream file(path, std::ios::binary);
  text_.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  if (!file)
  {
    std::filesystem::path compressed = path;
    compressed += ".gz";
    throw Error(Fault::CannotRead,
      "Cannot read " + path.string() +
        (std::filesystem::exists(compressed)
            ? ": it is compressed. Run gunzip on the files of this folder."
            : ": there is no such file. Give the folder polyMesh of a case."));
  }
  readHeader();
}

void FoamListReader::readHeader()
{
  const std::size_t name = text_.find("FoamFile");
  const std::size_t begin = std::min(text_.find('{', name), text_.size());
  const std::size_t end = std::min(text_.find('}', begin), text_.size());
  if (name == std::string::npos || end == text_.size())
  {
    refuse("it has no header FoamFile { ... }");
  }
  at_ = end + 1;
  isBinary_ = entryOf("format", begin, end) == "binary";
  isCompact_ = entryOf("class", begin, end) == "faceCompactList";
  const std::string arch = entryOf("arch", begin, end);
  if (isBinary_ && !arch.empty() && arch != "\"LSB;label=32;scalar=64\"")
  {
    refuse("its numbers are " + arch +
      ", not \"LSB;label=32;scalar=64\": convert it to ASCII "
      "with foamFormatConvert");
  }
}

std::string FoamListReader::entryOf(
  const std::string& key, std::size_t begin, std::size_t end) const
{
  for (std::size_t at = text_.find(key, begin); at < end; at = text_.find(key, at + 1))
  {
    const std::size_t value = text_.find_first_not_of(Blank, at + key.size());
    if (std::strchr(Blank, text_[at - 1]) && value > at + key.size() && value < end)
    {
      const bool isQuoted = text_[value] == '"';
      const std::size_t last = text_.find(isQuoted ? '"' : ';', value + 1);
      return text_.substr(value, last - value + (isQuoted ? 1 : 0));
    }
  }
  return {};
}

std::vector<std::uint32_t> FoamListReader::labels(std::size_t most)
{
  const std::size_t size = count(most);
  if (isBinary_)
  {
    return raw<std::uint32_t>(size);
  }
  std::vector<std::uint32_t> result(size);
  if (take('{')) // all the same
  {
    std::fill(result.begin(), result.end(), value<std::uint32_t>());
    require('}');
    return result;
  }
  require('(');
  for (std::uint32_t& label : result)
  {
    label = value<std::uint32_t>();
  }
  require(')');
  return result;
}

std::vector<double> FoamListReader::vectors()
{
  const std::size_t size = count(text_.size());
  if (isBinary_)
  {
    return raw<double>(3 * size);
  }
  std::vector<double> numbers(3 * size);
  require('(');
  for (std::size_t i = 0; i < size; ++i)
  {
    require('(');
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      numbers[3 * i + axis] = value<double>();
    }
    require(')');
  }
  require(')');
  return numbers;
}

void FoamListReader::labelLists(
  std::vector<std::size_t>& start, std::vector<std::uint32_t>& corners)
{
  if (isCompact_)
  {
    const std::vector<std::uint32_t> starts = labels(text_.size());
    start.assign(starts.begin(), starts.end());
    corners = labels(text_.size());
    if (start.empty() || start.front() != 0 || start.back() != corners.size() ||
      !std::is_sorted(start.begin(), start.end()))
    {
      refuse("its lists do not fit together");
    }
    return;
  }
  start = { 0 };
  corners.clear();
  const std::size_t size = count(text_.size());
  require('(');
  for (std::size_t i = 0; i < size; ++i)
  {
    const std::vector<std::uint32_t> list = labels(text_.size());
    corners.insert(corners.end(), list.begin(), list.end());
    start.push_back(corners.size());
  }
  require(')');
}

// Of a list that begins here.
std::size_t FoamListReader::count(std::size_t most)
{
  const auto size = value<std::uint32_t>();
  if (size > most || (!isBinary_ && size > text_.size() / ShortestItem && most == text_.size()))
  {
    refuse("a list of " + std::to_string(size) + " items is too long");
  }
  return size;
}

void FoamListReader::skipBlanks()
{
  while (at_ < text_.size())
  {
    at_ = std::min(text_.find_first_not_of(Blank, at_), text_.size());
    const bool isLine = text_.compare(at_, 2, "//") == 0;
    if (!isLine && text_.compare(at_, 2, "/*") != 0)
    {
      return;
    }
    const std::size_t end = text_.find(isLine ? "\n" : "*/", at_ + 2);
    at_ = end == std::string::npos ? text_.size() : end + (isLine ? 1 : 2);
  }
}

bool FoamListReader::take(char expected)
{
  skipBlanks();
  const bool isThere = at_ < text_.size() && text_[at_] == expected;
  at_ += isThere ? 1 : 0;
  return isThere;
}

void FoamListReader::require(char expected)
{
  if (!take(expected))
  {
    refuse(std::string("'") + expected + "' is missing");
  }
}

template <class Value>
Value FoamListReader::value()
{
  skipBlanks();
  Value result{};
  const auto [end, error] =
    std::from_chars(text_.data() + at_, text_.data() + text_.size(), result);
  if (error != std::errc())
  {
    refuse("a number is missing");
  }
  at_ = static_cast<std::size_t>(end - text_.data());
  return result;
}

template <class Value>
std::vector<Value> FoamListReader::raw(std::size_t count)
{
  std::vector<Value> result(count);
  if (count > 0) // else there are no brackets
  {
    require('(');
    const std::size_t bytes = count * sizeof(Value);
    if (bytes > text_.size() - at_)
    {
      refuse("it ends early");
    }
    std::memcpy(result.data(), text_.data() + at_, bytes);
    at_ += bytes;
    require(')');
  }
  return result;
}

void FoamListReader::refuse(const std::string& what) const
{
  const auto line =
    std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
  throw Error(Fault::CannotRead,
    "Cannot read " + path_.string() + ": " + what +
      (isBinary_ ? "" : ", in line " + std::to_string(line + 1)) +
      ". Write the mesh again with the program that made it.");
}

}
