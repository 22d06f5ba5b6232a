// SPDX-License-Identifier: BSD-3-Clause
// Volume and area of exact shapes, in millimetres.
#pragma once

#include <TopoDS_Shape.hxx>

namespace cartesian
{

double areaOf(const TopoDS_Shape& shape);

struct CadVolume
{
  double value = 0;       // negative of a solid that is inside out
  bool isCertain = false; // two ways to integrate agree
};

CadVolume volumeOf(const TopoDS_Shape& solid);

}
