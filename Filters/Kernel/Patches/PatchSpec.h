// What the user chooses about patches (sections 4.7, 4.8, A2).
#pragma once

#include <cstdint>

namespace cartesian
{

enum class PatchMethod : std::uint8_t
{
  Automatic = 0,     // Marching Cubes where that is safe, Exact Fit elsewhere
  ExactFit = 1,      // the surface itself, cut at the sides of the boxes and not simplified
  MarchingCubes = 2, // everywhere, for comparison
};

// What happens to the nodes between the ends of a polyline that an Exact Fit box shares with a Marching
// Cubes box.
enum class Tying : std::uint8_t
{
  KeepNodes = 0, // the Marching Cubes box takes them over
  MoveNodes = 1, // they move onto the straight line between the ends (4.8, equation 5)
};

struct PatchSpec
{
  PatchMethod method = PatchMethod::Automatic;
  double featureAngle = 30; // degrees, 0 to 180: edges that turn by more are kept
  double mergeAngle =
    15; // degrees, 0 to 90: how far the normals of what becomes one patch may differ
  Tying tying = Tying::KeepNodes;
};

}
