// SPDX-License-Identifier: BSD-3-Clause
// Merges small, poor and failing cells with a neighbour (section 4.10, but the volume is kept) or simplifies them
// (4.11, IP patches).
#pragma once

#include "Base/Execution.h"
#include "Shaping/CellUnion.h"

#include <optional>

namespace cartesian
{

struct MergeSpec
{
  double ratio = 0; // cells below this part of their box's volume are small

  JoinSpec joins; // which faces of the result become one

  bool merges = true;
  bool simplifies = true; // failing cells, by joining faces at any angle
};

// One cell after the other, the smallest or poorest first, within a slab: each joins the neighbour with which
// the sum of all costs around it (CellCost.h) falls most; where it falls with none, it stays. No two faces
// get the same nodes.
class CellMerger
{
public:
  CellMerger(CellComplex& cells, const MergeSpec& spec, Execution& execution)
    : cells_(cells)
    , spec_(spec)
    , execution_(execution)
    , trying_(cells)
  {
  }

  // Small cells, and before them groups of cells side by side.
  void mergeSmall();

  // Cells with a face that costs more than PoorCost. Looks at all cells, the next time at what has changed.
  void improve();

  // One cell, if it is poor; returns false if it fails and nothing helps.
  bool improve(CellKey key);

  // Whether cells with inverted faces may be simplified: one with a face bent around others cannot be cut any more.
  void bendInvalid(bool bends) { bendsInvalid_ = bends; }

  // Whether one of its faces fails, or it is so small that it strains solvers.
  bool isFailing(CellKey key);

  // The slab's cells; also those that it only touches, if they are not examined later.
  std::vector<CellKey> lookedAfter(bool looksAtOthers) const;

  // Those with a failing face.
  std::vector<CellKey> refused(bool looksAtOthers);

  std::size_t merged() const { return merged_; }         // cells that are gone
  std::size_t simplified() const { return simplified_; } // cells with faces joined at any angle

private:
  // Of the cell to merge.
  struct Neighbour
  {
    CellKey key;
    std::optional<Verdict> verdict; // without its faces towards that cell
  };

  // When something was done last: all have been examined since. 0: never.
  struct Marks
  {
    std::uint32_t merged = 0;
    std::uint32_t improved = 0;
    std::uint32_t refused = 0;
  };

  // Kept for their memory.
  struct Scratch
  {
    std::vector<UnionView> views; // of the cell to merge: alone, and with each neighbour
    CellUnion trial;
    MeasuredCell cell;
    std::vector<Neighbour> neighbours;
    std::vector<std::uint8_t> counts;
  };

  template <class Look>
  void run(std::vector<CellKey> keys, Look&& look);
  void mergeGroups(const std::vector<CellKey>& keys);
  void mergeGroup(const std::vector<CellKey>& keys);
  bool isSmall(CellKey key) const;
  bool isFineNextTo(CellKey key, CellKey other) const;
  bool mayBeOfFineBox(CellKey key) const;
  Verdict verdictOf(CellKey key) { return cartesian::verdictOf(cells_, key, scratch_.cell); }
  Verdict verdictOf(CellKey key, const CellKey* begin, const CellKey* end);
  void forgetViews(std::size_t count);
  UnionView& viewOf(std::size_t place, const std::vector<CellKey>& keys);
  bool mergeBest(
    CellKey key, const Verdict& own, std::size_t mostNeighbours, const Acceptance& acceptance);
  void simplifyBest(
    CellKey key, const Verdict& own, std::size_t mostNeighbours, const Acceptance& acceptance);
  void findBest(CellKey key, const Verdict& own, std::size_t mostNeighbours,
    const Acceptance& acceptance, const JoinSpec& joins, bool simplifies);
  void tryWith(Neighbour& neighbour, CellKey key, const Verdict& own, const Acceptance& acceptance,
    const JoinSpec& joins, bool simplifies);
  double costTogether(CellKey key, CellKey other, double most);
  void tryOut(UnionView& of, const Verdict& before, const Acceptance& acceptance,
    const JoinSpec& joins, bool simplifies);
  void apply(const CellUnion& chosen);

  CellComplex& cells_;
  const MergeSpec& spec_;
  Execution& execution_;
  UnionTrial trying_;
  bool bendsInvalid_ = true;
  std::size_t merged_ = 0;
  std::size_t simplified_ = 0;
  Marks at_;
  std::vector<CellKey> refused_; // then
  CellUnion best_;
  MeasuredCell own_; // to merge
  Scratch scratch_;
};

}
