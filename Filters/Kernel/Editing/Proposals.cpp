// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/Proposals.h"

#include "Base/Rings.h"
#include "Editing/EdgeArea.h"
#include "Editing/EditMeasures.h"
#include "Editing/PrimitiveEdits.h"
#include "Editing/WallEdges.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace cartesian
{

namespace
{

constexpr double MostRemovedUnasked = 0.05; // of its box: of a cell of which no face fails
constexpr double SmallShare = 0.5;  // of its box: such a cell has one more neighbour to merge with
constexpr double LargestMerged = 2; // boxes, together
constexpr double JoinCosine = 0.5;  // 60 degrees: walls that turn by more are not joined
constexpr double ShortEdge = 0.05;  // in boxes: to its middle alone
constexpr double ShortEdgeOfCell = 0.35; // in boxes
constexpr double CostOfCuts = 3;         // walls that cost more have their cell cut
constexpr double ReentrantCosine = 0.94; // 20 degrees
constexpr double LeastReentrant = 0.01;  // in boxes: how far the one wall is in front of the other
constexpr double FlatWarp = 0.05;
constexpr std::size_t MostCornersToSplit = 12;
constexpr std::size_t MostCornersOfFailing = 24;
constexpr std::size_t BestChords = 2;
constexpr double LeastStarOfPart = 0.05;
constexpr std::size_t MostFacesToCut = 100;

double edgeAt(const MeshView& mesh, std::uint32_t f)
{
  return mesh.cell(mesh.face(f).below).edge;
}

void proposeMerges(const MeshView& mesh, std::uint32_t c, std::size_t most, Proposals& proposals)
{
  if (!mesh.isFree(c))
  {
    return;
  }
  const Neighbours neighbours = largestNeighbours(mesh, c);
  for (std::size_t i = 0; i < std::min(most, neighbours.size()); ++i)
  {
    std::uint32_t into = neighbours[i];
    std::uint32_t from = c;
    if (std::make_tuple(mesh.facesOf(into).size(), from) <
      std::make_tuple(mesh.facesOf(from).size(), into))
    {
      std::swap(into, from);
    }
    if (mesh.cell(into).region == mesh.cell(from).region &&
      shareOf(mesh, into) + shareOf(mesh, from) < LargestMerged)
    {
      proposals.push_back({ EditKind::Merge, into, from });
    }
  }
}

void proposeCollapse(const MeshView& mesh, const SearchSpec& search, double edge, std::uint32_t u,
  std::uint32_t v, Proposals& proposals)
{
  const EditNode& a = mesh.node(u);
  const EditNode& b = mesh.node(v);
  const double length = norm(minus(a.at, b.at));
  if (length > search.longestEdge * edge)
  {
    return;
  }
  if (a.kind == b.kind && a.kind != NodeKind::Corner && a.constrainedAxes == b.constrainedAxes)
  {
    proposals.push_back({ EditKind::Collapse, std::min(u, v), std::max(u, v), 0,
      placeKeepingArea(mesh, std::min(u, v), std::max(u, v),
        onLattice(mesh, scaled(plus(a.at, b.at), 0.5), a.constrainedAxes)) });
    if (length < ShortEdge * edge)
    {
      return;
    }
  }
  if (!(a.atWall && !b.atWall))
  {
    proposals.push_back({ EditKind::Collapse, u, v, 0, placeKeepingArea(mesh, u, v, b.at) });
  }
  if (!(b.atWall && !a.atWall))
  {
    proposals.push_back({ EditKind::Collapse, v, u, 0, placeKeepingArea(mesh, v, u, a.at) });
  }
}

void proposeShortEdges(
  const MeshView& mesh, const SearchSpec& search, std::uint32_t f, Proposals& proposals)
{
  const Items ring = mesh.cornersOf(f);
  FixedList<std::pair<double, std::size_t>, 64> edges;
  const double edge = edgeAt(mesh, f);
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const double length = norm(minus(mesh.node(ring[i]).at, mesh.node(following(ring, i)).at));
    if (length < search.longestEdge * edge)
    {
      edges.offer({ length, i });
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t k = 0; k < std::min(search.edges, edges.size()); ++k)
  {
    const std::size_t i = edges[k].second;
    proposeCollapse(mesh, search, edge, ring[i], following(ring, i), proposals);
  }
}

void proposeJoins(const MeshView& mesh, std::uint32_t f, Proposals& proposals)
{
  const std::uint32_t c = mesh.face(f).below;
  for (const std::uint32_t g : mesh.facesOf(c))
  {
    if (g != f && couldJoin(mesh, f, g, c))
    {
      proposals.push_back({ EditKind::Join, f, g });
    }
  }
}

void proposeRemoval(const MeshView& mesh, std::uint32_t c, double share, Proposals& proposals)
{
  if (mesh.isFree(c) && shareOf(mesh, c) < share && couldRemove(mesh, c))
  {
    proposals.push_back({ EditKind::Remove, c });
  }
}

// A way to divide a face: the smaller star of its parts.
struct Chord
{
  double star = 0;
  std::uint32_t from = 0;
  std::uint32_t to = 0;
};

// Of a part of a face, from corner i to corner j: the smallest triangle around its mean, by the mean one; NoGain if too small.
double starOfPart(const MeshView& mesh, std::uint32_t f, std::size_t i, std::size_t j)
{
  const std::size_t size = mesh.face(f).corners.size;
  const std::size_t count = (j + size - i) % size + 1;
  const Vector normal = unit(mesh.face(f).area);
  const auto at = [&](std::size_t k) -> const Vector& { return mesh.corner(f, (i + k) % size); };
  double sum = 0;
  double least = -NoGain;
  forEachStarTriangle(count, at, [&](const Vector&, const Vector&, const Vector& triangle) {
    const double area = dot(triangle, normal);
    sum += area;
    least = std::min(least, area);
  });
  constexpr double LeastArea = 0.5e-4; // of a box's side
  const double edge = edgeAt(mesh, f);
  return sum > LeastArea * edge * edge ? least * double(count) / sum : NoGain;
}

void proposeSplits(const MeshView& mesh, std::uint32_t f, Proposals& proposals)
{
  const EditFace& face = mesh.face(f);
  const std::size_t size = face.corners.size;
  const bool isFailing = face.star < 0;
  if (size < 5 || size > (isFailing ? MostCornersOfFailing : MostCornersToSplit) ||
    (face.star >= Wanted::Star && face.warp <= FlatWarp))
  {
    return;
  }
  const double least = isFailing ? double(face.star) : LeastStarOfPart;
  std::array<Chord, BestChords> best{ Chord{ least }, Chord{ least } };
  for (std::uint32_t i = 0; i < size; ++i)
  {
    for (std::uint32_t j = i + 2; j < size; ++j)
    {
      if (i == 0 && j + 1 == size)
      {
        continue;
      }
      Chord chord{ std::min(starOfPart(mesh, f, i, j), starOfPart(mesh, f, j, i)), i, j };
      for (Chord& known : best)
      {
        if (chord.star > known.star)
        {
          std::swap(chord, known);
        }
      }
    }
  }
  for (const Chord& chord : best)
  {
    if (chord.star > least)
    {
      proposals.push_back({ EditKind::SplitFace, f, chord.from, chord.to });
    }
  }
}

// An edge of a cell at which its wall bends inwards.
struct ReentrantEdge
{
  double weight;
  Vector middle;
  Vector one; // the normals of the walls
  Vector other;
};

using ReentrantEdges = FixedList<ReentrantEdge, 64>;

Vector outOf(const MeshView& mesh, std::uint32_t c, std::uint32_t f)
{
  return scaled(unit(mesh.face(f).area), mesh.face(f).below == c ? 1 : -1);
}

void addReentrant(
  const MeshView& mesh, std::uint32_t c, std::uint32_t f, std::uint32_t g, ReentrantEdges& edges)
{
  const Vector one = outOf(mesh, c, f);
  const Vector other = outOf(mesh, c, g);
  if (dot(one, other) > ReentrantCosine ||
    dot(one, minus(mesh.face(g).centre, mesh.face(f).centre)) < LeastReentrant * edgeAt(mesh, f))
  {
    return;
  }
  const Items a = mesh.cornersOf(f);
  const Items b = mesh.cornersOf(g);
  const bool isTurned = (mesh.face(f).below == c) != (mesh.face(g).below == c);
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    const std::uint32_t p = a[i];
    const std::uint32_t q = following(a, i);
    const std::size_t j = placeOf(b, isTurned ? p : q);
    if (j < b.size() && following(b, j) == (isTurned ? q : p))
    {
      const Vector& from = mesh.node(p).at;
      const Vector& to = mesh.node(q).at;
      edges.offer(
        { (1 - dot(one, other)) * norm(minus(to, from)), scaled(plus(from, to), 0.5), one, other });
    }
  }
}

void proposeCuts(
  const MeshView& mesh, const SearchSpec& search, std::uint32_t c, Proposals& proposals)
{
  const Items faces = mesh.facesOf(c);
  if (!mesh.isFree(c) || faces.size() > MostFacesToCut)
  {
    return;
  }
  ReentrantEdges edges;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    for (std::size_t j = i + 1; j < faces.size() && mesh.isSurface(faces[i]); ++j)
    {
      if (mesh.isSurface(faces[j]))
      {
        addReentrant(mesh, c, faces[i], faces[j], edges);
      }
    }
  }
  std::stable_sort(edges.begin(), edges.end(),
    [](const ReentrantEdge& x, const ReentrantEdge& y) { return x.weight > y.weight; });
  for (std::size_t k = 0; k < std::min(search.cuts, edges.size()); ++k)
  {
    const ReentrantEdge& edge = edges[k];
    proposals.push_back({ EditKind::Cut, c, 0, 0, edge.middle, unit(minus(edge.one, edge.other)) });
    if (search.cutsAlongFaces)
    {
      proposals.push_back({ EditKind::Cut, c, 0, 0, edge.middle, edge.one });
      proposals.push_back({ EditKind::Cut, c, 0, 0, edge.middle, edge.other });
    }
  }
}

void proposeCutsOfFailing(
  const MeshView& mesh, const SearchSpec& search, std::uint32_t f, Proposals& proposals)
{
  const EditFace& face = mesh.face(f);
  if (mesh.isWall(f))
  {
    proposals.push_back({ EditKind::Flatten, f });
  }
  for (const std::uint32_t c : { face.below, face.above })
  {
    if (c == None || !mesh.isFree(c))
    {
      continue;
    }
    proposeCuts(mesh, search, c, proposals);
    proposals.push_back({ EditKind::Cut, c, 0, 0, face.centre, unit(face.area) });
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      Vector normal{};
      normal[axis] = 1;
      proposals.push_back({ EditKind::Cut, c, 0, 0, mesh.cell(c).centre, normal });
    }
  }
}

// Edits of other kinds, and of lower numbers, come first; each once.
void arrange(Proposals& proposals)
{
  const auto key = [](
                     const Proposal& p) { return std::tie(p.kind, p.a, p.b, p.c, p.at, p.normal); };
  std::sort(proposals.begin(), proposals.end(),
    [&](const Proposal& x, const Proposal& y) { return key(x) < key(y); });
  proposals.erase(std::unique(proposals.begin(), proposals.end(),
                    [&](const Proposal& x, const Proposal& y) { return key(x) == key(y); }),
    proposals.end());
}

}

Neighbours largestNeighbours(const MeshView& mesh, std::uint32_t c)
{
  FixedList<std::pair<double, std::uint32_t>, 64> found;
  for (const std::uint32_t f : mesh.facesOf(c))
  {
    const std::uint32_t other = mesh.beyond(f, c);
    if (other == None || !mesh.isFree(other))
    {
      continue;
    }
    auto* known = std::find_if(
      found.begin(), found.end(), [&](const auto& entry) { return entry.second == other; });
    if (known != found.end())
    {
      known->first -= norm(mesh.face(f).area);
    }
    else
    {
      found.offer({ -norm(mesh.face(f).area), other });
    }
  }
  std::sort(found.begin(), found.end());
  Neighbours neighbours;
  for (const auto& [area, other] : found)
  {
    neighbours.push(other);
  }
  return neighbours;
}

bool couldRemove(const MeshView& mesh, std::uint32_t c)
{
  constexpr double Any = 1e30;
  if (shareOf(mesh, c) >= ratioOf(mesh.mesh().small, mesh.cell(c).wall, Any))
  {
    return false;
  }
  const Items faces = mesh.facesOf(c);
  return std::any_of(faces.begin(), faces.end(), [&](std::uint32_t f) { return mesh.isWall(f); }) &&
    std::all_of(faces.begin(), faces.end(),
      [&](std::uint32_t f) { return mesh.isWall(f) || !mesh.isSurface(f); }) &&
    !isThinThere(mesh, c) && !isBridge(mesh, c);
}

bool couldJoin(const MeshView& mesh, std::uint32_t f, std::uint32_t g, std::uint32_t c)
{
  return mesh.beyond(f, c) == mesh.beyond(g, c) && mesh.face(f).wall == mesh.face(g).wall &&
    (!mesh.isSurface(f) || cosineBetween(mesh, f, g) >= JoinCosine) && areAdjacent(mesh, f, g);
}

void proposeForFace(
  const MeshView& mesh, const SearchSpec& search, std::uint32_t f, Proposals& proposals)
{
  const EditFace& face = mesh.face(f);
  for (const std::uint32_t c : { face.below, face.above })
  {
    if (c != None)
    {
      const bool isSmall = shareOf(mesh, c) < SmallShare;
      proposeMerges(mesh, c, search.neighbours - (isSmall ? 0 : 1), proposals);
      proposeRemoval(mesh, c, search.removedShare, proposals);
    }
  }
  proposeJoins(mesh, f, proposals);
  proposeShortEdges(mesh, search, f, proposals);
  for (const std::uint32_t c : { face.below, face.above })
  {
    if (c != None && face.cost > CostOfCuts && mesh.isSurface(f))
    {
      proposeCuts(mesh, search, c, proposals);
    }
  }
  if (search.cutsFailing && face.fails > 0)
  {
    proposeCutsOfFailing(mesh, search, f, proposals);
  }
  proposeSplits(mesh, f, proposals);
  arrange(proposals);
}

void proposeForCell(
  const MeshView& mesh, const SearchSpec& search, std::uint32_t c, Proposals& proposals)
{
  constexpr std::size_t AllNeighbours = 6;
  proposeMerges(mesh, c, AllNeighbours, proposals);
  proposeRemoval(mesh, c, std::min(search.removedShare, MostRemovedUnasked), proposals);
  const double edge = mesh.cell(c).edge;
  for (const std::uint32_t f : mesh.facesOf(c))
  {
    const Items ring = mesh.cornersOf(f);
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const std::uint32_t u = ring[i];
      const std::uint32_t v = following(ring, i);
      if (u < v && norm(minus(mesh.node(u).at, mesh.node(v).at)) < ShortEdgeOfCell * edge)
      {
        proposeCollapse(mesh, search, edge, u, v, proposals);
      }
    }
  }
  arrange(proposals);
}

}
