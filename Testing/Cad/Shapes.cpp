#include "Shapes.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax1.hxx>

#include <cmath>
#include <stdexcept>

namespace cartesian
{

namespace
{

constexpr double Near = 1e-9;

TopoDS_Face polygonFace(const std::vector<gp_Pnt>& polygon)
{
  BRepBuilderAPI_MakePolygon wire;
  for (const gp_Pnt& point : polygon)
  {
    wire.Add(point);
  }
  wire.Close();
  return BRepBuilderAPI_MakeFace(wire.Wire());
}

// What a boolean operation gives is a compound of one solid.
TopoDS_Shape onlySolid(const TopoDS_Shape& shape)
{
  TopExp_Explorer explorer(shape, TopAbs_SOLID);
  const TopoDS_Shape solid = explorer.Current();
  explorer.Next();
  if (explorer.More())
  {
    throw std::runtime_error("several solids instead of one");
  }
  return solid;
}

}

TopoDS_Shape box(const gp_Pnt& low, const gp_Pnt& high)
{
  return BRepPrimAPI_MakeBox(low, high).Shape();
}

TopoDS_Shape cylinder(const gp_Ax2& base, double radius, double height)
{
  return BRepPrimAPI_MakeCylinder(base, radius, height).Shape();
}

TopoDS_Shape prism(const std::vector<gp_Pnt>& polygon, double depth)
{
  return BRepPrimAPI_MakePrism(polygonFace(polygon), gp_Vec(0, depth, 0)).Shape();
}

TopoDS_Face rectangle(const gp_Pnt& corner, const gp_Vec& one, const gp_Vec& other)
{
  return polygonFace(
    { corner, corner.Translated(one), corner.Translated(one + other), corner.Translated(other) });
}

TopoDS_Shape fused(const TopoDS_Shape& one, const TopoDS_Shape& other)
{
  return onlySolid(BRepAlgoAPI_Fuse(one, other).Shape());
}

TopoDS_Shape cut(const TopoDS_Shape& from, const TopoDS_Shape& tool)
{
  return onlySolid(BRepAlgoAPI_Cut(from, tool).Shape());
}

TopoDS_Shape compound(const std::vector<TopoDS_Shape>& shapes)
{
  BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (const TopoDS_Shape& shape : shapes)
  {
    builder.Add(all, shape);
  }
  return all;
}

TopoDS_Shape moved(const TopoDS_Shape& shape, const gp_Trsf& by)
{
  const bool copy = true;
  return BRepBuilderAPI_Transform(shape, by, copy).Shape();
}

gp_Trsf translation(const gp_Vec& by)
{
  gp_Trsf result;
  result.SetTranslation(by);
  return result;
}

gp_Trsf turnAboutZ(double angle)
{
  gp_Trsf result;
  result.SetRotation(gp::OZ(), angle);
  return result;
}

std::vector<TopoDS_Face> facesOf(const TopoDS_Shape& shape)
{
  std::vector<TopoDS_Face> result;
  for (TopExp_Explorer explorer(shape, TopAbs_FACE); explorer.More(); explorer.Next())
  {
    result.push_back(TopoDS::Face(explorer.Current()));
  }
  return result;
}

TopoDS_Face faceAt(const TopoDS_Shape& shape, const gp_Pnt& point)
{
  TopoDS_Face found;
  for (const TopoDS_Face& face : facesOf(shape))
  {
    if (BRepExtrema_DistShapeShape(face, BRepBuilderAPI_MakeVertex(point).Vertex()).Value() < Near)
    {
      if (!found.IsNull())
      {
        throw std::runtime_error("two faces have the point");
      }
      found = face;
    }
  }
  if (found.IsNull())
  {
    throw std::runtime_error("no face has the point");
  }
  return found;
}

TopoDS_Edge edgeBetween(const TopoDS_Shape& shape, const gp_Pnt& start, const gp_Pnt& end)
{
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i)
  {
    const TopoDS_Edge edge = TopoDS::Edge(edges(i));
    const gp_Pnt one = BRep_Tool::Pnt(TopExp::FirstVertex(edge));
    const gp_Pnt other = BRep_Tool::Pnt(TopExp::LastVertex(edge));
    if ((one.IsEqual(start, Near) && other.IsEqual(end, Near)) ||
      (one.IsEqual(end, Near) && other.IsEqual(start, Near)))
    {
      return edge;
    }
  }
  throw std::runtime_error("no edge has these ends");
}

TopoDS_Shape boxWithHole(double x, double y, double z, double radius)
{
  const gp_Ax2 base(gp_Pnt(0, 0, -z), gp::DZ());
  return cut(
    box({ -x / 2, -y / 2, -z / 2 }, { x / 2, y / 2, z / 2 }), cylinder(base, radius, 2 * z));
}

SolidFacts boxWithHoleFacts(const std::string& name, double x, double y, double z, double radius)
{
  SolidFacts facts = boxFacts(name, x, y, z);
  facts.volume -= Pi * radius * radius * z;
  facts.area += 2 * Pi * radius * (z - radius);
  return facts;
}

SolidFacts boxFacts(const std::string& name, double x, double y, double z)
{
  return { name, x * y * z, 2 * (x * y + y * z + z * x) };
}

gp_Trsf turnOf(int degrees)
{
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp::Origin(), gp_Dir(1, 2, 3)), degrees * Degree);
  return turn;
}

void forEachPlace(
  const std::function<void(double size, const gp_Trsf& place, const std::string& name)>& make)
{
  for (const double size : { 0.1, 1.0, 10.0 })
  {
    for (const int degrees : { 0, 10, 30, 45 })
    {
      gp_Trsf scaling;
      scaling.SetScale(gp::Origin(), size);
      make(size, turnOf(degrees) * scaling,
        std::to_string(std::lround(10 * size)) + "_" + std::to_string(degrees));
    }
  }
}

}
