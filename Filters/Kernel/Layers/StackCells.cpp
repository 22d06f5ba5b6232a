// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/StackCells.h"

#include "Base/ForEachItem.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

StackCells::StackCells(const LayeredWall& wall, const LayerHeights& heights, Execution& execution)
  : wall_(wall)
  , layers_(heights.layers())
  , counts_(wall.nodes())
  , most_(wall.layered.size())
  , regular_(wall.layered.size())
{
  for (std::size_t n = 0; n < wall.nodes(); ++n)
  {
    counts_[n] = static_cast<std::uint8_t>(heights.layersIn(wall.parts[n], wall.isFlat[n]));
  }
  forEachItem(wall.layered.size(), execution, [&](std::size_t f) { count(f, heights); });
}

void StackCells::count(std::size_t face, const LayerHeights& heights)
{
  std::size_t least = wall_.layered[face] ? layers_ : 0;
  std::size_t most = 0;
  for (std::size_t i = 0; wall_.layered[face] && i < wall_.corners(face); ++i)
  {
    least = std::min<std::size_t>(least, counts_[wall_.node(face, i)]);
    most = std::max<std::size_t>(most, counts_[wall_.node(face, i)]);
  }
  most_[face] = static_cast<std::uint8_t>(most);
  const bool isMixed = least < most;
  const double slenderness = isMixed ? std::sqrt(wall_.area(face)) / wall_.asked[face] : 0;
  regular_[face] = static_cast<std::uint8_t>(heights.layersBelow(least, most, slenderness));
}

std::size_t StackCells::begin(std::size_t face, std::size_t k) const
{
  const bool isMixed = regular_[face] < most_[face];
  return !isMixed || k == 0 ? first(face) + k : layers_ - regular_[face] + k - 1;
}

bool StackCells::beginsAt(std::size_t face, std::size_t layer) const
{
  return layer == first(face) || layer >= layers_ - regular_[face];
}

std::size_t StackCells::endAt(std::size_t face, std::size_t layer) const
{
  const std::size_t ofRegular = layers_ - regular_[face];
  return layer < first(face) ? first(face) : layer < ofRegular ? ofRegular : layer + 1;
}

// Itself, where no other face has layers there.
std::size_t StackCells::beyond(std::size_t face, std::size_t i) const
{
  const std::size_t other = wall_.faceBeyond(face, i);
  return wall_.layered[other] ? other : face;
}

bool StackCells::isSideAt(std::size_t face, std::size_t i, std::size_t layer) const
{
  return beginsAt(face, layer) || beginsAt(beyond(face, i), layer);
}

std::size_t StackCells::endOfSide(std::size_t face, std::size_t i, std::size_t layer) const
{
  return std::min(endAt(face, layer), endAt(beyond(face, i), layer));
}

}
