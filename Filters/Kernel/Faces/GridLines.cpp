// SPDX-License-Identifier: BSD-3-Clause
#include "Faces/GridLines.h"

#include "Base/Sorting.h"

#include <algorithm>
#include <atomic>

namespace cartesian
{

namespace
{

constexpr std::size_t SidesAChunk = 64;
constexpr std::size_t ManySides = 4096; // in a chunk, of all

}

void SideView::look(
  std::uint32_t side, const SideChords& sideChords, const std::vector<Point>& nodes)
{
  const Rectangle r = sideChords.rectangle(side);
  sideChords.find(side, r, chords);
  dropOpposite(chords, scratch);
  listBorder(nodes, r, chords, border);
}

void GridLines::judge(bool keepsSeveral, NewPoints& points, Execution& execution)
{
  findNearSides(execution);
  lookAtLines(execution);
  inferStatuses();
  sideChanges_.assign(sides_.common.size(), 0);
  const LineObservation* const last = sights_.data() + sights_.size();
  for (const LineObservation* begin = sights_.data(); begin != last;)
  {
    const LineObservation* const end = std::find_if(
      begin, last, [&](const LineObservation& sight) { return !sight.sameLine(*begin); });
    const bool ofFlawed =
      std::any_of(begin, end, [&](const LineObservation& sight) { return isOfFlawed(sight.side); });
    const bool keeps = (keepsSeveral || begin->end - begin->first < 2) &&
      std::all_of(begin, end,
        [&](const LineObservation& sight) { return seesTheSame(sight, *begin) && leadsOn(sight); });
    if (ofFlawed && !keeps)
    {
      newLines_.push_back({ begin->low, begin->high, newCrossing(begin, end, points) });
      std::for_each(
        begin, end, [&](const LineObservation& sight) { sideChanges_[sight.side] = 1; });
    }
    begin = end;
  }
}

bool GridLines::isOfFlawed(std::uint32_t s) const
{
  const Side& side = sides_.common[s];
  const auto is = [&](std::uint32_t box) {
    const std::uint32_t n = sides_.polyhedralOrdinal(box);
    return n != None && flawed_[n] != 0;
  };
  return is(side.low) || is(side.high);
}

template <class Visitor>
void GridLines::forEachBorderNode(std::uint32_t s, Visitor&& visit) const
{
  for (std::size_t i = nodes_.borderStart[s]; i < nodes_.borderStart[s + 1]; ++i)
  {
    visit(nodes_.border[i]);
  }
}

void GridLines::findNearSides(Execution& execution)
{
  std::vector<std::atomic<std::uint8_t>> near(nodes_.at.size());
  const std::size_t count = sides_.common.size();
  execution.forEach(count, ManySides, [&](std::size_t begin, std::size_t end) {
    for (auto s = static_cast<std::uint32_t>(begin); s < end; ++s)
    {
      if (isOfFlawed(s))
      {
        forEachBorderNode(
          s, [&](std::uint32_t node) { near[node].store(1, std::memory_order_relaxed); });
      }
    }
  });
  std::vector<std::vector<std::uint32_t>> parts(chunks(count, ManySides));
  execution.forEach(count, ManySides, [&](std::size_t begin, std::size_t end) {
    for (auto s = static_cast<std::uint32_t>(begin); s < end; ++s)
    {
      bool touches = false;
      forEachBorderNode(s, [&](std::uint32_t node) {
        touches = touches || near[node].load(std::memory_order_relaxed) != 0;
      });
      if (touches)
      {
        parts[begin / ManySides].push_back(s);
      }
    }
  });
  nearSides_ = concatenated(parts);
}

std::size_t GridLines::nextGridNode(const std::vector<BorderNode>& border, std::size_t i) const
{
  std::size_t next = i + 1;
  while (next < border.size() && !isGrid(border[next].node))
  {
    ++next;
  }
  return next;
}

void GridLines::lookAtLines(Execution& execution)
{
  std::vector<SeenLines> seen(chunks(nearSides_.size(), SidesAChunk));
  execution.forEach(nearSides_.size(), SidesAChunk, [&](std::size_t begin, std::size_t end) {
    SideView view;
    for (std::size_t i = begin; i < end; ++i)
    {
      lookAround(nearSides_[i], view, seen[begin / SidesAChunk]);
    }
  });
  status_.assign(nodes_.at.size(), static_cast<std::int8_t>(KnownStatus::Unknown));
  for (const SeenLines& ofChunk : seen)
  {
    for (const auto& [node, known] : ofChunk.statuses)
    {
      status_[node] = static_cast<std::int8_t>(known);
    }
    const auto before = static_cast<std::uint32_t>(crossings_.size());
    crossings_.insert(crossings_.end(), ofChunk.crossings.begin(), ofChunk.crossings.end());
    for (LineObservation sight : ofChunk.sights)
    {
      sight.first += before;
      sight.end += before;
      sights_.push_back(sight);
    }
  }
  sortAll(sights_, execution);
}

void GridLines::lookAround(std::uint32_t s, SideView& view, SeenLines& seen) const
{
  view.look(s, sideChords_, nodes_.at);
  const std::vector<BorderNode>& border = view.border;
  for (std::size_t i = 0; i < border.size();)
  {
    if (border[i].known != KnownStatus::Unknown && isGrid(border[i].node))
    {
      seen.statuses.emplace_back(border[i].node, border[i].known);
    }
    const std::size_t next = nextGridNode(border, i);
    addSight(s, border, i, next, seen);
    i = next;
  }
}

// Adds the line between the grid nodes border[i] and border[next].
void GridLines::addSight(std::uint32_t s, const std::vector<BorderNode>& border, std::size_t i,
  std::size_t next, SeenLines& seen)
{
  std::vector<StatusChange>& crossings = seen.crossings;
  LineObservation sight;
  sight.low = border[i].node;
  sight.high = border[next < border.size() ? next : 0].node;
  sight.side = s;
  sight.first = static_cast<std::uint32_t>(crossings.size());
  for (std::size_t k = i + 1; k < next; ++k)
  {
    if (crossings.size() > sight.first && crossings.back().node == border[k].node)
    {
      crossings.back().change += border[k].change;
    }
    else
    {
      crossings.push_back({ border[k].node, border[k].change });
    }
  }
  const auto begin = crossings.begin() + sight.first;
  crossings.erase(std::remove_if(begin, crossings.end(),
                    [](const StatusChange& crossing) { return crossing.change == 0; }),
    crossings.end());
  if (border[i].border >= 2)
  {
    std::swap(sight.low, sight.high);
    std::reverse(begin, crossings.end());
    std::for_each(begin, crossings.end(), [](StatusChange& c) { c.change = -c.change; });
  }
  sight.end = static_cast<std::uint32_t>(crossings.size());
  seen.sights.push_back(sight);
}

int GridLines::changeAlong(const LineObservation& sight) const
{
  int sum = 0;
  for (std::uint32_t c = sight.first; c < sight.end; ++c)
  {
    sum += crossings_[c].change;
  }
  return sum;
}

// A node that is no corner of any box, only the end of a line between boxes, has the status to which the
// crossings lead.
void GridLines::inferStatuses()
{
  for (bool changed = true; changed;)
  {
    changed = false;
    for (const LineObservation& sight : sights_)
    {
      std::int8_t& low = status_[sight.low];
      std::int8_t& high = status_[sight.high];
      if ((low < 0) != (high < 0))
      {
        const int inferred = low < 0 ? high - changeAlong(sight) : low + changeAlong(sight);
        (low < 0 ? low : high) = static_cast<std::int8_t>(inferred > 0 ? 1 : 0);
        changed = true;
      }
    }
  }
}

// Whether the crossings lead from the status of one end to that of the other.
bool GridLines::leadsOn(const LineObservation& sight) const
{
  int status = status_[sight.low];
  for (std::uint32_t c = sight.first; c < sight.end; ++c)
  {
    status += crossings_[c].change;
    if (status < 0 || status > 1)
    {
      return false;
    }
  }
  return status == status_[sight.high];
}

bool GridLines::seesTheSame(const LineObservation& a, const LineObservation& b) const
{
  return std::equal(crossings_.begin() + a.first, crossings_.begin() + a.end,
    crossings_.begin() + b.first, crossings_.begin() + b.end);
}

// The middle one of the crossings that change the status as they should, or of all crossings, or a new
// point.
StatusChange GridLines::newCrossing(
  const LineObservation* begin, const LineObservation* end, NewPoints& points) const
{
  const int change = status_[begin->high] - status_[begin->low];
  if (change == 0)
  {
    return { None, 0 };
  }
  std::vector<std::uint32_t> right;
  std::vector<std::uint32_t> all;
  for (const LineObservation* sight = begin; sight != end; ++sight)
  {
    for (std::uint32_t c = sight->first; c < sight->end; ++c)
    {
      all.push_back(crossings_[c].node);
      if (crossings_[c].change == change)
      {
        right.push_back(crossings_[c].node);
      }
    }
  }
  std::vector<std::uint32_t>& from = right.empty() ? all : right;
  if (from.empty())
  {
    return { points.addMiddle(begin->low, begin->high), change };
  }
  std::sort(from.begin(), from.end(),
    [&](std::uint32_t a, std::uint32_t b) { return points.at(a) < points.at(b); });
  return { from[from.size() / 2], change };
}

const NewLine* GridLines::find(std::uint32_t low, std::uint32_t high) const
{
  const NewLine key{ low, high, { None, 0 } };
  const auto line = std::lower_bound(newLines_.begin(), newLines_.end(), key);
  return line == newLines_.end() || key < *line ? nullptr : &*line;
}

}
