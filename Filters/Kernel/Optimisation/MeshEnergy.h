// SPDX-License-Identifier: BSD-3-Clause
// The objective (FaceEnergy.h) of a node mesh's faces and cells for its current nodes, and its derivatives by the places
// of nodes.
#pragma once

#include "Acceptance/FaceEnergy.h"
#include "Optimisation/FaceEdits.h"
#include "Optimisation/LayerPrisms.h"

namespace cartesian
{

class MeshEnergy
{
public:
  // Of each face: `edges`: of the smaller of its boxes, borrowed; `isMoving`: 1 if it has a corner that moves. Gives the
  // mesh's changing cells their measures.
  MeshEnergy(NodeMesh& mesh, const LayerPrisms& prisms, const std::vector<double>& edges,
    std::vector<std::uint8_t> isMoving);

  // For the current nodes: measures, objectives, and their derivatives by measures.
  void evaluate();

  // Some faces alone.
  void measure(const std::vector<std::uint32_t>& faces);

  // Measures of faces and the cells beside them, and the objectives of all faces of these; returns the sum. Where that is
  // more than `most`, not all are looked at.
  double evaluate(const Surroundings& around, double most);

  // The same sum, of what was evaluated last.
  double known(const Surroundings& around) const;

  // The derivative of that sum by the place of a node, and of the prism on it.
  Vector derivative(const Surroundings& around, std::uint32_t node);

  // What evaluate() changes, to be put back.
  struct Kept
  {
    std::vector<FaceGeometry> faces;
    std::vector<double> stars;
    std::vector<CellGeometry> cells;
    std::vector<FaceEnergy> energies;
  };
  void keep(const Surroundings& around, Kept& kept) const;
  void putBack(const Surroundings& around, const Kept& kept);

  // From now on a face costs ten times as much beyond `fair`, and beyond its FaceEnergy::limits in `limits`.
  void keepLimits(const std::vector<FaceEnergy>& limits, double fair);

  // From now on a face is folded if its star is worse than now, and bad.
  void keepStars() { faces_.leastStars = faces_.stars; }

  // Of faces; the objective of a cell is the sum of its faces' and the cost of its own size.
  const std::vector<FaceEnergy>& ofFaces() const { return faces_.energies; }
  double ofCell(std::uint32_t c) const
  {
    return c < cells_.energies.size() ? cells_.energies[c] : 0;
  }

  const FaceGeometry& measures(std::size_t f) const { return faces_.measures[f]; }
  double star(std::size_t f) const
  {
    return faces_.stars[f];
  } // its smallest triangle, by the mean one

  bool isMoving(std::size_t f) const { return isMoving_[f] != 0; }
  bool isFolded(std::size_t f) const;

  // Passes the derivatives by measures of cells on to those of their faces: once after each evaluation.
  void differentiate();

  // Calls add(i, derivative) for the corners of a face.
  template <class Add>
  void forEachDerivative(std::size_t f, Add&& add) const;

private:
  const Vector& corner(std::size_t f, std::size_t i) const
  {
    return m_.nodes.at[m_.faces.corners[m_.faces.start[f] + i]];
  }

  void measureFace(std::size_t f);
  CellGeometry measureOf(std::uint32_t c) const;
  double energyOfSize(std::uint32_t c) const;
  void differentiateSize(std::uint32_t c);
  double sizesOf(const std::vector<std::uint32_t>& cells) const;
  double costOfWorse(std::size_t f) const;
  void evaluateFace(std::size_t f, bool differentiates);
  FaceEnergy energyOfWall(std::size_t f, const Ring& ring, bool differentiates);
  void passOn(std::uint32_t c);

  struct OfFaces
  {
    std::vector<FaceGeometry> measures;
    std::vector<double> stars;      // smallest triangles of stars
    std::vector<double> leastStars; // ... before
    std::vector<double> mostLimits; // beyond which they cost more
    std::vector<FaceEnergy> energies;
    std::vector<FaceGradient> derivatives;
  };

  struct OfCells
  {
    std::vector<CellGradient> derivatives;
    std::vector<double> energies;
  };

  NodeMesh& m_;
  const LayerPrisms& prisms_;
  const std::vector<std::uint8_t> isMoving_;
  const std::vector<double>& edges_;
  OfFaces faces_;
  OfCells cells_;
  std::vector<Vector> triangles_; // areas, of a face's star
};

// By the triangles of its star.
template <class Add>
void MeshEnergy::forEachDerivative(std::size_t f, Add&& add) const
{
  const FaceGeometry& face = faces_.measures[f];
  const Vector normal = unit(face.area);
  const double size = std::max(norm(face.area), Tiny);
  const std::size_t count = m_.faces.sizeOf(f);
  Vector ofMean{};
  Vector mean{};
  for (std::size_t i = 0; i < count; ++i)
  {
    mean = plus(mean, corner(f, i));
  }
  mean = scaled(mean, 1.0 / static_cast<double>(count));
  const FaceGradient& own = faces_.derivatives[f];
  const Vector fromCentre = minus(mean, face.centre);
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t k = i + 1 < count ? i + 1 : 0;
    const Vector p = minus(corner(f, i), mean);
    const Vector q = minus(corner(f, k), mean);
    const double area = dot(cross(p, q), normal) / 2;
    const Vector shift = scaled(own.centre, area / (3 * size));
    const Vector offset = plus(scaled(plus(p, q), 1.0 / 3), fromCentre);
    const Vector byArea =
      scaled(plus(own.area, scaled(normal, dot(offset, own.centre) / size)), 0.5);
    const Vector ofP = cross(q, byArea);
    const Vector ofQ = cross(byArea, p);
    add(i, plus(shift, ofP));
    add(k, plus(shift, ofQ));
    ofMean = plus(ofMean, minus(shift, plus(ofP, ofQ)));
  }
  ofMean = scaled(ofMean, 1.0 / static_cast<double>(count));
  for (std::size_t i = 0; i < count; ++i)
  {
    add(i, ofMean);
  }
}

}
