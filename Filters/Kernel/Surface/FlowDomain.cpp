// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/FlowDomain.h"

#include "Base/Error.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace cartesian
{

namespace
{

// A surface this many times smaller than the box would lose its shape on a lattice that holds the box.
constexpr double LargestBox = 1e5;

// A body this many times longer along another axis than along the flow lies across it.
constexpr double ClearlyLonger = 1.5;

Bounds lengthsAround(const DomainSpec& spec, const Bounds& surface)
{
  requireInRange(DomainSpec::Lengths, spec.before, "Lengths Before");
  requireInRange(DomainSpec::Lengths, spec.behind, "Lengths Behind");
  requireInRange(DomainSpec::Lengths, spec.beside, "Lengths Beside");
  const auto flow = static_cast<std::size_t>(spec.flow);
  Bounds box = surface;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const bool along = axis == flow / 2;
    const bool back = flow % 2 == 1;
    const double low = along ? (back ? spec.behind : spec.before) : spec.beside;
    const double high = along ? (back ? spec.before : spec.behind) : spec.beside;
    box.low[axis] -= low * surface.longest();
    box.high[axis] += high * surface.longest();
  }
  return box;
}

void checkBox(const Bounds& box, const Bounds& surface)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::string along = std::string(" along ") + "xyz"[axis];
    const std::string ends = number(box.low[axis]) + " to " + number(box.high[axis]) + along;
    if (!std::isfinite(box.low[axis]) || !std::isfinite(box.high[axis]) ||
      !(box.low[axis] < box.high[axis]))
    {
      throw Error(Fault::BadParameter,
        "The box of the domain runs from " + ends + ": give the lower bound first.");
    }
    if (box.high[axis] - box.low[axis] > LargestBox * surface.longest())
    {
      throw Error(Fault::BadParameter,
        "The box of the domain runs from " + ends + ", but the surface is only " +
          number(surface.longest()) + " long: choose a smaller box.");
    }
    if (box.high[axis] <= surface.low[axis] || box.low[axis] >= surface.high[axis])
    {
      throw Error(Fault::BadParameter,
        "The box of the domain runs from " + ends + " and misses the surface, which lies between " +
          number(surface.low[axis]) + " and " + number(surface.high[axis]) +
          ". Choose bounds that contain part of it.");
    }
  }
}

}

std::array<double, 3> unitAlong(FlowDirection flow)
{
  std::array<double, 3> unit{};
  unit[static_cast<std::size_t>(flow) / 2] = static_cast<std::size_t>(flow) % 2 == 0 ? 1 : -1;
  return unit;
}

Bounds boxAround(const DomainSpec& spec, const Bounds& surface)
{
  Bounds box = spec.boxFrom == BoxSource::Bounds ? spec.bounds : lengthsAround(spec, surface);
  if (spec.ground != DomainSide::NoSide)
  {
    const std::size_t side = static_cast<std::size_t>(spec.ground) - 1;
    (side % 2 == 0 ? box.low : box.high)[side / 2] =
      (side % 2 == 0 ? surface.low : surface.high)[side / 2];
  }
  if (spec.half != Half::Whole)
  {
    const std::size_t axis = static_cast<std::size_t>(spec.half) - 1;
    box.low[axis] = surface.low[axis] + (surface.high[axis] - surface.low[axis]) / 2;
  }
  checkBox(box, surface);
  return box;
}

std::array<std::string, 6> namesOfSides(const DomainSpec& spec)
{
  if (spec.sideNames == SideNames::Axes)
  {
    return { "xMin", "xMax", "yMin", "yMax", "zMin", "zMax" };
  }
  std::array<std::string, 6> names;
  names.fill("sides");
  const auto inlet = static_cast<std::size_t>(spec.flow);
  names[inlet] = "inlet";
  names[inlet ^ 1] = "outlet";
  if (spec.ground != DomainSide::NoSide)
  {
    names[static_cast<std::size_t>(spec.ground) - 1] = "ground";
  }
  if (spec.half != Half::Whole)
  {
    names[2 * (static_cast<std::size_t>(spec.half) - 1)] = "symmetry";
  }
  return names;
}

std::string describeAcross(const DomainSpec& spec, const Bounds& surface)
{
  const bool hasFlow =
    spec.isOutside() && (spec.boxFrom == BoxSource::Surface || spec.sideNames == SideNames::Flow);
  std::array<double, 3> lengths{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    lengths[axis] = surface.high[axis] - surface.low[axis];
  }
  const auto longest =
    static_cast<std::size_t>(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
  const std::size_t along = static_cast<std::size_t>(spec.flow) / 2;
  const bool stands =
    spec.ground != DomainSide::NoSide && (static_cast<std::size_t>(spec.ground) - 1) / 2 == longest;
  if (!hasFlow || stands || lengths[longest] < ClearlyLonger * lengths[along])
  {
    return "";
  }
  const char axis = "xyz"[longest];
  const char upper = "XYZ"[longest];
  return std::string("The body is ") + number(lengths[longest]) + " long along " + axis + ", but " +
    number(lengths[along]) + " along " + "xyz"[along] +
    ", where the flow goes. If that is not meant, " + "choose Flow Direction Plus " + upper +
    " or Minus " + upper + ".";
}

void turnInsideOut(Surface& surface)
{
  for (auto& triangle : surface.triangles)
  {
    std::swap(triangle[1], triangle[2]);
  }
}

}
