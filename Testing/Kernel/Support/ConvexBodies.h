// Volumes of unions of convex bodies, by inclusion and exclusion: known without any arrangement.
#pragma once

#include "Support/Shapes.h"

namespace cartesian
{

double volumeOfUnion(const std::vector<Soup>& bodies);

// Of what lies in the last of them and in no other.
inline double volumeLeft(const std::vector<Soup>& bodies)
{
  return volumeOfUnion(bodies) - volumeOfUnion({ bodies.begin(), bodies.end() - 1 });
}

}
