// SPDX-License-Identifier: BSD-3-Clause
#include "Optimisation/MeshEnergy.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// The smallest triangle of a face's star, relative to the mean one, unless it was smaller.
constexpr double LeastOfStar = 0.02;

constexpr double OfFoldedFace = 1e9;

// What limits beyond those that were kept cost besides.
constexpr double CostOfWorse = 10;

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
    energyOfCell_[c] += energyOfSize(c);
  }
}

double MeshEnergy::energyOfSize(std::uint32_t c)
{
  double byShare = 0;
  const double energy =
    energyOfShare(m_.cells.measures[c].volume / m_.cells.volumeOfBox[c], byShare);
  byCells_[c].volume += byShare / m_.cells.volumeOfBox[c];
  return energy;
}

void MeshEnergy::measure(const std::vector<std::uint32_t>& faces)
{
  for (const std::uint32_t f : faces)
  {
    measureFace(f);
  }
}

void MeshEnergy::keepLimits(const std::vector<FaceEnergy>& limits, double fair)
{
  for (std::size_t f = 0; f < limits.size(); ++f)
  {
    mostLimits_.push_back(std::max(fair, limits[f].limits));
    energies_[f].all += costOfWorse(f);
  }
}

double MeshEnergy::costOfWorse(std::size_t f) const
{
  return mostLimits_.empty() ? 0
                             : CostOfWorse * std::max(0.0, energies_[f].limits - mostLimits_[f]);
}

double MeshEnergy::known(const Surroundings& around)
{
  double sum = 0;
  for (const std::uint32_t c : around.cells)
  {
    sum += c < prisms_.firstCell ? energyOfSize(c) : 0;
  }
  for (const std::uint32_t f : around.facesOfCells)
  {
    sum += energies_[f].all;
  }
  return sum;
}

double MeshEnergy::evaluate(const Surroundings& around, double most)
{
  measure(around.faces);
  for (const std::uint32_t c : around.cells)
  {
    m_.cells.measures[c] = measureOf(c);
    byCells_[c] = {};
  }
  double sum = 0;
  for (const std::uint32_t c : around.cells)
  {
    sum += c < prisms_.firstCell ? energyOfSize(c) : 0;
  }
  for (std::size_t i = 0; i < around.facesOfCells.size() && sum <= most; ++i)
  {
    const std::uint32_t f = around.facesOfCells[i];
    byFaces_[f] = {};
    evaluateFace(f);
    sum += energies_[f].all;
  }
  return sum;
}

Vector MeshEnergy::derivative(const Surroundings& around, std::uint32_t node)
{
  for (const std::uint32_t c : around.cells)
  {
    passOn(c);
  }
  Vector sum{};
  for (const std::uint32_t f : around.faces)
  {
    forEachDerivative(f, [&](std::size_t i, const Vector& derivative) {
      const std::uint32_t corner = m_.faces.corners[m_.faces.start[f] + i];
      const bool follows = corner >= prisms_.firstNode;
      if ((follows ? prisms_.below[corner - prisms_.firstNode] : corner) == node)
      {
        sum = plus(sum, derivative);
      }
    });
  }
  return sum;
}

void MeshEnergy::keep(const Surroundings& around, Kept& kept) const
{
  kept.faces.clear();
  kept.stars.clear();
  kept.cells.clear();
  kept.energies.clear();
  for (const std::uint32_t f : around.faces)
  {
    kept.faces.push_back(faces_[f]);
    kept.stars.push_back(stars_[f]);
  }
  for (const std::uint32_t c : around.cells)
  {
    kept.cells.push_back(m_.cells.measures[c]);
  }
  for (const std::uint32_t f : around.facesOfCells)
  {
    kept.energies.push_back(energies_[f]);
  }
}

void MeshEnergy::putBack(const Surroundings& around, const Kept& kept)
{
  for (std::size_t i = 0; i < around.faces.size(); ++i)
  {
    faces_[around.faces[i]] = kept.faces[i];
    stars_[around.faces[i]] = kept.stars[i];
  }
  for (std::size_t i = 0; i < around.cells.size(); ++i)
  {
    m_.cells.measures[around.cells[i]] = kept.cells[i];
  }
  for (std::size_t i = 0; i < around.facesOfCells.size(); ++i)
  {
    energies_[around.facesOfCells[i]] = kept.energies[i];
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
  return measureCell(m_.cells.endUse[c] - m_.cells.firstUse[c], [&](std::size_t i) {
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
  energies_[f].all += costOfWorse(f) + (isFolded(f) ? OfFoldedFace : 0);
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
  const std::size_t size = m_.cells.endUse[c] - m_.cells.firstUse[c];
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
