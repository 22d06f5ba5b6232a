// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/FaceMending.h"

#include <cmath>

namespace cartesian
{

namespace
{

// Faces that become one may cut off less than the rest of a cell.
constexpr double LeastVolumeLeft = 0.8;

// Where no pair of faces helps, those that meet at less become one, in degrees.
constexpr std::array<double, 5> WiderAngles{ 30, 45, 60, 90, 180 };

constexpr double RadiansPerDegree = Pi / 180;

}

bool FaceMender::joinFaces(CellKey key, double leastCosine)
{
  look(key);
  if (isThin(shape_))
  {
    return false;
  }
  const CellFaults before = faultsOf(view_.shape, shape_, view_.beyond);
  const JoinedFaces joined = cartesian::joinFaces(view_, shape_, { leastCosine, 1 });
  if (joined.groups.empty() || !tryOut(joined).isBetterThan(before) || !keepsCell() ||
    complex_.hasFacesNear(key, view_, joined))
  {
    return false;
  }
  complex_.open(key);
  complex_.join(key, view_, joined);
  return true;
}

bool FaceMender::mend(CellKey key)
{
  bool any = false;
  while (mendFace(key))
  {
    any = true;
  }
  for (const double angle : WiderAngles)
  {
    if (complex_.isAtFault(key))
    {
      any = joinFaces(key, std::cos(angle * RadiansPerDegree)) || any;
    }
  }
  return any;
}

void FaceMender::look(CellKey key)
{
  complex_.view({ key }, view_);
  complex_.lookBeyond(key, view_);
  measure(view_.shape, shape_);
}

CellFaults FaceMender::tryOut(const JoinedFaces& joined)
{
  trial_ = shapeOf(view_, joined, beyond_);
  measure(trial_, after_);
  return faultsOf(trial_, after_, beyond_);
}

// What was tried out.
bool FaceMender::keepsCell() const
{
  return trial_.faces() >= LeastFaces && after_.volume > LeastVolumeLeft * shape_.volume;
}

// Makes a boundary face at fault and the neighbour with which most is mended one; returns whether it could.
bool FaceMender::mendFace(CellKey key)
{
  look(key);
  if (view_.faces.size() > MostFacesJoined)
  {
    return false;
  }
  CellFaults best = faultsOf(view_.shape, shape_, view_.beyond);
  JoinedFaces bestJoined;
  for (std::uint32_t face = 0; face < view_.faces.size(); ++face)
  {
    if (!view_.shape.isBoundary[face] || view_.across[face] != None ||
      !isAtFault(view_.shape, shape_, face))
    {
      continue;
    }
    for (JoinedFaces& joined : joinFace(view_, shape_, face))
    {
      const CellFaults fitness = tryOut(joined);
      if (fitness.isBetterThan(best) && keepsCell() && !complex_.hasFacesNear(key, view_, joined))
      {
        best = fitness;
        bestJoined = std::move(joined);
      }
    }
  }
  if (bestJoined.groups.empty())
  {
    return false;
  }
  complex_.open(key);
  complex_.join(key, view_, bestJoined);
  return true;
}

}
