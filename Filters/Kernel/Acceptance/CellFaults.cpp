// SPDX-License-Identifier: BSD-3-Clause
#include "Acceptance/CellFaults.h"

#include "Acceptance/Limits.h"
#include "Acceptance/Skewness.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cartesian
{

namespace
{

constexpr std::array<CellFaults::Kind, 4> Invalid{ CellFaults::BoundaryAngle,
  CellFaults::WronglyOriented, CellFaults::BoundarySkewness, CellFaults::InnerSkewness };

double cosine(const Vector& u, const Vector& v)
{
  const double lengths = std::sqrt(dot(u, u) * dot(v, v));
  return lengths > 0 ? dot(u, v) / lengths : 0;
}

bool isBoundarySkewed(const Polyhedron& cell, const CellShape& shape, std::size_t face)
{
  const FaceShape& f = shape.faces[face];
  const Vector normal = unit(f.area);
  const Vector towards = minus(f.centre, shape.centre);
  const double height = dot(towards, normal);
  const Vector aside = minus(towards, scaled(normal, height));
  return isSkewed(
    ringOf(cell, face), f.centre, aside, ShareOfHeight * std::abs(height), Limits::Skewness);
}

bool isInnerSkewed(
  const Polyhedron& cell, const CellShape& shape, std::size_t face, const Vector& between)
{
  const FaceShape& f = shape.faces[face];
  const Vector towards = minus(f.centre, shape.centre);
  const double across = dot(f.area, between);
  if (across == 0)
  {
    return true;
  }
  const Vector aside = minus(towards, scaled(between, dot(f.area, towards) / across));
  return isSkewed(
    ringOf(cell, face), f.centre, aside, ShareOfDistance * norm(between), Limits::Skewness);
}

double ownCosine(const CellShape& shape, std::size_t face)
{
  const FaceShape& f = shape.faces[face];
  return cosine(minus(f.centre, shape.centre), f.area);
}

bool isTooWide(double cosine, bool boundary)
{
  return boundary ? cosine <= Refused::BoundaryCosine : cosine < Refused::InnerCosine;
}

bool isUnequal(double volume, double other, double ratio)
{
  return std::min(volume, other) < ratio * std::max(volume, other);
}

// Whether the face is nearer to one of the centres than this part of its distances from both.
bool isOffCentre(
  const CellShape& shape, const FaceShape& face, const NeighbourCell& neighbour, double weight)
{
  const double near = std::abs(dot(minus(face.centre, shape.centre), face.area));
  const double far = std::abs(dot(minus(neighbour.centre, face.centre), face.area));
  return std::min(near, far) < weight * (near + far);
}

void addFaults(const Polyhedron& cell, const CellShape& shape, std::size_t f,
  const NeighbourCell& neighbour, CellFaults& faults)
{
  const FaceShape& face = shape.faces[f];
  const double own = ownCosine(shape, f);
  const auto note = [&](
                      CellFaults::Kind kind, bool holds) { faults.counts[kind] += holds ? 1 : 0; };
  bool wideAngle = false;
  bool skewed = false;
  if (cell.isBoundary[f])
  {
    wideAngle = isTooWide(own, true);
    skewed = isBoundarySkewed(cell, shape, f);
    note(CellFaults::BoundaryAngle, wideAngle);
  }
  else if (neighbour.volume > 0)
  {
    const Vector between = minus(neighbour.centre, shape.centre);
    const double others = cosine(minus(neighbour.centre, face.centre), face.area);
    wideAngle = isTooWide(std::min(own, others), false);
    skewed = isInnerSkewed(cell, shape, f, between);
    note(CellFaults::InnerAngle, wideAngle);
    note(CellFaults::WronglyOriented, std::min({ own, others, dot(between, face.area) }) <= 0);
    note(CellFaults::NonOrthogonal, cosine(between, face.area) < Refused::SlopeCosine);
    note(CellFaults::VolumeRatio, isUnequal(shape.volume, neighbour.volume, Limits::VolumeRatio));
    note(CellFaults::FaceWeight, isOffCentre(shape, face, neighbour, Limits::FaceWeight));
  }
  note(cell.isBoundary[f] ? CellFaults::BoundarySkewness : CellFaults::InnerSkewness, skewed);
  faults.area += wideAngle || skewed ? norm(face.area) : 0;
}

}

int CellFaults::weight() const
{
  static constexpr std::array<int, Kinds> weights{ 4, 2, 16, 2, 1, 8, 1, 1 };
  return std::inner_product(counts.begin(), counts.end(), weights.begin(), 0);
}

CellFaults& CellFaults::operator+=(const CellFaults& other)
{
  for (std::size_t i = 0; i < Kinds; ++i)
  {
    counts[i] += other.counts[i];
  }
  area += other.area;
  return *this;
}

CellFaults CellFaults::invalid() const
{
  CellFaults faults;
  for (const Kind kind : Invalid)
  {
    faults.counts[kind] = counts[kind];
  }
  return faults;
}

CellFaults faultsOf(const Polyhedron& cell, const CellShape& shape,
  const std::vector<NeighbourCell>& neighbours, const std::vector<std::uint8_t>& counted)
{
  CellFaults faults;
  for (std::size_t f = 0; f < cell.faces(); ++f)
  {
    if (counted.empty() || counted[f])
    {
      addFaults(cell, shape, f, neighbours[f], faults);
    }
  }
  return faults;
}

bool isRefused(
  const Polyhedron& cell, const CellShape& shape, std::size_t face, const NeighbourCell& neighbour)
{
  const FaceShape& f = shape.faces[face];
  const double own = ownCosine(shape, face);
  if (cell.isBoundary[face])
  {
    return isTooWide(own, true) || isBoundarySkewed(cell, shape, face);
  }
  if (!(neighbour.volume > 0))
  {
    return false;
  }
  const Vector between = minus(neighbour.centre, shape.centre);
  const double others = cosine(minus(neighbour.centre, f.centre), f.area);
  return isTooWide(std::min(own, others), false) ||
    std::min({ own, others, dot(between, f.area) }) <= 0 ||
    isInnerSkewed(cell, shape, face, between);
}

bool isUnbalanced(const CellShape& shape, std::size_t face, const NeighbourCell& neighbour)
{
  return neighbour.volume > 0 &&
    (isOffCentre(shape, shape.faces[face], neighbour, Balanced::FaceWeight) ||
      isUnequal(shape.volume, neighbour.volume, Balanced::VolumeRatio));
}

bool isTurnedOver(const CellShape& shape, std::size_t face, const NeighbourCell& neighbour)
{
  const FaceShape& f = shape.faces[face];
  const double own = dot(minus(f.centre, shape.centre), f.area);
  const double others = neighbour.volume > 0 ? dot(minus(neighbour.centre, f.centre), f.area) : own;
  return !(std::min(own, others) > 0);
}

bool Refusal::isRefused(std::size_t face)
{
  if (cartesian::isRefused(cell, shape, face, beyond[face]))
  {
    return true;
  }
  const bool boundary = cell.isBoundary[face] != 0;
  const double doubtful = boundary ? Doubtful::BoundaryCosine : Doubtful::InnerCosine;
  if (!(ownCosine(shape, face) <= doubtful))
  {
    return false;
  }
  if (projected.faces.empty())
  {
    projected.faces = shape.faces;
    projectCentres(cell, projected);
  }
  return isTooWide(ownCosine(projected, face), boundary);
}

CentreOffset centreOffsetOf(const Vector& centre, const Vector& faceCentre, const Vector& area)
{
  const Vector normal = unit(area);
  const Vector towards = minus(faceCentre, centre);
  const double height = dot(towards, normal);
  return { static_cast<float>(height),
    static_cast<float>(norm(minus(towards, scaled(normal, height)))) };
}

bool isSurelyAccepted(const CentreOffset& one, const CentreOffset& other)
{
  constexpr float MostSlope = 2; // the tangent of an angle below that of Doubtful::InnerCosine
  constexpr float MostOfDistance = 0.79F; // less than Limits::Skewness * ShareOfDistance
  static_assert(MostOfDistance < Limits::Skewness * ShareOfDistance);
  static_assert(
    1 > (1 + MostSlope * MostSlope) * Doubtful::InnerCosine * Doubtful::InnerCosine * 1.1);
  return one.aside <= MostSlope * one.height && other.aside <= MostSlope * other.height &&
    std::max(one.aside, other.aside) <= MostOfDistance * (one.height + other.height);
}

bool isSurelyGood(const CentreOffset& one, const CentreOffset& other)
{
  constexpr float MostSlope = 1.8F;
  constexpr float MostOfDistance = 0.38F;
  constexpr float LeastWeight = 0.14F;
  const float distance = one.height + other.height;
  return std::min(one.height, other.height) >= LeastWeight * distance &&
    std::max(one.aside, other.aside) <= MostOfDistance * distance &&
    one.aside <= MostSlope * one.height && other.aside <= MostSlope * other.height;
}

bool isPlain(const Polyhedron& cell, const CellShape& shape)
{
  for (std::size_t f = 0; f < cell.faces(); ++f)
  {
    if (cell.isBoundary[f] && ownCosine(shape, f) <= Doubtful::BoundaryCosine)
    {
      return false;
    }
  }
  return cell.faces() >= LeastFaces;
}

bool isAtFault(const Polyhedron& cell, const CellShape& shape, std::size_t face)
{
  const bool boundary = cell.isBoundary[face] != 0;
  return isTooWide(ownCosine(shape, face), boundary) ||
    (boundary && isBoundarySkewed(cell, shape, face));
}

bool isAnyAtFault(const Polyhedron& cell, const CellShape& shape)
{
  for (std::size_t f = 0; f < cell.faces(); ++f)
  {
    if (isAtFault(cell, shape, f))
    {
      return true;
    }
  }
  return false;
}

}
