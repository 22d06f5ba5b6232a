// Single cells to measure, for the tests.
#pragma once

#include "Acceptance/CellFaults.h"

namespace cartesian
{

inline Polyhedron cellOf(const std::vector<Vector>& nodes,
  const std::vector<std::vector<std::uint32_t>>& faces, bool boundary)
{
  Polyhedron cell;
  for (const Vector& node : nodes)
  {
    cell.nodes.push_back(node);
  }
  for (const std::vector<std::uint32_t>& face : faces)
  {
    for (const std::uint32_t node : face)
    {
      cell.addCorner(node);
    }
    cell.closeFace(boundary);
  }
  return cell;
}

// From z = `low` to `high`, over a rectangle from the origin that is `shift` further on along x at the top. Its faces: low
// z, high z, low y, high x, high y, low x.
inline Polyhedron shearedBox(
  double x, double y, double low, double high, double shift, bool boundary)
{
  return cellOf({ { 0, 0, low }, { x, 0, low }, { x, y, low }, { 0, y, low }, { shift, 0, high },
                  { x + shift, 0, high }, { x + shift, y, high }, { shift, y, high } },
    { { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 },
      { 3, 0, 4, 7 } },
    boundary);
}

inline Polyhedron boxOf(double x, double y, double z, bool boundary)
{
  return shearedBox(x, y, 0, z, 0, boundary);
}

inline CellShape shapeOf(const Polyhedron& cell)
{
  CellShape shape;
  measure(cell, shape);
  return shape;
}

inline NeighbourCell asNeighbour(const Polyhedron& cell)
{
  const CellShape shape = shapeOf(cell);
  return { shape.centre, shape.volume };
}

// Of equal cubes on all sides.
inline std::vector<NeighbourCell> cubesAround(double edge)
{
  const double half = edge / 2;
  std::vector<NeighbourCell> beyond;
  for (const Vector& way : std::vector<Vector>{
         { 0, 0, -1 }, { 0, 0, 1 }, { 0, -1, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 } })
  {
    beyond.push_back({ plus({ half, half, half }, scaled(way, edge)), edge * edge * edge });
  }
  return beyond;
}

}
