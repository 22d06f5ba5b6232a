// SPDX-License-Identifier: BSD-3-Clause
// Everything that a solver needs besides the mesh: initial and boundary conditions, properties, schemes and a script
// that runs it.
#pragma once

#include "Base/Range.h"
#include "OpenFoam/ConditionRows.h"
#include "OpenFoam/FoamBoundary.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cartesian
{

enum class Solver : std::uint8_t
{
  None = 0,
  Incompressible = 1, // simpleFoam
  ConjugateHeat = 2,  // chtMultiRegionSimpleFoam
  Transient = 3,      // pimpleFoam
};

enum class Turbulence : std::uint8_t
{
  KOmegaSST = 0,
  Laminar = 1,
};

// Of a transient flow, s.
struct FlowTimes
{
  double end = 1;
  double writeInterval = 0; // 0: a tenth of the end
  double step = 0;          // 0: by the Courant number
  double courant = 1;       // at most
};

// All in SI units.
struct SolverSetup
{
  static constexpr Range Speeds = moreThan(0); // turbulence and coefficients are in parts of it
  static constexpr Range Viscosities = moreThan(0);
  static constexpr Range Temperatures{ 0 };
  static constexpr Range AllIterations{ 1, 2147483647 };
  static constexpr Range Densities = moreThan(0);
  static constexpr Range EndTimes = moreThan(0);
  static constexpr Range WriteIntervals{ 0 };
  static constexpr Range TimeSteps{ 0 };
  static constexpr Range CourantNumbers = moreThan(0);

  Solver solver = Solver::None;
  Turbulence turbulence = Turbulence::KOmegaSST;
  double speed = 10;                    // at inlets, m/s
  double viscosity = 1.5e-5;            // kinematic, m2/s
  double density = 1.2;                 // kg/m3, for mass flows and pressures of one mesh
  double temperature = 350;             // of what flows in, K
  int iterations = 500;                 // of the flow
  int heatIterations = 20000;           // at most (HeatBalance.h)
  FlowTimes times = {};                 // of Transient
  bool overwrites = false;              // files that are there
  std::filesystem::path templates = {}; // a folder (CaseTemplates.h); empty: the library's own
  std::vector<Condition> conditions = {};
  std::vector<RegionMaterial> materials = {}; // of Conjugate Heat
  std::vector<Rotation> rotations = {};       // of the others
};

// A cellZone of a mesh.
struct ZoneOfMesh
{
  std::string name;
  std::vector<std::size_t> faces; // of each patch: how many are of cells of the zone
};

// A mesh of the case as it was written.
struct MeshOfCase
{
  std::string region; // empty: the case has one mesh
  bool isFluid = true;
  std::vector<FoamPatch> patches;     // each has a type
  std::vector<ZoneOfMesh> zones = {}; // of a whole mesh
};

// The flow around bodies in a box (Surface/FlowDomain.h).
struct FlowAround
{
  int direction = 0; // 0 to 5 for plus x, minus x, plus y, ...
  int up = 2;        // the axis of lift; where it is the flow's, the next one

  // Of the bodies along the flow, m, and of their shadow, m2 (FrontalArea.h); 0: not known, as of a decomposed case.
  double length = 0;
  double frontalArea = 0;
};

// The role of a patch in the flow.
enum class PatchRole : std::uint8_t
{
  Wall,
  Ground, // moves with the flow far away
  Inlet,
  Outlet,
  Slip,      // a side of the box around bodies
  Coupled,   // to another region
  Constraint // of its type: symmetry, cyclic, processor, ...
};

PatchRole roleOf(const FoamPatch& patch, const std::optional<FlowAround>& around);

// The names of the patches that have this role.
std::vector<std::string> namesOf(
  const MeshOfCase& mesh, PatchRole role, const std::optional<FlowAround>& around);

// Throws Error (BadParameter) where a number is out of range.
void requireInRange(const SolverSetup& setup);

// Throws Error (BadParameter) if the meshes do not suit the solver: no inlet, no outlet, several regions instead of
// one or vice versa, rows that do not fit (Conditions.h, Substances.h, Rotations.h).
void requireSuitable(const SolverSetup& setup, const std::vector<MeshOfCase>& meshes,
  const std::optional<FlowAround>& around);

// Writes 0, constant, system and Allrun into the folder of a case, or of a case in `pieces`, processor0/0 and so on.
// Existing files are kept, except those in system that only checkMesh needs (PolyMeshFiles.h), unless the set-up
// overwrites; returns the kept ones. Throws Error: BadParameter (requireInRange, requireSuitable, CaseTemplates), CannotWrite.
std::vector<std::filesystem::path> writeSolverCase(const std::filesystem::path& folder,
  const SolverSetup& setup, const std::vector<MeshOfCase>& meshes,
  const std::optional<FlowAround>& around, int pieces);

}
