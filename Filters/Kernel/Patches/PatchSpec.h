// SPDX-License-Identifier: BSD-3-Clause
// User options for patches (sections 4.7, 4.8, A2).
#pragma once

#include "Base/Range.h"

#include <cstdint>

namespace cartesian
{

enum class PatchMethod : std::uint8_t
{
  Automatic = 0,     // Marching Cubes where that is safe, Exact Fit elsewhere
  ExactFit = 1,      // the surface itself, cut at the sides of the boxes and not simplified
  MarchingCubes = 2, // everywhere, for comparison
};

// Treatment of the nodes between the ends of a polyline that an Exact Fit box shares with a Marching Cubes box.
enum class Tying : std::uint8_t
{
  KeepNodes = 0, // the Marching Cubes box takes them over
  MoveNodes = 1, // they move onto the straight line between the ends (4.8, equation 5)
};

struct PatchSpec
{
  static constexpr Range FeatureAngles{ 0, 180 };
  static constexpr Range MergeAngles{ 0, 90 };

  PatchMethod method = PatchMethod::Automatic;
  double featureAngle = 30; // degrees: edges of the surface that turn by more are kept
  double mergeAngle = 10;   // degrees: how far normals within one patch may differ
  Tying tying = Tying::KeepNodes;
};

}
