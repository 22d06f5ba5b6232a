// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/RefusalSearch.h"

#include "Editing/PrimitiveEdits.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// Depth first; all edits of few before those of more.
class Search
{
public:
  explicit Search(RefusedPieces& pieces)
    : pieces_(pieces)
    , best_(pieces.refusals())
  {
  }

  void run(const SearchBudget& budget)
  {
    for (int depth = 1; depth <= budget.depth && !best_.isWithin(pieces_.aim()); ++depth)
    {
      left_ = budget.trials;
      search(depth);
    }
    for (const RefusalEdit& edit : bestPlan_)
    {
      pieces_.make(edit);
    }
  }

private:
  void search(int depth)
  {
    const Refusals now = pieces_.refusals();
    if (now < best_)
    {
      best_ = now;
      bestPlan_ = plan_;
    }
    const std::uint32_t worst =
      depth == 0 || now.isWithin(pieces_.aim()) ? std::uint32_t(None) : pieces_.worst();
    if (worst == None)
    {
      return;
    }
    for (const RefusalEdit& edit : editsOfRefused(pieces_.mesh(), worst))
    {
      if (left_ == 0 || best_.isWithin(pieces_.aim()))
      {
        return;
      }
      --left_;
      tryThis(edit, depth);
    }
  }

  void tryThis(const RefusalEdit& edit, int depth)
  {
    EditMesh& mesh = pieces_.mesh();
    const EditMesh::Mark mark = mesh.mark();
    const std::size_t size = pieces_.size();
    if (pieces_.make(edit))
    {
      plan_.push_back(edit);
      search(depth - 1);
      plan_.pop_back();
    }
    mesh.undo(mark);
    pieces_.resize(size);
  }

  RefusedPieces& pieces_;
  Refusals best_;
  std::vector<RefusalEdit> plan_;
  std::vector<RefusalEdit> bestPlan_;
  int left_ = 0; // trials
};

}

Refusals RefusedPieces::begin(std::uint32_t c)
{
  pieces_ = { c };
  const Refusals now = refusals();
  const Refusals its = refusalsIn(mesh_, c);
  aim_ = { now.inverted - its.inverted, now.skew - its.skew, 0, 0 };
  return now;
}

bool RefusedPieces::contains(std::uint32_t c) const
{
  return std::find(pieces_.begin(), pieces_.end(), c) != pieces_.end();
}

std::vector<std::uint32_t> RefusedPieces::refused() const
{
  std::vector<std::uint32_t> refused;
  std::copy_if(pieces_.begin(), pieces_.end(), std::back_inserter(refused),
    [&](std::uint32_t p) { return mesh_.isFree(p) && hasInverted(mesh_, p); });
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
  const EditMesh::Mark mark = mesh_.mark();
  CutParts parts;
  if (!apply(edit, parts) || !isSettled(mark))
  {
    mesh_.undo(mark);
    return false;
  }
  mesh_.keep(mark);
  for (const std::uint32_t part : parts)
  {
    add(part);
  }
  if (edit.kind == EditKind::Pass)
  {
    addRefused(mesh_.beyond(edit.a, edit.c));
  }
  else if (edit.kind == EditKind::Merge)
  {
    addRefused(edit.a);
  }
  return true;
}

bool RefusedPieces::apply(const RefusalEdit& edit, CutParts& parts)
{
  switch (edit.kind)
  {
    case EditKind::Pass:
      return passFace(mesh_, edit.c, edit.a, edit.b);
    case EditKind::Join:
      return joinFaces(mesh_, edit.a, edit.b);
    case EditKind::Merge:
      return mergeCells(mesh_, edit.a, edit.b);
    default:
      return cutCell(mesh_, edit.a, edit.plane, parts);
  }
}

void searchRefusals(RefusedPieces& pieces, const SearchBudget& budget)
{
  Search(pieces).run(budget);
}

}
