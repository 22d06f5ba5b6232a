// SPDX-License-Identifier: BSD-3-Clause
// A short list on the stack, for hot paths that must not allocate. Full, it takes no more, and says so.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace cartesian
{

template <class T, std::size_t Capacity>
class FixedList
{
public:
  // False: it is full.
  bool add(const T& value)
  {
    if (size_ == Capacity)
    {
      return false;
    }
    at_[size_++] = value;
    return true;
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  void clear() { size_ = 0; }
  void pop() { --size_; }
  void resize(std::size_t size) { size_ = std::min(size, Capacity); }

  T& operator[](std::size_t i) { return at_[i]; }
  const T& operator[](std::size_t i) const { return at_[i]; }
  T& back() { return at_[size_ - 1]; }
  T* data() { return at_.data(); }
  const T* data() const { return at_.data(); }
  T* begin() { return at_.data(); }
  T* end() { return at_.data() + size_; }
  const T* begin() const { return at_.data(); }
  const T* end() const { return at_.data() + size_; }

  bool contains(const T& value) const { return std::find(begin(), end(), value) != end(); }

private:
  std::array<T, Capacity> at_;
  std::size_t size_ = 0;
};

}
