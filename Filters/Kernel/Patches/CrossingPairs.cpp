// SPDX-License-Identifier: BSD-3-Clause
#include "Patches/CrossingPairs.h"

#include "Base/Rings.h"
#include "Boxes/Sides.h"

#include <algorithm>

namespace cartesian
{

void CrossingPairs::find(const Box& box, const BoxSurface& piece, bool cancels)
{
  partner_.assign(piece.points.size(), None);
  crossings_.clear();
  if (!cancels)
  {
    return;
  }
  for (const Segment& s : piece.segments)
  {
    if (planeCount(piece.points[s.from]) >= 2)
    {
      crossings_.push_back(s.from);
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    pairAlong(box, piece, axis);
  }
}

void CrossingPairs::pairAlong(const Box& box, const BoxSurface& piece, std::size_t axis)
{
  onLines_.clear();
  for (const std::uint32_t node : crossings_)
  {
    if (!onPlane(piece.points[node][axis]))
    {
      onLines_.push_back(node);
    }
  }
  const auto key = [&](std::uint32_t node) {
    const Point& p = piece.points[node];
    return std::array<Level, 3>{ following(p, axis), preceding(p, axis), p[axis] };
  };
  std::sort(onLines_.begin(), onLines_.end(),
    [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  onLines_.erase(std::unique(onLines_.begin(), onLines_.end()), onLines_.end());
  for (std::size_t i = 0; i < onLines_.size();)
  {
    std::size_t j = i + 1;
    while (j < onLines_.size() && key(onLines_[j])[0] == key(onLines_[i])[0] &&
      key(onLines_[j])[1] == key(onLines_[i])[1])
    {
      ++j;
    }
    if (j - i > 1)
    {
      pairOnLine(box, piece, axis, onLines_.data() + i, onLines_.data() + j);
    }
    i = j;
  }
}

// Those on the edge or middle line of the box along `axis` on which a point lies.
void CrossingPairs::listHangingNodes(const Box& box, const Point& on, std::size_t axis)
{
  FinePoint from = boxes_.fineLow(box);
  for (const std::size_t other : { (axis + 1) % 3, (axis + 2) % 3 })
  {
    const std::int64_t size = Boxes::fineSize(box, static_cast<int>(other));
    from[other] +=
      on[other] == box.low[other] ? 0 : (on[other] == box.high[other] ? size : size / 2);
  }
  hangingNodes(boxes_, static_cast<int>(axis), from, Boxes::fineSize(box, static_cast<int>(axis)),
    box.global, hanging_);
}

// Pairs the crossings of one line, which come in order; hanging nodes divide it into lines of their own.
void CrossingPairs::pairOnLine(const Box& box, const BoxSurface& piece, std::size_t axis,
  const std::uint32_t* begin, const std::uint32_t* end)
{
  listHangingNodes(box, piece.points[*begin], axis);
  const auto upward = [&](std::uint32_t crossing) {
    const auto at = std::find_if(piece.segments.begin(), piece.segments.end(),
      [&](const Segment& s) { return s.from == crossing; });
    return features_.normal[at->triangle][axis] > 0;
  };
  open_.clear(); // crossings that nothing has cancelled so far
  std::size_t piecesBefore = 0;
  for (const std::uint32_t* node = begin; node != end; ++node)
  {
    const auto before = static_cast<std::size_t>(
      std::count_if(hanging_.begin(), hanging_.end(), [&](std::int64_t position) {
        return planeAt(boxes_.planes, axis, position) < piece.points[*node][axis];
      }));
    if (before != piecesBefore)
    {
      open_.clear();
      piecesBefore = before;
    }
    if (!open_.empty() && upward(open_.back()) != upward(*node))
    {
      partner_[open_.back()] = *node;
      partner_[*node] = open_.back();
      open_.pop_back();
    }
    else
    {
      open_.push_back(*node);
    }
  }
}

}
