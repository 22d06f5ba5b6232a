// SPDX-License-Identifier: BSD-3-Clause
#include "CadPart.h"

#include <BRepBndLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <array>
#include <cstdio>

namespace cartesian
{

TopTools_IndexedMapOfShape facesOf(const TopoDS_Shape& shape)
{
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  return faces;
}

TopTools_IndexedMapOfShape freeEdges(const TopoDS_Shape& shape)
{
  TopTools_IndexedDataMapOfShapeListOfShape facesOfEdges;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, facesOfEdges);
  TopTools_IndexedMapOfShape free;
  for (int i = 1; i <= facesOfEdges.Extent(); ++i)
  {
    const TopoDS_Edge& edge = TopoDS::Edge(facesOfEdges.FindKey(i));
    const TopTools_ListOfShape& faces = facesOfEdges(i);
    const bool isSeam =
      faces.Extent() > 0 && BRep_Tool::IsClosed(edge, TopoDS::Face(faces.First()));
    if (faces.Extent() == 1 && !isSeam && !BRep_Tool::Degenerated(edge) &&
      edge.Orientation() != TopAbs_INTERNAL)
    {
      free.Add(edge);
    }
  }
  return free;
}

bool isTessellated(const TopoDS_Shape& shape)
{
  const TopExp_Explorer face(shape, TopAbs_FACE);
  return face.More() && BRep_Tool::Surface(TopoDS::Face(face.Current())).IsNull();
}

std::string placeOf(const TopoDS_Shape& shape, double unit)
{
  Bnd_Box box;
  BRepBndLib::Add(shape, box, isTessellated(shape));
  if (box.IsVoid())
  {
    return "";
  }
  const gp_Pnt low = box.CornerMin();
  const gp_Pnt high = box.CornerMax();
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(), "(%.6g, %.6g, %.6g)", (low.X() + high.X()) / 2 / unit,
    (low.Y() + high.Y()) / 2 / unit, (low.Z() + high.Z()) / 2 / unit);
  return text.data();
}

void FaceHistory::add(const CadPart& part)
{
  const TopTools_IndexedMapOfShape faces = facesOf(part.shape);
  for (int i = 1; i <= faces.Extent(); ++i)
  {
    if (faces_.Add(faces(i)) > static_cast<int>(attributes_.size()))
    {
      attributes_.push_back(part.faces[static_cast<std::size_t>(i - 1)]);
    }
  }
}

void FaceHistory::follow(const TopoDS_Shape& face, const TopoDS_Shape& image)
{
  const int index = faces_.FindIndex(face);
  if (index > 0 && faces_.Add(image) > static_cast<int>(attributes_.size()))
  {
    attributes_.push_back(attributes_[static_cast<std::size_t>(index - 1)]);
  }
}

std::vector<FaceAttributes> FaceHistory::of(const TopoDS_Shape& shape) const
{
  std::vector<FaceAttributes> found;
  const TopTools_IndexedMapOfShape faces = facesOf(shape);
  for (int i = 1; i <= faces.Extent(); ++i)
  {
    const int index = faces_.FindIndex(faces(i));
    found.push_back(
      index > 0 ? attributes_[static_cast<std::size_t>(index - 1)] : FaceAttributes());
  }
  return found;
}

}
