#pragma once

#include "Facts.h"

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pnt.hxx>
#include <gp_Trsf.hxx>

#include <functional>
#include <string>
#include <vector>

namespace cartesian
{

constexpr double Pi = 3.14159265358979323846;
constexpr double Degree = Pi / 180;

// By two opposite corners.
TopoDS_Shape box(const gp_Pnt& low, const gp_Pnt& high);
TopoDS_Shape cylinder(const gp_Ax2& base, double radius, double height);
// A polygon in the plane y = 0, which sweeps to y = depth.
TopoDS_Shape prism(const std::vector<gp_Pnt>& polygon, double depth);
// A rectangle by a corner and two sides.
TopoDS_Face rectangle(const gp_Pnt& corner, const gp_Vec& one, const gp_Vec& other);

TopoDS_Shape fused(const TopoDS_Shape& one, const TopoDS_Shape& other);
TopoDS_Shape cut(const TopoDS_Shape& from, const TopoDS_Shape& tool);
TopoDS_Shape compound(const std::vector<TopoDS_Shape>& shapes);
// Geometry of its own, not an instance.
TopoDS_Shape moved(const TopoDS_Shape& shape, const gp_Trsf& by);

gp_Trsf translation(const gp_Vec& by);
gp_Trsf turnAboutZ(double angle);

std::vector<TopoDS_Face> facesOf(const TopoDS_Shape& shape);
// The only face that has the point.
TopoDS_Face faceAt(const TopoDS_Shape& shape, const gp_Pnt& point);
// The edge that has these ends.
TopoDS_Edge edgeBetween(const TopoDS_Shape& shape, const gp_Pnt& start, const gp_Pnt& end);

// A cuboid around the origin with a hole along z: 7 faces.
TopoDS_Shape boxWithHole(double x, double y, double z, double radius);
SolidFacts boxWithHoleFacts(const std::string& name, double x, double y, double z, double radius);
SolidFacts boxFacts(const std::string& name, double x, double y, double z);

// About an axis across none of a grid's.
gp_Trsf turnOf(int degrees);

// Three sizes at four turns, with a name for each.
void forEachPlace(
  const std::function<void(double size, const gp_Trsf& place, const std::string& name)>& make);

}
