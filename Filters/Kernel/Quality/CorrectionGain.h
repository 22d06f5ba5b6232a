// SPDX-License-Identifier: BSD-3-Clause
// Whether a solver's Laplacian settles in a cell. Faces that are not normal to the line between their cells get a
// correction of the last iteration's gradients (Jasak, PhD thesis, Imperial College 1996, section 3.3.1.3; OpenFOAM's
// "Gauss linear corrected", over-relaxed). A change of the value in one cell changes its own gradient, and with it this
// correction: divided by what the coefficients of the matrix answer, that is the gain. Beyond 1 the change grows with each
// iteration, whatever other measures say: a small cell beside a large one needs little non-orthogonality for that.
#pragma once

#include "Quality/QualityMeasures.h"

namespace cartesian
{

// Of each cell, the larger size of two: where boundary values are fixed, and where their gradients are.
std::vector<double> correctionGains(const FaceList& faces, const Quality& quality);

}
