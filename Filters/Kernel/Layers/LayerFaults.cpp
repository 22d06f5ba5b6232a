// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/LayerFaults.h"

#include "Base/ForEachItem.h"
#include "Quality/CellMeasures.h"
#include "Quality/CorrectionGain.h"
#include "Quality/FaceCorners.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace cartesian
{

namespace
{

constexpr std::uint32_t OfCells = 1U << Volume | 1U << Openness;
constexpr std::uint32_t OfFaces = 1U << BoundaryAngle | 1U << NonOrthogonality | 1U << Skewness;
constexpr int PointsOfAFace = 3; // at least

template <class Visitor>
void forEachCorner(const CellFaces& cells, std::size_t cell, Visitor&& visit)
{
  const std::size_t end = cells.firstCorner[cells.firstFace[cell + 1]];
  for (std::size_t i = cells.firstCorner[cells.firstFace[cell]]; i < end; ++i)
  {
    visit(cells.corners[i]);
  }
}

void addCell(const CellFaces& from, std::size_t cell, CellFaces& to)
{
  for (std::size_t f = from.firstFace[cell]; f < from.firstFace[cell + 1]; ++f)
  {
    to.corners.insert(to.corners.end(),
      from.corners.begin() + static_cast<std::ptrdiff_t>(from.firstCorner[f]),
      from.corners.begin() + static_cast<std::ptrdiff_t>(from.firstCorner[f + 1]));
    to.firstCorner.push_back(to.corners.size());
  }
  to.firstFace.push_back(to.faceCount());
}

void addCells(const CellFaces& from, CellFaces& to)
{
  const std::size_t corners = to.corners.size();
  const std::size_t faces = to.faceCount();
  const auto add = [](auto& starts, const auto& more, std::size_t by) {
    std::transform(more.begin() + 1, more.end(), std::back_inserter(starts),
      [&](std::size_t start) { return start + by; });
  };
  to.corners.insert(to.corners.end(), from.corners.begin(), from.corners.end());
  add(to.firstCorner, from.firstCorner, corners);
  add(to.firstFace, from.firstFace, faces);
}

// Adds a cell: its number of faces, and for each its size and points.
void addPolyhedron(CellFaces& cells, const Id* stream)
{
  for (Id left = *stream++; left > 0; --left)
  {
    const Id size = *stream++;
    for (Id i = 0; i < size; ++i)
    {
      cells.corners.push_back(static_cast<std::uint32_t>(*stream++));
    }
    cells.firstCorner.push_back(cells.corners.size());
  }
  cells.firstFace.push_back(cells.faceCount());
}

CellFaces cellsOf(const PrismStacks& stacks)
{
  CellFaces cells;
  cells.firstFace.assign(1, 0);
  cells.firstCorner.assign(1, 0);
  for (const Id start : stacks.faceStart)
  {
    addPolyhedron(cells, &stacks.faceStream[static_cast<std::size_t>(start)]);
  }
  return cells;
}

// What is left of a stack above one node may have hardly any third direction, where a prism has that of the face below it,
// however thin it is.
bool isFlat(const CellFaces& cells, std::size_t cell, const std::vector<double>& points)
{
  const FaceCorners faces(cells, points.data());
  AreaSpread spread;
  for (std::size_t f = cells.firstFace[cell]; f < cells.firstFace[cell + 1]; ++f)
  {
    spread.add(faces.geometry(f).area);
  }
  return spread.third() < LayerLimits::ThirdDirection;
}

}

// Cells that have changed, and those that share a face with one: all that measures of the first need.
struct LayerFaults::Selection
{
  CellFaces cells{ { 0 }, { 0 }, {} };
  std::vector<std::uint32_t> number; // of each: a near cell, or beyond these one of the stacks
  std::vector<std::uint32_t> face;   // of each face of a near cell among theirs; others None
  std::vector<std::uint8_t> hasChanged;

  void addPoints(
    std::size_t firstFace, std::size_t lastFace, std::vector<std::uint32_t>& points) const
  {
    points.insert(points.end(),
      cells.corners.begin() + static_cast<std::ptrdiff_t>(cells.firstCorner[firstFace]),
      cells.corners.begin() + static_cast<std::ptrdiff_t>(cells.firstCorner[lastFace]));
  }
  void addPointsOfCell(std::size_t cell, std::vector<std::uint32_t>& points) const
  {
    addPoints(cells.firstFace[cell], cells.firstFace[cell + 1], points);
  }
};

LayerFaults::LayerFaults(
  const NearCells& near, const std::vector<double>& points, Execution& execution)
  : near_(near)
{
  Faults faults = measure(near.cells, points, execution);
  faceWasAtFault_.assign(near.cells.faceCount(), 0);
  for (std::size_t f = 0; f < faults.face.size(); ++f)
  {
    faceWasAtFault_[faults.list.face[f]] = faults.face[f];
  }
  cellWasAtFault_ = std::move(faults.cell);
  cellWasOdd_ = std::move(faults.isOdd);
  cellWasLong_ = std::move(faults.isLong);
}

LayerFaults::Faults LayerFaults::measure(
  const CellFaces& cells, const std::vector<double>& points, Execution& execution)
{
  Faults faults;
  faults.list = listFaces(cells, points.size() / 3, Clashes::AreBoundary, execution);
  const Quality quality =
    measureQuality(points.data(), cells, faults.list, execution, standardLimits(), SlowMeasures);
  faults.face.resize(faults.list.face.size());
  forEachItem(faults.face.size(), execution, [&](std::size_t f) {
    faults.face[f] = (quality.faceFailures[f] & OfFaces) != 0 ||
      !(quality.faces[InnerAngle][f] < LayerLimits::InnerAngle);
  });
  faults.weight.assign(quality.faces[FaceWeight].begin(),
    quality.faces[FaceWeight].begin() + static_cast<std::ptrdiff_t>(faults.list.neighbour.size()));
  faults.volume.assign(quality.cells[Volume].begin(), quality.cells[Volume].end());
  const std::vector<double> gains = correctionGains(faults.list, quality);
  for (std::vector<std::uint8_t>* const ofCells : { &faults.cell, &faults.isOdd, &faults.isLong })
  {
    ofCells->resize(gains.size());
  }
  forEachItem(gains.size(), execution, [&](std::size_t c) {
    const std::uint32_t failures = quality.cellFailures[c];
    faults.cell[c] = (failures & OfCells) != 0;
    faults.isOdd[c] = !(gains[c] < LayerLimits::CorrectionGain);
    faults.isLong[c] = (failures & 1U << AspectRatio) != 0;
  });
  return faults;
}

LayerFaults::Changes LayerFaults::changesBy(const std::vector<std::uint8_t>& hasMoved) const
{
  Changes changes{ std::vector<std::uint8_t>(near_.cells.cellCount()),
    std::vector<std::uint8_t>(hasMoved.size()), {} };
  for (std::size_t c = 0; c < changes.cells.size(); ++c)
  {
    forEachCorner(near_.cells, c, [&](std::uint32_t p) { changes.cells[c] |= hasMoved[p]; });
    if (changes.cells[c])
    {
      forEachCorner(near_.cells, c, [&](std::uint32_t p) { changes.isTouched[p] = 1; });
    }
  }
  return changes;
}

LayerFaults::Selection LayerFaults::selectAll(const CellFaces& ofStacks) const
{
  Selection selected;
  selected.cells = near_.cells;
  addCells(ofStacks, selected.cells);
  selected.number.resize(selected.cells.cellCount());
  std::iota(selected.number.begin(), selected.number.end(), 0U);
  selected.face.resize(near_.cells.faceCount());
  std::iota(selected.face.begin(), selected.face.end(), 0U);
  selected.face.resize(selected.cells.faceCount(), std::uint32_t(None));
  selected.hasChanged.assign(selected.number.size(), 1);
  return selected;
}

LayerFaults::Selection LayerFaults::select(const CellFaces& ofStacks, const Changes& changes) const
{
  std::vector<std::uint8_t> isTouched = changes.isTouched;
  isTouched.resize(changes.isTouched.size() + changes.ofStacks.size());
  const std::size_t ofMesh = changes.isTouched.size();
  std::vector<std::uint8_t> stackChanged(ofStacks.cellCount());
  for (std::size_t c = 0; c < stackChanged.size(); ++c)
  {
    forEachCorner(ofStacks, c, [&](std::uint32_t p) {
      stackChanged[c] = stackChanged[c] || (p >= ofMesh && changes.ofStacks[p - ofMesh]);
    });
    if (stackChanged[c])
    {
      forEachCorner(ofStacks, c, [&](std::uint32_t p) { isTouched[p] = 1; });
    }
  }
  Selection selected;
  const auto add = [&](const CellFaces& cells, const std::vector<std::uint8_t>& hasChanged,
                     bool isOfMesh) {
    for (std::size_t c = 0; c < cells.cellCount(); ++c)
    {
      int touched = 0; // as often as faces have them
      forEachCorner(cells, c, [&](std::uint32_t p) { touched += isTouched[p]; });
      if (touched < PointsOfAFace)
      {
        continue;
      }
      selected.number.push_back(
        static_cast<std::uint32_t>(isOfMesh ? c : c + near_.cells.cellCount()));
      selected.hasChanged.push_back(hasChanged[c]);
      for (std::size_t f = cells.firstFace[c]; f < cells.firstFace[c + 1]; ++f)
      {
        selected.face.push_back(isOfMesh ? static_cast<std::uint32_t>(f) : std::uint32_t(None));
      }
      addCell(cells, c, selected.cells);
    }
  };
  add(near_.cells, changes.cells, true);
  add(ofStacks, stackChanged, false);
  return selected;
}

// Whether a listed face is at fault, and not because it was before there were layers.
bool LayerFaults::isNewFace(const Selection& selected, const Faults& faults, std::size_t f) const
{
  const std::uint32_t owner = faults.list.owner[f];
  const std::uint32_t other = f < faults.list.neighbour.size() ? faults.list.neighbour[f] : owner;
  const bool isOfMesh =
    std::max(selected.number[owner], selected.number[other]) < near_.cells.cellCount();
  return faults.face[f] && (selected.hasChanged[owner] || selected.hasChanged[other]) &&
    !(isOfMesh && faceWasAtFault_[selected.face[faults.list.face[f]]]);
}

LayerFault LayerFaults::ofFace(
  const Selection& selected, const Faults& faults, std::size_t f, const PrismStacks& stacks) const
{
  LayerFault fault;
  const std::uint32_t face = faults.list.face[f];
  selected.addPoints(face, face + 1, fault.points);
  const std::size_t ofMesh = near_.cells.cellCount();
  const std::uint32_t owner = faults.list.owner[f];
  const std::uint32_t other = f < faults.list.neighbour.size() ? faults.list.neighbour[f] : owner;
  const std::uint32_t c = selected.number[owner];
  const std::uint32_t d = selected.number[other];
  if (std::max(c, d) < ofMesh)
  {
    selected.addPointsOfCell(owner, fault.around);
    selected.addPointsOfCell(other, fault.around);
  }
  const bool areOfOneStack =
    std::min(c, d) < ofMesh || stacks.face[c - ofMesh] == stacks.face[d - ofMesh];
  fault.mendsThinner =
    areOfOneStack && !(std::max(c, d) >= ofMesh && stacks.isFilm[std::max(c, d) - ofMesh]);
  return fault;
}

// The smaller one of two cells of stacks side by side, if it is that much thinner.
std::optional<LayerFault> LayerFaults::ofSlice(
  const Selection& selected, const Faults& faults, std::size_t f, const PrismStacks& stacks) const
{
  const std::size_t ofMesh = near_.cells.cellCount();
  const std::uint32_t owner = faults.list.owner[f];
  const std::uint32_t other = faults.list.neighbour[f];
  const std::uint32_t c = selected.number[owner];
  const std::uint32_t d = selected.number[other];
  if (!(faults.weight[f] < LayerLimits::FaceWeight) ||
    !(selected.hasChanged[owner] || selected.hasChanged[other]) || std::min(c, d) < ofMesh ||
    stacks.face[c - ofMesh] == stacks.face[d - ofMesh])
  {
    return std::nullopt;
  }
  LayerFault fault;
  fault.mendsThinner = false;
  selected.addPointsOfCell(
    faults.volume[other] < faults.volume[owner] ? other : owner, fault.points);
  return fault;
}

std::vector<LayerFault> LayerFaults::find(
  const PrismStacks& stacks, const std::vector<double>& points, Execution& execution) const
{
  return findIn(selectAll(cellsOf(stacks)), stacks, points, execution);
}

std::vector<LayerFault> LayerFaults::find(const PrismStacks& stacks,
  const std::vector<double>& points, const Changes& changes, Execution& execution) const
{
  return findIn(select(cellsOf(stacks), changes), stacks, points, execution);
}

std::vector<LayerFault> LayerFaults::findIn(const Selection& selected, const PrismStacks& stacks,
  const std::vector<double>& points, Execution& execution) const
{
  const Faults faults = measure(selected.cells, points, execution);
  std::vector<std::uint8_t> hasNoThird(selected.number.size()); // of cells of stacks
  forEachItem(hasNoThird.size(), execution, [&](std::size_t c) {
    hasNoThird[c] = selected.number[c] >= near_.cells.cellCount() && selected.hasChanged[c] &&
      isFlat(selected.cells, c, points);
  });
  std::vector<LayerFault> found;
  for (std::size_t f = 0; f < faults.weight.size(); ++f)
  {
    if (std::optional<LayerFault> fault = ofSlice(selected, faults, f, stacks))
    {
      found.push_back(std::move(*fault));
    }
  }
  for (std::size_t f = 0; f < faults.face.size(); ++f)
  {
    if (isNewFace(selected, faults, f))
    {
      found.push_back(ofFace(selected, faults, f, stacks));
    }
  }
  for (std::size_t c = 0; c < selected.number.size(); ++c)
  {
    const std::uint32_t number = selected.number[c];
    const bool isOfMesh = number < near_.cells.cellCount();
    const bool isNew = faults.cell[c] && !(isOfMesh && cellWasAtFault_[number]);
    const bool isOdd = (faults.isOdd[c] && !(isOfMesh && cellWasOdd_[number])) ||
      (isOfMesh && faults.isLong[c] && !cellWasLong_[number]);
    if (selected.hasChanged[c] && (isNew || isOdd || hasNoThird[c]))
    {
      LayerFault fault;
      selected.addPointsOfCell(c, fault.points);
      fault.around = isOfMesh ? fault.points : fault.around;
      fault.mendsThinner = isNew && !hasNoThird[c];
      found.push_back(std::move(fault));
    }
  }
  return found;
}

}
