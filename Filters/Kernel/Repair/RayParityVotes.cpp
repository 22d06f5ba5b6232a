// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/RayParityVotes.h"

#include "Repair/LineGrid.h"
#include "Repair/Snapping.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t TrianglesAChunk = 2048;

// A triangle's crossing with a line.
struct VotingCrossing
{
  std::uint32_t line;
  Level level;
  std::uint32_t triangle;
  bool up; // the normal's direction along the line

  bool operator<(const VotingCrossing& other) const
  {
    return level != other.level ? level < other.level : triangle < other.triangle;
  }
};

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

  void vote(int along, std::vector<SampleRay>& lines, Execution& execution)
  {
    if (lines.empty())
    {
      return;
    }
    const LineGrid grid(surface_, along, lines, execution);
    const std::size_t count = surface_.triangles.size();
    std::vector<std::vector<VotingCrossing>> found(chunks(count, TrianglesAChunk));
    execution.forEach(count, TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t)
      {
        const Corners corners = surface_.corners(t);
        grid.forEachLine(corners, [&](std::uint32_t line) {
          const Point p = crossLine(corners, along, grid.at(line));
          found[begin / TrianglesAChunk].push_back(
            { line, p[static_cast<std::size_t>(along)], static_cast<std::uint32_t>(t),
              exactNormal(corners)[static_cast<std::size_t>(along)] > 0 });
        });
      }
    });
    const Buckets<VotingCrossing> crossings = sortIntoBuckets(
      found, lines.size(), [](const VotingCrossing& v) { return v.line; }, execution);
    for (std::size_t line = 0; line < lines.size(); ++line)
    {
      countLine(crossings.begin(line), crossings.end(line), lines[line].sheet);
    }
  }

  RayParityVotes takeVotes() { return std::move(votes_); }

private:
  // The crossings of one line, which was laid through a sheet.
  void countLine(const VotingCrossing* begin, const VotingCrossing* end, std::uint32_t sheet)
  {
    if ((end - begin) % 2 == 1)
    {
      return; // it passes through a hole
    }
    entered_.clear();
    for (const VotingCrossing* vote = begin; vote != end; ++vote)
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

  void addFacing(const VotingCrossing& vote, bool entering, RayParityVotes::OfFacing& facing) const
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
    const VotingCrossing* begin, const VotingCrossing* sample, const VotingCrossing* end)
  {
    const std::uint32_t own = sheets_.of(sample->triangle);
    const auto isNear = [&](const VotingCrossing& other) {
      return std::abs(double(other.level) - double(sample->level)) < near_;
    };
    close_.clear();
    for (const VotingCrossing* c = sample; c != begin && isNear(c[-1]); --c)
    {
      close_.push_back(bodyOf(sheets_.of(c[-1].triangle)));
    }
    for (const VotingCrossing* c = sample + 1; c != end && isNear(*c); ++c)
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

RayParityVotes voteOnSheets(
  const Surface& surface, const ManifoldComponents& sheets, Execution& execution)
{
  VoteCounter counter(surface, sheets);
  std::array<std::vector<SampleRay>, 3> lines = findSampleRays(surface, sheets, execution);
  for (int along = 0; along < 3; ++along)
  {
    counter.vote(along, lines[static_cast<std::size_t>(along)], execution);
  }
  return counter.takeVotes();
}

}
