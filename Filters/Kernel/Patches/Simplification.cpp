// SPDX-License-Identifier: BSD-3-Clause
#include "Patches/Simplification.h"

#include <algorithm>

namespace cartesian
{

Simplification::Simplification(const Surface& surface, const Boxes& boxes,
  const PlaneClearance& clearance, const PatchSpec& spec)
  : boxes_(boxes)
  , clearance_(clearance)
  , removal_(surface, spec, box_)
  , merging_(surface, spec, box_)
{
}

void Simplification::begin(const Box& box, const BoxSurface& piece)
{
  const auto& global = boxes_.globalOf(box).index;
  const Level shortest = std::min(
    { clearance_.of(0, global[0]), clearance_.of(1, global[1]), clearance_.of(2, global[2]) });
  box_.begin(box, piece, static_cast<double>(shortest));
}

void Simplification::add(const std::uint32_t* begin, const std::uint32_t* end,
  std::uint32_t triangle, const Vector& normal)
{
  Polygon like{};
  like.triangle = triangle;
  like.area = norm(box_.areaVector(begin, end));
  box_.append(begin, end, like, { normal, 0 });
}

}
