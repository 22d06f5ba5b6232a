// SPDX-License-Identifier: BSD-3-Clause
#include "CadMeasures.h"

#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>

#include <cmath>

namespace cartesian
{

namespace
{

// Relative, of a face: integration is refined until a step changes less. Without a tolerance, Open CASCADE integrates with few
// points, and is wrong by percents on free-form faces.
constexpr double Tolerance = 1e-7;

// Relative: what is shown as exact is so to this. Open CASCADE's own estimates of the error cannot be relied on: over a kink
// one is 1e-16 where the volume is wrong by 3 %.
constexpr double LargestError = 1e-6;

gp_Pnt middleOf(const TopoDS_Shape& shape)
{
  Bnd_Box box;
  BRepBndLib::Add(shape, box, Standard_False);
  return box.IsVoid() ? gp::Origin() : gp_Pnt((box.CornerMin().XYZ() + box.CornerMax().XYZ()) / 2);
}

}

double areaOf(const TopoDS_Shape& shape)
{
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties, Tolerance);
  return properties.Mass();
}

CadVolume volumeOf(const TopoDS_Shape& solid)
{
  const gp_Pnt middle = middleOf(solid); // far away, faces would cancel out
  GProp_GProps gauss(middle);
  BRepGProp::VolumeProperties(solid, gauss, Tolerance);
  GProp_GProps kronrod(middle);
  BRepGProp::VolumePropertiesGK(solid, kronrod, Tolerance);
  const double difference = std::abs(gauss.Mass() - kronrod.Mass());
  return { kronrod.Mass(), difference <= LargestError * std::abs(kronrod.Mass()) };
}

}
