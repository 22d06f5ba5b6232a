// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>

namespace cartesian
{

// Zeroes by number, of which only the pages that are written take memory: each editor has some for the whole mesh.
template <class T>
class Zeroes
{
public:
  T& operator[](std::uint32_t i)
  {
    if (i >= size_)
    {
      grow(i);
    }
    return at_.get()[i];
  }
  T at(std::uint32_t i) const { return i < size_ ? at_.get()[i] : T(); }

private:
  struct Free
  {
    void operator()(T* at) const { std::free(at); }
  };
  using Array = std::unique_ptr<T, Free>;

  void grow(std::uint32_t i)
  {
    const std::size_t size = std::size_t(i) + i / 2 + 1024;
    Array grown(static_cast<T*>(std::calloc(size, sizeof(T))));
    if (!grown)
    {
      throw std::bad_alloc();
    }
    std::copy_n(at_.get(), size_, grown.get());
    at_ = std::move(grown);
    size_ = size;
  }

  Array at_;
  std::size_t size_ = 0;
};

}
