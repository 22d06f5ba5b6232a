// Faces that Open CASCADE cannot triangulate as they are: their edges' curves on the surface are wrong.
#include "Parts.h"
#include "Shapes.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <cmath>
#include <string>

namespace cartesian
{

namespace
{

constexpr double EdgeTolerance = 1e-7;

// A line by the ends of what is on it, as long as the edge.
Handle(Geom2d_Line) line(const gp_Pnt2d& start, const gp_Pnt2d& end, double first)
{
  const gp_Dir2d along(gp_Vec2d(start, end));
  return new Geom2d_Line(start.Translated(gp_Vec2d(along) * -first), along);
}

// Both curves of a seam, aside by an angle: they no longer end where those of the circles do.
void shiftSeam(const TopoDS_Face& face, double angle)
{
  for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next())
  {
    const TopoDS_Edge edge = TopoDS::Edge(edges.Current().Oriented(TopAbs_FORWARD));
    if (BRep_Tool::IsClosed(edge, face))
    {
      double first = 0, last = 0;
      const auto shifted = [&](const TopoDS_Edge& side) {
        const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(side, face, first, last);
        const gp_Vec2d by(angle, 0);
        return line(curve->Value(first).Translated(by), curve->Value(last).Translated(by), first);
      };
      const Handle(Geom2d_Line) one = shifted(edge);
      BRep_Builder().UpdateEdge(
        edge, one, shifted(TopoDS::Edge(edge.Reversed())), face, EdgeTolerance);
      return;
    }
  }
}

// A ring with a countersink, whose cone has triangles only as a B-spline.
void countersunk(Folder& folder)
{
  const double outer = 13.5, inner = 5.5, wide = 11.5, height = 7, depth = 6;
  const gp_Ax2 axis(gp::Origin(), gp::DZ());
  const TopoDS_Shape ring = cut(cylinder(axis, outer, height), cylinder(axis, inner, height));
  const TopoDS_Shape shape = cut(ring, BRepPrimAPI_MakeCone(axis, wide, inner, depth).Shape());
  const double slant = std::hypot(wide - inner, depth);
  const SolidFacts solid{ "",
    Pi *
      ((outer * outer - inner * inner) * height -
        depth * ((wide * wide + wide * inner + inner * inner) / 3 - inner * inner)),
    Pi *
      (outer * outer - wide * wide + outer * outer - inner * inner + 2 * outer * height +
        2 * inner * (height - depth) + (wide + inner) * slant) };
  forEachPlace([&](double size, const gp_Trsf& place, const std::string& name) {
    const TopoDS_Shape own = moved(shape, place);
    for (const TopoDS_Face& face : facesOf(own))
    {
      if (BRepAdaptor_Surface(face).GetType() == GeomAbs_Cone)
      {
        shiftSeam(TopoDS::Face(face.Oriented(TopAbs_FORWARD)), 1e-4);
      }
    }
    Facts facts;
    facts.solids = { { "", solid.volume * std::pow(size, 3), solid.area * size * size } };
    facts.faces = 5;
    folder.brep("countersunk_" + name + ".brep", own, facts);
  });
}

// The curve of one edge runs back instead of forth.
void tangle(const TopoDS_Face& face)
{
  const TopoDS_Edge edge =
    TopoDS::Edge(TopExp_Explorer(face, TopAbs_EDGE).Current().Oriented(TopAbs_FORWARD));
  double first = 0, last = 0;
  const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  BRep_Builder().UpdateEdge(
    edge, line(curve->Value(last), curve->Value(first), first), face, EdgeTolerance);
}

// Nothing but its edges is left of a flat face.
void tangledFlat(Folder& folder)
{
  const TopoDS_Shape cuboid =
    BRepBuilderAPI_NurbsConvert(box(gp::Origin(), { 30, 20, 10 })).Shape();
  forEachPlace([&](double size, const gp_Trsf& place, const std::string& name) {
    Facts facts;
    facts.solids = { boxFacts("", 30 * size, 20 * size, 10 * size) };
    facts.faces = 6;
    facts.integrals = Integrals::Adaptive;
    const TopoDS_Shape own = moved(cuboid, place);
    folder.damaged("tangled_flat_" + name + ".brep", own, facts,
      [&] { tangle(faceAt(own, gp_Pnt(15, 10, 10).Transformed(place))); });
  });
}

// The same of a round one, of half a cylinder.
void tangledRound(Folder& folder)
{
  const double radius = 5, height = 20;
  const TopoDS_Shape half =
    BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeCylinder(radius, height, Pi).Shape()).Shape();
  const double section = Pi / 2 * radius * radius;
  Facts facts;
  facts.solids = { { "", section * height, 2 * section + (Pi + 2) * radius * height } };
  facts.faces = 5;
  facts.integrals = Integrals::Adaptive;
  folder.damaged("tangled_round.brep", half, facts, [&] {
    tangle(faceAt(half, { 0, radius, height / 2 }));
  });
}

}

const std::map<std::string, Part> Damaged = { { "countersunk", countersunk },
  { "tangled flat", tangledFlat }, { "tangled round", tangledRound } };

}
