// SPDX-License-Identifier: BSD-3-Clause
// Edits one after another that take a refused cell apart (RefusalEdits.h): the fewest that leave nothing of it refused.
#pragma once

#include "Editing/EditDecision.h"
#include "Editing/RefusalEdits.h"
#include "Editing/Refusals.h"

#include <vector>

namespace cartesian
{

using RefusalPlan = std::vector<RefusalEdit>;

// A cell that is refused, and what it becomes: its parts, and neighbours that are refused for what they took over.
class RefusedPieces
{
public:
  RefusedPieces(MeshEditor& mesh, const EditRules& rules)
    : mesh_(mesh)
    , rules_(rules)
  {
  }

  // Nothing else has changed since the last commit. What is refused now.
  Refusals begin(std::uint32_t c);

  // What is refused more than at the beginning, or less.
  Refusals refusals() const { return refusalsOf(mesh_, pieces_); }

  // Whether all that was refused of the cell has ended, and no more has begun.
  bool isEnded() const { return refusals().isWithin(aim_); }
  const Refusals& aim() const { return aim_; }

  MeshEditor& mesh() { return mesh_; }
  const std::vector<std::uint32_t>& all() const { return pieces_; }
  bool contains(std::uint32_t c) const;
  std::size_t size() const { return pieces_.size(); }

  // The pieces that have inverted faces, or are degenerate.
  std::vector<std::uint32_t> refused() const;

  // That with most of them, then of skew ones, or None.
  std::uint32_t worst() const;

  void addRefused(std::uint32_t c);

  // Makes a valid edit, and follows its pieces. False: undone.
  bool make(const RefusalEdit& edit);
  void make(const RefusalPlan& plan);

  // For tryEdit(): as far as the rules allow it.
  bool merge(std::uint32_t a, std::uint32_t b);

  // Any edit, if it ranks before what was, or not behind it where it does not have to be better. Else it is undone.
  template <class Edit>
  bool tryEdit(bool hasToBeBetter, Edit&& edit)
  {
    const Refusals before = refusals();
    const MeshEditor::Mark mark = mesh_.mark();
    const bool isValid = edit() && isValidNow(mark);
    const Refusals after = isValid ? refusals() : before;
    const bool isMade = isValid && (after < before || (!hasToBeBetter && !(before < after)));
    isMade ? mesh_.keep(mark) : mesh_.undo(mark);
    return isMade;
  }

  // For what is undone.
  void resize(std::size_t size) { pieces_.resize(size); }

private:
  void add(std::uint32_t c);
  void listOthers(std::uint32_t c);
  void addChanged(const MeshEditor::Mark& mark);
  bool apply(const RefusalEdit& edit, CutParts& parts);
  bool isValidNow(const MeshEditor::Mark& mark)
  {
    return updateAndValidate(mesh_, rules_.objective) && areAllClosed(mesh_, mark);
  }

  MeshEditor& mesh_;
  const EditRules& rules_; // which kinds of edits are allowed, and the objective that measures
  std::vector<std::uint32_t> pieces_;
  std::vector<std::uint32_t>
    others_; // cells around that were refused themselves: they have their own turn
  Refusals aim_;
};

struct SearchBudget
{
  int depth = 5;         // edits one after another
  std::size_t plans = 6; // of each length that are followed
  int trials = 800;
  static SearchBudget wide() { return { 6, 20, 5000 }; }
  static SearchBudget ofHalves() { return { 2, 3, 120 }; }
};

// The best edits that it finds; nothing is changed.
RefusalPlan searchRefusals(RefusedPieces& pieces, const SearchBudget& budget);

}
