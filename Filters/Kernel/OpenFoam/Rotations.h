// SPDX-License-Identifier: BSD-3-Clause
// Zones that turn, by a user's rows (ConditionRows.h): constant/MRFProperties. The walls in them turn along unless they are
// still; solvers give those in the zone their velocity.
#pragma once

#include "OpenFoam/CaseFiles.h"

namespace cartesian
{

struct TurningZone
{
  std::string name;
  Rotation row;
  std::vector<std::string> turning; // names of walls
  std::vector<std::string> outside; // those of them that are outside the zone too
  std::vector<std::string> still;   // patches in the zone that do not turn
};

std::vector<TurningZone> turningZones(
  const SolverSetup& setup, const MeshOfCase& mesh, const std::optional<FlowAround>& around);

// Entries for the velocity of a wall that turns along and is outside the zone too, as a shaft.
std::optional<std::string> velocityOutside(
  const std::vector<TurningZone>& zones, const FoamPatch& patch);

// An old file is replaced by one without zones, if there are none, or kept, as any other.
void writeRotations(const std::vector<TurningZone>& zones, CaseFiles& files);

// What turns and what does not, in words; empty: nothing turns.
std::string rotationsInWords(const SolverSetup& setup, const std::vector<MeshOfCase>& meshes,
  const std::optional<FlowAround>& around);

// Throws Error (BadParameter), which names the zone: a row for no zone, two for one, a boundary that does not exist, a speed or
// an axis of 0, or heat to solve for.
void requireSuitableRotations(const SolverSetup& setup, const std::vector<MeshOfCase>& meshes);

}
