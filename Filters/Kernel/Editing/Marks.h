// SPDX-License-Identifier: BSD-3-Clause
// Numbers that are marked, and values by number: all forgotten at once.
#pragma once

#include "Editing/Zeroes.h"

#include <cstdint>

namespace cartesian
{

class Marks
{
public:
  // None is marked from now on.
  void begin() { ++last_; }

  // Whether it was not marked yet.
  bool mark(std::uint32_t i)
  {
    std::uint32_t& at = marks_[i];
    const bool isNew = at != last_;
    at = last_;
    return isNew;
  }
  bool contains(std::uint32_t i) const { return marks_.at(i) == last_; }

private:
  Zeroes<std::uint32_t> marks_;
  std::uint32_t last_ = 0;
};

// Zero where none was set.
template <class T>
class ValuesByNumber
{
public:
  void begin() { ++last_; }
  T& operator[](std::uint32_t i)
  {
    Entry& entry = entries_[i];
    entry = entry.last == last_ ? entry : Entry{ T(), last_ };
    return entry.value;
  }
  T at(std::uint32_t i) const
  {
    const Entry entry = entries_.at(i);
    return entry.last == last_ ? entry.value : T();
  }

private:
  struct Entry
  {
    T value;
    std::uint32_t last;
  };

  Zeroes<Entry> entries_;
  std::uint32_t last_ = 0;
};

}
