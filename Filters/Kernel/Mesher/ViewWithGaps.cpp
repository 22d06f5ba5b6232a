// SPDX-License-Identifier: BSD-3-Clause
#include "Mesher/ViewWithGaps.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// Of each triangle of the view.
template <class Value>
std::vector<Value> copied(const Value* values, std::size_t count, Value otherwise)
{
  return values ? std::vector<Value>(values, values + count) : std::vector<Value>(count, otherwise);
}

}

ViewWithGaps::ViewWithGaps(const SurfaceView& view, const std::vector<ClosedGap>& gaps)
  : triangles_(view.triangles, view.triangles + 3 * view.triangleCount)
  , boundary_(copied(view.boundary, view.triangleCount, 0))
  , region_(copied(view.region, view.triangleCount, OutsideRegion))
  , knowsEdges_(copied(view.knowsEdges, view.triangleCount, std::uint8_t(0)))
  , isSheet_(copied(view.isSheet, view.triangleCount, std::uint8_t(0)))
  , view_(view)
{
  std::int32_t boundary = *std::max_element(boundary_.begin(), boundary_.end());
  for (const ClosedGap& gap : gaps)
  {
    for (const auto& triangle : gap.triangles)
    {
      triangles_.insert(triangles_.end(), triangle.begin(), triangle.end());
    }
    const std::size_t count = triangles_.size() / 3;
    boundary_.resize(count, ++boundary);
    region_.resize(count, gap.region);
    knowsEdges_.resize(count);
    isSheet_.resize(count);
  }
  view_.triangles = triangles_.data();
  view_.triangleCount = boundary_.size();
  view_.boundary = boundary_.data();
  view_.region = view.region ? region_.data() : nullptr;
  view_.knowsEdges = view.knowsEdges ? knowsEdges_.data() : nullptr;
  view_.isSheet = view.isSheet ? isSheet_.data() : nullptr;
  view_.cells = nullptr; // it was looked at without the gaps before
}

}
