// SPDX-License-Identifier: BSD-3-Clause
#include "CadGaps.h"

#include "CadPart.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <Bnd_Box.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <vector>

namespace cartesian
{

namespace
{

// Of an edge's length: edges further apart have nothing to do with each other.
constexpr double WidestOfLength = 0.02;

// Edges that are compared with all others.
constexpr int MostEdges = 300;

class FreeEdge
{
public:
  explicit FreeEdge(const TopoDS_Edge& edge)
    : edge_(edge)
    , curve_(edge)
    , length_(GCPnts_AbscissaPoint::Length(curve_))
  {
    BRepBndLib::Add(edge, box_, Standard_False);
  }

  // The largest distance of its inner quarters from the other; 0 if that is elsewhere.
  double gapTo(const FreeEdge& other) const
  {
    constexpr double Apart = 1e300;
    Bnd_Box around = box_;
    around.Enlarge(WidestOfLength * length_);
    if (around.IsOut(other.box_))
    {
      return 0;
    }
    double largest = 0;
    for (const double part : { 0.25, 0.5, 0.75 })
    {
      const double first = curve_.FirstParameter();
      const gp_Pnt point = curve_.Value(first + part * (curve_.LastParameter() - first));
      const BRepExtrema_DistShapeShape distance(
        BRepBuilderAPI_MakeVertex(point).Vertex(), other.edge_);
      largest = std::max(largest, distance.IsDone() ? distance.Value() : Apart);
    }
    return largest <= WidestOfLength * length_ ? largest : 0;
  }

private:
  TopoDS_Edge edge_;
  BRepAdaptor_Curve curve_;
  double length_;
  Bnd_Box box_;
};

}

double widestGap(const TopoDS_Shape& shape)
{
  const TopTools_IndexedMapOfShape free = freeEdges(shape);
  TopTools_IndexedDataMapOfShapeListOfShape facesOfEdges;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, facesOfEdges);
  std::vector<FreeEdge> edges;
  for (int i = 1; i <= free.Extent(); ++i)
  {
    edges.emplace_back(TopoDS::Edge(free(i)));
  }
  const auto faceOf = [&](int edge) -> const TopoDS_Shape& {
    return facesOfEdges.FindFromKey(free(edge)).First();
  };
  double widest = 0;
  for (int i = 1; i <= std::min(free.Extent(), MostEdges); ++i)
  {
    const FreeEdge& edge = edges[static_cast<std::size_t>(i - 1)];
    for (int k = 1; k <= free.Extent(); ++k)
    {
      if (!faceOf(i).IsSame(faceOf(k)))
      {
        widest = std::max(widest, edge.gapTo(edges[static_cast<std::size_t>(k - 1)]));
      }
    }
  }
  return widest;
}

}
