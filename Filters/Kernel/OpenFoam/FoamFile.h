// SPDX-License-Identifier: BSD-3-Clause
// One file of OpenFOAM: a header, then text or a list.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace cartesian
{

enum class FoamFormat
{
  Ascii, // the shortest decimals that read back as the same numbers
  Binary // labels in 32 bits and numbers in 64, as OpenFOAM is built by default
};

// All methods throw Error (CannotWrite).
class FoamFile
{
public:
  struct Header
  {
    const char* className;
    std::string location; // folder of the file within the case
    std::string note;     // empty: none
  };

  FoamFile(const std::filesystem::path& path, FoamFormat format, const Header& header);

  void text(const std::string& words);

  void labels(std::size_t count, const std::function<std::int32_t(std::size_t)>& label);

  // Vectors of three numbers.
  void vectors(const std::vector<double>& numbers);

  // Lists of labels; the i-th from start[i] to start[i + 1].
  void labelLists(const std::vector<std::size_t>& start, const std::vector<std::uint32_t>& labels);

  // Must be called at the end: until then, part of the file may not have been written.
  void close();

  // Whether this class wrote the file.
  static bool isOurs(const std::filesystem::path& path);

private:
  template <class Value>
  void decimal(Value value);
  template <class Value>
  void raw(Value value);
  void begin(std::size_t count);
  void end(std::size_t count);
  void flush(std::size_t least);

  std::filesystem::path path_;
  FoamFormat format_;
  std::ofstream file_;
  std::string buffer_;
};

}
