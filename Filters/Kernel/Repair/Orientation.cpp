// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/Orientation.h"

#include "Lattice/Vector.h"
#include "Repair/LineGrid.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t TrianglesAChunk = 2048;

// A closed sheet with at least one vote in so many on either side passes through other sheets.
constexpr long long VotesPerDissent = 4;

// The votes on each sheet.
struct Votes
{
  std::vector<long long> outward; // that its first triangle's normal points outward
  std::vector<long long> inward;

  explicit Votes(std::size_t sheets)
    : outward(sheets)
    , inward(sheets)
  {
  }
};

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

// Of the crossings of one line.
void countVotes(
  const VotingCrossing* begin, const VotingCrossing* end, const Sheets& sheets, Votes& votes)
{
  if ((end - begin) % 2 == 1)
  {
    return; // it passes through a hole
  }
  for (const VotingCrossing* vote = begin; vote != end; ++vote)
  {
    if ((vote != begin && vote[-1].level == vote->level) ||
      (vote + 1 != end && vote[1].level == vote->level))
    {
      continue;
    }
    const bool entering = (vote - begin) % 2 == 0;
    const bool outward = entering != vote->up;
    auto& counts = outward != sheets.turned(vote->triangle) ? votes.outward : votes.inward;
    ++counts[sheets.of(vote->triangle)];
  }
}

void vote(const Surface& surface, const Sheets& sheets, int along, std::vector<VotingLine>& lines,
  Votes& votes, Execution& execution)
{
  if (lines.empty())
  {
    return;
  }
  const LineGrid grid(surface, along, lines);
  const std::size_t count = surface.triangles.size();
  std::vector<std::vector<VotingCrossing>> found(chunks(count, TrianglesAChunk));
  execution.forEach(count, TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
    {
      const Corners corners = surface.corners(t);
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
    countVotes(crossings.begin(line), crossings.end(line), sheets, votes);
  }
}

void turn(Surface& surface, std::size_t triangle)
{
  std::swap(surface.triangles[triangle][1], surface.triangles[triangle][2]);
}

// Decides which sheets must be reversed.
class Verdict
{
public:
  Verdict(const Surface& surface, const Sheets& sheets, const Votes& votes,
    const std::vector<TrianglePair>& pairs)
    : sheets_(sheets)
    , votes_(votes)
    , unturned_(surface.triangles.size())
    , volume_(surface.triangles.size())
    , size_(surface.triangles.size())
    , isBody_(surface.triangles.size())
  {
    const Point base = surface.corners(0)[0];
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
      const int direction = sheets.turned(t) ? -1 : 1;
      const Corners c = surface.corners(t);
      unturned_[sheets.of(t)] += direction;
      volume_[sheets.of(t)] +=
        direction * dot(minus(c[0], base), cross(minus(c[1], c[0]), minus(c[2], c[0])));
      ++size_[sheets.of(t)];
    }
    findBodies(pairs);
  }

  // A tie between the votes on a sheet that does not pass through others.
  bool isUndecided(std::uint32_t sheet) const
  {
    return votes_.outward[sheet] == votes_.inward[sheet] && !passesThroughOthers(sheet);
  }

  // Whether the sheet's first triangle must be reversed.
  bool turns(std::uint32_t sheet) const
  {
    if (passesThroughOthers(sheet))
    {
      return volume_[sheet] < 0;
    }
    return isUndecided(sheet) ? unturned_[sheet] < 0 : votes_.outward[sheet] < votes_.inward[sheet];
  }

private:
  // 1 if a closed sheet was given with its normals outward, -1 inward, 0 if neither.
  int givenWay(std::uint32_t sheet) const
  {
    const long long size = size_[sheet];
    const long long way = unturned_[sheet];
    return !sheets_.closed(sheet) || std::abs(way) != size || volume_[sheet] == 0
      ? 0
      : ((volume_[sheet] > 0) == (way > 0) ? 1 : -1);
  }

  // Closed sheets that cross others which were given alike.
  void findBodies(const std::vector<TrianglePair>& pairs)
  {
    std::vector<std::uint8_t> crossesUnlike(isBody_.size());
    for (const TrianglePair& pair : pairs)
    {
      const std::uint32_t a = sheets_.of(pair.first);
      const std::uint32_t b = sheets_.of(pair.second);
      if (a != b && pair.contact == Contact::Crossing)
      {
        const bool alike = givenWay(a) != 0 && givenWay(a) == givenWay(b);
        (alike ? isBody_ : crossesUnlike)[a] = 1;
        (alike ? isBody_ : crossesUnlike)[b] = 1;
      }
    }
    for (std::size_t s = 0; s < isBody_.size(); ++s)
    {
      isBody_[s] = isBody_[s] != 0 && crossesUnlike[s] == 0 ? 1 : 0;
    }
  }

  bool passesThroughOthers(std::uint32_t sheet) const
  {
    if (isBody_[sheet] != 0)
    {
      return true;
    }
    const long long fewer = std::min(votes_.outward[sheet], votes_.inward[sheet]);
    return sheets_.closed(sheet) && fewer > 0 &&
      VotesPerDissent * fewer >= votes_.outward[sheet] + votes_.inward[sheet];
  }

  const Sheets& sheets_;
  const Votes& votes_;
  std::vector<long long>
    unturned_;                  // triangles that face as the sheet's first minus those that do not
  std::vector<double> volume_;  // six times, with all triangles facing as the first
  std::vector<long long> size_; // triangles
  std::vector<std::uint8_t> isBody_; // by itself
};

}

void orient(Surface& surface, const TrianglePairs& pairs, Execution& execution)
{
  const std::size_t count = surface.triangles.size();
  const Sheets sheets(surface, SurfaceEdges(surface, execution));
  Votes votes(count);
  std::array<std::vector<VotingLine>, 3> lines = findVotingLines(surface, sheets, execution);
  for (int along = 0; along < 3; ++along)
  {
    vote(surface, sheets, along, lines[static_cast<std::size_t>(along)], votes, execution);
  }
  const Verdict verdict(surface, sheets, votes, pairs.pairs);
  for (std::size_t t = 0; t < count; ++t)
  {
    if (sheets.turned(t) != verdict.turns(sheets.of(t)))
    {
      turn(surface, t);
    }
  }
  if (volumeOf(surface) < 0)
  {
    for (std::size_t t = 0; t < count; ++t)
    {
      if (verdict.isUndecided(sheets.of(t)))
      {
        turn(surface, t);
      }
    }
  }
}

}
