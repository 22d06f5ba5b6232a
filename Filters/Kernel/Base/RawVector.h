// SPDX-License-Identifier: BSD-3-Clause
// A vector whose new elements are left uninitialised: for large arrays that all threads fill in
// parallel, where zeroing them first on one thread would take as long.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace cartesian
{

template <class T>
struct RawAllocator : std::allocator<T>
{
  static_assert(std::is_trivially_copyable_v<T>);

  template <class U>
  struct rebind // NOLINT(readability-identifier-naming): the standard's name
  {
    using other = RawAllocator<U>;
  };

  template <class U, class... Arguments>
  void construct(U* at, Arguments&&... arguments)
  {
    if constexpr (sizeof...(Arguments) == 0)
    {
      ::new (static_cast<void*>(at)) U;
    }
    else
    {
      ::new (static_cast<void*>(at)) U{ std::forward<Arguments>(arguments)... };
    }
  }
};

template <class T>
using RawVector = std::vector<T, RawAllocator<T>>;

}
