// SPDX-License-Identifier: BSD-3-Clause
// Whether open edges are gaps, which healing closes, or the rim of a sheet.
#pragma once

#include <TopoDS_Shape.hxx>

namespace cartesian
{

// The widest gap between free edges of two faces that run beside each other, in millimetres; 0 if there is none.
double widestGap(const TopoDS_Shape& shape);

}
