// SPDX-License-Identifier: BSD-3-Clause
// User options for boundary layers.
#pragma once

#include "Base/Range.h"

#include <cstdint>
#include <vector>

namespace cartesian
{

struct WallLayerSpec
{
  static constexpr Range Counts{ 0, 50 };
  static constexpr Range Ratios{ 1, 3 };
  static constexpr Range Thicknesses{ 0 };

  int count = 0;      // 0: no layers
  double ratio = 1.2; // of the thicknesses of two layers, away from the wall

  // User units; the first that is not 0 applies. Both 0: all layers together are a third of the box
  // at that place.
  double firstThickness = 0;
  double thickness = 0; // of all layers

  // Boundaries that are unlike the others; of several entries the first applies.
  struct OfBoundary
  {
    std::int32_t boundary;
    double thickness; // of all layers, in user units; 0: none
  };
  std::vector<OfBoundary> boundaries;

  std::vector<std::int32_t> regions; // with layers; none: all (Walls.h)

  // Of all layers on a boundary. `usual`: on others.
  double thicknessAt(std::int32_t boundary, double usual) const;
  bool isIn(std::int32_t region) const;
  bool hasLayers(std::int32_t boundary) const { return thicknessAt(boundary, 1) > 0; }
};

// Throws Error: BadParameter.
void requireValid(const WallLayerSpec& spec);

// Of all layers, in user units, except on `boundaries`. `box`: the shortest side of the box there.
double totalThickness(const WallLayerSpec& spec, double box);

// The height above the wall at which each layer ends, as a part of the total: 0, ..., 1.
std::vector<double> heightsOfLayers(const WallLayerSpec& spec);

}
