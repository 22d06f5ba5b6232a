// SPDX-License-Identifier: BSD-3-Clause
// Colours that tell categories apart.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace cartesian
{

// Red, green and blue from 0 to 1.
using Colour = std::array<double, 3>;

// `hue` in turns.
inline Colour colourOfHue(double hue, double saturation, double value)
{
  Colour rgb;
  for (std::size_t c = 0; c < rgb.size(); ++c)
  {
    const double turns = hue + 1 - static_cast<double>(c) / 3;
    const double away = std::abs(6 * (turns - std::floor(turns + 0.5))); // from this primary colour
    rgb[c] = value * (1 - saturation * std::clamp(away - 1, 0.0, 1.0));
  }
  return rgb;
}

// Of the i-th boundary. Hues a golden ratio apart differ from the last few; eight further on they come back, in another
// shade.
inline Colour colourOfBoundary(std::size_t i)
{
  constexpr double GoldenRatio = 0.618034;
  constexpr double Blue = 0.58;
  constexpr std::array<std::pair<double, double>, 3> Shades{ { { 0.45, 0.9 }, { 0.7, 0.8 },
    { 0.25, 1 } } }; // saturation, value
  const double turns = Blue + GoldenRatio * static_cast<double>(i);
  const auto& [saturation, value] = Shades[i / 8 % Shades.size()];
  return colourOfHue(turns - std::floor(turns), saturation, value);
}

}
