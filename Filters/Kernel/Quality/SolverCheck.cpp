// SPDX-License-Identifier: BSD-3-Clause
#include "Quality/SolverCheck.h"

#include "Base/Sorting.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace cartesian
{

namespace
{

constexpr std::size_t ItemsAChunk = 4096;

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
  {
    const auto last = std::max_element(checked.regionOf.begin(), checked.regionOf.end());
    result_.ofRegions.resize(last == checked.regionOf.end() ? 1 : *last + 1);
  }

  void lookAtFaces(std::size_t begin, std::size_t end)
  {
    for (std::size_t f = begin; f < end; ++f)
    {
      lookAtFace(f);
    }
  }

  void lookAtCells(std::size_t begin, std::size_t end)
  {
    for (std::size_t c = begin; c < end; ++c)
    {
      lookAtCell(static_cast<std::uint32_t>(c));
    }
  }

  // May list cells several times.
  const SolverCheck& result() const { return result_; }

private:
  bool isHere(std::uint32_t cell) const
  {
    return checked_.isElsewhere.empty() || checked_.isElsewhere[cell] == 0;
  }

  void add(Finding what, std::uint32_t cell, std::size_t count = 1)
  {
    result_.ofRegions[checked_.regionOf[cell]][what] += count;
    if (FindingSpecs[what].isFailure)
    {
      result_.failing.push_back(cell);
    }
  }

  void lookAtFace(std::size_t f)
  {
    const std::uint32_t owner = faces_.owner[f];
    const std::size_t inner = faces_.neighbour.size();
    if (!isHere(owner))
    {
      return;
    }
    if (norm(quality_.faceGeometry[f].area) < SolverLimits::Area)
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
    const bool isSeen = f < inner || isSeen_[f - inner];
    raise(result_.skewness, isSeen ? quality_.faces[Skewness][f] : 0);
    raise(result_.nonOrthogonality, f < inner ? quality_.faces[NonOrthogonality][f] : 0);
    if (isSeen && quality_.faces[Skewness][f] > Limits::Skewness)
    {
      add(SkewFaces, owner);
      result_.failing.push_back(f < inner ? faces_.neighbour[f] : owner);
    }
    if (f < inner && quality_.faces[NonOrthogonality][f] > Limits::NonOrthogonality)
    {
      const bool isError = std::cos(radians(quality_.faces[NonOrthogonality][f])) <=
        SolverLimits::NonOrthogonalityCosine;
      add(isError ? NonOrthogonalFaces : SteepFaces, owner);
      if (isError)
      {
        result_.failing.push_back(faces_.neighbour[f]);
      }
    }
  }

  // Not by NaN.
  static void raise(double& most, double value) { most = value > most ? value : most; }

  // The pyramid from a cell's centre, if the face's area points out of the cell times `sign`.
  bool isInverted(std::size_t f, std::uint32_t cell, double sign) const
  {
    return sign * pyramidVolume(quality_.faceGeometry[f], quality_.cellGeometry[cell].centre) <
      SolverLimits::PyramidVolume;
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
      { CellsOfFewFaces, size < SolverLimits::Faces },
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
  SolverCheck result_;
};

SolverCheck sumOf(const std::vector<Counter>& counters, SolverCheck sum)
{
  for (const Counter& counter : counters)
  {
    const SolverCheck& part = counter.result();
    for (std::size_t r = 0; r < part.ofRegions.size(); ++r)
    {
      std::transform(part.ofRegions[r].begin(), part.ofRegions[r].end(), sum.ofRegions[r].begin(),
        sum.ofRegions[r].begin(), std::plus<>());
    }
    sum.skewness = std::max(sum.skewness, part.skewness);
    sum.nonOrthogonality = std::max(sum.nonOrthogonality, part.nonOrthogonality);
    sum.failing.insert(sum.failing.end(), part.failing.begin(), part.failing.end());
  }
  sum.failing = sortedUnique(std::move(sum.failing));
  return sum;
}

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
  const Counter none(cells, faces, checked, isSeen, quality);
  const std::size_t ofFaces = chunks(faces.owner.size(), ItemsAChunk);
  std::vector<Counter> counters(ofFaces + chunks(cells.cellCount(), ItemsAChunk), none);
  execution.forEach(faces.owner.size(), ItemsAChunk, [&](std::size_t begin, std::size_t end) {
    counters[begin / ItemsAChunk].lookAtFaces(begin, end);
  });
  execution.forEach(cells.cellCount(), ItemsAChunk, [&](std::size_t begin, std::size_t end) {
    counters[ofFaces + begin / ItemsAChunk].lookAtCells(begin, end);
  });
  return sumOf(counters, none.result());
}

}
