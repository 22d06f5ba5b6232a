// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/ShortEdges.h"

#include "Base/Rings.h"
#include "Editing/EdgeArea.h"
#include "Editing/EditMeasures.h"
#include "Editing/PrimitiveEdits.h"
#include "Editing/VolumeDeficits.h"

#include <algorithm>
#include <tuple>

namespace cartesian
{

namespace
{

constexpr double MayGrowBy =
  1.3; // an edge that got longer than this, by edits beside it, is no longer short
constexpr std::size_t EdgesAPoll = 2; // one takes up to 10 ms in a cell with very many faces
constexpr double ThinCell = 0.15;     // of its box
constexpr double KeptOfThin = 0.99;   // of its volume

// Faces of a cell that its box is too large for; edges that go there, in boxes.
constexpr std::size_t Crowd = 64;
constexpr double ShortestOfCrowd = 0.02;
constexpr double LongestOfCrowd = 0.5;

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

double lengthOf(const MeshView& mesh, std::uint32_t u, std::uint32_t v)
{
  return norm(minus(mesh.node(u).at, mesh.node(v).at));
}

std::vector<ShortEdge> listShortEdges(const ZoneTask& task, double length, bool atWallOnly)
{
  const MeshView& mesh = task.mesh;
  std::vector<ShortEdge> edges;
  task.forEachFace([&](std::uint32_t f) {
    const Items ring = mesh.cornersOf(f);
    const double box = mesh.cell(mesh.face(f).below).edge;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const std::uint32_t u = std::min(ring[i], following(ring, i));
      const std::uint32_t v = std::max(ring[i], following(ring, i));
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
  return node.constrainedAxes == AllAxes ? 9 : int(node.kind);
}

bool isEdge(const MeshView& mesh, std::uint32_t u, std::uint32_t v)
{
  const Items faces = mesh.facesAround(u);
  return std::any_of(faces.begin(), faces.end(), [&](std::uint32_t f) {
    const Items ring = mesh.cornersOf(f);
    const std::size_t i = placeOf(ring, u);
    return following(ring, i) == v || preceding(ring, i) == v;
  });
}

// Where to: to the middle between equals, to either, to the higher kind.
FixedList<Proposal, 3> waysToCollapse(const MeshView& mesh, std::uint32_t u, std::uint32_t v)
{
  const EditNode& a = mesh.node(u);
  const EditNode& b = mesh.node(v);
  FixedList<Proposal, 3> ways;
  if (rankOf(a) == rankOf(b) && a.kind != NodeKind::Corner &&
    a.constrainedAxes == b.constrainedAxes)
  {
    ways.push({ EditKind::Collapse, u, v, 0,
      placeKeepingArea(
        mesh, u, v, onLattice(mesh, scaled(plus(a.at, b.at), 0.5), a.constrainedAxes)) });
  }
  if (rankOf(a) <= rankOf(b))
  {
    ways.push({ EditKind::Collapse, u, v, 0, placeKeepingArea(mesh, u, v, b.at) });
  }
  if (rankOf(b) <= rankOf(a))
  {
    ways.push({ EditKind::Collapse, v, u, 0, placeKeepingArea(mesh, v, u, a.at) });
  }
  return ways;
}

// Whether a cell at a node is as thin as the body: an edge may be all that lies between its walls.
bool isInThinBody(const MeshView& mesh, std::uint32_t n)
{
  const auto isThin = [&](std::uint32_t c) {
    return c != None && mesh.isFree(c) && mesh.cell(c).volume < ThinCell * mesh.cell(c).boxVolume &&
      isThinThere(mesh, c);
  };
  const Items faces = mesh.facesAround(n);
  return std::any_of(faces.begin(), faces.end(),
    [&](std::uint32_t f) { return isThin(mesh.face(f).below) || isThin(mesh.face(f).above); });
}

// Whether no cell that changed lost more of itself than rounding.
bool keepsVolumes(MeshEditor& mesh, const MeshEditor::Mark& mark)
{
  const auto& records = mesh.cellRecords();
  const bool isAnyGone =
    std::any_of(records.begin() + std::ptrdiff_t(mark.cellRecords), records.end(),
      [&](const auto& record) { return mesh.cell(record.first).gone && !record.second.gone; });
  return !isAnyGone &&
    std::all_of(mesh.dirty.cells.begin(), mesh.dirty.cells.end(), [&](std::uint32_t c) {
      const double before = mesh.changeCell(c).volume;
      measureCell(mesh, c);
      return mesh.cell(c).volume > KeptOfThin * before;
    });
}

// Makes the ends of edges one, whatever that costs.
class Welding
{
public:
  Welding(const ZoneTask& task, const EditRules& rules, const std::function<void()>& poll,
    std::vector<std::uint32_t>& changed)
    : mesh_(task.mesh)
    , rules_(rules)
    , zone_(task.zone)
    , poll_(poll)
    , changed_(changed)
  {
  }

  // If `isSound(mark)` afterwards.
  template <class IsSound>
  void weld(const ShortEdge& edge, IsSound&& isSound)
  {
    std::uint32_t u = edge.u;
    std::uint32_t v = edge.v;
    if (++count_ % EdgesAPoll == 0)
    {
      poll_();
    }
    if (mesh_.node(u).gone || mesh_.node(v).gone || !isEdge(mesh_, u, v))
    {
      return;
    }
    if (rankOf(mesh_.node(u)) > rankOf(mesh_.node(v)))
    {
      std::swap(u, v);
    }
    if (!rules_.mayChangeWalls && !mayBecome(u, v))
    {
      std::swap(u, v);
      if (!mayBecome(u, v))
      {
        return;
      }
    }
    if ((mesh_.node(u).constrainedAxes & ~mesh_.node(v).constrainedAxes) != 0)
    {
      return;
    }
    const bool isThin = isInThinBody(mesh_, u);
    const MeshEditor::Mark mark = mesh_.mark();
    if (collapseEdge(mesh_, u, v, mesh_.node(v).at) && updateShapes(mesh_) &&
      (!isThin || keepsVolumes(mesh_, mark)) && isSound(mark))
    {
      passOnDeficits(mesh_);
      listChanged(mesh_, changed_);
      mesh_.commit();
      mesh_.reclaim(zone_);
    }
    else
    {
      mesh_.undo(mark);
    }
  }

private:
  bool mayBecome(std::uint32_t u, std::uint32_t v) const
  {
    double charge = 0;
    return mayCollapse(mesh_, rules_, u, v, mesh_.node(v).at, charge);
  }

  MeshEditor& mesh_;
  const EditRules& rules_;
  const Items zone_;
  const std::function<void()>& poll_;
  std::vector<std::uint32_t>& changed_;
  std::size_t count_ = 0;
};

bool isCrowded(const MeshView& mesh, std::uint32_t c)
{
  return c != None && mesh.isFree(c) && mesh.cell(c).faces.size > Crowd;
}

bool isCrowdedAt(const MeshView& mesh, std::uint32_t n)
{
  const Items faces = mesh.facesAround(n);
  return std::any_of(faces.begin(), faces.end(), [&](std::uint32_t f) {
    return isCrowded(mesh, mesh.face(f).below) || isCrowded(mesh, mesh.face(f).above);
  });
}

bool isAnyCrowded(const ZoneTask& task)
{
  return std::any_of(
    task.cells.begin(), task.cells.end(), [&](std::uint32_t c) { return isCrowded(task.mesh, c); });
}

// Whether no face that changed folds.
bool keepsShapes(const MeshEditor& mesh, const MeshEditor::Mark& mark)
{
  constexpr float LeastStar = 0.05F;
  const auto& records = mesh.faceRecords();
  return std::all_of(
    records.begin() + std::ptrdiff_t(mark.faceRecords), records.end(), [&](const auto& record) {
      const EditFace& face = mesh.face(record.first);
      return face.gone || (face.star > LeastStar && dot(face.area, record.second.area) > 0);
    });
}

}

void collapseShortEdges(const ZoneTask& task, const EditRules& rules, double length,
  const std::function<void()>& poll, std::vector<std::uint32_t>& changed)
{
  Welding welding(task, rules, poll, changed);
  for (const ShortEdge& edge : listShortEdges(task, length, false))
  {
    welding.weld(edge, [&](const MeshEditor::Mark& mark) {
      return rules.mayChangeWalls || keepsShapes(task.mesh, mark);
    });
  }
}

void thinCrowdedCells(
  const ZoneTask& task, const std::function<void()>& poll, std::vector<std::uint32_t>& changed)
{
  const MeshView& mesh = task.mesh;
  const EditRules rules;
  Welding welding(task, rules, poll, changed);
  for (double length = ShortestOfCrowd; length < LongestOfCrowd && isAnyCrowded(task); length *= 2)
  {
    for (const ShortEdge& edge : listShortEdges(task, length, true))
    {
      if (isCrowdedAt(mesh, edge.u) &&
        lengthOf(mesh, edge.u, edge.v) < length * mesh.edgeAt(edge.u))
      {
        welding.weld(
          edge, [&](const MeshEditor::Mark& mark) { return keepsShapes(task.mesh, mark); });
      }
    }
  }
}

void snapEdges(const ZoneTask& task, const EditRules& rules, const SnapSpec& spec,
  const std::function<void()>& poll)
{
  MeshEditor& mesh = task.mesh;
  ProposalTrials trials(mesh, rules);
  std::size_t count = 0;
  for (const ShortEdge& edge : listShortEdges(task, spec.length, true))
  {
    if (++count % EdgesAPoll == 0)
    {
      poll();
    }
    if (mesh.node(edge.u).gone || mesh.node(edge.v).gone || !isEdge(mesh, edge.u, edge.v) ||
      lengthOf(mesh, edge.u, edge.v) > MayGrowBy * spec.length * mesh.edgeAt(edge.u))
    {
      continue;
    }
    trials.setBox(mesh.face(mesh.facesAround(edge.u)[0]).below);
    for (const Proposal& way : waysToCollapse(mesh, edge.u, edge.v))
    {
      if (trials.make(way, -spec.slack))
      {
        passOnDeficits(mesh);
        mesh.commit();
        break;
      }
    }
  }
}

}
