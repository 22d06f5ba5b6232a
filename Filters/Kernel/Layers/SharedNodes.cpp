// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/SharedNodes.h"

#include <algorithm>
#include <numeric>

namespace cartesian
{

namespace
{

// Calls visit(point) for all points of the faces in a stream of cells.
template <class Visitor>
void forEachPoint(std::vector<Id>& faceStream, Visitor&& visit)
{
  for (auto at = faceStream.begin(); at != faceStream.end();)
  {
    for (Id faces = *at++; faces > 0; --faces)
    {
      const Id size = *at++;
      std::for_each(at, at + size, visit);
      at += size;
    }
  }
}

// The corners of faces as the mesh's points.
std::vector<Id> pointsOfCorners(const BoundaryMesh& faces)
{
  std::vector<Id> points;
  for (const Id corner : faces.corners)
  {
    points.push_back(faces.meshPoint[static_cast<std::size_t>(corner)]);
  }
  return points;
}

// By number from `first` on, after `added` others.
void shift(Id& number, Id first, Id added)
{
  number += number >= first ? added : 0;
}

}

std::vector<PointCopy> shareNodes(
  const OutputMesh& mesh, const LayeredWall& wall, PrismStacks& stacks, LayeredBoundary& boundary)
{
  std::vector<PointCopy> copies;
  if (wall.of.isShared.empty())
  {
    return copies;
  }
  const Id first = mesh.pointCount();
  std::vector<Id> top(wall.nodes(), -1); // a column's last point
  for (std::size_t i = 0; i < stacks.nodeOfPoint.size(); ++i)
  {
    top[stacks.nodeOfPoint[i]] = first + static_cast<Id>(i);
  }
  std::vector<Id> renamed(static_cast<std::size_t>(first) + stacks.nodeOfPoint.size());
  std::iota(renamed.begin(), renamed.end(), Id(0));
  for (std::size_t n = 0; n < wall.nodes(); ++n)
  {
    if (wall.of.isShared[n] && top[n] >= 0)
    {
      const Id point = wall.of.mesh.meshPoint[n];
      std::swap(
        renamed[static_cast<std::size_t>(point)], renamed[static_cast<std::size_t>(top[n])]);
      copies.push_back({ wall.of.region, point, top[n] });
      const Vector below = wall.at(n, wall.parts[n]);
      std::copy(below.begin(), below.end(), stacks.points.begin() + 3 * (top[n] - first));
    }
  }
  const auto rename = [&](Id& point) { point = renamed[static_cast<std::size_t>(point)]; };
  forEachPoint(stacks.faceStream, rename);
  std::for_each(stacks.connectivity.begin(), stacks.connectivity.end(), rename);
  std::for_each(boundary.mesh.meshPoint.begin(), boundary.mesh.meshPoint.end(), rename);
  boundary.mesh.corners = pointsOfCorners(boundary.mesh);
  numberPoints(boundary.mesh);
  stacks.moved.erase(std::remove_if(stacks.moved.begin(), stacks.moved.end(),
                       [&](const MovedPoint& moved) {
                         return renamed[static_cast<std::size_t>(moved.point)] != moved.point;
                       }),
    stacks.moved.end());
  return copies;
}

void append(const OutputMesh& mesh, PrismStacks& stacks, const PrismStacks& more)
{
  const Id points = static_cast<Id>(stacks.nodeOfPoint.size());
  const auto shiftPoint = [&](Id& point) { shift(point, mesh.pointCount(), points); };
  PrismStacks next = more;
  forEachPoint(next.faceStream, shiftPoint);
  std::for_each(next.connectivity.begin(), next.connectivity.end(), shiftPoint);
  const auto add = [](
                     auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  add(stacks.moved, next.moved);
  add(stacks.points, next.points);
  add(stacks.nodeOfPoint, next.nodeOfPoint);
  appendCells(stacks, next);
}

void append(const OutputMesh& mesh, const PrismStacks& before, LayeredBoundary& boundary,
  const LayeredBoundary& more)
{
  const Id points = static_cast<Id>(before.nodeOfPoint.size());
  const Id cells = static_cast<Id>(before.cells());
  std::vector<Id> corners = pointsOfCorners(boundary.mesh);
  boundary.mesh.start.pop_back(); // the end
  for (const Id start : more.mesh.start)
  {
    boundary.mesh.start.push_back(static_cast<Id>(boundary.mesh.corners.size()) + start);
  }
  for (Id point : pointsOfCorners(more.mesh))
  {
    shift(point, mesh.pointCount(), points);
    corners.push_back(point);
  }
  boundary.mesh.corners = std::move(corners);
  numberPoints(boundary.mesh);
  for (BoundaryFace face : more.faces)
  {
    shift(face.cell, mesh.cellCount(), cells);
    boundary.faces.push_back(face);
  }
  for (LayeredInterface face : more.interfaces)
  {
    shift(face.cell, mesh.cellCount(), cells);
    boundary.interfaces.push_back(face);
  }
  boundary.stacks.insert(boundary.stacks.end(), more.stacks.begin(), more.stacks.end());
}

}
