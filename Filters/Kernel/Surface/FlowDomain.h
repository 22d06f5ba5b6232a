// SPDX-License-Identifier: BSD-3-Clause
// Which side of the surface is meshed: what it encloses, or the space around it, in a box.
//
// Outside, the surface is turned inside out, so that its winding far away is one: a point in no body is inside
// (Winding.h), in the union of bodies it is not, and no triangles of the box are needed. The box ends where the grid
// does; bodies that reach beyond are cut off there exactly.
#pragma once

#include "Lattice/Meshlines.h"
#include "Surface/Surface.h"

#include <string>

namespace cartesian
{

enum class Domain : std::uint8_t
{
  Inside = 0,       // what the surface encloses
  Outside = 1,      // a box without the bodies that the surface encloses
  AroundPoints = 2, // spaces that it encloses, in bodies or between them, around the points to keep
};

enum class BoxSource : std::uint8_t
{
  Surface = 0, // lengths of it before, behind and beside
  Bounds = 1,  // as given
};

enum class FlowDirection : std::uint8_t
{
  PlusX = 0,
  MinusX = 1,
  PlusY = 2,
  MinusY = 3,
  PlusZ = 4,
  MinusZ = 5,
};

// A side of the box.
enum class DomainSide : std::uint8_t
{
  NoSide = 0,
  XMin = 1,
  XMax = 2,
  YMin = 3,
  YMax = 4,
  ZMin = 5,
  ZMax = 6,
};

// Which half of the box is left out: all below the middle of the surface along one axis.
enum class Half : std::uint8_t
{
  Whole = 0,
  AcrossX = 1,
  AcrossY = 2,
  AcrossZ = 3,
};

// The names of the sides of the box.
enum class SideNames : std::uint8_t
{
  Axes = 0, // xMin, xMax, yMin, ...
  Flow = 1, // inlet, outlet, ground, symmetry; and sides, which are one boundary
};

struct DomainSpec
{
  static constexpr Range Lengths{ 0 };
  static constexpr Range BoxesAlong{ 0, 1000 };

  Domain domain = Domain::Inside;
  BoxSource boxFrom = BoxSource::Surface;
  FlowDirection flow = FlowDirection::PlusX;
  double before = 3; // times the surface's longest side
  double behind = 5;
  double beside = 3;
  DomainSide ground = DomainSide::NoSide; // there the box ends with the surface
  Half half = Half::Whole;
  SideNames sideNames = SideNames::Flow;
  int boxesAlong =
    60; // the bodies' longest side, if no depth is specified; 0: any number (FlowRefinement.h)
  Bounds bounds{};              // user units
  EndBoundaries sides = NoEnds; // boundaries of the box's sides

  // In user units: connected parts of the domain without any are left out; none: all parts stay.
  std::vector<std::array<double, 3>> keepPoints;
  std::vector<std::array<double, 3>> keepOut; // no part that stays may contain one

  bool isOutside() const { return domain == Domain::Outside; }
};

std::array<double, 3> unitAlong(FlowDirection flow);

// The box around a surface with these bounds. Throws Error: BadParameter.
Bounds boxAround(const DomainSpec& spec, const Bounds& surface);

// Of the sides in the order of DomainSide. Sides of the same name are one boundary.
std::array<std::string, 6> namesOfSides(const DomainSpec& spec);

// A note if bodies with these bounds lie across the flow, which may be meant; or empty. A body that is longest away from
// the ground stands on it.
std::string describeAcross(const DomainSpec& spec, const Bounds& surface);

// Turns the oriented surface into the boundary of the space around it.
void turnInsideOut(Surface& surface);

}
