// SPDX-License-Identifier: BSD-3-Clause
#include "StepProducts.h"

#include <gp_Ax3.hxx>

#include <algorithm>

namespace cartesian
{

namespace
{

gp_XYZ coordinatesOf(const StepEntity& entity, double unit)
{
  const std::vector<StepValue>& values = valueOf(entity, 1).list;
  return values.size() == 3 ? gp_XYZ(values[0].number, values[1].number, values[2].number) * unit
                            : gp_XYZ(0, 0, 0);
}

}

const StepValue& valueOf(const StepEntity& entity, std::size_t i)
{
  static const StepValue none;
  return i < entity.values.size() ? entity.values[i] : none;
}

StepProducts::StepProducts(const StepText& step)
  : step_(step)
{
  readRepresentations();
  readUsages();
}

void StepProducts::readRepresentations()
{
  for (const int number : step_.all("SHAPE_REPRESENTATION_RELATIONSHIP"))
  {
    const StepEntity link = step_.part(number, "SHAPE_REPRESENTATION_RELATIONSHIP");
    const int one = valueOf(link, 2).reference;
    const int other = valueOf(link, 3).reference;
    if (one != 0 && other != 0) // else it places one in the other
    {
      related_[one].insert(other);
      related_[other].insert(one);
    }
  }
  for (const int number : step_.all("SHAPE_DEFINITION_REPRESENTATION"))
  {
    const StepEntity link = step_.part(number, "SHAPE_DEFINITION_REPRESENTATION");
    const StepEntity shape = step_.part(valueOf(link, 0).reference, "PRODUCT_DEFINITION_SHAPE");
    std::vector<int> open{ valueOf(link, 1).reference };
    while (!open.empty())
    {
      const int representation = open.back();
      open.pop_back();
      if (products_.emplace(representation, valueOf(shape, 2).reference).second &&
        related_.count(representation) > 0)
      {
        open.insert(
          open.end(), related_.at(representation).begin(), related_.at(representation).end());
      }
    }
  }
}

void StepProducts::readUsages()
{
  std::map<int, gp_Trsf> where; // of usages
  for (const int number : step_.all("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION"))
  {
    const StepEntity link = step_.part(number, "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION");
    const int relation = valueOf(link, 0).reference;
    const StepEntity frames = step_.part(
      valueOf(step_.part(relation, "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION"), 0).reference,
      "ITEM_DEFINED_TRANSFORMATION");
    const int usage =
      valueOf(step_.part(valueOf(link, 1).reference, "PRODUCT_DEFINITION_SHAPE"), 2).reference;
    const int part = valueOf(step_.part(usage, "NEXT_ASSEMBLY_USAGE_OCCURRENCE"), 4).reference;
    if (!frames.values.empty())
    {
      where[usage] = whereOf(step_.part(relation, "REPRESENTATION_RELATIONSHIP"), frames, part);
    }
  }
  for (const int number : step_.all("NEXT_ASSEMBLY_USAGE_OCCURRENCE"))
  {
    const StepEntity usage = step_.part(number, "NEXT_ASSEMBLY_USAGE_OCCURRENCE");
    const std::string& name = valueOf(usage, 1).text;
    usages_[valueOf(usage, 4).reference].push_back(
      { valueOf(usage, 3).reference, name.empty() ? valueOf(usage, 0).text : name, where[number] });
  }
}

// Takes the frame in the part to the one in the assembly; files have them in either order.
gp_Trsf StepProducts::whereOf(const StepEntity& relation, const StepEntity& frames, int part) const
{
  const int first = valueOf(relation, 2).reference;
  const gp_Trsf one = frameOf(valueOf(frames, 2).reference, first);
  const gp_Trsf other = frameOf(valueOf(frames, 3).reference, valueOf(relation, 3).reference);
  return productOf(first) == part ? other * one.Inverted() : one * other.Inverted();
}

// From its own coordinates to those of the representation.
gp_Trsf StepProducts::frameOf(int axes, int representation) const
{
  const StepEntity frame = step_.part(axes, "AXIS2_PLACEMENT_3D");
  const std::vector<StepEntity> kinds = step_.at(representation);
  const double unit = kinds.empty() ? 1 : millimetresIn(valueOf(kinds.front(), 2).reference);
  const auto direction = [&](std::size_t i, const gp_XYZ& other) {
    const gp_XYZ given = coordinatesOf(step_.part(valueOf(frame, i).reference, "DIRECTION"), 1);
    return gp_Dir(given.Modulus() > gp::Resolution() ? given : other);
  };
  const gp_Dir z = direction(2, gp_XYZ(0, 0, 1));
  const gp_Dir x = direction(3, gp_XYZ(1, 0, 0));
  const gp_Pnt origin(
    coordinatesOf(step_.part(valueOf(frame, 1).reference, "CARTESIAN_POINT"), unit));
  gp_Trsf toFrame;
  toFrame.SetTransformation(
    z.IsParallel(x, gp::Resolution()) ? gp_Ax3(origin, z) : gp_Ax3(origin, z, x));
  return toFrame.Inverted();
}

int StepProducts::productOf(int representation) const
{
  const auto product = products_.find(representation);
  return product == products_.end() ? 0 : product->second;
}

std::string StepProducts::nameOf(int product) const
{
  const auto first = [&](int number) {
    const std::vector<StepEntity> kinds = step_.at(number);
    return kinds.empty() ? StepEntity() : kinds.front();
  };
  const StepEntity version = first(valueOf(first(product), 2).reference);
  return valueOf(first(valueOf(version, 2).reference), 0).text;
}

std::set<int> StepProducts::representationsOf(int product) const
{
  std::set<int> all;
  for (const auto& [representation, of] : products_)
  {
    if (of == product)
    {
      all.insert(representation);
    }
  }
  return all;
}

std::vector<StepPlace> StepProducts::placesOf(int product) const
{
  std::vector<StepPlace> places;
  std::set<int> above;
  addPlaces(product, {}, above, places);
  return places;
}

// `above`: products that hold it, as none can hold itself.
void StepProducts::addPlaces(
  int product, const StepPlace& inner, std::set<int>& above, std::vector<StepPlace>& places) const
{
  const auto used = usages_.find(product);
  if (used == usages_.end() || !above.insert(product).second)
  {
    places.push_back(inner);
    return;
  }
  for (const Usage& usage : used->second)
  {
    addPlaces(usage.assembly,
      { usage.where * inner.where, inner.name.empty() ? usage.name : inner.name }, above, places);
  }
  above.erase(product);
}

double StepProducts::lengthOf(int unit) const
{
  static const std::map<std::string, double> prefixes{ { "MILLI", 1 }, { "CENTI", 10 },
    { "DECI", 100 }, { "KILO", 1e6 }, { "MICRO", 1e-3 }, { "NANO", 1e-6 } };
  const StepEntity converted = step_.part(unit, "CONVERSION_BASED_UNIT");
  if (!converted.values.empty())
  {
    const std::vector<StepEntity> kinds = step_.at(valueOf(converted, 1).reference);
    const StepEntity value = kinds.empty() ? StepEntity() : kinds.front();
    const StepValue& length = valueOf(value, 0);
    return length.list.empty() ? 1
                               : length.list.front().number * lengthOf(valueOf(value, 1).reference);
  }
  const auto prefix = prefixes.find(valueOf(step_.part(unit, "SI_UNIT"), 0).text);
  return prefix == prefixes.end() ? 1000 : prefix->second;
}

double StepProducts::millimetresIn(int context) const
{
  const StepEntity units = step_.part(context, "GLOBAL_UNIT_ASSIGNED_CONTEXT");
  for (const StepValue& unit : valueOf(units, 0).list)
  {
    const std::vector<StepEntity> kinds = step_.at(unit.reference);
    if (std::any_of(kinds.begin(), kinds.end(),
          [](const StepEntity& part) { return part.type == "LENGTH_UNIT"; }))
    {
      return lengthOf(unit.reference);
    }
  }
  return 1;
}

}
