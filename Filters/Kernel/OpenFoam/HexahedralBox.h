// SPDX-License-Identifier: BSD-3-Clause
// A cell that is a box along the axes, with hanging nodes where cells beside it are smaller.
#pragma once

#include "OpenFoam/PolyMeshFiles.h"

#include <array>

namespace cartesian
{

class HexahedralBox
{
public:
  explicit HexahedralBox(const FoamMesh& mesh)
    : mesh_(mesh)
  {
  }

  // The cell with these faces, in any order. False: it is no box, a side is neither one face nor four quarters, or points
  // lie where no box halved at most twice more has corners.
  bool read(const std::uint32_t* faces, std::size_t count);

  // Calls visit(face, isWhole) for the faces of the cell that was read: a side, or a quarter of one.
  template <class Visitor>
  void forEachFace(Visitor&& visit) const
  {
    for (std::size_t i = 0; i < count_; ++i)
    {
      visit(faces_[i], isWhole_[i]);
    }
  }

  // Calls visit(point, halvings) for the points of each face: of the largest box inside this one that has a corner there, how often
  // it would be halved; 0 to 2.
  template <class Visitor>
  void forEachPoint(Visitor&& visit) const
  {
    for (std::size_t i = 0; i < count_; ++i)
    {
      for (std::size_t c = mesh_.start[faces_[i]]; c < mesh_.start[faces_[i] + 1UL]; ++c)
      {
        visit(mesh_.corners[c], halvingsAt(mesh_.corners[c]));
      }
    }
  }

  double shortestEdge() const;

private:
  static constexpr std::size_t MostFaces = 24;

  double at(std::uint32_t point, std::size_t axis) const
  {
    return mesh_.points[3UL * point + axis];
  }
  void findBounds();
  bool findMiddles();
  bool placeInner(std::size_t axis, double at);
  bool readSides();
  int sideOf(std::uint32_t face) const;
  int partAlong(std::uint32_t face, std::size_t axis) const;
  int halvingsAt(std::uint32_t point) const;

  const FoamMesh& mesh_;
  const std::uint32_t* faces_ = nullptr;
  std::size_t count_ = 0;
  std::array<bool, MostFaces> isWhole_{};
  std::array<double, 3> low_{};
  std::array<double, 3> high_{};
  std::array<double, 3> middle_{};                  // where hanging nodes are, if any
  std::array<std::array<double, 2>, 3> quarters_{}; // the same, on both sides of the middle
};

}
