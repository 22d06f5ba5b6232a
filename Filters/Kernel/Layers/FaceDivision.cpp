// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/FaceDivision.h"

#include "Base/Rings.h"
#include "Polyhedra/CellGeometry.h"
#include "Quality/FaceMeasures.h"
#include "Quality/Limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace cartesian
{

namespace
{

// Sine of the angle by which a corner may turn back where parts are joined.
constexpr double Straight = 0.02;

constexpr double Refused = std::numeric_limits<double>::infinity();

using Part = FaceDivision::Part;

// Of two parts with a common edge; or empty.
Part joinedRing(const Part& a, const Part& b)
{
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      if (a[i] != following(b, j) || following(a, i) != b[j])
      {
        continue;
      }
      Part ring;
      for (std::size_t k = 1; k <= a.size(); ++k)
      {
        ring.push_back(a[(i + k) % a.size()]);
      }
      for (std::size_t k = 2; k < b.size(); ++k)
      {
        ring.push_back(b[(j + k) % b.size()]);
      }
      return ring;
    }
  }
  return {};
}

FaceGeometry geometryOf(const std::vector<Vector>& corners, const Part& ring)
{
  return measureFace(ring.size(), [&](std::size_t i) -> const Vector& { return corners[ring[i]]; });
}

}

const std::vector<Part>& FaceDivision::divide(const std::vector<Vector>& corners,
  const Vector& cell, const FlatEnough& flat, const std::vector<Diagonal>& barred)
{
  corners_ = &corners;
  cell_ = cell;
  parts_.clear();
  Part whole(corners.size());
  std::iota(whole.begin(), whole.end(), 0);
  normal_ = unit(geometryOf(corners, whole).area);
  if (excessOf(whole, flat) <= 1 || !triangulate(barred))
  {
    parts_.push_back(whole);
    return parts_;
  }
  listTriangles(0, corners.size() - 1);
  joinFlat(flat);
  return parts_;
}

// Beyond 1 it is too warped.
double FaceDivision::excessOf(const Part& ring, const FlatEnough& flat) const
{
  const FaceGeometry face = geometryOf(*corners_, ring);
  const Vector normal = unit(face.area);
  Vector mean{};
  double warp = 0;
  for (const std::uint32_t i : ring)
  {
    mean = plus(mean, scaled((*corners_)[i], 1 / static_cast<double>(ring.size())));
    warp = std::max(warp, std::abs(dot(minus((*corners_)[i], face.centre), normal)));
  }
  return std::max(std::abs(dot(minus(face.centre, mean), normal)) / flat.off, warp / flat.warp);
}

// Whether the cell sees it well.
bool FaceDivision::faces(const Part& ring) const
{
  const FaceGeometry face = geometryOf(*corners_, ring);
  const Vector normal = unit(face.area);
  const Vector line = minus(face.centre, cell_);
  const double height = dot(line, normal);
  const Vector aside = minus(line, scaled(normal, height));
  return dot(face.area, normal_) > 0 && norm(aside) < LayerLimits::Slope * height &&
    skewness(
      ring.size(), [&](std::size_t i) { return (*corners_)[ring[i]]; }, face.centre, aside,
      ShareOfHeight * height) <= LayerLimits::Skewness;
}

// 1 for an equilateral triangle, more for longer ones.
double FaceDivision::costOf(const Part& triangle) const
{
  if (!faces(triangle))
  {
    return Refused;
  }
  double squares = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vector edge = minus((*corners_)[following(triangle, i)], (*corners_)[triangle[i]]);
    squares += dot(edge, edge);
  }
  const double shape =
    squares / (4 * std::sqrt(3.0) * dot(geometryOf(*corners_, triangle).area, normal_));
  return shape * shape;
}

// Finds the triangulation of least cost; false: each has a triangle that is refused.
bool FaceDivision::triangulate(const std::vector<Diagonal>& barred)
{
  const std::size_t size = corners_->size();
  cost_.assign(size * size, 0);
  apex_.assign(size * size, 0);
  for (std::size_t span = 2; span < size; ++span)
  {
    for (std::size_t i = 0; i + span < size; ++i)
    {
      const std::size_t k = i + span;
      double& least = cost_[i * size + k] = Refused;
      const Diagonal chord{ static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k) };
      const bool isBarred = std::find(barred.begin(), barred.end(), chord) != barred.end();
      for (std::size_t j = i + 1; j < k && !isBarred; ++j)
      {
        const double sides = cost_[i * size + j] + cost_[j * size + k];
        const double cost = sides < least ? sides +
            costOf({ static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j),
              static_cast<std::uint32_t>(k) })
                                          : Refused;
        if (cost < least)
        {
          least = cost;
          apex_[i * size + k] = j;
        }
      }
    }
  }
  return cost_[size - 1] < Refused;
}

void FaceDivision::listTriangles(std::size_t i, std::size_t k)
{
  if (k - i < 2)
  {
    return;
  }
  const std::size_t j = apex_[i * corners_->size() + k];
  parts_.push_back({ static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j),
    static_cast<std::uint32_t>(k) });
  listTriangles(i, j);
  listTriangles(j, k);
}

// Parts that are flat enough together become one.
void FaceDivision::joinFlat(const FlatEnough& flat)
{
  while (joinFlattest(flat))
  {
  }
}

bool FaceDivision::joinFlattest(const FlatEnough& flat)
{
  double least = Refused;
  std::array<std::size_t, 2> best{};
  for (std::size_t a = 0; a < parts_.size(); ++a)
  {
    for (std::size_t b = a + 1; b < parts_.size(); ++b)
    {
      const Part ring = joinedRing(parts_[a], parts_[b]);
      const double excess = ring.empty() ? Refused : excessOf(ring, flat);
      if (excess <= 1 && excess < least && isConvex(ring))
      {
        least = excess;
        best = { a, b };
      }
    }
  }
  if (least < Refused)
  {
    parts_[best[0]] = joinedRing(parts_[best[0]], parts_[best[1]]);
    parts_.erase(parts_.begin() + static_cast<std::ptrdiff_t>(best[1]));
  }
  return least < Refused;
}

bool FaceDivision::isConvex(const Part& ring) const
{
  bool is = true;
  const std::size_t size = ring.size();
  for (std::size_t i = 0; i < size; ++i)
  {
    const Vector& at = (*corners_)[ring[i]];
    const Vector ahead = minus((*corners_)[ring[(i + 1) % size]], at);
    const Vector back = minus((*corners_)[ring[(i + size - 1) % size]], at);
    is = is && dot(cross(ahead, back), normal_) >= -Straight * norm(ahead) * norm(back);
  }
  return is;
}

}
