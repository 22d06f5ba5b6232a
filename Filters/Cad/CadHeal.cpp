// SPDX-License-Identifier: BSD-3-Clause
#include "CadHeal.h"

#include "CadBodies.h"

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
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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
  int open = 0;                     // edges
  std::vector<TopoDS_Shape> images; // of the part's faces
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
  std::vector<TopoDS_Shape> images;
  for (int i = 1; i <= faces.Extent(); ++i)
  {
    const TopoDS_Shape image = sewing.ModifiedSubShape(faces(i));
    for (TopExp_Explorer face(image, TopAbs_FACE); face.More(); face.Next())
    {
      history.follow(faces(i), face.Current());
    }
    images.push_back(image);
  }
  const TopoDS_Shape shape = sewing.SewedShape();
  return { shape, history.of(shape), freeEdges(shape).Extent(), images };
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

bool isSolid(const CadPart& part)
{
  return part.shape.ShapeType() == TopAbs_SOLID;
}

TopoDS_Solid solidOf(const TopoDS_Shell& shell)
{
  ShapeFix_Shell fix;
  fix.FixFaceOrientation(shell);
  TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(fix.Shell()).Solid();
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

// A single face has no shell.
std::vector<TopoDS_Shell> shellsOf(const TopoDS_Shape& shape)
{
  std::vector<TopoDS_Shell> shells;
  for (TopExp_Explorer shell(shape, TopAbs_SHELL); shell.More(); shell.Next())
  {
    shells.push_back(TopoDS::Shell(shell.Current()));
  }
  for (TopExp_Explorer face(shape, TopAbs_FACE, TopAbs_SHELL); face.More(); face.Next())
  {
    BRep_Builder().MakeShell(shells.emplace_back());
    BRep_Builder().Add(shells.back(), face.Current());
  }
  return shells;
}

// A solid of each closed shell; what stays open is one part.
std::vector<CadPart> partsOf(const Sewn& sewn, const CadPart& former)
{
  FaceHistory history;
  history.add({ sewn.shape, former.name, sewn.faces, former.instance });
  std::vector<CadPart> parts;
  TopoDS_Compound open;
  BRep_Builder().MakeCompound(open);
  for (const TopoDS_Shell& shell : shellsOf(sewn.shape))
  {
    if (freeEdges(shell).IsEmpty())
    {
      const TopoDS_Solid solid = solidOf(shell);
      parts.push_back({ solid, former.name, history.of(solid), former.instance });
    }
    else
    {
      BRep_Builder().Add(open, shell);
    }
  }
  if (TopExp_Explorer(open, TopAbs_FACE).More())
  {
    parts.push_back({ open, former.name, history.of(open), former.instance });
  }
  return parts;
}

// Some of a part's faces.
CadPart partOf(const CadPart& part, const std::vector<std::size_t>& which)
{
  const TopTools_IndexedMapOfShape faces = facesOf(part.shape);
  FaceHistory history;
  history.add(part);
  TopoDS_Compound some;
  BRep_Builder().MakeCompound(some);
  for (const std::size_t f : which)
  {
    BRep_Builder().Add(some, faces(static_cast<int>(f) + 1));
  }
  return { some, part.name, history.of(some), part.instance };
}

CadPart united(const std::vector<CadPart>& parts)
{
  CadPart all;
  FaceHistory history;
  TopoDS_Compound faces;
  BRep_Builder().MakeCompound(faces);
  for (const CadPart& part : parts)
  {
    all.name = all.name.empty() ? part.name : all.name;
    history.add(part);
    for (TopExp_Explorer face(part.shape, TopAbs_FACE); face.More(); face.Next())
    {
      BRep_Builder().Add(faces, face.Current());
    }
  }
  all.shape = faces;
  all.faces = history.of(faces);
  return all;
}

class Healing
{
public:
  Healing(bool hasTopology, const CadOptions& options, const CadReport& report)
    : hasTopology_(hasTopology)
    , options_(options)
    , report_(report)
  {
  }

  // Faces of one product first; what is open then may go with others'.
  void add(CadPart part)
  {
    const bool mayStay = options_.healTolerance <= 0 && hasTopology_;
    if (isSolid(part) && (mayStay || freeEdges(part.shape).IsEmpty()))
    {
      parts.push_back(std::move(part));
      return;
    }
    for (CadPart& made : sewn(part))
    {
      (isSolid(made) ? parts : open_).push_back(std::move(made));
    }
  }

  void end()
  {
    const std::vector<CadPart> left =
      open_.size() > 1 ? sewn(united(open_)) : std::exchange(open_, {});
    parts.insert(parts.end(), left.begin(), left.end());
  }

  std::vector<CadPart> parts;

private:
  std::vector<CadPart> sewn(const CadPart& part)
  {
    const int before = freeEdges(part.shape).Extent();
    const Sewn sewing = sewAsNeeded(part, hasTopology_, options_);
    if (sewing.open < before)
    {
      report_.note("Sewn: " + (part.name.empty() ? "faces" : part.name) + " at " +
        placeOf(part.shape, options_.unit) + ", free edges " + std::to_string(before) +
        " before, " + std::to_string(sewing.open) + " after.");
    }
    const std::vector<std::vector<std::size_t>> bodies = bodiesOf(sewing.images);
    std::vector<CadPart> together = partsOf(sewing, part);
    if (bodies.size() < 2)
    {
      return together;
    }
    std::vector<CadPart> apart = eachSewn(bodies, part);
    const auto solidsOf = [](const std::vector<CadPart>& made) {
      return std::count_if(made.begin(), made.end(), isSolid);
    };
    const bool isBetter = sewing.open > 0 ? solidsOf(apart) > solidsOf(together)
                                          : std::all_of(apart.begin(), apart.end(), isSolid);
    if (isBetter)
    {
      report_.note("Divided: bodies that touch, at " + placeOf(part.shape, options_.unit) + ".");
    }
    return isBetter ? apart : together;
  }

  std::vector<CadPart> eachSewn(
    const std::vector<std::vector<std::size_t>>& bodies, const CadPart& part) const
  {
    std::vector<CadPart> all;
    std::vector<CadPart> open;
    for (const std::vector<std::size_t>& body : bodies)
    {
      const CadPart own = partOf(part, body);
      for (CadPart& made : partsOf(sewAsNeeded(own, hasTopology_, options_), own))
      {
        (isSolid(made) ? all : open).push_back(std::move(made));
      }
    }
    if (!open.empty()) // slivers among them, whose edges lie on each other
    {
      all.push_back(united(open));
      all.back().instance = part.instance;
    }
    return all;
  }

  bool hasTopology_;
  const CadOptions& options_;
  const CadReport& report_;
  std::vector<CadPart> open_;
};

}

void heal(CadFile& file, const CadOptions& options, const CadReport& report)
{
  Healing healing(file.hasTopology, options, report);
  for (CadPart& part : file.parts)
  {
    healing.add(std::move(part));
  }
  healing.end();
  file.parts = std::move(healing.parts);
}

}
