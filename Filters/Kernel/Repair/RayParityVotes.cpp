// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/RayParityVotes.h"

#include "Repair/RayCrossings.h"
#include "Repair/SampleRays.h"
#include "Repair/Snapping.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// Of lines with triangles in all. Beyond that, the lines of small triangles have no vote: millions of large triangles that
// all overlap would take days.
constexpr std::size_t MostCrossings = 2500000;

// Followed at once on all threads: at first, and at the most.
constexpr std::size_t FirstRays = 16;
constexpr std::size_t MostRays = 16384;

constexpr std::size_t RaysACheck = 1024; // of the limit

class VoteCounter
{
public:
  VoteCounter(const Surface& surface, const ManifoldComponents& sheets)
    : surface_(surface)
    , sheets_(sheets)
    , near_(placingOf(surface).snap)
    , isIn_(surface.triangles.size())
  {
    votes_.amongAll.resize(surface.triangles.size());
    votes_.alone.resize(surface.triangles.size());
    votes_.samples.resize(surface.triangles.size());
  }

  void vote(
    std::size_t along, std::vector<SampleRay>& rays, const TriangleTree& tree, Execution& execution)
  {
    sortAll(rays, execution);
    std::size_t crossed = 0;
    std::size_t next = 0;
    while (next < rays.size() && crossed < MostCrossings)
    {
      std::vector<Point> places(
        std::min({ std::max(next, FirstRays), MostRays, rays.size() - next }));
      std::transform(rays.data() + next, rays.data() + next + places.size(), places.begin(),
        [](const SampleRay& ray) { return ray.place; });
      const Buckets<NumberedCrossing> crossings =
        crossingsOf(surface_, tree, along, places, execution);
      for (std::size_t i = 0; i < places.size(); ++i)
      {
        if (i % RaysACheck == 0 && crossed >= MostCrossings)
        {
          return;
        }
        countLine(crossings.begin(i), crossings.end(i), rays[next + i].sheet);
        crossed += static_cast<std::size_t>(crossings.end(i) - crossings.begin(i));
      }
      next += places.size();
    }
  }

  RayParityVotes takeVotes() { return std::move(votes_); }

private:
  // The crossings of one line, which was laid through a sheet.
  void countLine(const NumberedCrossing* begin, const NumberedCrossing* end, std::uint32_t sheet)
  {
    if ((end - begin) % 2 == 1)
    {
      return; // it passes through a hole
    }
    entered_.clear();
    for (const NumberedCrossing* vote = begin; vote != end; ++vote)
    {
      const std::uint32_t own = sheets_.of(vote->triangle);
      const bool isAlone = (vote == begin || vote[-1].level != vote->level) &&
        (vote + 1 == end || vote[1].level != vote->level);
      if (isAlone)
      {
        addFacing(*vote, (vote - begin) % 2 == 0, votes_.amongAll[own]);
        addFacing(*vote, isIn_[own] == 0, votes_.alone[own]);
      }
      if (own == sheet && sheets_.closed(own))
      {
        addNesting(begin, vote, end);
      }
      enter(own);
    }
    for (const std::uint32_t entered : entered_)
    {
      isIn_[entered] = 0;
    }
  }

  void addFacing(
    const NumberedCrossing& vote, bool entering, RayParityVotes::OfFacing& facing) const
  {
    const bool outward = entering != vote.up;
    ++(outward != sheets_.turned(vote.triangle) ? facing.outward : facing.inward);
  }

  void enter(std::uint32_t sheet)
  {
    isIn_[sheet] ^= 1;
    if (isIn_[sheet] != 0)
    {
      entered_.push_back(sheet);
    }
    else
    {
      entered_.erase(std::find(entered_.begin(), entered_.end(), sheet));
    }
  }

  std::uint32_t bodyOf(std::uint32_t sheet) const
  {
    return sheets_.closed(sheet) ? sheet : AllOpenSheets;
  }

  // What the line is in where it crosses a sheet.
  void addNesting(
    const NumberedCrossing* begin, const NumberedCrossing* sample, const NumberedCrossing* end)
  {
    const std::uint32_t own = sheets_.of(sample->triangle);
    const auto isNear = [&](const RayCrossing& other) {
      return std::abs(double(other.level) - double(sample->level)) < near_;
    };
    close_.clear();
    for (const NumberedCrossing* c = sample; c != begin && isNear(c[-1]); --c)
    {
      close_.push_back(bodyOf(sheets_.of(c[-1].triangle)));
    }
    for (const NumberedCrossing* c = sample + 1; c != end && isNear(*c); ++c)
    {
      close_.push_back(bodyOf(sheets_.of(c->triangle)));
    }
    sortOut(close_);
    ++votes_.samples[own];
    for (const std::uint32_t other : close_)
    {
      if (other != own)
      {
        ++votes_.nesting[{ own, other }].unknown;
      }
    }
    around_.clear();
    std::size_t open = 0;
    for (const std::uint32_t other : entered_)
    {
      around_.push_back(bodyOf(other));
      open += around_.back() == AllOpenSheets ? 1 : 0;
    }
    sortOut(around_);
    for (const std::uint32_t other : around_)
    {
      const bool isIn = other == AllOpenSheets ? open % 2 == 1 : other != own;
      if (isIn && !std::binary_search(close_.begin(), close_.end(), other))
      {
        ++votes_.nesting[{ own, other }].inside;
      }
    }
  }

  static void sortOut(std::vector<std::uint32_t>& sheets)
  {
    std::sort(sheets.begin(), sheets.end());
    sheets.erase(std::unique(sheets.begin(), sheets.end()), sheets.end());
  }

  const Surface& surface_;
  const ManifoldComponents& sheets_;
  double near_;                    // levels
  std::vector<std::uint8_t> isIn_; // of each sheet: whether the line is in it by its own crossings
  std::vector<std::uint32_t> entered_; // those
  std::vector<std::uint32_t> close_;
  std::vector<std::uint32_t> around_;
  RayParityVotes votes_;
};

}

RayParityVotes voteOnSheets(const Surface& surface, const ManifoldComponents& sheets,
  const TriangleTree& tree, Execution& execution)
{
  VoteCounter counter(surface, sheets);
  std::array<std::vector<SampleRay>, 3> rays = findSampleRays(surface, sheets, execution);
  for (std::size_t along = 0; along < 3; ++along)
  {
    counter.vote(along, rays[along], tree, execution);
  }
  return counter.takeVotes();
}

}
