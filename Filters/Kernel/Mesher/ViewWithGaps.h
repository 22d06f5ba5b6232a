// SPDX-License-Identifier: BSD-3-Clause
// A surface with the triangles that close gaps in it, each gap a boundary of its own after all others.
#pragma once

#include "Mesher/ClosedGaps.h"

namespace cartesian
{

// Borrows the view that it is made of, not the gaps.
class ViewWithGaps
{
public:
  ViewWithGaps(const SurfaceView& view, const std::vector<ClosedGap>& gaps);
  ViewWithGaps(const ViewWithGaps&) = delete;
  ViewWithGaps& operator=(const ViewWithGaps&) = delete;

  const SurfaceView& view() const { return view_; }

private:
  std::vector<std::uint32_t> triangles_;
  std::vector<std::int32_t> boundary_;
  std::vector<std::int32_t> region_;
  std::vector<std::uint8_t> knowsEdges_;
  std::vector<std::uint8_t> isSheet_;
  SurfaceView view_;
};

}
