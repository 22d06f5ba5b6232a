// SPDX-License-Identifier: BSD-3-Clause
// Removes corners and faces from arrays of faces, and closes the gaps.
#pragma once

#include "Base/Execution.h"
#include "Base/RawVector.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace cartesian
{

// Faces come in groups (boxes or sides). `groupStart`: the first face of each group, and the end;
// `start`: the first corner of each face, and the end.
template <class WhatIsLeft, class Move>
class FaceCompaction
{
public:
  FaceCompaction(std::vector<std::size_t>& groupStart, RawVector<std::size_t>& start,
    RawVector<std::uint32_t>& corners, const WhatIsLeft& whatIsLeft, const Move& move)
    : groupStart_(groupStart)
    , start_(start)
    , corners_(corners)
    , whatIsLeft_(whatIsLeft)
    , move_(move)
    , groups_(groupStart.size() - 1)
  {
  }

  // Compacts each chunk by itself, then moves the chunks together.
  void run(Execution& execution)
  {
    std::vector<FaceSpan> spans;
    for (std::size_t begin = 0; begin < groups_; begin += GroupsAChunk)
    {
      const std::size_t first = groupStart_[begin];
      const std::size_t last = groupStart_[std::min(begin + GroupsAChunk, groups_)];
      spans.push_back({ first, start_[first], last - first, start_[last] - start_[first] });
    }
    execution.forEach(groups_, GroupsAChunk, [&](std::size_t begin, std::size_t end) {
      FaceSpan& span = spans[begin / GroupsAChunk];
      span = compact(begin, end, span);
    });
    FaceSpan next{ 0, 0, 0, 0 };
    for (std::size_t i = 0; i < spans.size(); ++i)
    {
      if (next.face != spans[i].face || next.corner != spans[i].corner)
      {
        moveUp(i, spans[i], next);
      }
      next.face += spans[i].faces;
      next.corner += spans[i].corners;
    }
    groupStart_.back() = next.face;
    start_.resize(next.face + 1);
    start_.back() = next.corner;
    corners_.resize(next.corner);
  }

private:
  static constexpr std::size_t GroupsAChunk = 4096;

  // The faces and corners of a chunk: the first, and how many.
  struct FaceSpan
  {
    std::size_t face;
    std::size_t corner;
    std::size_t faces;
    std::size_t corners;
  };

  // Compacts the chunk of groups [begin, end), which spans `all`, and returns what is left. It reads nothing
  // beyond, where another thread may write.
  FaceSpan compact(std::size_t begin, std::size_t end, const FaceSpan& all)
  {
    std::vector<std::uint32_t> ring;
    std::size_t face = all.face; // next to be written, never beyond what was read
    std::size_t corner = all.corner;
    const std::size_t lastFace = all.face + all.faces;
    std::size_t read = all.face;
    std::size_t first = all.corner;
    for (std::size_t group = begin; group < end; ++group)
    {
      const std::size_t groupEnd = group + 1 < end ? groupStart_[group + 1] : lastFace;
      groupStart_[group] = face;
      for (; read < groupEnd; ++read)
      {
        const std::size_t last = read + 1 < lastFace ? start_[read + 1] : all.corner + all.corners;
        whatIsLeft_(corners_.data() + first, corners_.data() + last, ring);
        first = last;
        if (ring.size() > 2)
        {
          move_(read, face);
          std::copy(ring.begin(), ring.end(), corners_.begin() + std::ptrdiff_t(corner));
          start_[face++] = corner;
          corner += ring.size();
        }
      }
    }
    return { all.face, all.corner, face - all.face, corner - all.corner };
  }

  // Moves a chunk to the end of those before it.
  void moveUp(std::size_t chunk, const FaceSpan& span, const FaceSpan& to)
  {
    if (span.corner != to.corner)
    {
      const auto from = corners_.begin() + std::ptrdiff_t(span.corner);
      std::copy(
        from, from + std::ptrdiff_t(span.corners), corners_.begin() + std::ptrdiff_t(to.corner));
    }
    for (std::size_t f = 0; f < span.faces; ++f)
    {
      start_[to.face + f] = start_[span.face + f] - span.corner + to.corner;
      move_(span.face + f, to.face + f);
    }
    const std::size_t end = std::min((chunk + 1) * GroupsAChunk, groups_);
    for (std::size_t g = chunk * GroupsAChunk; g < end; ++g)
    {
      groupStart_[g] = groupStart_[g] - span.face + to.face;
    }
  }

  std::vector<std::size_t>& groupStart_;
  RawVector<std::size_t>& start_;
  RawVector<std::uint32_t>& corners_;
  const WhatIsLeft& whatIsLeft_;
  const Move& move_;
  std::size_t groups_;
};

// whatIsLeft(begin, end, ring) puts the corners that a face keeps into `ring`; with fewer than three the face
// is removed. Calls move(from, to) for faces that stay, to move what else belongs to them. Both are called
// from several threads.
template <class WhatIsLeft, class Move>
void compactFaces(std::vector<std::size_t>& groupStart, RawVector<std::size_t>& start,
  RawVector<std::uint32_t>& corners, const WhatIsLeft& whatIsLeft, const Move& move,
  Execution& execution)
{
  FaceCompaction<WhatIsLeft, Move>(groupStart, start, corners, whatIsLeft, move).run(execution);
}

}
