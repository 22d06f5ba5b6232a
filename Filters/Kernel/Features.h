// Sharp features of the surface (section 4.7): edges at which it turns by more than an angle.
//
// A thin triangle turned over between two healthy ones is folded geometry (section 1): its edges are
// no features.
#pragma once

#include "Surface.h"
#include "Vector.h"

namespace cartesian
{

struct Features
{
  std::vector<std::uint8_t> sharp; // of each triangle; bit i: its edge from corner i to the next
  std::vector<Vector> normal;      // of each triangle, of length 1; 0 where it has no area
};

// `featureAngle` in degrees, from 0 to 180. Open and non-manifold edges are sharp.
Features findFeatures(const Surface& surface, double featureAngle, Execution& execution);

}
