// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/Orientation.h"

#include "Lattice/Vector.h"
#include "Surface/Components.h"
#include "Surface/LineCrossings.h"
#include "Surface/SurfaceEdges.h"

#include <cmath>
#include <tuple>

namespace cartesian
{

namespace
{

constexpr std::size_t TrianglesAChunk = 2048;

// Of a sheet that lines are laid through: enough to outvote those that pass where the surface is at
// fault.
constexpr std::size_t FewestTriangles = 12;
constexpr std::size_t MostTriangles = 63;
constexpr std::size_t PartOfTriangles = 256;

// Tests of a line against a triangle in all; beyond it lines are given up, those of small
// triangles first. A soup of a million large triangles would take days.
constexpr double MostTests = 5e6;
constexpr double LeastReduction = 1.25; // at once

constexpr double MostGridCells = 1024; // a direction

// A closed sheet with as large a part of its votes on either side passes through others.
constexpr long long PartThatCrosses = 4;

// Triangles by sheet, and how each is turned against the sheet's first: disjoint sets.
class Sheets
{
public:
  Sheets(const Surface& surface, const SurfaceEdges& edges)
    : parent_(surface.triangles.size())
    , turned_(surface.triangles.size())
    , open_(surface.triangles.size())
  {
    for (std::size_t t = 0; t < parent_.size(); ++t)
    {
      parent_[t] = static_cast<std::uint32_t>(t);
    }
    edges.forEach([&](std::uint32_t, const EdgeUse* begin, const EdgeUse* end) {
      if (end - begin == 2)
      {
        join(begin[0].triangle(), begin[1].triangle(), begin[0].down() == begin[1].down());
      }
    });
    joinAsGiven(surface, edges);
    for (std::size_t t = 0; t < parent_.size(); ++t)
    {
      flatten(static_cast<std::uint32_t>(t));
    }
    edges.forEach([&](std::uint32_t, const EdgeUse* begin, const EdgeUse* end) {
      for (const EdgeUse* use = begin; use != end; ++use)
      {
        const std::uint32_t sheet = of(use->triangle());
        open_[sheet] = open_[sheet] | (netUse(sheet, begin, end) != 0 ? 1 : 0);
      }
    });
  }

  std::uint32_t of(std::size_t triangle) const { return parent_[triangle]; }
  bool closed(std::uint32_t sheet) const { return open_[sheet] == 0; }
  bool turned(std::size_t triangle) const { return turned_[triangle] != 0; }

private:
  // Joins sheets that need each other to close, where all triangles of a component were given a
  // consistent direction.
  void joinAsGiven(const Surface& surface, const SurfaceEdges& edges)
  {
    bool any = false;
    edges.forEach([&](std::uint32_t, const EdgeUse* begin, const EdgeUse* end) {
      any = any || end - begin > 2;
    });
    if (!any)
    {
      return;
    }
    DisjointSets components = connectedComponents(surface);
    std::vector<std::uint8_t> inconsistent(surface.vertices.size());
    edges.forEach([&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
      const auto down = std::count_if(begin, end, [](const EdgeUse& use) { return use.down(); });
      if (std::abs((end - begin) - 2 * down) > (end - begin) % 2)
      {
        inconsistent[components.find(lower)] = 1;
      }
    });
    edges.forEach([&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
      if ((end - begin) % 2 == 1 || end - begin == 2 || inconsistent[components.find(lower)] != 0)
      {
        return;
      }
      const EdgeUse* before = nullptr;
      for (const EdgeUse* use = begin; use != end; ++use)
      {
        if (netUse(flatten(use->triangle()), begin, end) != 0)
        {
          if (before)
          {
            join(before->triangle(), use->triangle(), false);
          }
          before = use;
        }
      }
    });
  }

  // How much more often the triangles of a sheet run down an edge than up, as its first one turns them.
  int netUse(std::uint32_t sheet, const EdgeUse* begin, const EdgeUse* end)
  {
    int net = 0;
    for (const EdgeUse* use = begin; use != end; ++use)
    {
      if (flatten(use->triangle()) == sheet)
      {
        net += use->down() != turned(use->triangle()) ? 1 : -1;
      }
    }
    return net;
  }

  // Points a triangle straight at its root; the paths to it stay short.
  std::uint32_t flatten(std::uint32_t t)
  {
    std::uint32_t root = t;
    std::uint8_t turned = 0;
    while (parent_[root] != root)
    {
      turned ^= turned_[root];
      root = parent_[root];
    }
    while (parent_[t] != root && t != root)
    {
      const std::uint32_t next = parent_[t];
      const std::uint8_t own = turned_[t];
      parent_[t] = root;
      turned_[t] = turned;
      turned ^= own;
      t = next;
    }
    return root;
  }

  // The lower root wins. A contradiction (a Moebius band) stays where it is found.
  void join(std::uint32_t a, std::uint32_t b, bool opposite)
  {
    const std::uint32_t rootA = flatten(a);
    const std::uint32_t rootB = flatten(b);
    const auto between =
      static_cast<std::uint8_t>(turned_[a] ^ turned_[b] ^ static_cast<std::uint8_t>(opposite));
    if (rootA != rootB)
    {
      const auto [low, high] = std::minmax(rootA, rootB);
      parent_[high] = low;
      turned_[high] = between;
    }
  }

  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> turned_; // against the parent; a root is not
  std::vector<std::uint8_t> open_;   // of roots: an edge of other than two triangles bounds it
};

// What the votes say of each sheet.
struct Poll
{
  std::vector<long long> outward; // that its first triangle has an outward normal
  std::vector<long long> inward;

  explicit Poll(std::size_t sheets)
    : outward(sheets)
    , inward(sheets)
  {
  }
};

// A line along axes.along through a triangle, and how much it counts for.
struct Line
{
  Level middle;
  Level outer;
  std::size_t rank; // among the lines of its sheet
  Wide area;        // of the triangle, projected along the line, twice
  std::array<std::uint32_t, 3> triangle;

  bool operator<(const Line& other) const
  {
    return rank != other.rank ? rank < other.rank
                              : std::make_tuple(other.area, triangle, middle, outer) <
        std::make_tuple(area, other.triangle, other.middle, other.outer);
  }
};

Wide magnitude(Wide x)
{
  return x < 0 ? -x : x;
}

Level evenNear(double level)
{
  return static_cast<Level>(2 * std::llround(level / 2));
}

// The line of even levels nearest to the point of a triangle that is nearest to one of its corners of
// those three that share out its area, if it passes through the triangle.
bool findLine(const Corners& c, const RowAxes& axes, std::size_t corner, Line& line)
{
  const auto weighted = [&](int axis) {
    return (double(c[0][axis]) + c[1][axis] + c[2][axis] + 3.0 * c[corner][axis]) / 6;
  };
  const auto [least, most] = std::minmax({ c[0][axes.outer], c[1][axes.outer], c[2][axes.outer] });
  line.outer = evenNear(weighted(axes.outer));
  if (line.outer < least || line.outer > most)
  {
    return false;
  }
  const auto [from, to, up] = crossedLevels(c, axes, line.outer);
  line.middle = evenNear(weighted(axes.middle));
  return line.middle > from && line.middle < to;
}

// Triangles of each sheet, by size; lines through the largest.
class LineFinder
{
public:
  LineFinder(const Surface& surface, const Sheets& sheets, Execution& execution)
    : surface_(surface)
    , best_(surface.triangles.size())
  {
    execution.forEach(best_.size(), TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t)
      {
        best_[t] = bestOf(t);
      }
    });
    std::vector<std::size_t> start(best_.size() + 1);
    for (std::size_t t = 0; t < best_.size(); ++t)
    {
      ++start[sheets.of(t)];
    }
    scan(start);
    std::vector<std::uint32_t> triangles(best_.size());
    std::vector<std::size_t> next(start.begin(), start.end() - 1);
    for (std::size_t t = 0; t < best_.size(); ++t)
    {
      triangles[next[sheets.of(t)]++] = static_cast<std::uint32_t>(t);
    }
    for (std::size_t s = 0; s < best_.size(); ++s)
    {
      addLines(triangles.data() + start[s], triangles.data() + start[s + 1]);
    }
  }

  std::array<std::vector<Line>, 3>& lines() { return lines_; }

private:
  struct Best
  {
    Wide area = 0;
    int axis = 0;
  };

  Best bestOf(std::size_t triangle) const
  {
    Best best;
    const std::array<Wide, 3> normal = exactNormal(surface_.corners(triangle));
    for (int axis = 0; axis < 3; ++axis)
    {
      const Wide area = magnitude(normal[axis]);
      best = area > best.area ? Best{ area, axis } : best;
    }
    return best;
  }

  void addLines(std::uint32_t* begin, std::uint32_t* end)
  {
    const auto size = static_cast<std::size_t>(end - begin);
    const std::size_t wanted =
      std::min(size, std::clamp(size / PartOfTriangles, FewestTriangles, MostTriangles));
    std::uint32_t* const last = begin + wanted;
    std::partial_sort(begin, last, end, [&](std::uint32_t a, std::uint32_t b) {
      return best_[a].area != best_[b].area ? best_[a].area > best_[b].area : sorted(a) < sorted(b);
    });
    for (const std::uint32_t* t = begin; t != last; ++t)
    {
      for (std::size_t corner = 0; best_[*t].area > 0 && corner < 3; ++corner)
      {
        Line line{};
        const auto axis = static_cast<std::size_t>(best_[*t].axis);
        if (findLine(surface_.corners(*t), RowsAlong[axis], corner, line))
        {
          line.rank = static_cast<std::size_t>(t - begin);
          line.area = best_[*t].area;
          line.triangle = sorted(*t);
          lines_[axis].push_back(line);
        }
      }
    }
  }

  std::array<std::uint32_t, 3> sorted(std::uint32_t triangle) const
  {
    std::array<std::uint32_t, 3> v = surface_.triangles[triangle];
    std::sort(v.begin(), v.end());
    return v;
  }

  const Surface& surface_;
  std::vector<Best> best_; // of each triangle: its largest projection
  std::array<std::vector<Line>, 3> lines_;
};

// Lines along one axis, in a grid across it that tells which of them may cross a triangle.
class LineGrid
{
public:
  LineGrid(const Surface& surface, int along, std::vector<Line>& lines)
    : axes_(RowsAlong[static_cast<std::size_t>(along)])
    , lines_(lines)
  {
    std::sort(lines_.begin(), lines_.end());
    Bounds bounds = Bounds::none();
    for (const Line& line : lines_)
    {
      bounds.include(0, line.middle);
      bounds.include(1, line.outer);
    }
    low_ = { bounds.low[0], bounds.low[1] };
    for (std::size_t i = 0; i < 2; ++i)
    {
      size_[i] = std::max(bounds.high[i] - bounds.low[i], 1.0);
    }
    double excess = 1;
    while (file(), excess = tests(surface) / MostTests, excess > 1)
    {
      lines_.resize(static_cast<std::size_t>(
        static_cast<double>(lines_.size()) / std::max(excess, LeastReduction)));
    }
  }

  // Calls visit(line) with the numbers of the lines that cross a triangle.
  template <class Visitor>
  void forEachLine(const Corners& c, Visitor&& visit) const
  {
    const auto [least, most] =
      std::minmax({ c[0][axes_.outer], c[1][axes_.outer], c[2][axes_.outer] });
    const Range range = rangeOf(c);
    for (std::size_t o = range.first[1]; o < range.end[1]; ++o)
    {
      for (std::size_t m = range.first[0]; m < range.end[0]; ++m)
      {
        const std::size_t cell = m + o * cells_;
        for (std::size_t i = start_[cell]; i < start_[cell + 1]; ++i)
        {
          const Line& line = lines_[number_[i]];
          if (line.outer > least && line.outer < most)
          {
            const auto [from, to, up] = crossedLevels(c, axes_, line.outer);
            if (line.middle > from && line.middle < to)
            {
              visit(number_[i]);
            }
          }
        }
      }
    }
  }

  Point at(std::uint32_t line) const
  {
    Point p{};
    p[axes_.middle] = lines_[line].middle;
    p[axes_.outer] = lines_[line].outer;
    return p;
  }

private:
  struct Range
  {
    std::array<std::size_t, 2> first{ 0, 0 };
    std::array<std::size_t, 2> end{ 0, 0 };
  };

  std::size_t cellAt(std::size_t direction, double level) const
  {
    const double cell = (level - low_[direction]) / size_[direction] * static_cast<double>(cells_);
    return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(cells_ - 1)));
  }

  Range rangeOf(const Corners& c) const
  {
    Range range;
    for (std::size_t i = 0; i < 2; ++i)
    {
      const int axis = i == 0 ? axes_.middle : axes_.outer;
      const auto [least, most] = std::minmax({ c[0][axis], c[1][axis], c[2][axis] });
      if (most < low_[i] || least > low_[i] + size_[i])
      {
        return {};
      }
      range.first[i] = cellAt(i, least);
      range.end[i] = cellAt(i, most) + 1;
    }
    return range;
  }

  void file()
  {
    const auto count = static_cast<double>(lines_.size());
    cells_ = static_cast<std::size_t>(std::clamp(std::sqrt(count), 1.0, MostGridCells));
    start_.assign(cells_ * cells_ + 1, 0);
    const auto cellOf = [&](const Line& line) {
      return cellAt(0, line.middle) + cells_ * cellAt(1, line.outer);
    };
    for (const Line& line : lines_)
    {
      ++start_[cellOf(line)];
    }
    number_.resize(scan(start_));
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for (std::size_t n = 0; n < lines_.size(); ++n)
    {
      number_[next[cellOf(lines_[n])]++] = static_cast<std::uint32_t>(n);
    }
  }

  // How many lines and empty cells all triangles would be tested against.
  double tests(const Surface& surface) const
  {
    // Lines in the cells left of and below each corner of a cell.
    const std::size_t corners = cells_ + 1;
    std::vector<std::size_t> below(corners * corners);
    for (std::size_t o = 0; o < cells_; ++o)
    {
      for (std::size_t m = 0; m < cells_; ++m)
      {
        const std::size_t at = m + o * corners;
        const std::size_t here = start_[m + o * cells_ + 1] - start_[m + o * cells_];
        below[at + corners + 1] = here + below[at + corners] + below[at + 1] - below[at];
      }
    }
    std::size_t sum = 0;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
      const Range range = rangeOf(surface.corners(t));
      const std::size_t low = range.first[1] * corners;
      const std::size_t high = range.end[1] * corners;
      sum += (range.end[0] - range.first[0]) * (range.end[1] - range.first[1]) +
        below[range.end[0] + high] - below[range.first[0] + high] - below[range.end[0] + low] +
        below[range.first[0] + low];
    }
    return static_cast<double>(sum);
  }

  const RowAxes axes_;
  std::vector<Line>& lines_;
  std::size_t cells_ = 1; // a direction
  std::array<double, 2> low_{};
  std::array<double, 2> size_{};
  std::vector<std::size_t> start_;
  std::vector<std::uint32_t> number_; // of the lines in each cell
};

// A triangle's crossing with a line.
struct Vote
{
  std::uint32_t line;
  Level level;
  std::uint32_t triangle;
  bool up; // the normal's direction along the line

  bool operator<(const Vote& other) const
  {
    return level != other.level ? level < other.level : triangle < other.triangle;
  }
};

// Of the crossings of one line.
void countVotes(const Vote* begin, const Vote* end, const Sheets& sheets, Poll& poll)
{
  if ((end - begin) % 2 == 1)
  {
    return; // it passes through a hole
  }
  for (const Vote* vote = begin; vote != end; ++vote)
  {
    if ((vote != begin && vote[-1].level == vote->level) ||
      (vote + 1 != end && vote[1].level == vote->level))
    {
      continue;
    }
    const bool entering = (vote - begin) % 2 == 0;
    const bool outward = entering != vote->up;
    auto& votes = outward != sheets.turned(vote->triangle) ? poll.outward : poll.inward;
    ++votes[sheets.of(vote->triangle)];
  }
}

void vote(const Surface& surface, const Sheets& sheets, int along, std::vector<Line>& lines,
  Poll& poll, Execution& execution)
{
  if (lines.empty())
  {
    return;
  }
  const LineGrid grid(surface, along, lines);
  const std::size_t count = surface.triangles.size();
  std::vector<std::vector<Vote>> found(chunks(count, TrianglesAChunk));
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
  const Buckets<Vote> votes = sortIntoBuckets(
    found, lines.size(), [](const Vote& v) { return v.line; }, execution);
  for (std::size_t line = 0; line < lines.size(); ++line)
  {
    countVotes(votes.begin(line), votes.end(line), sheets, poll);
  }
}

void turn(Surface& surface, std::size_t triangle)
{
  std::swap(surface.triangles[triangle][1], surface.triangles[triangle][2]);
}

}

void orient(Surface& surface, Execution& execution)
{
  const std::size_t count = surface.triangles.size();
  const Sheets sheets(surface, SurfaceEdges(surface, execution));
  Poll poll(count);
  LineFinder finder(surface, sheets, execution);
  for (int along = 0; along < 3; ++along)
  {
    vote(surface, sheets, along, finder.lines()[static_cast<std::size_t>(along)], poll, execution);
  }
  std::vector<long long> unturned(count);
  const Point base = surface.corners(0)[0];
  std::vector<double> volume(count); // six times, as the first triangle is turned
  for (std::size_t t = 0; t < count; ++t)
  {
    unturned[sheets.of(t)] += sheets.turned(t) ? -1 : 1;
    const Corners c = surface.corners(t);
    volume[sheets.of(t)] += (sheets.turned(t) ? -1 : 1) *
      dot(minus(c[0], base), cross(minus(c[1], c[0]), minus(c[2], c[0])));
  }
  const auto crosses = [&](std::uint32_t sheet) {
    const long long fewer = std::min(poll.outward[sheet], poll.inward[sheet]);
    return sheets.closed(sheet) && fewer > 0 &&
      PartThatCrosses * fewer >= poll.outward[sheet] + poll.inward[sheet];
  };
  const auto undecided = [&](std::uint32_t sheet) {
    return poll.outward[sheet] == poll.inward[sheet] && !crosses(sheet);
  };
  for (std::size_t t = 0; t < count; ++t)
  {
    const std::uint32_t sheet = sheets.of(t);
    const bool turnSheet = crosses(sheet) ? volume[sheet] < 0
      : undecided(sheet)                  ? unturned[sheet] < 0
                                          : poll.outward[sheet] < poll.inward[sheet];
    if (sheets.turned(t) != turnSheet)
    {
      turn(surface, t);
    }
  }
  if (volumeOf(surface) < 0)
  {
    for (std::size_t t = 0; t < count; ++t)
    {
      if (undecided(sheets.of(t)))
      {
        turn(surface, t);
      }
    }
  }
}

}
