// SPDX-License-Identifier: BSD-3-Clause
// The boxes beside the wall, which layers are measured by.
#pragma once

#include "Mesh/OutputMesh.h"
#include "Surface/WallLayerSpec.h"

namespace cartesian
{

// The shortest sides of boxes; halvings of the shortest global one, unless they differ from these.
class BoxSides
{
public:
  explicit BoxSides(const Boxes& boxes);

  double shortestSide(const Box& box) const; // levels
  double undivided() const { return undivided_; }

private:
  double undivided_; // the shortest, were no box divided
};

// The side that most boxes have at walls with layers, in user units; of equally many, the longest.
double usualBoxSide(
  const Boxes& boxes, const Patches& patches, const WallLayerSpec& layers, Execution& execution);

// At each face, in user units.
std::vector<double> boxSides(const OutputMesh& mesh, const std::vector<BoundaryFace>& faces);

}
