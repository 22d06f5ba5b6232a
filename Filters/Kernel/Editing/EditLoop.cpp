// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/EditLoop.h"
#include "Editing/VolumeDeficits.h"

#include "Editing/EditMeasures.h"
#include "Editing/NodeMoves.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace cartesian
{

namespace
{

constexpr double NoMoveBeyond = 0.3; // nodes are not tried where another edit gains so much of it
constexpr double Retried =
  0.05; // an item that failed is tried again where its cost changed by this part
constexpr double QuietFace =
  0.3; // of a cell, faces that cost less of leastCost have no nodes that move
constexpr double LargeCell = 1.3; // of its box
constexpr std::size_t NodesOfCell = 8;
constexpr std::size_t ItemsAPoll = 4; // one takes up to 20 ms in a cell with very many faces

// A face or a cell that costs too much.
struct Item
{
  double cost;
  bool isCell;
  std::uint32_t number;

  // The last of a queue is the most expensive, then the face, then that with the lower number.
  bool operator<(const Item& other) const
  {
    return std::make_tuple(cost, other.isCell, other.number) <
      std::make_tuple(other.cost, isCell, number);
  }
};

class EditLoop
{
public:
  EditLoop(const ZoneTask& task, const LoopSpec& spec)
    : task_(task)
    , mesh_(task.mesh)
    , spec_(spec)
    , trials_(task.mesh, spec.rules)
    , memory_(task.memory)
  {
    memory_.begin();
    for (const std::uint32_t c : task.cells)
    {
      memory_.here.mark(c);
    }
  }

  std::vector<MadeEdit> run(const std::function<void()>& poll)
  {
    trials_.setPoll(poll);
    for (const std::uint32_t c : task_.cells)
    {
      push({ 0, true, c });
    }
    task_.forEachFace([&](std::uint32_t f) { push({ 0, false, f }); });
    while (!queue_.empty() || !later_.empty())
    {
      if (queue_.empty())
      {
        takeLater();
        continue;
      }
      const Item item = queue_.top();
      queue_.pop();
      if (isDone(item))
      {
        continue;
      }
      if (++items_ % ItemsAPoll == 0)
      {
        poll();
      }
      improve(item);
    }
    return std::move(edits_);
  }

private:
  // By the edit that was made last.
  struct Changed
  {
    std::vector<std::uint32_t> faces;
    std::vector<std::uint32_t> cells;
  };

  double costOf(const Item& item) const
  {
    if (item.isCell)
    {
      return mesh_.isFree(item.number) ? mesh_.cell(item.number).cost : 0;
    }
    const EditFace& face = mesh_.face(item.number);
    const bool isFree =
      !face.gone && (mesh_.isFree(face.below) || (face.above != None && mesh_.isFree(face.above)));
    return isFree ? face.cost : 0;
  }

  void push(Item item)
  {
    item.cost = costOf(item);
    if (isWanted(item))
    {
      wasHopeless(item) ? later_.push_back(item) : queue_.push(item);
    }
  }

  bool isWanted(const Item& item) const
  {
    const bool fails =
      item.isCell ? mesh_.cell(item.number).strains : mesh_.face(item.number).fails > 0;
    return item.cost > spec_.leastCost && (!spec_.failingOnly || fails) && mayChange(item);
  }

  // What nothing helped waits until all else is done: most of what changes near it does not help it either.
  bool wasHopeless(const Item& item) const
  {
    return (item.isCell ? memory_.hopelessCells : memory_.hopelessFaces).contains(item.number);
  }

  void takeLater()
  {
    for (Item& item : later_)
    {
      item.cost = costOf(item);
      if (isWanted(item))
      {
        queue_.push(item);
      }
    }
    later_.clear();
  }

  bool mayChange(const Item& item) const
  {
    const auto isSmall = [&](std::uint32_t c) {
      return c != None && mesh_.cell(c).faces.size < MostFacesChanged;
    };
    return item.isCell
      ? isSmall(item.number)
      : isSmall(mesh_.face(item.number).below) || isSmall(mesh_.face(item.number).above);
  }

  float& failedAt(const Item& item)
  {
    return (item.isCell ? memory_.failedCells : memory_.failedFaces)[item.number];
  }

  // It costs something else now, or did not get better when it cost about as much.
  bool isDone(const Item& item)
  {
    const std::uint32_t c = item.isCell ? item.number : mesh_.face(item.number).below;
    return costOf(item) != item.cost || task_.isDeferred(c, memory_.here.contains(c)) ||
      std::abs(double(failedAt(item)) - item.cost) < Retried * item.cost;
  }

  void improve(const Item& item)
  {
    const std::uint32_t c = item.isCell ? item.number : mesh_.face(item.number).below;
    trials_.setBox(c);
    Proposal best{};
    bool isMade = false;
    double gained = bestProposal(item, best, isMade);
    if (isMade)
    {
      finish(best);
      return;
    }
    if (!(gained >= NoMoveBeyond * item.cost))
    {
      const double least = std::max(gained, spec_.leastGainOfMove * item.cost);
      gained = std::max(gained,
        bestMove(mesh_, trials_, spec_.rules.objective, spec_.search, nodesOf(item),
          mesh_.cell(c).edge, least, best));
    }
    if (!(gained > NoGain) || !make(best)) // or a cell would not close
    {
      failedAt(item) = static_cast<float>(item.cost);
      (item.isCell ? memory_.hopelessCells : memory_.hopelessFaces).mark(item.number);
    }
  }

  // `isMade`: it gained so much that it is made.
  double bestProposal(const Item& item, Proposal& best, bool& isMade)
  {
    proposals_.clear();
    item.isCell ? proposeForCell(mesh_, spec_.search, item.number, proposals_)
                : proposeForFace(mesh_, spec_.search, item.number, proposals_);
    const double least = spec_.leastGain * std::max(item.cost, 1.0);
    double gained = NoGain;
    for (const Proposal& proposal : proposals_)
    {
      if (memory_.failed.contains(proposal, versionOf(proposal)))
      {
        continue;
      }
      const double enough = makesLargeCell(proposal) ? -NoGain : spec_.search.enough * item.cost;
      const double gain = trials_.gainOrMake(proposal, std::max(least, gained), enough, isMade);
      if (gain > gained)
      {
        gained = gain;
        best = proposal;
      }
      if (isMade)
      {
        break;
      }
    }
    return gained;
  }

  // A cut may be better.
  bool makesLargeCell(const Proposal& proposal) const
  {
    return proposal.kind == EditKind::Merge &&
      shareOf(mesh_, proposal.a) + shareOf(mesh_, proposal.b) > LargeCell;
  }

  FixedList<std::uint32_t, 16> nodesOf(const Item& item) const
  {
    FixedList<std::uint32_t, 16> nodes;
    if (!item.isCell)
    {
      for (const std::uint32_t n : mesh_.cornersOf(item.number))
      {
        nodes.offer(n);
      }
      return nodes;
    }
    for (const std::uint32_t f : mesh_.facesOf(item.number))
    {
      if (mesh_.face(f).cost < QuietFace * spec_.leastCost && !mesh_.isSurface(f))
      {
        continue;
      }
      for (const std::uint32_t n : mesh_.cornersOf(f))
      {
        if (nodes.size() < NodesOfCell && !nodes.contains(n))
        {
          nodes.push(n);
        }
      }
    }
    return nodes;
  }

  bool make(const Proposal& proposal)
  {
    const bool isMade = trials_.make(proposal, 0);
    if (isMade)
    {
      finish(proposal);
    }
    return isMade;
  }

  // What it changed is looked at again.
  void finish(const Proposal& proposal)
  {
    note(proposal);
    passOnDeficits(mesh_);
    collectChanged();
    mesh_.commit();
    for (const std::uint32_t f : changed_.faces)
    {
      raiseVersion(mesh_.face(f).below);
      raiseVersion(mesh_.face(f).above);
      if (proposal.kind != EditKind::Move)
      {
        failedAt({ 0, false, f }) = 0;
      }
      push({ 0, false, f });
    }
    for (const std::uint32_t c : changed_.cells)
    {
      push({ 0, true, c });
    }
  }

  void note(const Proposal& proposal)
  {
    switch (proposal.kind)
    {
      case EditKind::Remove:
        edits_.push_back(madeEdit(mesh_, proposal.kind, proposal.a));
        edits_.back().reason =
          wasRefused(mesh_, proposal.a) ? RemovalReason::Refused : RemovalReason::Small;
        break;
      case EditKind::Merge:
      case EditKind::Cut:
        edits_.push_back(madeEdit(mesh_, proposal.kind, proposal.a));
        break;
      case EditKind::Flatten:
        edits_.push_back(madeEdit(mesh_, proposal.kind, mesh_.face(proposal.a).below));
        break;
      default:
        break;
    }
  }

  void collectChanged()
  {
    changed_.faces.clear();
    changed_.cells.clear();
    for (const auto& record : mesh_.faceRecords())
    {
      changed_.faces.push_back(record.first);
    }
    for (const auto& record : mesh_.cellRecords())
    {
      changed_.cells.push_back(record.first);
    }
    for (std::vector<std::uint32_t>* all : { &changed_.faces, &changed_.cells })
    {
      std::sort(all->begin(), all->end());
      all->erase(std::unique(all->begin(), all->end()), all->end());
    }
  }

  void raiseVersion(std::uint32_t c)
  {
    if (c == None)
    {
      return;
    }
    ++memory_.versions[c];
  }

  std::uint32_t versionOfCell(std::uint32_t c) const { return memory_.versions.at(c); }

  std::uint32_t versionOfFace(std::uint32_t f) const
  {
    return versionOfCell(mesh_.face(f).below) + versionOfCell(mesh_.face(f).above);
  }

  std::uint32_t versionOfNode(std::uint32_t n) const
  {
    std::uint32_t sum = 0;
    for (const std::uint32_t f : mesh_.facesAround(n))
    {
      sum += versionOfFace(f);
    }
    return sum;
  }

  // Grows whenever a cell changes that the proposal looks at.
  std::uint32_t versionOf(const Proposal& proposal) const
  {
    switch (proposal.kind)
    {
      case EditKind::Merge:
        return versionOfCell(proposal.a) + versionOfCell(proposal.b);
      case EditKind::Remove:
      case EditKind::Cut:
        return versionOfCell(proposal.a);
      case EditKind::Join:
      case EditKind::SplitFace:
      case EditKind::Flatten:
        return versionOfFace(proposal.a);
      default:
        return versionOfNode(proposal.a) + versionOfNode(proposal.b);
    }
  }

  const ZoneTask& task_;
  MeshEditor& mesh_;
  const LoopSpec& spec_;
  ProposalTrials trials_;
  LoopMemory& memory_;
  std::priority_queue<Item> queue_;
  std::vector<Item> later_;
  Proposals proposals_;
  Changed changed_;
  std::vector<MadeEdit> edits_;
  std::size_t items_ = 0; // looked at
};

}

MadeEdit madeEdit(const MeshView& mesh, EditKind kind, std::uint32_t c)
{
  const EditCell& cell = mesh.cell(c);
  const double level = mesh.level();
  MadeEdit edit{ cell.boxIndex, kind };
  edit.removed = kind == EditKind::Remove ? cell.volume / (level * level * level) : 0;
  return edit;
}

bool wasRefused(const MeshEditor& mesh, std::uint32_t c)
{
  const auto& records = mesh.faceRecords();
  return std::any_of(records.begin(), records.end(), [&](const auto& record) {
    const EditFace& was = record.second;
    return !was.gone && was.fails > 0 && (was.below == c || was.above == c);
  });
}

std::vector<MadeEdit> improve(
  const ZoneTask& task, const LoopSpec& spec, const std::function<void()>& poll)
{
  return EditLoop(task, spec).run(poll);
}

}
