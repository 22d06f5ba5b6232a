// SPDX-License-Identifier: BSD-3-Clause
#include "Faces/FlawedBoxes.h"

#include "Faces/LoopPatches.h"

#include <map>
#include <tuple>

namespace cartesian
{

namespace
{

// How far a chord between crossings of one line bends into the side, as a part of the side's width.
constexpr int BendPart = 8;

constexpr std::size_t SidesAChunk = 256;
constexpr std::size_t BoxesAChunk = 64;

// What one side sees on a line between neighbouring grid nodes: crossings[first, end), upward.
struct Sight
{
  std::uint32_t low;
  std::uint32_t high;
  std::uint32_t side;
  std::uint32_t first;
  std::uint32_t end;

  bool sameLine(const Sight& other) const { return low == other.low && high == other.high; }
  bool operator<(const Sight& other) const
  {
    return std::tie(low, high, side) < std::tie(other.low, other.high, other.side);
  }
};

struct LineCrossing
{
  std::uint32_t node;
  int change; // of the status, upward

  bool operator==(const LineCrossing& other) const
  {
    return node == other.node && change == other.change;
  }
};

// A line that does not keep its crossings.
struct NewLine
{
  std::uint32_t low;
  std::uint32_t high;
  LineCrossing crossing; // or None

  bool operator<(const NewLine& other) const
  {
    return std::tie(low, high) < std::tie(other.low, other.high);
  }
};

// A crossing on the border of a side, counter-clockwise.
struct RingCrossing
{
  std::uint32_t node;
  int change;
  int border;
};

// What is seen of one side after the other.
struct SideView
{
  std::vector<SideEdge> chords;
  std::vector<BorderNode> border;
  std::vector<RingCrossing> ring;
  std::vector<std::uint8_t> scratch;
};

// The lines around a chunk of sides.
struct SeenLines
{
  std::vector<Sight> sights;
  std::vector<LineCrossing> crossings;
  std::vector<std::pair<std::uint32_t, Known>> statuses; // of grid nodes
};

class Rebuilder
{
public:
  Rebuilder(const Boxes& boxes, const Patches& patches, const Sides& sides, const Nodes& nodes,
    const InnerFaces& inner, const std::vector<std::uint8_t>& flawed, GivenUp givenUp,
    Execution& execution)
    : boxes_(boxes)
    , patches_(patches)
    , sides_(sides)
    , nodes_(nodes)
    , inner_(inner)
    , flawed_(flawed)
    , givenUp_(givenUp)
    , execution_(execution)
    , sideChords_(boxes, patches, sides, nodes)
  {
  }

  RebuiltPatches rebuild()
  {
    findNearSides();
    lookAtLines();
    inferStatuses();
    judgeLines();
    judgeSides();
    RebuiltPatches result;
    result.boxes = flawed_;
    for (const std::uint32_t s : changed_)
    {
      for (const std::uint32_t box : { sides_.common[s].low, sides_.common[s].high })
      {
        if (const std::uint32_t n = sides_.polyhedralOrdinal(box); n != None)
        {
          result.boxes[n] = 1;
        }
      }
    }
    writePatches(result);
    return result;
  }

private:
  const Point& at(std::uint32_t node) const
  {
    return node < nodes_.at.size() ? nodes_.at[node] : added_[node - nodes_.at.size()];
  }

  bool isGrid(std::uint32_t node) const
  {
    return node >= nodes_.patchPoints && node < nodes_.at.size();
  }

  bool isOfFlawed(std::uint32_t s) const
  {
    const Side& side = sides_.common[s];
    const auto is = [&](std::uint32_t box) {
      const std::uint32_t n = sides_.polyhedralOrdinal(box);
      return n != None && flawed_[n] != 0;
    };
    return is(side.low) || is(side.high);
  }

  template <class Visitor>
  void forEachBorderNode(std::uint32_t s, Visitor&& visit) const
  {
    for (std::size_t i = nodes_.borderStart[s]; i < nodes_.borderStart[s + 1]; ++i)
    {
      visit(nodes_.border[i]);
    }
  }

  // The sides that touch a flawed box.
  void findNearSides()
  {
    std::vector<std::uint8_t> near(nodes_.at.size());
    const auto count = static_cast<std::uint32_t>(sides_.common.size());
    for (std::uint32_t s = 0; s < count; ++s)
    {
      if (isOfFlawed(s))
      {
        forEachBorderNode(s, [&](std::uint32_t node) { near[node] = 1; });
      }
    }
    for (std::uint32_t s = 0; s < count; ++s)
    {
      bool touches = false;
      forEachBorderNode(s, [&](std::uint32_t node) { touches = touches || near[node] != 0; });
      if (touches)
      {
        nearSides_.push_back(s);
      }
    }
  }

  // The net chords of a side as its patches have them, and its border.
  void look(std::uint32_t s, const Rectangle& r, SideView& view) const
  {
    sideChords_.find(s, r, view.chords);
    dropOpposite(view.chords, view.scratch);
    listBorder(nodes_.at, r, view.chords, view.border);
  }

  // The grid node after border[i], or the end.
  std::size_t nextGridNode(const std::vector<BorderNode>& border, std::size_t i) const
  {
    std::size_t next = i + 1;
    while (next < border.size() && !isGrid(border[next].node))
    {
      ++next;
    }
    return next;
  }

  void lookAtLines()
  {
    std::vector<SeenLines> seen(chunks(nearSides_.size(), SidesAChunk));
    execution_.forEach(nearSides_.size(), SidesAChunk, [&](std::size_t begin, std::size_t end) {
      SideView view;
      for (std::size_t i = begin; i < end; ++i)
      {
        lookAround(nearSides_[i], view, seen[begin / SidesAChunk]);
      }
    });
    status_.assign(nodes_.at.size(), static_cast<std::int8_t>(Known::Nothing));
    for (const SeenLines& part : seen)
    {
      for (const auto& [node, known] : part.statuses)
      {
        status_[node] = static_cast<std::int8_t>(known);
      }
      const auto before = static_cast<std::uint32_t>(crossings_.size());
      crossings_.insert(crossings_.end(), part.crossings.begin(), part.crossings.end());
      for (Sight sight : part.sights)
      {
        sight.first += before;
        sight.end += before;
        sights_.push_back(sight);
      }
    }
    std::sort(sights_.begin(), sights_.end());
  }

  void lookAround(std::uint32_t s, SideView& view, SeenLines& seen) const
  {
    look(s, sideChords_.rectangle(s), view);
    const std::vector<BorderNode>& border = view.border;
    for (std::size_t i = 0; i < border.size();)
    {
      if (border[i].known != Known::Nothing && isGrid(border[i].node))
      {
        seen.statuses.emplace_back(border[i].node, border[i].known);
      }
      const std::size_t next = nextGridNode(border, i);
      addSight(s, border, i, next, seen);
      i = next;
    }
  }

  // The line between the grid nodes border[i] and border[next].
  static void addSight(std::uint32_t s, const std::vector<BorderNode>& border, std::size_t i,
    std::size_t next, SeenLines& seen)
  {
    std::vector<LineCrossing>& crossings = seen.crossings;
    Sight sight;
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
                      [](const LineCrossing& crossing) { return crossing.change == 0; }),
      crossings.end());
    if (border[i].border >= 2)
    {
      std::swap(sight.low, sight.high);
      std::reverse(begin, crossings.end());
      std::for_each(begin, crossings.end(), [](LineCrossing& c) { c.change = -c.change; });
    }
    sight.end = static_cast<std::uint32_t>(crossings.size());
    seen.sights.push_back(sight);
  }

  int changeAlong(const Sight& sight) const
  {
    int sum = 0;
    for (std::uint32_t c = sight.first; c < sight.end; ++c)
    {
      sum += crossings_[c].change;
    }
    return sum;
  }

  // Nodes that are no corner of any box, only the ends of lines between boxes, have the status that
  // the crossings lead to.
  void inferStatuses()
  {
    for (bool changed = true; changed;)
    {
      changed = false;
      for (const Sight& sight : sights_)
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

  bool leadsOn(const Sight& sight) const
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

  bool seesTheSame(const Sight& a, const Sight& b) const
  {
    return std::equal(crossings_.begin() + a.first, crossings_.begin() + a.end,
      crossings_.begin() + b.first, crossings_.begin() + b.end);
  }

  void judgeLines()
  {
    sideChanges_.assign(sides_.common.size(), 0);
    for (auto begin = sights_.cbegin(); begin != sights_.cend();)
    {
      const auto end = std::find_if(
        begin, sights_.cend(), [&](const Sight& sight) { return !sight.sameLine(*begin); });
      const bool ofFlawed =
        std::any_of(begin, end, [&](const Sight& sight) { return isOfFlawed(sight.side); });
      const bool keeps = (givenUp_ != GivenUp::Crossings || begin->end - begin->first < 2) &&
        std::all_of(begin, end,
          [&](const Sight& sight) { return seesTheSame(sight, *begin) && leadsOn(sight); });
      if (ofFlawed && !keeps)
      {
        newLines_.push_back({ begin->low, begin->high, newCrossing(begin, end) });
        std::for_each(begin, end, [&](const Sight& sight) { sideChanges_[sight.side] = 1; });
      }
      begin = end;
    }
  }

  // The middle one of the crossings that change the status as it has to, or of all, or a new point.
  template <class Iterator>
  LineCrossing newCrossing(Iterator begin, Iterator end)
  {
    const int change = status_[begin->high] - status_[begin->low];
    if (change == 0)
    {
      return { None, 0 };
    }
    std::vector<std::uint32_t> right;
    std::vector<std::uint32_t> all;
    for (Iterator sight = begin; sight != end; ++sight)
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
      return { addMiddle(begin->low, begin->high), change };
    }
    std::sort(
      from.begin(), from.end(), [&](std::uint32_t a, std::uint32_t b) { return at(a) < at(b); });
    return { from[from.size() / 2], change };
  }

  static Level oddMiddle(Level a, Level b)
  {
    const Level low = std::min(a, b);
    return (low + (std::max(a, b) - low) / 2) | 1;
  }

  std::uint32_t addMiddle(std::uint32_t low, std::uint32_t high)
  {
    Point p = at(low);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      p[axis] = p[axis] == at(high)[axis] ? p[axis] : oddMiddle(p[axis], at(high)[axis]);
    }
    return addPoint(p);
  }

  // A patch may have a corner there already.
  std::uint32_t addPoint(const Point& p)
  {
    if (byPlace_.empty())
    {
      for (std::uint32_t node = 0; node < nodes_.patchPoints; ++node)
      {
        byPlace_.emplace_hint(byPlace_.end(), nodes_.at[node], node);
      }
    }
    const auto next = static_cast<std::uint32_t>(nodes_.at.size() + added_.size());
    const auto [place, isNew] = byPlace_.emplace(p, next);
    if (isNew)
    {
      added_.push_back(p);
    }
    return place->second;
  }

  void judgeSides()
  {
    newChordsOf_.assign(sides_.common.size(), None);
    for (const std::uint32_t s : nearSides_)
    {
      const bool forced = givenUp_ != GivenUp::Nothing && isOfFlawed(s);
      if (sideChanges_[s] != 0 || inner_.flawed[s] != 0 || forced)
      {
        newChordsOf_[s] = static_cast<std::uint32_t>(changed_.size());
        changed_.push_back(s);
      }
    }
    newChords_.resize(changed_.size());
    execution_.forEach(changed_.size(), SidesAChunk, [&](std::size_t begin, std::size_t end) {
      SideView view;
      for (std::size_t i = begin; i < end; ++i)
      {
        newChords_[i] = chordsBetweenCrossings(changed_[i], view);
      }
    });
    for (std::size_t i = 0; i < changed_.size(); ++i)
    {
      bendAlongBorder(sideChords_.rectangle(changed_[i]), newChords_[i]);
    }
  }

  // The crossings around a side, as far as they change the status in turns.
  void walkRound(std::uint32_t s, SideView& view) const
  {
    look(s, sideChords_.rectangle(s), view);
    view.ring.clear();
    int status = status_[view.border.front().node];
    const auto pass = [&](std::uint32_t node, int change, int border) {
      if (status + change == 0 || status + change == 1)
      {
        status += change;
        view.ring.push_back({ node, change, border });
      }
    };
    for (std::size_t i = 0; i < view.border.size();)
    {
      const std::size_t next = nextGridNode(view.border, i);
      passLine(view.border, i, next, pass);
      i = next;
    }
  }

  template <class Visitor>
  void passLine(
    const std::vector<BorderNode>& border, std::size_t i, std::size_t next, Visitor&& pass) const
  {
    const bool down = border[i].border >= 2;
    const std::uint32_t here = border[i].node;
    const std::uint32_t there = border[next < border.size() ? next : 0].node;
    const NewLine key{ down ? there : here, down ? here : there, { None, 0 } };
    const auto line = std::lower_bound(newLines_.begin(), newLines_.end(), key);
    if (line != newLines_.end() && !(key < *line))
    {
      if (line->crossing.node != None)
      {
        pass(line->crossing.node, down ? -line->crossing.change : line->crossing.change,
          border[i].border);
      }
      return;
    }
    for (std::size_t k = i + 1; k < next;)
    {
      int change = 0;
      const std::size_t first = k;
      for (; k < next && border[k].node == border[first].node; ++k)
      {
        change += border[k].change;
      }
      if (change != 0)
      {
        pass(border[first].node, change, border[i].border);
      }
    }
  }

  // Each crossing out of the inside is joined to the next one into it, or to the one before: as fewer
  // chords run along the border, then as they are shorter.
  std::vector<SideEdge> chordsBetweenCrossings(std::uint32_t s, SideView& view) const
  {
    walkRound(s, view);
    const std::vector<RingCrossing>& ring = view.ring;
    std::vector<SideEdge> best;
    std::pair<std::size_t, double> bestCost{ 0, 0 };
    const std::size_t n = ring.size() - ring.size() % 2;
    for (const std::size_t step : { std::size_t(1), n - 1 })
    {
      std::vector<SideEdge> chords;
      std::pair<std::size_t, double> cost{ 0, 0 };
      for (std::size_t i = 0; i < n; ++i)
      {
        const RingCrossing& out = ring[i];
        const RingCrossing& in = ring[(i + step) % n];
        if (out.change < 0)
        {
          chords.push_back({ out.node, in.node });
          cost.first += out.border == in.border ? 1 : 0;
          cost.second += norm(minus(at(out.node), at(in.node)));
        }
      }
      if (best.empty() || cost < bestCost)
      {
        best = chords;
        bestCost = cost;
      }
    }
    return best;
  }

  // A chord along the border would lie on the next side too.
  void bendAlongBorder(const Rectangle& r, std::vector<SideEdge>& chords)
  {
    const auto u = static_cast<std::size_t>(r.axis + 1) % 3;
    const auto v = static_cast<std::size_t>(r.axis + 2) % 3;
    const std::size_t count = chords.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      const Point& p = at(chords[i].from);
      const Point& q = at(chords[i].to);
      for (const std::size_t across : { u, v })
      {
        if (p[across] != q[across] || !onPlane(p[across]))
        {
          continue;
        }
        const std::size_t along = u + v - across;
        const auto low = static_cast<Level>(across == u ? r.low.a : r.low.b);
        const auto high = static_cast<Level>(across == u ? r.high.a : r.high.b);
        const Level length = std::max(p[along], q[along]) - std::min(p[along], q[along]);
        const Level depth = std::min(length / 2, (high - low) / BendPart) | 1;
        Point bend = p;
        bend[along] = oddMiddle(p[along], q[along]);
        bend[across] = p[across] == low ? low + depth : high - depth;
        const std::uint32_t node = addPoint(bend);
        chords.push_back({ node, chords[i].to });
        chords[i].to = node;
        break;
      }
    }
  }

  // The new patches of all boxes that get some, by chunks of these boxes.
  std::vector<Patches> makePatches(const std::vector<std::uint32_t>& rebuilt)
  {
    std::vector<Patches> parts(chunks(rebuilt.size(), BoxesAChunk));
    execution_.forEach(rebuilt.size(), BoxesAChunk, [&](std::size_t begin, std::size_t end) {
      LoopPatches maker(boxes_, patches_, sides_, nodes_, added_, newChordsOf_, newChords_);
      Patches& part = parts[begin / BoxesAChunk];
      part.start.push_back(0);
      for (std::size_t i = begin; i < end; ++i)
      {
        part.boxStart.push_back(part.triangle.size());
        maker.add(rebuilt[i], part);
      }
      part.boxStart.push_back(part.triangle.size());
    });
    return parts;
  }

  // Those of the i-th box of `from`.
  static void copyPatches(const Patches& from, std::size_t i, Patches& to)
  {
    for (std::size_t p = from.boxStart[i]; p < from.boxStart[i + 1]; ++p)
    {
      to.corners.insert(to.corners.end(), from.corners.begin() + std::ptrdiff_t(from.start[p]),
        from.corners.begin() + std::ptrdiff_t(from.start[p + 1]));
      to.start.push_back(to.corners.size());
      to.triangle.push_back(from.triangle[p]);
      to.boundary.push_back(from.boundary[p]);
    }
  }

  void writePatches(RebuiltPatches& result)
  {
    std::vector<std::uint32_t> rebuilt;
    for (std::uint32_t n = 0; n < sides_.polyhedral.size(); ++n)
    {
      if (sides_.patchBox[n] != None && result.boxes[n] != 0)
      {
        rebuilt.push_back(n);
      }
    }
    const std::vector<Patches> parts = makePatches(rebuilt);
    Patches& to = result.patches;
    to.start.push_back(0);
    std::size_t next = 0;
    for (std::uint32_t n = 0; n < sides_.polyhedral.size(); ++n)
    {
      const std::uint32_t box = sides_.patchBox[n];
      if (box == None)
      {
        continue;
      }
      to.boxStart.push_back(to.triangle.size());
      if (result.boxes[n] != 0)
      {
        copyPatches(parts[next / BoxesAChunk], next % BoxesAChunk, to);
        ++next;
      }
      else
      {
        copyPatches(patches_, box, to);
      }
    }
    to.boxStart.push_back(to.triangle.size());
    to.reason = patches_.reason;
    to.points.reserve(patches_.points.size() + added_.size());
    to.points = patches_.points;
    to.points.insert(to.points.end(), added_.begin(), added_.end());
  }

  const Boxes& boxes_;
  const Patches& patches_;
  const Sides& sides_;
  const Nodes& nodes_;
  const InnerFaces& inner_;
  const std::vector<std::uint8_t>& flawed_;
  GivenUp givenUp_;
  Execution& execution_;
  SideChords sideChords_;

  std::vector<std::uint32_t> nearSides_;
  std::vector<std::int8_t> status_; // of grid nodes near flawed boxes, or Known::Nothing
  std::vector<Sight> sights_;
  std::vector<LineCrossing> crossings_;
  std::vector<NewLine> newLines_;
  std::vector<Point> added_;               // numbered after the nodes
  std::map<Point, std::uint32_t> byPlace_; // patch points and added ones
  std::vector<std::uint8_t> sideChanges_;  // 1: a line around it is new
  std::vector<std::uint32_t> changed_;     // sides with new chords
  std::vector<std::uint32_t> newChordsOf_;
  std::vector<std::vector<SideEdge>> newChords_;
};

}

RebuiltPatches rebuildFlawedBoxes(const Boxes& boxes, const Patches& patches, const Sides& sides,
  const Nodes& nodes, const InnerFaces& inner, const std::vector<std::uint8_t>& flawed,
  GivenUp givenUp, Execution& execution)
{
  return Rebuilder(boxes, patches, sides, nodes, inner, flawed, givenUp, execution).rebuild();
}

}
