// SPDX-License-Identifier: BSD-3-Clause
#include "CadWeld.h"

#include "CadPart.h"

#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

namespace cartesian
{

namespace
{

constexpr std::int64_t None = -1;

}

std::int64_t CadWeld::add(const gp_Pnt& point)
{
  points_.push_back(point);
  return static_cast<std::int64_t>(points_.size()) - 1;
}

std::int64_t CadWeld::addOnce(const gp_Pnt& point)
{
  const auto [place, isNew] = ofPlace_.try_emplace({ point.X(), point.Y(), point.Z() }, None);
  return place->second = isNew ? add(point) : place->second;
}

std::int64_t CadWeld::vertex(const TopoDS_Shape& shape)
{
  const auto index = static_cast<std::size_t>(vertices_.Add(shape));
  if (index > ofVertex_.size())
  {
    ofVertex_.push_back(add(BRep_Tool::Pnt(TopoDS::Vertex(shape))));
  }
  return ofVertex_[index - 1];
}

void CadWeld::weldEdge(const TopoDS_Edge& edge, const Handle(Poly_Triangulation) & triangles,
  const TopLoc_Location& place, std::vector<std::int64_t>& nodes)
{
  const Handle(Poly_PolygonOnTriangulation) polygon =
    BRep_Tool::PolygonOnTriangulation(edge, triangles, place);
  if (polygon.IsNull() || polygon->NbNodes() < 2)
  {
    return;
  }
  const int count = polygon->NbNodes();
  const TopoDS_Vertex begin = TopExp::FirstVertex(edge); // of the edge forward, as the polygon
  const TopoDS_Vertex end = TopExp::LastVertex(edge);
  const auto at = [&](int i) -> std::int64_t& {
    return nodes[static_cast<std::size_t>(polygon->Node(i) - 1)];
  };
  if (BRep_Tool::Degenerated(edge) && !begin.IsNull())
  {
    for (int i = 1; i <= count; ++i)
    {
      at(i) = vertex(begin);
    }
    return;
  }
  const auto index = static_cast<std::size_t>(edges_.Add(edge));
  if (index > lines_.size())
  {
    Line& line = lines_.emplace_back();
    for (int i = 1; i <= count; ++i)
    {
      const TopoDS_Vertex& corner = i == 1 ? begin : end;
      const bool isCorner = (i == 1 || i == count) && !corner.IsNull();
      line.points.push_back(
        isCorner ? vertex(corner) : add(triangles->Node(polygon->Node(i)).Transformed(place)));
      line.parameters.push_back(polygon->HasParameters() ? polygon->Parameters()->Value(i) : 0);
    }
    if (begin.IsNull() && BRep_Tool::IsClosed(edge))
    {
      line.points.back() = line.points.front();
    }
  }
  const Line& line = lines_[index - 1];
  for (int i = 1; i <= count && static_cast<std::size_t>(count) == line.points.size(); ++i)
  {
    at(i) = line.points[static_cast<std::size_t>(i - 1)];
  }
}

std::vector<std::int64_t> CadWeld::nodesOf(const TopoDS_Face& face)
{
  TopLoc_Location place;
  const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(face, place);
  if (triangles.IsNull())
  {
    return {};
  }
  std::vector<std::int64_t> nodes(static_cast<std::size_t>(triangles->NbNodes()), None);
  // Of a seam, each side by its orientation in the face forward.
  for (TopExp_Explorer edge(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); edge.More(); edge.Next())
  {
    weldEdge(TopoDS::Edge(edge.Current()), triangles, place, nodes);
  }
  const bool hasEdges = !isTessellated(face);
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    if (nodes[i] == None)
    {
      const gp_Pnt point = triangles->Node(static_cast<int>(i) + 1).Transformed(place);
      nodes[i] = hasEdges ? add(point) : addOnce(point);
    }
  }
  return nodes;
}

const CadWeld::Line* CadWeld::lineOf(const TopoDS_Shape& edge) const
{
  const int index = edges_.FindIndex(edge);
  return index == 0 ? nullptr : &lines_[static_cast<std::size_t>(index - 1)];
}

}
