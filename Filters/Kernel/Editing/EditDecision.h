// SPDX-License-Identifier: BSD-3-Clause
// May this edit be made? Decided here, and nowhere else.
//
// The mesh must stay one: cells closed, faces not folded, no two faces alike. No more faces or cells than before may
// fail the limits of solvers. The wall may not move farther than ObjectiveSpec::mostMoved, sharp edges and corners stay
// except for a charge. What remains is a matter of cost (WallObjective.h): the gain has to be large enough.
#pragma once

#include "Editing/MeshEditor.h"
#include "Editing/WallObjective.h"

namespace cartesian
{

constexpr double NoGain = -std::numeric_limits<double>::infinity();

// Edits that change more faces in all are not tried, nor are cells of more.
constexpr std::size_t MostFacesChanged = 512;

struct EditRules
{
  ObjectiveSpec objective;
  bool mayChangeWalls = true; // false: what is on the surface stays (Exact Fit)
  double mostMerged = 2;      // of its box: of the smaller of two cells that merge; 0: none do
  bool mayCut = true;         // cells, and join walls of failing ones at any angle
  bool mayTrade = true;       // what solvers refuse for what only fails (Refusals.h)
};

// What edits since the last commit have to gain (gainOf), or more.
struct NeededGain
{
  double gain = NoGain;
  double box = 1; // the volume of a box there
};

// Measures what edits left dirty, and tests it. False: the mesh would not be valid, or does not gain what is needed.
// Nothing is dirty afterwards.
bool updateAndValidate(
  MeshEditor& mesh, const ObjectiveSpec& spec, const NeededGain& needed = NeededGain());

// The same without costs: those are not valid afterwards. What is dirty stays listed, to be looked at.
bool updateShapes(MeshEditor& mesh);

// Whether the cells that changed since the mark are closed in full: updateAndValidate() only counts.
bool areAllClosed(MeshEditor& mesh, const MeshEditor::Mark& mark);

// By how much the objective falls with the edits since the last commit; `box`: the volume of a box there.
double gainOf(const MeshEditor& mesh, const ObjectiveSpec& spec, double box);

// Whether node u may become v, at `at`; `charge` for what a sharp edge loses; see NodeKind.
bool mayCollapse(const MeshView& mesh, const EditRules& rules, std::uint32_t u, std::uint32_t v,
  const Vector& at, double& charge);

// Whether a node may move there: on its surface or edge, not too far from where that was known.
bool mayMove(const MeshView& mesh, const EditRules& rules, std::uint32_t n, const Vector& to);

// Whether two faces may become one; `charge` for a sharp edge between them.
bool mayJoin(
  const MeshView& mesh, const EditRules& rules, std::uint32_t f, std::uint32_t g, double& charge);

// Whether two cells may become one, as far as their size goes.
bool mayMerge(const MeshView& mesh, const EditRules& rules, std::uint32_t a, std::uint32_t b);

// The gain of edits since the mark, once they are valid, or NoGain: not more than `least`.
double decide(const MeshEditor& mesh, const EditRules& rules, const MeshEditor::Mark& mark,
  double box, double least);

}
