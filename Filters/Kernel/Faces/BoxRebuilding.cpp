// SPDX-License-Identifier: BSD-3-Clause
#include "Faces/BoxRebuilding.h"

#include "Faces/ChordSimplification.h"
#include "Faces/GridLines.h"
#include "Faces/LoopPatches.h"

namespace cartesian
{

namespace
{

// How far a chord between two crossings of one line bends into the side, as a part of the side's width.
constexpr int BendPart = 8;

constexpr std::size_t SidesAChunk = 64;
constexpr std::size_t BoxesAChunk = 8;

// A crossing on the border of a side.
struct RingCrossing
{
  std::uint32_t node;
  int change; // of the status, counter-clockwise
  int border; // 0 to 3, as in BorderNode
};

class Rebuilder
{
public:
  Rebuilder(const Boxes& boxes, const Patches& patches, const Sides& sides, const Nodes& nodes,
    const InnerFaces& inner, const std::vector<std::uint8_t>& flawed, RebuildLevel givenUp,
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
    , points_(nodes)
    , lines_(sides, nodes, sideChords_, flawed)
  {
  }

  RebuiltPatches rebuild()
  {
    lines_.judge(givenUp_ != RebuildLevel::Crossings, points_, execution_);
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
  // Gives new chords to the sides that do not keep theirs.
  void judgeSides()
  {
    newChordsOf_.assign(sides_.common.size(), None);
    for (const std::uint32_t s : lines_.nearSides())
    {
      const bool forced = givenUp_ == RebuildLevel::Detail
        ? lines_.isOfFlawed(s) && isBetweenFlawed(s)
        : givenUp_ != RebuildLevel::Nothing && lines_.isOfFlawed(s);
      if (lines_.changes(s) || inner_.flawed[s] != 0 || forced)
      {
        newChordsOf_[s] = static_cast<std::uint32_t>(changed_.size());
        changed_.push_back(s);
      }
    }
    newChords_.resize(changed_.size());
    execution_.forEach(changed_.size(), SidesAChunk, [&](std::size_t begin, std::size_t end) {
      SideView view;
      ChordSimplifier simplifier;
      for (std::size_t i = begin; i < end; ++i)
      {
        newChords_[i] = keepsCrossings(changed_[i]) ? simplerChords(changed_[i], view, simplifier)
                                                    : chordsBetweenCrossings(changed_[i], view);
      }
    });
    for (std::size_t i = 0; i < changed_.size(); ++i)
    {
      bendAlongBorder(sideChords_.rectangle(changed_[i]), newChords_[i]);
    }
  }

  // Whether neither box at a side has patches that stay.
  bool isBetweenFlawed(std::uint32_t s) const
  {
    const Side& side = sides_.common[s];
    const auto is = [&](std::uint32_t box) {
      const std::uint32_t n = sides_.polyhedralOrdinal(box);
      return n == None || sides_.patchBox[n] == None || flawed_[n] != 0;
    };
    return is(side.low) && is(side.high);
  }

  bool keepsCrossings(std::uint32_t s) const
  {
    return givenUp_ == RebuildLevel::Detail && !lines_.changes(s) && inner_.flawed[s] == 0;
  }

  std::vector<SideEdge> simplerChords(
    std::uint32_t s, SideView& view, ChordSimplifier& simplifier) const
  {
    const Rectangle r = sideChords_.rectangle(s);
    view.look(s, sideChords_, nodes_.at);
    simplifier.simplify(
      [&](std::uint32_t node) -> Point { return points_.at(node); }, r, view.chords);
    return view.chords;
  }

  // Lists the crossings around a side counter-clockwise, as far as they change the status in turns.
  void walkRound(std::uint32_t s, SideView& view, std::vector<RingCrossing>& ring) const
  {
    view.look(s, sideChords_, nodes_.at);
    ring.clear();
    int status = lines_.status(view.border.front().node);
    const auto pass = [&](std::uint32_t node, int change, int border) {
      if (status + change == 0 || status + change == 1)
      {
        status += change;
        ring.push_back({ node, change, border });
      }
    };
    for (std::size_t i = 0; i < view.border.size();)
    {
      const std::size_t next = lines_.nextGridNode(view.border, i);
      passLine(view.border, i, next, pass);
      i = next;
    }
  }

  // Calls pass(node, change, border) for the crossings of the line between the grid nodes border[i] and
  // border[next].
  template <class Visitor>
  void passLine(
    const std::vector<BorderNode>& border, std::size_t i, std::size_t next, Visitor&& pass) const
  {
    const bool down = border[i].border >= 2;
    const std::uint32_t here = border[i].node;
    const std::uint32_t there = border[next < border.size() ? next : 0].node;
    if (const NewLine* line = lines_.find(down ? there : here, down ? here : there))
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

  // Joins each crossing out of the inside to the next one into it, or each to the one before it,
  // whichever leaves fewer chords along the border, or else shorter chords.
  std::vector<SideEdge> chordsBetweenCrossings(std::uint32_t s, SideView& view) const
  {
    std::vector<RingCrossing> ring;
    walkRound(s, view, ring);
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
          cost.second += norm(minus(points_.at(out.node), points_.at(in.node)));
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

  // Bends chords that run along the border, as they would lie on the next side too.
  void bendAlongBorder(const Rectangle& r, std::vector<SideEdge>& chords)
  {
    const auto u = static_cast<std::size_t>(r.axis + 1) % 3;
    const auto v = static_cast<std::size_t>(r.axis + 2) % 3;
    const std::size_t count = chords.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      const Point p = points_.at(chords[i].from);
      const Point q = points_.at(chords[i].to);
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
        const std::uint32_t node = points_.add(bend);
        chords.push_back({ node, chords[i].to });
        chords[i].to = node;
        break;
      }
    }
  }

  // The new patches of these boxes, by chunks of them.
  std::vector<Patches> makePatches(const std::vector<std::uint32_t>& rebuilt)
  {
    std::vector<Patches> made(chunks(rebuilt.size(), BoxesAChunk));
    execution_.forEach(rebuilt.size(), BoxesAChunk, [&](std::size_t begin, std::size_t end) {
      LoopPatches maker(
        boxes_, patches_, sides_, nodes_, points_.points(), newChordsOf_, newChords_);
      Patches& chunk = made[begin / BoxesAChunk];
      chunk.start.push_back(0);
      for (std::size_t i = begin; i < end; ++i)
      {
        chunk.boxStart.push_back(chunk.triangle.size());
        maker.add(rebuilt[i], chunk);
      }
      chunk.boxStart.push_back(chunk.triangle.size());
    });
    return made;
  }

  // Copies those of the i-th box of `from`.
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
    const std::vector<Patches> made = makePatches(rebuilt);
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
        copyPatches(made[next / BoxesAChunk], next % BoxesAChunk, to);
        ++next;
      }
      else
      {
        copyPatches(patches_, box, to);
      }
    }
    to.boxStart.push_back(to.triangle.size());
    to.enclosed = patches_.enclosed;
    to.reason = patches_.reason;
    to.missing = patches_.missing;
    to.surfaceVolume = patches_.surfaceVolume;
    to.points.reserve(patches_.points.size() + points_.points().size());
    to.points = patches_.points;
    to.points.insert(to.points.end(), points_.points().begin(), points_.points().end());
    to.knowsEdges = patches_.knowsEdges;
    to.kinds = patches_.kinds;
    to.kinds.resize(to.points.size(), PointKind::OnSurface);
  }

  const Boxes& boxes_;
  const Patches& patches_;
  const Sides& sides_;
  const Nodes& nodes_;
  const InnerFaces& inner_;
  const std::vector<std::uint8_t>& flawed_;
  RebuildLevel givenUp_;
  Execution& execution_;
  SideChords sideChords_;
  NewPoints points_;
  GridLines lines_;

  std::vector<std::uint32_t> changed_;     // sides with new chords
  std::vector<std::uint32_t> newChordsOf_; // of each side: its index in `changed_`, or None
  std::vector<std::vector<SideEdge>> newChords_;
};

}

RebuiltPatches rebuildFlawedBoxes(const Boxes& boxes, const Patches& patches, const Sides& sides,
  const Nodes& nodes, const InnerFaces& inner, const std::vector<std::uint8_t>& flawed,
  RebuildLevel givenUp, Execution& execution)
{
  return Rebuilder(boxes, patches, sides, nodes, inner, flawed, givenUp, execution).rebuild();
}

}
