// SPDX-License-Identifier: BSD-3-Clause
// All edits that are proposed for a face are tried out in place; the one with the largest gain is made.
#pragma once

#include "Optimisation/FaceProposals.h"

namespace cartesian
{

class EditTrials
{
public:
  explicit EditTrials(Mending& mending)
    : m_(mending)
  {
  }

  // Whether any had a gain.
  bool editBest(std::uint32_t face);

private:
  double tryOut(const ProposedEdit& edit);
  void takeBack();
  bool keepsShapes() const;
  bool keepsWall(const ProposedEdit& edit) const;
  double volumeAround() const;

  Mending& m_;
  std::vector<ProposedEdit> edits_;
  Surroundings around_; // the edit, before it
  Surroundings after_;
  MeshEnergy::Kept kept_;
};

}
