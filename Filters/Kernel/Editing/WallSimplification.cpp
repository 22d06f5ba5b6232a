// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/WallSimplification.h"

#include "Base/Rings.h"
#include "Base/Sorting.h"
#include "Editing/EdgeArea.h"
#include "Editing/EditDecision.h"
#include "Editing/EditLoop.h"
#include "Editing/EditMeasures.h"
#include "Editing/PrimitiveEdits.h"
#include "Editing/Proposals.h"
#include "Editing/ShortEdges.h"
#include "Editing/VolumeDeficits.h"
#include "Editing/WallEdges.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr int Rounds = 2;
constexpr double MostOfSharpEdge =
  0.15;                             // in boxes: of a sharp edge between two walls that become one
constexpr double LeastCosine = 0.3; // between them, unless one is small:
constexpr double SmallWall = 1e-3;  // of a box's side
constexpr double LeastStar = 0.15;  // of walls that were joined
constexpr double MostWarp = 0.15;
constexpr double LeastStarBetween = 0.05; // of faces that lost a node
constexpr double MostWarpBetween = 0.2;
constexpr std::size_t MostTried = 3; // of a wall's neighbours
constexpr std::size_t MostFacesOfNode = 12;
constexpr std::size_t Capacity = 128;
constexpr std::size_t TrialsAPoll = 4; // one takes up to 10 ms in a cell with very many walls

using Walls = FixedList<std::pair<double, std::uint32_t>, Capacity>;

class WallSimplifier
{
public:
  WallSimplifier(MeshEditor& mesh, const SimplificationSpec& spec, const EditRules& rules,
    const std::function<void()>& poll, std::vector<std::uint32_t>& changed)
    : mesh_(mesh)
    , spec_(spec)
    , rules_(rules)
    , poll_(poll)
    , changed_(changed)
  {
  }

  void joinWallsOf(std::uint32_t c)
  {
    while (joinOne(c))
    {
    }
  }

  // A node between two others, as seen from all its faces.
  void removeBetween(std::uint32_t n)
  {
    std::uint32_t p = None;
    std::uint32_t q = None;
    if (!isBetween(n, p, q))
    {
      return;
    }
    const EditNode& node = mesh_.node(n);
    const double accumulatedDeviation =
      distanceToSegment(node.at, mesh_.node(p).at, mesh_.node(q).at) +
      double(std::max({ node.accumulatedDeviation, mesh_.node(p).accumulatedDeviation,
        mesh_.node(q).accumulatedDeviation }));
    const double tolerance = node.kind >= NodeKind::OnEdge ? spec_.ofEdges : spec_.tolerance;
    if (accumulatedDeviation > tolerance * mesh_.edgeAt(n) ||
      (node.constrainedAxes & ~mesh_.node(p).constrainedAxes) != 0)
    {
      return;
    }
    const MeshEditor::Mark mark = mesh_.mark();
    bool isMade = collapseEdge(mesh_, n, p, placeKeepingArea(mesh_, n, p, mesh_.node(p).at));
    if (isMade)
    {
      mesh_.changeNode(p).accumulatedDeviation = static_cast<float>(accumulatedDeviation);
      mesh_.changeNode(q).accumulatedDeviation = static_cast<float>(accumulatedDeviation);
      isMade = areSound(LeastStarBetween, MostWarpBetween);
    }
    finish(mark, isMade);
  }

private:
  void finish(const MeshEditor::Mark& mark, bool isMade)
  {
    if (++tried_ % TrialsAPoll == 0)
    {
      poll_();
    }
    if (isMade)
    {
      passOnDeficits(mesh_);
      listChanged(mesh_, changed_);
      mesh_.commit();
    }
    else
    {
      mesh_.undo(mark);
    }
  }

  // What changed: faces star-shaped and flat enough, cells closed.
  bool areSound(double leastStar, double mostWarp)
  {
    return updateShapes(mesh_) &&
      std::all_of(mesh_.dirty.faces.begin(), mesh_.dirty.faces.end(), [&](std::uint32_t f) {
        const EditFace& face = mesh_.face(f);
        return face.gone || (face.star > leastStar && face.warp < mostWarp);
      });
  }

  bool joinOne(std::uint32_t c)
  {
    Walls walls;
    for (const std::uint32_t f : mesh_.facesOf(c))
    {
      if (mesh_.isSurface(f))
      {
        walls.offer({ norm(mesh_.face(f).area), f });
      }
    }
    std::sort(walls.begin(), walls.end());
    return std::any_of(walls.begin(), walls.end(),
      [&](const auto& wall) { return joinWithNeighbour(c, wall.second, wall.first, walls); });
  }

  // With the wall that has most nearly the same normal.
  bool joinWithNeighbour(std::uint32_t c, std::uint32_t f, double area, const Walls& walls)
  {
    const double edge = mesh_.cell(c).edge;
    Walls others;
    for (const auto& [itsArea, g] : walls)
    {
      if (g == f || mesh_.face(g).wall != mesh_.face(f).wall ||
        mesh_.beyond(g, c) != mesh_.beyond(f, c) || !areAdjacent(mesh_, f, g))
      {
        continue;
      }
      const double cosine = cosineBetween(mesh_, f, g);
      if (cosine > LeastCosine || area < SmallWall * edge * edge)
      {
        others.offer({ -cosine, g });
      }
    }
    std::sort(others.begin(), others.end());
    for (std::size_t i = 0; i < std::min(others.size(), MostTried); ++i)
    {
      if (join(others[i].second, f, edge))
      {
        return true;
      }
    }
    return false;
  }

  bool join(std::uint32_t f, std::uint32_t g, double edge)
  {
    double charge = 0;
    if (!rules_.mayChangeWalls && !mayJoin(mesh_, rules_, f, g, charge))
    {
      return false;
    }
    if (sharpnessBetween(mesh_, f, g) * sharedLength(mesh_, f, g) > MostOfSharpEdge * edge)
    {
      return false;
    }
    FixedList<Vector, 16> points;
    points.push(mesh_.face(f).centre);
    points.push(mesh_.face(g).centre);
    const Items other = mesh_.cornersOf(g);
    Vector middle{};
    double shared = 0;
    for (const std::uint32_t n : mesh_.cornersOf(f))
    {
      if (placeOf(other, n) < other.size())
      {
        if (!points.add(mesh_.node(n).at))
        {
          return false;
        }
        middle = plus(middle, mesh_.node(n).at);
        ++shared;
      }
    }
    if (!points.add(scaled(middle, 1 / shared)))
    {
      return false;
    }
    const MeshEditor::Mark mark = mesh_.mark();
    bool isMade = joinFaces(mesh_, f, g) && areSound(LeastStar, MostWarp);
    if (isMade)
    {
      double farthest = 0;
      for (const Vector& p : points)
      {
        farthest = std::max(farthest, distanceToFace(mesh_, p, f));
      }
      const double accumulatedDeviation = double(mesh_.face(f).accumulatedDeviation) + farthest;
      mesh_.changeFace(f).accumulatedDeviation = static_cast<float>(accumulatedDeviation);
      isMade = !rules_.mayChangeWalls || accumulatedDeviation < spec_.tolerance * edge;
    }
    finish(mark, isMade);
    return isMade;
  }

  bool isBetween(std::uint32_t n, std::uint32_t& p, std::uint32_t& q) const
  {
    const EditNode& node = mesh_.node(n);
    if (node.gone || !node.atWall || node.faces.size > MostFacesOfNode ||
      node.kind == NodeKind::Corner)
    {
      return false;
    }
    for (const std::uint32_t f : mesh_.facesAround(n))
    {
      const Items ring = mesh_.cornersOf(f);
      const std::size_t i = placeOf(ring, n);
      const std::uint32_t x = preceding(ring, i);
      const std::uint32_t y = following(ring, i);
      if (p == None)
      {
        p = x;
        q = y;
      }
      const bool isSame = (x == p && y == q) || (x == q && y == p);
      if (!isSame || ring.size() <= 3)
      {
        return false;
      }
    }
    return true;
  }

  MeshEditor& mesh_;
  const SimplificationSpec& spec_;
  const EditRules& rules_;
  const std::function<void()>& poll_;
  std::vector<std::uint32_t>& changed_; // cells
  std::size_t tried_ = 0;
};

void joinInPlanes(const ZoneTask& task, const SimplificationSpec& spec, const EditRules& rules,
  const std::function<void()>& poll, std::vector<std::uint32_t>& changed)
{
  WallSimplifier simplifier(task.mesh, spec, rules, poll, changed);
  for (const std::uint32_t c : task.cells)
  {
    if (task.mesh.isFree(c))
    {
      simplifier.joinWallsOf(c);
    }
  }
}

void joinWalls(const ZoneTask& task, const SimplificationSpec& spec, const EditRules& rules,
  const std::function<void()>& poll, std::vector<std::uint32_t>& changed)
{
  MeshEditor& mesh = task.mesh;
  std::vector<std::uint32_t> nodes;
  task.forEachFace([&](std::uint32_t f) {
    if (mesh.isSurface(f))
    {
      const Items ring = mesh.cornersOf(f);
      nodes.insert(nodes.end(), ring.begin(), ring.end());
    }
  });
  nodes = sortedUnique(std::move(nodes));
  WallSimplifier simplifier(mesh, spec, rules, poll, changed);
  for (int round = 0; round < Rounds; ++round)
  {
    for (const std::uint32_t c : task.cells)
    {
      if (mesh.isFree(c))
      {
        simplifier.joinWallsOf(c);
      }
    }
    for (const std::uint32_t n : nodes)
    {
      simplifier.removeBetween(n);
    }
  }
}

}

void simplifyWalls(const ZoneTask& task, const SimplificationSpec& spec, const EditRules& rules,
  const std::function<void()>& poll)
{
  MeshEditor& mesh = task.mesh;
  std::vector<std::uint32_t> changed;
  if (!rules.mayChangeWalls)
  {
    joinInPlanes(task, spec, rules, poll, changed);
  }
  collapseShortEdges(task, rules, spec.weld, poll, changed);
  if (!rules.mayChangeWalls)
  {
    joinInPlanes(task, spec, rules, poll, changed);
  }
  else
  {
    thinCrowdedCells(task, poll, changed);
    joinWalls(task, spec, rules, poll, changed);
  }
  changed = sortedUnique(std::move(changed));
  for (const std::uint32_t c : changed)
  {
    if (mesh.isFree(c))
    {
      measureCell(mesh, c);
    }
  }
  costCells(mesh, { changed.data(), changed.data() + changed.size() }, rules.objective);
}

}
