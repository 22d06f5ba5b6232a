// SPDX-License-Identifier: BSD-3-Clause
#include "Acceptance/CellCost.h"

#include "Acceptance/Limits.h"
#include "Acceptance/Skewness.h"
#include "Polyhedra/CellGeometry.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cartesian
{

namespace
{

// checkMesh's determinant of the cell's inner faces: 1 for a cube, next to nothing where there is a direction
// that hardly any of them faces. No more than what a cell that is gone costs: where the domain is one cell
// thin, all have that.
constexpr double MostOfDeterminant = 8;

// Of a cell's largest face.
constexpr double NegligibleShare = 1e-4;

constexpr double CostOfFailure = 1e3;

// No gain from a merge may outweigh this: the most that any other measure costs.
constexpr double MostCost = 100;

constexpr double square(double x)
{
  return x * x;
}

constexpr double fourth(double x)
{
  return square(square(x));
}

double bounded(double cost)
{
  return std::min(cost, MostCost);
}

double costOf(const FaceSkewness& skewness)
{
  return bounded(fourth(skewness.value() / Fair::Skewness));
}

double failure(double cosine)
{
  return CostOfFailure * (2 - cosine);
}

double costOfBoundaryFace(const Polyhedron& cell, const CellShape& shape, std::size_t face)
{
  const FaceShape& f = shape.faces[face];
  const Vector normal = unit(f.area);
  const Vector towards = minus(f.centre, shape.centre);
  const double height = dot(towards, normal);
  const double cosine = height / std::max(norm(towards), Tiny);
  if (cosine < Failing::BoundaryCosine)
  {
    return failure(cosine);
  }
  const Vector aside = minus(towards, scaled(normal, height));
  return costOf(skewnessOf(ringOf(cell, face), f.centre, aside, ShareOfHeight * height)) +
    bounded(square((1 / square(cosine) - 1) / Fair::BoundarySlope));
}

double costOfInnerFace(
  const Polyhedron& cell, const CellShape& shape, std::size_t face, const NeighbourCell& beyond)
{
  const FaceShape& f = shape.faces[face];
  const Vector normal = unit(f.area);
  const Vector between = minus(beyond.centre, shape.centre);
  const Vector towards = minus(f.centre, shape.centre);
  const Vector away = minus(beyond.centre, f.centre);
  const double distance = std::max(norm(between), Tiny);
  const double across = dot(between, normal);
  const double near = dot(towards, normal);
  const double far = dot(away, normal);
  const double own = near / std::max(norm(towards), Tiny);
  const double others = far / std::max(norm(away), Tiny);
  const double least = std::min({ across / distance, own, others });
  if (least < Failing::InnerCosine)
  {
    return failure(least);
  }
  const Vector aside = minus(towards, scaled(between, near / across));
  const double weight = std::min(near, far) / across;
  const double ratio =
    std::min(shape.volume, beyond.volume) / std::max(shape.volume, beyond.volume);
  return costOf(skewnessOf(ringOf(cell, face), f.centre, aside, ShareOfDistance * distance)) +
    bounded(square((square(distance / across) - 1) / Fair::Slope)) +
    bounded(fourth(Fair::FaceWeight / weight)) +
    bounded(square(Fair::VolumeRatio / std::max(ratio, Tiny))) +
    bounded(fourth(Fair::InnerCosine / std::min(own, others)));
}

}

double costOfFace(
  const Polyhedron& cell, const CellShape& shape, std::size_t face, const NeighbourCell& beyond)
{
  return cell.isBoundary[face] || beyond.volume <= 0 ? costOfBoundaryFace(cell, shape, face)
                                                     : costOfInnerFace(cell, shape, face, beyond);
}

double negligibleArea(const CellShape& shape)
{
  double largest = 0;
  for (const FaceShape& face : shape.faces)
  {
    largest = std::max(largest, dot(face.area, face.area));
  }
  return NegligibleShare * std::sqrt(largest);
}

double costOfShare(double share)
{
  return share >= Fair::LargeShare ? 0 : bounded(square(Fair::Share / std::max(share, Tiny)));
}

double costOfDeterminant(const Polyhedron& cell, const CellShape& shape)
{
  std::array<Vector, 3> sum{};
  double size = 0;
  std::size_t count = 0;
  for (std::size_t f = 0; f < cell.faces(); ++f)
  {
    if (cell.isBoundary[f])
    {
      continue;
    }
    const Vector& area = shape.faces[f].area;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      sum[axis] = plus(sum[axis], scaled(area, area[axis]));
    }
    size += norm(area);
    ++count;
  }
  const double mean = size / static_cast<double>(std::max<std::size_t>(count, 1));
  const double determinant = dot(sum[0], cross(sum[1], sum[2])) / (8 * std::pow(mean, 6) + Tiny);
  return count == 0 ? 0
                    : std::min(Fair::Determinant / std::max(determinant, Tiny), MostOfDeterminant);
}

bool isEasy(const Polyhedron& cell, const CellShape& shape)
{
  const double negligible = negligibleArea(shape);
  for (std::size_t f = 0; f < cell.faces(); ++f)
  {
    if (norm(shape.faces[f].area) < negligible ||
      (cell.isBoundary[f] && costOfBoundaryFace(cell, shape, f) > PoorCost))
    {
      return false;
    }
  }
  return costOfDeterminant(cell, shape) <= PoorCost;
}

}
