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

// By which an automatic number of layers is chosen, in user units: the side of the boxes that most of the walls with layers passes
// through, of equal parts the longest; half of it if some are smaller: layers as high as most of those would end there.
double boxSideForLayers(
  const Boxes& boxes, const Patches& patches, const WallLayerSpec& layers, Execution& execution);

// At each face, in user units.
std::vector<double> boxSides(const OutputMesh& mesh, const std::vector<BoundaryFace>& faces);

}
