// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/LayerRegion.h"

namespace cartesian
{

namespace
{

constexpr std::int32_t NoRegion = 0;
constexpr std::int32_t SeveralRegions = -1;

LayerRegion wholeMesh(const OutputMesh& mesh, Execution& execution)
{
  LayerRegion whole{ FirstRegion, mesh.boundary(), {}, {}, mesh.boundaryMesh(execution), {}, {} };
  for (const BoundaryFace& face : whole.faces)
  {
    whole.boundary.push_back(face.boundary);
  }
  return whole;
}

// The region of each cell: by its place in CellArrays, and by its number.
struct RegionsOfCells
{
  std::vector<int> ofPlace;
  std::vector<int> ofNumber;
};

RegionsOfCells regionsOfCells(const OutputMesh& mesh, Execution& execution)
{
  const auto count = static_cast<std::size_t>(mesh.cellCount());
  RegionsOfCells regions{ std::vector<int>(count), std::vector<int>(count) };
  std::vector<Id> number(count);
  std::vector<int> globalBox(3 * count);
  std::vector<unsigned char> level(3 * count);
  std::vector<double> fraction(count);
  mesh.writeCellData(
    { number.data(), globalBox.data(), level.data(), regions.ofPlace.data(), fraction.data() },
    execution);
  for (std::size_t place = 0; place < count; ++place)
  {
    regions.ofNumber[static_cast<std::size_t>(number[place])] = regions.ofPlace[place];
  }
  return regions;
}

// The region of the cells at each point of the mesh.
std::vector<std::int32_t> regionsOfPoints(const OutputMesh& mesh, const RegionsOfCells& regions)
{
  std::vector<std::int32_t> ofPoint(static_cast<std::size_t>(mesh.pointCount()), NoRegion);
  mesh.forEachCell([&](const CellOfMesh& cell) {
    const std::int32_t region = regions.ofPlace[cell.place];
    mesh.forEachPoint(cell, [&](Id p) {
      std::int32_t& known = ofPoint[static_cast<std::size_t>(p)];
      known = known == NoRegion || known == region ? region : SeveralRegions;
    });
  });
  return ofPoint;
}

BoundaryFace seenFromInFront(BoundaryFace face, Id cell)
{
  using Kind = BoundaryFace::Kind;
  face.cell = cell;
  face.kind = face.kind == Kind::Shaped ? Kind::TurnedShaped : Kind::TurnedCut;
  return face;
}

class RegionFinder
{
public:
  RegionFinder(const OutputMesh& mesh, const Walls& walls, Execution& execution)
    : mesh_(mesh)
    , walls_(walls)
    , regions_(regionsOfCells(mesh, execution))
    , ofPoint_(regionsOfPoints(mesh, regions_))
    , execution_(execution)
  {
  }

  LayerRegion find(std::int32_t region) const
  {
    LayerRegion found{ region, {}, {}, {}, {}, {}, {} };
    for (const BoundaryFace& face : mesh_.boundary())
    {
      if (regions_.ofNumber[static_cast<std::size_t>(face.cell)] == region)
      {
        found.faces.push_back(face);
        found.boundary.push_back(face.boundary);
      }
    }
    for (std::size_t i = 0; i < mesh_.interfaces().size(); ++i)
    {
      addInterface(i, found);
    }
    found.mesh = mesh_.meshOf(found.faces, execution_);
    for (const Id p : found.mesh.meshPoint)
    {
      found.isShared.push_back(ofPoint_[static_cast<std::size_t>(p)] == SeveralRegions);
    }
    for (const int other : regions_.ofPlace)
    {
      found.isElsewhere.push_back(other != region);
    }
    return found;
  }

private:
  void addInterface(std::size_t i, LayerRegion& found) const
  {
    const BoundaryFace& face = mesh_.interfaces()[i];
    const Wall& wall = walls_.all[static_cast<std::size_t>(face.boundary)];
    if (wall.behind == found.region || wall.front == found.region)
    {
      const bool isBehind = wall.behind == found.region;
      found.faces.push_back(
        isBehind ? face : seenFromInFront(face, mesh_.inFrontOfInterfaces()[i]));
      found.boundary.push_back(isBehind ? wall.boundary : wall.boundaryInFront);
      found.ofInterface.push_back(i);
    }
  }

  const OutputMesh& mesh_;
  const Walls& walls_;
  const RegionsOfCells regions_;
  const std::vector<std::int32_t> ofPoint_;
  Execution& execution_;
};

}

std::vector<LayerRegion> layerRegions(
  const OutputMesh& mesh, const Walls& walls, Execution& execution)
{
  std::vector<LayerRegion> found;
  if (!walls.any())
  {
    found.push_back(wholeMesh(mesh, execution));
    return found;
  }
  std::int32_t last = FirstRegion;
  for (const Wall& wall : walls.all)
  {
    last = std::max({ last, wall.behind, wall.front });
  }
  const RegionFinder finder(mesh, walls, execution);
  for (std::int32_t region = FirstRegion; region <= last; ++region)
  {
    found.push_back(finder.find(region));
  }
  return found;
}

}
