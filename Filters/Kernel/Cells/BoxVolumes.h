// SPDX-License-Identifier: BSD-3-Clause
// The separated volumes of one polyhedral box (section 6, step B2).
#pragma once

#include "Base/ObjectPool.h"
#include "Cells/BoxFaces.h"
#include "Lattice/Vector.h"

namespace cartesian
{

// A connected set of faces: it closes, hence it bounds a volume or a void in one.
struct Shell
{
  std::vector<std::uint32_t> faces; // of BoxFaces; none if the shell became part of another
  double volume = 0;
  double area = 0; // of all its faces
  bool hasInnerFace = false;

  void clear()
  {
    faces.clear();
    volume = 0;
    area = 0;
    hasInnerFace = false;
  }

  // Whether its volume, of either sign, is mere rounding.
  bool isSliver() const;
};

// Keeps its storage from box to box.
class BoxVolumes
{
public:
  BoxVolumes(const Patches& patches, const Nodes& nodes)
    : patches_(patches)
    , nodes_(nodes)
  {
  }

  // Finds the volumes of a box of which these are the connected faces. `origin`: a point near them, for
  // the sake of rounding.
  void find(BoxFaces& faces, const Point& origin);

  const std::vector<Shell>& shells() const { return shells_; }

  // Voids that became holes of the volumes around them, and folds that were dropped.
  std::size_t voids() const { return voids_; }
  std::size_t folds() const { return folds_; }

  // Whether a volume has a face on both sides of it, which happens where parts of the surface overlap.
  bool anyFaceTwice(const BoxFaces& faces);

  // The boundary that the largest area of a shell's patches belongs to.
  std::int32_t mainBoundary(const BoxFaces& faces, const Shell& shell);

private:
  // Area, and volume of the cone to the origin, by star triangulation (equation 1).
  struct FaceMeasure
  {
    double area = 0;
    double volume = 0;
  };

  void measureFaces(const BoxFaces& faces, const Point& origin);
  void findShells(BoxFaces& faces);
  std::size_t fillVoids(const BoxFaces& faces);
  std::size_t dropFolds(const BoxFaces& faces);
  Shell* shellAround(const BoxFaces& faces, const Shell& inner);
  double solidAngle(const BoxFaces& faces, const Shell& shell, const Point& from);

  const Patches& patches_;
  const Nodes& nodes_;
  std::vector<FaceMeasure> measures_; // of each face
  std::vector<Vector> ring_;
  std::vector<Shell> shells_;
  ObjectPool<Shell> pool_;
  std::size_t voids_ = 0;
  std::size_t folds_ = 0;
  std::vector<std::uint32_t> shellOf_;
  std::vector<std::pair<std::int32_t, double>> areas_;
  BoxFaces::Cycles cycles_;
  std::vector<std::uint32_t> dropped_;
};

}
