// SPDX-License-Identifier: BSD-3-Clause
#include "CadHeal.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <ShapeFix_Shell.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <array>
#include <cmath>
#include <optional>

namespace cartesian
{

namespace
{

// Of the size. Neighbours are found by sewing, even where nothing is to be healed.
constexpr double NoGap = 1e-7;

// Gaps up to these are sewn in files whose faces do not know their neighbours, the smallest that leaves no edge free.
constexpr std::array<double, 4> GapsOfFaces{ NoGap, 1e-6, 1e-5, 1e-4 };

double sizeOf(const TopoDS_Shape& shape)
{
  Bnd_Box box;
  BRepBndLib::Add(shape, box, Standard_False);
  return box.IsVoid() ? 0 : std::sqrt(box.SquareExtent());
}

struct Sewn
{
  TopoDS_Shape shape;
  std::vector<FaceAttributes> faces;
  int open = 0; // edges
};

Sewn sew(const CadPart& part, double tolerance)
{
  BRepBuilderAPI_Sewing sewing(tolerance);
  const TopTools_IndexedMapOfShape faces = facesOf(part.shape);
  for (int i = 1; i <= faces.Extent(); ++i)
  {
    sewing.Add(faces(i));
  }
  sewing.Perform();
  FaceHistory history;
  history.add(part);
  for (int i = 1; i <= faces.Extent(); ++i)
  {
    const TopoDS_Shape image = sewing.ModifiedSubShape(faces(i));
    for (TopExp_Explorer face(image, TopAbs_FACE); face.More(); face.Next())
    {
      history.follow(faces(i), face.Current());
    }
  }
  const TopoDS_Shape shape = sewing.SewedShape();
  return { shape, history.of(shape), freeEdges(shape).Extent() };
}

Sewn sewAsNeeded(const CadPart& part, bool hasTopology, const CadOptions& options)
{
  if (options.healTolerance > 0)
  {
    return sew(part, options.healTolerance * options.unit);
  }
  const double size = sizeOf(part.shape);
  Sewn best = sew(part, NoGap * size);
  for (const double gap : GapsOfFaces)
  {
    if (best.open == 0 || hasTopology)
    {
      break;
    }
    Sewn sewn = sew(part, gap * size);
    if (sewn.open < best.open)
    {
      best = std::move(sewn);
    }
  }
  return best;
}

// A part of its own for each closed shell, which is a solid then; one for all that stays open.
std::vector<CadPart> partsOf(const Sewn& sewn, const std::string& name)
{
  FaceHistory history;
  history.add({ sewn.shape, name, sewn.faces });
  std::vector<CadPart> parts;
  TopoDS_Compound open;
  BRep_Builder().MakeCompound(open);
  const auto keep = [&](const TopoDS_Shape& shape) { BRep_Builder().Add(open, shape); };
  for (TopExp_Explorer shell(sewn.shape, TopAbs_SHELL); shell.More(); shell.Next())
  {
    if (freeEdges(shell.Current()).Extent() > 0)
    {
      keep(shell.Current());
      continue;
    }
    ShapeFix_Shell fix(TopoDS::Shell(shell.Current())); // faces turned alike
    fix.FixFaceOrientation(TopoDS::Shell(shell.Current()));
    TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(fix.Shell()).Solid();
    BRepLib::OrientClosedSolid(solid);
    parts.push_back({ solid, name, history.of(solid) });
  }
  for (TopExp_Explorer face(sewn.shape, TopAbs_FACE, TopAbs_SHELL); face.More(); face.Next())
  {
    keep(face.Current());
  }
  if (TopExp_Explorer(open, TopAbs_FACE).More())
  {
    parts.push_back({ open, name, history.of(open) });
  }
  return parts;
}

}

void heal(CadFile& file, const CadOptions& options, const CadReport& report)
{
  std::vector<CadPart> healed;
  for (CadPart& part : file.parts)
  {
    const int before = freeEdges(part.shape).Extent();
    const bool isSolid = part.shape.ShapeType() == TopAbs_SOLID;
    if (isSolid && (before == 0 || (options.healTolerance <= 0 && file.hasTopology)))
    {
      healed.push_back(std::move(part));
      continue;
    }
    const Sewn sewn = sewAsNeeded(part, file.hasTopology, options);
    if (sewn.open < before)
    {
      report.note("Sewn: " + (part.name.empty() ? "faces" : part.name) + " at " +
        placeOf(part.shape, options.unit) + ", free edges " + std::to_string(before) + " before, " +
        std::to_string(sewn.open) + " after.");
    }
    for (CadPart& made : partsOf(sewn, part.name))
    {
      healed.push_back(std::move(made));
    }
  }
  file.parts = std::move(healed);
}

}
