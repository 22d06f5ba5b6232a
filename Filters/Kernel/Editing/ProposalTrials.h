// SPDX-License-Identifier: BSD-3-Clause
// Makes proposals, with what follows of them: faces between the same two cells are joined, nodes between two edges go,
// small parts of a cut go to a neighbour, each where that gains too. What does not pay is undone.
#pragma once

#include "Editing/Proposals.h"

#include <functional>

namespace cartesian
{

class ProposalTrials
{
public:
  ProposalTrials(MeshEditor& mesh, const EditRules& rules)
    : mesh_(mesh)
    , rules_(rules)
  {
  }

  // Called now and then by what takes long; it may throw. It has to outlive this, or its last proposal.
  void setPoll(const std::function<void()>& poll) { poll_ = &poll; }

  // In which volumes are measured: those of the cell's box.
  void setBox(std::uint32_t cell) { box_ = mesh_.cell(cell).boxVolume; }

  // What a proposal gains, or NoGain: not more than `least`. The mesh stays as it is.
  double gain(const Proposal& proposal, double least);

  // The same, but where it gains more than `enough`, it is made: the journal has what changed.
  double gainOrMake(const Proposal& proposal, double least, double enough, bool& isMade);

  // Makes it; the journal has what changed. False: it does not gain more than `least`, and is undone.
  bool make(const Proposal& proposal, double least);

private:
  bool apply(const Proposal& proposal);
  bool collapse(std::uint32_t u, std::uint32_t v, const Vector& at);
  bool join(std::uint32_t f, std::uint32_t g);
  bool merge(std::uint32_t a, std::uint32_t b);
  bool remove(std::uint32_t c);
  bool cut(const Proposal& proposal);
  bool flatten(std::uint32_t f);
  bool mayGainOfMerges(const FixedList<std::uint32_t, 16>& parts, std::size_t count) const;
  void mergePart(std::uint32_t part, const FixedList<std::uint32_t, 16>& parts);
  bool updateAndValidate()
  {
    return cartesian::updateAndValidate(mesh_, rules_.objective, { needed_, box_ });
  }

  // Makes a further edit if it gains by itself.
  template <class Edit>
  bool applyIfGain(Edit&& edit);

  // Whatever it gains by itself, since more follows.
  template <class Edit>
  bool applyUnchecked(Edit&& edit);

  using Faces = FixedList<std::uint32_t, 128>;
  bool joinFacesOf(std::uint32_t c, const Faces& which);
  void dissolveNodes(std::uint32_t f);
  bool dissolveNode(std::uint32_t f, std::size_t& tries);

  MeshEditor& mesh_;
  const EditRules& rules_;
  const std::function<void()>* poll_ = nullptr;
  std::size_t count_ = 0; // of further edits
  double box_ = 1;
  double aim_ = NoGain;    // what has to be gained with all that follows, or more
  double needed_ = NoGain; // ... by the edit itself
};

}
