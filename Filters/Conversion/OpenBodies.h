// SPDX-License-Identifier: BSD-3-Clause
// Open bodies: faces of a CAD file that form no solid. Beside solids they bound no space.
#pragma once

#include "BoundaryNames.h"
#include "Surface/Surface.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace cartesian
{

// The cell array of surfaces that know their open bodies, as CAD systems do: not 0 on polygons of one.
constexpr const char* OpenBodyArray = "OpenBody";

// Of open bodies, what was left out of a surface, by boundary.
class LeftOutBodies
{
public:
  void add(std::int32_t boundary, const std::array<Vector, 3>& triangle);

  // A message; empty if nothing was left out.
  std::string describe(const BoundaryNames& names) const;

private:
  struct Part
  {
    double area = 0;
    Vector place{}; // of its first triangle
  };
  std::map<std::int32_t, Part> parts_;
};

// The region whose triangles wind around a place, or the first if none does. Triangles that `isOpen` names bound none.
std::int32_t regionAround(
  const SurfaceView& surface, const std::vector<std::uint8_t>& isOpen, const Vector& place);

}
