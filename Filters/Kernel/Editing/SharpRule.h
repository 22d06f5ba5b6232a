// SPDX-License-Identifier: BSD-3-Clause
// Which edges of the wall are sharp: those that the surface knows (SharpEdge), if it does, else by the Feature Angle. One
// rule for all who ask.
#pragma once

#include "Lattice/Vector.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

class SharpRule
{
public:
  // Degrees, 0 to 180. `knowsEdges`: edges between nodes on known ones are sharp, and no others.
  explicit SharpRule(double featureAngle = 30, bool knowsEdges = false)
    : knowsEdges_(knowsEdges)
    , sharp_(cosineOf(featureAngle - Slack))
    , blunt_(cosineOf(featureAngle - Blunt))
    , fully_(cosineOf(featureAngle + Fully))
  {
  }

  // Of an edge whose faces' normals have this cosine; `isOnKnown`: both of its nodes are on edges or corners.
  bool isSharp(double cosine, bool isOnKnown) const
  {
    return knowsEdges_ ? isKnown(cosine, isOnKnown) : cosine < sharp_;
  }

  // 0: not at all, to 1.
  double sharpness(double cosine, bool isOnKnown) const
  {
    return knowsEdges_ ? double(isKnown(cosine, isOnKnown))
                       : std::clamp((blunt_ - cosine) / (blunt_ - fully_), 0.0, 1.0);
  }

  // Faces that turn by less do so by rounding.
  static constexpr double OfOnePlane = 0.99996; // cosine

private:
  // In degrees about the feature angle: walls of cells turn by a little less than the surface. Between the last two, an
  // edge is partly sharp.
  static constexpr double Slack = 5;
  static constexpr double Blunt = 10;
  static constexpr double Fully = 3;

  static double cosineOf(double degrees)
  {
    return std::cos(radians(std::clamp(degrees, 0.0, 180.0)));
  }
  static bool isKnown(double cosine, bool isOnKnown) { return isOnKnown && cosine < OfOnePlane; }

  bool knowsEdges_;
  double sharp_; // cosines
  double blunt_;
  double fully_;
};

}
