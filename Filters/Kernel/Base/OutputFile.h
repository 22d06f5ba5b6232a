// SPDX-License-Identifier: BSD-3-Clause
// Files of text and numbers, and files that are renamed when complete.
#pragma once

#include "Base/Error.h"

#include <array>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace cartesian
{

// Methods throw Error (CannotWrite).
class OutputFile
{
public:
  explicit OutputFile(std::filesystem::path path);

  void text(std::string_view words)
  {
    buffer_ += words;
    flushIfFull();
  }

  // The shortest decimals that read back as the same number.
  template <class Value>
  void decimal(Value value)
  {
    std::array<char, 32> digits;
    text({ digits.data(),
      static_cast<std::size_t>(
        std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr - digits.data()) });
  }

  template <class Value>
  void hexadecimal(Value value)
  {
    std::array<char, 32> digits;
    text({ digits.data(),
      static_cast<std::size_t>(
        std::to_chars(digits.data(), digits.data() + digits.size(), value, 16).ptr -
        digits.data()) });
  }

  // The bytes of the number, in the order of this computer.
  template <class Value>
  void raw(Value value)
  {
    std::array<char, sizeof(Value)> bytes;
    std::memcpy(bytes.data(), &value, sizeof(Value));
    text({ bytes.data(), bytes.size() });
  }

  // Must be called at the end: until then, part of the file may not have been written.
  void close();

private:
  void flushIfFull()
  {
    if (buffer_.size() >= BufferBytes)
    {
      flush();
    }
  }
  void flush();

  static constexpr std::size_t BufferBytes = 1 << 20;

  std::filesystem::path path_;
  std::ofstream file_;
  std::string buffer_;
};

// Has files written under other names beside `paths`, whose names they take in this order when all are complete. If
// that fails, only the old files remain. Throws Error (CannotWrite), and what `write` does.
void replaceFiles(const std::vector<std::filesystem::path>& paths,
  const std::function<void(const std::vector<std::filesystem::path>& unfinished)>& write);

// Does `work`; errors of the file system become an Error (CannotWrite).
template <class Work>
void reportingFailures(Work&& work)
{
  try
  {
    work();
  }
  catch (const std::filesystem::filesystem_error& error)
  {
    throw Error(Fault::CannotWrite,
      std::string(error.what()) + ": choose another folder, or free disk space.");
  }
}

}
