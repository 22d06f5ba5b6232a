// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/PrismStacks.h"

#include "Layers/StackSides.h"
#include "Polyhedra/CellGeometry.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr double FirstWithin = 0.05;

// The points above a node are numbered consecutively, from the mesh to the wall.
class Columns
{
public:
  Columns(const OutputMesh& mesh, const LayeredWall& wall, std::size_t layers)
    : wall_(wall)
    , layers_(layers)
    , first_(wall.nodes())
  {
    Id next = mesh.pointCount();
    for (std::size_t n = 0; n < wall.nodes(); ++n)
    {
      first_[n] = wall.parts[n] > 0 ? next : -1;
      next += wall.parts[n] > 0 ? static_cast<Id>(layers) : 0;
    }
  }

  std::size_t layers() const { return layers_; }

  // So many layers above the mesh.
  Id above(std::size_t n, std::size_t k) const
  {
    return k == 0 || first_[n] < 0 ? wall_.of.mesh.meshPoint[n]
                                   : first_[n] + static_cast<Id>(k) - 1;
  }

  // The cells of a face's stack.
  std::size_t cells(std::size_t f) const
  {
    return !wall_.hasStack(f) ? 0 : wall_.tapers(f) ? 1 : layers_;
  }

  // Where the k-th of them ends.
  std::size_t end(std::size_t f, std::size_t k) const { return wall_.tapers(f) ? layers_ : k + 1; }

private:
  const LayeredWall& wall_;
  const std::size_t layers_;
  std::vector<Id> first_; // of each node, or -1
};

// So many edges of a face from corner `first` on.
struct Edges
{
  std::size_t face;
  std::size_t first;
  std::size_t count;
};

// Lists the points of the side over edges, from layer k to `end`; none if it has no area.
void listSide(const LayeredWall& wall, const Columns& columns, const Edges& edges, std::size_t k,
  std::size_t end, std::vector<Id>& points)
{
  points.clear();
  const auto add = [&](Id point) {
    if (points.empty() || (point != points.back() && point != points.front()))
    {
      points.push_back(point);
    }
  };
  const std::size_t last = edges.first + edges.count;
  for (std::size_t c = edges.first; c <= last; ++c)
  {
    add(columns.above(wall.node(edges.face, c), k));
  }
  for (std::size_t j = k + 1; j < end; ++j)
  {
    add(columns.above(wall.node(edges.face, last), j));
  }
  for (std::size_t c = last + 1; c-- > edges.first;)
  {
    const Id point = columns.above(wall.node(edges.face, c), end);
    if (point != points[c - edges.first])
    {
      add(point);
    }
  }
  for (std::size_t j = end - 1; j > k; --j)
  {
    add(columns.above(wall.node(edges.face, edges.first), j));
  }
  if (points.size() < 3)
  {
    points.clear();
  }
}

// Calls visit(i, points) for all sides of the k-th cell of a face's stack, each over edges from corner i on.
template <class Visitor>
void forEachSide(const LayeredWall& wall, const Columns& columns, const StackSides& sides,
  std::size_t f, std::size_t k, Visitor&& visit)
{
  std::vector<Id> points;
  for (std::size_t j = k; j < columns.end(f, k); ++j)
  {
    sides.forEach(f, j, [&](std::size_t i, std::size_t n) {
      const bool isWhole = wall.isWhole(f, i);
      if (isWhole && j > k)
      {
        return;
      }
      listSide(wall, columns, { f, i, n }, j, isWhole ? columns.layers() : j + 1, points);
      if (!points.empty())
      {
        visit(i, points);
      }
    });
  }
}

class Stacker
{
public:
  Stacker(const OutputMesh& mesh, const LayeredWall& wall, const LayerHeights& heights)
    : wall_(wall)
    , heights_(heights)
    , columns_(mesh, wall, heights.layers())
    , sides_(wall, heights)
  {
  }

  PrismStacks run()
  {
    placePoints();
    for (std::size_t f = 0; f < wall_.layered.size(); ++f)
    {
      for (std::size_t k = 0; k < columns_.cells(f); ++k)
      {
        addCell(f, k);
      }
    }
    result_.offsets.push_back(static_cast<Id>(result_.connectivity.size()));
    return std::move(result_);
  }

private:
  void placePoints()
  {
    for (std::size_t n = 0; n < wall_.nodes(); ++n)
    {
      if (wall_.parts[n] == 0)
      {
        continue;
      }
      result_.moved.push_back({ wall_.of.mesh.meshPoint[n], wall_.at(n, wall_.parts[n]) });
      for (std::size_t k = 1; k <= columns_.layers(); ++k)
      {
        const Vector at =
          wall_.at(n, heights_.at(wall_.parts[n], columns_.layers() - k, wall_.isFlat[n]));
        result_.points.insert(result_.points.end(), at.begin(), at.end());
        result_.nodeOfPoint.push_back(n);
      }
    }
  }

  void addCell(std::size_t f, std::size_t k)
  {
    std::vector<Id>& stream = result_.faceStream;
    result_.offsets.push_back(static_cast<Id>(result_.connectivity.size()));
    result_.faceStart.push_back(static_cast<Id>(stream.size()));
    const std::size_t count = stream.size();
    const std::size_t end = columns_.end(f, k);
    const std::size_t corners = wall_.corners(f);
    stream.push_back(2);
    stream.push_back(static_cast<Id>(corners));
    for (std::size_t i = 0; i < corners; ++i)
    {
      stream.push_back(columns_.above(wall_.node(f, corners - 1 - i), k));
      result_.connectivity.push_back(stream.back());
    }
    stream.push_back(static_cast<Id>(corners));
    for (std::size_t i = 0; i < corners; ++i)
    {
      const std::size_t n = wall_.node(f, i);
      stream.push_back(columns_.above(n, end));
      for (std::size_t j = k + 1; wall_.parts[n] > 0 && j <= end; ++j)
      {
        result_.connectivity.push_back(columns_.above(n, j));
      }
    }
    forEachSide(
      wall_, columns_, sides_, f, k, [&](std::size_t /*i*/, const std::vector<Id>& points) {
        ++stream[count];
        stream.push_back(static_cast<Id>(points.size()));
        stream.insert(stream.end(), points.begin(), points.end());
      });
    result_.layer.push_back(static_cast<unsigned char>(columns_.layers() + 1 - end));
    result_.face.push_back(f);
    result_.tapers.push_back(wall_.tapers(f));
    result_.isFlat.push_back(wall_.isFlatFace(f));
    result_.below.push_back(wall_.of.faces[f].cell);
  }

  const LayeredWall& wall_;
  const LayerHeights& heights_;
  const Columns columns_;
  const StackSides sides_;
  PrismStacks result_;
};

class BoundaryLister
{
public:
  BoundaryLister(const OutputMesh& mesh, const LayeredWall& wall, const LayerHeights& heights,
    const std::vector<double>& lastByCell)
    : mesh_(mesh)
    , wall_(wall)
    , heights_(heights)
    , columns_(mesh, wall, heights.layers())
    , sides_(wall, heights)
    , lastByCell_(lastByCell)
  {
  }

  LayeredBoundary run()
  {
    keepWithoutStacks();
    Id cell = mesh_.cellCount();
    for (std::size_t f = 0; f < wall_.layered.size(); ++f)
    {
      for (std::size_t k = 0; k < columns_.cells(f); ++k)
      {
        addOf(f, k, cell++);
      }
    }
    result_.mesh.start.push_back(static_cast<Id>(result_.mesh.corners.size()));
    numberPoints(result_.mesh);
    return std::move(result_);
  }

private:
  void addInterface(std::size_t f, Id cell)
  {
    const FaceGeometry geometry = measureFace(wall_.corners(f),
      [&](std::size_t i) -> const Vector& { return wall_.place[wall_.node(f, i)]; });
    result_.interfaces.push_back({ wall_.of.ofInterface[f - wall_.of.boundaryFaces()],
      wall_.of.region, cell, wall_.of.boundary[f], norm(geometry.area), measureOf(f) });
  }

  StackMeasure measureOf(std::size_t f) const
  {
    StackMeasure measure;
    measure.asked = wall_.asked[f];
    measure.layers = static_cast<int>(columns_.cells(f));
    measure.end = wall_.endOn(f);
    if (measure.layers > 0)
    {
      measure.thickness = wall_.thickness(f);
      const double first = wall_.heightOn(
        f, [&](std::size_t n) { return heights_.at(wall_.parts[n], 1, wall_.isFlat[n]); });
      const double asked = measure.asked * heights_.at(1, 1, true);
      measure.lastByCell = lastByCell_[f];
      measure.isWhole = !wall_.tapers(f) && std::abs(first - asked) <= FirstWithin * asked;
    }
    return measure;
  }

  void add(const BoundaryFace& face, const std::vector<Id>& points, const StackMeasure& stack)
  {
    result_.faces.push_back(face);
    result_.stacks.push_back(stack);
    std::vector<Id>& corners = result_.mesh.corners;
    result_.mesh.start.push_back(static_cast<Id>(corners.size())); // the end comes last
    corners.insert(corners.end(), points.begin(), points.end());
  }

  std::vector<Id> pointsOf(std::size_t f, std::size_t k) const
  {
    std::vector<Id> points;
    for (std::size_t i = 0; i < wall_.corners(f); ++i)
    {
      points.push_back(columns_.above(wall_.node(f, i), k));
    }
    return points;
  }

  void keepWithoutStacks()
  {
    for (std::size_t f = 0; f < wall_.layered.size(); ++f)
    {
      if (wall_.hasStack(f))
      {
        continue;
      }
      if (wall_.of.isInterface(f))
      {
        addInterface(f, wall_.of.faces[f].cell);
      }
      else
      {
        add(wall_.of.faces[f], pointsOf(f, 0), measureOf(f));
      }
    }
  }

  void addOf(std::size_t f, std::size_t k, Id cell)
  {
    const bool isAtWall = columns_.end(f, k) == columns_.layers();
    if (isAtWall && wall_.of.isInterface(f))
    {
      addInterface(f, cell);
    }
    else if (isAtWall)
    {
      const BoundaryFace& base = wall_.of.faces[f];
      add({ cell, base.index, base.boundary, BoundaryFace::Kind::Cut },
        pointsOf(f, columns_.layers()), measureOf(f));
    }
    forEachSide(wall_, columns_, sides_, f, k, [&](std::size_t i, const std::vector<Id>& points) {
      const std::size_t other = wall_.faceBeyond(f, i);
      if (!wall_.layered[other])
      {
        const BoundaryFace& there = wall_.of.faces[other];
        add({ cell, there.index, there.boundary, BoundaryFace::Kind::Cut }, points, {});
      }
    });
  }

  const OutputMesh& mesh_;
  const LayeredWall& wall_;
  const LayerHeights& heights_;
  const Columns columns_;
  const StackSides sides_;
  const std::vector<double>& lastByCell_;
  LayeredBoundary result_;
};

}

void numberPoints(BoundaryMesh& mesh)
{
  mesh.meshPoint = mesh.corners;
  std::sort(mesh.meshPoint.begin(), mesh.meshPoint.end());
  mesh.meshPoint.erase(
    std::unique(mesh.meshPoint.begin(), mesh.meshPoint.end()), mesh.meshPoint.end());
  for (Id& corner : mesh.corners)
  {
    corner = std::lower_bound(mesh.meshPoint.begin(), mesh.meshPoint.end(), corner) -
      mesh.meshPoint.begin();
  }
}

PrismStacks stackPrisms(
  const OutputMesh& mesh, const LayeredWall& wall, const LayerHeights& heights)
{
  return Stacker(mesh, wall, heights).run();
}

LayeredBoundary boundaryOf(const OutputMesh& mesh, const LayeredWall& wall,
  const LayerHeights& heights, const std::vector<double>& lastByCell)
{
  return BoundaryLister(mesh, wall, heights, lastByCell).run();
}

}
