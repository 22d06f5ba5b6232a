// SPDX-License-Identifier: BSD-3-Clause
#include "CadEdges.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>

#include <cmath>
#include <numeric>
#include <optional>

namespace cartesian
{

namespace
{

constexpr int Samples = 7; // of an edge that is looked at as a whole

// Outward; none where the surface has no normal, as at a cone's tip.
std::optional<gp_Vec> normalAt(const TopoDS_Face& face, const TopoDS_Edge& edge, double parameter)
{
  double first = 0;
  double last = 0;
  const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  if (curve.IsNull())
  {
    return {};
  }
  const gp_Pnt2d at = curve->Value(parameter);
  const BRepAdaptor_Surface surface(face, Standard_False);
  gp_Pnt point;
  gp_Vec u;
  gp_Vec v;
  surface.D1(at.X(), at.Y(), point, u, v);
  gp_Vec normal = u.Crossed(v);
  if (!(normal.Magnitude() > 1e-9 * u.Magnitude() * v.Magnitude()) ||
    normal.Magnitude() <= gp::Resolution())
  {
    return {};
  }
  return face.Orientation() == TopAbs_REVERSED ? -normal : normal;
}

}

CadEdges::CadEdges(const TopoDS_Shape& shape)
{
  // The two sides of a seam are two edges of one face.
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
  {
    for (TopExp_Explorer edge(face.Current(), TopAbs_EDGE); edge.More(); edge.Next())
    {
      const int index = facesOfEdges_.Add(edge.Current(), TopTools_ListOfShape());
      facesOfEdges_(index).Append(face.Current());
    }
  }
}

bool CadEdges::isSharpAt(const TopoDS_Shape& shape, double parameter) const
{
  const int index = facesOfEdges_.FindIndex(shape);
  if (index == 0 || facesOfEdges_(index).Extent() != 2)
  {
    return true;
  }
  const TopTools_ListOfShape& faces = facesOfEdges_(index);
  const TopoDS_Edge edge = TopoDS::Edge(facesOfEdges_.FindKey(index));
  const bool isSeam = faces.First().IsSame(faces.Last());
  const auto one = normalAt(TopoDS::Face(faces.First()), edge, parameter);
  const auto other =
    normalAt(TopoDS::Face(faces.Last()), isSeam ? TopoDS::Edge(edge.Reversed()) : edge, parameter);
  return one && other && one->Angle(*other) > LargestTangentAngle * M_PI / 180;
}

bool CadEdges::isSmooth(const TopoDS_Edge& edge) const
{
  double first = 0;
  double last = 0;
  BRep_Tool::Range(edge, first, last);
  for (int i = 0; i < Samples; ++i)
  {
    if (isSharpAt(edge, first + (last - first) * (i + 0.5) / Samples))
    {
      return false;
    }
  }
  return true;
}

std::vector<int> CadEdges::tangentGroups(const TopoDS_Shape& shape) const
{
  const TopTools_IndexedMapOfShape faces = facesOf(shape);
  std::vector<int> first(static_cast<std::size_t>(faces.Extent()));
  std::iota(first.begin(), first.end(), 0);
  const auto find = [&](int face) {
    while (first[static_cast<std::size_t>(face)] != face)
    {
      face = first[static_cast<std::size_t>(face)];
    }
    return face;
  };
  for (int i = 1; i <= facesOfEdges_.Extent(); ++i)
  {
    const TopoDS_Edge& edge = TopoDS::Edge(facesOfEdges_.FindKey(i));
    if (facesOfEdges_(i).Extent() == 2 && !BRep_Tool::Degenerated(edge) && isSmooth(edge))
    {
      const int one = find(faces.FindIndex(facesOfEdges_(i).First()) - 1);
      const int other = find(faces.FindIndex(facesOfEdges_(i).Last()) - 1);
      first[static_cast<std::size_t>(std::max(one, other))] = std::min(one, other);
    }
  }
  std::vector<int> groups(first.size());
  int count = 0;
  for (std::size_t i = 0; i < groups.size(); ++i)
  {
    const auto root = static_cast<std::size_t>(find(static_cast<int>(i)));
    groups[i] = root == i ? count++ : groups[root];
  }
  return groups;
}

}
