// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/SmallCells.h"

#include "Editing/VolumeDeficits.h"

namespace cartesian
{

namespace
{

constexpr double Whatever = -1e30; // no gain is less

class SmallCellTaker
{
public:
  SmallCellTaker(
    const ZoneTask& task, const EditRules& rules, bool removes, std::vector<MadeEdit>& edits)
    : mesh_(task.mesh)
    , removes_(removes)
    , trials_(task.mesh, rules)
    , edits_(edits)
  {
  }

  void take(std::uint32_t c)
  {
    if (!mesh_.isFree(c) || !isSmallCell(mesh_, c))
    {
      return;
    }
    trials_.setBox(c);
    if (!merge(c) && removes_ && couldRemove(mesh_, c))
    {
      make({ EditKind::Remove, c });
    }
  }

private:
  // Into the neighbour where that costs least.
  bool merge(std::uint32_t c)
  {
    Proposal best{};
    double gained = Whatever;
    for (const std::uint32_t other : largestNeighbours(mesh_, c))
    {
      const Proposal merge{ EditKind::Merge, other, c };
      if (const double gain = trials_.gain(merge, gained); gain > gained)
      {
        gained = gain;
        best = merge;
      }
    }
    return gained > Whatever && make(best);
  }

  bool make(const Proposal& proposal)
  {
    if (!trials_.make(proposal, Whatever))
    {
      return false;
    }
    edits_.push_back(madeEdit(mesh_, proposal.kind, proposal.a));
    passOnDeficits(mesh_);
    mesh_.commit();
    return true;
  }

  MeshEditor& mesh_;
  const bool removes_;
  ProposalTrials trials_;
  std::vector<MadeEdit>& edits_;
};

}

bool isSmallCell(const MeshView& mesh, std::uint32_t c)
{
  const EditCell& cell = mesh.cell(c);
  const SmallCellSpec& spec = mesh.mesh().small;
  return cell.volume < ratioOf(spec, cell.wall, spec.ratio) * cell.boxVolume;
}

void mergeOrRemoveSmallCells(
  const ZoneTask& task, const EditRules& rules, bool removes, std::vector<MadeEdit>& edits)
{
  SmallCellTaker taker(task, rules, removes, edits);
  for (const std::uint32_t c : task.cells)
  {
    taker.take(c);
  }
}

}
