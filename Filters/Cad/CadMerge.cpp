// SPDX-License-Identifier: BSD-3-Clause
#include "CadMerge.h"

#include <BRepTools_History.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>

namespace cartesian
{

namespace
{

// Edges between faces that differ in name, colour or layer.
void keepBorders(const CadPart& part, ShapeUpgrade_UnifySameDomain& unify)
{
  const TopTools_IndexedMapOfShape faces = facesOf(part.shape);
  TopTools_IndexedDataMapOfShapeListOfShape facesOfEdges;
  TopExp::MapShapesAndAncestors(part.shape, TopAbs_EDGE, TopAbs_FACE, facesOfEdges);
  const auto of = [&](const TopoDS_Shape& face) -> const FaceAttributes& {
    return part.faces[static_cast<std::size_t>(faces.FindIndex(face) - 1)];
  };
  for (int i = 1; i <= facesOfEdges.Extent(); ++i)
  {
    for (const TopoDS_Shape& face : facesOfEdges(i))
    {
      if (!(of(face) == of(facesOfEdges(i).First())))
      {
        unify.KeepShape(facesOfEdges.FindKey(i));
      }
    }
  }
}

}

void mergeCoplanar(std::vector<CadPart>& parts, const CadReport& report)
{
  int before = 0;
  int after = 0;
  for (CadPart& part : parts)
  {
    ShapeUpgrade_UnifySameDomain unify(part.shape, Standard_True, Standard_True, Standard_False);
    keepBorders(part, unify);
    unify.Build();
    FaceHistory history;
    history.add(part);
    const TopTools_IndexedMapOfShape faces = facesOf(part.shape);
    for (int i = 1; i <= faces.Extent(); ++i)
    {
      for (const TopoDS_Shape& image : unify.History()->Modified(faces(i)))
      {
        history.follow(faces(i), image);
      }
    }
    part.shape = unify.Shape();
    part.faces = history.of(part.shape);
    before += faces.Extent();
    after += static_cast<int>(part.faces.size());
  }
  report.note("Merged: " + std::to_string(before) + " faces to " + std::to_string(after) + ".");
}

}
