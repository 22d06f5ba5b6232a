// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/FaceJoining.h"

#include "Acceptance/CellCost.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

// Points on one plane are rounded to whole levels.
constexpr double RoundingLevels = 2;

// ... so that each is this near to the plane through its own centre: others need no closer look.
constexpr double NearLevels = 3 * RoundingLevels;

// Cosine of normals of faces that might lie on one plane.
constexpr double NearlyFlat = 0.999;

// All diagonals are tried.
constexpr std::size_t MostCornersRecut = 16;

// Faces that are cut apart anew do not fold over.
constexpr double LeastCosineOfCut = 0.5;

bool contains(const Ring& ring, std::uint32_t node)
{
  return std::find(ring.corners, ring.corners + ring.size, node) != ring.corners + ring.size;
}

// Edges between nodes, of faces, as numbers in the order of nodes, then of faces.
constexpr unsigned BitsOfNode = 24;
constexpr unsigned BitsOfFace = 16;

std::uint64_t numberOfEdge(std::uint32_t from, std::uint32_t to, std::uint32_t face)
{
  return (std::uint64_t(std::min(from, to)) << BitsOfNode | std::max(from, to)) << BitsOfFace |
    face;
}

std::uint32_t faceOfEdge(std::uint64_t number)
{
  return static_cast<std::uint32_t>(number & ((1U << BitsOfFace) - 1));
}

}

bool hasEdgeFrom(const Ring& ring, std::uint32_t from, std::uint32_t to)
{
  for (std::size_t i = 0; i < ring.size; ++i)
  {
    if (ring.corners[i] == from)
    {
      return ring.corners[i + 1 < ring.size ? i + 1 : 0] == to;
    }
  }
  return false;
}

bool joinRings(const Ring& first, const Ring& second, std::vector<std::uint32_t>& joined)
{
  const auto next = [](const Ring& ring, std::size_t i) { return i + 1 < ring.size ? i + 1 : 0; };
  // Where the chain begins in the first: what follows it is not shared.
  std::size_t begin = first.size;
  std::size_t chain = 0;
  bool before = hasEdgeFrom(second, first.corners[0], first.corners[first.size - 1]);
  for (std::size_t i = 0; i < first.size; ++i)
  {
    const bool shared = hasEdgeFrom(second, first.corners[next(first, i)], first.corners[i]);
    chain += shared ? 1 : 0;
    if (shared && !before)
    {
      if (begin != first.size)
      {
        return false;
      }
      begin = i;
    }
    before = shared;
  }
  if (begin == first.size || chain + 1 >= first.size + second.size - chain)
  {
    return false;
  }
  // The first from the end of the chain to its start; from there the second, which runs the other way.
  joined.clear();
  for (std::size_t n = chain; n < first.size; ++n)
  {
    joined.push_back(first.corners[(begin + n) % first.size]);
  }
  const auto start = static_cast<std::size_t>(
    std::find(second.corners, second.corners + second.size, first.corners[begin]) - second.corners);
  for (std::size_t n = 0; n + chain < second.size; ++n)
  {
    const std::uint32_t node = second.corners[(start + n) % second.size];
    if (std::find(joined.begin(), joined.end(), node) != joined.end())
    {
      return false;
    }
    joined.push_back(node);
  }
  return true;
}

// --- what there is

void FaceJoiner::look(const CellView& view, const CellShape& shape)
{
  view_ = &view;
  shape_ = &shape;
  edges_.clear();
  planes_.clear();
  for (const FaceShape& face : shape.faces)
  {
    planes_.push_back({ unit(face.area), norm(face.area) });
  }
  joinedShape_.polyhedron.nodes.clear();
}

Ring FaceJoiner::ringOf(Part part) const
{
  return isFace(part) ? cartesian::ringOf(view_->shape, part) : ringOf(groupOf(part).ring);
}

Ring FaceJoiner::ringOf(const std::vector<std::uint32_t>& corners) const
{
  return { view_->shape.nodes.data(), corners.data(), corners.size() };
}

// Whether is(ring) for any part.
template <class Is>
bool FaceJoiner::anyPart(Is&& is) const
{
  for (std::uint32_t f = 0; f < faces(); ++f)
  {
    if (isFace(partOf_[f]) && is(ringOf(f)))
    {
      return true;
    }
  }
  return std::any_of(
    joined_.groups.begin(), joined_.groups.end(), [&](const JoinedFaces::Group& group) {
      return !group.members.empty() && is(ringOf(group.ring));
    });
}

void FaceJoiner::begin(const JoinSpec& spec, const JoinedFaces& given)
{
  spec_ = { std::max(spec.boundary, featureCosine_), spec.inner };
  negligible_ = spec.boundary < 1 ? negligibleArea(*shape_) : 0;
  joined_ = given;
  partOf_.resize(faces());
  for (std::uint32_t f = 0; f < faces(); ++f)
  {
    partOf_[f] = f;
  }
  for (std::uint32_t g = 0; g < given.groups.size(); ++g)
  {
    for (const std::uint32_t member : given.groups[g].members)
    {
      partOf_[member] = faces() + g;
    }
  }
}

// The faces on either side of each edge; where there are not two, none is joined.
void FaceJoiner::listPairs()
{
  if (!edges_.empty())
  {
    return;
  }
  pairs_.clear();
  for (std::uint32_t f = 0; f < faces(); ++f)
  {
    const Ring ring = ringOf(f);
    std::uint32_t from = ring.corners[ring.size - 1];
    for (std::size_t i = 0; i < ring.size; ++i)
    {
      const std::uint32_t to = ring.corners[i];
      edges_.push_back(numberOfEdge(from, to, f));
      from = to;
    }
  }
  std::sort(edges_.begin(), edges_.end());
  const auto sameEdge = [&](std::size_t i, std::size_t k) {
    return k < edges_.size() && edges_[k] >> BitsOfFace == edges_[i] >> BitsOfFace;
  };
  for (std::size_t i = 0; i + 1 < edges_.size(); ++i)
  {
    if (sameEdge(i, i + 1) && !sameEdge(i, i + 2) && (i == 0 || !sameEdge(i, i - 1)))
    {
      pairs_.emplace_back(faceOfEdge(edges_[i]), faceOfEdge(edges_[i + 1]));
    }
  }
}

// --- all that fit, or one more

JoinedFaces FaceJoiner::join(const JoinSpec& spec)
{
  if (faces() > MostFacesJoined)
  {
    return {};
  }
  begin(spec, {});
  if (!mayAnyFit())
  {
    return {};
  }
  listPairs();
  for (bool joined = true; joined;)
  {
    joined = false;
    for (const auto& [f, g] : pairs_)
    {
      joined = (partOf_[f] != partOf_[g] && mayFit(f, g) && join(partOf_[f], partOf_[g])) || joined;
    }
  }
  return joinedParts();
}

std::vector<JoinedFaces> FaceJoiner::joinOneMore(
  const JoinedFaces& given, std::size_t face, double leastCosine)
{
  std::vector<JoinedFaces> results;
  if (faces() > MostFacesJoined)
  {
    return results;
  }
  listPairs();
  begin({ leastCosine, leastCosine }, given);
  const Part part = partAt(face);
  const std::vector<Part> parts = partOf_;
  for (const Part other : partsBeside(part))
  {
    if (join(part, other) || recut(part, other))
    {
      results.push_back(joinedParts());
      joined_ = given;
      partOf_ = parts;
    }
  }
  return results;
}

// Takes them.
JoinedFaces FaceJoiner::joinedParts()
{
  JoinedFaces joined = std::move(joined_);
  auto& groups = joined.groups;
  groups.erase(std::remove_if(groups.begin(), groups.end(),
                 [](const JoinedFaces::Group& group) { return group.members.empty(); }),
    groups.end());
  return joined;
}

// Of a face of JoinedShape.
FaceJoiner::Part FaceJoiner::partAt(std::size_t face) const
{
  for (std::uint32_t f = 0; f < faces(); ++f)
  {
    if (isFace(partOf_[f]) && face-- == 0)
    {
      return f;
    }
  }
  return faces() + static_cast<Part>(face);
}

std::vector<FaceJoiner::Part> FaceJoiner::partsBeside(Part part) const
{
  std::vector<Part> beside;
  for (const auto& [f, g] : pairs_)
  {
    const Part one = partOf_[f];
    const Part other = partOf_[g];
    if (one != other && (one == part || other == part) && mayFit(f, g))
    {
      beside.push_back(one == part ? other : one);
    }
  }
  std::sort(beside.begin(), beside.end());
  beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
  return beside;
}

const JoinedShape& FaceJoiner::shapeOf(const JoinedFaces& joined)
{
  Polyhedron& polyhedron = joinedShape_.polyhedron;
  if (polyhedron.nodes.empty())
  {
    polyhedron.nodes = view_->shape.nodes;
  }
  polyhedron.start.assign(1, 0);
  polyhedron.corners.clear();
  polyhedron.isBoundary.clear();
  joinedShape_.measures.faces.clear();
  joinedShape_.beyond.clear();
  const auto add = [&](const Ring& ring, std::uint32_t member, const FaceShape& shape) {
    polyhedron.corners.insert(polyhedron.corners.end(), ring.corners, ring.corners + ring.size);
    polyhedron.closeFace(view_->shape.isBoundary[member] != 0);
    joinedShape_.measures.faces.push_back(shape);
    joinedShape_.beyond.push_back(view_->beyond[member]);
  };
  const auto isMember = [&](std::uint32_t f) {
    return std::any_of(
      joined.groups.begin(), joined.groups.end(), [&](const JoinedFaces::Group& group) {
        return std::find(group.members.begin(), group.members.end(), f) != group.members.end();
      });
  };
  for (std::uint32_t f = 0; f < faces(); ++f)
  {
    if (!isMember(f))
    {
      add(ringOf(f), f, shape_->faces[f]);
    }
  }
  for (const JoinedFaces::Group& group : joined.groups)
  {
    const Ring ring = ringOf(group.ring);
    add(ring, group.members.front(), group.shape);
  }
  measureVolume(joinedShape_.measures);
  return joinedShape_;
}

// --- what fits

bool FaceJoiner::mayAnyFit() const
{
  for (std::uint32_t f = 0; f < faces(); ++f)
  {
    for (std::uint32_t g = 0; g < f; ++g)
    {
      if (mayFit(f, g))
      {
        return true;
      }
    }
  }
  return false;
}

// Of two faces, before a closer look.
bool FaceJoiner::mayFit(std::uint32_t f, std::uint32_t g) const
{
  if (f == g || view_->across[f] != view_->across[g] || view_->fixed[f] || view_->fixed[g])
  {
    return false;
  }
  if (isNegligible(f) || isNegligible(g))
  {
    return true;
  }
  if (!isInner(f) && view_->boundary[f] != view_->boundary[g])
  {
    return false;
  }
  const bool flat = leastCosine(f) >= 1;
  if (dot(planes_[f].normal, planes_[g].normal) < std::min(leastCosine(f), NearlyFlat))
  {
    return false;
  }
  const Vector normal = unit(plus(shape_->faces[f].area, shape_->faces[g].area));
  return !flat || (isNearPlane(f, normal) && isNearPlane(g, normal));
}

// Of a face that is on one plane with another: each corner and the centre are near to it.
bool FaceJoiner::isNearPlane(std::uint32_t f, const Vector& normal) const
{
  const Ring ring = ringOf(f);
  for (std::size_t i = 0; i < ring.size; ++i)
  {
    if (std::abs(dot(minus(ring[i], shape_->faces[f].centre), normal)) > NearLevels)
    {
      return false;
    }
  }
  return true;
}

// For solvers of one region a face between two is at the boundary.
bool FaceJoiner::isInner(std::uint32_t f) const
{
  return view_->across[f] != None && !view_->shape.isBoundary[f];
}

bool FaceJoiner::isNegligible(std::uint32_t f) const
{
  return planes_[f].area < negligible_;
}

bool FaceJoiner::isNegligiblePart(Part part) const
{
  if (isFace(part))
  {
    return isNegligible(part);
  }
  const std::vector<std::uint32_t>& members = groupOf(part).members;
  return std::all_of(
    members.begin(), members.end(), [&](std::uint32_t f) { return isNegligible(f); });
}

double FaceJoiner::leastCosine(std::uint32_t f) const
{
  return isInner(f) ? spec_.inner : spec_.boundary;
}

// --- joining

bool FaceJoiner::join(Part g, Part h)
{
  if (isNegligiblePart(g)) // a joined face belongs to what its first member does
  {
    std::swap(g, h);
  }
  const std::uint32_t one = firstMember(g);
  const std::uint32_t other = firstMember(h);
  if ((!isNegligiblePart(h) && !isInner(one) && view_->boundary[one] != view_->boundary[other]) ||
    !joinRings(ringOf(g), ringOf(h), ring_) || hasTwin(ring_) ||
    !(isNegligiblePart(h) ? fitsWithNegligible() : fitsTogether(g, h, leastCosine(one))))
  {
    return false;
  }
  const Part part = makeGroup(g);
  JoinedFaces::Group& group = groupOf(part);
  group.ring = ring_;
  group.shape = measure(ringOf(ring_));
  const auto add = [&](std::uint32_t member) {
    group.members.push_back(member);
    partOf_[member] = part;
  };
  if (isFace(h))
  {
    add(h);
    return true;
  }
  std::for_each(groupOf(h).members.begin(), groupOf(h).members.end(), add);
  groupOf(h) = {};
  return true;
}

// Whether ring_ can stand for the two parts: it has a star triangulation, and the normals are close; from a
// cosine of 1 on, all lies on one plane.
bool FaceJoiner::fitsTogether(Part g, Part h, double leastCosine) const
{
  const bool flat = leastCosine >= 1;
  const Ring ring = ringOf(ring_);
  const Vector normal = unit(areaOf(ring));
  const auto normalOf = [&](Part part) {
    return isFace(part) ? planes_[part].normal : unit(groupOf(part).shape.area);
  };
  const Vector one = normalOf(g);
  const Vector other = normalOf(h);
  const double least = std::min(dot(one, normal), dot(other, normal));
  if (flat ? least <= 0 : std::min(least, dot(one, other)) < leastCosine)
  {
    return false;
  }
  return (!flat || isFlat(ring, measure(ring), RoundingLevels)) && isStar(ring, normal);
}

// ... where one of the two is negligible.
bool FaceJoiner::fitsWithNegligible() const
{
  const Ring ring = ringOf(ring_);
  return isStar(ring, unit(areaOf(ring)));
}

// Of a face alone, if it is in none.
FaceJoiner::Part FaceJoiner::makeGroup(Part part)
{
  if (!isFace(part))
  {
    return part;
  }
  const Ring ring = ringOf(part);
  joined_.groups.push_back(
    { { part }, { ring.corners, ring.corners + ring.size }, shape_->faces[part] });
  return partOf_[part] = faces() + static_cast<Part>(joined_.groups.size() - 1);
}

// Whether they are of different boundaries in one plane. Where one is negligible, a part may lose it, but none may grow.
bool FaceJoiner::isBorderBetween(Part g, Part h) const
{
  const auto normalOf = [&](Part part) {
    return isFace(part) ? planes_[part].normal : unit(groupOf(part).shape.area);
  };
  const std::uint32_t one = firstMember(g);
  return !isInner(one) && view_->boundary[one] != view_->boundary[firstMember(h)] &&
    dot(normalOf(g), normalOf(h)) >= NearlyFlat;
}

// Divides two parts anew, so that the smaller of both is as large as can be; false where nothing is better.
bool FaceJoiner::recut(Part g, Part h)
{
  if (isBorderBetween(g, h) || !joinRings(ringOf(g), ringOf(h), ring_) || ring_.size() < 4 ||
    ring_.size() > MostCornersRecut)
  {
    return false;
  }
  const double least = leastCosine(firstMember(g));
  const auto sizeOf = [&](Part part) {
    return isFace(part) ? planes_[part].area : norm(groupOf(part).shape.area);
  };
  double largest = 2 * std::min(sizeOf(g), sizeOf(h));
  std::array<std::vector<std::uint32_t>, 2> best;
  for (std::size_t i = 0; i < ring_.size(); ++i)
  {
    for (std::size_t k = i + 2; k < ring_.size() && k - i + 1 < ring_.size(); ++k)
    {
      const auto at = [&](std::size_t c) { return ring_.begin() + static_cast<std::ptrdiff_t>(c); };
      halves_[0].assign(at(i), at(k + 1));
      halves_[1].assign(at(k), ring_.end());
      halves_[1].insert(halves_[1].end(), ring_.begin(), at(i + 1));
      const double smaller = smallerOf(halves_, least, largest);
      if (smaller > largest && !hasEdge(ring_[i], ring_[k]) && !hasTwin(halves_[0]) &&
        !hasTwin(halves_[1]))
      {
        largest = smaller;
        std::swap(best, halves_);
      }
    }
  }
  if (best[0].empty())
  {
    return false;
  }
  const std::array<Part, 2> parts{ makeGroup(g), makeGroup(h) };
  for (std::size_t i = 0; i < 2; ++i)
  {
    groupOf(parts[i]).ring = std::move(best[i]);
    groupOf(parts[i]).shape = measure(ringOf(groupOf(parts[i]).ring));
    groupOf(parts[i]).recut = true;
  }
  return true;
}

// Its area, or less than 0 where that is not larger than `largest`, one has no star triangulation, or they meet at too
// wide an angle.
double FaceJoiner::smallerOf(
  const std::array<std::vector<std::uint32_t>, 2>& parts, double leastCosine, double largest) const
{
  const std::array<Ring, 2> rings{ ringOf(parts[0]), ringOf(parts[1]) };
  const Vector area = areaOf(rings[0]);
  const Vector other = areaOf(rings[1]);
  const double smaller = std::min(norm(area), norm(other));
  const bool fits = smaller > largest &&
    dot(unit(area), unit(other)) >= std::max(leastCosine, LeastCosineOfCut) &&
    isStar(rings[0], unit(area)) && isStar(rings[1], unit(other));
  return fits ? smaller : -1;
}

bool FaceJoiner::hasEdge(std::uint32_t from, std::uint32_t to) const
{
  return anyPart(
    [&](const Ring& ring) { return hasEdgeFrom(ring, from, to) || hasEdgeFrom(ring, to, from); });
}

// Two faces between the same nodes would enclose nothing.
bool FaceJoiner::hasTwin(const std::vector<std::uint32_t>& ring) const
{
  return anyPart([&](const Ring& other) {
    return other.size == ring.size() &&
      std::all_of(
        ring.begin(), ring.end(), [&](std::uint32_t node) { return contains(other, node); });
  });
}

}
