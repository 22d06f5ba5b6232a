// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/FrontalArea.h"

#include "Base/Rings.h"
#include "Lattice/Lattice.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace cartesian
{

namespace
{

constexpr double Squares = 2048; // along the shadow's longer side

using Place = std::array<double, 2>; // in squares

// A shadow as squares that it covers with their middles.
class Shadow
{
public:
  explicit Shadow(const std::array<double, 2>& lengths)
    : square_(std::max(lengths[0], lengths[1]) / Squares)
  {
    for (std::size_t i = 0; i < 2; ++i)
    {
      count_[i] = static_cast<long>(std::ceil(lengths[i] / square_)) + 1;
    }
    isCovered_.resize(static_cast<std::size_t>(count_[0] * count_[1]));
  }

  double square() const { return square_; }

  // Row by row, between where the triangle's edges cross the middle of the row.
  void add(const std::array<Place, 3>& triangle)
  {
    const auto [low, high] = std::minmax({ triangle[0][1], triangle[1][1], triangle[2][1] });
    for (long row = middleAfter(low); row < middleAfter(high); ++row)
    {
      const double y = static_cast<double>(row) + 0.5;
      double begin = std::numeric_limits<double>::infinity();
      double end = -begin;
      for (std::size_t i = 0; i < 3; ++i)
      {
        const Place& a = triangle[i];
        const Place& b = following(triangle, i);
        if ((a[1] <= y) != (b[1] <= y))
        {
          const double x = a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
          begin = std::min(begin, x);
          end = std::max(end, x);
        }
      }
      cover(row, begin, end);
    }
  }

  double area() const
  {
    return square_ * square_ *
      static_cast<double>(std::count(isCovered_.begin(), isCovered_.end(), 1));
  }

private:
  static long middleAfter(double x) { return static_cast<long>(std::ceil(x - 0.5)); }

  void cover(long row, double begin, double end)
  {
    if (row < 0 || row >= count_[1] || !(begin < end))
    {
      return;
    }
    const auto start = isCovered_.begin() + row * count_[0];
    const long first = std::clamp(middleAfter(begin), 0L, count_[0]);
    const long last = std::clamp(middleAfter(end), 0L, count_[0]);
    std::fill(start + first, start + last, 1);
  }

  double square_;
  std::array<long, 2> count_;
  std::vector<std::uint8_t> isCovered_;
};

double coordinate(const FoamMesh& mesh, std::size_t corner, std::size_t axis)
{
  return mesh.points[3 * std::size_t(mesh.corners[corner]) + axis];
}

// Calls with each face of the patches of these names.
template <class Action>
void forEachFace(const FoamMesh& mesh, const std::vector<std::string>& names, Action&& action)
{
  std::size_t face = mesh.neighbour.size();
  for (const FoamPatch& patch : mesh.patches)
  {
    const bool isAsked = std::find(names.begin(), names.end(), patch.name) != names.end();
    for (const std::size_t end = face + patch.count; face < end; ++face)
    {
      if (isAsked)
      {
        action(mesh.start[face], mesh.start[face + 1]);
      }
    }
  }
}

// Empty where the patches have no faces.
Bounds boundsOf(const FoamMesh& mesh, const std::vector<std::string>& names)
{
  Bounds bounds = Bounds::none();
  forEachFace(mesh, names, [&](std::size_t begin, std::size_t end) {
    for (std::size_t corner = begin; corner < end; ++corner)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        bounds.include(axis, coordinate(mesh, corner, static_cast<std::size_t>(axis)));
      }
    }
  });
  return bounds;
}

}

BodySize sizeOfBodies(const FoamMesh& mesh, const std::vector<std::string>& names, int axis)
{
  const Bounds bounds = boundsOf(mesh, names);
  if (!(bounds.low[0] <= bounds.high[0]))
  {
    return {};
  }
  const std::array<std::size_t, 2> across{ static_cast<std::size_t>((axis + 1) % 3),
    static_cast<std::size_t>((axis + 2) % 3) };
  const auto lengthOf = [&](std::size_t along) { return bounds.high[along] - bounds.low[along]; };
  Shadow shadow({ lengthOf(across[0]), lengthOf(across[1]) });
  const auto place = [&](std::size_t corner) {
    return Place{ (coordinate(mesh, corner, across[0]) - bounds.low[across[0]]) / shadow.square(),
      (coordinate(mesh, corner, across[1]) - bounds.low[across[1]]) / shadow.square() };
  };
  forEachFace(mesh, names, [&](std::size_t begin, std::size_t end) {
    for (std::size_t corner = begin + 1; corner + 1 < end; ++corner)
    {
      shadow.add({ place(begin), place(corner), place(corner + 1) });
    }
  });
  return { lengthOf(static_cast<std::size_t>(axis)), shadow.area() };
}

std::optional<int> flatAxisOf(const FoamMesh& mesh, const std::vector<std::string>& names)
{
  const Bounds bounds = boundsOf(mesh, names);
  std::array<double, 3> lengths;
  std::transform(
    bounds.high.begin(), bounds.high.end(), bounds.low.begin(), lengths.begin(), std::minus<>());
  const double* const least = std::min_element(lengths.data(), lengths.data() + lengths.size());
  return *least >= 0 ? std::optional<int>(static_cast<int>(least - lengths.data())) : std::nullopt;
}

}
