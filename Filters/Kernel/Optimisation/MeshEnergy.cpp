// SPDX-License-Identifier: BSD-3-Clause
#include "Optimisation/MeshEnergy.h"

#include "Base/Sorting.h"

#include <algorithm>
#include <iterator>

namespace cartesian
{

namespace
{

// The smallest triangle of a face's star, relative to the mean one, unless it was smaller.
constexpr double LeastOfStar = 0.02;

constexpr double OfFoldedFace = 1e9;

}

MeshEnergy::MeshEnergy(NodeMesh& mesh, const LayerPrisms& prisms, const std::vector<double>& edges,
  std::vector<std::uint8_t> isMoving)
  : m_(mesh)
  , prisms_(prisms)
  , isMoving_(std::move(isMoving))
  , edges_(edges)
  , faces_(mesh.faces.size())
  , stars_(mesh.faces.size())
  , energies_(mesh.faces.size())
  , byFaces_(mesh.faces.size())
  , byCells_(mesh.cells.measures.size())
  , energyOfCell_(mesh.cells.changing)
{
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    if (!isMoving_[f])
    {
      measureFace(f);
    }
  }
}

void MeshEnergy::evaluate()
{
  for (std::size_t f = 0; f < m_.faces.size(); ++f)
  {
    if (isMoving_[f])
    {
      measureFace(f);
    }
  }
  for (std::uint32_t c = 0; c < m_.cells.changing; ++c)
  {
    m_.cells.measures[c] = measureOf(c);
  }
  std::fill(byFaces_.begin(), byFaces_.end(), FaceGradient{});
  std::fill(byCells_.begin(), byCells_.end(), CellGradient{});
  std::fill(energyOfCell_.begin(), energyOfCell_.end(), 0);
  for (std::size_t f = 0; f < m_.faces.size(); ++f)
  {
    evaluateFace(f);
    for (const std::uint32_t c : m_.faces.cells[f])
    {
      if (c < m_.cells.changing)
      {
        energyOfCell_[c] += energies_[f].all;
      }
    }
  }
  for (std::uint32_t c = 0; c < prisms_.firstCell; ++c)
  {
    double byShare = 0;
    energyOfCell_[c] +=
      energyOfShare(m_.cells.measures[c].volume / m_.cells.volumeOfBox[c], byShare);
    byCells_[c].volume += byShare / m_.cells.volumeOfBox[c];
  }
}

void MeshEnergy::evaluate(const std::vector<std::uint32_t>& faces)
{
  std::vector<std::uint32_t> cells;
  for (const std::uint32_t f : faces)
  {
    measureFace(f);
    std::copy_if(m_.faces.cells[f].begin(), m_.faces.cells[f].end(), std::back_inserter(cells),
      [&](std::uint32_t c) { return c < m_.cells.changing; });
  }
  std::vector<std::uint32_t> around = faces;
  for (const std::uint32_t c : cells = sortedUnique(std::move(cells)))
  {
    m_.cells.measures[c] = measureOf(c);
    around.insert(around.end(), m_.cells.uses.begin() + std::ptrdiff_t(m_.cells.firstUse[c]),
      m_.cells.uses.begin() + std::ptrdiff_t(m_.cells.firstUse[c + 1]));
  }
  for (const std::uint32_t f : sortedUnique(std::move(around)))
  {
    evaluateFace(f);
  }
}

void MeshEnergy::measureFace(std::size_t f)
{
  triangles_.clear();
  faces_[f] = cartesian::measureFace(
    cornersOf(f), [&](std::size_t i) -> const Vector& { return corner(f, i); },
    [&](const Vector& area) { triangles_.push_back(area); });
  StarShare share;
  for (const Vector& triangle : triangles_)
  {
    share.add(dot(triangle, faces_[f].area));
  }
  stars_[f] = share.smallest(cornersOf(f), faces_[f].area);
}

CellGeometry MeshEnergy::measureOf(std::uint32_t c) const
{
  const std::uint32_t* const begin = m_.cells.uses.data() + m_.cells.firstUse[c];
  return measureCell(m_.cells.firstUse[c + 1] - m_.cells.firstUse[c], [&](std::size_t i) {
    FaceGeometry face = faces_[begin[i]];
    face.area = m_.faces.cells[begin[i]][0] == c ? face.area : scaled(face.area, -1);
    return face;
  });
}

void MeshEnergy::evaluateFace(std::size_t f)
{
  if (!prisms_.counts[f])
  {
    return;
  }
  const auto& cells = m_.faces.cells[f];
  const Ring ring{ m_.nodes.at.data(), m_.faces.corners.data() + m_.faces.start[f], cornersOf(f) };
  energies_[f] = m_.isWall(f)
    ? energyOfWall(f, ring)
    : energyOfInnerFace(faces_[f], ring, edges_[f], m_.cells.measures[cells[0]],
        m_.cells.measures[cells[1]], byFaces_[f], byCells_[cells[0]], byCells_[cells[1]]);
  if (isFolded(f))
  {
    energies_[f].all += OfFoldedFace;
  }
}

// Between two regions it is a boundary face for the solvers of both.
FaceEnergy MeshEnergy::energyOfWall(std::size_t f, const Ring& ring)
{
  const auto& cells = m_.faces.cells[f];
  FaceEnergy energy = energyOfBoundaryFace(
    faces_[f], ring, edges_[f], m_.cells.measures[cells[0]], byFaces_[f], byCells_[cells[0]]);
  if (cells[1] != None)
  {
    FaceGeometry turned = faces_[f];
    turned.area = scaled(turned.area, -1);
    FaceGradient ofTurned;
    const FaceEnergy other = energyOfBoundaryFace(
      turned, ring, edges_[f], m_.cells.measures[cells[1]], ofTurned, byCells_[cells[1]]);
    energy.limits += other.limits;
    energy.all += other.all;
    byFaces_[f].centre = plus(byFaces_[f].centre, ofTurned.centre);
    byFaces_[f].area = minus(byFaces_[f].area, ofTurned.area);
  }
  return energy;
}

bool MeshEnergy::isFolded(std::size_t f) const
{
  return isMoving_[f] && !leastStars_.empty() && stars_[f] < std::min(LeastOfStar, leastStars_[f]);
}

void MeshEnergy::differentiate()
{
  for (std::uint32_t c = 0; c < m_.cells.changing; ++c)
  {
    passOn(c);
  }
}

// From a cell to its faces: its centre is that of the pyramids over the faces, around the mean of their centres.
void MeshEnergy::passOn(std::uint32_t c)
{
  const std::uint32_t* const begin = m_.cells.uses.data() + m_.cells.firstUse[c];
  const std::size_t size = m_.cells.firstUse[c + 1] - m_.cells.firstUse[c];
  Vector mean{};
  for (std::size_t i = 0; i < size; ++i)
  {
    mean = plus(mean, faces_[begin[i]].centre);
  }
  mean = scaled(mean, 1.0 / static_cast<double>(size));
  const double volume = std::max(m_.cells.measures[c].volume, Tiny);
  const Vector centre = minus(m_.cells.measures[c].centre, mean);
  const CellGradient& own = byCells_[c];
  for (std::size_t i = 0; i < size; ++i)
  {
    const std::uint32_t f = begin[i];
    const double sign = m_.faces.cells[f][0] == c ? 1 : -1;
    const Vector height = minus(faces_[f].centre, mean);
    const double pyramid = sign * dot(height, faces_[f].area) / 3;
    const double byPyramid =
      dot(minus(scaled(height, 0.75), centre), own.centre) / volume + own.volume;
    byFaces_[f].centre = plus(byFaces_[f].centre,
      plus(
        scaled(own.centre, 0.75 * pyramid / volume), scaled(faces_[f].area, sign * byPyramid / 3)));
    byFaces_[f].area = plus(byFaces_[f].area, scaled(height, sign * byPyramid / 3));
  }
}

}
