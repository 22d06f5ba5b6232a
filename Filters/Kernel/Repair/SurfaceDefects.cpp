// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/SurfaceDefects.h"

#include "Base/Error.h"
#include "Base/Sorting.h"
#include "Base/Words.h"
#include "Repair/TrianglePairs.h"
#include "Surface/Components.h"

#include <cmath>
#include <numeric>

namespace cartesian
{

namespace
{

// Overlapped triangles in a message.
constexpr std::size_t MostNamed = 20; // overlapped triangles
constexpr std::size_t MostPlaces = 5; // of other kinds

constexpr std::size_t TrianglesAChunk = 2048;

using Triangle = std::array<std::uint32_t, 3>;

// Two triangles at an edge with almost no angle between them.
struct Fold
{
  std::uint32_t first;
  std::uint32_t second;

  bool operator<(const Fold& other) const
  {
    return first != other.first ? first < other.first : second < other.second;
  }
};

// Points from an edge to the triangle's third corner, at right angles to the edge.
Vector across(const Surface& surface, std::uint32_t lower, const EdgeUse& use)
{
  const Triangle& t = surface.triangles[use.triangle()];
  const Point& p = surface.vertices[lower];
  const Vector edge = minus(surface.vertices[use.upper], p);
  const Vector side = minus(surface.vertices[t[0] ^ t[1] ^ t[2] ^ lower ^ use.upper], p);
  return cross(cross(edge, side), edge);
}

bool folded(const Vector& a, const Vector& b)
{
  static const double least = std::cos(radians(FoldAngle));
  const double product = dot(a, a) * dot(b, b);
  return product > 0 && dot(a, b) > least * std::sqrt(product);
}

// Not the two sides of a sheet.
std::vector<Fold> findFolds(const Surface& surface, const SurfaceEdges& edges, Execution& execution)
{
  const auto isSheet = [&](const EdgeUse& use) { return surface.isOfSheet(use.triangle()); };
  std::vector<std::vector<Fold>> parts(edges.chunkCount());
  edges.forEach(execution,
    [&](std::size_t chunk, std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
      for (const EdgeUse* a = begin; a != end; ++a)
      {
        // Comparing the next few is enough, even at an edge of many triangles.
        for (const EdgeUse* b = a + 1; b != end && b != a + 3; ++b)
        {
          if (folded(across(surface, lower, *a), across(surface, lower, *b)) &&
            !(isSheet(*a) && isSheet(*b)))
          {
            parts[chunk].push_back(
              { std::min(a->triangle(), b->triangle()), std::max(a->triangle(), b->triangle()) });
          }
        }
      }
    });
  std::vector<Fold> folds = concatenated(parts);
  std::sort(folds.begin(), folds.end());
  return folds;
}

struct Partner
{
  std::uint32_t triangle;
  std::uint32_t other;

  bool operator<(const Partner& p) const
  {
    return triangle != p.triangle ? triangle < p.triangle : other < p.other;
  }
};

class DefectLister
{
public:
  DefectLister(const Surface& surface, std::size_t given, const SurfaceRepair& repair,
    const JoinedCracks& cracks, const Meshlines& planes, Execution& execution)
    : surface_(surface)
    , given_(surface)
    , repair_(repair)
    , cracks_(cracks)
    , planes_(planes)
    , execution_(execution)
  {
    given_.triangles.resize(given);
    for (const DroppedTriangle& d : repair.loose)
    {
      given_.triangles[d.triangle] = d.vertices;
    }
  }

  SurfaceDefects list()
  {
    const SurfaceEdges edges(given_, execution_);
    listEdges(edges);
    listTriangles();
    listPairs(findFolds(given_, edges, execution_));
    listComponents();
    listHoles();
    listCracks();
    result_.defects = concatenated(defects_);
    result_.points = concatenated(points_);
    return std::move(result_);
  }

private:
  static constexpr std::uint32_t None = SurfaceDefects::None;

  // `width`: in levels.
  template <class Points>
  void add(DefectKind kind, std::uint32_t triangle, std::uint32_t other, bool polygon,
    const Points& points, double width = 0)
  {
    const auto k = static_cast<std::size_t>(kind);
    if (++result_.counts[k] <= SurfaceDefects::MostListed)
    {
      defects_[k].push_back({ kind, triangle, other, static_cast<std::uint32_t>(points.size()),
        polygon, width * surface_.lattice.step() });
      points_[k].insert(points_[k].end(), points.begin(), points.end());
    }
  }

  Vector positionOf(std::uint32_t vertex) const
  {
    const Point& p = surface_.vertices[vertex];
    const Lattice& lattice = surface_.lattice;
    return { lattice.position(0, p[0]), lattice.position(1, p[1]), lattice.position(2, p[2]) };
  }

  Vector positionOf(const Vector& place) const
  {
    return plus(surface_.lattice.origin(), scaled(place, surface_.lattice.step()));
  }

  std::array<Vector, 3> positionsOf(const Triangle& t) const
  {
    return { positionOf(t[0]), positionOf(t[1]), positionOf(t[2]) };
  }

  std::array<Vector, 4> around(const Triangle& t) const
  {
    return { positionOf(t[0]), positionOf(t[1]), positionOf(t[2]), positionOf(t[0]) };
  }

  void addTriangle(DefectKind kind, std::uint32_t triangle, std::uint32_t other)
  {
    add(kind, triangle, other, true, positionsOf(given_.triangles[triangle]));
  }

  struct FlawedEdge
  {
    DefectKind kind;
    std::uint32_t lower;
    const EdgeUse* begin;
    const EdgeUse* end;
  };

  void listEdges(const SurfaceEdges& edges)
  {
    std::vector<std::vector<FlawedEdge>> parts(edges.chunkCount());
    edges.forEach(execution_,
      [&](std::size_t chunk, std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
        const auto uses = end - begin;
        const auto down = std::count_if(begin, end, [](const EdgeUse& use) { return use.down(); });
        if (uses != 2 || down != 1)
        {
          const DefectKind kind = uses % 2 == 1
            ? DefectKind::OpenEdge
            : (2 * down != uses ? DefectKind::InconsistentEdge : DefectKind::NonManifoldEdge);
          parts[chunk].push_back({ kind, lower, begin, end });
        }
      });
    for (const FlawedEdge& edge : concatenated(parts))
    {
      add(edge.kind, edge.begin->triangle(),
        edge.end - edge.begin > 1 ? edge.begin[1].triangle() : None, false,
        std::array<Vector, 2>{ positionOf(edge.lower), positionOf(edge.begin->upper) });
    }
  }

  std::vector<std::uint32_t> listDegenerate() const
  {
    const std::size_t count = given_.triangles.size();
    std::vector<std::vector<std::uint32_t>> parts(chunks(count, TrianglesAChunk));
    execution_.forEach(count, TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t)
      {
        if (exactNormal(given_.corners(t)) == std::array<Wide, 3>{ 0, 0, 0 })
        {
          parts[begin / TrianglesAChunk].push_back(static_cast<std::uint32_t>(t));
        }
      }
    });
    return concatenated(parts);
  }

  void listTriangles()
  {
    std::vector<bool> dropped(given_.triangles.size());
    const auto k = static_cast<std::size_t>(DefectKind::DuplicateTriangle);
    const std::size_t listed = std::min(repair_.duplicates.size(), SurfaceDefects::MostListed);
    defects_[k].reserve(listed);
    points_[k].reserve(3 * listed);
    for (const DroppedTriangle& d : repair_.duplicates)
    {
      dropped[d.triangle] = true;
      add(DefectKind::DuplicateTriangle, d.triangle, None, true, positionsOf(d.vertices));
    }
    for (const std::uint32_t t : listDegenerate())
    {
      if (!dropped[t])
      {
        add(DefectKind::DegenerateTriangle, t, None, false, around(given_.triangles[t]));
      }
    }
  }

  void listPairs(const std::vector<Fold>& folds)
  {
    std::vector<Partner> folded;
    for (const Fold& fold : folds)
    {
      folded.push_back({ fold.first, fold.second });
      folded.push_back({ fold.second, fold.first });
    }
    addPartners(DefectKind::FoldedTriangle, folded);

    const TrianglePairs& found = repair_.pairs;
    result_.notCompared = found.givenUp.size();
    if (!found.givenUp.empty())
    {
      result_.notComparedAt = positionOf(surface_.triangles[found.givenUp[0]][0]);
    }
    std::vector<Partner> overlapped;
    for (const TrianglePair& pair : found.pairs)
    {
      if (pair.second >= given_.triangles.size())
      {
        continue; // it closes a hole
      }
      if (pair.contact == Contact::Crossing)
      {
        if (repair_.areTouching(pair))
        {
          continue; // an edge lies on a face, or beside it by a rounding
        }
        const std::array<Vector, 2> ends =
          sharedSegment(given_.corners(pair.first), given_.corners(pair.second));
        add(DefectKind::Intersection, pair.first, pair.second, false,
          std::array<Vector, 2>{ positionOf(ends[0]), positionOf(ends[1]) });
      }
      else if (!std::binary_search(folds.begin(), folds.end(), Fold{ pair.first, pair.second }))
      {
        overlapped.push_back({ pair.first, pair.second });
        overlapped.push_back({ pair.second, pair.first });
      }
    }
    addPartners(DefectKind::OverlappedTriangle, overlapped);
  }

  // Lists each triangle once, with its lowest partner.
  void addPartners(DefectKind kind, std::vector<Partner>& partners)
  {
    std::sort(partners.begin(), partners.end());
    for (std::size_t i = 0; i < partners.size(); ++i)
    {
      if (i == 0 || partners[i - 1].triangle != partners[i].triangle)
      {
        addTriangle(kind, partners[i].triangle, partners[i].other);
      }
    }
  }

  void listComponents()
  {
    DisjointSets components = connectedComponents(given_);
    std::vector<Point> low(given_.vertices.size(), Point{ ~0u, ~0u, ~0u });
    std::vector<Point> high(given_.vertices.size(), Point{});
    for (const Triangle& t : given_.triangles)
    {
      const std::uint32_t root = components.find(t[0]);
      for (const std::uint32_t v : t)
      {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          low[root][axis] = std::min(low[root][axis], given_.vertices[v][axis]);
          high[root][axis] = std::max(high[root][axis], given_.vertices[v][axis]);
        }
      }
    }
    std::vector<bool> small(given_.vertices.size());
    for (std::size_t v = 0; v < small.size(); ++v)
    {
      if (low[v][0] <= high[v][0])
      {
        ++result_.components;
        small[v] = true;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          small[v] = small[v] &&
            high[v][axis] - low[v][axis] <
              spacing(planes_[axis], (double(low[v][axis]) + high[v][axis]) / 2);
        }
      }
    }
    for (std::size_t t = 0; t < given_.triangles.size(); ++t)
    {
      if (small[components.find(given_.triangles[t][0])] && !namesAVertexTwice(given_.triangles[t]))
      {
        addTriangle(DefectKind::SmallComponent, static_cast<std::uint32_t>(t), None);
      }
    }
  }

  void listHoles()
  {
    std::vector<Vector> points;
    for (const Hole& hole : repair_.holes)
    {
      points.clear();
      for (const std::uint32_t v : hole.rim)
      {
        points.push_back(positionOf(v));
      }
      points.push_back(points.front());
      add(hole.leak ? DefectKind::Leak : DefectKind::Hole, None, None, false, points, hole.width);
    }
  }

  void listCracks()
  {
    for (const JoinedCracks::Edge& edge : cracks_.joined)
    {
      add(DefectKind::JoinedCrack, None, None, false,
        std::array<Vector, 2>{ positionOf(edge.ends[0]), positionOf(edge.ends[1]) }, edge.width);
    }
  }

  const Surface& surface_;
  Surface given_; // without the triangles that close holes
  const SurfaceRepair& repair_;
  const JoinedCracks& cracks_;
  const Meshlines& planes_;
  Execution& execution_;
  SurfaceDefects result_;
  std::vector<std::vector<Defect>> defects_{ DefectKinds }; // by kind
  std::vector<std::vector<Vector>> points_{ DefectKinds };
};

std::string nameOf(const Defect& defect, const std::vector<long long>& cells)
{
  const long long first = cells[defect.triangle];
  if (defect.kind != DefectKind::Intersection)
  {
    return nameOfCell(first);
  }
  const long long second = cells[defect.other];
  return first < 0 || second < 0
    ? nameOfCell(first) + " and " + nameOfCell(second)
    : "cells " + std::to_string(first) + " and " + std::to_string(second);
}

// The first of a kind, by the user's numbers, with their middles.
std::string listFirst(
  const SurfaceDefects& defects, DefectKind kind, const std::vector<long long>& cells)
{
  const std::size_t most = kind == DefectKind::OverlappedTriangle ? MostNamed : MostPlaces;
  std::string text;
  std::size_t count = 0;
  std::size_t point = 0;
  for (const Defect& defect : defects.defects)
  {
    if (defect.kind == kind && count++ < most)
    {
      Vector middle{};
      for (std::size_t i = point; i < point + defect.size; ++i)
      {
        middle = plus(middle, scaled(defects.points[i], 1. / defect.size));
      }
      text += "\n  " + nameOf(defect, cells) + " at (" + number(middle[0]) + ", " +
        number(middle[1]) + ", " + number(middle[2]) + ")";
    }
    point += defect.size;
  }
  return text + (count > most ? "\n  ..." : "");
}

}

SurfaceDefects findDefects(const Surface& surface, std::size_t given, const SurfaceRepair& repair,
  const JoinedCracks& cracks, const Meshlines& planes, Execution& execution)
{
  return DefectLister(surface, given, repair, cracks, planes, execution).list();
}

SurfaceDefects listContacts(const std::vector<ClosedContact>& contacts, const Lattice& lattice)
{
  SurfaceDefects result;
  std::size_t& count = result.counts[static_cast<std::size_t>(DefectKind::ClosedContact)];
  for (const ClosedContact& contact : contacts)
  {
    for (std::size_t i = 0; i < contact.given.size(); ++i, ++count)
    {
      result.defects.push_back({ DefectKind::ClosedContact, contact.given[i], SurfaceDefects::None,
        3, true, contact.width * lattice.step() });
      for (const Point& p : contact.triangles[i])
      {
        result.points.push_back(
          { lattice.position(0, p[0]), lattice.position(1, p[1]), lattice.position(2, p[2]) });
      }
    }
  }
  return result;
}

void addClosedGap(const std::vector<Vector>& rim, double width, SurfaceDefects& defects)
{
  ++defects.counts[static_cast<std::size_t>(DefectKind::ClosedGap)];
  defects.defects.push_back({ DefectKind::ClosedGap, SurfaceDefects::None, SurfaceDefects::None,
    static_cast<std::uint32_t>(rim.size() + 1), false, width });
  defects.points.insert(defects.points.end(), rim.begin(), rim.end());
  defects.points.push_back(rim.front());
}

std::string describe(const SurfaceDefects& defects, const std::vector<long long>& cells)
{
  const std::array<std::pair<DefectKind, const char*>, 3> kinds = { {
    { DefectKind::FoldedTriangle, " triangles are folded back onto a neighbour." },
    { DefectKind::OverlappedTriangle, " triangles overlap others in the same plane." },
    { DefectKind::Intersection, " pairs of triangles intersect." },
  } };
  std::string text;
  for (const auto& [kind, words] : kinds)
  {
    if (const std::size_t count = defects.counts[static_cast<std::size_t>(kind)])
    {
      text += (text.empty() ? "" : "\n") + std::to_string(count) + words;
      text += listFirst(defects, kind, cells);
    }
  }
  text += text.empty() ? "" : "\nRepair the surface if the mesh shows flaws there.";
  if (defects.notCompared > 0)
  {
    const Vector& at = defects.notComparedAt;
    text += (text.empty() ? "" : "\n") + std::to_string(defects.notCompared) +
      " triangles, such as one at (" + number(at[0]) + ", " + number(at[1]) + ", " + number(at[2]) +
      "), have too many others nearby to be checked for intersections: they are long and thin, or "
      "far larger than others. Subdivide them if the mesh shows flaws there.";
  }
  return text;
}

}
