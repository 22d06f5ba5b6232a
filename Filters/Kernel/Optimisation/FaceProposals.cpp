// SPDX-License-Identifier: BSD-3-Clause
#include "Optimisation/FaceProposals.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// Nodes that are nearer to each other than this part of the box's edge become one.
constexpr double LongestCollapsed = 0.4;

// Faces inside are joined up to 45 degrees.
constexpr double InnerCosine = 0.707;

// Wall nodes merge only along a wall face: elsewhere two walls would meet.
bool mayCollapse(const Mending& m, std::uint32_t from, std::uint32_t into)
{
  const NumberLists::List faces = m.faces.facesOf(from);
  return m.isMovable(from) && m.mesh.nodes.mayMove[into] &&
    std::all_of(
      faces.begin(), faces.end(), [&](std::uint32_t f) { return m.faces.mayChange(f); }) &&
    (m.task.paths[from].kind == NodePath::Kind::Free ||
      (m.mayBeAt(from, m.mesh.nodes.at[into]) &&
        std::any_of(faces.begin(), faces.end(),
          [&](std::uint32_t f) { return m.mesh.isWall(f) && m.faces.hasCorner(f, into); })));
}

void proposeCollapses(const Mending& m, std::uint32_t f, std::vector<ProposedEdit>& edits)
{
  const auto& faces = m.mesh.faces;
  const std::size_t size = faces.sizeOf(f);
  const auto propose = [&](std::size_t i, std::size_t k) {
    const std::uint32_t a = faces.corners[faces.start[f] + i];
    const std::uint32_t b = faces.corners[faces.start[f] + k % size];
    if (norm(minus(m.mesh.nodes.at[a], m.mesh.nodes.at[b])) < LongestCollapsed * m.task.edges[f])
    {
      for (const auto& [from, into] : { std::pair{ a, b }, { b, a } })
      {
        if (mayCollapse(m, from, into))
        {
          edits.push_back({ ProposedEdit::Kind::Collapse, from, into });
        }
      }
    }
  };
  for (std::size_t i = 0; i < size; ++i)
  {
    propose(i, i + 1);
  }
  for (std::size_t i = 0; size == 4 && i < 2; ++i) // across
  {
    propose(i, i + 2);
  }
}

bool mayJoin(const Mending& m, std::uint32_t f, std::uint32_t g)
{
  if (f == g || !m.faces.areBetweenTheSame(f, g) || !m.faces.mayChange(f) || !m.faces.mayChange(g))
  {
    return false;
  }
  const double sign = m.mesh.faces.cells[f] == m.mesh.faces.cells[g] ? 1 : -1;
  return sign * dot(unit(m.energy.measures(f).area), unit(m.energy.measures(g).area)) >=
    (m.mesh.isWall(f) ? m.task.featureCosine : InnerCosine);
}

void proposeJoins(const Mending& m, std::uint32_t f, std::vector<ProposedEdit>& edits)
{
  const NodeMesh::Cells& cells = m.mesh.cells;
  const auto& [below, above] = m.mesh.faces.cells[f];
  const std::uint32_t c = below < cells.changing ? below : above;
  for (std::uint32_t u = cells.firstUse[c]; u < cells.endUse[c]; ++u)
  {
    if (mayJoin(m, f, cells.uses[u]))
    {
      edits.push_back({ ProposedEdit::Kind::Join, f, cells.uses[u] });
    }
  }
}

}

void proposeEdits(const Mending& mending, std::uint32_t face, std::vector<ProposedEdit>& edits)
{
  edits.clear();
  proposeCollapses(mending, face, edits);
  proposeJoins(mending, face, edits);
}

}
