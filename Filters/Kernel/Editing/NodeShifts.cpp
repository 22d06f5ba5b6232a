// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/NodeShifts.h"

#include "Base/Rings.h"
#include "Editing/EditMeasures.h"
#include "Editing/PrimitiveEdits.h"
#include "Editing/WallOpening.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr double SmoothCosine = 0.9; // 26 degrees
constexpr int RoundsOfHalving = 2;   // then nodes of poor faces go back, and those of their cells
constexpr int Rounds = 16;
constexpr std::size_t ItemsAChunk = 1024;

// Of walls, or of faces between the same two regions; all cells may change.
bool isAmongFreeWalls(const MeshView& mesh, std::uint32_t n)
{
  const EditNode& node = mesh.node(n);
  if (node.gone || !node.atWall)
  {
    return false;
  }
  const Items faces = mesh.facesAround(n);
  const auto isAny = [&](bool wall) {
    return std::any_of(faces.begin(), faces.end(),
      [&](std::uint32_t f) { return mesh.isSurface(f) && mesh.isWall(f) == wall; });
  };
  return std::all_of(faces.begin(), faces.end(),
           [&](std::uint32_t f) {
             const EditFace& face = mesh.face(f);
             return mesh.isFree(face.below) && (face.above == None || mesh.isFree(face.above));
           }) &&
    !(isAny(true) && isAny(false));
}

}

bool isFreeWall(const MeshView& mesh, std::uint32_t f)
{
  return !mesh.face(f).gone && mesh.isSurface(f) && mesh.isFree(mesh.face(f).below);
}

bool maySlide(const MeshView& mesh, std::uint32_t n)
{
  const EditNode& node = mesh.node(n);
  return node.kind == NodeKind::OnSurface && node.constrainedAxes == 0 && isAmongFreeWalls(mesh, n);
}

bool maySlideInPlane(const MeshView& mesh, std::uint32_t n)
{
  const EditNode& node = mesh.node(n);
  const bool isInOne =
    node.constrainedAxes != 0 && (node.constrainedAxes & (node.constrainedAxes - 1)) == 0;
  return node.kind == NodeKind::OnEdge && isInOne && isAmongFreeWalls(mesh, n);
}

bool isSmoothAt(const MeshView& mesh, std::uint32_t n, const Vector& normal)
{
  const Items faces = mesh.facesAround(n);
  return std::all_of(faces.begin(), faces.end(), [&](std::uint32_t f) {
    const Vector& area = mesh.face(f).area;
    return !isFreeWall(mesh, f) || mesh.signOf(f) * dot(area, normal) >= SmoothCosine * norm(area);
  });
}

Vector normalOfWalls(const MeshView& mesh, std::uint32_t n)
{
  Vector sum{};
  for (const std::uint32_t f : mesh.facesAround(n))
  {
    sum = isFreeWall(mesh, f) && !isWallOfEnd(mesh.face(f).wall)
      ? plus(sum, scaled(mesh.face(f).area, mesh.signOf(f)))
      : sum;
  }
  return unit(sum);
}

NodeShifts::NodeShifts(
  EditMesh& whole, const ObjectiveSpec& spec, double mostCost, Execution& execution)
  : whole_(whole)
  , mesh_(whole, 0, 0, {})
  , spec_(spec)
  , mostCost_(mostCost)
  , execution_(execution)
  , shifts_(whole.nodes.size())
{
  forEach(shifts_.size(), [&](std::uint32_t n) {
    shifts_[n] = {};
    shifts_[n].before = mesh_.node(n).at;
  });
}

void NodeShifts::forEach(std::size_t count, const std::function<void(std::uint32_t)>& visit)
{
  execution_.forEach(count, ItemsAChunk, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i)
    {
      visit(i);
    }
  });
}

void NodeShifts::plan(const std::function<Vector(std::uint32_t)>& way)
{
  forEach(shifts_.size(), [&](std::uint32_t n) {
    shifts_[n].way = way(n);
    shifts_[n].part = shifts_[n].way == Vector{} ? 0 : 1;
  });
}

void NodeShifts::make()
{
  find(near_, nullptr);
  forEach(shifts_.size(), [&](std::uint32_t n) {
    if (hasMoved(n))
    {
      place(n);
    }
  });
  measure(near_);
  isPoor_.assign(whole_.faces.size(), 0);
  findPoor(near_);
  for (int round = 0; round < Rounds && takeBack(round); ++round)
  {
    find(now_, &Shift::isTakenBack);
    measure(now_);
    findPoor(now_);
  }
  setCosts();
  passOver();
}

void NodeShifts::place(std::uint32_t n)
{
  const Shift& shift = shifts_[n];
  EditNode& node = whole_.nodes[n];
  node.at = shift.part == 0
    ? shift.before
    : onLattice(mesh_, plus(shift.before, scaled(shift.way, shift.part)), node.constrainedAxes);
}

// Of nodes that move, or of some of them.
void NodeShifts::find(Reach& reach, bool Shift::*isTakenBack)
{
  const auto isMeant = [&](std::uint32_t n) {
    return isTakenBack ? shifts_[n].*isTakenBack : hasMoved(n);
  };
  reach.faces.assign(whole_.faces.size(), 0);
  forEach(reach.faces.size(), [&](std::uint32_t f) {
    const Items ring = mesh_.cornersOf(f);
    reach.faces[f] = !mesh_.face(f).gone && std::any_of(ring.begin(), ring.end(), isMeant) ? 1 : 0;
  });
  reach.cells.assign(whole_.cells.size(), 0);
  forEach(reach.cells.size(), [&](std::uint32_t c) {
    const Items faces = mesh_.facesOf(c);
    reach.cells[c] = mesh_.isFree(c) &&
        std::any_of(
          faces.begin(), faces.end(), [&](std::uint32_t f) { return reach.faces[f] != 0; })
      ? 1
      : 0;
  });
}

// Nothing else has changed.
void NodeShifts::measure(const Reach& reach)
{
  forEach(reach.faces.size(), [&](std::uint32_t f) {
    if (reach.faces[f] != 0)
    {
      MeshEditor mesh(whole_, 0, 0, {});
      measureFace(mesh, f);
    }
  });
  forEach(reach.cells.size(), [&](std::uint32_t c) {
    if (reach.cells[c] != 0)
    {
      MeshEditor mesh(whole_, 0, 0, {});
      measureCell(mesh, c);
    }
  });
}

// Whether what a face costs may have changed.
bool NodeShifts::dependsOn(const Reach& reach, std::uint32_t f) const
{
  const EditFace& face = mesh_.face(f);
  return !face.gone &&
    (reach.cells[face.below] != 0 || (face.above != None && reach.cells[face.above] != 0));
}

void NodeShifts::findPoor(const Reach& reach)
{
  forEach(isPoor_.size(), [&](std::uint32_t f) {
    if (dependsOn(reach, f))
    {
      isPoor_[f] = isWorse(f) ? 1 : 0;
    }
  });
}

bool NodeShifts::isWorse(std::uint32_t f) const
{
  const EditFace& face = mesh_.face(f);
  const Cost<double> cost = costOfFace(mesh_, f, spec_);
  return cost.fails > int(face.fails) || cost.value > face.cost + mostCost_;
}

// Halves what nodes of faces that became poor have moved; later takes it back. False: there are none.
bool NodeShifts::takeBack(int round)
{
  if (std::find(isPoor_.begin(), isPoor_.end(), 1) == isPoor_.end())
  {
    return false;
  }
  forEach(shifts_.size(), [&](std::uint32_t n) {
    Shift& shift = shifts_[n];
    shift.isTakenBack = shift.part != 0 && isAnyPoor(n, round >= RoundsOfHalving);
    if (shift.isTakenBack)
    {
      shift.part = round < RoundsOfHalving ? shift.part / 2 : 0;
      place(n);
    }
  });
  return true;
}

// Of the faces around a node, or also of their cells.
bool NodeShifts::isAnyPoor(std::uint32_t n, bool ofCells) const
{
  const auto is = [&](std::uint32_t f) { return isPoor_[f] != 0; };
  const Items faces = mesh_.facesAround(n);
  bool isAny = std::any_of(faces.begin(), faces.end(), is);
  for (std::size_t i = 0; ofCells && i < faces.size() && !isAny; ++i)
  {
    for (const std::uint32_t c : { mesh_.face(faces[i]).below, mesh_.face(faces[i]).above })
    {
      const Items others = c == None ? faces : mesh_.facesOf(c);
      isAny = isAny || std::any_of(others.begin(), others.end(), is);
    }
  }
  return isAny;
}

void NodeShifts::setCosts()
{
  forEach(near_.cells.size(), [&](std::uint32_t c) {
    if (near_.cells[c] != 0)
    {
      MeshEditor mesh(whole_, 0, 0, {});
      setCostOfCell(mesh, c);
    }
  });
  forEach(near_.faces.size(), [&](std::uint32_t f) {
    if (dependsOn(near_, f))
    {
      MeshEditor mesh(whole_, 0, 0, {});
      setCostOfFace(mesh, f, spec_);
    }
  });
}

// The volume that a wall has passed over, as the triangles around the mean of its corners enclose it. Their areas are
// of second degree in time: Simpson's rule is exact.
double NodeShifts::sweptBy(std::uint32_t f) const
{
  const Items ring = mesh_.cornersOf(f);
  const auto at = [&](std::uint32_t n, double time) {
    return plus(scaled(shifts_[n].before, 1 - time), scaled(mesh_.node(n).at, time));
  };
  const auto moved = [&](std::uint32_t n) { return minus(mesh_.node(n).at, shifts_[n].before); };
  const double share = 1 / double(ring.size());
  double volume = 0;
  for (const auto& [time, weight] : { std::pair{ 0.0, 1.0 }, { 0.5, 4.0 }, { 1.0, 1.0 } })
  {
    Vector mean{};
    Vector meanMoved{};
    for (const std::uint32_t n : ring)
    {
      mean = plus(mean, scaled(at(n, time), share));
      meanMoved = plus(meanMoved, scaled(moved(n), share));
    }
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const std::uint32_t p = ring[i];
      const std::uint32_t q = following(ring, i);
      const Vector area = cross(minus(at(p, time), mean), minus(at(q, time), mean));
      volume += weight * dot(plus(plus(moved(p), moved(q)), meanMoved), area);
    }
  }
  return volume / 36; // 6 of the rule, 3 of the mean, 2 of areas
}

void NodeShifts::passOver()
{
  forEach(whole_.faces.size(), [&](std::uint32_t f) {
    EditFace& face = whole_.faces[f];
    if (!face.gone && isSurface(face) && near_.faces[f] != 0)
    {
      face.volumeDeficit -= sweptBy(f);
    }
  });
}

}
