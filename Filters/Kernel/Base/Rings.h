// SPDX-License-Identifier: BSD-3-Clause
// Neighbours in a closed list, such as the corners of a polygon; `i` is below its size.
#pragma once

#include <cstddef>
#include <iterator>

namespace cartesian
{

template <class Ring>
decltype(auto) following(const Ring& ring, std::size_t i)
{
  return ring[i + 1 < std::size(ring) ? i + 1 : 0];
}

template <class Ring>
decltype(auto) preceding(const Ring& ring, std::size_t i)
{
  return ring[(i > 0 ? i : std::size(ring)) - 1];
}

}
