// SPDX-License-Identifier: BSD-3-Clause
#include "Acceptance/FaceEnergy.h"

#include "Acceptance/Limits.h"
#include "Acceptance/Skewness.h"

namespace cartesian
{

namespace
{

// Weights of what accuracy asks for. A gradient at a wall has nothing beyond to balance it.
constexpr double WeightOfBoundary = 80;
constexpr double WeightOfInner = 1;
constexpr double WeightOfSlope = 0.3;

// Beyond these parts of the distance of the centres (of the box's edge at boundaries) a measure grows no steeper: a cell
// turned inside out is to find its way back.
constexpr double LeastAcross = 0.15;
constexpr double LeastHeight = 0.02;
constexpr double LeastRatio = 1e-3;

// ... but by this much for each distance (edge) beyond: the worse it is, the more it costs.
constexpr double Beyond = 1e4;

double square(double x)
{
  return x * x;
}

double fourth(double x)
{
  return square(square(x));
}

void add(Vector& sum, const Vector& v, double factor)
{
  sum[0] += factor * v[0];
  sum[1] += factor * v[1];
  sum[2] += factor * v[2];
}

// The distance `aside` by which a face's centre is off: skewness, and the error of a flux. Returns the factor of
// `aside` in the derivative.
double energyOfOffset(const FaceGeometry& face, const Ring& ring, const Vector& aside, double least,
  double weight, FaceEnergy& energy)
{
  const double offset = dot(aside, aside);
  const double fair =
    fourth(Fair::Skewness * skewnessOf(ring, face.centre, aside, least).reachAlone());
  const double skew = offset * offset / std::max(fair, Tiny);
  energy.limits += skew;
  energy.all += skew + weight * offset;
  return 4 * offset / std::max(fair, Tiny) + 2 * weight;
}

void addRatio(const CellGeometry& below, const CellGeometry& above, FaceEnergy& energy,
  CellGradient& ofBelow, CellGradient& ofAbove)
{
  const bool isBelowSmaller = below.volume < above.volume;
  const double large = std::max({ below.volume, above.volume, Tiny });
  const double small = std::max(std::min(below.volume, above.volume), LeastRatio * large);
  const double ratio = square(Fair::VolumeRatio * large / small);
  energy.limits += ratio;
  energy.all += ratio;
  (isBelowSmaller ? ofBelow : ofAbove).volume -= 2 * ratio / small;
  (isBelowSmaller ? ofAbove : ofBelow).volume += 2 * ratio / large;
}

// A face seen from a cell on one of its sides: the angle of section 3. `height`: along the normal. Returns the derivative by
// the height; adds that by the way from the centre of the cell to the face's.
double addAngle(const Vector& way, double height, FaceEnergy& energy, Vector& byWay)
{
  const double length = std::max(dot(way, way), Tiny);
  const double angle = square(square(Fair::InnerCosine) * length / square(height));
  energy.limits += angle;
  energy.all += angle;
  add(byWay, way, 4 * angle / length);
  return -4 * angle / height;
}

// A height that is less than `least`, in units of `unit`; returns the derivative.
double addLack(double height, double least, double unit, FaceEnergy& energy)
{
  const double lack = Beyond * std::max(0.0, least - height) / unit;
  energy.limits += lack;
  energy.all += lack;
  return height < least ? -Beyond / unit : 0;
}

void addAreaGradient(
  const Vector& byNormal, const Vector& normal, double size, FaceGradient& ofFace)
{
  add(ofFace.area, byNormal, 1 / size);
  add(ofFace.area, normal, -dot(byNormal, normal) / size);
}

// Of an inner face, by the lines between centres and their parts along the normal.
struct InnerDerivatives
{
  Vector between{};
  Vector towards{};
  Vector away{};
  double near;
  double far;
  double across;
};

// Takes those along the normal to those by the lines; returns that by the normal.
Vector takeAlong(InnerDerivatives& by, const Vector& normal, const Vector& towards,
  const Vector& away, const Vector& between)
{
  Vector byNormal{};
  add(by.towards, normal, by.near);
  add(byNormal, towards, by.near);
  add(by.away, normal, by.far);
  add(byNormal, away, by.far);
  add(by.between, normal, by.across);
  add(byNormal, between, by.across);
  return byNormal;
}

}

FaceEnergy energyOfInnerFace(const FaceGeometry& face, const Ring& ring, double edge,
  const CellGeometry& below, const CellGeometry& above, FaceGradient& ofFace, CellGradient& ofBelow,
  CellGradient& ofAbove)
{
  FaceEnergy energy;
  const double size = std::max(norm(face.area), Tiny);
  const Vector normal = scaled(face.area, 1 / size);
  const Vector between = minus(above.centre, below.centre);
  const Vector towards = minus(face.centre, below.centre);
  const Vector away = minus(above.centre, face.centre);
  const double distance = std::max(norm(between), Tiny);
  const double across = std::max(dot(between, normal), LeastAcross * distance);
  const double near = std::max(dot(towards, normal), LeastHeight * distance);
  const double far = std::max(dot(away, normal), LeastHeight * distance);
  InnerDerivatives by;
  by.near = addLack(dot(towards, normal), LeastHeight * distance, distance, energy);
  by.far = addLack(dot(away, normal), LeastHeight * distance, distance, energy);
  by.across = addLack(dot(between, normal), LeastAcross * distance, distance, energy);

  const double slope = std::max(0.0, square(distance / across) - 1);
  const double weightOfSlope = WeightOfSlope * size / square(edge);
  energy.limits += square(slope / Fair::Slope);
  energy.all += square(slope / Fair::Slope) + weightOfSlope * slope;
  const double bySlope = 2 * slope / square(Fair::Slope) + weightOfSlope;
  add(by.between, between, 2 * bySlope / square(across));
  by.across -= 2 * bySlope * square(distance / across) / across;

  const double nearer = std::min(near, far);
  const double weight = fourth(Fair::FaceWeight * across / nearer);
  energy.limits += weight;
  energy.all += weight;
  (near < far ? by.near : by.far) -= 4 * weight / nearer;
  by.across += 4 * weight / across;

  addRatio(below, above, energy, ofBelow, ofAbove);

  const double part = near / across;
  Vector aside = towards;
  add(aside, between, -part);
  const double factor = energyOfOffset(
    face, ring, aside, ShareOfDistance * distance, WeightOfInner * size / fourth(edge), energy);
  add(by.towards, aside, factor);
  add(by.between, aside, -factor * part);
  const double byPart = -factor * dot(aside, between);
  by.near += byPart / across;
  by.across -= byPart * part / across;

  if (norm(towards) * far > norm(away) * near)
  {
    by.near += addAngle(towards, near, energy, by.towards);
  }
  else
  {
    by.far += addAngle(away, far, energy, by.away);
  }

  const Vector byNormal = takeAlong(by, normal, towards, away, between);
  add(ofFace.centre, by.towards, 1);
  add(ofFace.centre, by.away, -1);
  add(ofBelow.centre, plus(by.towards, by.between), -1);
  add(ofAbove.centre, plus(by.away, by.between), 1);
  addAreaGradient(byNormal, normal, size, ofFace);
  return energy;
}

FaceEnergy energyOfBoundaryFace(const FaceGeometry& face, const Ring& ring, double edge,
  const CellGeometry& cell, FaceGradient& ofFace, CellGradient& ofCell)
{
  FaceEnergy energy;
  const double size = std::max(norm(face.area), Tiny);
  const Vector normal = scaled(face.area, 1 / size);
  const Vector towards = minus(face.centre, cell.centre);
  const double along = dot(towards, normal);
  const double height = std::max(along, LeastHeight * edge);
  Vector aside = towards;
  add(aside, normal, -along);
  double byAside = energyOfOffset(
    face, ring, aside, ShareOfHeight * height, WeightOfBoundary * size / fourth(edge), energy);

  const double slope = dot(aside, aside) / square(height);
  energy.limits += square(slope / Fair::BoundarySlope);
  energy.all += square(slope / Fair::BoundarySlope);
  const double bySlope = 2 * slope / square(Fair::BoundarySlope);
  byAside += 2 * bySlope / square(height);
  const double byHeight =
    addLack(along, LeastHeight * edge, edge, energy) - 2 * bySlope * slope / height;

  Vector byTowards = scaled(aside, byAside);
  add(byTowards, normal, byHeight);
  Vector byNormal = scaled(aside, -byAside * along);
  add(byNormal, towards, byHeight);
  add(ofFace.centre, byTowards, 1);
  add(ofCell.centre, byTowards, -1);
  addAreaGradient(byNormal, normal, size, ofFace);
  return energy;
}

double energyOfShare(double share, double& byShare)
{
  byShare = 0;
  if (share >= Fair::LargeShare)
  {
    return 0;
  }
  const double least = std::max(share, LeastRatio);
  const double energy = square(Fair::Share / least);
  const double lack = std::max(0.0, LeastRatio - share);
  byShare = -2 * energy / least - (lack > 0 ? Beyond : 0);
  return energy + Beyond * lack;
}

}
