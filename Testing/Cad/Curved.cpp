// Roundings, creases, kinks, seams and poles.
#include "Parts.h"
#include "Shapes.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Ax1.hxx>

#include <cmath>

namespace cartesian
{

namespace
{

constexpr double X = 30, Y = 20, Z = 10;

void write(Folder& folder, const std::string& file, const TopoDS_Shape& shape,
  const SolidFacts& solid, int faces, const std::map<std::string, double>& others = {},
  Integrals integrals = Integrals::FixedOrder)
{
  Document document;
  document.add(shape, solid.name);
  Facts facts;
  facts.solids = { solid };
  facts.faces = faces;
  facts.others = others;
  facts.integrals = integrals;
  folder.step(file, document, facts);
}

// All faces are tangent to their neighbours. Volume and area are Steiner's for what lies within *radius* of a cuboid.
void roundedBox(Folder& folder)
{
  const double radius = 3;
  const TopoDS_Shape sharp = box(gp::Origin(), { X, Y, Z });
  BRepFilletAPI_MakeFillet fillet(sharp);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(sharp, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i)
  {
    fillet.Add(radius, TopoDS::Edge(edges(i)));
  }
  const double x = X - 2 * radius, y = Y - 2 * radius, z = Z - 2 * radius;
  SolidFacts solid = boxFacts("rounded_box", x, y, z);
  solid.volume +=
    solid.area * radius + Pi * radius * radius * (x + y + z) + 4.0 / 3 * Pi * std::pow(radius, 3);
  solid.area += 2 * Pi * radius * (x + y + z) + 4 * Pi * radius * radius;
  write(folder, "rounded_box.step", fillet.Shape(), solid, 26, { { "tangentGroups", 1 } });
}

// Three of its faces are one tangent group, the other four have a group each.
void roundedEdge(Folder& folder)
{
  const double radius = 3;
  const TopoDS_Shape sharp = box(gp::Origin(), { X, Y, Z });
  BRepFilletAPI_MakeFillet fillet(sharp);
  fillet.Add(radius, edgeBetween(sharp, { X, 0, Z }, { X, Y, Z }));
  const double corner = (1 - Pi / 4) * radius * radius;
  SolidFacts solid = boxFacts("rounded_edge", X, Y, Z);
  solid.volume -= corner * Y;
  solid.area += (Pi / 2 - 2) * radius * Y - 2 * corner;
  write(folder, "rounded_edge.step", fillet.Shape(), solid, 7, { { "tangentGroups", 5 } });
}

// The ridge of a roof, less sharp than any feature angle and yet an edge.
void crease(Folder& folder)
{
  const double degrees = 3;
  const double rise = X / 2 * std::tan(degrees / 2 * Degree);
  const TopoDS_Shape shape =
    prism({ { 0, 0, 0 }, { X, 0, 0 }, { X, 0, Z }, { X / 2, 0, Z + rise }, { 0, 0, Z } }, Y);
  const double section = X * (Z + rise / 2);
  const SolidFacts solid{ "crease", section * Y,
    2 * section + Y * (X + 2 * Z + 2 * std::hypot(X / 2, rise)) };
  write(
    folder, "crease.step", shape, solid, 7, { { "creaseDegrees", degrees }, { "sharpEdges", 15 } });
}

TopoDS_Edge polyline(const std::vector<gp_Pnt>& points)
{
  const int count = static_cast<int>(points.size());
  TColgp_Array1OfPnt poles(1, count);
  TColStd_Array1OfReal knots(1, count);
  TColStd_Array1OfInteger multiplicities(1, count);
  for (int i = 1; i <= count; ++i)
  {
    poles(i) = points[static_cast<std::size_t>(i - 1)];
    knots(i) = i;
    multiplicities(i) = (i == 1 || i == count) ? 2 : 1;
  }
  return BRepBuilderAPI_MakeEdge(new Geom_BSplineCurve(poles, knots, multiplicities, 1));
}

constexpr double KinksDepth = 8;

// One face with three kinks (a B-spline of degree 1, extruded) above a cuboid's other five.
TopoDS_Shape kinkedShape()
{
  const std::vector<gp_Pnt> top = { { 0, 0, 10 }, { 5, 0, 12 }, { 10, 0, 9 }, { 15, 0, 12 },
    { 20, 0, 10 } };
  BRepBuilderAPI_MakeWire wire(polyline(top));
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(20, 0, 10), gp_Pnt(20, 0, 0)));
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(20, 0, 0), gp_Pnt(0, 0, 0)));
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(0, 0, 10)));
  return BRepPrimAPI_MakePrism(
    BRepBuilderAPI_MakeFace(wire.Wire()).Face(), gp_Vec(0, KinksDepth, 0))
    .Shape();
}

SolidFacts kinkedFacts()
{
  const double section = 5 * (11 + 10.5 + 10.5 + 11);
  const double length = 2 * (std::hypot(5.0, 2.0) + std::hypot(5.0, 3.0)) + 10 + 20 + 10;
  return { "kinks", section * KinksDepth, 2 * section + KinksDepth * length };
}

void kinks(Folder& folder)
{
  write(
    folder, "kinks.step", kinkedShape(), kinkedFacts(), 6, { { "kinks", 3 } }, Integrals::Adaptive);
}

// A hole that touches a kink: divided there, the face cannot be triangulated closed.
void holeAtKink(Folder& folder)
{
  const double radius = 2, middle = 8, height = 10.2, slope = 3.0 / 5; // in the middle of the hole
  const gp_Ax2 axis(gp_Pnt(middle, KinksDepth / 2, -5), gp::DZ());
  const TopoDS_Shape shape = cut(kinkedShape(), cylinder(axis, radius, 40));
  forEachPlace([&](double size, const gp_Trsf& place, const std::string& name) {
    SolidFacts solid = kinkedFacts();
    const double section = Pi * radius * radius;
    solid.volume = (solid.volume - section * height) * std::pow(size, 3);
    solid.area = (solid.area - section * (1 + std::hypot(1, slope)) + 2 * Pi * radius * height) *
      std::pow(size, 2);
    Facts facts;
    facts.solids = { solid };
    facts.faces = 7;
    facts.integrals = Integrals::AcrossKinks;
    folder.brep("hole_at_kink_" + name + ".brep", moved(shape, place), facts);
  });
}

// Two pipes of one radius through each other, which share Steinmetz's solid: 16/3 r^3, and 16 r^2 of their walls.
void crossingPipes(Folder& folder)
{
  const double radius = 5, length = 40;
  const TopoDS_Shape one = cylinder(gp_Ax2(gp_Pnt(-length / 2, 0, 0), gp::DX()), radius, length);
  const TopoDS_Shape other = cylinder(gp_Ax2(gp_Pnt(0, -length / 2, 0), gp::DY()), radius, length);
  const double section = Pi * radius * radius;
  const SolidFacts solid{ "crossing_pipes", 2 * section * length - 16.0 / 3 * std::pow(radius, 3),
    4 * section + 4 * Pi * radius * length - 16 * radius * radius };
  const TopoDS_Shape shape = fused(one, other);
  write(folder, "crossing_pipes.step", shape, solid, 8, { { "tangentGroups", 8 } });
}

// A pipe and a branch of the same radius from its axis, which share half of Steinmetz's solid.
void tee(Folder& folder)
{
  const double radius = 5, length = 40, branch = 30;
  const TopoDS_Shape pipe = cylinder(gp_Ax2(gp_Pnt(-length / 2, 0, 0), gp::DX()), radius, length);
  const TopoDS_Shape arm = cylinder(gp_Ax2(gp::Origin(), gp::DY()), radius, branch);
  const double section = Pi * radius * radius;
  const SolidFacts solid{ "tee", section * (length + branch) - 8.0 / 3 * std::pow(radius, 3),
    3 * section + 2 * Pi * radius * (length + branch) - 8 * radius * radius };
  const TopoDS_Shape shape = fused(pipe, arm);
  write(folder, "tee.step", shape, solid, 5, { { "tangentGroups", 5 } });
}

void torus(Folder& folder)
{
  const double large = 10, small = 3;
  write(folder, "torus.step", BRepPrimAPI_MakeTorus(large, small).Shape(),
    { "torus", 2 * Pi * Pi * large * small * small, 4 * Pi * Pi * large * small }, 1);
}

void sphere(Folder& folder)
{
  const double radius = 5;
  const SolidFacts solid{ "sphere", 4.0 / 3 * Pi * std::pow(radius, 3), 4 * Pi * radius * radius };
  write(folder, "sphere.step", BRepPrimAPI_MakeSphere(radius).Shape(), solid, 1);
}

void cone(Folder& folder)
{
  const double radius = 5, height = 12;
  const SolidFacts solid{ "cone", Pi * radius * radius * height / 3,
    Pi * radius * (radius + std::hypot(radius, height)) };
  write(folder, "cone.step", BRepPrimAPI_MakeCone(radius, 0, height).Shape(), solid, 2);
}

// Rational B-splines instead of planes and a cylinder: large and small, turned.
void splines(Folder& folder)
{
  const TopoDS_Shape shape = BRepBuilderAPI_NurbsConvert(boxWithHole(X, Y, Z, 3)).Shape();
  SolidFacts solid = boxWithHoleFacts("splines", X, Y, Z, 3);
  write(folder, "splines.step", shape, solid, 7, {}, Integrals::Adaptive);
  for (const double size : { 0.1, 1.0, 100.0 })
  {
    for (const int turn : { 0, 17, 45, 90 })
    {
      gp_Trsf scaling;
      scaling.SetScaleFactor(size);
      gp_Trsf turning;
      turning.SetRotation(gp_Ax1(gp_Pnt(3, 5, 7), gp_Dir(1, 2, 3)), turn * Degree);
      const SolidFacts sized{ solid.name, solid.volume * size * size * size,
        solid.area * size * size };
      const std::string file =
        "splines_" + std::to_string(std::lround(10 * size)) + "_" + std::to_string(turn) + ".step";
      write(folder, file, moved(shape, turning * scaling), sized, 7, {}, Integrals::Adaptive);
    }
  }
}

}

const std::map<std::string, Part> Curved = { { "rounded box", roundedBox },
  { "rounded edge", roundedEdge }, { "crease", crease }, { "kinks", kinks },
  { "hole at kink", holeAtKink }, { "crossing pipes", crossingPipes }, { "tee", tee },
  { "torus", torus }, { "sphere", sphere }, { "cone", cone }, { "splines", splines } };

}
