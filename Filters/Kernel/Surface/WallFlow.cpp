// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/WallFlow.h"

#include <cmath>

namespace cartesian
{

void requireValid(const WallFlow& flow)
{
  requireInRange(WallFlow::YPlus, flow.targetYPlus, "Target Y Plus");
  if (flow.targetYPlus > 0)
  {
    requireInRange(WallFlow::Speeds, flow.speed, "Flow Speed");
    requireInRange(WallFlow::Viscosities, flow.viscosity, "Flow Viscosity");
    requireInRange(WallFlow::Lengths, flow.length, "Flow Length");
  }
}

double firstThicknessFor(const WallFlow& flow, double length)
{
  const double along = flow.length > 0 ? flow.length : length;
  const double reynolds = flow.speed * along / flow.viscosity;
  const double friction = 0.058 * std::pow(reynolds, -0.2);
  const double frictionSpeed = flow.speed * std::sqrt(friction / 2);
  return 2 * flow.targetYPlus * flow.viscosity / frictionSpeed;
}

}
