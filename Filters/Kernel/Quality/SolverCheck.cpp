// SPDX-License-Identifier: BSD-3-Clause
#include "Quality/SolverCheck.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cartesian
{

namespace
{

constexpr std::size_t FewestFaces = 4;

// OpenFOAM's, whatever the unit of length: of a pyramid's volume and of a face's area.
constexpr double InvertedBelow = -1e-15;
constexpr double NoAreaBelow = 1e-300;
constexpr double TurnedOver = 1e-15; // cosine of the non-orthogonality

class Counter
{
public:
  Counter(const CellFaces& cells, const FaceList& faces, const CheckedCells& checked,
    const std::vector<bool>& isSeen, const Quality& quality)
    : cells_(cells)
    , faces_(faces)
    , checked_(checked)
    , isSeen_(isSeen)
    , quality_(quality)
    , isFailing_(cells.cellCount())
  {
    const auto last = std::max_element(checked.regionOf.begin(), checked.regionOf.end());
    result_.ofRegions.resize(last == checked.regionOf.end() ? 1 : *last + 1);
  }

  SolverCheck run() &&
  {
    for (std::size_t f = 0; f < faces_.owner.size(); ++f)
    {
      lookAtFace(f);
    }
    for (std::uint32_t c = 0; c < cells_.cellCount(); ++c)
    {
      lookAtCell(c);
    }
    for (std::uint32_t c = 0; c < cells_.cellCount(); ++c)
    {
      if (isFailing_[c])
      {
        result_.failing.push_back(c);
      }
    }
    return std::move(result_);
  }

private:
  bool isHere(std::uint32_t cell) const
  {
    return checked_.isElsewhere.empty() || checked_.isElsewhere[cell] == 0;
  }

  void add(Finding what, std::uint32_t cell, std::size_t count = 1)
  {
    result_.ofRegions[checked_.regionOf[cell]][what] += count;
    isFailing_[cell] = isFailing_[cell] || FindingSpecs[what].isFailure;
  }

  void lookAtFace(std::size_t f)
  {
    const std::uint32_t owner = faces_.owner[f];
    const std::size_t inner = faces_.neighbour.size();
    if (!isHere(owner))
    {
      return;
    }
    if (norm(quality_.faceGeometry[f].area) < NoAreaBelow)
    {
      add(FacesWithoutArea, owner);
    }
    if (isInverted(f, owner, 1))
    {
      add(InvertedFaces, owner);
    }
    if (f < inner && isInverted(f, faces_.neighbour[f], -1))
    {
      add(InvertedFaces, faces_.neighbour[f]);
    }
    if ((f < inner || isSeen_[f - inner]) && quality_.faces[Skewness][f] > Limits::Skewness)
    {
      add(SkewFaces, owner);
      isFailing_[f < inner ? faces_.neighbour[f] : owner] = true;
    }
    if (f < inner && quality_.faces[NonOrthogonality][f] > Limits::NonOrthogonality)
    {
      const bool isError = std::cos(radians(quality_.faces[NonOrthogonality][f])) <= TurnedOver;
      add(isError ? NonOrthogonalFaces : SteepFaces, owner);
      isFailing_[faces_.neighbour[f]] = isFailing_[faces_.neighbour[f]] || isError;
    }
  }

  // The pyramid from a cell's centre, if the face's area points out of the cell times `sign`.
  bool isInverted(std::size_t f, std::uint32_t cell, double sign) const
  {
    const FaceGeometry& face = quality_.faceGeometry[f];
    const Vector height = minus(face.centre, quality_.cellGeometry[cell].centre);
    return sign * dot(face.area, height) / 3 < InvertedBelow;
  }

  void lookAtCell(std::uint32_t c)
  {
    const std::size_t size = cells_.firstFace[c + 1] - cells_.firstFace[c];
    if (!isHere(c) || size == 0)
    {
      return;
    }
    const bool isLayer = !checked_.isLayer.empty() && checked_.isLayer[c] != 0;
    const std::array<std::pair<Finding, bool>, 4> found{ {
      { CellsOfFewFaces, size < FewestFaces },
      { OpenCells, quality_.cells[Openness][c] > Limits::Openness },
      { CellsWithoutVolume, quality_.cells[Volume][c] < Tiny },
      { isLayer ? LongLayers : LongCells, quality_.cells[AspectRatio][c] > Limits::AspectRatio },
    } };
    for (const auto& [what, isThere] : found)
    {
      if (isThere)
      {
        add(what, c);
      }
    }
  }

  const CellFaces& cells_;
  const FaceList& faces_;
  const CheckedCells& checked_;
  const std::vector<bool>& isSeen_;
  const Quality& quality_;
  std::vector<bool> isFailing_;
  SolverCheck result_;
};

}

std::size_t failuresIn(const Findings& findings)
{
  std::size_t sum = 0;
  for (std::size_t f = 0; f < FindingCount; ++f)
  {
    sum += FindingSpecs[f].isFailure ? findings[f] : 0;
  }
  return sum;
}

SolverCheck checkForSolver(const double* points, const CellFaces& cells, const FaceList& faces,
  const CheckedCells& checked, const std::vector<bool>& isSeen, Execution& execution)
{
  const Quality quality =
    measureQuality(points, cells, faces, execution, standardLimits(), SlowMeasures);
  return Counter(cells, faces, checked, isSeen, quality).run();
}

}
