// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/CellCut.h"

#include "Base/DisjointSets.h"
#include "Base/Rings.h"
#include "Editing/PrimitiveEdits.h"
#include "Editing/WallEdges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

namespace cartesian
{

namespace
{

constexpr std::size_t MostFaces = 256;
constexpr std::size_t MostEdges = 2048;
constexpr std::size_t MostOfSection = 128;

// A crossing nearer to an end of its edge than this part of it falls on that end.
constexpr double NearEnd = 0.15;

// In boxes.
constexpr double DisplacementOfCuts = 0.2;

// On which side of the plane nodes are: their distance, 0 on it.
class PlaneSides
{
public:
  // False: there are too many.
  bool add(std::uint32_t node, double distance) { return nodes_.add({ node, distance }); }

  // Once all nodes of the cell are added, some of them several times.
  void index()
  {
    std::size_t slots = 64;
    while (slots < 4 * nodes_.size() && slots < MostSlots)
    {
      slots *= 2;
    }
    mask_ = slots - 1;
    std::fill(slots_.begin(), slots_.begin() + static_cast<std::ptrdiff_t>(slots), Empty);
    std::size_t count = 0;
    for (const Side& node : nodes_)
    {
      std::uint16_t& slot = slotOf(node.node);
      if (slot == Empty)
      {
        nodes_[count] = node;
        slot = static_cast<std::uint16_t>(count++);
      }
    }
    nodes_.resize(count);
  }

  // A new node, then.
  bool insert(std::uint32_t node, double distance)
  {
    const auto i = static_cast<std::uint16_t>(nodes_.size());
    if (!add(node, distance))
    {
      return false;
    }
    if (2 * nodes_.size() > mask_ && mask_ + 1 < MostSlots)
    {
      index();
    }
    else
    {
      slotOf(node) = i;
    }
    return true;
  }

  double& at(std::uint32_t node) { return nodes_[slotOf(node)].distance; }

private:
  struct Side
  {
    std::uint32_t node;
    double distance;
  };

  static constexpr std::size_t MostNodes = 1024;
  static constexpr std::size_t MostSlots = 2 * MostNodes;
  static constexpr std::uint16_t Empty = 0xffff;

  // Where a node's place in the list is, or would be.
  std::uint16_t& slotOf(std::uint32_t node)
  {
    std::size_t slot = node & mask_;
    while (slots_[slot] != Empty && nodes_[slots_[slot]].node != node)
    {
      slot = (slot + 1) & mask_;
    }
    return slots_[slot];
  }

  FixedList<Side, MostNodes> nodes_;
  std::array<std::uint16_t, MostSlots> slots_; // of a hash table; as many as the mask says
  std::size_t mask_ = 0;
};

class CellCutter
{
public:
  CellCutter(MeshEditor& mesh, std::uint32_t cell, const CutPlane& plane)
    : mesh_(mesh)
    , cell_(cell)
    , plane_(plane)
  {
  }

  bool run(CutParts& parts)
  {
    return classify() && pinToNodes() && divideEdges() && divideFaces() && listEdges() &&
      traceSection() && makeParts(parts);
  }

private:
  // An edge of the cell's faces, as seen from outside.
  struct Edge
  {
    std::uint32_t from;
    std::uint32_t to;
    std::uint32_t face; // index in faces_

    bool operator<(const Edge& other) const
    {
      return std::tie(from, to, face) < std::tie(other.from, other.to, other.face);
    }
  };

  // Where a face passes from one side to the other: corners on the plane, from one to another in the ring.
  struct Passage
  {
    double along; // the line in which the planes of the face and the cut meet
    std::size_t first;
    std::size_t last;

    bool operator<(const Passage& other) const { return along < other.along; }
  };

  bool classify()
  {
    const Items faces = mesh_.facesOf(cell_);
    if (faces.size() > MostFaces)
    {
      return false;
    }
    for (const std::uint32_t f : faces)
    {
      faces_.push(f);
      for (const std::uint32_t n : mesh_.cornersOf(f))
      {
        const double distance = dot(minus(mesh_.node(n).at, plane_.through), plane_.normal);
        if (!sides_.add(n, std::abs(distance) < plane_.tolerance ? 0 : distance))
        {
          return false;
        }
      }
    }
    sides_.index();
    return true;
  }

  template <class Visitor>
  void forEachCrossedEdge(Visitor&& visit)
  {
    for (const std::uint32_t f : faces_)
    {
      for (std::size_t i = 0; i < mesh_.face(f).corners.size; ++i)
      {
        const Items ring = mesh_.cornersOf(f);
        const std::uint32_t a = ring[i];
        const std::uint32_t b = following(ring, i);
        if (sides_.at(a) * sides_.at(b) < 0)
        {
          visit(a, b);
        }
      }
    }
  }

  bool pinToNodes()
  {
    forEachCrossedEdge([&](std::uint32_t a, std::uint32_t b) {
      const double t = sides_.at(a) / (sides_.at(a) - sides_.at(b));
      const double length = norm(minus(mesh_.node(a).at, mesh_.node(b).at));
      if (t < NearEnd || t * length < plane_.tolerance)
      {
        sides_.at(a) = 0;
      }
      else if (t > 1 - NearEnd || (1 - t) * length < plane_.tolerance)
      {
        sides_.at(b) = 0;
      }
    });
    return true;
  }

  bool divideEdges()
  {
    bool isPossible = true;
    forEachCrossedEdge(
      [&](std::uint32_t a, std::uint32_t b) { isPossible = isPossible && divideEdge(a, b); });
    return isPossible;
  }

  // Puts a node into all faces that have the edge.
  bool divideEdge(std::uint32_t a, std::uint32_t b)
  {
    const double t = sides_.at(a) / (sides_.at(a) - sides_.at(b));
    const std::uint32_t made = mesh_.makeNode(nodeBetween(a, b, t));
    if (made == None || !sides_.insert(made, 0))
    {
      return false;
    }
    FixedList<std::uint32_t, MostFaces> around;
    for (const std::uint32_t f : mesh_.facesAround(a))
    {
      if (!around.add(f))
      {
        return false;
      }
    }
    FixedList<std::uint32_t, MostFaces> divided;
    for (const std::uint32_t f : around)
    {
      const Items ring = mesh_.cornersOf(f);
      divided.clear();
      bool hasEdge = false;
      for (std::size_t i = 0; i < ring.size(); ++i)
      {
        const std::uint32_t p = ring[i];
        const std::uint32_t q = following(ring, i);
        const bool isEdge = (p == a && q == b) || (p == b && q == a);
        if (!divided.add(p) || (isEdge && !divided.add(made)))
        {
          return false;
        }
        hasEdge = hasEdge || isEdge;
      }
      if (hasEdge && !mesh_.areCellsFree(f))
      {
        return false;
      }
      if (hasEdge)
      {
        mesh_.setCorners(f, divided.data(), divided.size());
      }
    }
    return true;
  }

  EditNode nodeBetween(std::uint32_t a, std::uint32_t b, double t) const
  {
    const EditNode& from = mesh_.node(a);
    const EditNode& to = mesh_.node(b);
    EditNode made;
    Vector at = plus(from.at, scaled(minus(to.at, from.at), t));
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (((from.constrainedAxes & to.constrainedAxes) >> axis & 1) != 0 &&
        from.at[axis] == to.at[axis]) // one plane
      {
        made.constrainedAxes = static_cast<std::uint8_t>(made.constrainedAxes | 1U << axis);
        at[axis] = from.at[axis];
      }
    }
    made.at = onLattice(mesh_, at, made.constrainedAxes);
    made.referencePosition = made.at;
    made.maxDisplacement = static_cast<float>(DisplacementOfCuts * mesh_.cell(cell_).edge);
    placeOnWall(a, b, made);
    return made;
  }

  void placeOnWall(std::uint32_t a, std::uint32_t b, EditNode& made) const
  {
    FixedList<std::uint32_t, 4> walls;
    for (const std::uint32_t f : mesh_.facesAround(a))
    {
      const Items ring = mesh_.cornersOf(f);
      const std::size_t j = placeOf(ring, b);
      if (mesh_.isSurface(f) && j < ring.size() &&
        (following(ring, j) == a || preceding(ring, j) == a))
      {
        walls.offer(f); // it matters whether they are two
      }
    }
    if (walls.empty())
    {
      return;
    }
    made.atWall = true;
    if (walls.size() != 2)
    {
      made.kind = NodeKind::Corner;
      return;
    }
    const Vector one = unit(mesh_.face(walls[0]).area);
    const Vector other = unit(mesh_.face(walls[1]).area);
    const bool areOnEdges = std::min(mesh_.node(a).kind, mesh_.node(b).kind) >= NodeKind::OnEdge;
    const bool isSmooth = mesh_.face(walls[0]).wall == mesh_.face(walls[1]).wall &&
      !mesh_.sharp().isSharp(dot(one, other), areOnEdges);
    made.kind = isSmooth ? NodeKind::OnSurface : NodeKind::OnEdge;
    made.along = unit(isSmooth ? plus(one, other) : minus(mesh_.node(b).at, mesh_.node(a).at));
  }

  // 1: it has corners in front of the plane, 2: behind it.
  unsigned sidesOf(std::uint32_t f)
  {
    unsigned sides = 0;
    for (const std::uint32_t n : mesh_.cornersOf(f))
    {
      const double s = sides_.at(n);
      sides |= s > 0 ? 1U : s < 0 ? 2U : 0U;
    }
    return sides;
  }

  bool divideFaces()
  {
    for (std::size_t i = 0; i < faces_.size(); ++i)
    {
      while (sidesOf(faces_[i]) == 3)
      {
        const std::uint32_t made = divideFace(faces_[i]);
        if (made == None || !faces_.add(made))
        {
          return false;
        }
      }
    }
    return true;
  }

  // Along one chord between two neighbouring passages. Returns the new face, or None.
  std::uint32_t divideFace(std::uint32_t f)
  {
    FixedList<Passage, 64> passages;
    if (!listPassages(f, passages) || passages.size() < 2 || passages.size() % 2 != 0)
    {
      return None;
    }
    std::sort(passages.begin(), passages.end());
    const auto [i, j] = nearestEnds(f, passages[0], passages[1]);
    return splitFace(mesh_, f, i, j);
  }

  // False: there are too many.
  bool listPassages(std::uint32_t f, FixedList<Passage, 64>& passages)
  {
    const Vector line = cross(mesh_.face(f).area, plane_.normal);
    const Items ring = mesh_.cornersOf(f);
    const std::size_t size = ring.size();
    for (std::size_t i = 0; i < size; ++i)
    {
      const double before = sides_.at(ring[(i + size - 1) % size]);
      if (sides_.at(ring[i]) != 0 || before == 0)
      {
        continue;
      }
      std::size_t last = i;
      while (sides_.at(ring[(last + 1) % size]) == 0)
      {
        last = (last + 1) % size;
      }
      if (before * sides_.at(ring[(last + 1) % size]) < 0 &&
        !passages.add({ dot(mesh_.node(ring[i]).at, line), i, last }))
      {
        return false;
      }
    }
    return true;
  }

  std::pair<std::size_t, std::size_t> nearestEnds(
    std::uint32_t f, const Passage& one, const Passage& other) const
  {
    std::pair<std::size_t, std::size_t> best{ one.first, other.first };
    double least = HUGE_VAL;
    for (const std::size_t i : { one.first, one.last })
    {
      for (const std::size_t j : { other.first, other.last })
      {
        const Vector between = minus(mesh_.corner(f, i), mesh_.corner(f, j));
        if (const double square = dot(between, between); square < least)
        {
          least = square;
          best = { i, j };
        }
      }
    }
    return best;
  }

  // Of all faces, each of which is on one side now; a face in the plane is on the side of the cell.
  bool listEdges()
  {
    for (std::uint32_t i = 0; i < faces_.size(); ++i)
    {
      const std::uint32_t f = faces_[i];
      const Items ring = mesh_.cornersOf(f);
      const bool isOutward = mesh_.face(f).below == cell_;
      const unsigned sides = sidesOf(f);
      const bool facesAlong = dot(mesh_.face(f).area, plane_.normal) > 0;
      inFront_.push(sides == 0 ? facesAlong != isOutward : sides == 1);
      for (std::size_t k = 0; k < ring.size(); ++k)
      {
        const std::uint32_t p = ring[k];
        const std::uint32_t q = following(ring, k);
        if (!edges_.add(isOutward ? Edge{ p, q, i } : Edge{ q, p, i }))
        {
          return false;
        }
      }
    }
    std::sort(edges_.begin(), edges_.end());
    return true;
  }

  // The face on the other side of an edge, or None. Where the cell touches itself along the edge, as where the rim of a sheet
  // lies in a face that was divided there: that on the same side of the plane.
  std::uint32_t across(const Edge& edge) const
  {
    const Edge* found =
      std::lower_bound(edges_.begin(), edges_.end(), Edge{ edge.to, edge.from, 0 });
    std::uint32_t face = None;
    for (; found != edges_.end() && found->from == edge.to && found->to == edge.from; ++found)
    {
      if (face == None || (inFront_[found->face] == inFront_[edge.face] && plane_.mayLookBack))
      {
        face = found->face;
      }
    }
    return face;
  }

  // The edges between faces in front of the plane and behind it, in rings.
  bool traceSection()
  {
    for (const Edge& edge : edges_)
    {
      const std::uint32_t other = across(edge);
      if (other == None)
      {
        return false;
      }
      if (inFront_[edge.face] && !inFront_[other] && !section_.add(edge))
      {
        return false;
      }
    }
    for (std::size_t i = 0; i + 1 < section_.size(); ++i) // sorted by where they begin
    {
      if (section_[i].from == section_[i + 1].from)
      {
        return false;
      }
    }
    return (section_.empty() && plane_.mayLookBack) ||
      section_.size() >= 3; // parts may touch along edges alone
  }

  std::uint32_t groupOf(std::size_t face)
  {
    return rootOf(group_, static_cast<std::uint32_t>(face));
  }

  // Faces of the same part have one group: the lowest of them.
  void groupFaces()
  {
    group_.resize(faces_.size());
    std::iota(group_.begin(), group_.end(), 0U);
    for (const Edge& edge : edges_)
    {
      const std::uint32_t other = across(edge);
      if (inFront_[edge.face] == inFront_[other])
      {
        uniteIn(group_, edge.face, other);
      }
    }
  }

  bool makeParts(CutParts& parts)
  {
    groupFaces();
    FixedList<std::uint32_t, MostFaces> cellOf; // of groups
    cellOf.resize(faces_.size());
    for (std::size_t i = 0; i < faces_.size(); ++i)
    {
      if (groupOf(i) == i)
      {
        cellOf[i] = parts.empty() ? cell_ : makePart();
        if (cellOf[i] == None || !parts.add(cellOf[i]))
        {
          return false;
        }
      }
    }
    for (std::size_t i = 0; i < faces_.size(); ++i)
    {
      if (const std::uint32_t to = cellOf[groupOf(i)]; to != cell_)
      {
        mesh_.giveFace(faces_[i], cell_, to);
      }
    }
    for (const std::uint32_t part : parts)
    {
      FixedList<std::uint32_t, MostFaces> ofPart;
      for (std::size_t i = 0; i < faces_.size(); ++i)
      {
        if (cellOf[groupOf(i)] == part)
        {
          ofPart.push(faces_[i]);
        }
      }
      mesh_.setFaces(part, ofPart.data(), ofPart.size());
    }
    return parts.size() >= 2 && (section_.empty() || makeSection(cellOf));
  }

  std::uint32_t makePart()
  {
    EditCell made = mesh_.cell(cell_);
    made.number = None;
    made.cost = 0;
    made.strains = false;
    return mesh_.makeCell(made);
  }

  // A face for each ring, from the part behind to that in front.
  bool makeSection(const FixedList<std::uint32_t, MostFaces>& cellOf)
  {
    FixedList<bool, MostOfSection> isDone;
    isDone.resize(section_.size());
    std::fill(isDone.begin(), isDone.end(), false);
    for (std::size_t i = 0; i < section_.size(); ++i)
    {
      if (isDone[i])
      {
        continue;
      }
      FixedList<std::uint32_t, MostOfSection> ring;
      std::size_t at = i;
      do
      {
        isDone[at] = true;
        ring.push(section_[at].from);
        at = nextInSection(at);
      } while (at != None && at != i && !isDone[at]);
      if (at != i || ring.size() < 3 || (!plane_.mayLookBack && !(areaOf(ring) > 0)))
      {
        return false;
      }
      EditFace made;
      made.below = cellOf[groupOf(across(section_[i]))];
      made.above = cellOf[groupOf(section_[i].face)];
      if (mesh_.makeFace(made, ring.data(), ring.size()) == None)
      {
        return false;
      }
    }
    return true;
  }

  std::size_t nextInSection(std::size_t i) const
  {
    const Edge* found =
      std::lower_bound(section_.begin(), section_.end(), Edge{ section_[i].to, 0, 0 });
    return found != section_.end() && found->from == section_[i].to
      ? static_cast<std::size_t>(found - section_.begin())
      : None;
  }

  // As seen from in front of the plane; negative around a hole.
  double areaOf(const FixedList<std::uint32_t, MostOfSection>& ring) const
  {
    double area = 0;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const Vector p = minus(mesh_.node(ring[i]).at, plane_.through);
      const Vector q = minus(mesh_.node(following(ring, i)).at, plane_.through);
      area += dot(cross(p, q), plane_.normal);
    }
    return area;
  }

  MeshEditor& mesh_;
  const std::uint32_t cell_;
  const CutPlane& plane_;
  PlaneSides sides_;
  FixedList<std::uint32_t, MostFaces> faces_;
  FixedList<bool, MostFaces> inFront_; // of the plane
  FixedList<Edge, MostEdges> edges_;
  FixedList<Edge, MostOfSection> section_;
  FixedList<std::uint32_t, MostFaces> group_;
};

}

bool cutCell(MeshEditor& mesh, std::uint32_t c, const CutPlane& plane, CutParts& parts)
{
  return mesh.isFree(c) && CellCutter(mesh, c, plane).run(parts);
}

}
