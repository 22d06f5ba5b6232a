// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/PrismStacks.h"

#include "Layers/StackSides.h"
#include "Polyhedra/CellGeometry.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace cartesian
{

namespace
{

constexpr double FirstWithin = 0.05;
constexpr double FilmByWidth = 0.1;

// The points above a node are numbered consecutively, from the mesh to the wall.
class Columns
{
public:
  Columns(const OutputMesh& mesh, const LayeredWall& wall, const StackCells& cells)
    : wall_(wall)
    , cells_(cells)
    , first_(wall.nodes())
  {
    Id next = mesh.pointCount();
    for (std::size_t n = 0; n < wall.nodes(); ++n)
    {
      first_[n] = next;
      next += static_cast<Id>(cells.layersAt(n));
    }
  }

  // Where the layer begins that is the k-th from the mesh if all are there: the mesh's point above those that are.
  Id above(std::size_t n, std::size_t k) const
  {
    const std::size_t missing = cells_.layers() - cells_.layersAt(n);
    return k <= missing ? wall_.of.mesh.meshPoint[n] : first_[n] + static_cast<Id>(k - missing) - 1;
  }

private:
  const LayeredWall& wall_;
  const StackCells& cells_;
  std::vector<Id> first_; // of each node
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

// Calls visit(i) for all sides of the k-th cell of a face's stack, each over edges from corner i on; `points` has those of
// the side.
template <class Visitor>
void forEachSide(const LayeredWall& wall, const StackCells& cells, const Columns& columns,
  const StackSides& sides, std::size_t f, std::size_t k, std::vector<Id>& points, Visitor&& visit)
{
  for (std::size_t j = cells.begin(f, k); j < cells.end(f, k); ++j)
  {
    sides.forEach(f, j, [&](std::size_t i, std::size_t n) {
      if (!cells.isSideAt(f, i, j))
      {
        return;
      }
      listSide(wall, columns, { f, i, n }, j, cells.endOfSide(f, i, j), points);
      if (!points.empty())
      {
        visit(i);
      }
    });
  }
}

constexpr std::size_t FacesAChunk = 256;

class Stacker
{
public:
  Stacker(const OutputMesh& mesh, const LayeredWall& wall, const LayerHeights& heights,
    const std::vector<std::uint8_t>& isWanted, Execution& execution)
    : wall_(wall)
    , heights_(heights)
    , isWanted_(isWanted)
    , cells_(wall, heights, execution)
    , columns_(mesh, wall, cells_)
    , sides_(wall, heights, cells_, execution)
  {
  }

  PrismStacks run(Execution& execution) const
  {
    const std::size_t faces = wall_.layered.size();
    std::vector<PrismStacks> parts(chunks(faces, FacesAChunk));
    execution.forEach(faces, FacesAChunk, [&](std::size_t begin, std::size_t end) {
      PrismStacks& part = parts[begin / FacesAChunk];
      std::vector<Id> points;
      for (std::size_t f = begin; f < end; ++f)
      {
        for (std::size_t k = 0; isWanted(f) && k < cells_.cells(f); ++k)
        {
          addCell(f, k, points, part);
        }
      }
      part.offsets.push_back(static_cast<Id>(part.connectivity.size()));
    });
    PrismStacks result;
    placePoints(result);
    result.offsets.push_back(0);
    for (PrismStacks& part : parts)
    {
      appendCells(result, part);
      part = {};
    }
    return result;
  }

private:
  bool isWanted(std::size_t f) const { return isWanted_.empty() || isWanted_[f] != 0; }

  void placePoints(PrismStacks& result) const
  {
    for (std::size_t n = 0; n < wall_.nodes(); ++n)
    {
      for (std::size_t k = cells_.layersAt(n); k-- > 0;)
      {
        const Vector at = wall_.at(n, heights_.at(wall_.parts[n], k, wall_.isFlat[n]));
        result.points.insert(result.points.end(), at.begin(), at.end());
        result.nodeOfPoint.push_back(n);
      }
    }
  }

  // `points`: scratch.
  void addCell(std::size_t f, std::size_t k, std::vector<Id>& points, PrismStacks& part) const
  {
    std::vector<Id>& stream = part.faceStream;
    part.offsets.push_back(static_cast<Id>(part.connectivity.size()));
    part.faceStart.push_back(static_cast<Id>(stream.size()));
    const std::size_t count = stream.size();
    const std::size_t begin = cells_.begin(f, k);
    const std::size_t end = cells_.end(f, k);
    const std::size_t corners = wall_.corners(f);
    stream.push_back(2);
    stream.push_back(static_cast<Id>(corners));
    for (std::size_t i = 0; i < corners; ++i)
    {
      stream.push_back(columns_.above(wall_.node(f, corners - 1 - i), begin));
      part.connectivity.push_back(stream.back());
    }
    stream.push_back(static_cast<Id>(corners));
    for (std::size_t i = 0; i < corners; ++i)
    {
      const std::size_t n = wall_.node(f, i);
      stream.push_back(columns_.above(n, end));
      for (std::size_t j = begin + 1; j <= end; ++j)
      {
        const Id point = columns_.above(n, j);
        point != columns_.above(n, j - 1) ? part.connectivity.push_back(point) : void();
      }
    }
    forEachSide(wall_, cells_, columns_, sides_, f, k, points, [&](std::size_t) {
      ++stream[count];
      stream.push_back(static_cast<Id>(points.size()));
      stream.insert(stream.end(), points.begin(), points.end());
    });
    part.layer.push_back(static_cast<unsigned char>(cells_.layers() + 1 - end));
    part.face.push_back(f);
    part.tapers.push_back(wall_.tapers(f));
    part.isFilm.push_back(
      wall_.isFlatFace(f) && wall_.asked[f] < FilmByWidth * std::sqrt(wall_.area(f)));
    part.below.push_back(wall_.of.faces[f].cell);
  }

  const LayeredWall& wall_;
  const LayerHeights& heights_;
  const std::vector<std::uint8_t>& isWanted_;
  const StackCells cells_;
  const Columns columns_;
  const StackSides sides_;
};

class BoundaryLister
{
public:
  BoundaryLister(const OutputMesh& mesh, const LayeredWall& wall, const LayerHeights& heights,
    const std::vector<double>& lastByCell, Execution& execution)
    : mesh_(mesh)
    , wall_(wall)
    , heights_(heights)
    , cells_(wall, heights, execution)
    , columns_(mesh, wall, cells_)
    , sides_(wall, heights, cells_, execution)
    , lastByCell_(lastByCell)
  {
  }

  LayeredBoundary run()
  {
    keepWithoutStacks();
    Id cell = mesh_.cellCount();
    for (std::size_t f = 0; f < wall_.layered.size(); ++f)
    {
      for (std::size_t k = 0; k < cells_.cells(f); ++k)
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
    measure.layers = static_cast<int>(cells_.cells(f));
    measure.end = wall_.endOn(f);
    if (measure.layers > 0)
    {
      measure.thickness = wall_.thickness(f);
      const double first = wall_.heightOn(
        f, [&](std::size_t n) { return heights_.at(wall_.parts[n], 1, wall_.isFlat[n]); });
      const double asked = measure.asked * heights_.at(1, 1, true);
      measure.lastByCell = lastByCell_[f];
      measure.keepsFirst = cells_.hasRegular(f) && std::abs(first - asked) <= FirstWithin * asked;
      measure.isWhole = measure.keepsFirst && cells_.isWhole(f);
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
    const bool isAtWall = cells_.end(f, k) == cells_.layers();
    if (isAtWall && wall_.of.isInterface(f))
    {
      addInterface(f, cell);
    }
    else if (isAtWall)
    {
      const BoundaryFace& base = wall_.of.faces[f];
      add({ cell, base.index, base.boundary, BoundaryFace::Kind::Cut },
        pointsOf(f, cells_.layers()), measureOf(f));
    }
    forEachSide(wall_, cells_, columns_, sides_, f, k, points_, [&](std::size_t i) {
      const std::size_t other = wall_.faceBeyond(f, i);
      if (!wall_.layered[other])
      {
        const BoundaryFace& there = wall_.of.faces[other];
        add({ cell, there.index, there.boundary, BoundaryFace::Kind::Cut }, points_, {});
      }
    });
  }

  const OutputMesh& mesh_;
  const LayeredWall& wall_;
  const LayerHeights& heights_;
  const StackCells cells_;
  const Columns columns_;
  const StackSides sides_;
  const std::vector<double>& lastByCell_;
  std::vector<Id> points_; // scratch
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

void appendCells(PrismStacks& stacks, const PrismStacks& more)
{
  const Id corners = static_cast<Id>(stacks.connectivity.size());
  const Id stream = static_cast<Id>(stacks.faceStream.size());
  stacks.offsets.pop_back(); // the end
  const auto add = [](auto& to, const auto& from, Id by) {
    std::transform(
      from.begin(), from.end(), std::back_inserter(to), [&](Id value) { return value + by; });
  };
  add(stacks.offsets, more.offsets, corners);
  add(stacks.faceStart, more.faceStart, stream);
  const auto append = [](auto& to, const auto& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  append(stacks.connectivity, more.connectivity);
  append(stacks.faceStream, more.faceStream);
  append(stacks.layer, more.layer);
  append(stacks.face, more.face);
  append(stacks.tapers, more.tapers);
  append(stacks.isFilm, more.isFilm);
  append(stacks.below, more.below);
}

PrismStacks stackPrisms(const OutputMesh& mesh, const LayeredWall& wall,
  const LayerHeights& heights, const std::vector<std::uint8_t>& isWanted, Execution& execution)
{
  return Stacker(mesh, wall, heights, isWanted, execution).run(execution);
}

LayeredBoundary boundaryOf(const OutputMesh& mesh, const LayeredWall& wall,
  const LayerHeights& heights, const std::vector<double>& lastByCell, Execution& execution)
{
  return BoundaryLister(mesh, wall, heights, lastByCell, execution).run();
}

}
