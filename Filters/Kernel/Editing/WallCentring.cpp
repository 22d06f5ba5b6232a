// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/WallCentring.h"

#include "Editing/NodeShifts.h"

namespace cartesian
{

namespace
{

constexpr int Steps = 4;
constexpr double Relaxation = 0.7;
constexpr double MostMoved = 0.1; // in boxes, by one step
constexpr double MostCost = 0.2;  // that a face may cost more than before

// From a wall's centre to under that of its cell, along the wall; between two regions, the mean of both.
Vector offCentre(const MeshView& mesh, std::uint32_t f)
{
  const EditFace& face = mesh.face(f);
  const Vector normal = unit(face.area);
  Vector to = minus(mesh.cell(face.below).centre, face.centre);
  if (face.above != None)
  {
    to = scaled(plus(to, minus(mesh.cell(face.above).centre, face.centre)), 0.5);
  }
  return minus(to, scaled(normal, dot(to, normal)));
}

// The mean of its walls', along the wall. 0: it would leave it.
Vector wayOf(const MeshView& mesh, std::uint32_t n)
{
  if (!maySlide(mesh, n))
  {
    return {};
  }
  const EditNode& node = mesh.node(n);
  const Vector normal = normalOfWalls(mesh, n);
  if (!isSmoothAt(mesh, n, normal))
  {
    return {};
  }
  Vector sum{};
  double area = 0;
  for (const std::uint32_t f : mesh.facesAround(n))
  {
    if (isFreeWall(mesh, f))
    {
      const double part = norm(mesh.face(f).area);
      sum = plus(sum, scaled(offCentre(mesh, f), part));
      area += part;
    }
  }
  Vector way = scaled(sum, area > 0 ? Relaxation / area : 0);
  way = minus(way, scaled(normal, dot(way, normal)));
  const double length = norm(way);
  const double most = MostMoved * mesh.edgeAt(n);
  way = length > most ? scaled(way, most / length) : way;
  const double accumulatedDeviation = norm(minus(plus(node.at, way), node.referencePosition));
  return accumulatedDeviation <= double(node.maxDisplacement) ? way : Vector{};
}

}

void centreWalls(EditMesh& whole, const ObjectiveSpec& spec, Execution& execution)
{
  const MeshView mesh(whole);
  for (int step = 0; step < Steps; ++step)
  {
    NodeShifts shifts(whole, spec, MostCost, execution);
    shifts.plan([&](std::uint32_t n) { return wayOf(mesh, n); });
    shifts.make();
  }
}

}
