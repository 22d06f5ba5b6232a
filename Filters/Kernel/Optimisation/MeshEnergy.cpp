// SPDX-License-Identifier: BSD-3-Clause
#include "Optimisation/MeshEnergy.h"

#include <algorithm>
#include <numeric>

namespace cartesian
{

namespace
{

// The smallest triangle of a face's star, relative to the mean one, unless it was smaller.
constexpr double LeastOfStar = 0.02;

constexpr double OfFoldedFace = 1e9;

// Extra cost of violating limits that were met before.
constexpr double CostOfWorse = 10;

}

MeshEnergy::MeshEnergy(NodeMesh& mesh, const LayerPrisms& prisms, const std::vector<double>& edges,
  std::vector<std::uint8_t> isMoving)
  : m_(mesh)
  , prisms_(prisms)
  , isMoving_(std::move(isMoving))
  , edges_(edges)
{
  faces_.measures.resize(mesh.faces.size());
  faces_.stars.resize(mesh.faces.size());
  faces_.energies.resize(mesh.faces.size());
  faces_.derivatives.resize(mesh.faces.size());
  cells_.derivatives.resize(mesh.cells.measures.size());
  cells_.energies.resize(mesh.cells.changing);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    if (!isMoving_[f])
    {
      measureFace(f);
    }
  }
}

// --- of all

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
  std::fill(faces_.derivatives.begin(), faces_.derivatives.end(), FaceGradient{});
  std::fill(cells_.derivatives.begin(), cells_.derivatives.end(), CellGradient{});
  std::fill(cells_.energies.begin(), cells_.energies.end(), 0);
  for (std::size_t f = 0; f < m_.faces.size(); ++f)
  {
    evaluateFace(f, true);
    for (const std::uint32_t c : m_.faces.cells[f])
    {
      if (c < m_.cells.changing)
      {
        cells_.energies[c] += faces_.energies[f].all;
      }
    }
  }
  for (std::uint32_t c = 0; c < prisms_.firstCell; ++c)
  {
    cells_.energies[c] += energyOfSize(c);
    differentiateSize(c);
  }
}

void MeshEnergy::differentiate()
{
  for (std::uint32_t c = 0; c < m_.cells.changing; ++c)
  {
    passOn(c);
  }
}

void MeshEnergy::keepLimits(const std::vector<FaceEnergy>& limits, double fair)
{
  for (std::size_t f = 0; f < limits.size(); ++f)
  {
    faces_.mostLimits.push_back(std::max(fair, limits[f].limits));
    faces_.energies[f].all += costOfWorse(f);
  }
}

// --- of some

void MeshEnergy::measure(const std::vector<std::uint32_t>& faces)
{
  for (const std::uint32_t f : faces)
  {
    measureFace(f);
  }
}

double MeshEnergy::sizesOf(const std::vector<std::uint32_t>& cells) const
{
  return std::accumulate(cells.begin(), cells.end(), 0.0,
    [&](double sum, std::uint32_t c) { return sum + energyOfSize(c); });
}

double MeshEnergy::known(const Surroundings& around) const
{
  return std::accumulate(around.facesOfCells.begin(), around.facesOfCells.end(),
    sizesOf(around.cells),
    [&](double sum, std::uint32_t f) { return sum + faces_.energies[f].all; });
}

double MeshEnergy::evaluate(const Surroundings& around, double most)
{
  measure(around.faces);
  for (const std::uint32_t c : around.cells)
  {
    m_.cells.measures[c] = measureOf(c);
  }
  double sum = sizesOf(around.cells);
  for (std::size_t i = 0; i < around.facesOfCells.size() && sum <= most; ++i)
  {
    const std::uint32_t f = around.facesOfCells[i];
    evaluateFace(f, false);
    sum += faces_.energies[f].all;
  }
  return sum;
}

Vector MeshEnergy::derivative(const Surroundings& around, std::uint32_t node)
{
  for (const std::uint32_t f : around.facesOfCells)
  {
    faces_.derivatives[f] = {};
  }
  for (const std::uint32_t c : around.cells)
  {
    cells_.derivatives[c] = {};
    differentiateSize(c);
  }
  for (const std::uint32_t f : around.facesOfCells)
  {
    evaluateFace(f, true);
  }
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
    kept.faces.push_back(faces_.measures[f]);
    kept.stars.push_back(faces_.stars[f]);
  }
  for (const std::uint32_t c : around.cells)
  {
    kept.cells.push_back(m_.cells.measures[c]);
  }
  for (const std::uint32_t f : around.facesOfCells)
  {
    kept.energies.push_back(faces_.energies[f]);
  }
}

void MeshEnergy::putBack(const Surroundings& around, const Kept& kept)
{
  for (std::size_t i = 0; i < around.faces.size(); ++i)
  {
    faces_.measures[around.faces[i]] = kept.faces[i];
    faces_.stars[around.faces[i]] = kept.stars[i];
  }
  for (std::size_t i = 0; i < around.cells.size(); ++i)
  {
    m_.cells.measures[around.cells[i]] = kept.cells[i];
  }
  for (std::size_t i = 0; i < around.facesOfCells.size(); ++i)
  {
    faces_.energies[around.facesOfCells[i]] = kept.energies[i];
  }
}

// --- of one

void MeshEnergy::measureFace(std::size_t f)
{
  triangles_.clear();
  faces_.measures[f] = cartesian::measureFace(
    m_.faces.sizeOf(f), [&](std::size_t i) -> const Vector& { return corner(f, i); },
    [&](const Vector& area) { triangles_.push_back(area); });
  StarShare share;
  for (const Vector& triangle : triangles_)
  {
    share.add(dot(triangle, faces_.measures[f].area));
  }
  faces_.stars[f] = share.smallest(m_.faces.sizeOf(f), faces_.measures[f].area);
}

CellGeometry MeshEnergy::measureOf(std::uint32_t c) const
{
  const std::uint32_t* const begin = m_.cells.uses.data() + m_.cells.firstUse[c];
  return measureCell(m_.cells.endUse[c] - m_.cells.firstUse[c], [&](std::size_t i) {
    FaceGeometry face = faces_.measures[begin[i]];
    face.area = m_.faces.cells[begin[i]][0] == c ? face.area : scaled(face.area, -1);
    return face;
  });
}

void MeshEnergy::evaluateFace(std::size_t f, bool differentiates)
{
  if (!prisms_.counts[f])
  {
    return;
  }
  const auto& [below, above] = m_.faces.cells[f];
  const Ring ring{ m_.nodes.at.data(), m_.faces.corners.data() + m_.faces.start[f],
    m_.faces.sizeOf(f) };
  const Gradients gradients{ &faces_.derivatives[f], &cells_.derivatives[below],
    above == None ? nullptr : &cells_.derivatives[above] };
  FaceEnergy& energy = faces_.energies[f];
  energy = m_.isWall(f)
    ? energyOfWall(f, ring, differentiates)
    : energyOfInnerFace(faces_.measures[f], ring, edges_[f], m_.cells.measures[below],
        m_.cells.measures[above], differentiates ? &gradients : nullptr);
  energy.all += costOfWorse(f) + (isFolded(f) ? OfFoldedFace : 0);
}

// Between two regions it is a boundary face for the solvers of both.
FaceEnergy MeshEnergy::energyOfWall(std::size_t f, const Ring& ring, bool differentiates)
{
  const auto& [below, above] = m_.faces.cells[f];
  const auto energyFrom = [&](std::uint32_t c, const FaceGeometry& face, FaceGradient& ofFace) {
    const Gradients gradients{ &ofFace, &cells_.derivatives[c], nullptr };
    return energyOfBoundaryFace(
      face, ring, edges_[f], m_.cells.measures[c], differentiates ? &gradients : nullptr);
  };
  FaceEnergy energy = energyFrom(below, faces_.measures[f], faces_.derivatives[f]);
  if (above != None)
  {
    FaceGeometry turned = faces_.measures[f];
    turned.area = scaled(turned.area, -1);
    FaceGradient ofTurned;
    const FaceEnergy other = energyFrom(above, turned, ofTurned);
    energy.limits += other.limits;
    energy.all += other.all;
    FaceGradient& ofFace = faces_.derivatives[f];
    ofFace.centre = plus(ofFace.centre, ofTurned.centre);
    ofFace.area = minus(ofFace.area, ofTurned.area);
  }
  return energy;
}

double MeshEnergy::energyOfSize(std::uint32_t c) const
{
  return c < prisms_.firstCell
    ? energyOfShare(m_.cells.measures[c].volume / m_.cells.volumeOfBox[c])
    : 0;
}

void MeshEnergy::differentiateSize(std::uint32_t c)
{
  if (c < prisms_.firstCell)
  {
    cells_.derivatives[c].volume +=
      derivativeOfShare(m_.cells.measures[c].volume / m_.cells.volumeOfBox[c]) /
      m_.cells.volumeOfBox[c];
  }
}

double MeshEnergy::costOfWorse(std::size_t f) const
{
  return faces_.mostLimits.empty()
    ? 0
    : CostOfWorse * std::max(0.0, faces_.energies[f].limits - faces_.mostLimits[f]);
}

bool MeshEnergy::isFolded(std::size_t f) const
{
  return isMoving_[f] && !faces_.leastStars.empty() &&
    faces_.stars[f] < std::min(LeastOfStar, faces_.leastStars[f]);
}

// From a cell to its faces: its centre is that of the pyramids over the faces, around the mean of their centres.
void MeshEnergy::passOn(std::uint32_t c)
{
  const std::uint32_t* const begin = m_.cells.uses.data() + m_.cells.firstUse[c];
  const std::size_t size = m_.cells.endUse[c] - m_.cells.firstUse[c];
  Vector mean{};
  for (std::size_t i = 0; i < size; ++i)
  {
    mean = plus(mean, faces_.measures[begin[i]].centre);
  }
  mean = scaled(mean, 1.0 / static_cast<double>(size));
  const double volume = std::max(m_.cells.measures[c].volume, Tiny);
  const Vector centre = minus(m_.cells.measures[c].centre, mean);
  const CellGradient& own = cells_.derivatives[c];
  for (std::size_t i = 0; i < size; ++i)
  {
    const std::uint32_t f = begin[i];
    const double sign = m_.faces.cells[f][0] == c ? 1 : -1;
    const Vector height = minus(faces_.measures[f].centre, mean);
    const double pyramid = sign * dot(height, faces_.measures[f].area) / 3;
    const double byPyramid =
      dot(minus(scaled(height, 0.75), centre), own.centre) / volume + own.volume;
    faces_.derivatives[f].centre = plus(faces_.derivatives[f].centre,
      plus(scaled(own.centre, 0.75 * pyramid / volume),
        scaled(faces_.measures[f].area, sign * byPyramid / 3)));
    faces_.derivatives[f].area =
      plus(faces_.derivatives[f].area, scaled(height, sign * byPyramid / 3));
  }
}

}
