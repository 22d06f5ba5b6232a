// SPDX-License-Identifier: BSD-3-Clause
// From places on a displaced surface to those on the surface as it was.
#pragma once

#include "Displacement/Displacement.h"

namespace cartesian
{

// Of the walls with layers. The surface and its displacement must stay as they are.
class WallLift
{
public:
  WallLift(const Surface& displaced, const Displacement& displacement, Execution& execution);

  const Displacement& displacement() const { return displacement_; }

  // In levels: where a point goes with its place on the nearest displaced triangle (of equally near ones the
  // first), if that becomes what it was. Itself, if there is no such wall.
  Vector operator()(const Vector& at) const;

  // The nearest displaced triangle, or NoTriangle.
  static constexpr std::uint32_t NoTriangle = ~0U;
  std::uint32_t triangleAt(const Vector& at) const;

  // Whether layers fit between the two.
  bool hasRoom(const Vector& from, const Vector& to) const;

private:
  class Search;

  const Surface& surface_;
  const Displacement& displacement_;
  const TriangleTree tree_;
};

}
