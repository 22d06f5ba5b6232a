// Several solids that touch or overlap, as bodies of one part.
#include "Parts.h"
#include "Shapes.h"

#include <BRepPrimAPI_MakeSphere.hxx>

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
  { "hollow", hollow } };

}
