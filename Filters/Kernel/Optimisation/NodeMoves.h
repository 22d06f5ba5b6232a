// SPDX-License-Identifier: BSD-3-Clause
// Moves a node along its path as long as the objective of everything that it changes falls.
#pragma once

#include "Optimisation/Mending.h"

namespace cartesian
{

class NodeMoves
{
public:
  explicit NodeMoves(Mending& mending);

  // Whether the node has moved. Nothing is done if nothing around it has changed since it was last examined.
  bool move(std::uint32_t node);

private:
  void lookAround(std::uint32_t node);
  bool stepDown(std::uint32_t node, double& step, double& now);
  void put(std::uint32_t node, const Vector& at);

  Mending& m_;
  std::vector<std::uint32_t> lookedAt_; // of nodes
  Surroundings around_;
  MeshEnergy::Kept kept_;
};

}
