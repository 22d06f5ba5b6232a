// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/NodePlaces.h"

#include "Base/Sorting.h"
#include "Editing/EditMeasures.h"

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
  Places(EditMesh& whole, const ObjectiveSpec& spec)
    : mesh_(whole, 0, 0, {})
    , spec_(spec)
  {
    for (std::uint32_t n = 0; n < mesh_.nodeCount(); ++n)
    {
      const EditNode& node = mesh_.node(n);
      if (!node.gone)
      {
        all_.push_back({ node.at, node.constrainedAxes != AllAxes, n });
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
        move(all_[i].node);
      }
    }
  }

private:
  // To the nearest place that is free and keeps all volumes.
  void move(std::uint32_t n)
  {
    const Vector from = mesh_.node(n).at;
    const EditMesh& whole = mesh_.mesh();
    for (int steps = 1; steps <= MostSteps; ++steps)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        for (const int sign : { 1, -1 })
        {
          Vector to = from;
          to[axis] += sign * steps * whole.level;
          const bool isInside = to[axis] >= whole.low[axis] && to[axis] <= whole.high[axis];
          if ((mesh_.node(n).constrainedAxes >> axis & 1) == 0 && isInside && !isTaken(to) &&
            moveTo(n, to))
          {
            taken_.push_back(to);
            return;
          }
        }
      }
    }
  }

  // False: the mesh is as before.
  bool moveTo(std::uint32_t n, const Vector& to)
  {
    const MeshEditor::Mark mark = mesh_.mark();
    mesh_.changeNode(n).at = to;
    for (const std::uint32_t f : mesh_.facesAround(n))
    {
      mesh_.dirty.faces.add(f);
    }
    if (!measureDirty(mesh_))
    {
      mesh_.undo(mark);
      return false;
    }
    std::vector<std::uint32_t> changed;
    listChanged(mesh_, changed);
    mesh_.commit();
    changed = sortedUnique(std::move(changed));
    costCells(mesh_, { changed.data(), changed.data() + changed.size() }, spec_);
    return true;
  }

  bool isTaken(const Vector& at) const
  {
    const auto next = std::lower_bound(all_.begin(), all_.end(), Placed{ at, false, 0 });
    return (next != all_.end() && next->at == at) ||
      std::find(taken_.begin(), taken_.end(), at) != taken_.end();
  }

  MeshEditor mesh_;
  const ObjectiveSpec& spec_;
  std::vector<Placed> all_;
  std::vector<Vector> taken_; // by those that moved: few
};

}

void separateNodes(EditMesh& whole, const ObjectiveSpec& spec, Execution& execution)
{
  Places(whole, spec).run(execution);
}

}
