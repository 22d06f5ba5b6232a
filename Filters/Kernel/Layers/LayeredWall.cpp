// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/LayeredWall.h"

#include "Lattice/LineMeeting.h"
#include "Layers/BoxSides.h"
#include "Polyhedra/CellGeometry.h"
#include "Polyhedra/OffsetPlanes.h"
#include "Repair/TriangleTree.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr double PartOfTheWay = 1.0 / 3; // to what lies opposite
constexpr double SinOfOnePlane = 0.1;    // normals that differ by less count as equal
constexpr double SinOfSharpEdge = 0.7;   // ... about the way of a node
constexpr std::size_t NodesAChunk = 256;

class WallFinder
{
public:
  WallFinder(LayerRegion region, const OutputMesh& mesh, const WallLayerSpec& spec)
    : mesh_(mesh)
    , spec_(spec)
  {
    wall_.of = std::move(region);
  }

  LayeredWall run(const std::vector<double>& points, Execution& execution)
  {
    for (const Id point : wall_.of.mesh.meshPoint)
    {
      const double* const at = &points[3 * static_cast<std::size_t>(point)];
      wall_.place.push_back({ at[0], at[1], at[2] });
    }
    findLayered();
    findBeyond();
    facets_.resize(wall_.nodes());
    others_.resize(wall_.nodes());
    for (std::size_t f = 0; f < wall_.layered.size(); ++f)
    {
      addFace(f);
    }
    findWays(execution);
    endAtOddEdges();
    endAtInterfaces();
    return std::move(wall_);
  }

private:
  void findLayered()
  {
    wall_.layered.resize(wall_.of.faces.size());
    wall_.isOnWall.assign(wall_.nodes(), 0);
    wall_.usual.assign(wall_.nodes(), 0);
    wall_.isFlat.assign(wall_.nodes(), 1);
    const std::vector<double> sides = boxSides(mesh_, wall_.of.faces);
    const double first = heightsOfLayers(spec_)[1];
    for (std::size_t f = 0; f < wall_.layered.size(); ++f)
    {
      const double usual = totalThickness(spec_, sides[f]);
      wall_.asked.push_back(
        spec_.isIn(wall_.of.region) ? spec_.thicknessAt(wall_.of.boundary[f], usual) : 0);
      wall_.layered[f] = wall_.asked[f] > 0;
      for (std::size_t i = 0; wall_.layered[f] && i < wall_.corners(f); ++i)
      {
        const std::size_t n = wall_.node(f, i);
        wall_.isOnWall[n] = 1;
        wall_.usual[n] = std::max(wall_.usual[n], usual);
        wall_.isFlat[n] = wall_.isFlat[n] && isFlat(first * wall_.asked[f], sides[f]);
      }
    }
  }

  void findBeyond()
  {
    std::vector<std::array<std::size_t, 4>> edges; // lower node, upper node, corner, face
    for (std::size_t f = 0; f < wall_.layered.size(); ++f)
    {
      for (std::size_t i = 0; i < wall_.corners(f); ++i)
      {
        const std::size_t a = wall_.node(f, i);
        const std::size_t b = wall_.node(f, i + 1);
        edges.push_back({ std::min(a, b), std::max(a, b), wall_.corner(f, i), f });
      }
    }
    std::sort(edges.begin(), edges.end());
    wall_.beyond.resize(edges.size());
    wall_.opposite.resize(edges.size());
    for (std::size_t i = 0; i < edges.size();)
    {
      std::size_t end = i + 1;
      while (end < edges.size() && edges[end][0] == edges[i][0] && edges[end][1] == edges[i][1])
      {
        ++end;
      }
      for (std::size_t k = i; k < end; ++k)
      {
        const auto& other = edges[end - i == 2 ? i + end - 1 - k : k];
        wall_.beyond[edges[k][2]] = other[3];
        wall_.opposite[edges[k][2]] = other[2];
      }
      i = end;
    }
  }

  void addFace(std::size_t f)
  {
    const std::size_t size = wall_.corners(f);
    const auto at = [&](std::size_t i) -> const Vector& { return wall_.place[wall_.node(f, i)]; };
    const Vector inwards = scaled(unit(measureFace(size, at).area), -1);
    for (std::size_t i = 0; norm(inwards) > 0 && i < size; ++i)
    {
      const Vector back = minus(at(i + size - 1), at(i));
      const Vector ahead = minus(at(i + 1), at(i));
      const std::size_t n = wall_.node(f, i);
      addFacet((wall_.layered[f] ? facets_ : others_)[n],
        { inwards, radians(angle(back, ahead)), wall_.asked[f] });
    }
  }

  void findWays(Execution& execution)
  {
    wall_.way.assign(wall_.nodes(), Vector{});
    wall_.fixed.resize(wall_.nodes());
    wall_.across.resize(wall_.nodes());
    wall_.parts.assign(wall_.nodes(), 0);
    wall_.ends.assign(wall_.nodes(), LayerEnd::Nowhere);
    execution.forEach(wall_.nodes(), NodesAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
      {
        wall_.fixed[n] = independentNormals(others_[n], SinOfOnePlane);
        if (wall_.isOnWall[n])
        {
          wall_.way[n] = meetingPoint(facets_[n], wall_.fixed[n]);
          std::vector<Facet> all = others_[n];
          all.push_back({ unit(wall_.way[n]), 1, wall_.usual[n] });
          all.insert(all.end(), facets_[n].begin(), facets_[n].end());
          wall_.across[n] = independentNormals(all, SinOfSharpEdge);
          wall_.parts[n] = norm(wall_.way[n]) > 0 ? 1 : 0;
          wall_.ends[n] = wall_.parts[n] > 0 ? LayerEnd::Nowhere : LayerEnd::Corner;
        }
      }
    });
  }

  // Edges of other than two faces have no unique neighbour: their nodes cannot have layers.
  void endAtOddEdges()
  {
    for (std::size_t f = 0; f < wall_.layered.size(); ++f)
    {
      for (std::size_t i = 0; i < wall_.corners(f); ++i)
      {
        if (wall_.faceBeyond(f, i) == f)
        {
          for (const std::size_t n : { wall_.node(f, i), wall_.node(f, i + 1) })
          {
            wall_.parts[n] = 0;
            wall_.ends[n] = LayerEnd::Corner;
          }
        }
      }
    }
  }

  // The cells beyond an interface without layers do not change, nor do its edges.
  void endAtInterfaces()
  {
    for (std::size_t f = wall_.of.boundaryFaces(); f < wall_.layered.size(); ++f)
    {
      for (std::size_t i = 0; !wall_.layered[f] && i < wall_.corners(f); ++i)
      {
        wall_.parts[wall_.node(f, i)] = 0;
        wall_.ends[wall_.node(f, i)] = LayerEnd::Corner;
      }
    }
  }

  const OutputMesh& mesh_;
  const WallLayerSpec& spec_;
  std::vector<std::vector<Facet>> facets_; // around each node, of walls with layers
  std::vector<std::vector<Facet>> others_;
  LayeredWall wall_;
};

// Whether a triangle bounds a region, and which way its normal points.
struct Facing
{
  bool outwards;
  bool inwards;
};

Facing facing(const Surface& surface, std::uint32_t triangle, std::int32_t region)
{
  const std::int32_t boundary = surface.boundary[triangle];
  return surface.walls.any()
    ? Facing{ surface.walls.behind(boundary) == region, surface.walls.front(boundary) == region }
    : Facing{ true, false };
}

// Where a ray leaves a region through a triangle, in its own length; more than 1: it does not.
double leavesAt(const Vector& from, const Vector& along, const Corners& c, const Facing& facing)
{
  constexpr double Rounding = 1e-9;
  const LineMeeting m = meetLine(c, from, along);
  const bool meets = (m.leaves ? facing.outwards : facing.inwards) && m.second >= -Rounding &&
    m.third >= -Rounding && m.second + m.third <= 1 + Rounding && m.distance > 0;
  return meets ? m.distance : 2;
}

}

bool LayeredWall::hasStack(std::size_t face) const
{
  bool any = false;
  for (std::size_t i = 0; i < corners(face); ++i)
  {
    any = any || parts[node(face, i)] > 0;
  }
  return layered[face] && any;
}

bool LayeredWall::tapers(std::size_t face) const
{
  bool any = false;
  for (std::size_t i = 0; i < corners(face); ++i)
  {
    any = any || parts[node(face, i)] == 0;
  }
  return any && hasStack(face);
}

bool LayeredWall::isFlatFace(std::size_t face) const
{
  bool all = true;
  for (std::size_t i = 0; i < corners(face); ++i)
  {
    all = all && isFlat[node(face, i)];
  }
  return all;
}

LayerEnd LayeredWall::endOn(std::size_t face) const
{
  LayerEnd end = LayerEnd::Nowhere;
  for (std::size_t i = 0; i < corners(face); ++i)
  {
    end = std::max(end, ends[node(face, i)]);
  }
  return end;
}

LayeredWall findLayeredWall(LayerRegion region, const OutputMesh& mesh,
  const std::vector<double>& points, const WallLayerSpec& spec, Execution& execution)
{
  return WallFinder(std::move(region), mesh, spec).run(points, execution);
}

void keepFromOpposite(
  LayeredWall& wall, const Surface& surface, const FlowDomainSides& sides, Execution& execution)
{
  const TriangleTree tree(surface, execution);
  const Lattice& lattice = surface.lattice;
  execution.forEach(wall.nodes(), NodesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      if (wall.parts[n] == 0)
      {
        continue;
      }
      wall.way[n] = sides.along(wall.place[n], wall.way[n]);
      const Vector from = scaled(minus(wall.place[n], lattice.origin()), 1 / lattice.step());
      const Vector along = scaled(wall.way[n], 1 / PartOfTheWay / lattice.step());
      const Vector to = plus(from, along);
      wall.parts[n] = std::min(
        wall.parts[n], sides.leavesAt(wall.place[n], scaled(wall.way[n], 1 / PartOfTheWay)));
      Vector low = from;
      Vector high = from;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        low[axis] = std::min(from[axis], to[axis]);
        high[axis] = std::max(from[axis], to[axis]);
      }
      tree.forEachWithin(low, high, [&](std::uint32_t t) {
        wall.parts[n] = std::min(wall.parts[n],
          leavesAt(from, along, surface.corners(t), facing(surface, t, wall.of.region)));
      });
      wall.ends[n] = wall.parts[n] < 1 ? LayerEnd::Gap : wall.ends[n];
    }
  });
}

}
