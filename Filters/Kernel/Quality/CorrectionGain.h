// SPDX-License-Identifier: BSD-3-Clause
// Whether a solver's non-orthogonal correction converges in a cell. Faces that are not normal to the line between their
// cells get a correction of the last iteration's gradients (Jasak, PhD thesis, Imperial College 1996, section 3.3.1.3;
// OpenFOAM's "Gauss linear corrected", over-relaxed). A change of the value in one cell changes its own gradient, and
// with it this correction: divided by the response of the matrix coefficients, that is the gain. Above 1 the change
// grows with each iteration, whatever other measures say: a small cell beside a large one needs little
// non-orthogonality for that. Coefficients of faces are those of a pressure, about in proportion to the cells' volume
// by area. It considers each cell alone: flows have diverged where no cell has a large gain.
#pragma once

#include "Quality/QualityMeasures.h"

namespace cartesian
{

// Of each cell, 0 or more, without unit: the larger of two, where boundary values are fixed and where their gradients are.
// `faces`, `quality`: of all cells, from listFaces() and measureQuality().
std::vector<double> correctionGains(const FaceList& faces, const Quality& quality);

}
