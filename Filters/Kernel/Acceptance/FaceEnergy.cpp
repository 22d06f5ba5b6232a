// SPDX-License-Identifier: BSD-3-Clause
#include "Acceptance/FaceEnergy.h"

#include "Acceptance/Limits.h"
#include "Acceptance/Skewness.h"

namespace cartesian
{

namespace
{

// Weights of the part for accuracy. A gradient at a wall has nothing beyond to balance it.
constexpr double WeightOfBoundary = 80;
constexpr double WeightOfInner = 1;
constexpr double WeightOfSlope = 0.3;

// Beyond these parts of the distance of the centres (of the box's edge at boundaries) a measure grows no steeper, so
// that an inverted cell can recover.
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

// Of a measure, and of the additional part for accuracy.
void add(FaceEnergy& energy, double measure, double more = 0)
{
  energy.limits += measure;
  energy.all += measure + more;
}

// The distance `aside` by which a face's centre is off: skewness, and the error of a flux.
struct Offset
{
  double square;
  double fair; // fourth power of where it costs 1
  double weight;

  double skew() const { return square * square / std::max(fair, Tiny); }

  // The factor of `aside` in the derivative.
  double derivative() const { return 4 * square / std::max(fair, Tiny) + 2 * weight; }
};

Offset offsetOf(
  const FaceGeometry& face, const Ring& ring, const Vector& aside, double least, double weight)
{
  return { dot(aside, aside),
    fourth(Fair::Skewness * skewnessOf(ring, face.centre, aside, least).reachAlone()), weight };
}

struct Ratio
{
  Ratio(const CellGeometry& below, const CellGeometry& above)
    : isBelowSmaller(below.volume < above.volume)
    , large(std::max({ below.volume, above.volume, Tiny }))
    , small(std::max(std::min(below.volume, above.volume), LeastRatio * large))
    , energy(square(Fair::VolumeRatio * large / small))
  {
  }

  void differentiate(const Gradients& gradients) const
  {
    (isBelowSmaller ? gradients.below : gradients.above)->volume -= 2 * energy / small;
    (isBelowSmaller ? gradients.above : gradients.below)->volume += 2 * energy / large;
  }

  bool isBelowSmaller;
  double large;
  double small;
  double energy;
};

// A face seen from a cell on one of its sides: the angle of section 3. `height`: along the normal.
double energyOfAngle(const Vector& way, double height)
{
  const double length = std::max(dot(way, way), Tiny);
  return square(square(Fair::InnerCosine) * length / square(height));
}

// Adds its derivative by the way from the centre of the cell to the face's; returns that by the height.
double differentiateAngle(const Vector& way, double height, Vector& byWay)
{
  const double angle = energyOfAngle(way, height);
  add(byWay, way, 4 * angle / std::max(dot(way, way), Tiny));
  return -4 * angle / height;
}

// Of a height that is less than `least`, in units of `unit`.
double energyOfLack(double height, double least, double unit)
{
  return Beyond * std::max(0.0, least - height) / unit;
}

double derivativeOfLack(double height, double least, double unit)
{
  return height < least ? -Beyond / unit : 0;
}

void addAreaGradient(
  const Vector& byNormal, const Vector& normal, double size, FaceGradient& ofFace)
{
  add(ofFace.area, byNormal, 1 / size);
  add(ofFace.area, normal, -dot(byNormal, normal) / size);
}

// An inner face between its cells: the lines between centres, and their parts along the normal.
struct Between
{
  Between(const FaceGeometry& face, const CellGeometry& below, const CellGeometry& above)
    : size(std::max(norm(face.area), Tiny))
    , normal(scaled(face.area, 1 / size))
    , between(minus(above.centre, below.centre))
    , towards(minus(face.centre, below.centre))
    , away(minus(above.centre, face.centre))
    , distance(std::max(norm(between), Tiny))
    , alongBetween(dot(between, normal))
    , alongTowards(dot(towards, normal))
    , alongAway(dot(away, normal))
    , across(std::max(alongBetween, LeastAcross * distance))
    , near(std::max(alongTowards, LeastHeight * distance))
    , far(std::max(alongAway, LeastHeight * distance))
    , nearer(std::min(near, far))
    , part(near / across)
    , aside(towards)
    , slope(std::max(0.0, square(distance / across) - 1))
    , weight(fourth(Fair::FaceWeight * across / nearer))
  {
    add(aside, between, -part);
  }

  bool isAngleBelow() const { return norm(towards) * far > norm(away) * near; }

  double size;
  Vector normal;
  Vector between;
  Vector towards;
  Vector away;
  double distance;
  double alongBetween;
  double alongTowards;
  double alongAway;
  double across;
  double near;
  double far;
  double nearer;
  double part;
  Vector aside;
  double slope;
  double weight;
};

// By those lines.
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
Vector takeAlong(InnerDerivatives& by, const Between& face)
{
  Vector byNormal{};
  add(by.towards, face.normal, by.near);
  add(byNormal, face.towards, by.near);
  add(by.away, face.normal, by.far);
  add(byNormal, face.away, by.far);
  add(by.between, face.normal, by.across);
  add(byNormal, face.between, by.across);
  return byNormal;
}

void differentiate(
  const Between& face, const Offset& offset, double weightOfSlope, const Gradients& gradients)
{
  const double distance = face.distance;
  const double across = face.across;
  InnerDerivatives by;
  by.near = derivativeOfLack(face.alongTowards, LeastHeight * distance, distance);
  by.far = derivativeOfLack(face.alongAway, LeastHeight * distance, distance);
  by.across = derivativeOfLack(face.alongBetween, LeastAcross * distance, distance);

  const double bySlope = 2 * face.slope / square(Fair::Slope) + weightOfSlope;
  add(by.between, face.between, 2 * bySlope / square(across));
  by.across -= 2 * bySlope * square(distance / across) / across;

  (face.near < face.far ? by.near : by.far) -= 4 * face.weight / face.nearer;
  by.across += 4 * face.weight / across;

  const double factor = offset.derivative();
  add(by.towards, face.aside, factor);
  add(by.between, face.aside, -factor * face.part);
  const double byPart = -factor * dot(face.aside, face.between);
  by.near += byPart / across;
  by.across -= byPart * face.part / across;

  if (face.isAngleBelow())
  {
    by.near += differentiateAngle(face.towards, face.near, by.towards);
  }
  else
  {
    by.far += differentiateAngle(face.away, face.far, by.away);
  }

  const Vector byNormal = takeAlong(by, face);
  add(gradients.face->centre, by.towards, 1);
  add(gradients.face->centre, by.away, -1);
  add(gradients.below->centre, plus(by.towards, by.between), -1);
  add(gradients.above->centre, plus(by.away, by.between), 1);
  addAreaGradient(byNormal, face.normal, face.size, *gradients.face);
}

// A boundary face seen from its cell.
struct Beside
{
  Beside(const FaceGeometry& face, const CellGeometry& cell, double edge)
    : size(std::max(norm(face.area), Tiny))
    , normal(scaled(face.area, 1 / size))
    , towards(minus(face.centre, cell.centre))
    , along(dot(towards, normal))
    , height(std::max(along, LeastHeight * edge))
    , aside(towards)
  {
    add(aside, normal, -along);
    slope = dot(aside, aside) / square(height);
  }

  double size;
  Vector normal;
  Vector towards;
  double along;
  double height;
  Vector aside;
  double slope;
};

void differentiate(
  const Beside& face, const Offset& offset, double edge, const Gradients& gradients)
{
  const double bySlope = 2 * face.slope / square(Fair::BoundarySlope);
  const double byAside = offset.derivative() + 2 * bySlope / square(face.height);
  const double byHeight =
    derivativeOfLack(face.along, LeastHeight * edge, edge) - 2 * bySlope * face.slope / face.height;
  Vector byTowards = scaled(face.aside, byAside);
  add(byTowards, face.normal, byHeight);
  Vector byNormal = scaled(face.aside, -byAside * face.along);
  add(byNormal, face.towards, byHeight);
  add(gradients.face->centre, byTowards, 1);
  add(gradients.below->centre, byTowards, -1);
  addAreaGradient(byNormal, face.normal, face.size, *gradients.face);
}

}

FaceEnergy energyOfInnerFace(const FaceGeometry& face, const Ring& ring, double edge,
  const CellGeometry& below, const CellGeometry& above, const Gradients* gradients)
{
  FaceEnergy energy;
  const Between between(face, below, above);
  const double distance = between.distance;
  const double weightOfSlope = WeightOfSlope * between.size / square(edge);
  add(energy, energyOfLack(between.alongTowards, LeastHeight * distance, distance));
  add(energy, energyOfLack(between.alongAway, LeastHeight * distance, distance));
  add(energy, energyOfLack(between.alongBetween, LeastAcross * distance, distance));
  add(energy, square(between.slope / Fair::Slope), weightOfSlope * between.slope);
  add(energy, between.weight);
  const Ratio ratio(below, above);
  add(energy, ratio.energy);
  const Offset offset = offsetOf(face, ring, between.aside, ShareOfDistance * distance,
    WeightOfInner * between.size / fourth(edge));
  add(energy, offset.skew(), offset.weight * offset.square);
  add(energy,
    between.isAngleBelow() ? energyOfAngle(between.towards, between.near)
                           : energyOfAngle(between.away, between.far));
  if (gradients)
  {
    ratio.differentiate(*gradients);
    differentiate(between, offset, weightOfSlope, *gradients);
  }
  return energy;
}

FaceEnergy energyOfBoundaryFace(const FaceGeometry& face, const Ring& ring, double edge,
  const CellGeometry& cell, const Gradients* gradients)
{
  FaceEnergy energy;
  const Beside beside(face, cell, edge);
  const Offset offset = offsetOf(face, ring, beside.aside, ShareOfHeight * beside.height,
    WeightOfBoundary * beside.size / fourth(edge));
  add(energy, offset.skew(), offset.weight * offset.square);
  add(energy, square(beside.slope / Fair::BoundarySlope));
  add(energy, energyOfLack(beside.along, LeastHeight * edge, edge));
  if (gradients)
  {
    differentiate(beside, offset, edge, *gradients);
  }
  return energy;
}

double energyOfShare(double share)
{
  return share >= Fair::LargeShare ? 0
                                   : square(Fair::Share / std::max(share, LeastRatio)) +
      Beyond * std::max(0.0, LeastRatio - share);
}

double derivativeOfShare(double share)
{
  if (share >= Fair::LargeShare)
  {
    return 0;
  }
  const double least = std::max(share, LeastRatio);
  return -2 * square(Fair::Share / least) / least - (share < LeastRatio ? Beyond : 0);
}

}
