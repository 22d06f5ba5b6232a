// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/RefusalSearch.h"

#include "Editing/PrimitiveEdits.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// Edits one after another, and what they leave.
struct Plan
{
  RefusalPlan edits;
  Refusals refusals;
};

// What edits of some pieces leave may be worse for a while: of each length, several plans are followed.
class Search
{
public:
  Search(RefusedPieces& pieces, const SearchBudget& budget)
    : pieces_(pieces)
    , budget_(budget)
    , best_{ {}, pieces.refusals() }
    , trialsLeft_(budget.trials)
  {
  }

  RefusalPlan run()
  {
    std::vector<Plan> plans{ best_ };
    for (int length = 1; length <= budget_.depth && isGoingOn(); ++length)
    {
      std::vector<Plan> longer;
      for (const Plan& plan : plans)
      {
        extend(plan, longer);
      }
      keepBest(longer);
      plans.swap(longer);
    }
    return best_.edits;
  }

private:
  bool isGoingOn() const { return trialsLeft_ > 0 && !best_.refusals.isWithin(pieces_.aim()); }

  // By each edit of the worst piece that it leaves.
  void extend(const Plan& plan, std::vector<Plan>& longer)
  {
    MeshEditor& mesh = pieces_.mesh();
    const MeshEditor::Mark mark = mesh.mark();
    const std::size_t size = pieces_.size();
    pieces_.make(plan.edits);
    if (const std::uint32_t worst = pieces_.worst(); worst != None)
    {
      for (const RefusalEdit& edit : editsOfRefused(mesh, worst))
      {
        if (isGoingOn())
        {
          attempt(plan, edit, longer);
        }
      }
    }
    mesh.undo(mark);
    pieces_.resize(size);
  }

  void attempt(const Plan& plan, const RefusalEdit& edit, std::vector<Plan>& longer)
  {
    MeshEditor& mesh = pieces_.mesh();
    const MeshEditor::Mark mark = mesh.mark();
    const std::size_t size = pieces_.size();
    --trialsLeft_;
    if (pieces_.make(edit))
    {
      longer.push_back({ plan.edits, pieces_.refusals() });
      longer.back().edits.push_back(edit);
      best_ = longer.back().refusals < best_.refusals ? longer.back() : best_;
    }
    mesh.undo(mark);
    pieces_.resize(size);
  }

  // Those that leave the same are taken for the same, in another order.
  void keepBest(std::vector<Plan>& plans) const
  {
    std::stable_sort(plans.begin(), plans.end(),
      [](const Plan& x, const Plan& y) { return x.refusals < y.refusals; });
    plans.erase(std::unique(plans.begin(), plans.end(),
                  [](const Plan& x, const Plan& y) { return !(x.refusals < y.refusals); }),
      plans.end());
    plans.resize(std::min(plans.size(), budget_.plans));
  }

  RefusedPieces& pieces_;
  const SearchBudget& budget_;
  Plan best_;
  int trialsLeft_;
};

}

Refusals RefusedPieces::begin(std::uint32_t c)
{
  pieces_ = { c };
  const Refusals now = refusals();
  const Refusals its = refusalsIn(mesh_, c);
  listOthers(c);
  aim_ = { now.inverted - its.inverted, now.skew - its.skew, 0, 0 };
  return now;
}

void RefusedPieces::listOthers(std::uint32_t c)
{
  others_.clear();
  mesh_.forEachCellAround(c, [&](std::uint32_t other) {
    if (other != c && mesh_.isFree(other) && hasInverted(mesh_, other))
    {
      others_.push_back(other);
    }
  });
}

bool RefusedPieces::contains(std::uint32_t c) const
{
  return std::find(pieces_.begin(), pieces_.end(), c) != pieces_.end();
}

std::vector<std::uint32_t> RefusedPieces::refused() const
{
  std::vector<std::uint32_t> refused;
  std::copy_if(pieces_.begin(), pieces_.end(), std::back_inserter(refused), [&](std::uint32_t p) {
    return mesh_.isFree(p) && (hasInverted(mesh_, p) || isDegenerate(mesh_, p));
  });
  return refused;
}

std::uint32_t RefusedPieces::worst() const
{
  std::uint32_t worst = None;
  std::pair<int, int> most{ 0, 0 };
  for (const std::uint32_t p : pieces_)
  {
    if (mesh_.isFree(p))
    {
      const Refusals its = refusalsIn(mesh_, p);
      const std::pair<int, int> count{ its.inverted, its.skew };
      if (count > most)
      {
        most = count;
        worst = p;
      }
    }
  }
  return worst;
}

void RefusedPieces::addRefused(std::uint32_t c)
{
  if (c != None && mesh_.isFree(c) && hasInverted(mesh_, c))
  {
    add(c);
  }
}

void RefusedPieces::add(std::uint32_t c)
{
  if (!contains(c))
  {
    pieces_.push_back(c);
  }
}

bool RefusedPieces::make(const RefusalEdit& edit)
{
  const MeshEditor::Mark mark = mesh_.mark();
  CutParts parts;
  if (!apply(edit, parts) || !isValidNow(mark))
  {
    mesh_.undo(mark);
    return false;
  }
  mesh_.keep(mark);
  for (const std::uint32_t part : parts)
  {
    add(part);
  }
  if (edit.kind == RefusalEdit::Kind::Pass)
  {
    addRefused(mesh_.beyond(edit.a, edit.c));
  }
  else if (edit.kind == RefusalEdit::Kind::Merge)
  {
    addRefused(edit.a);
  }
  addChanged(mark);
  return true;
}

// Cells that are refused by the edit.
void RefusedPieces::addChanged(const MeshEditor::Mark& mark)
{
  for (std::size_t i = mark.cellRecords; i < mesh_.cellRecords().size(); ++i)
  {
    const std::uint32_t c = mesh_.cellRecords()[i].first;
    if (std::find(others_.begin(), others_.end(), c) == others_.end())
    {
      addRefused(c);
    }
  }
}

void RefusedPieces::make(const RefusalPlan& plan)
{
  for (const RefusalEdit& edit : plan)
  {
    make(edit);
  }
}

bool RefusedPieces::merge(std::uint32_t a, std::uint32_t b)
{
  return mayMerge(mesh_, rules_, a, b) && mergeCells(mesh_, a, b);
}

bool RefusedPieces::apply(const RefusalEdit& edit, CutParts& parts)
{
  switch (edit.kind)
  {
    case RefusalEdit::Kind::Pass:
      return passFace(mesh_, edit.c, edit.a, edit.b);
    case RefusalEdit::Kind::Join:
      return joinFaces(mesh_, edit.a, edit.b);
    case RefusalEdit::Kind::Merge:
      return merge(edit.a, edit.b);
    case RefusalEdit::Kind::Cut:
      return rules_.mayCut && cutCell(mesh_, edit.a, edit.plane, parts);
  }
  return false;
}

RefusalPlan searchRefusals(RefusedPieces& pieces, const SearchBudget& budget)
{
  return Search(pieces, budget).run();
}

}
