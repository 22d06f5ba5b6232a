// Several parts, placed by assemblies.
#include "Parts.h"
#include "Shapes.h"

#include <cmath>

namespace cartesian
{

namespace
{

// A plate with two holes on the x axis.
struct Plate
{
  double x = 60, y = 40, thickness = 5;
  double holeRadius = 4, holeX = 15;

  TopoDS_Shape shape() const
  {
    TopoDS_Shape result = box({ -x / 2, -y / 2, 0 }, { x / 2, y / 2, thickness });
    for (const double at : { -holeX, holeX })
    {
      const gp_Ax2 hole(gp_Pnt(at, 0, -thickness), gp::DZ());
      result = cut(result, cylinder(hole, holeRadius, 3 * thickness));
    }
    return result;
  }

  SolidFacts facts(const std::string& name, const gp_Pnt& centre) const
  {
    SolidFacts result = boxFacts(name, x, y, thickness);
    result.volume -= 2 * Pi * holeRadius * holeRadius * thickness;
    result.area += 2 * (2 * Pi * holeRadius * thickness - 2 * Pi * holeRadius * holeRadius);
    result.centre = centre;
    return result;
  }
};

// A bolt along z with a hexagonal head on z = 0.
struct Bolt
{
  double radius = 4, length = 10;
  double headRadius = 7, headHeight = 4; // of the hexagon's corners

  TopoDS_Shape shape() const
  {
    std::vector<gp_Pnt> hexagon;
    for (int i = 0; i < 6; ++i)
    {
      const double angle = 60 * i * Degree;
      hexagon.emplace_back(headRadius * std::cos(angle), 0, headRadius * std::sin(angle));
    }
    gp_Trsf upright; // y becomes z
    upright.SetRotation(gp::OX(), 90 * Degree);
    const TopoDS_Shape head = moved(prism(hexagon, headHeight), upright);
    return fused(head, cylinder(gp_Ax2(gp_Pnt(0, 0, -length), gp::DZ()), radius, length));
  }

  // Its origin is at the given place, and it is turned about z only.
  SolidFacts facts(const std::string& name, const gp_Pnt& origin) const
  {
    const double hexagon = 1.5 * std::sqrt(3.0) * headRadius * headRadius;
    const double head = hexagon * headHeight;
    const double shank = Pi * radius * radius * length;
    const double z = (head * headHeight / 2 - shank * length / 2) / (head + shank);
    return { name, head + shank,
      2 * hexagon + 6 * headRadius * headHeight + 2 * Pi * radius * length,
      gp_Pnt(origin.X(), origin.Y(), origin.Z() + z) };
  }
};

// Two instances of a plate, one upside down; an assembly of two instances of a bolt, one turned, which is turned too.
void boltedPlates(Folder& folder)
{
  const Plate plate;
  const Bolt bolt;
  Document document;
  const TDF_Label plates = document.add(plate.shape(), "plate");
  const TDF_Label bolts = document.add(bolt.shape(), "bolt");
  const TDF_Label pair = document.addAssembly("bolts");
  document.place(
    pair, bolts, "bolt_1", translation({ plate.holeX, 0, 0 }) * turnAboutZ(30 * Degree));
  document.place(pair, bolts, "bolt_2", translation({ -plate.holeX, 0, 0 }));

  const TDF_Label joint = document.addAssembly("joint");
  gp_Trsf upsideDown;
  upsideDown.SetRotation(gp::OX(), 180 * Degree);
  document.place(joint, plates, "lower", translation({ 0, 0, -plate.thickness }));
  document.place(joint, plates, "upper", translation({ 0, 0, plate.thickness }) * upsideDown);
  document.place(joint, pair, "bolts_in_place",
    translation({ 0, 0, plate.thickness }) * turnAboutZ(180 * Degree));

  Facts facts;
  facts.solids = { plate.facts("lower", { 0, 0, -plate.thickness / 2 }),
    plate.facts("upper", { 0, 0, plate.thickness / 2 }),
    bolt.facts("bolt_1", { -plate.holeX, 0, plate.thickness }),
    bolt.facts("bolt_2", { plate.holeX, 0, plate.thickness }) };
  facts.faces = 2 * 8 + 2 * 10;
  const double shank = 2 * Pi * bolt.radius * 2 * plate.thickness;
  const double hexagon = 1.5 * std::sqrt(3.0) * bolt.headRadius * bolt.headRadius;
  facts.others = { { "contactArea",
    2 * shank + 2 * (hexagon - Pi * bolt.radius * bolt.radius) + plate.x * plate.y -
      2 * Pi * plate.holeRadius * plate.holeRadius } };
  folder.step("bolted_plates.step", document, facts);
}

// Fluid in a pipe with a heater block around it: the contacts are cylinders.
void heatedPipe(Folder& folder)
{
  const double inner = 5, outer = 7, length = 100;
  const double side = 20, low = 30, high = 70;
  const gp_Ax2 axis = gp::XOY();
  const TopoDS_Shape fluid = cylinder(axis, inner, length);
  const TopoDS_Shape pipe = cut(cylinder(axis, outer, length), fluid);
  const TopoDS_Shape heater = cut(box({ -side / 2, -side / 2, low }, { side / 2, side / 2, high }),
    cylinder(axis, outer, length));

  Document document;
  const TDF_Label assembly = document.addAssembly("heated_pipe");
  document.place(assembly, document.add(fluid, "fluid"), "fluid");
  document.place(assembly, document.add(pipe, "pipe"), "pipe");
  document.place(assembly, document.add(heater, "heater"), "heater");
  document.nameSubshape(faceAt(fluid, { 0, 0, 0 }), "inlet");
  document.nameSubshape(faceAt(fluid, { 0, 0, length }), "outlet");

  const double section = Pi * inner * inner, ring = Pi * (outer * outer - inner * inner);
  const double blockSection = side * side - Pi * outer * outer;
  const double inside = 2 * Pi * inner * length, outside = 2 * Pi * outer * length;
  const double heated = 2 * Pi * outer * (high - low);
  Facts facts;
  facts.solids = { { "fluid", section * length, 2 * section + inside },
    { "pipe", ring * length, 2 * ring + inside + outside },
    { "heater", blockSection * (high - low),
      2 * blockSection + 4 * side * (high - low) + heated } };
  facts.faces = 3 + 4 + 7;
  facts.boundaries = { { "inlet", section }, { "outlet", section } };
  facts.others = { { "contactArea", inside + heated } };
  folder.step("heated_pipe.step", document, facts);
}

// An assembly whose parts are in files of their own. Names of instances are not asserted: OCCT writes some as ''.
void severalFiles(Folder& folder)
{
  Document document;
  const TDF_Label assembly = document.addAssembly("pair");
  const TDF_Label block = document.add(boxWithHole(30, 20, 10, 3), "outside_block");
  document.place(assembly, block, "first");
  document.place(assembly, block, "second", translation({ 0, 0, 10 }) * turnAboutZ(90 * Degree));

  Facts facts;
  facts.solids = { boxWithHoleFacts("", 30, 20, 10, 3), boxWithHoleFacts("", 30, 20, 10, 3) };
  facts.solids[0].centre = gp_Pnt(0, 0, 0);
  facts.solids[1].centre = gp_Pnt(0, 0, 10);
  facts.faces = 14;
  facts.others = { { "contactArea", 20 * 20 - Pi * 9 } };
  folder.stepOfSeveralFiles("several_files.step", document, facts);
}

}

const std::map<std::string, Part> Assemblies = { { "bolted plates", boltedPlates },
  { "heated pipe", heatedPipe }, { "several files", severalFiles } };

}
