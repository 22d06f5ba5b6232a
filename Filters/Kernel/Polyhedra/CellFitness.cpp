#include "Polyhedra/CellFitness.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cartesian
{

namespace
{

// A sixth of a degree less than section 3 allows: solvers do not agree on the centre of a bent face.
constexpr double LeastBoundaryCosine = 0.00290887798436196; // cos 89 5/6
constexpr double LeastInnerCosine = 0.261627710462944;      // cos 74 5/6

// Other centres turn no face further than from here to these.
constexpr double DoubtfulBoundaryCosine = 0.173648177666930; // cos 80
constexpr double DoubtfulInnerCosine = 0.422618261740699;    // cos 65

constexpr double LeastSlopeCosine = 0.342020143325669; // cos 70
constexpr double MostSkewness = 4;
constexpr double LeastVolumeRatio = 0.01;
constexpr double LeastFaceWeight = 0.05;

// OpenFOAM measures skewness over at least these parts of the distance of the centres, and of the
// height above a boundary face.
constexpr double ShareOfDistance = 0.2;
constexpr double ShareOfHeight = 0.4;

// Areas that differ by less are equal but for rounding.
constexpr double RoundingOfAreas = 1e-6;

double cosine(const Vector& u, const Vector& v)
{
  const double lengths = std::sqrt(dot(u, u) * dot(v, v));
  return lengths > 0 ? dot(u, v) / lengths : 0;
}

// `aside`: from where the line meets the face's plane to the face's centre; `share`: the least that it
// is measured over.
bool isFarAside(const Polyhedron& cell, const FaceShape& shape, std::size_t face,
  const Vector& aside, double share)
{
  const double distance = norm(aside);
  if (distance <= MostSkewness * share)
  {
    return false;
  }
  double reach = 0;
  for (std::size_t i = cell.start[face]; i < cell.start[face + 1]; ++i)
  {
    reach = std::max(reach, std::abs(dot(minus(cell.nodes[cell.corners[i]], shape.centre), aside)));
  }
  return distance * distance > MostSkewness * reach;
}

bool isBoundarySkewed(const Polyhedron& cell, const CellShape& shape, std::size_t face)
{
  const FaceShape& f = shape.faces[face];
  const Vector normal = unit(f.area);
  const Vector towards = minus(f.centre, shape.centre);
  const double height = dot(towards, normal);
  const Vector aside = minus(towards, scaled(normal, height));
  return isFarAside(cell, f, face, aside, ShareOfHeight * std::abs(height));
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
  return isFarAside(cell, f, face, aside, ShareOfDistance * norm(between));
}

double ownCosine(const CellShape& shape, std::size_t face)
{
  const FaceShape& f = shape.faces[face];
  return cosine(minus(f.centre, shape.centre), f.area);
}

void addFaults(const Polyhedron& cell, const CellShape& shape, std::size_t f, const Beyond& beyond,
  Fitness& fitness)
{
  const FaceShape& face = shape.faces[f];
  const double own = ownCosine(shape, f);
  const auto note = [&](
                      Fitness::Fault fault, bool holds) { fitness.faults[fault] += holds ? 1 : 0; };
  bool steep = false;
  bool skewed = false;
  if (cell.isBoundary[f])
  {
    steep = own <= LeastBoundaryCosine;
    skewed = isBoundarySkewed(cell, shape, f);
    note(Fitness::BoundaryAngle, steep);
  }
  else if (beyond.volume > 0)
  {
    const Vector between = minus(beyond.centre, shape.centre);
    const double others = cosine(minus(beyond.centre, face.centre), face.area);
    steep = std::min(own, others) < LeastInnerCosine;
    skewed = isInnerSkewed(cell, shape, f, between);
    note(Fitness::InnerAngle, steep);
    note(Fitness::Wrong, std::min({ own, others, dot(between, face.area) }) <= 0);
    note(Fitness::Steep, cosine(between, face.area) < LeastSlopeCosine);
    note(Fitness::Uneven,
      std::min(shape.volume, beyond.volume) <
        LeastVolumeRatio * std::max(shape.volume, beyond.volume));
    const double near = std::abs(dot(minus(face.centre, shape.centre), face.area));
    const double far = std::abs(dot(minus(beyond.centre, face.centre), face.area));
    note(Fitness::Lopsided, std::min(near, far) < LeastFaceWeight * (near + far));
  }
  note(cell.isBoundary[f] ? Fitness::BoundarySkewed : Fitness::InnerSkewed, skewed);
  fitness.area += steep || skewed ? norm(face.area) : 0;
}

}

int Fitness::count() const
{
  return std::accumulate(faults.begin(), faults.end(), 0);
}

int Fitness::weight() const
{
  static constexpr std::array<int, Faults> weights{ 4, 2, 16, 2, 1, 8, 1, 1 };
  return std::inner_product(faults.begin(), faults.end(), weights.begin(), 0);
}

Fitness& Fitness::operator+=(const Fitness& other)
{
  for (std::size_t i = 0; i < Faults; ++i)
  {
    faults[i] += other.faults[i];
  }
  area += other.area;
  return *this;
}

bool Fitness::isNoLessValidThan(const Fitness& other) const
{
  constexpr std::array<Fault, 4> refused{ BoundaryAngle, Wrong, BoundarySkewed, InnerSkewed };
  return std::all_of(refused.begin(), refused.end(),
    [&](Fault fault) { return faults[fault] <= other.faults[fault]; });
}

bool Fitness::isNoWorseThan(const Fitness& other) const
{
  return std::equal(faults.begin(), faults.end(), other.faults.begin(), std::less_equal<>());
}

bool Fitness::isBetterThan(const Fitness& other) const
{
  return isNoWorseThan(other) &&
    (count() < other.count() || area < other.area * (1 - RoundingOfAreas));
}

Fitness fitnessOf(const Polyhedron& cell, const CellShape& shape, const std::vector<Beyond>& beyond,
  const std::vector<std::uint8_t>& counts)
{
  Fitness fitness;
  for (std::size_t f = 0; f < cell.faces(); ++f)
  {
    if (counts.empty() || counts[f])
    {
      addFaults(cell, shape, f, beyond[f], fitness);
    }
  }
  return fitness;
}

bool isRefused(
  const Polyhedron& cell, const CellShape& shape, std::size_t face, const Beyond& beyond)
{
  Fitness fitness;
  addFaults(cell, shape, face, beyond, fitness);
  return fitness.faults[Fitness::InnerAngle] > 0 || !fitness.isNoLessValidThan({});
}

bool isDoubtful(const Polyhedron& cell, const CellShape& shape, std::size_t face)
{
  const bool boundary = cell.isBoundary[face] != 0;
  if (ownCosine(shape, face) > (boundary ? DoubtfulBoundaryCosine : DoubtfulInnerCosine))
  {
    return false;
  }
  CellShape projected;
  measureProjected(cell, projected);
  const double own = ownCosine(projected, face);
  return boundary ? own <= LeastBoundaryCosine : own < LeastInnerCosine;
}

FaceSight sightOf(const Vector& centre, const Vector& faceCentre, const Vector& area)
{
  const Vector normal = unit(area);
  const Vector towards = minus(faceCentre, centre);
  const double height = dot(towards, normal);
  return { static_cast<float>(height),
    static_cast<float>(norm(minus(towards, scaled(normal, height)))) };
}

bool isSurelyAccepted(const FaceSight& one, const FaceSight& other)
{
  constexpr float MostSlope = 2; // the tangent of an angle below that of DoubtfulInnerCosine
  constexpr float MostOfDistance = 0.79F; // less than MostSkewness * ShareOfDistance
  static_assert(MostOfDistance < MostSkewness * ShareOfDistance);
  static_assert(1 > (1 + MostSlope * MostSlope) * DoubtfulInnerCosine * DoubtfulInnerCosine * 1.1);
  return one.aside <= MostSlope * one.height && other.aside <= MostSlope * other.height &&
    std::max(one.aside, other.aside) <= MostOfDistance * (one.height + other.height);
}

bool isPlain(const Polyhedron& cell, const CellShape& shape)
{
  for (std::size_t f = 0; f < cell.faces(); ++f)
  {
    if (cell.isBoundary[f] && ownCosine(shape, f) <= DoubtfulBoundaryCosine)
    {
      return false;
    }
  }
  return cell.faces() >= LeastFaces;
}

bool isAtFault(const Polyhedron& cell, const CellShape& shape, std::size_t face)
{
  return cell.isBoundary[face]
    ? ownCosine(shape, face) <= LeastBoundaryCosine || isBoundarySkewed(cell, shape, face)
    : ownCosine(shape, face) < LeastInnerCosine;
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
