// SPDX-License-Identifier: BSD-3-Clause
// Whether an edit of the mesh is accepted: one function compares the quality of the cells before and after (Verdict.h).
// What differs between steps of shaping has a name, and stands in one table.
#pragma once

#include "Acceptance/FaceEnergy.h"
#include "Acceptance/Verdict.h"

#include <algorithm>

namespace cartesian
{

// How many faces may fail afterwards.
enum class MayRefuse
{
  NoFace,
  FewerOrNone, // than before
  AsMany       // as before
};

struct Acceptance
{
  MayRefuse refused;
  double leastGain = -Never;  // costs have to fall by more; a cost of Never is never accepted
  double mostWorst = Never;   // nothing may cost more than this, unless something did:
  bool worstFalls = false;    // ... then less than that
  std::size_t leastFaces = 0; // of a cell
  double leastVolume = 0;     // as a part of what it was; 0: volumes are not compared
  double mostVolume = 0;
};

// From here on a face strains solvers: skewness 2.4.
constexpr double StrainedCost = 5;

// Sums of costs have to change by more than rounding.
constexpr double LeastGain = 1e-6;

// What each step of shaping accepts.
struct Accepted
{
  static constexpr double Failed = 1e3; // a cost of what fails (CellCost.h)
  static constexpr double Any = -Never; // gain

  // Merged or simplified cells: small ones, poor ones (CellMerging).
  static constexpr Acceptance SmallMerge{ MayRefuse::FewerOrNone, LeastGain, Failed, true };
  static constexpr Acceptance PoorMerge{ MayRefuse::FewerOrNone, 0.3, Failed, true };

  // Joined faces: of a union (CellUnion), between regions (InterfaceMending), where layers are requested (WallJoining).
  static constexpr Acceptance Join{ MayRefuse::AsMany, Any, Never, false, LeastFaces, 0.8, 1.25 };
  static constexpr Acceptance Mend{ MayRefuse::AsMany, 0.3, Never, false, LeastFaces, 0.8, 1.25 };
  static constexpr Acceptance Wall{ MayRefuse::AsMany, Any, Never, false, LeastFaces, 0.8, 1.2 };

  // Cells next to a removed one: next to a tip (TipRemoval), or ones that must not change (RefusedCells).
  static constexpr Acceptance TipRemoval{ MayRefuse::NoFace, Any, StrainedCost };
  static constexpr Acceptance Removal{ MayRefuse::NoFace };

  // Cells next to one that goes to another region, and that cell itself (CellCession).
  static constexpr Acceptance LeftBehind{ MayRefuse::AsMany };
  static constexpr Acceptance Ceded{ MayRefuse::NoFace };
};

// ... of the parts of a cut. Of cuts that are accepted the best has the smallest weight of faults (CutSearch.h).
struct AcceptedCut
{
  // The smallest part's volume is more than this part of the cell's.
  static constexpr double LeastOfSplit = 1e-3;
  static constexpr double LeastOfInvalid = 1e-6;

  static constexpr double AspectOfInvalid = Refused::AspectRatio;
  static constexpr double MostGiven = 0.5; // of its box: all parts but the largest
};

// An edit of faces, or a node that moves, where the worst are repaired (Optimisation/WorstFaces.h): the objective
// (FaceEnergy.h) of everything that it changes falls by a fraction of itself. Requirements on faces hold only for
// those that met them before.
struct AcceptedEdit
{
  static constexpr double LeastGain = 0.01;

  // The cost of volume that an edit adds to the mesh or removes: for a thousandth of the box, that of a face that is
  // just fair.
  static constexpr double CostOfVolume = 1000;

  static constexpr double LeastStar = 0.05; // a face's smallest triangle, by the mean one
  static constexpr double LeastArea = 1e-4; // by the square of the box's edge

  // No face of the wall turns by more than 15 degrees, nor comes farther from where the middle of one that it replaces
  // was, as a part of the box's edge.
  static constexpr double WallCosine = 0.966;
  static constexpr double FarthestFromWall = 0.02;
};

// FaceEnergy::limits from which on a face is repaired: a skewness of 1.8; and from which on all nodes of its cells are
// moved.
struct PoorFace
{
  static constexpr double Limits = 1.5;
  static constexpr double LimitsOfFailing = limitsAtSkewness(cartesian::Limits::Skewness);
};

inline double acceptedBelow(double objective)
{
  return (1 - AcceptedEdit::LeastGain) * objective;
}

// By how much costs fall.
inline double gain(const Verdict& before, const Verdict& after)
{
  return before.cost - after.cost - after.costBeyond;
}

inline bool keepsVolume(const Acceptance& acceptance, double before, double after)
{
  return acceptance.leastVolume == 0 ||
    (after >= acceptance.leastVolume * before && after <= acceptance.mostVolume * before);
}

// Required of each cell if an edit changes several.
inline bool keepsShape(const Acceptance& acceptance, const Verdict& before, const Verdict& after)
{
  return after.faces >= acceptance.leastFaces &&
    keepsVolume(acceptance, before.volume, after.volume);
}

inline bool accepts(const Acceptance& acceptance, const Verdict& before, const Verdict& after)
{
  const double most = std::max(before.worst, acceptance.mostWorst);
  const bool mayRefuse = after.refused == 0 ||
    (acceptance.refused == MayRefuse::FewerOrNone && after.refused < before.refused) ||
    (acceptance.refused == MayRefuse::AsMany && after.refused <= before.refused);
  return mayRefuse && gain(before, after) > acceptance.leastGain &&
    (acceptance.worstFalls ? after.worst < most : after.worst <= most) &&
    keepsShape(acceptance, before, after);
}

}
