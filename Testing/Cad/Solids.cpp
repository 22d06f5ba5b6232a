// Several solids that touch or overlap, as bodies of one part.
#include "Parts.h"
#include "Shapes.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffsetAPI_MakePipe.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <TopoDS.hxx>
#include <gp_Ax1.hxx>
#include <gp_Circ.hxx>

#include <cmath>

namespace cartesian
{

namespace
{

struct Body
{
  TopoDS_Shape shape;
  SolidFacts facts;
};

void write(Folder& folder, const std::string& file, const std::vector<Body>& bodies, int faces,
  const std::map<std::string, double>& others)
{
  std::vector<TopoDS_Shape> shapes;
  Facts facts;
  facts.faces = faces;
  facts.others = others;
  for (const Body& body : bodies)
  {
    shapes.push_back(body.shape);
    facts.solids.push_back(body.facts);
  }
  Document document;
  document.add(compound(shapes), "bodies");
  for (const Body& body : bodies)
  {
    document.nameSubshape(body.shape, body.facts.name);
  }
  folder.step(file, document, facts);
}

Body cube(const std::string& name, const gp_Pnt& low, double side)
{
  return { box(low, low.Translated({ side, side, side })), boxFacts(name, side, side, side) };
}

SolidFacts cylinderFacts(const std::string& name, double radius, double height)
{
  return { name, Pi * radius * radius * height, 2 * Pi * radius * (radius + height) };
}

void turnedCube(Folder& folder)
{
  const Body tower{ moved(box({ -0.5, -0.5, 1 }, { 0.5, 0.5, 2 }), turnAboutZ(30 * Degree)),
    boxFacts("tower", 1, 1, 1) };
  write(folder, "turned_cube.step", { cube("base", { -1, -1, -1 }, 2), tower }, 12,
    { { "contactArea", 1 } });
}

void cylinderOnCube(Folder& folder)
{
  const Body tower{ cylinder(gp_Ax2(gp_Pnt(4, 5, 10), gp::DZ()), 3, 6),
    cylinderFacts("tower", 3, 6) };
  write(folder, "cylinder_on_cube.step", { cube("base", gp::Origin(), 10), tower }, 9,
    { { "contactArea", 9 * Pi } });
}

// Half of the cylinder has nothing below it.
void overhang(Folder& folder)
{
  const Body tower{ cylinder(gp_Ax2(gp_Pnt(10, 5, 10), gp::DZ()), 3, 6),
    cylinderFacts("tower", 3, 6) };
  write(folder, "overhang.step", { cube("base", gp::Origin(), 10), tower }, 9,
    { { "contactArea", 4.5 * Pi } });
}

void overlap(Folder& folder)
{
  write(folder, "overlap.step",
    { cube("first", gp::Origin(), 10), cube("second", { 5, 5, 5 }, 10) }, 12,
    { { "unionVolume", 1875 }, { "commonVolume", 125 } });
}

void touchAtEdge(Folder& folder)
{
  write(folder, "touch_at_edge.step",
    { cube("first", gp::Origin(), 10), cube("second", { 10, 10, 0 }, 10) }, 12,
    { { "contactArea", 0 } });
}

void touchAtCorner(Folder& folder)
{
  write(folder, "touch_at_corner.step",
    { cube("first", gp::Origin(), 10), cube("second", { 10, 10, 10 }, 10) }, 12,
    { { "contactArea", 0 } });
}

void apart(Folder& folder)
{
  write(folder, "apart.step", { cube("first", gp::Origin(), 10), cube("second", { 20, 0, 0 }, 10) },
    12, {});
}

// Fluid in a pipe along an arc: the contact is a part of a torus, of which the fuse makes a solid without volume, too.
void bend(Folder& folder, double size, int degrees)
{
  const double arc = 0.5, large = 30 * size, inner = 10 * size, outer = 11 * size;
  const gp_Trsf turn = turnOf(degrees);
  const gp_Ax2 middle(gp_Pnt(large, 0, 0), gp::DZ(), -gp::DX());
  const gp_Circ path(gp_Ax2(gp::Origin(), -gp::DY(), gp::DX()), large);
  const TopoDS_Wire arcs =
    BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(path, 0, arc).Edge()).Wire();
  const auto circle = [&](double radius) {
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(middle, radius)).Edge()).Wire();
  };
  const TopoDS_Face disc = BRepBuilderAPI_MakeFace(circle(inner));
  const TopoDS_Face ring = BRepBuilderAPI_MakeFace(
    BRepBuilderAPI_MakeFace(circle(outer)).Face(), TopoDS::Wire(circle(inner).Reversed()));
  const auto swept = [&](const TopoDS_Face& section) {
    return moved(BRepOffsetAPI_MakePipe(arcs, section).Shape(), turn);
  };
  const auto facts = [&](const std::string& name, double hole, double radius) {
    const double section = Pi * (radius * radius - hole * hole);
    return SolidFacts{ name, section * large * arc,
      2 * section + 2 * Pi * (radius + hole) * large * arc };
  };
  write(folder,
    "bend_" + std::to_string(static_cast<int>(10 * size)) + "_" + std::to_string(degrees) + ".step",
    { { swept(disc), facts("fluid", 0, inner) }, { swept(ring), facts("wall", inner, outer) } }, 7,
    { { "contactArea", 2 * Pi * inner * large * arc } });
}

void bends(Folder& folder)
{
  for (const double size : { 0.1, 1.0, 10.0 })
  {
    for (const int degrees : { 0, 10, 30, 45 })
    {
      bend(folder, size, degrees);
    }
  }
}

// A rod through a plate, which divides it.
void rodThroughPlate(Folder& folder)
{
  const Body rod{ cylinder(gp_Ax2(gp_Pnt(5, 5, -10), gp::DZ()), 2, 30),
    cylinderFacts("rod", 2, 30) };
  write(folder, "rod_through_plate.step", { cube("plate", gp::Origin(), 10), rod }, 9, {});
}

// A solid of two shells.
void hollow(Folder& folder)
{
  const double radius = 3;
  SolidFacts facts = boxFacts("hollow", 10, 10, 10);
  facts.volume -= 4.0 / 3 * Pi * std::pow(radius, 3);
  facts.area += 4 * Pi * radius * radius;
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Pnt(5, 5, 5), radius).Shape();
  write(folder, "hollow.step", { { cut(box(gp::Origin(), { 10, 10, 10 }), ball), facts } }, 7, {});
}

}

const std::map<std::string, Part> Solids = { { "turned cube", turnedCube },
  { "cylinder on cube", cylinderOnCube }, { "overhang", overhang }, { "overlap", overlap },
  { "touch at edge", touchAtEdge }, { "touch at corner", touchAtCorner }, { "apart", apart },
  { "bends", bends }, { "rod through plate", rodThroughPlate }, { "hollow", hollow } };

}
