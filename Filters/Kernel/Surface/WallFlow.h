// SPDX-License-Identifier: BSD-3-Clause
// The height of the first layer from y+, the dimensionless distance of the wall cells' centres.
#pragma once

#include "Base/Range.h"

namespace cartesian
{

// In units of the surface and seconds.
struct WallFlow
{
  static constexpr Range YPlus{ 0 };
  static constexpr Range Speeds = moreThan(0);
  static constexpr Range Viscosities = moreThan(0);
  static constexpr Range Lengths{ 0 };

  double targetYPlus = 0; // 0: not given
  double speed = 10;
  double viscosity = 1.5e-5; // kinematic; default: air's, in m2/s
  double length = 0;         // of the boundary layer; 0: the surface's longest side
};

// Throws Error: BadParameter.
void requireValid(const WallFlow& flow);

// Twice the distance at which a cell's centre has the target y+ in the turbulent boundary layer of a flat plate, where the
// friction coefficient is 0.058 Re^-0.2 (Schlichting, Boundary-Layer Theory, from the 1/7 power law). `length`: for a flow
// without one.
double firstThicknessFor(const WallFlow& flow, double length);

}
