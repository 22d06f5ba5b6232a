// SPDX-License-Identifier: BSD-3-Clause
// One file of OpenFOAM that holds a list: what FoamFile writes, and OpenFOAM.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cartesian
{

// All methods throw Error (CannotRead).
class FoamListReader
{
public:
  // Reads the file and its header.
  explicit FoamListReader(const std::filesystem::path& path);

  // At most `most` of them.
  std::vector<std::uint32_t> labels(std::size_t most);

  // Three numbers each.
  std::vector<double> vectors();

  // Lists of labels, `corners`, the i-th from start[i] to start[i + 1].
  void labelLists(std::vector<std::size_t>& start, std::vector<std::uint32_t>& corners);

private:
  void readHeader();
  std::string entryOf(const std::string& key, std::size_t begin, std::size_t end) const;

  std::size_t count(std::size_t most);
  void skipBlanks();
  bool take(char expected);
  void require(char expected);
  template <class Value>
  Value value();
  template <class Value>
  std::vector<Value> raw(std::size_t count);
  [[noreturn]] void refuse(const std::string& what) const;

  std::filesystem::path path_;
  std::string text_;
  std::size_t at_ = 0;
  bool isBinary_ = false;
  bool isCompact_ = false; // lists of labels are two lists: starts, and all labels
};

}
