// SPDX-License-Identifier: BSD-3-Clause
// The plane of a flat side of a mesh, and places in it.
#pragma once

#include "Quality/FaceList.h"
#include "Sections/PlanePolygons.h"
#include "Sections/SideMotion.h"

#include <optional>

namespace cartesian
{

// Twice the area of a face: a vector along its normal. `points`: three coordinates each.
Vector doubledArea(const CellFaces& cells, std::size_t face, const std::vector<double>& points);

class SidePlane
{
public:
  // Seen from outside, the faces are counter-clockwise in it. Planes across an axis keep that coordinate exactly.
  SidePlane(const CellFaces& cells, const std::vector<std::size_t>& faces,
    const std::vector<double>& points);

  PlanePlace placeOf(const Vector& point) const
  {
    const Vector from = minus(point, origin_);
    return { dot(from, along_[0]), dot(from, along_[1]) };
  }
  Vector pointAt(const PlanePlace& place) const
  {
    return plus(origin_, plus(scaled(along_[0], place[0]), scaled(along_[1], place[1])));
  }
  double size() const { return size_; }

  // A point of the faces that does not lie in it (PeriodicSpec::Flatness).
  const std::optional<Vector>& pointBeside() const { return beside_; }

private:
  void choose(const Vector& area);

  Vector origin_{};
  std::array<Vector, 2> along_{};
  Vector normal_{};
  std::optional<Vector> beside_;
  double size_ = 0; // the diagonal of what holds its points
};

}
