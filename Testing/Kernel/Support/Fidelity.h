// How well the boundary of a mesh shows the surface it was made of: measured from the arrays that were written,
// and the triangles that were given.
#pragma once

#include "Support/Pipeline.h"

#include <map>
#include <optional>

namespace cartesian
{

struct Fidelity
{
  double volume = 0;                    // the error of what the surface encloses, relative
  std::map<std::int32_t, double> areas; // the errors of the surface's boundaries, relative
  double boundaryOff = 0;  // the largest distance of a boundary face's corner or centre, in boxes
  double surfaceOff = 0;   // ... and back, of places all over the surface
  double edgesKept = 1;    // the part of the length of its sharp edges that the mesh has, too
  std::size_t leaning = 0; // boundary faces turned more than 45 degrees from the surface near them

  double worstArea() const;
};

// `box`: the length of one along the surface. `around`: the box that is meshed, if it is the space around the
// surface. Edges are sharp where the surface turns by more than `featureAngle` (degrees); the mesh keeps as much of
// them as has an edge that turns by more than half of it within a tenth of a box.
Fidelity fidelityOf(const MeshArrays& mesh, const Soup& soup, double box, double featureAngle,
  const std::optional<Bounds>& around = {});

}
