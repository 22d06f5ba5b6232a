// SPDX-License-Identifier: BSD-3-Clause
// Vectors at the nodes of a graph, as smooth as the known values allow.
#pragma once

#include "Base/Execution.h"
#include "Lattice/Vector.h"

#include <cstdint>
#include <vector>

namespace cartesian
{

// Each unknown value is the weighted mean of its neighbours', with 0 in place of what is not linked; its component
// along its fixed normals is kept.
class HarmonicField
{
public:
  struct Link
  {
    std::uint32_t to; // an unknown or a known
    double weight;
  };

  HarmonicField() = default;

  // `values`: of the unknowns, to start with, then of the knowns. `firstLink`: of each unknown, and the end. `damping`: of
  // each unknown, its weight towards 0. `fixed`: of each unknown, orthogonal normals of length 1, or null; borrowed.
  HarmonicField(std::vector<Vector> values, std::vector<std::size_t> firstLink,
    std::vector<Link> links, std::vector<double> damping,
    std::vector<const std::vector<Vector>*> fixed);

  std::vector<Vector>& values() { return values_; }
  const std::vector<Vector>& values() const { return values_; }

  // From now on an unknown is 0. Whether it was not held before.
  bool hold(std::size_t unknown);

  // From the values as they are. The same bits for any number of threads.
  void solve(Execution& execution);

private:
  using Vectors = std::vector<Vector>;

  std::size_t unknowns() const { return sums_.size(); }
  Vector withinFixed(std::size_t i, const Vector& v) const;
  void multiply(const Vectors& values, Vectors& result, Execution& execution) const;

  std::vector<Vector> values_;
  std::vector<std::size_t> firstLink_; // of each unknown, and the end
  std::vector<Link> links_;
  std::vector<double> sums_; // of the weights of each unknown
  std::vector<const std::vector<Vector>*> fixed_;
};

}
