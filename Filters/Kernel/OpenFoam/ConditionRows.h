// SPDX-License-Identifier: BSD-3-Clause
// What a user says of boundaries, regions and zones of a case: rows of three tables, all in SI units except rpm.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace cartesian
{

enum class FlowCondition : std::uint8_t
{
  ByName,     // what the patch has without a row
  Speed,      // m/s, normal to the patch
  VolumeFlow, // m3/s
  MassFlow,   // kg/s
  Pressure,   // Pa above the surroundings: at an inlet the total pressure, elsewhere the static one
};

enum class HeatCondition : std::uint8_t
{
  ByName,
  Temperature, // K
  HeatFlux,    // W/m2, into the mesh
};

// Of the patches with a name, or of those that a pattern (* any text, ? any character) names: the own name counts before
// patterns, of these the first. Speed and flows go into the mesh at an inlet and out of it elsewhere; negative: the other way.
struct Condition
{
  std::string boundary;
  FlowCondition flow = FlowCondition::ByName;
  double flowValue = 0;
  HeatCondition heat = HeatCondition::ByName;
  double heatValue = 0;
  double intensity =
    -1; // of turbulence, more than 0 to 1, in parts of the speed; -1: 0.05, around bodies 0.01
  double length = -1; // of turbulence, m; -1: so that the eddy viscosity is ten times the fluid's
};

enum class Material : std::uint8_t
{
  ByKind, // air in fluid regions, steel in solid ones
  Air,
  Water,
  Aluminium,
  Copper,
  Steel,
};

// Of the regions with a name, or of a pattern, as above.
struct RegionMaterial
{
  std::string region;
  Material material = Material::ByKind;
  double density = -1;      // kg/m3; -1: the material's, as below
  double heatCapacity = -1; // J/(kg K)
  double conductivity = -1; // W/(m K)
  double viscosity = -1;    // kinematic, m2/s, of a fluid; -1 and ByKind: that of the set-up
  double heatSource = 0;    // W, in all of the region
};

// Of the zones with a name, or of a pattern, as above: they turn, as seen by those outside.
struct Rotation
{
  std::string zone;
  double speed = 0; // revolutions per minute, right-handed about the axis; not 0
  std::array<double, 3> origin = { 0, 0, 0 }; // a point of the axis, m
  std::array<double, 3> axis = { 0, 0, 1 };   // of any length but 0
  // Boundaries in the zone that do not turn along: "none", or names and patterns, with spaces between them. "automatic":
  // those that are outside the zone too.
  std::string stillBoundaries = "automatic";
};

}
