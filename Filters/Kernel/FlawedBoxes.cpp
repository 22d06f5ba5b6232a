#include "FlawedBoxes.h"

#include "Loops.h"
#include "MarchingCubes.h"
#include "SideChords.h"

#include <map>
#include <tuple>

namespace cartesian
{

namespace
{

// How far a chord between crossings of one line bends into the side, as a part of the side's width.
constexpr int BendPart = 8;

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

class Rebuilder
{
public:
  Rebuilder(const Boxes& boxes, const Patches& patches, const Sides& sides, const Nodes& nodes,
    const InnerFaces& inner, const std::vector<std::uint8_t>& flawed, GivenUp givenUp)
    : boxes_(boxes)
    , patches_(patches)
    , sides_(sides)
    , nodes_(nodes)
    , inner_(inner)
    , flawed_(flawed)
    , givenUp_(givenUp)
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
      for (const std::uint32_t box : { sides_.sides[s].low, sides_.sides[s].high })
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
    const Side& side = sides_.sides[s];
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
    const auto count = static_cast<std::uint32_t>(sides_.sides.size());
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

  // The net chords of a side as its patches have them.
  void findChords(std::uint32_t s, const Rectangle& r)
  {
    sideChords_.find(s, r, chords_);
    dropOpposite(chords_, scratch_);
  }

  void lookAtLines()
  {
    status_.assign(nodes_.at.size(), static_cast<std::int8_t>(Known::Nothing));
    for (const std::uint32_t s : nearSides_)
    {
      const Rectangle r = sideChords_.rectangle(s);
      findChords(s, r);
      listBorder(nodes_.at, r, chords_, border_);
      for (std::size_t i = 0; i < border_.size();)
      {
        if (border_[i].known != Known::Nothing && isGrid(border_[i].node))
        {
          status_[border_[i].node] = static_cast<std::int8_t>(border_[i].known);
        }
        std::size_t next = i + 1;
        while (next < border_.size() && !isGrid(border_[next].node))
        {
          ++next;
        }
        addSight(s, i, next);
        i = next;
      }
    }
    std::sort(sights_.begin(), sights_.end());
  }

  // The line between the grid nodes border_[i] and border_[next].
  void addSight(std::uint32_t s, std::size_t i, std::size_t next)
  {
    Sight sight;
    sight.low = border_[i].node;
    sight.high = border_[next < border_.size() ? next : 0].node;
    sight.side = s;
    sight.first = static_cast<std::uint32_t>(crossings_.size());
    for (std::size_t k = i + 1; k < next; ++k)
    {
      if (crossings_.size() > sight.first && crossings_.back().node == border_[k].node)
      {
        crossings_.back().change += border_[k].change;
      }
      else
      {
        crossings_.push_back({ border_[k].node, border_[k].change });
      }
    }
    const auto begin = crossings_.begin() + sight.first;
    crossings_.erase(std::remove_if(begin, crossings_.end(),
                       [](const LineCrossing& crossing) { return crossing.change == 0; }),
      crossings_.end());
    if (border_[i].border >= 2)
    {
      std::swap(sight.low, sight.high);
      std::reverse(begin, crossings_.end());
      std::for_each(begin, crossings_.end(), [](LineCrossing& c) { c.change = -c.change; });
    }
    sight.end = static_cast<std::uint32_t>(crossings_.size());
    sights_.push_back(sight);
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
    sideChanges_.assign(sides_.sides.size(), 0);
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
    newChordsOf_.assign(sides_.sides.size(), None);
    for (const std::uint32_t s : nearSides_)
    {
      const bool forced = givenUp_ != GivenUp::Nothing && isOfFlawed(s);
      if (sideChanges_[s] != 0 || inner_.flawed[s] != 0 || forced)
      {
        newChordsOf_[s] = static_cast<std::uint32_t>(newChords_.size());
        changed_.push_back(s);
        newChords_.push_back(chordsBetweenCrossings(s));
      }
    }
  }

  // The crossings around a side, as far as they change the status in turns.
  void walkRound(std::uint32_t s, const Rectangle& r)
  {
    findChords(s, r);
    listBorder(nodes_.at, r, chords_, border_);
    ring_.clear();
    int status = status_[border_.front().node];
    const auto pass = [&](std::uint32_t node, int change, int border) {
      if (status + change == 0 || status + change == 1)
      {
        status += change;
        ring_.push_back({ node, change, border });
      }
    };
    for (std::size_t i = 0; i < border_.size();)
    {
      std::size_t next = i + 1;
      while (next < border_.size() && !isGrid(border_[next].node))
      {
        ++next;
      }
      passLine(i, next, pass);
      i = next;
    }
  }

  template <class Visitor>
  void passLine(std::size_t i, std::size_t next, Visitor&& pass)
  {
    const bool down = border_[i].border >= 2;
    const std::uint32_t here = border_[i].node;
    const std::uint32_t there = border_[next < border_.size() ? next : 0].node;
    const NewLine key{ down ? there : here, down ? here : there, { None, 0 } };
    const auto line = std::lower_bound(newLines_.begin(), newLines_.end(), key);
    if (line != newLines_.end() && !(key < *line))
    {
      if (line->crossing.node != None)
      {
        pass(line->crossing.node, down ? -line->crossing.change : line->crossing.change,
          border_[i].border);
      }
      return;
    }
    for (std::size_t k = i + 1; k < next;)
    {
      int change = 0;
      const std::size_t first = k;
      for (; k < next && border_[k].node == border_[first].node; ++k)
      {
        change += border_[k].change;
      }
      if (change != 0)
      {
        pass(border_[first].node, change, border_[i].border);
      }
    }
  }

  // Each crossing out of the inside is joined to the next one into it, or to the one before: as fewer
  // chords run along the border, then as they are shorter.
  std::vector<SideEdge> chordsBetweenCrossings(std::uint32_t s)
  {
    const Rectangle r = sideChords_.rectangle(s);
    walkRound(s, r);
    std::vector<SideEdge> best;
    std::pair<std::size_t, double> bestCost{ 0, 0 };
    const std::size_t n = ring_.size() - ring_.size() % 2;
    for (const std::size_t step : { std::size_t(1), n - 1 })
    {
      std::vector<SideEdge> chords;
      std::pair<std::size_t, double> cost{ 0, 0 };
      for (std::size_t i = 0; i < n; ++i)
      {
        const RingCrossing& out = ring_[i];
        const RingCrossing& in = ring_[(i + step) % n];
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
    bendAlongBorder(r, best);
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

  // The chords on a box's sides, as its patches run along them.
  void gatherChords(std::size_t n)
  {
    boxChords_.clear();
    normals_.clear();
    for (std::size_t i = sides_.boxStart[n]; i < sides_.boxStart[n + 1]; ++i)
    {
      const auto [s, upper] = sides_.ofBox[i];
      if (newChordsOf_[s] != None)
      {
        chords_ = newChords_[newChordsOf_[s]];
      }
      else
      {
        findChords(s, sideChords_.rectangle(s));
      }
      const std::size_t axis = sides_.sides[s].axis;
      Vector up{ 0, 0, 0 };
      up[axis] = 1;
      for (const SideEdge& chord : chords_)
      {
        boxChords_.push_back(upper ? SideEdge{ chord.to, chord.from } : chord);
        normals_.push_back(unit(cross(minus(at(chord.to), at(chord.from)), up)));
      }
    }
  }

  std::uint32_t local(std::uint32_t node) const
  {
    return static_cast<std::uint32_t>(
      std::lower_bound(boxNodes_.begin(), boxNodes_.end(), node) - boxNodes_.begin());
  }

  void addBox(std::uint32_t n, Patches& result)
  {
    gatherChords(n);
    const Box& box = boxes_.boxes[sides_.polyhedral[n]];
    boxNodes_.clear();
    for (const SideEdge& chord : boxChords_)
    {
      boxNodes_.push_back(chord.from);
      boxNodes_.push_back(chord.to);
    }
    std::sort(boxNodes_.begin(), boxNodes_.end());
    boxNodes_.erase(std::unique(boxNodes_.begin(), boxNodes_.end()), boxNodes_.end());
    listLoopNodes(box);
    listSources(n);
    leaving_.assign(boxNodes_.size(), None);
    sameFrom_.assign(boxChords_.size(), None);
    for (std::uint32_t c = 0; c < boxChords_.size(); ++c)
    {
      const std::uint32_t from = local(boxChords_[c].from);
      sameFrom_[c] = leaving_[from];
      leaving_[from] = c;
    }
    for (const SideEdge& first : boxChords_)
    {
      walk_.clear();
      for (std::uint32_t here = local(first.from); leaving_[here] != None;)
      {
        walk_.push_back(here);
        const std::uint32_t c = leaving_[here];
        leaving_[here] = sameFrom_[c];
        here = local(boxChords_[c].to);
      }
      forEachSimpleLoop(walk_, [&](const std::uint32_t* begin, const std::uint32_t* end) {
        triangulate(begin, end, result);
      });
    }
  }

  void listLoopNodes(const Box& box)
  {
    loopNodes_.assign(boxNodes_.size(), LoopNode{ 0, { 0, 0, 0 }, { 0, 0, 0 }, 0 });
    for (std::size_t c = 0; c < boxChords_.size(); ++c)
    {
      for (const std::uint32_t node : { boxChords_[c].from, boxChords_[c].to })
      {
        LoopNode& loopNode = loopNodes_[local(node)];
        loopNode.normal = plus(loopNode.normal, normals_[c]);
      }
    }
    for (std::uint32_t i = 0; i < boxNodes_.size(); ++i)
    {
      const Point& p = at(boxNodes_[i]);
      loopNodes_[i].id = boxNodes_[i];
      loopNodes_[i].at = minus(p, box.low);
      loopNodes_[i].normal = unit(loopNodes_[i].normal);
      loopNodes_[i].planes = planesOf(box, p);
    }
  }

  void triangulate(const std::uint32_t* begin, const std::uint32_t* end, Patches& result)
  {
    loop_.clear();
    for (const std::uint32_t* node = begin; node != end; ++node)
    {
      loop_.push_back(loopNodes_[*node]);
    }
    for (const auto& t : triangulation_.triangulate(loop_))
    {
      const Vector normal =
        unit(cross(minus(loop_[t[1]].at, loop_[t[0]].at), minus(loop_[t[2]].at, loop_[t[0]].at)));
      const std::size_t source = mostAlike(normal);
      for (const std::uint32_t i : t)
      {
        result.corners.push_back(numberOf(loop_[i].id));
      }
      result.start.push_back(result.corners.size());
      result.triangle.push_back(patches_.triangle[source]);
      result.boundary.push_back(patches_.boundary[source]);
    }
  }

  std::uint32_t numberOf(std::uint32_t node) const
  {
    return node < nodes_.patchPoints
      ? node
      : static_cast<std::uint32_t>(node - nodes_.at.size() + nodes_.patchPoints);
  }

  // The patches that the box had, or its neighbours, or the first one of all.
  void listSources(std::uint32_t n)
  {
    sources_.clear();
    const auto addOf = [&](std::uint32_t polyhedral) {
      const std::uint32_t box = polyhedral == None ? None : sides_.patchBox[polyhedral];
      for (std::size_t p = box == None ? 0 : patches_.boxStart[box];
           box != None && p < patches_.boxStart[box + 1]; ++p)
      {
        sources_.push_back({ p, unit(areaOf(p)) });
      }
    };
    addOf(n);
    for (std::size_t i = sides_.boxStart[n]; sources_.empty() && i < sides_.boxStart[n + 1]; ++i)
    {
      const Side& side = sides_.sides[sides_.ofBox[i].side];
      addOf(sides_.polyhedralOrdinal(sides_.ofBox[i].upper ? side.high : side.low));
    }
    if (sources_.empty())
    {
      sources_.push_back({ 0, { 0, 0, 0 } });
    }
  }

  Vector areaOf(std::size_t patch) const
  {
    Vector area{ 0, 0, 0 };
    const Point& first = patches_.points[patches_.corners[patches_.start[patch]]];
    for (std::size_t c = patches_.start[patch] + 1; c + 1 < patches_.start[patch + 1]; ++c)
    {
      area = plus(area,
        cross(minus(patches_.points[patches_.corners[c]], first),
          minus(patches_.points[patches_.corners[c + 1]], first)));
    }
    return area;
  }

  std::size_t mostAlike(const Vector& normal) const
  {
    return std::max_element(sources_.begin(), sources_.end(),
      [&](
        const Source& a, const Source& b) { return dot(a.normal, normal) < dot(b.normal, normal); })
      ->patch;
  }

  void writePatches(RebuiltPatches& result)
  {
    Patches& to = result.patches;
    to.start.push_back(0);
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
        addBox(n, to);
        continue;
      }
      for (std::size_t p = patches_.boxStart[box]; p < patches_.boxStart[box + 1]; ++p)
      {
        to.corners.insert(to.corners.end(),
          patches_.corners.begin() + std::ptrdiff_t(patches_.start[p]),
          patches_.corners.begin() + std::ptrdiff_t(patches_.start[p + 1]));
        to.start.push_back(to.corners.size());
        to.triangle.push_back(patches_.triangle[p]);
        to.boundary.push_back(patches_.boundary[p]);
      }
    }
    to.boxStart.push_back(to.triangle.size());
    to.reason = patches_.reason;
    to.points.reserve(patches_.points.size() + added_.size());
    to.points = patches_.points;
    to.points.insert(to.points.end(), added_.begin(), added_.end());
  }

  struct Source
  {
    std::size_t patch;
    Vector normal;
  };

  const Boxes& boxes_;
  const Patches& patches_;
  const Sides& sides_;
  const Nodes& nodes_;
  const InnerFaces& inner_;
  const std::vector<std::uint8_t>& flawed_;
  GivenUp givenUp_;
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

  std::vector<SideEdge> chords_;
  std::vector<std::uint8_t> scratch_;
  std::vector<BorderNode> border_;
  std::vector<RingCrossing> ring_;
  std::vector<SideEdge> boxChords_;
  std::vector<Vector> normals_;
  std::vector<std::uint32_t> boxNodes_;
  std::vector<LoopNode> loopNodes_;
  std::vector<LoopNode> loop_;
  std::vector<Source> sources_;
  std::vector<std::uint32_t> leaving_;
  std::vector<std::uint32_t> sameFrom_;
  std::vector<std::uint32_t> walk_;
  LoopTriangulation triangulation_;
};

}

RebuiltPatches rebuildFlawedBoxes(const Boxes& boxes, const Patches& patches, const Sides& sides,
  const Nodes& nodes, const InnerFaces& inner, const std::vector<std::uint8_t>& flawed,
  GivenUp givenUp)
{
  return Rebuilder(boxes, patches, sides, nodes, inner, flawed, givenUp).rebuild();
}

}
