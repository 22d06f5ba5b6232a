// SPDX-License-Identifier: BSD-3-Clause
#include "Collapse/EdgeCollapse.h"

#include "Base/Sorting.h"
#include "Collapse/CollapseChecks.h"
#include "Collapse/FaceCompaction.h"
#include "Collapse/MovingLayers.h"

#include <cmath>

namespace cartesian
{

namespace
{

constexpr std::size_t EdgesAChunk = 256;
constexpr std::size_t MergesAChunk = 256;
constexpr std::size_t SlotsAChunk = 1 << 14;
constexpr std::size_t BoxesAChunk = 512;

// In a chain of short edges, one collapses in each round.
constexpr int MostRounds = 8;

// Along surfaces that bend, edges collapse up to so many times the spec's ratio, but no longer ones than this part of
// their box. There a merged cell would keep a separate small face beside its neighbour's; on planes both become one.
constexpr double TimesRatio = 5;
constexpr double LongestRatio = 0.5;

// ... where normals around their nodes differ by angles between these, in degrees: where the corner of a box
// moves onto the surface (up to the feature angle), and where two nodes of the surface become one.
constexpr double LeastBend = 1;
constexpr double MostBend = 10;

struct Choice
{
  float length = -1; // negative: the edge does not collapse now
  bool toB = false;  // whether a moves to where b is, or b to a
};

class Collapser
{
public:
  Collapser(const Boxes& boxes, const Sides& sides, const EdgeCollapseSpec& spec, Patches& patches,
    Nodes& nodes, InnerFaces& inner, Execution& execution)
    : boxes_(boxes)
    , sides_(sides)
    , spec_(spec)
    , patches_(patches)
    , nodes_(nodes)
    , inner_(inner)
    , execution_(execution)
    , layers_(boxes, sides, nodes, spec)
    , slots_(patches, nodes, inner)
    , longest_(spec.exact ? spec.ratio
                          : std::max(spec.ratio, std::min(TimesRatio * spec.ratio, LongestRatio)))
    , straight_(std::cos(radians(LeastBend)))
    , bent_(std::cos(radians(MostBend)))
    , sharp_(std::cos(radians(spec.featureAngle)))
  {
  }

  std::size_t run()
  {
    execution_.nextLoop(0.3);
    // Moving nodes may shorten an edge.
    edges_ = listShortEdges(
      { boxes_, sides_, patches_, nodes_, inner_ }, std::max(2 * spec_.ratio, longest_),
      [&](std::size_t n) { return layers_.stays(n); }, execution_);
    if (edges_.empty())
    {
      return 0;
    }
    slots_.find(edges_, execution_);
    for (ShortEdge& edge : edges_)
    {
      edge.a = slots_.ofNode(edge.a);
      edge.b = slots_.ofNode(edge.b);
    }
    banEdgesThatStay();
    choices_.resize(edges_.size());
    setNew(1);
    std::size_t gone = 0;
    for (int round = 0; round < MostRounds; ++round)
    {
      // If everything tried was taken back, the next round tries other edges.
      const std::size_t tried = collapseOnce();
      gone += merges_.size();
      if (tried == 0)
      {
        break;
      }
    }
    if (gone > 0)
    {
      rewrite();
    }
    return gone;
  }

private:
  struct Merge
  {
    std::uint32_t edge;
    std::uint32_t stays; // slots
    std::uint32_t goes;
    Point before; // where the one that stays was
  };

  // Bans edges with an end in a box that keeps its edges.
  void banEdgesThatStay()
  {
    std::vector<std::uint8_t> kept(slots_.size());
    std::vector<std::vector<std::uint32_t>> found(chunks(sides_.polyhedral.size(), BoxesAChunk));
    execution_.forEach(
      sides_.polyhedral.size(), BoxesAChunk, [&](std::size_t begin, std::size_t end) {
        for (std::size_t n = begin; n < end; ++n)
        {
          if (layers_.stays(n) && layers_.isNearMoving(n))
          {
            execution_.poll();
            listSlotsOfBox(n, found[begin / BoxesAChunk]);
          }
        }
      });
    for (const std::vector<std::uint32_t>& ofChunk : found)
    {
      for (const std::uint32_t slot : ofChunk)
      {
        kept[slot] = 1;
      }
    }
    for (std::uint32_t slot = 0; slot < slots_.size(); ++slot)
    {
      kept[slot] = kept[slot] || layers_.isAtEnd(slots_[slot].node);
    }
    for (ShortEdge& edge : edges_)
    {
      edge.banned = kept[edge.a] || kept[edge.b];
    }
  }

  // Appends the slots at the faces of a box; they may come twice.
  void listSlotsOfBox(std::size_t n, std::vector<std::uint32_t>& slots) const
  {
    const auto list = [&](const auto& start, const auto& corners, std::size_t face) {
      for (std::size_t i = start[face]; i < start[face + 1]; ++i)
      {
        if (const std::uint32_t slot = slots_.ofNode(corners[i]); slot != None)
        {
          slots.push_back(slot);
        }
      }
    };
    const std::uint32_t cut = sides_.patchBox[n];
    for (std::size_t p = cut == None ? 0 : patches_.boxStart[cut];
         cut != None && p < patches_.boxStart[cut + 1]; ++p)
    {
      list(patches_.start, patches_.corners, p);
    }
    for (std::size_t i = sides_.boxStart[n]; i < sides_.boxStart[n + 1]; ++i)
    {
      const std::size_t s = sides_.ofBox[i].side;
      for (std::size_t f = inner_.sideStart[s]; f < inner_.sideStart[s + 1]; ++f)
      {
        list(inner_.start, inner_.nodes, f);
      }
    }
  }

  Choice choose(const ShortEdge& edge, CollapseChecks& checks) const
  {
    Choice choice;
    const std::uint32_t a = slots_[edge.a].into;
    const std::uint32_t b = slots_[edge.b].into;
    if (edge.banned || a == b || (slots_.isGridNode(a) && slots_.isGridNode(b)))
    {
      return choice;
    }
    const double length = norm(minus(slots_[a].at, slots_[b].at));
    if (length >= spec_.ratio * edge.unit &&
      (length >= longest_ * edge.unit || !isAlongBend(a, b, checks)))
    {
      return choice;
    }
    const bool toB = checks.mayMove(a, slots_[b].at, edge.unit) && checks.keepsWalls(a, b);
    const bool toA = checks.mayMove(b, slots_[a].at, edge.unit) && checks.keepsWalls(b, a);
    if ((!toA && !toB) || !checks.closesUp(a, b))
    {
      return choice;
    }
    choice.length = static_cast<float>(length);
    choice.toB = toA && toB ? prefersB(a, b) : toB;
    return choice;
  }

  bool isAlongBend(std::uint32_t a, std::uint32_t b, CollapseChecks& checks) const
  {
    const double atA = checks.bendAt(a);
    const double atB = checks.bendAt(b);
    const double bend = std::min(atA, atB);
    const bool isTwo = std::max(atA, atB) <= 1;
    return bend < straight_ && bend > (isTwo ? bent_ : sharp_);
  }

  // Where both may move, the grid's node does, else the one at the lower place.
  bool prefersB(std::uint32_t a, std::uint32_t b) const
  {
    if (slots_.isGridNode(a) != slots_.isGridNode(b))
    {
      return slots_.isGridNode(a);
    }
    return slots_[a].at < slots_[b].at;
  }

  // One round, in which each node takes part in its shortest edge only. Returns the number of edges
  // that it tried.
  std::size_t collapseOnce()
  {
    execution_.nextLoop(0.3);
    execution_.forEach(edges_.size(), EdgesAChunk, [&](std::size_t begin, std::size_t end) {
      CollapseChecks checks(boxes_, spec_, patches_, slots_);
      for (std::size_t i = begin; i < end; ++i)
      {
        if (isNew_[slots_[edges_[i].a].into] || isNew_[slots_[edges_[i].b].into])
        {
          execution_.poll();
          choices_[i] = choose(edges_[i], checks);
        }
      }
    });
    pickMerges();
    const std::size_t tried = merges_.size();
    for (const Merge& merge : merges_)
    {
      swapRings(merge);
    }
    takeBackBadMerges();
    setNew(0);
    execution_.forEach(merges_.size(), MergesAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t m = begin; m < end; ++m)
      {
        markAround(merges_[m].stays);
      }
    });
    shortenWays();
    return tried;
  }

  // Each slot leads to the one that stands for it.
  void shortenWays()
  {
    RawVector<std::uint32_t> standing(slots_.size());
    execution_.forEach(slots_.size(), SlotsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t slot = begin; slot < end; ++slot)
      {
        standing[slot] = slots_.standing(static_cast<std::uint32_t>(slot));
      }
    });
    execution_.forEach(slots_.size(), SlotsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t slot = begin; slot < end; ++slot)
      {
        slots_[slot].into = standing[slot];
      }
    });
  }

  void setNew(std::uint8_t isNew)
  {
    isNew_ = std::vector<std::atomic<std::uint8_t>>(slots_.size());
    for (std::size_t slot = 0; isNew != 0 && slot < isNew_.size(); ++slot)
    {
      isNew_[slot].store(isNew, std::memory_order_relaxed);
    }
  }

  // What is decided of a slot follows from the faces there, and the places of their corners.
  void markAround(std::uint32_t slot)
  {
    slots_.forEachSlotAround(
      slot, [&](std::uint32_t near) { isNew_[near].store(1, std::memory_order_relaxed); });
  }

  // By length, then by place, so that the order of nodes does not matter.
  bool isBefore(std::uint32_t i, std::uint32_t k) const
  {
    if (choices_[i].length != choices_[k].length)
    {
      return choices_[i].length < choices_[k].length;
    }
    const auto ends = [&](std::uint32_t e) {
      const Point& p = slots_[slots_[edges_[e].a].into].at;
      const Point& q = slots_[slots_[edges_[e].b].into].at;
      return std::make_pair(std::min(p, q), std::max(p, q));
    };
    const auto x = ends(i);
    const auto y = ends(k);
    return x != y ? x < y : i < k;
  }

  void pickMerges()
  {
    std::vector<std::uint32_t> best(slots_.size(), None);
    for (std::uint32_t e = 0; e < edges_.size(); ++e)
    {
      if (choices_[e].length < 0)
      {
        continue;
      }
      for (const std::uint32_t slot : { slots_[edges_[e].a].into, slots_[edges_[e].b].into })
      {
        best[slot] = best[slot] == None || isBefore(e, best[slot]) ? e : best[slot];
      }
    }
    merges_.clear();
    for (std::uint32_t e = 0; e < edges_.size(); ++e)
    {
      const std::uint32_t a = slots_[edges_[e].a].into;
      const std::uint32_t b = slots_[edges_[e].b].into;
      if (choices_[e].length < 0 || best[a] != e || best[b] != e)
      {
        continue;
      }
      // Boxes refer to grid nodes as their corners: of the two nodes the grid's stays, if need be at the
      // other's place.
      const bool aStays = slots_.isGridNode(a) || (!slots_.isGridNode(b) && !choices_[e].toB);
      const std::uint32_t stays = aStays ? a : b;
      merges_.push_back({ e, stays, aStays ? b : a, slots_[stays].at });
      slots_[stays].at = slots_[choices_[e].toB ? b : a].at;
      slots_[merges_.back().goes].into = stays;
    }
  }

  // Joins the rings of two slots, or separates them again.
  void swapRings(const Merge& merge)
  {
    std::swap(slots_[merge.stays].next, slots_[merge.goes].next);
  }

  // Reverts the merges that moved a corner of a bad face, until there is no such face.
  void takeBackBadMerges()
  {
    std::vector<std::uint32_t> mergeAt(slots_.size(), None);
    for (std::uint32_t m = 0; m < merges_.size(); ++m)
    {
      mergeAt[merges_[m].stays] = m;
    }
    std::vector<std::uint8_t> bad(merges_.size());
    setNew(1);
    for (bool any = true; any;)
    {
      bad.assign(merges_.size(), 0);
      std::vector<std::vector<std::uint32_t>> found(chunks(merges_.size(), EdgesAChunk));
      execution_.nextLoop(0.1);
      execution_.forEach(merges_.size(), EdgesAChunk, [&](std::size_t begin, std::size_t end) {
        CollapseChecks checks(boxes_, spec_, patches_, slots_);
        for (std::size_t m = begin; m < end; ++m)
        {
          if (merges_[m].edge != None && isNew_[merges_[m].stays])
          {
            execution_.poll();
            listBadMerges(merges_[m].stays, mergeAt, checks, found[begin / EdgesAChunk]);
          }
        }
      });
      any = false;
      setNew(0);
      for (const auto& ofChunk : found)
      {
        for (const std::uint32_t m : ofChunk)
        {
          any = true;
          bad[m] = 1;
        }
      }
      for (std::uint32_t m = 0; m < merges_.size(); ++m)
      {
        if (bad[m])
        {
          takeBack(merges_[m], mergeAt);
        }
      }
    }
    merges_.erase(std::remove_if(merges_.begin(), merges_.end(),
                    [](const Merge& merge) { return merge.edge == None; }),
      merges_.end());
  }

  // Appends the merges that moved corners of bad faces around a slot; they may come several times.
  void listBadMerges(std::uint32_t slot, const std::vector<std::uint32_t>& mergeAt,
    CollapseChecks& checks, std::vector<std::uint32_t>& bad) const
  {
    checks.forEachBadFace(slot, [&](const std::vector<std::uint32_t>& ring) {
      for (const std::uint32_t node : ring)
      {
        const std::uint32_t s = slots_.ofNode(node);
        if (s != None && mergeAt[s] != None)
        {
          bad.push_back(mergeAt[s]);
        }
      }
    });
  }

  void takeBack(Merge& merge, std::vector<std::uint32_t>& mergeAt)
  {
    swapRings(merge);
    slots_[merge.stays].at = merge.before;
    slots_[merge.goes].into = merge.goes;
    mergeAt[merge.stays] = None;
    markAround(merge.stays);
    markAround(merge.goes);
    edges_[merge.edge].banned = true;
    choices_[merge.edge] = {};
    merge.edge = None;
  }

  // Writes the current faces and node positions.
  void rewrite()
  {
    const auto whatIsLeft = [&](const std::uint32_t* begin, const std::uint32_t* end,
                              std::vector<std::uint32_t>& ring) {
      slots_.ringOf(begin, end, ring);
    };
    compactFaces(
      patches_.boxStart, patches_.start, patches_.corners, whatIsLeft,
      [&](std::size_t from, std::size_t to) {
        patches_.triangle[to] = patches_.triangle[from];
        patches_.boundary[to] = patches_.boundary[from];
      },
      execution_);
    patches_.triangle.resize(patches_.start.size() - 1);
    patches_.boundary.resize(patches_.start.size() - 1);
    const bool hasRegions = !inner_.region.empty();
    compactFaces(
      inner_.sideStart, inner_.start, inner_.nodes, whatIsLeft,
      [&](std::size_t from, std::size_t to) {
        if (hasRegions)
        {
          inner_.region[to] = inner_.region[from];
        }
      },
      execution_);
    inner_.region.resize(hasRegions ? inner_.size() : 0);
    for (const MergingNodes::Slot& slot : slots_)
    {
      nodes_.at[slot.node] = slots_[slot.into].at;
      raise(nodes_.kinds[slots_[slot.into].node], nodes_.kinds[slot.node]);
    }
  }

  const Boxes& boxes_;
  const Sides& sides_;
  const EdgeCollapseSpec& spec_;
  Patches& patches_;
  Nodes& nodes_;
  InnerFaces& inner_;
  Execution& execution_;
  MovingLayers layers_;
  MergingNodes slots_;
  double longest_;  // edge that collapses, as a part of its unit
  double straight_; // cosines
  double bent_;
  double sharp_;
  std::vector<ShortEdge> edges_; // their ends are nodes at first, then slots
  std::vector<Choice> choices_;  // of each edge
  std::vector<std::atomic<std::uint8_t>>
    isNew_;                   // of slots: 1 where faces have changed since the last look
  std::vector<Merge> merges_; // of this round
};

}

std::size_t collapseShortEdges(const Boxes& boxes, const Sides& sides, const EdgeCollapseSpec& spec,
  Patches& patches, Nodes& nodes, InnerFaces& inner, Execution& execution)
{
  return Collapser(boxes, sides, spec, patches, nodes, inner, execution).run();
}

}
