// SPDX-License-Identifier: BSD-3-Clause
// Points of triangulated faces, numbered so that what lies on a common edge or vertex is one point.
#pragma once

#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>

#include <array>
#include <cstdint>
#include <map>
#include <vector>

class Poly_Triangulation;

namespace cartesian
{

class CadWeld
{
public:
  // Numbers of the nodes of a face's triangulation, by its own numbers less 1. Of the same faces in the same order,
  // the same.
  std::vector<std::int64_t> nodesOf(const TopoDS_Face& face);

  // The points of an edge, in order, that a face before has, and its parameters there. Empty if none has.
  struct Line
  {
    std::vector<std::int64_t> points;
    std::vector<double> parameters;
  };
  const Line* lineOf(const TopoDS_Shape& edge) const;

  const std::vector<gp_Pnt>& points() const { return points_; }

private:
  std::int64_t add(const gp_Pnt& point);
  std::int64_t addOnce(const gp_Pnt& point);
  std::int64_t vertex(const TopoDS_Shape& shape);
  void weldEdge(const TopoDS_Edge& edge, const Handle(Poly_Triangulation) & triangles,
    const TopLoc_Location& place, std::vector<std::int64_t>& nodes);

  std::vector<gp_Pnt> points_;
  std::map<std::array<double, 3>, std::int64_t> ofPlace_; // of faces that know no edges
  TopTools_IndexedMapOfShape vertices_;
  std::vector<std::int64_t> ofVertex_;
  TopTools_IndexedMapOfShape edges_;
  std::vector<Line> lines_; // of each edge
};

}
