// Faces with names, colours and layers.
#include "Parts.h"
#include "Shapes.h"

#include <cmath>

namespace cartesian
{

namespace
{

// A plenum with two round inlets and an outlet, whose pipes stand on its sides.
struct Junction
{
  double x = 80, y = 50, z = 40;
  double inletRadius = 8, inletLength = 20;
  double outletRadius = std::sqrt(50.0), outletLength = 30;

  TopoDS_Shape shape() const
  {
    const gp_Ax2 inlet1(gp_Pnt(-inletLength, 14, z / 2), gp::DX());
    const gp_Ax2 inlet2(gp_Pnt(-inletLength, 36, z / 2), gp::DX());
    const gp_Ax2 outlet(gp_Pnt(x, y / 2, z / 2), gp::DX());
    TopoDS_Shape result =
      fused(box(gp::Origin(), { x, y, z }), cylinder(inlet1, inletRadius, inletLength));
    result = fused(result, cylinder(inlet2, inletRadius, inletLength));
    return fused(result, cylinder(outlet, outletRadius, outletLength));
  }

  std::string nameOf(const TopoDS_Face& face, const TopoDS_Shape& shape) const
  {
    const auto isAt = [&](const gp_Pnt& point) { return face.IsSame(faceAt(shape, point)); };
    return isAt({ -inletLength, 14, z / 2 })     ? "inlet_1"
      : isAt({ -inletLength, 36, z / 2 })        ? "inlet_2"
      : isAt({ x + outletLength, y / 2, z / 2 }) ? "outlet"
                                                 : "wall";
  }

  Facts facts() const
  {
    const double inlet = Pi * inletRadius * inletRadius;
    const double outlet = Pi * outletRadius * outletRadius;
    const double pipes = 2 * Pi * (2 * inletRadius * inletLength + outletRadius * outletLength);
    SolidFacts solid = boxFacts("junction", x, y, z);
    solid.volume += 2 * inlet * inletLength + outlet * outletLength;
    solid.area += pipes; // the caps are as large as what they replace
    Facts result;
    result.solids = { solid };
    result.faces = 12;
    result.boundaries = { { "inlet_1", inlet }, { "inlet_2", inlet }, { "outlet", outlet },
      { "wall", solid.area - 2 * inlet - outlet } };
    return result;
  }
};

void junction(Folder& folder)
{
  const Junction junction;
  const TopoDS_Shape shape = junction.shape();
  Document document;
  document.add(shape, "junction");
  for (const TopoDS_Face& face : facesOf(shape))
  {
    document.nameSubshape(face, junction.nameOf(face, shape));
  }
  folder.step("junction_mm.step", document, junction.facts(), "MM");
  folder.step("junction_m.step", document, junction.facts(), "M");
  folder.step("junction_inch.step", document, junction.facts(), "INCH");
}

// The cuboid of all parts below; its faces by the points in their middle.
constexpr double X = 30, Y = 20, Z = 10;
const gp_Pnt Left(0, Y / 2, Z / 2), Right(X, Y / 2, Z / 2), Front(X / 2, 0, Z / 2),
  Back(X / 2, Y, Z / 2), Bottom(X / 2, Y / 2, 0), Top(X / 2, Y / 2, Z);

TopoDS_Shape cuboid()
{
  return box(gp::Origin(), { X, Y, Z });
}

Facts cuboidFacts(const std::map<std::string, double>& boundaries)
{
  Facts facts;
  facts.solids = { boxFacts("cuboid", X, Y, Z) };
  facts.faces = 6;
  facts.boundaries = boundaries;
  return facts;
}

void partlyNamed(Folder& folder)
{
  const TopoDS_Shape shape = cuboid();
  Document document;
  document.add(shape, "cuboid");
  document.nameSubshape(faceAt(shape, Left), "inlet");
  document.nameSubshape(faceAt(shape, Right), "outlet");
  folder.step(
    "partly_named.step", document, cuboidFacts({ { "inlet", Y * Z }, { "outlet", Y * Z } }));
}

// Apostrophes, spaces, and what STEP's syntax has too. Letters beyond ASCII are UTF-8 in one file (as OCCT writes them),
// and in the other encoded, as the standard wants them.
void oddNames(Folder& folder)
{
  const TopoDS_Shape shape = cuboid();
  Document document;
  document.add(shape, "cuboid");
  document.nameSubshape(faceAt(shape, Left), "it's");
  document.nameSubshape(faceAt(shape, Right), "two words");
  document.nameSubshape(faceAt(shape, Front), "#1=A((b));");
  document.nameSubshape(faceAt(shape, Back), "back\\slash");
  document.nameSubshape(faceAt(shape, Top), "Außenwand");
  folder.step("odd_names.step", document,
    cuboidFacts({ { "it's", Y * Z }, { "two words", Y * Z }, { "#1=A((b));", X * Z },
      { "back\\slash", X * Z }, { "Außenwand", X * Y } }));
  folder.copy("odd_names.step", "encoded_names.step", "ß", "\\X2\\00DF\\X0\\");
}

// OCCT 7.6 takes an apostrophe before a parenthesis as the end of the name, and loses the face.
void quotes(Folder& folder)
{
  const TopoDS_Shape shape = cuboid();
  Document document;
  document.add(shape, "cuboid");
  document.nameSubshape(faceAt(shape, Left), "inlet (24')");
  folder.step("quotes.step", document, cuboidFacts({ { "inlet (24')", Y * Z } }));
}

// As SolidWorks writes them.
void noneNamed(Folder& folder)
{
  const TopoDS_Shape shape = cuboid();
  Document document;
  document.add(shape, "cuboid");
  for (const TopoDS_Face& face : facesOf(shape))
  {
    document.nameSubshape(face, "NONE");
  }
  folder.step(
    "names_none.step", document, cuboidFacts({ { "NONE", cuboidFacts({}).solids[0].area } }));
}

void colours(Folder& folder)
{
  const TopoDS_Shape shape = cuboid();
  Document document;
  document.add(shape, "cuboid");
  document.colour(faceAt(shape, Left), "00FF00");
  document.colour(faceAt(shape, Right), "FF0000");
  for (const gp_Pnt& point : { Front, Back, Bottom, Top })
  {
    document.colour(faceAt(shape, point), "0080FF");
  }
  const Facts facts =
    cuboidFacts({ { "00FF00", Y * Z }, { "FF0000", Y * Z }, { "0080FF", 2 * X * (Y + Z) } });
  folder.step("colours.step", document, facts);
  folder.iges("colours.igs", document, facts);
}

void layers(Folder& folder)
{
  const TopoDS_Shape shape = cuboid();
  Document document;
  document.add(shape, "cuboid");
  document.putInLayer(faceAt(shape, Left), "inlet");
  document.putInLayer(faceAt(shape, Right), "outlet");
  for (const gp_Pnt& point : { Front, Back, Bottom, Top })
  {
    document.putInLayer(faceAt(shape, point), "wall");
  }
  folder.step("layers.step", document,
    cuboidFacts({ { "inlet", Y * Z }, { "outlet", Y * Z }, { "wall", 2 * X * (Y + Z) } }));
}

// Two products of one name, with faces of one name.
void sameNames(Folder& folder)
{
  Document document;
  for (const double x : { 0.0, 2 * X })
  {
    const TopoDS_Shape shape = box({ x, 0, 0 }, { x + X, Y, Z });
    document.add(shape, "body");
    document.nameSubshape(faceAt(shape, { x, Y / 2, Z / 2 }), "inlet");
  }
  Facts facts;
  facts.solids = { boxFacts("body", X, Y, Z), boxFacts("body", X, Y, Z) };
  facts.faces = 12;
  facts.boundaries = { { "inlet", 2 * Y * Z } };
  folder.step("same_names.step", document, facts);
}

}

const std::map<std::string, Part> NamedParts = { { "junction", junction },
  { "partly named", partlyNamed }, { "odd names", oddNames }, { "quotes", quotes },
  { "none named", noneNamed }, { "colours", colours }, { "layers", layers },
  { "same names", sameNames } };

}
