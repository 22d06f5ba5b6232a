// SPDX-License-Identifier: BSD-3-Clause
// A set of labels, such as those of a region's faces, as runs of consecutive ones: few where a mesh is numbered box
// after box. It gives the number of each label in the set.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cartesian
{

class LabelRuns
{
public:
  LabelRuns() = default;

  // In any order, and as often as they like.
  explicit LabelRuns(std::vector<std::int32_t> labels);

  void add(const LabelRuns& others);

  std::size_t size() const;

  // How many labels of the set are below this one.
  std::size_t countBelow(std::int32_t label) const;

  // Appends the set as numbers that processes can exchange; takes it from there, and moves `next` on.
  void appendTo(std::vector<double>& numbers) const;
  static LabelRuns takeFrom(std::vector<double>::const_iterator& next);

private:
  struct Run
  {
    std::int32_t begin;
    std::int32_t end;
    std::size_t before; // labels in earlier runs
  };

  void unite(const std::vector<Run>& runs);

  std::vector<Run> runs_; // ascending, with gaps between them
};

}
