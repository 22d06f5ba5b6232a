// SPDX-License-Identifier: BSD-3-Clause
// Shared data of the loop over the worst faces (WorstFaces.h) and its proposers: the mesh, its objective, and what has
// changed since when.
#pragma once

#include "Optimisation/FaceEdits.h"
#include "Optimisation/MeshEnergy.h"
#include "Optimisation/NodePaths.h"

namespace cartesian
{

// The mesh to repair; borrowed.
struct MendingTask
{
  NodeMesh& mesh;
  const NodePaths& paths;
  const std::vector<Vector>& before; // where nodes were in the beginning
  const std::vector<double>& edges;  // of boxes, of each face
  double featureCosine;              // faces of the wall that turn by more are not joined
};

// When cells changed last, counted in changes and looks.
class CellChanges
{
public:
  explicit CellChanges(std::size_t cells)
    : changedAt_(cells)
  {
  }

  std::uint32_t next() { return ++now_; }

  void mark(const std::vector<std::uint32_t>& cells)
  {
    ++now_;
    for (const std::uint32_t c : cells)
    {
      changedAt_[c] = now_;
    }
  }

  template <class Cells>
  bool isAnySince(const Cells& cells, std::uint32_t since) const
  {
    return std::any_of(cells.begin(), cells.end(),
      [&](std::uint32_t c) { return c < changedAt_.size() && changedAt_[c] >= since; });
  }

private:
  std::uint32_t now_ = 0;
  std::vector<std::uint32_t> changedAt_;
};

struct Mending
{
  // Edits that change more faces are not made: their time grows with the number.
  static constexpr std::size_t MostFacesAround = 300;

  Mending(const MendingTask& what, MeshEnergy& objective);

  bool isMovable(std::uint32_t node) const
  {
    return mesh.nodes.mayMove[node] && task.paths[node].kind != NodePath::Kind::Fixed;
  }

  bool mayBeAt(std::uint32_t node, const Vector& to) const
  {
    return task.paths.allows(node, task.before[node], to, edgeOf[node]);
  }

  const MendingTask& task;
  NodeMesh& mesh;
  MeshEnergy& energy;
  FaceEdits faces;
  CellChanges changes;
  std::vector<double> edgeOf; // of the smallest box around each node
};

}
