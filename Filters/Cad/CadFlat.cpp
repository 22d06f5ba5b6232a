// SPDX-License-Identifier: BSD-3-Clause
#include "CadFlat.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <gp_Pln.hxx>

#include <algorithm>

namespace cartesian
{

namespace
{

// Of an edge, where its distance from a plane is looked at.
constexpr int Samples = 32;

std::vector<gp_XYZ> pointsAlong(const TopoDS_Edge& edge)
{
  const BRepAdaptor_Curve curve(edge);
  const double first = curve.FirstParameter();
  const double step = (curve.LastParameter() - first) / Samples;
  std::vector<gp_XYZ> points;
  for (int i = 0; i <= Samples; ++i)
  {
    points.push_back(curve.Value(first + i * step).XYZ());
  }
  if (edge.Orientation() == TopAbs_REVERSED)
  {
    std::reverse(points.begin(), points.end());
  }
  return points;
}

// The plane between edges.
class FlatFace
{
public:
  // Forward, without what holds it.
  explicit FlatFace(const TopoDS_Face& face)
    : face_(TopoDS::Face(face.Oriented(TopAbs_FORWARD)))
  {
    TopTools_IndexedMapOfShape known;
    for (TopoDS_Iterator wire(face_); wire.More(); wire.Next())
    {
      std::vector<std::vector<gp_XYZ>> curves;
      for (TopExp_Explorer edge(wire.Value(), TopAbs_EDGE); edge.More(); edge.Next())
      {
        const TopoDS_Edge& own = TopoDS::Edge(edge.Current());
        const int before = known.Extent();
        // At a seam or a pole the surface is curved.
        if (BRep_Tool::Degenerated(own) || known.Add(own.Oriented(TopAbs_FORWARD)) <= before)
        {
          isFlat_ = false;
          return;
        }
        curves.push_back(pointsAlong(own));
      }
      add(curves);
    }
    isFlat_ = normal_.Modulus() > gp::Resolution();
  }

  // Null if it is not flat.
  TopoDS_Face within(double distance) const
  {
    if (!isFlat_)
    {
      return {};
    }
    const gp_Pln plane(gp_Pnt(middle_ / count_), gp_Dir(normal_));
    const bool isNear = std::all_of(points_.begin(), points_.end(),
      [&](const gp_XYZ& point) { return plane.Distance(gp_Pnt(point)) <= distance; });
    if (!isNear)
    {
      return {};
    }
    TopoDS_Face made;
    BRep_Builder builder;
    builder.MakeFace(made, new Geom_Plane(plane), Precision::Confusion());
    for (TopoDS_Iterator wire(face_); wire.More(); wire.Next())
    {
      builder.Add(made, wire.Value());
    }
    return made;
  }

private:
  // A wire; the one around all others has the largest area, and turns as the face does.
  void add(const std::vector<std::vector<gp_XYZ>>& curves)
  {
    gp_XYZ area(0, 0, 0);
    for (const std::vector<gp_XYZ>& curve : curves)
    {
      for (std::size_t i = 0; i < curve.size(); ++i)
      {
        middle_ += curve[i];
        count_ += 1;
        points_.push_back(curve[i]);
        area +=
          i == 0 ? gp_XYZ(0, 0, 0) : (curve[i - 1] - curves[0][0]).Crossed(curve[i] - curves[0][0]);
      }
    }
    normal_ = area.Modulus() > normal_.Modulus() ? area : normal_;
  }

  TopoDS_Face face_;
  gp_XYZ normal_{ 0, 0, 0 };
  gp_XYZ middle_{ 0, 0, 0 };
  double count_ = 0;
  std::vector<gp_XYZ> points_;
  bool isFlat_ = true;
};

}

std::vector<CadPart> withFlatFaces(const std::vector<CadPart>& parts,
  const std::vector<std::vector<int>>& faces, double distance,
  std::vector<std::vector<bool>>& isFlat)
{
  const Handle(BRepTools_ReShape) change = new BRepTools_ReShape;
  isFlat.assign(parts.size(), {});
  bool isAny = false;
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    const TopTools_IndexedMapOfShape own = facesOf(parts[p].shape);
    for (const int number : faces[p])
    {
      const TopoDS_Face face = TopoDS::Face(own(number));
      const TopoDS_Face made = FlatFace(face).within(distance);
      isFlat[p].push_back(!made.IsNull());
      isAny = isAny || !made.IsNull();
      if (!made.IsNull() && !change->IsRecorded(face))
      {
        change->Replace(face, made.Oriented(face.Orientation()));
      }
    }
  }
  if (!isAny)
  {
    return {};
  }
  std::vector<CadPart> result = parts;
  for (CadPart& part : result)
  {
    part.shape = change->Apply(part.shape);
  }
  return result;
}

}
