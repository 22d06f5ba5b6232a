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
constexpr std::size_t MostRays = 1024;

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
    std::sort(rays.begin(), rays.end());
    std::size_t crossed = 0;
    std::vector<std::vector<RayCrossing>> crossings;
    for (std::size_t first = 0; first < rays.size() && crossed < MostCrossings;
         first += crossings.size())
    {
      crossings.resize(std::min({ std::max(first, FirstRays), MostRays, rays.size() - first }));
      execution.forEach(crossings.size(), 1, [&](std::size_t i, std::size_t) {
        crossings[i] = crossingsOf(surface_, tree, along, rays[first + i].place);
      });
      for (std::size_t i = 0; i < crossings.size(); ++i)
      {
        const std::vector<RayCrossing>& all = crossings[i];
        countLine(all.data(), all.data() + all.size(), rays[first + i].sheet);
        crossed += all.size();
      }
    }
  }

  RayParityVotes takeVotes() { return std::move(votes_); }

private:
  // The crossings of one line, which was laid through a sheet.
  void countLine(const RayCrossing* begin, const RayCrossing* end, std::uint32_t sheet)
  {
    if ((end - begin) % 2 == 1)
    {
      return; // it passes through a hole
    }
    entered_.clear();
    for (const RayCrossing* vote = begin; vote != end; ++vote)
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

  void addFacing(const RayCrossing& vote, bool entering, RayParityVotes::OfFacing& facing) const
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
  void addNesting(const RayCrossing* begin, const RayCrossing* sample, const RayCrossing* end)
  {
    const std::uint32_t own = sheets_.of(sample->triangle);
    const auto isNear = [&](const RayCrossing& other) {
      return std::abs(double(other.level) - double(sample->level)) < near_;
    };
    close_.clear();
    for (const RayCrossing* c = sample; c != begin && isNear(c[-1]); --c)
    {
      close_.push_back(bodyOf(sheets_.of(c[-1].triangle)));
    }
    for (const RayCrossing* c = sample + 1; c != end && isNear(*c); ++c)
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
