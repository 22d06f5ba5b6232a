// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/ShortEdges.h"

#include "Editing/EdgeArea.h"
#include "Editing/EditMeasures.h"
#include "Editing/PrimitiveEdits.h"

#include <algorithm>
#include <tuple>

namespace cartesian
{

namespace
{

constexpr double MayGrowBy =
  1.3; // an edge that got longer than this, by edits beside it, is no longer short
constexpr std::size_t EdgesAPoll = 1024;

struct ShortEdge
{
  float share; // its length by that of a box's edge
  std::uint32_t u;
  std::uint32_t v;

  bool operator<(const ShortEdge& other) const
  {
    return std::tie(share, u, v) < std::tie(other.share, other.u, other.v);
  }
  bool operator==(const ShortEdge& other) const { return u == other.u && v == other.v; }
};

double lengthOf(const EditMesh& mesh, std::uint32_t u, std::uint32_t v)
{
  return norm(minus(mesh.node(u).at, mesh.node(v).at));
}

double edgeAt(const EditMesh& mesh, std::uint32_t n)
{
  return mesh.cell(mesh.face(mesh.facesAround(n)[0]).below).edge;
}

std::vector<ShortEdge> listShortEdges(const ZoneTask& task, double length, bool atWallOnly)
{
  const EditMesh& mesh = task.mesh;
  std::vector<ShortEdge> edges;
  task.forEachFace([&](std::uint32_t f) {
    const Items ring = mesh.cornersOf(f);
    const double box = mesh.cell(mesh.face(f).below).edge;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const std::uint32_t u = std::min(ring[i], ring[(i + 1) % ring.size()]);
      const std::uint32_t v = std::max(ring[i], ring[(i + 1) % ring.size()]);
      const bool isListed = !atWallOnly || mesh.node(u).atWall || mesh.node(v).atWall;
      if (const double share = lengthOf(mesh, u, v) / box; isListed && share < length)
      {
        edges.push_back({ static_cast<float>(share), u, v });
      }
    }
  });
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

int rankOf(const EditNode& node)
{
  return node.held == HeldFast ? 9 : int(node.kind);
}

bool isEdge(const EditMesh& mesh, std::uint32_t u, std::uint32_t v)
{
  const Items faces = mesh.facesAround(u);
  return std::any_of(faces.begin(), faces.end(), [&](std::uint32_t f) {
    const Items ring = mesh.cornersOf(f);
    const std::size_t i = placeOf(ring, u);
    return ring[(i + 1) % ring.size()] == v || ring[(i + ring.size() - 1) % ring.size()] == v;
  });
}

// Where to: to the middle between equals, to either, to the higher kind.
FixedList<Proposal, 3> waysToCollapse(const EditMesh& mesh, std::uint32_t u, std::uint32_t v)
{
  const EditNode& a = mesh.node(u);
  const EditNode& b = mesh.node(v);
  FixedList<Proposal, 3> ways;
  if (rankOf(a) == rankOf(b) && a.kind != NodeKind::Corner && a.held == b.held)
  {
    ways.add({ EditKind::Collapse, u, v, 0,
      placeKeepingArea(mesh, u, v, onLattice(mesh, scaled(plus(a.at, b.at), 0.5), a.held)) });
  }
  if (rankOf(a) <= rankOf(b))
  {
    ways.add({ EditKind::Collapse, u, v, 0, placeKeepingArea(mesh, u, v, b.at) });
  }
  if (rankOf(b) <= rankOf(a))
  {
    ways.add({ EditKind::Collapse, v, u, 0, placeKeepingArea(mesh, v, u, a.at) });
  }
  return ways;
}

}

void weldEdges(const ZoneTask& task, double length, const std::function<void()>& poll,
  std::vector<std::uint32_t>& changed)
{
  EditMesh& mesh = task.mesh;
  std::size_t count = 0;
  for (const ShortEdge& edge : listShortEdges(task, length, false))
  {
    std::uint32_t u = edge.u;
    std::uint32_t v = edge.v;
    if (++count % EdgesAPoll == 0)
    {
      poll();
    }
    if (mesh.node(u).gone || mesh.node(v).gone || !isEdge(mesh, u, v))
    {
      continue;
    }
    if (rankOf(mesh.node(u)) > rankOf(mesh.node(v)))
    {
      std::swap(u, v);
    }
    if ((mesh.node(u).held & ~mesh.node(v).held) != 0)
    {
      continue;
    }
    const EditMesh::Mark mark = mesh.mark();
    if (collapseEdge(mesh, u, v, mesh.node(v).at) && settleShapes(mesh))
    {
      passOnDebts(mesh);
      listChanged(mesh, changed);
      mesh.commit();
    }
    else
    {
      mesh.undo(mark);
    }
  }
}

void snapEdges(const ZoneTask& task, const EditRules& rules, const SnapSpec& spec,
  const std::function<void()>& poll)
{
  EditMesh& mesh = task.mesh;
  ProposalTrials trials(mesh, rules);
  std::size_t count = 0;
  for (const ShortEdge& edge : listShortEdges(task, spec.length, true))
  {
    if (++count % EdgesAPoll == 0)
    {
      poll();
    }
    if (mesh.node(edge.u).gone || mesh.node(edge.v).gone || !isEdge(mesh, edge.u, edge.v) ||
      lengthOf(mesh, edge.u, edge.v) > MayGrowBy * spec.length * edgeAt(mesh, edge.u))
    {
      continue;
    }
    trials.setBox(mesh.face(mesh.facesAround(edge.u)[0]).below);
    for (const Proposal& way : waysToCollapse(mesh, edge.u, edge.v))
    {
      if (trials.make(way, -spec.slack))
      {
        passOnDebts(mesh);
        mesh.commit();
        break;
      }
    }
  }
}

}
