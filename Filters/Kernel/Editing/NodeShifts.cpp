// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/NodeShifts.h"

#include "Base/Rings.h"
#include "Base/Sorting.h"
#include "Editing/EditMeasures.h"
#include "Editing/PrimitiveEdits.h"
#include "Editing/WallOpening.h"

#include <algorithm>
#include <numeric>

namespace cartesian
{

namespace
{

constexpr double SmoothCosine = 0.9; // 26 degrees
constexpr int RoundsOfHalving = 2;   // then nodes of poor faces go back, and those of their cells
constexpr int Rounds = 16;
constexpr std::size_t ItemsAChunk = 256;

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
  , shiftOf_(whole.nodes.size())
  , stamps_{ 0, std::vector<std::uint8_t>(whole.faces.size()),
    std::vector<std::uint8_t>(whole.cells.size()) }
  , costs_(whole.faces.size())
  , isPoor_(whole.faces.size(), 0)
{
}

template <class Visitor>
void NodeShifts::forEach(const std::vector<std::uint32_t>& list, Visitor&& visit) const
{
  execution_.forEach(list.size(), ItemsAChunk, [&](std::size_t begin, std::size_t end) {
    MeshEditor mesh(whole_, 0, 0, {});
    for (std::size_t i = begin; i < end; ++i)
    {
      visit(mesh, list[i]);
    }
  });
}

// What add(i, list) adds for 0 to count - 1, in their order.
template <class Add>
std::vector<std::uint32_t> NodeShifts::gather(std::size_t count, Add&& add) const
{
  std::vector<std::vector<std::uint32_t>> ofChunks(chunks(count, ItemsAChunk));
  execution_.forEach(count, ItemsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      add(i, ofChunks[begin / ItemsAChunk]);
    }
  });
  return concatenated(ofChunks);
}

void NodeShifts::plan(const std::function<Vector(std::uint32_t)>& way)
{
  std::vector<std::vector<Shift>> ofChunks(chunks(shiftOf_.size(), ItemsAChunk));
  execution_.forEach(shiftOf_.size(), ItemsAChunk, [&](std::size_t begin, std::size_t end) {
    for (auto n = static_cast<std::uint32_t>(begin); n < end; ++n)
    {
      shiftOf_[n] = None;
      if (const Vector its = way(n); its != Vector{})
      {
        ofChunks[begin / ItemsAChunk].push_back({ n, mesh_.node(n).at, its });
      }
    }
  });
  std::vector<std::size_t> first(ofChunks.size());
  std::transform(ofChunks.begin(), ofChunks.end(), first.begin(),
    [](const std::vector<Shift>& some) { return some.size(); });
  shifts_.resize(scan(first));
  execution_.forEach(ofChunks.size(), 1, [&](std::size_t i, std::size_t) {
    for (std::size_t s = 0; s < ofChunks[i].size(); ++s)
    {
      shifts_[first[i] + s] = ofChunks[i][s];
      shiftOf_[ofChunks[i][s].node] = static_cast<std::uint32_t>(first[i] + s);
    }
  });
}

void NodeShifts::make()
{
  std::vector<std::uint32_t> all(shifts_.size());
  std::iota(all.begin(), all.end(), 0);
  const Reach near = reachOf(all, [](const Shift&) { return true; });
  forEach(all, [&](const MeshEditor&, std::uint32_t s) { place(shifts_[s]); });
  measure(near);
  findPoor(near);
  for (int round = 0; round < Rounds && !poor_.empty(); ++round)
  {
    const std::vector<std::uint32_t> some = takeBack(round);
    const Reach now = reachOf(some, [](const Shift& shift) { return shift.isTakenBack; });
    measure(now);
    findPoor(now);
    forEach(some, [&](const MeshEditor&, std::uint32_t s) { shifts_[s].isTakenBack = false; });
  }
  setCosts(near);
  passOver(near);
}

void NodeShifts::place(Shift& shift)
{
  EditNode& node = whole_.nodes[shift.node];
  node.at = shift.part == 0
    ? shift.before
    : onLattice(mesh_, plus(shift.before, scaled(shift.way, shift.part)), node.constrainedAxes);
}

// A face is added by the first of its nodes that is meant, a cell by the first of its faces.
template <class IsMeant>
NodeShifts::Reach NodeShifts::reachOf(const std::vector<std::uint32_t>& shifts, IsMeant&& isMeant)
{
  Reach reach;
  reach.stamp = static_cast<std::uint8_t>(++stamps_.last);
  const auto isOne = [&](std::uint32_t n) {
    return shiftOf_[n] != None && isMeant(shifts_[shiftOf_[n]]);
  };
  reach.faces = gather(shifts.size(), [&](std::size_t i, std::vector<std::uint32_t>& list) {
    const std::uint32_t n = shifts_[shifts[i]].node;
    for (const std::uint32_t f : mesh_.facesAround(n))
    {
      const Items ring = mesh_.cornersOf(f);
      *std::find_if(ring.begin(), ring.end(), isOne) == n ? list.push_back(f) : void();
    }
  });
  forEach(reach.faces, [&](const MeshEditor&, std::uint32_t f) { stamps_.faces[f] = reach.stamp; });
  reach.cells = gather(reach.faces.size(), [&](std::size_t i, std::vector<std::uint32_t>& list) {
    const std::uint32_t f = reach.faces[i];
    for (const std::uint32_t c : { mesh_.face(f).below, mesh_.face(f).above })
    {
      const auto isFirst = [&] {
        const Items faces = mesh_.facesOf(c);
        return *std::find_if(faces.begin(), faces.end(),
                 [&](std::uint32_t g) { return stamps_.faces[g] >= reach.stamp; }) == f;
      };
      c != None&& mesh_.isFree(c) && isFirst() ? list.push_back(c) : void();
    }
  });
  forEach(reach.cells, [&](const MeshEditor&, std::uint32_t c) { stamps_.cells[c] = reach.stamp; });
  return reach;
}

// Of the faces whose costs may have changed: those of the cells, each once.
template <class Visitor>
void NodeShifts::forEachDependent(const Reach& reach, Visitor&& visit) const
{
  execution_.forEach(reach.cells.size(), ItemsAChunk, [&](std::size_t begin, std::size_t end) {
    MeshEditor mesh(whole_, 0, 0, {});
    for (std::size_t i = begin; i < end; ++i)
    {
      const std::uint32_t c = reach.cells[i];
      for (const std::uint32_t f : mesh_.facesOf(c))
      {
        const std::uint32_t below = mesh_.face(f).below;
        below == c || stamps_.cells[below] < reach.stamp ? visit(mesh, f, begin / ItemsAChunk)
                                                         : void();
      }
    }
  });
}

// Nothing else has changed.
void NodeShifts::measure(const Reach& reach)
{
  forEach(reach.faces, [](MeshEditor& mesh, std::uint32_t f) { measureFace(mesh, f); });
  forEach(reach.cells, [](MeshEditor& mesh, std::uint32_t c) { measureCell(mesh, c); });
}

void NodeShifts::findPoor(const Reach& reach)
{
  std::vector<std::vector<std::uint32_t>> more(chunks(reach.cells.size(), ItemsAChunk));
  forEachDependent(reach, [&](const MeshEditor&, std::uint32_t f, std::size_t chunk) {
    costs_[f] = costOfFace(mesh_, f, spec_);
    const bool is = isWorse(f);
    is&& isPoor_[f] == 0 ? more[chunk].push_back(f) : void();
    isPoor_[f] = is ? 1 : 0;
  });
  poor_.erase(
    std::remove_if(poor_.begin(), poor_.end(), [&](std::uint32_t f) { return isPoor_[f] == 0; }),
    poor_.end());
  const std::vector<std::uint32_t> found = concatenated(more);
  poor_.insert(poor_.end(), found.begin(), found.end());
}

bool NodeShifts::isWorse(std::uint32_t f) const
{
  const EditFace& face = mesh_.face(f);
  const Cost<double>& cost = costs_[f];
  return cost.fails > int(face.fails) || cost.value > face.cost + mostCost_;
}

// Halves what nodes of faces that became poor have moved; later takes it back. Returns which shifts.
std::vector<std::uint32_t> NodeShifts::takeBack(int round)
{
  std::vector<std::uint32_t> some = shiftsAtPoor(round >= RoundsOfHalving);
  forEach(some, [&](const MeshEditor&, std::uint32_t s) {
    Shift& shift = shifts_[s];
    shift.isTakenBack = true;
    shift.part = round < RoundsOfHalving ? shift.part / 2 : 0;
    place(shift);
  });
  return some;
}

// Of nodes of poor faces, or also of their cells, that have moved.
std::vector<std::uint32_t> NodeShifts::shiftsAtPoor(bool ofCells) const
{
  return sortedUnique(gather(poor_.size(), [&](std::size_t i, std::vector<std::uint32_t>& list) {
    const auto addOf = [&](std::uint32_t f) {
      for (const std::uint32_t n : mesh_.cornersOf(f))
      {
        const std::uint32_t s = shiftOf_[n];
        s != None&& shifts_[s].part != 0 ? list.push_back(s) : void();
      }
    };
    addOf(poor_[i]);
    const EditFace& face = mesh_.face(poor_[i]);
    for (const std::uint32_t c : { face.below, face.above })
    {
      for (const std::uint32_t f : ofCells&& c != None ? mesh_.facesOf(c) : Items{})
      {
        addOf(f);
      }
    }
  }));
}

void NodeShifts::setCosts(const Reach& reach)
{
  forEach(reach.cells, [](MeshEditor& mesh, std::uint32_t c) { setCostOfCell(mesh, c); });
  forEachDependent(reach,
    [&](MeshEditor& mesh, std::uint32_t f, std::size_t) { setCost(mesh.rawFace(f), costs_[f]); });
}

// The volume that a wall has passed over, as the triangles around the mean of its corners enclose it. Their areas are
// of second degree in time: Simpson's rule is exact.
double NodeShifts::sweptBy(std::uint32_t f) const
{
  const Items ring = mesh_.cornersOf(f);
  const auto before = [&](std::uint32_t n) -> const Vector& {
    return shiftOf_[n] == None ? mesh_.node(n).at : shifts_[shiftOf_[n]].before;
  };
  const auto at = [&](std::uint32_t n, double time) {
    return plus(scaled(before(n), 1 - time), scaled(mesh_.node(n).at, time));
  };
  const auto moved = [&](std::uint32_t n) { return minus(mesh_.node(n).at, before(n)); };
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

void NodeShifts::passOver(const Reach& reach)
{
  forEach(reach.faces, [&](const MeshEditor&, std::uint32_t f) {
    EditFace& face = whole_.faces[f];
    face.volumeDeficit -= isSurface(face) ? sweptBy(f) : 0;
  });
}

}
