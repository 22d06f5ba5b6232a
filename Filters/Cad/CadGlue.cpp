// SPDX-License-Identifier: BSD-3-Clause
#include "CadGlue.h"

#include "CadProgress.h"

#include <BOPAlgo_Builder.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <ShapeAnalysis_ShapeTolerance.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace cartesian
{

namespace
{

// Whether a solid is no thicker, in the mean, than shapes are exact: such as one of the same face from both sides, which
// the fuse makes where solids share a torus.
bool isFilm(const TopoDS_Shape& solid)
{
  GProp_GProps inside;
  GProp_GProps around;
  BRepGProp::VolumeProperties(solid, inside);
  BRepGProp::SurfaceProperties(solid, around);
  const double exactness = ShapeAnalysis_ShapeTolerance().Tolerance(solid, 1); // the largest
  return 2 * std::abs(inside.Mass()) <= exactness * around.Mass();
}

// The general fuse of copies: instances share their faces, which would be moved together else.
class Fuse
{
public:
  Fuse(const std::vector<CadPart>& parts, const CadReport& report)
    : report_(report)
  {
    fuse_.SetRunParallel(Standard_True);
    for (const CadPart& part : parts)
    {
      copies_.push_back(
        { BRepBuilderAPI_Copy(part.shape).Shape(), part.name, part.faces, part.instance });
      fuse_.AddArgument(copies_.back().shape);
    }
  }

  // False if Open CASCADE could not.
  bool perform()
  {
    const Handle(CadProgress) progress = new CadProgress(report_, 0.5, 0.7);
    fuse_.Perform(progress->Start());
    return !fuse_.HasErrors();
  }

  std::string why() const
  {
    std::ostringstream text;
    fuse_.DumpErrors(text);
    return text.str();
  }

  // What the solids have become; a solid that several have in part has all their names.
  std::vector<CadPart> parts()
  {
    followFaces();
    TopTools_IndexedMapOfShape solids;
    std::vector<std::string> names;
    for (const CadPart& copy : copies_)
    {
      for (const TopoDS_Shape& solid : imagesOf(copy.shape))
      {
        if (const auto known = static_cast<std::size_t>(solids.FindIndex(solid)); known > 0)
        {
          names[known - 1] += "_and_" + copy.name;
          isCommon_[known - 1] = true;
          continue;
        }
        solids.Add(solid);
        names.push_back(copy.name);
        isCommon_.push_back(false);
      }
    }
    TopoDS_Compound all;
    BRep_Builder().MakeCompound(all);
    std::vector<CadPart> made;
    for (int i = 1; i <= solids.Extent(); ++i)
    {
      BRep_Builder().Add(all, solids(i));
      made.push_back({ {}, names[static_cast<std::size_t>(i - 1)], history_.of(solids(i)), {} });
    }
    // Points and lines inside a face, where another solid touches it: triangles around them are far off.
    BRepTools::RemoveInternals(all, Standard_True);
    TopoDS_Iterator clean(all);
    for (CadPart& part : made)
    {
      part.shape = clean.Value();
      clean.Next();
    }
    return made;
  }

  // Whether several solids hold that one of parts().
  bool isCommon(std::size_t part) const { return isCommon_[part]; }

private:
  void followFaces()
  {
    for (const CadPart& copy : copies_)
    {
      history_.add(copy);
    }
    for (const CadPart& copy : copies_)
    {
      for (TopExp_Explorer face(copy.shape, TopAbs_FACE); face.More(); face.Next())
      {
        for (const TopoDS_Shape& image : fuse_.Modified(face.Current()))
        {
          history_.follow(face.Current(), image);
        }
      }
    }
  }

  std::vector<TopoDS_Shape> imagesOf(const TopoDS_Shape& solid)
  {
    const TopTools_ListOfShape& images = fuse_.Modified(solid);
    if (images.IsEmpty())
    {
      return { solid };
    }
    std::vector<TopoDS_Shape> all(images.begin(), images.end());
    const auto end = std::remove_if(all.begin(), all.end(), isFilm);
    return { all.begin(), end == all.begin() ? all.end() : end };
  }

  const CadReport& report_;
  BOPAlgo_Builder fuse_;
  std::vector<CadPart> copies_;
  FaceHistory history_;
  std::vector<bool> isCommon_;
};

int countFree(const std::vector<CadPart>& parts)
{
  int count = 0;
  for (const CadPart& part : parts)
  {
    count += freeEdges(part.shape).Extent();
  }
  return count;
}

// Faces of two solids.
int countShared(const std::vector<CadPart>& parts)
{
  TopTools_IndexedMapOfShape known;
  int shared = 0;
  for (const CadPart& part : parts)
  {
    const TopTools_IndexedMapOfShape faces = facesOf(part.shape);
    const int before = known.Extent();
    TopExp::MapShapes(part.shape, TopAbs_FACE, known);
    shared += before + faces.Extent() - known.Extent();
  }
  return shared;
}

}

void glue(std::vector<CadPart>& parts, const CadOptions& options, const CadReport& report)
{
  std::vector<CadPart> solids;
  std::vector<CadPart> sheets;
  for (CadPart& part : parts)
  {
    (part.shape.ShapeType() == TopAbs_SOLID ? solids : sheets).push_back(part);
  }
  if (solids.size() < 2)
  {
    return;
  }
  Fuse fuse(solids, report);
  if (!fuse.perform())
  {
    report.warning("The solids could not be glued (" + fuse.why() +
      "): they stay apart. Correct the solids that overlap.");
    return;
  }
  std::vector<CadPart> glued = fuse.parts();
  if (countFree(glued) > countFree(solids))
  {
    report.warning(
      "Gluing would open solids: they stay apart. Correct those that overlap, or switch "
      "off Glue Solids.");
    return;
  }
  std::map<std::string, int> pieces;
  for (std::size_t p = 0; p < glued.size(); ++p)
  {
    if (fuse.isCommon(p))
    {
      report.warning("Solids overlap at " + placeOf(glued[p].shape, options.unit) +
        ": what several of them hold is the solid " + glued[p].name +
        ". Correct the assembly if they should only touch.");
    }
    pieces[glued[p].name] += fuse.isCommon(p) ? 0 : 1;
  }
  for (const auto& [name, count] : pieces)
  {
    if (count > 1)
    {
      report.warning("Gluing divided the solid " + name + " into " + std::to_string(count) +
        " solids: another one passes through it. Correct the assembly if they should only touch.");
    }
  }
  report.note("Glued: " + std::to_string(solids.size()) + " solids, which share " +
    std::to_string(countShared(glued)) + " faces.");
  glued.insert(glued.end(), sheets.begin(), sheets.end());
  parts = std::move(glued);
}

void noteNeighbours(const std::vector<CadPart>& parts, const CadReport& report)
{
  std::vector<Bnd_Box> boxes;
  for (const CadPart& part : parts)
  {
    BRepBndLib::Add(part.shape, boxes.emplace_back(), Standard_False);
  }
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    pairs += static_cast<std::size_t>(
      std::count_if(boxes.begin(), boxes.begin() + static_cast<std::ptrdiff_t>(i),
        [&](const Bnd_Box& other) { return !boxes[i].IsOut(other); }));
  }
  if (pairs > 0)
  {
    report.note("Glue Solids is off: regions of solids that touch need it. Pairs that may touch: " +
      std::to_string(pairs) + ".");
  }
}

}
