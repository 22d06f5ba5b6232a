// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/Refusals.h"

#include "Quality/CellMeasures.h"
#include "Quality/Limits.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

// Volumes that differ by less, by their sum, are the same.
constexpr double SameVolume = 1e-9;

bool isFacingAway(const MeshView& mesh, std::uint32_t f)
{
  const EditFace& face = mesh.face(f);
  return !mesh.isSurface(f) &&
    !(dot(face.area, minus(mesh.cell(face.above).centre, mesh.cell(face.below).centre)) > 0);
}

// As seen from one of its cells.
bool isInvertedAlone(const MeshView& mesh, std::uint32_t f, std::uint32_t c)
{
  const double out = pyramidVolume(mesh.face(f), mesh.cell(c).centre);
  return !((mesh.face(f).below == c ? out : -out) > 0);
}

// Whether a cell that shares a node is no part of a film, as those of a body are that is thin everywhere.
bool hasLargeNear(const MeshView& mesh, std::uint32_t c)
{
  constexpr double Large = 0.15; // of its box
  bool isAny = false;
  mesh.forEachCellAround(c, [&](std::uint32_t other) {
    isAny = isAny ||
      (mesh.cell(other).region == mesh.cell(c).region &&
        mesh.cell(other).volume >= Large * mesh.cell(other).boxVolume);
  });
  return isAny;
}

// By checkMesh's aspect ratio. Not cells of films where all is as thin, unless there is nothing between their walls.
bool isLong(const MeshView& mesh, std::uint32_t c)
{
  AreaSums sums;
  for (const std::uint32_t f : mesh.facesOf(c))
  {
    sums.add(mesh.face(f).area);
  }
  return !(sums.aspectRatio(std::abs(mesh.cell(c).volume)) < EditLimits::AspectRatio) &&
    (hasNoVolume(mesh, c) || hasLargeNear(mesh, c));
}

}

bool Refusals::operator<(const Refusals& other) const
{
  if (inverted != other.inverted)
  {
    return inverted < other.inverted;
  }
  if (skew != other.skew)
  {
    return skew < other.skew;
  }
  if (std::abs(volume - other.volume) > SameVolume * (volume + other.volume))
  {
    return volume < other.volume;
  }
  return poor < other.poor;
}

Refusals refusalsOf(const MeshEditor& mesh, const std::vector<std::uint32_t>& cells)
{
  Refusals sum{ mesh.delta.inverted, mesh.delta.skew, 0, mesh.delta.failures };
  for (const std::uint32_t c : cells)
  {
    if (!mesh.cell(c).gone)
    {
      sum.skew += isDegenerate(mesh, c) ? 1 : 0;
      sum.volume += hasInverted(mesh, c) ? mesh.cell(c).volume : 0;
    }
  }
  return sum;
}

bool hasNoVolume(const MeshView& mesh, std::uint32_t c)
{
  constexpr double Most = 1e-4; // of its box: no body is meant that is as thin
  return mesh.cell(c).volume < Most * mesh.cell(c).boxVolume;
}

bool isDegenerate(const MeshView& mesh, std::uint32_t c)
{
  return mesh.facesOf(c).size() < SolverLimits::Faces || isLong(mesh, c);
}

bool isInvertedFrom(const MeshView& mesh, std::uint32_t f, std::uint32_t c)
{
  return mesh.face(f).inverted != 0 && (isInvertedAlone(mesh, f, c) || isFacingAway(mesh, f));
}

bool hasInverted(const MeshView& mesh, std::uint32_t c)
{
  const Items faces = mesh.facesOf(c);
  return std::any_of(
    faces.begin(), faces.end(), [&](std::uint32_t f) { return isInvertedFrom(mesh, f, c); });
}

bool isRefused(const MeshView& mesh, std::uint32_t c)
{
  const Items faces = mesh.facesOf(c);
  return isDegenerate(mesh, c) || std::any_of(faces.begin(), faces.end(), [&](std::uint32_t f) {
    return mesh.face(f).skew || isInvertedFrom(mesh, f, c);
  });
}

Refusals refusalsIn(const MeshView& mesh, std::uint32_t c)
{
  Refusals sum{};
  for (const std::uint32_t f : mesh.facesOf(c))
  {
    sum.inverted += int(isInvertedAlone(mesh, f, c)) + int(isFacingAway(mesh, f));
    sum.skew += mesh.face(f).skew ? 1 : 0;
  }
  sum.skew += isDegenerate(mesh, c) ? 1 : 0;
  return sum;
}

}
