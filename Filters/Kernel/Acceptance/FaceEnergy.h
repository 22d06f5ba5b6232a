// SPDX-License-Identifier: BSD-3-Clause
// What a solver suffers from a face: the energy that nodes at the wall minimise (NodeOptimisation.h), and how it
// changes with the face and with the cells on its two sides.
#pragma once

#include "Polyhedra/CellGeometry.h"

namespace cartesian
{

// The derivatives of an energy by what is measured of a face, and of a cell.
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
  // A sum over measures, each 1 where solvers begin to mind: skewness, non-orthogonality, interpolation weight,
  // ratio of volumes, angle of section 3.
  double limits = 0;

  // ... and what accuracy asks for: the square of the distance by which a flux misses its place.
  double all = 0;
};

// `ring`: for the face's reach, to which OpenFOAM's skewness is relative; `edge`: of the cells' boxes. The area points from the cell below to the one above. Adds to the gradients.
FaceEnergy energyOfInnerFace(const FaceGeometry& face, const Ring& ring, double edge,
  const CellGeometry& below, const CellGeometry& above, FaceGradient& ofFace, CellGradient& ofBelow,
  CellGradient& ofAbove);

FaceEnergy energyOfBoundaryFace(const FaceGeometry& face, const Ring& ring, double edge,
  const CellGeometry& cell, FaceGradient& ofFace, CellGradient& ofCell);

// Of a cell with this share of its box's volume; `byShare`: its derivative.
double energyOfShare(double share, double& byShare);

}
