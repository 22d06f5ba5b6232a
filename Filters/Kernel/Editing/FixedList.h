// SPDX-License-Identifier: BSD-3-Clause
// A short list on the stack, for hot paths that must not allocate. Full, it takes no more, and says so: the caller gives up
// what it is about, unless it says by another name for add() that the first ones do.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <new>
#include <stdexcept>
#include <type_traits>

namespace cartesian
{

template <class T, std::size_t Capacity>
class FixedList
{
public:
  // False: it is full.
  [[nodiscard]] bool add(const T& value)
  {
    if (size_ == Capacity)
    {
      return false;
    }
    new (items() + size_++) T(value);
    return true;
  }

  // What there must be room for. Throws std::length_error.
  void push(const T& value)
  {
    if (!add(value))
    {
      throw std::length_error("FixedList");
    }
  }

  // One of several to choose from: the first ones do.
  void offer(const T& value) { static_cast<void>(add(value)); }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  void clear() { size_ = 0; }
  void pop() { --size_; }
  void resize(std::size_t size) { size_ = std::min(size, Capacity); }

  T& operator[](std::size_t i) { return items()[i]; }
  const T& operator[](std::size_t i) const { return items()[i]; }
  T& back() { return items()[size_ - 1]; }
  T* data() { return items(); }
  const T* data() const { return items(); }
  T* begin() { return items(); }
  T* end() { return items() + size_; }
  const T* begin() const { return items(); }
  const T* end() const { return items() + size_; }

  bool contains(const T& value) const { return std::find(begin(), end(), value) != end(); }

private:
  static_assert(std::is_trivially_copy_constructible_v<T> && std::is_trivially_destructible_v<T>);

  T* items() { return reinterpret_cast<T*>(room_.data()); }
  const T* items() const { return reinterpret_cast<const T*>(room_.data()); }

  alignas(T) std::array<std::byte,
    Capacity * sizeof(T)> room_; // uninitialised: that would take longer than most uses
  std::size_t size_ = 0;
};

}
