// SPDX-License-Identifier: BSD-3-Clause
// One file of OpenFOAM: a header, then text or a list.
#pragma once

#include "Base/OutputFile.h"
#include "Base/RawVector.h"

#include <cstdint>

namespace cartesian
{

enum class FoamFormat
{
  Ascii, // the shortest decimals that read back as the same numbers
  Binary // labels in 32 bits and numbers in 64, as OpenFOAM is built by default
};

// All methods throw Error (CannotWrite).
class FoamFile : public OutputFile
{
public:
  struct Header
  {
    const char* className;
    std::string location; // folder of the file within the case
    std::string note;     // empty: none
  };

  FoamFile(const std::filesystem::path& path, FoamFormat format, const Header& header);

  void labels(std::size_t count, const std::function<std::int32_t(std::size_t)>& label);

  // Vectors of three numbers.
  void vectors(const std::vector<double>& numbers);

  // Lists of labels; the i-th from start[i] to start[i + 1].
  void labelLists(const std::vector<std::size_t>& start, const RawVector<std::uint32_t>& labels);

  // Whether this class wrote the file.
  static bool isOurs(const std::filesystem::path& path);

private:
  void begin(std::size_t count);
  void end(std::size_t count);

  FoamFormat format_;
};

}
