// SPDX-License-Identifier: BSD-3-Clause
// The points near a wall follow its nodes when these move inwards, the less the farther they are: no cell is squeezed
// more than others.
#pragma once

#include "Layers/NearCells.h"

namespace cartesian
{

// The ways of points are harmonic on the graph of the mesh's edges, whose weights are the reciprocals of their lengths:
// along a row of points they fall linearly from the wall's to 0 at points that do not move. Those on planes of
// boundaries without layers slide within them.
class NodeMotion
{
public:
  NodeMotion(const NearCells& near, const LayeredWall& wall, const std::vector<double>& points);

  // The ways of the points that may move, as the wall's parts are now; starts from the ways before. The same bits
  // for any number of threads.
  void run(const LayeredWall& wall);

  const std::vector<std::uint32_t>& moving() const { return moving_; } // points of the mesh, in order
  const std::vector<Vector>& ways() const { return ways_; }

private:
  struct Link
  {
    std::uint32_t to; // of moving_; or a node of the wall, beyond these
    double weight;
  };

  void listLinks(const NearCells& near, const std::vector<double>& points);
  std::vector<Vector> residual(const LayeredWall& wall) const;
  Vector within(std::size_t i, const Vector& v) const;

  std::vector<std::uint32_t> moving_;
  std::vector<Vector> ways_;
  std::vector<std::size_t> firstLink_; // of each, and the end
  std::vector<Link> links_;
  std::vector<double> sums_; // of the weights
  std::vector<const std::vector<Vector>*> fixed_; // normals of planes, or null
};

}
