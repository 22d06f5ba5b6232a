// SPDX-License-Identifier: BSD-3-Clause
#include "MeshCheck.h"

#include "Base/Error.h"
#include "Base/Sorting.h"
#include "BoundaryOfFaces.h"
#include "FieldData.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>

namespace cartesian
{

namespace
{

constexpr std::size_t CellsAChunk = 1 << 14;

std::vector<vtkIdType> allCells(vtkUnstructuredGrid* grid)
{
  std::vector<vtkIdType> cells(static_cast<std::size_t>(grid->GetNumberOfCells()));
  std::iota(cells.begin(), cells.end(), vtkIdType(0));
  return cells;
}

// Calls visit(cell, isPolyhedron, begin, end) for the points of each cell.
template <class Visitor>
void forEachCell(vtkUnstructuredGrid* grid, Visitor&& visit, Execution& execution)
{
  const auto count = static_cast<std::size_t>(grid->GetNumberOfCells());
  execution.forEach(count, CellsAChunk, [&](std::size_t begin, std::size_t end) {
    const auto points = vtk::TakeSmartPointer(grid->GetCells()->NewIterator());
    for (std::size_t c = begin; c < end; ++c)
    {
      const auto cell = static_cast<vtkIdType>(c);
      vtkIdType size = 0;
      const vtkIdType* point = nullptr;
      points->GetCellAtId(cell, size, point);
      visit(cell, grid->GetCellType(cell) == VTK_POLYHEDRON, point, point + size);
    }
  });
}

// Polyhedra, and hexahedra that have a point in common with one.
std::vector<vtkIdType> cellsAtWalls(vtkUnstructuredGrid* grid, Execution& execution)
{
  std::vector<std::atomic<bool>> isOfPolyhedron(
    static_cast<std::size_t>(grid->GetNumberOfPoints()));
  const auto mark = [&](vtkIdType point) {
    isOfPolyhedron[std::size_t(point)].store(true, std::memory_order_relaxed);
  };
  const auto isMarked = [&](vtkIdType point) {
    return isOfPolyhedron[std::size_t(point)].load(std::memory_order_relaxed);
  };
  using Points = const vtkIdType*;
  forEachCell(
    grid,
    [&](vtkIdType, bool isPolyhedron, Points begin, Points end) {
      std::for_each(begin, isPolyhedron ? end : begin, mark);
    },
    execution);
  std::vector<std::vector<vtkIdType>> chosen(
    chunks(static_cast<std::size_t>(grid->GetNumberOfCells()), CellsAChunk));
  forEachCell(
    grid,
    [&](vtkIdType cell, bool isPolyhedron, Points begin, Points end) {
      if (isPolyhedron || std::any_of(begin, end, isMarked))
      {
        chosen[std::size_t(cell) / CellsAChunk].push_back(cell);
      }
    },
    execution);
  return concatenated(chosen);
}

// Of those that Region numbers; one that is empty if there are no several.
std::vector<std::string> regionNames(vtkUnstructuredGrid* grid)
{
  auto* names = vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray("RegionNames"));
  vtkDataArray* const regions = grid->GetCellData()->GetArray("Region");
  std::vector<std::string> result;
  if (!names || !regions)
  {
    return std::vector<std::string>(1);
  }
  for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
  {
    result.push_back(names->GetValue(i));
  }
  const bool areKnown = result.size() > 1 && regions->GetRange(0)[0] >= FirstRegion &&
    regions->GetRange(0)[1] < FirstRegion + static_cast<double>(result.size());
  return areKnown ? result : std::vector<std::string>(1);
}

// Opens the faces between regions.
void separate(const CellFaces& cells, const std::vector<std::uint32_t>& regionOf, FaceList& list)
{
  std::vector<std::size_t> between;
  for (std::size_t f = 0; f < list.neighbour.size(); ++f)
  {
    if (regionOf[list.owner[f]] != regionOf[list.neighbour[f]])
    {
      between.push_back(f);
    }
  }
  openFaces(cells, between, list);
}

// The rest of checkMesh().
class Checker
{
public:
  Checker(vtkUnstructuredGrid* grid, Checked which, Execution& execution)
    : grid_(grid)
    , cellOf_(which == Checked::All ? allCells(grid) : cellsAtWalls(grid, execution))
    , cells_(facesOfCells(grid, cellOf_, execution))
  {
  }

  MeshCheck run(Execution& execution)
  {
    MeshCheck result{ regionNames(grid_), {}, {} };
    const CheckedCells checked{ regionsOfCells(result.regions.size()), ghosts(), layers() };
    FaceList list = listFaces(cells_, static_cast<std::size_t>(grid_->GetNumberOfPoints()),
      Clashes::AreBoundary, execution);
    std::vector<vtkIdType> boundary;
    const bool isKnown = readBoundaryOfFaces(grid_, cells_, cellOf_, list, boundary, execution) ==
      BoundaryKnowledge::All;
    const std::vector<bool> isSeen = seenFaces(checked.regionOf, boundary, isKnown, list);
    std::vector<double> copy;
    SolverCheck found =
      checkForSolver(coordinatesOf(grid_, copy), cells_, list, checked, isSeen, execution);
    result.ofRegions = std::move(found.ofRegions);
    result.skewness = found.skewness;
    result.nonOrthogonality = found.nonOrthogonality;
    result.ofRegions.resize(result.regions.size());
    for (const std::uint32_t cell : found.failing)
    {
      result.failing.push_back(cellOf_[cell]);
    }
    return result;
  }

private:
  std::vector<std::uint32_t> regionsOfCells(std::size_t count) const
  {
    std::vector<std::uint32_t> ofCells(cellOf_.size());
    vtkDataArray* const regions = grid_->GetCellData()->GetArray("Region");
    for (std::size_t i = 0; count > 1 && i < cellOf_.size(); ++i)
    {
      ofCells[i] = static_cast<std::uint32_t>(regions->GetComponent(cellOf_[i], 0)) - FirstRegion;
    }
    return ofCells;
  }

  std::vector<unsigned char> ghosts() const
  {
    std::vector<unsigned char> isGhost;
    if (vtkUnsignedCharArray* const ghosts = grid_->GetCellGhostArray())
    {
      for (const vtkIdType cell : cellOf_)
      {
        isGhost.push_back(ghosts->GetValue(cell));
      }
    }
    return isGhost;
  }

  // Whether each is one of a stack of layers.
  std::vector<unsigned char> layers() const
  {
    std::vector<unsigned char> isLayer;
    if (vtkDataArray* const layer = grid_->GetCellData()->GetArray("Layer"))
    {
      for (const vtkIdType cell : cellOf_)
      {
        isLayer.push_back(layer->GetComponent(cell, 0) > 0 ? 1 : 0);
      }
    }
    return isLayer;
  }

  // Boundary faces of the mesh, and those between regions, which this opens; the others have cells beyond that are
  // not looked at.
  std::vector<bool> seenFaces(const std::vector<std::uint32_t>& regionOf,
    const std::vector<vtkIdType>& boundary, bool isKnown, FaceList& list) const
  {
    std::vector<bool> isUnseen(cells_.faceCount());
    for (std::size_t i = 0; i < boundary.size(); ++i)
    {
      isUnseen[list.face[list.neighbour.size() + i]] = isKnown && boundary[i] == UnknownBoundary;
    }
    separate(cells_, regionOf, list);
    std::vector<bool> isSeen(list.face.size() - list.neighbour.size());
    for (std::size_t i = 0; i < isSeen.size(); ++i)
    {
      isSeen[i] = !isUnseen[list.face[list.neighbour.size() + i]];
    }
    return isSeen;
  }

  vtkUnstructuredGrid* grid_;
  std::vector<vtkIdType> cellOf_;
  CellFaces cells_;
};

std::string inWords(const Findings& findings)
{
  std::string text;
  for (std::size_t f = 0; f < FindingCount; ++f)
  {
    const FindingSpec& spec = FindingSpecs[f];
    if (spec.isFailure && findings[f] > 0)
    {
      text += (text.empty() ? "" : ", ") + std::to_string(findings[f]) + " " +
        (findings[f] == 1 ? spec.one : spec.several);
    }
  }
  return text;
}

}

Findings MeshCheck::sum() const
{
  Findings all{};
  for (const Findings& findings : ofRegions)
  {
    std::transform(all.begin(), all.end(), findings.begin(), all.begin(), std::plus<>());
  }
  return all;
}

MeshCheck checkMesh(vtkUnstructuredGrid* grid, Checked which, Execution& execution)
{
  return grid->GetNumberOfCells() == 0 ? MeshCheck{ { "" }, { Findings{} }, {} }
                                       : Checker(grid, which, execution).run(execution);
}

MeshCheck sum(MeshCheck check, const Processes& processes)
{
  if (processes.areSeveral())
  {
    const Findings mine = check.sum();
    const std::vector<double> all = processes.sum({ mine.begin(), mine.end() });
    check.ofRegions.assign(1, {});
    std::transform(all.begin(), all.end(), check.ofRegions[0].begin(),
      [](double count) { return static_cast<std::size_t>(count); });
  }
  return check;
}

void toVTK(const MeshCheck& check, vtkIdType cells, vtkStringArray* table)
{
  constexpr double Digits = 100;
  const auto rounded = [](double value) { return number(std::round(Digits * value) / Digits); };
  table->Initialize();
  for (const std::string& text :
    { std::string("Cells"), std::string("Fail"), std::string("Skewness"), std::string("Non-orth."),
      std::to_string(cells), std::to_string(check.failing.size()), rounded(check.skewness),
      rounded(check.nonOrthogonality) })
  {
    table->InsertNextValue(text);
  }
}

void setFindings(const MeshCheck& check, vtkUnstructuredGrid* grid)
{
  const Findings all = check.sum();
  for (std::size_t f = 0; f < FindingCount; ++f)
  {
    setField(grid, FindingSpecs[f].name, { static_cast<double>(all[f]) });
    std::vector<double> ofRegions;
    for (const Findings& findings : check.ofRegions)
    {
      ofRegions.push_back(static_cast<double>(findings[f]));
    }
    if (ofRegions.size() > 1)
    {
      setField(grid, (std::string("Region") + FindingSpecs[f].name).c_str(), ofRegions);
    }
  }
}

std::string describeFailures(const MeshCheck& check, vtkUnstructuredGrid* grid)
{
  constexpr std::size_t MostPlaces = 5;
  std::string text;
  for (std::size_t r = 0; r < check.regions.size(); ++r)
  {
    const std::string words = inWords(check.ofRegions[r]);
    text += words.empty() ? ""
                          : (text.empty() ? "" : "; ") +
        (check.regions[r].empty() ? "" : "in region " + check.regions[r] + " ") + words;
  }
  if (text.empty())
  {
    return text;
  }
  text = "checkMesh will fail: " + text +
    ". Repairing that would change the wall too much. Change the Cell Size by a few percent, so "
    "that the wall lies elsewhere in the boxes; where it bounds something thinner than the boxes, "
    "use smaller ones (Refinement Depth):";
  for (std::size_t i = 0; i < std::min(check.failing.size(), MostPlaces); ++i)
  {
    std::array<double, 6> at;
    grid->GetCellBounds(check.failing[i], at.data());
    const auto corner = [&](std::size_t end) {
      return "(" + number(at[end]) + ", " + number(at[2 + end]) + ", " + number(at[4 + end]) + ")";
    };
    text += "\n  in a cell from " + corner(0) + " to " + corner(1);
  }
  return text;
}

}
