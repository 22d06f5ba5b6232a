// SPDX-License-Identifier: BSD-3-Clause
// Unused objects kept for reuse, so that nested containers, which are filled anew for each box or
// side, keep their memory.
#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

namespace cartesian
{

template <class T>
class ObjectPool
{
public:
  // A new object, or a released one in the state in which it was left.
  T acquire()
  {
    if (unused_.empty())
    {
      return {};
    }
    T object = std::move(unused_.back());
    unused_.pop_back();
    return object;
  }

  // Takes all objects; leaves `objects` empty.
  void release(std::vector<T>& objects)
  {
    std::move(objects.begin(), objects.end(), std::back_inserter(unused_));
    objects.clear();
  }

private:
  std::vector<T> unused_;
};

}
