// Faces that form no solid, and files that hold surfaces only.
#include "Parts.h"
#include "Shapes.h"

#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Shell.hxx>
#include <gp_Ax1.hxx>

namespace cartesian
{

namespace
{

TopoDS_Shape shell(const std::vector<TopoDS_Face>& faces)
{
  BRep_Builder builder;
  TopoDS_Shell result;
  builder.MakeShell(result);
  for (const TopoDS_Face& face : faces)
  {
    builder.Add(result, face);
  }
  return result;
}

TopoDS_Shape sewn(const std::vector<TopoDS_Face>& faces)
{
  BRepBuilderAPI_Sewing sewing;
  for (const TopoDS_Face& face : faces)
  {
    sewing.Add(face);
  }
  sewing.Perform();
  return sewing.SewedShape();
}

// One side of a cube in squares, each smaller by half a gap all around.
void addSide(std::vector<TopoDS_Face>& faces, const gp_Pnt& corner, const gp_Dir& one,
  const gp_Dir& other, double square, int count, double gap)
{
  const double side = square - gap;
  for (int i = 0; i < count; ++i)
  {
    for (int j = 0; j < count; ++j)
    {
      const gp_Vec start =
        gp_Vec(one) * (i * square + gap / 2) + gp_Vec(other) * (j * square + gap / 2);
      faces.push_back(
        rectangle(corner.Translated(start), gp_Vec(one) * side, gp_Vec(other) * side));
    }
  }
}

// A cube of 10 from squares that do not touch: *gap* between neighbours in a side, 0.7 of it at the cube's edges.
std::vector<TopoDS_Face> looseCube(int count, double gap)
{
  const double side = 10;
  const gp_Pnt low = gp::Origin(), high(side, side, side);
  const gp_Dir x = gp::DX(), y = gp::DY(), z = gp::DZ();
  std::vector<TopoDS_Face> faces;
  addSide(faces, high, x.Reversed(), y.Reversed(), side / count, count, gap); // z = 10 is first
  addSide(faces, low, y, x, side / count, count, gap);
  addSide(faces, low, z, y, side / count, count, gap);
  addSide(faces, low, x, z, side / count, count, gap);
  addSide(faces, high, y.Reversed(), z.Reversed(), side / count, count, gap);
  addSide(faces, high, z.Reversed(), x.Reversed(), side / count, count, gap);
  return faces;
}

// Closes at a heal tolerance of two gaps; its volume is then 1000 to the gap times the area.
void gaps(Folder& folder)
{
  const double gap = 1e-4;
  const std::vector<TopoDS_Face> faces = looseCube(2, gap);
  Document document;
  document.add(shell(faces), "shell");
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    document.nameSubshape(faces[i], i < 4 ? "top" : "rest");
  }
  const double square = (5 - gap) * (5 - gap);
  Facts facts;
  facts.area = 24 * square;
  facts.faces = 24;
  facts.openEdges = 96;
  facts.boundaries = { { "top", 4 * square }, { "rest", 20 * square } };
  facts.others = { { "gap", gap }, { "closedVolume", 1000 } };
  folder.step("gaps.step", document, facts);
}

// They touch, but know nothing of each other, and half of them look inwards.
void sixFaces(Folder& folder)
{
  std::vector<TopoDS_Face> faces = looseCube(1, 0);
  for (std::size_t i = 0; i < faces.size(); i += 2)
  {
    faces[i].Reverse();
  }
  Facts facts;
  facts.area = 600;
  facts.faces = 6;
  facts.openEdges = 24;
  facts.others = { { "closedVolume", 1000 } };
  Document document;
  document.add(compound({ faces.begin(), faces.end() }), "faces");
  folder.step("six_faces.step", document, facts);
  folder.brep("six_faces.brep", document.shape(), facts);
}

TopoDS_Shape angledSheet(const gp_Vec& from)
{
  BRepBuilderAPI_MakePolygon line;
  line.Add(gp::Origin().Translated(from));
  line.Add(gp_Pnt(10, 0, 0).Translated(from));
  line.Add(gp_Pnt(10, 0, 5).Translated(from));
  return BRepPrimAPI_MakePrism(line.Wire(), gp_Vec(0, 4, 0)).Shape();
}

void sheet(Folder& folder)
{
  Document document;
  document.add(angledSheet({ 0, 0, 0 }), "sheet");
  Facts facts;
  facts.area = 60;
  facts.faces = 2;
  facts.openEdges = 6;
  folder.step("sheet.step", document, facts);
}

void solidAndSheet(Folder& folder)
{
  Document document;
  document.add(box(gp::Origin(), { 10, 10, 10 }), "cube");
  document.add(angledSheet({ 20, 0, 0 }), "sheet");
  Facts facts;
  facts.solids = { boxFacts("cube", 10, 10, 10) };
  facts.area = 660;
  facts.faces = 8;
  facts.openEdges = 6;
  folder.step("solid_and_sheet.step", document, facts);
}

// A square tube without ends inside a solid, turned.
void strayTube(Folder& folder)
{
  const double side = 4, length = 6;
  const gp_Pnt low(-2, -2, -3);
  const gp_Vec x(side, 0, 0), y(0, side, 0), z(0, 0, length);
  const TopoDS_Shape tube = sewn({ rectangle(low, x, z), rectangle(low.Translated(x), y, z),
    rectangle(low.Translated(x + y), -x, z), rectangle(low.Translated(y), -y, z) });
  for (const int degrees : { 0, 10, 30, 45 })
  {
    const gp_Trsf turn = turnOf(degrees);
    Document document;
    document.add(moved(box({ -10, -6, -5 }, { 10, 6, 5 }), turn), "body");
    document.add(moved(tube, turn), "tube");
    Facts facts;
    facts.solids = { boxFacts("body", 20, 12, 10) };
    facts.area = facts.solids[0].area + 4 * side * length;
    facts.faces = 10;
    facts.openEdges = 8;
    folder.step("stray_tube_" + std::to_string(degrees) + ".step", document, facts);
  }
}

// Two solids that touch, and a sheet from wall to wall of the second.
void partition(Folder& folder)
{
  Document document;
  document.add(box(gp::Origin(), { 10, 10, 10 }), "left");
  document.add(box({ 10, 0, 0 }, { 20, 10, 10 }), "right");
  document.add(rectangle({ 14, 0, 0 }, { 0, 10, 0 }, { 0, 0, 10 }), "splitter");
  Facts facts;
  facts.solids = { boxFacts("left", 10, 10, 10), boxFacts("right", 10, 10, 10) };
  facts.area = 1300;
  facts.faces = 13;
  facts.openEdges = 4;
  folder.step("partition.step", document, facts);
}

// Each face by itself in the file; the facts are those of the sewn solid.
void igesFaces(Folder& folder)
{
  Facts facts;
  facts.solids = { boxWithHoleFacts("", 30, 20, 10, 3) };
  facts.faces = 7;
  const TopoDS_Shape shape = boxWithHole(30, 20, 10, 3);
  folder.iges("faces.igs", shape, IgesForm::Faces, facts);
  folder.iges("faces_inch.igs", shape, IgesForm::Faces, facts, "INCH");
  folder.iges("solid.igs", shape, IgesForm::Solid, facts);
  folder.brep("solid.brep", shape, facts);
}

// Solids whose faces meet in edges, as loose faces: three cubes in a row, and two that share one edge.
void touchingFaces(Folder& folder)
{
  for (const double size : { 0.1, 1.0, 10.0 })
  {
    for (const int degrees : { 0, 10, 30, 45 })
    {
      const gp_Trsf turn = turnOf(degrees);
      const std::string name = "touching_" + std::to_string(static_cast<int>(10 * size)) + "_" +
        std::to_string(degrees) + ".igs";
      Facts facts;
      facts.solids.assign(3, boxFacts("", size, size, size));
      facts.faces = 18;
      facts.others = { { "contactArea", 2 * size * size } };
      std::vector<TopoDS_Shape> row;
      for (const double x : { 0.0, size, 2 * size })
      {
        row.push_back(moved(box({ x, 0, 0 }, { x + size, size, size }), turn));
      }
      folder.iges(name, compound(row), IgesForm::Faces, facts);
    }
  }
  Facts facts;
  facts.solids = { boxFacts("", 10, 10, 10), boxFacts("", 10, 10, 10) };
  facts.faces = 12;
  folder.iges("touching_edge.igs",
    compound({ box(gp::Origin(), { 10, 10, 10 }), box({ 10, 10, 0 }, { 20, 20, 10 }) }),
    IgesForm::Faces, facts);
}

// The rim of a box without a side lies on the edges of a cube: sewn together or apart, one solid and one sheet.
void openBoxBesideCube(Folder& folder)
{
  const double side = 10, length = 5;
  std::vector<TopoDS_Shape> faces;
  for (const TopoDS_Face& face : facesOf(box(gp::Origin(), { side, side, side })))
  {
    faces.push_back(face);
  }
  const TopoDS_Shape open = box({ side, 0, 0 }, { side + length, side, side });
  const TopoDS_Face lid = faceAt(open, { side, side / 2, side / 2 });
  for (const TopoDS_Face& face : facesOf(open))
  {
    if (!face.IsSame(lid))
    {
      faces.push_back(face);
    }
  }
  Facts facts;
  facts.area = 7 * side * side + 4 * side * length;
  facts.faces = 11;
  facts.openEdges = 4;
  facts.others = { { "closedVolume", side * side * side }, { "closedArea", 6 * side * side },
    { "stillOpen", 4 } };
  folder.brep("open_box_beside_cube.brep", compound(faces), facts);
}

void igesSphere(Folder& folder)
{
  const double radius = 5;
  Facts facts;
  facts.solids = { { "", 4.0 / 3 * Pi * radius * radius * radius, 4 * Pi * radius * radius } };
  facts.faces = 1;
  const TopoDS_Shape shape = BRepPrimAPI_MakeSphere(radius).Shape();
  folder.iges("sphere.igs", shape, IgesForm::Faces, facts);
  folder.iges("sphere_solid.igs", shape, IgesForm::Solid, facts);
}

}

const std::map<std::string, Part> Surfaces = { { "gaps", gaps }, { "six faces", sixFaces },
  { "sheet", sheet }, { "solid and sheet", solidAndSheet }, { "stray tube", strayTube },
  { "partition", partition }, { "IGES faces", igesFaces }, { "touching faces", touchingFaces },
  { "open box beside cube", openBoxBesideCube }, { "IGES sphere", igesSphere } };

}
