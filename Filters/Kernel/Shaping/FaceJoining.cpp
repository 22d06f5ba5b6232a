// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/FaceJoining.h"

#include "Polyhedra/CellCost.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

constexpr std::uint32_t None = ~std::uint32_t(0);

// Two polygons that share a chain of edges as one, or nothing where they share several or meet
// elsewhere too.
std::vector<std::uint32_t> joinRings(
  std::vector<std::uint32_t> first, std::vector<std::uint32_t> second)
{
  const auto follows = [](const std::vector<std::uint32_t>& ring, std::size_t i, std::uint32_t from,
                         std::uint32_t to) {
    return ring[i] == from && ring[(i + 1) % ring.size()] == to;
  };
  const auto isShared = [&](std::size_t i) {
    const std::uint32_t from = first[i];
    const std::uint32_t to = first[(i + 1) % first.size()];
    for (std::size_t k = 0; k < second.size(); ++k)
    {
      if (follows(second, k, to, from))
      {
        return true;
      }
    }
    return false;
  };
  // Where the chain begins in the first: what follows it is not shared.
  std::size_t begin = first.size();
  std::size_t chain = 0;
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    chain += isShared(i) ? 1 : 0;
    if (isShared(i) && !isShared((i + first.size() - 1) % first.size()))
    {
      if (begin != first.size())
      {
        return {};
      }
      begin = i;
    }
  }
  if (begin == first.size() || chain + 1 >= first.size() + second.size() - chain)
  {
    return {};
  }
  std::rotate(first.begin(), first.begin() + static_cast<std::ptrdiff_t>(begin), first.end());
  const std::uint32_t start = first.front();
  const auto at = std::find(second.begin(), second.end(), start);
  std::rotate(second.begin(), at, second.end());
  // first: start ... end, rest; second, the other way along the chain: start, rest ... end ...
  std::vector<std::uint32_t> joined(
    first.begin() + static_cast<std::ptrdiff_t>(chain), first.end());
  joined.insert(joined.end(), second.begin(), second.end() - static_cast<std::ptrdiff_t>(chain));
  std::vector<std::uint32_t> sorted = joined;
  std::sort(sorted.begin(), sorted.end());
  const bool twice = std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
  return twice ? std::vector<std::uint32_t>{} : joined;
}

// Points on one plane are rounded to whole levels.
constexpr double RoundingLevels = 2;

// ... so that each is this near to the plane through its own centre: others need no closer look.
constexpr double NearLevels = 3 * RoundingLevels;

// Whether the last face can stand for the two before it: it has a star triangulation, and the normals
// are close; `flat`: all lies on one plane.
bool fitsTogether(const Polyhedron& faces, double leastCosine, bool flat)
{
  CellShape shape;
  measure(faces, shape);
  const Vector normal = unit(shape.faces[2].area);
  for (std::size_t f = 0; f < 2; ++f)
  {
    const double cosine = dot(unit(shape.faces[f].area), normal);
    if (flat ? cosine <= 0 : cosine < leastCosine)
    {
      return false;
    }
  }
  if (!flat && dot(unit(shape.faces[0].area), unit(shape.faces[1].area)) < leastCosine)
  {
    return false;
  }
  return (!flat || isFlat(faces, shape, 2, RoundingLevels)) && isStar(faces, 2, normal);
}

// ... where one of the two is negligible.
bool fitsWithNegligible(const Polyhedron& faces)
{
  CellShape shape;
  measure(faces, shape);
  return isStar(faces, 2, unit(shape.faces[2].area));
}

void addRing(const std::vector<std::uint32_t>& ring, Polyhedron& shape)
{
  shape.corners.insert(shape.corners.end(), ring.begin(), ring.end());
  shape.closeFace(false);
}

class Joiner
{
public:
  Joiner(const CellView& view, const CellShape& shape, const JoinSpec& spec)
    : view_(view)
    , shape_(shape)
    , spec_(spec)
  {
    normals_.reserve(shape.faces.size());
    for (const FaceShape& face : shape.faces)
    {
      normals_.push_back(unit(face.area));
    }
    negligible_ = spec.boundary < 1 ? negligibleArea(shape) : 0;
  }

  // A group with each of its neighbours in turn.
  std::vector<JoinedFaces> runWith(const JoinedFaces& given, std::uint32_t group)
  {
    std::vector<JoinedFaces> results;
    if (!begin())
    {
      return results;
    }
    if (!given.groups.empty())
    {
      beginWith(given);
    }
    const JoinedFaces apart = joined_;
    const std::vector<std::uint32_t> groups = groupOf_;
    for (const std::uint32_t other : groupsBeside(group))
    {
      if (join(group, other) || recut(group, other))
      {
        results.push_back(withoutEmpty(std::move(joined_)));
        joined_ = apart;
        groupOf_ = groups;
      }
    }
    return results;
  }

  JoinedFaces run()
  {
    if (!mayAnyFit() || !begin())
    {
      return {};
    }
    for (bool joined = true; joined;)
    {
      joined = false;
      for (const auto& [f, g] : pairs_)
      {
        joined = join(groupOf_[f], groupOf_[g]) || joined;
      }
    }
    JoinedFaces joined = withoutEmpty(std::move(joined_));
    if (joined.groups.size() == view_.faces.size())
    {
      joined.groups.clear();
    }
    return joined;
  }

private:
  // False where there is nothing to join.
  bool begin()
  {
    listPairs();
    if (pairs_.empty())
    {
      return false;
    }
    trial_.nodes = view_.shape.nodes;
    joined_.groups.reserve(view_.faces.size());
    for (std::uint32_t f = 0; f < view_.faces.size(); ++f)
    {
      const auto corners = view_.shape.corners.begin();
      joined_.groups.push_back({ { f },
        { corners + std::ptrdiff_t(view_.shape.start[f]),
          corners + std::ptrdiff_t(view_.shape.start[f + 1]) } });
      groupOf_.push_back(f);
    }
    return true;
  }

  void beginWith(const JoinedFaces& given)
  {
    joined_ = given;
    for (std::uint32_t g = 0; g < given.groups.size(); ++g)
    {
      for (const std::uint32_t member : given.groups[g].members)
      {
        groupOf_[member] = g;
      }
    }
  }

  std::vector<std::uint32_t> groupsBeside(std::uint32_t group) const
  {
    std::vector<std::uint32_t> beside;
    for (const auto& [f, g] : pairs_)
    {
      const std::uint32_t one = groupOf_[f];
      const std::uint32_t other = groupOf_[g];
      if (one != other && (one == group || other == group))
      {
        beside.push_back(one == group ? other : one);
      }
    }
    std::sort(beside.begin(), beside.end());
    beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
    return beside;
  }

  bool mayAnyFit() const
  {
    for (std::uint32_t f = 0; f < view_.faces.size(); ++f)
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

  static JoinedFaces withoutEmpty(JoinedFaces joined)
  {
    auto& groups = joined.groups;
    groups.erase(std::remove_if(groups.begin(), groups.end(),
                   [](const JoinedFaces::Group& group) { return group.members.empty(); }),
      groups.end());
    return joined;
  }

  // The faces on either side of each edge; where there are not two, none is joined.
  void listPairs()
  {
    std::vector<std::array<std::uint32_t, 3>> edges; // lower node, higher node, face
    edges.reserve(view_.shape.corners.size());
    for (std::uint32_t f = 0; f < view_.faces.size(); ++f)
    {
      std::uint32_t from = view_.shape.corners[view_.shape.start[f + 1] - 1];
      for (std::size_t i = view_.shape.start[f]; i < view_.shape.start[f + 1]; ++i)
      {
        const std::uint32_t to = view_.shape.corners[i];
        edges.push_back({ std::min(from, to), std::max(from, to), f });
        from = to;
      }
    }
    std::sort(edges.begin(), edges.end());
    const auto sameEdge = [&](std::size_t i, std::size_t k) {
      return k < edges.size() && edges[k][0] == edges[i][0] && edges[k][1] == edges[i][1];
    };
    for (std::size_t i = 0; i + 1 < edges.size(); ++i)
    {
      if (sameEdge(i, i + 1) && !sameEdge(i, i + 2) && (i == 0 || !sameEdge(i, i - 1)) &&
        mayFit(edges[i][2], edges[i + 1][2]))
      {
        pairs_.emplace_back(edges[i][2], edges[i + 1][2]);
      }
    }
  }

  // Of two faces, before a closer look.
  bool mayFit(std::uint32_t f, std::uint32_t g) const
  {
    if (f == g || view_.across[f] != view_.across[g] || view_.fixed[f] || view_.fixed[g])
    {
      return false;
    }
    if (isNegligible(f) || isNegligible(g))
    {
      return true;
    }
    if (!isInner(f) && view_.boundary[f] != view_.boundary[g])
    {
      return false;
    }
    const bool flat = leastCosine(f) >= 1;
    if (dot(normals_[f], normals_[g]) < std::min(leastCosine(f), NearlyFlat))
    {
      return false;
    }
    const Vector normal = unit(plus(shape_.faces[f].area, shape_.faces[g].area));
    return !flat || (isNearPlane(f, normal) && isNearPlane(g, normal));
  }

  // Of a face that is on one plane with another: each corner and the centre are near to it.
  bool isNearPlane(std::uint32_t f, const Vector& normal) const
  {
    for (std::size_t i = view_.shape.start[f]; i < view_.shape.start[f + 1]; ++i)
    {
      const Vector& corner = view_.shape.nodes[view_.shape.corners[i]];
      if (std::abs(dot(minus(corner, shape_.faces[f].centre), normal)) > NearLevels)
      {
        return false;
      }
    }
    return true;
  }

  // For solvers of one region a face between two is at the boundary; but nobody asks the cell beyond.
  bool isInterface(std::uint32_t f) const
  {
    return view_.across[f] != None && view_.shape.isBoundary[f];
  }
  bool isInner(std::uint32_t f) const { return view_.across[f] != None && !isInterface(f); }
  bool isNegligible(std::uint32_t f) const
  {
    return norm(shape_.faces[f].area) < negligible_ && !isInterface(f);
  }
  bool isNegligible(const JoinedFaces::Group& group) const
  {
    return std::all_of(
      group.members.begin(), group.members.end(), [&](std::uint32_t f) { return isNegligible(f); });
  }
  double leastCosine(std::uint32_t f) const
  {
    const double boundary =
      isInterface(f) ? std::max(spec_.boundary, FlatInterface) : spec_.boundary;
    return isInner(f) ? spec_.inner : boundary;
  }

  bool join(std::uint32_t g, std::uint32_t h)
  {
    if (g == h)
    {
      return false;
    }
    if (isNegligible(joined_.groups[g])) // a joined face belongs to what its first member does
    {
      std::swap(g, h);
    }
    JoinedFaces::Group& first = joined_.groups[g];
    JoinedFaces::Group& second = joined_.groups[h];
    std::vector<std::uint32_t> ring = joinRings(first.ring, second.ring);
    if (ring.empty() || hasTwin(ring))
    {
      return false;
    }
    trial_.start.assign(1, 0);
    trial_.corners.clear();
    trial_.isBoundary.clear();
    addRing(first.ring, trial_);
    addRing(second.ring, trial_);
    addRing(ring, trial_);
    const double least = leastCosine(first.members.front());
    if (!(isNegligible(second) ? fitsWithNegligible(trial_)
                               : fitsTogether(trial_, least, least >= 1)))
    {
      return false;
    }
    first.ring = std::move(ring);
    first.members.insert(first.members.end(), second.members.begin(), second.members.end());
    for (const std::uint32_t member : second.members)
    {
      groupOf_[member] = g;
    }
    second = {};
    return true;
  }

  // Divides two groups anew, so that the smaller of both is as large as can be; false where nothing is better.
  bool recut(std::uint32_t g, std::uint32_t h)
  {
    JoinedFaces::Group& first = joined_.groups[g];
    JoinedFaces::Group& second = joined_.groups[h];
    const std::vector<std::uint32_t> ring = joinRings(first.ring, second.ring);
    if (ring.size() < 4 || ring.size() > MostCornersRecut)
    {
      return false;
    }
    const double least = leastCosine(first.members.front());
    trial_.start.assign(1, 0);
    trial_.corners.clear();
    trial_.isBoundary.clear();
    addRing(first.ring, trial_);
    addRing(second.ring, trial_);
    CellShape shape;
    measure(trial_, shape);
    double largest = 2 * std::min(norm(shape.faces[0].area), norm(shape.faces[1].area));
    std::array<std::vector<std::uint32_t>, 2> best;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      for (std::size_t k = i + 2; k < ring.size() && k - i + 1 < ring.size(); ++k)
      {
        std::array<std::vector<std::uint32_t>, 2> parts = cutRing(ring, i, k);
        const double smaller = smallerOf(parts, least);
        if (smaller > largest && !hasEdge(ring[i], ring[k]) && !hasTwin(parts[0]) &&
          !hasTwin(parts[1]))
        {
          largest = smaller;
          best = std::move(parts);
        }
      }
    }
    if (best[0].empty())
    {
      return false;
    }
    first.ring = std::move(best[0]);
    second.ring = std::move(best[1]);
    first.recut = second.recut = true;
    return true;
  }

  bool hasEdge(std::uint32_t from, std::uint32_t to) const
  {
    const auto runs = [&](const JoinedFaces::Group& group) {
      for (std::size_t i = 0; i < group.ring.size(); ++i)
      {
        const std::uint32_t a = group.ring[i];
        const std::uint32_t b = group.ring[i + 1 < group.ring.size() ? i + 1 : 0];
        if ((a == from && b == to) || (a == to && b == from))
        {
          return true;
        }
      }
      return false;
    };
    return std::any_of(joined_.groups.begin(), joined_.groups.end(), runs);
  }

  static std::array<std::vector<std::uint32_t>, 2> cutRing(
    const std::vector<std::uint32_t>& ring, std::size_t i, std::size_t k)
  {
    const auto at = [&](std::size_t c) { return ring.begin() + static_cast<std::ptrdiff_t>(c); };
    std::array<std::vector<std::uint32_t>, 2> parts;
    parts[0].assign(at(i), at(k + 1));
    parts[1].assign(at(k), ring.end());
    parts[1].insert(parts[1].end(), ring.begin(), at(i + 1));
    return parts;
  }

  // Its area, or less than 0 where one has no star triangulation, or they meet at too wide an angle.
  double smallerOf(const std::array<std::vector<std::uint32_t>, 2>& parts, double leastCosine)
  {
    trial_.start.assign(1, 0);
    trial_.corners.clear();
    trial_.isBoundary.clear();
    addRing(parts[0], trial_);
    addRing(parts[1], trial_);
    CellShape shape;
    measure(trial_, shape);
    const Vector normal = unit(shape.faces[0].area);
    const Vector other = unit(shape.faces[1].area);
    const bool fits = dot(normal, other) >= std::max(leastCosine, LeastCosineOfCut) &&
      isStar(trial_, 0, normal) && isStar(trial_, 1, other);
    return fits ? std::min(norm(shape.faces[0].area), norm(shape.faces[1].area)) : -1;
  }

  // Two faces between the same nodes would enclose nothing.
  bool hasTwin(std::vector<std::uint32_t> ring) const
  {
    std::sort(ring.begin(), ring.end());
    return std::any_of(
      joined_.groups.begin(), joined_.groups.end(), [&](const JoinedFaces::Group& group) {
        if (group.ring.size() != ring.size())
        {
          return false;
        }
        std::vector<std::uint32_t> nodes = group.ring;
        std::sort(nodes.begin(), nodes.end());
        return nodes == ring;
      });
  }

  // All diagonals are tried.
  static constexpr std::size_t MostCornersRecut = 16;

  // Faces that are cut apart anew do not fold over.
  static constexpr double LeastCosineOfCut = 0.5;

  // Cosine of normals of faces that might lie on one plane.
  static constexpr double NearlyFlat = 0.999;
  static constexpr double FlatInterface = 0.866; // cosine of 30 degrees

  const CellView& view_;
  const CellShape& shape_;
  JoinSpec spec_;
  std::vector<Vector> normals_; // of faces
  double negligible_;           // areas; on one plane only, none is
  JoinedFaces joined_;
  std::vector<std::uint32_t> groupOf_;                         // of faces
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_; // of neighbouring faces
  Polyhedron trial_;
};

}

JoinedFaces joinFaces(const CellView& view, const CellShape& shape, const JoinSpec& spec)
{
  return view.faces.size() > MostFacesJoined ? JoinedFaces{} : Joiner(view, shape, spec).run();
}

std::vector<JoinedFaces> joinOneMore(const CellView& view, const CellShape& shape,
  const JoinedFaces& joined, std::uint32_t group, double leastCosine)
{
  return view.faces.size() > MostFacesJoined
    ? std::vector<JoinedFaces>{}
    : Joiner(view, shape, { leastCosine, leastCosine }).runWith(joined, group);
}

Polyhedron shapeOf(
  const CellView& view, const JoinedFaces& joined, std::vector<NeighbourCell>& beyond)
{
  if (joined.groups.empty())
  {
    beyond = view.beyond;
    return view.shape;
  }
  Polyhedron shape;
  shape.reserve(view.shape.nodes.size(), joined.groups.size(), view.shape.corners.size());
  shape.nodes = view.shape.nodes;
  beyond.clear();
  beyond.reserve(joined.groups.size());
  for (const JoinedFaces::Group& group : joined.groups)
  {
    const std::uint32_t face = group.members.front();
    shape.corners.insert(shape.corners.end(), group.ring.begin(), group.ring.end());
    shape.closeFace(view.shape.isBoundary[face]);
    beyond.push_back(view.beyond[face]);
  }
  return shape;
}

}
