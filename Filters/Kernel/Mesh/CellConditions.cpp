// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CellConditions.h"

#include "Quality/CellMeasures.h"
#include "Quality/QualityMeasures.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t CellsAChunk = 256;

// Checks one cell after the other. Keeps its storage.
class Inspector
{
public:
  Inspector(const MeshParts& parts, CellConditions& failures)
    : parts_(parts)
    , failures_(failures)
  {
  }

  void inspect(std::size_t cell)
  {
    faces_.clear();
    parts_.wall.forEachUse(cell, [&](const FaceUse& use) { faces_.push_back(geometryOf(use)); });
    const CellGeometry geometry =
      measureCell(faces_.size(), [&](std::size_t f) -> const FaceGeometry& { return faces_[f]; });
    std::array<bool, 2> failing{ false, false }; // at inner faces, at the boundary
    AreaSums sums;
    for (std::size_t f = 0; f < faces_.size(); ++f)
    {
      sums.add(faces_[f].area);
      // Compares cosines, for speed.
      const Vector way = minus(faces_[f].centre, geometry.centre);
      const bool boundary = isBoundary(parts_.wall.uses[parts_.wall.cells[cell].firstUse + f]);
      const double least = boundary ? 0 : leastInnerCosine_ * norm(way) * norm(faces_[f].area);
      failing[boundary] = failing[boundary] || !(dot(way, faces_[f].area) > least);
    }
    failures_.boundaryAngle += failing[1];
    failures_.innerAngle += failing[0];
    failures_.open += fails(Openness, sums.openness());
    failures_.negativeVolume += fails(Volume, geometry.volume);
  }

private:
  FaceGeometry geometryOf(const FaceUse& use)
  {
    corners_.clear();
    parts_.wall.faces.forEachNode(
      use, [&](std::uint32_t node) { corners_.push_back(toVector(parts_.nodes.at[node])); });
    return measureFace(
      corners_.size(), [&](std::size_t i) -> const Vector& { return corners_[i]; });
  }

  bool isBoundary(const FaceUse& use) const
  {
    const CellKey other = parts_.wall.faces.beyond(use);
    return other == None || parts_.wall.isRemoved(other) || parts_.wall.isInterface(use.face);
  }

  const MeshParts& parts_;
  CellConditions& failures_;
  const double leastInnerCosine_ = std::cos(MeasureSpecs[InnerAngle].limit / 90 * std::acos(0.0));
  std::vector<FaceGeometry> faces_;
  std::vector<Vector> corners_;
};

}

CellConditions countFailures(
  const MeshParts& parts, const CellNumbers& numbers, Execution& execution)
{
  const std::size_t cells = numbers.coreEnd - numbers.coreBegin;
  std::vector<CellConditions> ofChunk(chunks(cells, CellsAChunk));
  execution.nextLoop(0.8);
  execution.forEach(cells, CellsAChunk, [&](std::size_t begin, std::size_t end) {
    Inspector inspector(parts, ofChunk[begin / CellsAChunk]);
    for (std::size_t c = numbers.coreBegin + begin; c < numbers.coreBegin + end; ++c)
    {
      if (!parts.wall.cells[c].removed)
      {
        inspector.inspect(c);
      }
    }
  });
  CellConditions all;
  for (const CellConditions& chunk : ofChunk)
  {
    all.boundaryAngle += chunk.boundaryAngle;
    all.innerAngle += chunk.innerAngle;
    all.open += chunk.open;
    all.negativeVolume += chunk.negativeVolume;
  }
  return all;
}

}
