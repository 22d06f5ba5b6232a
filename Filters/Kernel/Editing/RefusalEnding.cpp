// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/RefusalEnding.h"

#include "Editing/EditMeasures.h"
#include "Editing/PrimitiveEdits.h"
#include "Editing/RefusalEdits.h"
#include "Editing/RefusalSearch.h"
#include "Editing/Refusals.h"
#include "Editing/VolumeDeficits.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

// What may go in all within so many boxes of a place, in boxes; what is left stays refused, and is told. Crumbs always may.
constexpr double MostRemoved = 1;
constexpr double NearRemoved = 4;

// More is no crumb, and more is tried before: boxes.
constexpr double MuchRemoved = 0.02;

constexpr double SmallPiece = 0.3; // of its box: goes to a neighbour

// A piece that would go is halved before, unless it is smaller: of its box. Bodies thinner than boxes are all that is there.
constexpr double LeastHalved = 1.0 / 512;
constexpr int MostHalvings = 6;

class RefusalEnder
{
public:
  RefusalEnder(
    const ZoneTask& task, const EditRules& rules, bool removes, std::vector<RemovedPiece>& removed)
    : mesh_(task.mesh)
    , removes_(removes)
    , removed_(removed)
    , pieces_(task.mesh, rules)
  {
  }

  void end(std::uint32_t c, std::vector<MadeEdit>& edits)
  {
    const Refusals before = pieces_.begin(c);
    if (!takeApart(c, before).isLessThan(before))
    {
      undo();
      mesh_.commit();
      return;
    }
    if (made_.empty()) // else neighbours would swell
    {
      passOnDeficits(mesh_);
    }
    if (pieces_.size() > 1)
    {
      edits.push_back(madeEdit(mesh_, EditKind::Cut, c));
    }
    edits.insert(edits.end(), made_.begin(), made_.end());
    mesh_.commit();
  }

private:
  // What one way to take a cell apart leaves.
  struct Outcome
  {
    Refusals refusals;
    double boxes; // removed

    bool isLessThan(const Refusals& other) const
    {
      return refusals.inverted != other.inverted ? refusals.inverted < other.inverted
                                                 : refusals.skew < other.skew;
    }
    bool operator<(const Outcome& other) const
    {
      return isLessThan(other.refusals) || (!other.isLessThan(refusals) && boxes < other.boxes);
    }
  };

  // Where much would go, or something stays refused, a wider search is tried, and to halve pieces.
  Outcome takeApart(std::uint32_t c, const Refusals& refused)
  {
    removedBefore_ = removed_.size();
    mark_ = mesh_.mark();
    RefusalPlan plan = search(c, SearchBudget());
    Outcome best = attempt(c, plan, false);
    if (isGood(best))
    {
      return best;
    }
    undo();
    RefusalPlan wider = search(c, SearchBudget::wide());
    if (const Outcome outcome = attempt(c, wider, false); outcome < best)
    {
      best = outcome;
      plan.swap(wider);
    }
    if (isGood(best))
    {
      return best;
    }
    undo();
    const Outcome halved = attempt(c, plan, true);
    if (halved < best && halved.isLessThan(refused))
    {
      return halved;
    }
    undo();
    const Outcome planned = attempt(c, plan, false);
    if (planned.isLessThan(refused))
    {
      return planned;
    }
    undo();
    return attempt(c, {}, false); // as it is
  }

  bool isGood(const Outcome& outcome) const
  {
    return outcome.refusals.inverted <= pieces_.aim().inverted && outcome.boxes <= MuchRemoved;
  }

  RefusalPlan search(std::uint32_t c, const SearchBudget& budget)
  {
    pieces_.begin(c);
    return searchRefusals(pieces_, budget);
  }

  void undo()
  {
    mesh_.undo(mark_);
    mark_ = mesh_.mark();
    removed_.resize(removedBefore_);
  }

  Outcome attempt(std::uint32_t c, const RefusalPlan& plan, bool halves)
  {
    pieces_.begin(c);
    made_.clear();
    pieces_.make(plan);
    mergeSmall();
    if (halves)
    {
      halve();
      mergeSmall();
    }
    removeRefused();
    Outcome outcome{ pieces_.refusals(), 0 };
    for (std::size_t i = removedBefore_; i < removed_.size(); ++i)
    {
      outcome.boxes += removed_[i].boxes;
    }
    return outcome;
  }

  // Into a neighbour that is no piece, where nothing gets worse by that.
  void mergeSmall()
  {
    for (const std::uint32_t p : std::vector<std::uint32_t>(pieces_.all()))
    {
      if (pieces_.size() < 2 || mesh_.cell(p).gone ||
        mesh_.cell(p).volume > SmallPiece * mesh_.cell(p).boxVolume)
      {
        continue;
      }
      for (const std::uint32_t n : largestNeighbours(mesh_, p))
      {
        if (!pieces_.contains(n) && pieces_.tryEdit(false, [&] { return pieces_.merge(n, p); }))
        {
          pieces_.addRefused(n);
          break;
        }
      }
    }
  }

  // Pieces that would go, again and again, as far as something of them stays then.
  void halve()
  {
    std::vector<std::uint32_t> todo = pieces_.all();
    for (int round = 0; round < MostHalvings && !todo.empty(); ++round)
    {
      std::vector<std::uint32_t> next;
      for (const std::uint32_t p : todo)
      {
        if (!mesh_.cell(p).gone && mesh_.isFree(p) && hasInverted(mesh_, p) &&
          mesh_.cell(p).volume > LeastHalved * mesh_.cell(p).boxVolume)
        {
          halve(p, next);
        }
      }
      todo.swap(next);
    }
  }

  void halve(std::uint32_t p, std::vector<std::uint32_t>& next)
  {
    const std::size_t first = pieces_.all().size();
    for (const CutPlane& plane : planesAcross(mesh_, p, { 0, 0.25, -0.25 }))
    {
      if (pieces_.make({ RefusalEdit::Kind::Cut, p, 0, 0, plane }))
      {
        next.push_back(p);
        next.insert(next.end(), pieces_.all().begin() + std::ptrdiff_t(first), pieces_.all().end());
        pieces_.make(searchRefusals(pieces_, SearchBudget::ofHalves()));
        return;
      }
    }
  }

  // The smallest first, as long as that helps.
  void removeRefused()
  {
    for (bool isAny = removes_; isAny && !pieces_.isEnded();)
    {
      std::vector<std::uint32_t> refused = pieces_.refused();
      std::sort(refused.begin(), refused.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::make_pair(mesh_.cell(a).volume, a) < std::make_pair(mesh_.cell(b).volume, b);
      });
      isAny =
        std::any_of(refused.begin(), refused.end(), [&](std::uint32_t p) { return remove(p); });
    }
  }

  bool remove(std::uint32_t p)
  {
    const RemovedPiece piece{ mesh_.cell(p).centre, shareOf(mesh_, p) };
    const std::vector<std::uint32_t> cells = withFlapsBeside(p);
    std::vector<MadeEdit> edits;
    for (const std::uint32_t c : cells)
    {
      edits.push_back(madeEdit(mesh_, EditKind::Remove, c));
      edits.back().reason = RemovalReason::Rim;
    }
    const auto removeAll = [&] {
      return std::all_of(
        cells.begin(), cells.end(), [&](std::uint32_t c) { return removeCell(mesh_, c); });
    };
    if (!mayRemove(p, piece) || isBridge(mesh_, p) || !pieces_.tryEdit(true, removeAll))
    {
      return false;
    }
    removed_.push_back(piece);
    made_.insert(made_.end(), edits.begin(), edits.end());
    return true;
  }

  // A piece, and what hangs on it that has nothing between its walls: that is no cell by itself.
  std::vector<std::uint32_t> withFlapsBeside(std::uint32_t p) const
  {
    std::vector<std::uint32_t> cells{ p };
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      for (const std::uint32_t f : mesh_.facesOf(cells[i]))
      {
        const std::uint32_t other = mesh_.beyond(f, cells[i]);
        if (!mesh_.isSurface(f) && hasNoVolume(mesh_, other) &&
          std::find(cells.begin(), cells.end(), other) == cells.end())
        {
          cells.push_back(other);
        }
      }
    }
    return cells;
  }

  bool mayRemove(std::uint32_t p, const RemovedPiece& piece) const
  {
    double sum = piece.boxes;
    for (const RemovedPiece& other : removed_)
    {
      const Vector way = minus(other.at, piece.at);
      const double distance = std::max({ std::abs(way[0]), std::abs(way[1]), std::abs(way[2]) });
      sum += distance <= NearRemoved * mesh_.cell(p).edge ? other.boxes : 0;
    }
    return piece.boxes <= MuchRemoved || sum <= MostRemoved;
  }

  MeshEditor& mesh_;
  const bool removes_;
  std::vector<RemovedPiece>& removed_;
  RefusedPieces pieces_;
  std::vector<MadeEdit> made_; // of what is removed of this cell
  MeshEditor::Mark mark_{};    // before its first edit
  std::size_t removedBefore_ = 0;
};

}

void endRefusals(const ZoneTask& task, const EditRules& rules, bool removes,
  std::vector<RemovedPiece>& removed, std::vector<MadeEdit>& edits,
  const std::function<void()>& poll)
{
  RefusalEnder ender(task, rules, removes, removed);
  for (const std::uint32_t c : task.cells)
  {
    poll();
    if (task.mesh.isFree(c) && isRefused(task.mesh, c))
    {
      ender.end(c, edits);
    }
  }
}

}
