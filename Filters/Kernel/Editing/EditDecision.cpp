// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/EditDecision.h"

#include "Base/Rings.h"
#include "Editing/CellClosure.h"
#include "Editing/EdgeArea.h"
#include "Editing/EditMeasures.h"
#include "Editing/PrimitiveEdits.h"
#include "Editing/VolumeDeficits.h"
#include "Editing/WallEdges.h"

#include <cmath>

namespace cartesian
{

namespace
{

constexpr double LeastShare = 1e-9; // of its box, of any cell

// For a node where more than two sharp edges meet, and that goes.
constexpr double ChargeOfCorner = 3;

// A wall that moves so far costs (d / distance)^2 / 2, both in boxes.
double chargeOfDistance(double distance, const ObjectiveSpec& spec)
{
  const double share = distance / spec.distance;
  return share * share / 2;
}

bool hasTwin(const MeshView& mesh, std::uint32_t f)
{
  const Items ring = mesh.cornersOf(f);
  std::uint32_t least = ring[0];
  for (const std::uint32_t n : ring)
  {
    least = mesh.node(n).faces.size < mesh.node(least).faces.size ? n : least;
  }
  for (const std::uint32_t g : mesh.facesAround(least))
  {
    const Items other = mesh.cornersOf(g);
    if (g != f && other.size() == ring.size() &&
      std::all_of(ring.begin(), ring.end(),
        [&](std::uint32_t n) { return placeOf(other, n) < other.size(); }))
    {
      return true;
    }
  }
  return false;
}

// Measures faces of other corners; their cells are dirty too.
bool updateFaces(MeshEditor& mesh)
{
  const bool areFree = std::all_of(mesh.dirty.faces.begin(), mesh.dirty.faces.end(),
    [&](std::uint32_t f) { return mesh.face(f).gone || mesh.areCellsFree(f); });
  for (std::size_t i = 0; areFree && i < mesh.dirty.faces.size(); ++i)
  {
    const std::uint32_t f = mesh.dirty.faces[i];
    if (mesh.face(f).gone)
    {
      continue;
    }
    if (mesh.face(f).corners.size < 3)
    {
      return false;
    }
    mesh.changeFace(f);
    measureFace(mesh, f);
    for (const std::uint32_t c : { mesh.face(f).below, mesh.face(f).above })
    {
      c != None ? mesh.dirty.cells.add(c) : void();
    }
  }
  return areFree;
}

template <class IsClosed>
bool areShapesValid(MeshEditor& mesh, IsClosed&& isClosed)
{
  const DirtySets& dirty = mesh.dirty;
  return dirty.shapes.size() == 0 ||
    (std::all_of(dirty.shapes.begin(), dirty.shapes.end(),
       [&](std::uint32_t c) { return !mesh.isFree(c) || isClosed(mesh, c); }) &&
      std::none_of(dirty.faces.begin(), dirty.faces.end(),
        [&](std::uint32_t f) { return !mesh.face(f).gone && hasTwin(mesh, f); }));
}

void lowerAllMisses(MeshEditor& mesh)
{
  for (const std::uint32_t c : mesh.dirty.shapes)
  {
    if (mesh.isFree(c))
    {
      lowerMisses(mesh, c);
    }
  }
}

bool updateCells(MeshEditor& mesh)
{
  for (const std::uint32_t c : mesh.dirty.cells)
  {
    if (!mesh.isFree(c))
    {
      continue;
    }
    EditCell& cell = mesh.changeCell(c);
    measureCell(mesh, c);
    if (!(cell.volume > LeastShare * cell.boxVolume))
    {
      return false;
    }
    const Cost<double> cost = costOfCell(mesh, c);
    mesh.delta.cost += cost.value - cell.cost;
    mesh.delta.strains += int(cost.strains) - int(cell.strains);
    cell.cost = cost.value;
    cell.strains = cost.strains;
  }
  return true;
}

// All faces of the dirty cells, those that changed themselves first: they decide most trials.
class FacesToUpdate
{
public:
  // False: there are more than is worth a trial.
  bool collect(const MeshEditor& mesh)
  {
    FixedList<std::uint32_t, MostFacesChanged> others;
    for (const std::uint32_t c : mesh.dirty.cells)
    {
      if (!mesh.isFree(c))
      {
        continue;
      }
      for (const std::uint32_t f : mesh.facesOf(c))
      {
        const std::uint32_t other = mesh.beyond(f, c);
        const bool isSeen =
          other != None && other < c && mesh.dirty.cells.contains(other) && mesh.isFree(other);
        if (!isSeen)
        {
          left_ += mesh.face(f).cost;
          if (!(mesh.dirty.faces.contains(f) ? faces_.add(f) : others.add(f)))
          {
            return false;
          }
        }
      }
    }
    return std::all_of(
      others.begin(), others.end(), [&](std::uint32_t f) { return faces_.add(f); });
  }

  bool updateAndValidate(MeshEditor& mesh, const ObjectiveSpec& spec, double most)
  {
    double sum = mesh.delta.cost - left_;
    costs_.clear();
    for (const std::uint32_t f : faces_)
    {
      costs_.push(costOfFace(mesh, f, spec));
      sum += costs_.back().value;
      if (sum > most)
      {
        return false;
      }
    }
    for (std::size_t i = 0; i < faces_.size(); ++i)
    {
      setCostOfFace(mesh, faces_[i], costs_[i]);
    }
    return true;
  }

private:
  static void setCostOfFace(MeshEditor& mesh, std::uint32_t f, const Cost<double>& cost)
  {
    EditFace& face = mesh.changeFace(f);
    mesh.delta.cost += cost.value - face.cost;
    mesh.delta.count(face, -1);
    setCost(face, cost);
    mesh.delta.count(face, 1);
  }

  FixedList<std::uint32_t, MostFacesChanged> faces_;
  FixedList<Cost<double>, MostFacesChanged> costs_;
  double left_ = 0; // what they cost before
};

// Whether a place is on the planes that hold a node.
bool isOnPlanesOf(const EditNode& node, const Vector& at)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if ((node.constrainedAxes >> axis & 1) != 0 && at[axis] != node.at[axis])
    {
      return false;
    }
  }
  return true;
}

// A node on a sharp edge moves along it, and its edge may not leave `at` far behind; false: not at all.
bool mayLeaveEdge(const MeshView& mesh, const EditRules& rules, std::uint32_t u, std::uint32_t v,
  const Vector& at, bool isSharp, double& charge)
{
  const SharpEnds ends = sharpEndsAt(mesh, u);
  if (ends.size() < 2)
  {
    return ends.empty() || isSharp;
  }
  if (!isSharp)
  {
    return false;
  }
  const double edge = mesh.cell(mesh.face(mesh.facesAround(u)[0]).below).edge;
  double worst = 0;
  for (const std::uint32_t end : ends)
  {
    if (end != v)
    {
      worst = std::max(worst, distanceToSegment(mesh.node(u).at, at, mesh.node(end).at) / edge);
    }
  }
  charge += 2 * chargeOfDistance(worst, rules.objective) + (ends.size() > 2 ? ChargeOfCorner : 0) +
    rules.objective.volume * areaLost(mesh, u, v, at) / (edge * edge);
  return worst <= rules.objective.mostMoved;
}

// --- what walls that must not change may still lose

constexpr double Rounding = 2; // levels

// Whether a node lies on a straight line from another to a third, as seen from all faces around it.
bool liesOnLine(const MeshView& mesh, std::uint32_t u, std::uint32_t v)
{
  const Items faces = mesh.facesAround(u);
  const auto beside = [&](std::uint32_t f, std::size_t by) {
    const Items ring = mesh.cornersOf(f);
    return ring[(placeOf(ring, u) + by) % ring.size()];
  };
  const auto besideV = [&](std::uint32_t f) {
    const std::uint32_t before = beside(f, mesh.face(f).corners.size - 1);
    return before == v ? beside(f, 1) : before;
  };
  const std::uint32_t end = besideV(faces[0]);
  return distanceToSegment(mesh.node(u).at, mesh.node(v).at, mesh.node(end).at) <=
    Rounding * mesh.level() &&
    std::all_of(faces.begin(), faces.end(), [&](std::uint32_t f) {
      return besideV(f) == end &&
        (beside(f, 1) == v || beside(f, mesh.face(f).corners.size - 1) == v);
    });
}

// Whether a wall stays in its plane, and looks the same way, when one of its nodes moves.
bool staysInPlane(const MeshView& mesh, std::uint32_t f, std::uint32_t n, const Vector& way)
{
  const Vector normal = unit(mesh.face(f).area);
  const Items ring = mesh.cornersOf(f);
  const std::size_t i = placeOf(ring, n);
  const Vector across = minus(mesh.node(following(ring, i)).at, mesh.node(preceding(ring, i)).at);
  // Of a narrow wall the normal is known less well than that.
  double longest = 0;
  for (std::size_t j = 0; j < ring.size(); ++j)
  {
    longest =
      std::max(longest, norm(minus(mesh.corner(f, (j + 1) % ring.size()), mesh.corner(f, j))));
  }
  const bool isKnown =
    norm(way) <= 2 * Rounding * mesh.level() || 2 * norm(mesh.face(f).area) >= norm(way) * longest;
  return isKnown && std::abs(dot(normal, way)) <= Rounding * mesh.level() &&
    norm(mesh.face(f).area) + dot(normal, cross(way, across)) / 2 >= 0;
}

// Whether a node may become another without a wall that leaves its plane, or a sharp edge its line.
bool staysInWalls(const MeshView& mesh, std::uint32_t u, std::uint32_t v)
{
  const double rounding = Rounding * mesh.level();
  const EditNode& node = mesh.node(u);
  const Vector way = minus(mesh.node(v).at, node.at);
  const Items faces = mesh.facesAround(u);
  if (node.kind == NodeKind::Corner ||
    !std::all_of(faces.begin(), faces.end(),
      [&](std::uint32_t f) { return !mesh.isSurface(f) || staysInPlane(mesh, f, u, way); }))
  {
    return false;
  }
  const SharpEnds ends = sharpEndsAt(mesh, u);
  if (ends.size() != 2)
  {
    return ends.empty() && node.kind == NodeKind::OnSurface;
  }
  const Vector& from = mesh.node(ends[0]).at;
  const Vector& to = mesh.node(ends[1]).at;
  return distanceToSegment(node.at, from, to) <= rounding &&
    distanceToSegment(mesh.node(v).at, from, to) <= rounding;
}

bool areInOnePlane(const MeshView& mesh, std::uint32_t f, std::uint32_t g)
{
  if (norm(mesh.face(f).area) < norm(mesh.face(g).area))
  {
    std::swap(f, g);
  }
  const Vector normal = unit(mesh.face(f).area);
  const Items ring = mesh.cornersOf(g);
  return cosineBetween(mesh, f, g) > 0 &&
    std::all_of(ring.begin(), ring.end(), [&](std::uint32_t n) {
      return std::abs(dot(normal, minus(mesh.node(n).at, mesh.face(f).centre))) <=
        Rounding * mesh.level();
    });
}

constexpr double MostLost = 0.1; // of what cells held, by one edit and by all

// What the cells that changed held.
double heldBefore(const MeshEditor& mesh)
{
  double held = 0;
  for (const auto& [c, was] : mesh.cellRecords())
  {
    held += was.gone ? 0 : was.volume;
  }
  return held;
}

// Whether most of that stays theirs: a body thinner than boxes is all that is there.
bool keepsBody(const MeshEditor& mesh, double held)
{
  return std::max(std::abs(mesh.delta.volume), 2 * std::abs(mesh.delta.interRegionVolume)) <=
    MostLost * held;
}

// Whether the walls that changed are as large as before: none is folded, or lies on another.
bool keepsAreas(const MeshEditor& mesh)
{
  constexpr std::size_t Most = 256;
  constexpr double Little = 1e-7; // of the area
  FixedList<std::uint32_t, Most> seen;
  double before = 0;
  double after = 0;
  for (const auto& [f, was] : mesh.faceRecords())
  {
    if (seen.contains(f))
    {
      continue;
    }
    if (!seen.add(f))
    {
      return false;
    }
    const EditFace& is = mesh.face(f);
    before += !was.gone && isSurface(was) ? norm(was.area) : 0;
    after += !is.gone && isSurface(is) ? norm(is.area) : 0;
  }
  return std::abs(after - before) <= Little * before;
}

// Whether walls have not drifted too far, or owe less than before; of more than some it is not asked.
bool mayLeaveDeficit(const MeshEditor& mesh, const ObjectiveSpec& spec, double box, double held)
{
  const double most = MostLost * held;
  const auto may = [&](bool ofWalls) {
    const ChangedDeficit deficit = changedDeficit(mesh, ofWalls);
    const double after = std::abs(deficit.after);
    if (deficit.walls > MostFacesChanged)
    {
      return false;
    }
    return after <= std::min(spec.mostDrift * std::cbrt(box) * deficit.area, most) ||
      after <= std::abs(deficit.before);
  };
  return may(true) && (mesh.delta.interRegionVolume == 0 || may(false));
}

}

bool updateAndValidate(MeshEditor& mesh, const ObjectiveSpec& spec, const NeededGain& needed)
{
  FacesToUpdate faces;
  const auto most = [&] { // that all faces and cells may cost, with the volume as it is
    return mesh.delta.cost + gainOf(mesh, spec, needed.box) - needed.gain;
  };
  const bool isValid = updateFaces(mesh) && faces.collect(mesh) && updateCells(mesh) &&
    faces.updateAndValidate(mesh, spec, most()) && areShapesValid(mesh, isClosedByCount);
  if (isValid)
  {
    lowerAllMisses(mesh);
  }
  mesh.dirty.clear();
  return isValid;
}

bool updateShapes(MeshEditor& mesh)
{
  constexpr std::size_t Many =
    256; // there are many such edits, and few that are right by the count alone
  const auto isClosedAsFarAsWorthIt = [](MeshEditor& of, std::uint32_t c) {
    return of.cell(c).faces.size > Many ? isClosedByCount(of, c) : isClosed(of, c);
  };
  const bool isValid = updateFaces(mesh) && areShapesValid(mesh, isClosedAsFarAsWorthIt);
  if (isValid)
  {
    lowerAllMisses(mesh);
  }
  return isValid;
}

bool areAllClosed(MeshEditor& mesh, const MeshEditor::Mark& mark)
{
  for (std::size_t i = mark.cellRecords; i < mesh.cellRecords().size(); ++i)
  {
    const std::uint32_t c = mesh.cellRecords()[i].first;
    if (mesh.isFree(c) && !isClosed(mesh, c))
    {
      return false;
    }
  }
  return true;
}

double gainOf(const MeshEditor& mesh, const ObjectiveSpec& spec, double box)
{
  const EditDelta& delta = mesh.delta;
  const double moved = std::abs(delta.volume) + std::abs(delta.interRegionVolume);
  return -delta.cost - spec.volume * moved / box - delta.fidelity;
}

bool mayCollapse(const MeshView& mesh, const EditRules& rules, std::uint32_t u, std::uint32_t v,
  const Vector& at, double& charge)
{
  const EditNode& from = mesh.node(u);
  const EditNode& to = mesh.node(v);
  const bool moves = at != to.at;
  if (from.gone || to.gone || (from.atWall && !to.atWall) ||
    (from.constrainedAxes & ~to.constrainedAxes) != 0 ||
    (moves && to.constrainedAxes != from.constrainedAxes) || !isOnPlanesOf(from, at) ||
    !isOnPlanesOf(to, at))
  {
    return false;
  }
  if (moves && (to.kind == NodeKind::Corner || (to.atWall && !rules.mayChangeWalls)))
  {
    return false;
  }
  if (!from.atWall)
  {
    return true;
  }
  const WallEdge edge = wallEdgeOf(mesh, u, v);
  if (!rules.mayChangeWalls)
  {
    return liesOnLine(mesh, u, v) || (edge.isWall && staysInWalls(mesh, u, v));
  }
  if (!edge.isWall)
  {
    return false;
  }
  return from.kind < NodeKind::OnEdge || mayLeaveEdge(mesh, rules, u, v, at, edge.isSharp, charge);
}

bool mayMove(const MeshView& mesh, const EditRules& rules, std::uint32_t n, const Vector& to)
{
  const EditNode& node = mesh.node(n);
  return (rules.mayChangeWalls || !node.atWall) && isOnPlanesOf(node, to) &&
    node.kind != NodeKind::Corner &&
    (node.kind == NodeKind::Free ||
      norm(minus(to, node.referencePosition)) <= double(node.maxDisplacement));
}

bool mayJoin(
  const MeshView& mesh, const EditRules& rules, std::uint32_t f, std::uint32_t g, double& charge)
{
  if (!rules.mayChangeWalls && mesh.isSurface(f))
  {
    return areInOnePlane(mesh, f, g);
  }
  if (const double sharpness = sharpnessBetween(mesh, f, g); sharpness > 0)
  {
    const double edge = mesh.cell(mesh.face(f).below).edge;
    charge += rules.objective.sharpEdge * sharpness * sharedLength(mesh, f, g) / edge;
  }
  return true;
}

bool mayMerge(const MeshView& mesh, const EditRules& rules, std::uint32_t a, std::uint32_t b)
{
  return std::min(shareOf(mesh, a), shareOf(mesh, b)) < rules.mostMerged;
}

double decide(const MeshEditor& mesh, const EditRules& rules, const MeshEditor::Mark& mark,
  double box, double least)
{
  const EditDelta& delta = mesh.delta;
  if (delta.failures > 0 || (delta.failures == 0 && delta.strains > 0) ||
    (!rules.mayTrade && (delta.inverted > 0 || delta.skew > 0)) ||
    delta.fidelity > rules.objective.mostLost)
  {
    return NoGain;
  }
  const double gain = gainOf(mesh, rules.objective, box);
  if (!(gain > least) || (!rules.mayChangeWalls && !keepsAreas(mesh)))
  {
    return NoGain;
  }
  const double distance = distanceOfWalls(mesh, mark) / std::cbrt(box);
  const double net = gain - chargeOfDistance(distance, rules.objective);
  const double held = heldBefore(mesh);
  if (distance > rules.objective.mostMoved || !(net > least) || !keepsBody(mesh, held) ||
    !mayLeaveDeficit(mesh, rules.objective, box, held))
  {
    return NoGain;
  }
  return net;
}

}
