// SPDX-License-Identifier: BSD-3-Clause
// Which edges of the wall are sharp, for all edits that ask: what they lose of these is charged.
#pragma once

#include "Lattice/Vector.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

// An edge is sharp if the surface knows it (SharpEdge), or if the walls turn there by nearly the Feature Angle. An angle
// beyond the usual one keeps fewer edges on nodes, but edits must not round off what boxes have kept of them.
class SharpRule
{
public:
  // Degrees, 0 to 180. `knowsEdges`: the surface does, and its angle counts for nothing.
  explicit SharpRule(double featureAngle = Usual, bool knowsEdges = false)
    : knowsEdges_(knowsEdges)
  {
    const double angle = knowsEdges ? Usual : std::clamp(featureAngle, 0.0, Usual);
    sharp_ = cosineOf(angle - Slack);
    blunt_ = cosineOf(angle - Blunt);
    fully_ = cosineOf(angle + Fully);
  }

  // Of an edge whose faces' normals have this cosine; `areOnEdges`: both of its nodes are on edges or corners.
  bool isSharp(double cosine, bool areOnEdges) const
  {
    return cosine < sharp_ || isKnown(cosine, areOnEdges);
  }

  // 0: not at all, to 1.
  double sharpness(double cosine, bool areOnEdges) const
  {
    return isKnown(cosine, areOnEdges)
      ? 1
      : std::clamp((blunt_ - cosine) / (blunt_ - fully_), 0.0, 1.0);
  }

  // Faces that turn by less do so by rounding.
  static constexpr double OfOnePlane = 0.99996; // cosine

private:
  static constexpr double Usual = 30; // degrees

  // In degrees about the angle: walls of cells turn by a little less than the surface. Between the last two (cosines of
  // 0.94 and 0.84 about the usual angle), an edge is partly sharp.
  static constexpr double Slack = 5;
  static constexpr double Blunt = 10.05;
  static constexpr double Fully = 2.86;

  static double cosineOf(double degrees) { return std::cos(radians(std::max(degrees, 0.0))); }

  bool isKnown(double cosine, bool areOnEdges) const
  {
    return knowsEdges_ && areOnEdges && cosine < OfOnePlane;
  }

  bool knowsEdges_;
  double sharp_ = 1; // cosines
  double blunt_ = 1;
  double fully_ = 1;
};

}
