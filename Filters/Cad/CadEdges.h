// SPDX-License-Identifier: BSD-3-Clause
// Which edges are sharp: those between faces that are not tangent.
#pragma once

#include "CadPart.h"

#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

namespace cartesian
{

// Faces that turn by less at their edge are tangent, in degrees: what modellers write as fillets is off by up to this.
constexpr double LargestTangentAngle = 1;

// The faces at the edges of a part; a seam has its face twice.
class CadEdges
{
public:
  explicit CadEdges(const TopoDS_Shape& shape);

  // Whether the edge is sharp at that parameter. Where it bounds one face, or more than two, it is.
  bool isSharpAt(const TopoDS_Shape& shape, double parameter) const;

  // Numbers from 0, equal for faces that are joined by edges that are smooth all along, in order of facesOf().
  std::vector<int> tangentGroups(const TopoDS_Shape& shape) const;

private:
  bool isSmooth(const TopoDS_Edge& edge) const;

  TopTools_IndexedDataMapOfShapeListOfShape facesOfEdges_;
};

}
