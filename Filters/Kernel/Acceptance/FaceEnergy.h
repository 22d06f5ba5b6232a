// SPDX-License-Identifier: BSD-3-Clause
// The objective of a face, which nodes at the wall minimise (NodeOptimisation.h), and its derivatives by the face and
// by the cells on its two sides.
#pragma once

#include "Acceptance/Limits.h"
#include "Polyhedra/CellGeometry.h"

namespace cartesian
{

// The derivatives of an objective by the measures of a face and of a cell.
struct FaceGradient
{
  Vector centre{};
  Vector area{};
};

struct CellGradient
{
  Vector centre{};
  double volume = 0;
};

struct FaceEnergy
{
  // A sum over measures, each 1 at the preferred quality limits: skewness, non-orthogonality, interpolation weight,
  // ratio of volumes, angle of section 3.
  double limits = 0;

  // ... and the part for accuracy: the square of the distance by which a flux misses its place.
  double all = 0;
};

// Where derivatives are added to; `above` null: a boundary face.
struct Gradients
{
  FaceGradient* face;
  CellGradient* below;
  CellGradient* above;
};

// `ring`: for the face's reach, to which OpenFOAM's skewness is relative; `edge`: of the cells' boxes. The area points
// from the cell below to the one above. `gradients` null: the objective alone.
FaceEnergy energyOfInnerFace(const FaceGeometry& face, const Ring& ring, double edge,
  const CellGeometry& below, const CellGeometry& above, const Gradients* gradients);

FaceEnergy energyOfBoundaryFace(const FaceGeometry& face, const Ring& ring, double edge,
  const CellGeometry& cell, const Gradients* gradients);

// Of a cell with this share of its box's volume, and the derivative.
double energyOfShare(double share);
double derivativeOfShare(double share);

// FaceEnergy::limits of a face that has this skewness and no other flaw.
constexpr double limitsAtSkewness(double skewness)
{
  const double square = (skewness / Fair::Skewness) * (skewness / Fair::Skewness);
  return square * square;
}

}
