// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/NodePlaces.h"

#include "Base/Sorting.h"

#include <algorithm>
#include <tuple>

namespace cartesian
{

namespace
{

constexpr int MostSteps = 1000;

struct Placed
{
  Vector at;
  bool isFree; // of two at one place, that which may not move comes first
  std::uint32_t node;

  bool operator<(const Placed& other) const
  {
    return std::tie(at, isFree, node) < std::tie(other.at, other.isFree, other.node);
  }
};

class Places
{
public:
  explicit Places(EditStore& store)
    : store_(store)
  {
    for (std::uint32_t n = 0; n < store.nodes.size(); ++n)
    {
      const EditNode& node = store.nodes[n];
      if (!node.gone)
      {
        all_.push_back({ node.at, node.held != HeldFast, n });
      }
    }
  }

  void run(Execution& execution)
  {
    sortAll(all_, execution);
    for (std::size_t i = 1; i < all_.size(); ++i)
    {
      if (all_[i].at == all_[i - 1].at && all_[i].isFree)
      {
        move(store_.nodes[all_[i].node]);
      }
    }
  }

private:
  void move(EditNode& node)
  {
    for (int steps = 1; steps <= MostSteps; ++steps)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        for (const int sign : { 1, -1 })
        {
          Vector to = node.at;
          to[axis] += sign * steps * store_.level;
          const bool isInside = to[axis] >= store_.low[axis] && to[axis] <= store_.high[axis];
          if ((node.held >> axis & 1) == 0 && isInside && !isTaken(to))
          {
            node.at = to;
            taken_.push_back(to);
            return;
          }
        }
      }
    }
  }

  bool isTaken(const Vector& at) const
  {
    const auto next = std::lower_bound(all_.begin(), all_.end(), Placed{ at, false, 0 });
    return (next != all_.end() && next->at == at) ||
      std::find(taken_.begin(), taken_.end(), at) != taken_.end();
  }

  EditStore& store_;
  std::vector<Placed> all_;
  std::vector<Vector> taken_; // by those that moved: few
};

}

void separateNodes(EditStore& store, Execution& execution)
{
  Places(store).run(execution);
}

}
