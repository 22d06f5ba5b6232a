#include "Facts.h"

#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace cartesian
{

namespace
{

struct Tolerances
{
  double volume, area; // relative
};

Tolerances tolerancesOf(Integrals integrals)
{
  return integrals == Integrals::FixedOrder ? Tolerances{ 1e-9, 1e-9 }
    : integrals == Integrals::Adaptive      ? Tolerances{ 1e-7, 2e-3 }
                                            : Tolerances{ 1e-5, 2e-3 };
}

bool equal(double one, double other, double tolerance)
{
  return std::abs(one - other) <= tolerance * std::abs(other);
}

double areaOf(const TopoDS_Shape& shape)
{
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties);
  return properties.Mass();
}

GProp_GProps volumeOf(const TopoDS_Shape& solid, Integrals integrals)
{
  GProp_GProps properties;
  if (integrals == Integrals::FixedOrder)
  {
    BRepGProp::VolumeProperties(solid, properties);
  }
  else
  {
    BRepGProp::VolumePropertiesGK(
      solid, properties, integrals == Integrals::Adaptive ? 1e-9 : 1e-5);
  }
  return properties;
}

bool isThis(const SolidFacts& facts, const TopoDS_Shape& solid, Integrals integrals)
{
  const GProp_GProps properties = volumeOf(solid, integrals);
  const Tolerances tolerances = tolerancesOf(integrals);
  const double size = std::cbrt(facts.volume);
  return equal(properties.Mass(), facts.volume, tolerances.volume) &&
    equal(areaOf(solid), facts.area, tolerances.area) &&
    (!facts.centre ||
      properties.CentreOfMass().Distance(*facts.centre) <= tolerances.volume * size);
}

template <class Number>
void expect(const std::string& what, Number is, Number should, double tolerance = 0)
{
  if (!equal(static_cast<double>(is), static_cast<double>(should), tolerance))
  {
    std::ostringstream message;
    message << std::setprecision(17) << what << ": " << is << " instead of " << should;
    throw std::runtime_error(message.str());
  }
}

void checkSolids(const Facts& facts, const TopoDS_Shape& shape)
{
  std::vector<TopoDS_Shape> solids;
  for (TopExp_Explorer explorer(shape, TopAbs_SOLID); explorer.More(); explorer.Next())
  {
    solids.push_back(explorer.Current());
  }
  expect("solids", solids.size(), facts.solids.size());
  for (const SolidFacts& one : facts.solids)
  {
    const auto found = std::find_if(solids.begin(), solids.end(),
      [&](const TopoDS_Shape& solid) { return isThis(one, solid, facts.integrals); });
    if (found == solids.end())
    {
      std::ostringstream message;
      message << std::setprecision(17) << "no solid is what is said of " << one.name << ", "
              << one.volume << " and " << one.area;
      for (const TopoDS_Shape& solid : solids)
      {
        message << "; there is " << volumeOf(solid, facts.integrals).Mass() << " and "
                << areaOf(solid);
      }
      throw std::runtime_error(message.str());
    }
    solids.erase(found);
  }
}

int openEdgesOf(const TopoDS_Shape& shape)
{
  TopTools_IndexedDataMapOfShapeListOfShape facesOfEdges;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, facesOfEdges);
  int count = 0;
  for (int i = 1; i <= facesOfEdges.Extent(); ++i) // a seam has its face twice
  {
    count += facesOfEdges(i).Extent() == 1 &&
      !BRep_Tool::Degenerated(TopoDS::Edge(facesOfEdges.FindKey(i)));
  }
  return count;
}

double totalArea(const Facts& facts)
{
  double sum = 0;
  for (const SolidFacts& solid : facts.solids)
  {
    sum += solid.area;
  }
  return facts.area.value_or(sum);
}

std::string quoted(const std::string& text)
{
  std::string result = "\"";
  for (const char character : text)
  {
    result += (character == '"' || character == '\\') ? std::string("\\") + character
                                                      : std::string(1, character);
  }
  return result + '"';
}

void print(std::ostream& stream, const std::map<std::string, double>& numbers)
{
  const char* separator = "";
  stream << "{";
  for (const auto& [name, number] : numbers)
  {
    stream << separator << quoted(name) << ": " << number;
    separator = ", ";
  }
  stream << "}";
}

void print(std::ostream& stream, const SolidFacts& solid)
{
  stream << "{\"name\": " << quoted(solid.name) << ", \"volume\": " << solid.volume
         << ", \"area\": " << solid.area;
  if (solid.centre)
  {
    stream << ", \"centre\": [" << solid.centre->X() << ", " << solid.centre->Y() << ", "
           << solid.centre->Z() << "]";
  }
  stream << "}";
}

}

void check(const Facts& facts, const TopoDS_Shape& shape,
  const std::vector<std::pair<TopoDS_Shape, std::string>>& boundaries)
{
  checkSolids(facts, shape);
  int faces = 0;
  for (TopExp_Explorer explorer(shape, TopAbs_FACE); explorer.More(); explorer.Next())
  {
    ++faces;
  }
  expect("faces", faces, facts.faces);
  expect("area", areaOf(shape), totalArea(facts), tolerancesOf(facts.integrals).area);
  expect("open edges", openEdgesOf(shape), facts.openEdges);
  std::map<std::string, double> areas;
  for (const auto& [subshape, name] : boundaries)
  {
    areas[name] += areaOf(subshape);
  }
  for (const auto& [name, area] : facts.boundaries)
  {
    expect("area of " + name, areas[name], area, tolerancesOf(facts.integrals).area);
  }
}

std::string json(const Facts& facts)
{
  std::ostringstream stream;
  stream << std::setprecision(17) << "{\"solids\": [";
  const char* separator = "";
  for (const SolidFacts& solid : facts.solids)
  {
    stream << separator;
    print(stream, solid);
    separator = ", ";
  }
  stream << "], \"area\": " << totalArea(facts) << ", \"faces\": " << facts.faces
         << ", \"openEdges\": " << facts.openEdges << ", \"boundaries\": ";
  print(stream, facts.boundaries);
  stream << ", \"others\": ";
  print(stream, facts.others);
  stream << "}";
  return stream.str();
}

}
