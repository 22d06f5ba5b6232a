// SPDX-License-Identifier: BSD-3-Clause
#include "FoamFromVTK.h"

#include "Base/Error.h"
#include "BoundaryOfFaces.h"
#include "Cells/Cells.h"
#include "OpenFoam/ThirdEdges.h"
#include "PeriodicPairs.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace cartesian
{

namespace
{

// The volume of a whole box, divided by its own, may differ from 1 by so much.
constexpr double Rounding = 1e-9;

// Numbers in order, NoBoundary last.
bool isBefore(vtkIdType a, vtkIdType b)
{
  return (a == NoBoundary) != (b == NoBoundary) ? b == NoBoundary : a < b;
}

// The name as a word that is not taken yet: with the number, if need be.
std::string takeWord(const std::string& name, vtkIdType number, std::set<std::string>& taken)
{
  std::string word = foamWord(name);
  while (!taken.insert(word).second)
  {
    word += "_" + std::to_string(number);
  }
  return word;
}

// A distinct word for each boundary.
std::vector<std::string> patchNames(
  vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& boundaries)
{
  const std::map<vtkIdType, std::string> given = readBoundaryTexts(grid, "BoundaryNames");
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (const vtkIdType boundary : boundaries)
  {
    const auto name = given.find(boundary);
    const std::string plain =
      boundary == NoBoundary ? "no_surface" : "boundary_" + std::to_string(boundary);
    names.push_back(takeWord(
      name == given.end() || name->second.empty() ? plain : name->second, boundary, taken));
  }
  return names;
}

// What periodic pairs say of their patches.
void addPairs(vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& boundaries,
  std::vector<FoamPatch>& patches)
{
  int number = 0;
  for (const PeriodicPair& pair : readPeriodicPairs(grid))
  {
    ++number;
    for (std::size_t k = 0; k < 2; ++k)
    {
      const auto own = std::find(boundaries.begin(), boundaries.end(), pair.boundary[k]);
      const auto other = std::find(boundaries.begin(), boundaries.end(), pair.boundary[1 - k]);
      if (own != boundaries.end() && other != boundaries.end())
      {
        FoamPatch& patch = patches[static_cast<std::size_t>(own - boundaries.begin())];
        patch.partner = patches[static_cast<std::size_t>(other - boundaries.begin())].name;
        patch.motion = k == 0 ? pair.motion : pair.motion.reversed();
        patch.pair = k == 0 ? number : -number;
      }
    }
  }
}

}

std::vector<FoamPatch> patchesOf(vtkUnstructuredGrid* grid,
  const std::vector<vtkIdType>& boundaries, const std::vector<std::size_t>& counts)
{
  const std::vector<std::string> names = patchNames(grid, boundaries);
  std::map<vtkIdType, std::string> types = readBoundaryTexts(grid, "BoundaryTypes");
  std::vector<FoamPatch> patches;
  patches.reserve(names.size());
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    patches.push_back({ names[i], counts[i], types[boundaries[i]] });
  }
  addPairs(grid, boundaries, patches);
  return patches;
}

std::pair<std::vector<vtkIdType>, std::vector<std::size_t>> sortByBoundary(
  const std::vector<vtkIdType>& boundaryOf, FaceList& list)
{
  std::vector<vtkIdType> boundaries = boundaryOf;
  std::sort(boundaries.begin(), boundaries.end(), isBefore);
  boundaries.erase(std::unique(boundaries.begin(), boundaries.end()), boundaries.end());
  std::vector<std::uint32_t> patchOf;
  patchOf.reserve(boundaryOf.size());
  for (const vtkIdType boundary : boundaryOf)
  {
    patchOf.push_back(static_cast<std::uint32_t>(
      std::lower_bound(boundaries.begin(), boundaries.end(), boundary, isBefore) -
      boundaries.begin()));
  }
  std::vector<std::size_t> counts = sortByPatch(list, patchOf, boundaries.size());
  return { std::move(boundaries), std::move(counts) };
}

FoamRegions regionsOf(
  vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& cells, RegionsAsked asked)
{
  auto* names = vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray("RegionNames"));
  auto* regions = vtkIntArray::SafeDownCast(grid->GetCellData()->GetArray("Region"));
  std::map<int, std::uint32_t> number;
  for (int i = 1; names && asked == RegionsAsked::AllOfTheMesh && i <= names->GetNumberOfValues();
       ++i)
  {
    number[i] = 0;
  }
  for (std::size_t i = 0; names && regions && i < cells.size(); ++i)
  {
    number[regions->GetValue(cells[i])] = 0;
  }
  if (!regions || number.size() < 2 || number.begin()->first < 1 ||
    number.rbegin()->first > names->GetNumberOfValues())
  {
    return {};
  }
  FoamRegions result;
  std::set<std::string> taken;
  for (auto& [region, index] : number)
  {
    index = static_cast<std::uint32_t>(result.names.size());
    result.names.push_back(takeWord(names->GetValue(region - 1), region, taken));
  }
  for (const vtkIdType cell : cells)
  {
    result.ofCell.push_back(number[regions->GetValue(cell)]);
  }
  result.areZones = grid->GetFieldData()->HasArray("RegionsAreZones");
  return result;
}

std::vector<FoamZone> zonesOf(const FoamRegions& regions)
{
  std::vector<FoamZone> zones;
  for (const std::string& name : regions.names)
  {
    zones.push_back({ name, {} });
  }
  for (std::uint32_t cell = 0; cell < regions.ofCell.size(); ++cell)
  {
    zones[regions.ofCell[cell]].cells.push_back(cell);
  }
  return zones;
}

namespace
{

std::size_t firstCellOf(vtkUnstructuredGrid* grid, const GridFaces& faces)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(grid->GetCellData()->GetAbstractArray(CellId));
  const vtkIdType first = ids ? ids->GetValue(faces.cellOf.front()) : 0;
  for (std::size_t c = 0; c < faces.cellOf.size(); ++c)
  {
    if (!ids || ids->GetValue(faces.cellOf[c]) != first + static_cast<vtkIdType>(c))
    {
      throw Error(Fault::BadMesh,
        "The cells of this piece are not numbered consecutively: to write a decomposed case, save "
        "the output of Cartesian Mesher itself.");
    }
  }
  return static_cast<std::size_t>(first);
}

std::vector<std::int32_t> pointNumbers(vtkUnstructuredGrid* grid, const GridFaces& faces)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(grid->GetPointData()->GetGlobalIds());
  if (!ids)
  {
    throw Error(Fault::BadMesh,
      "The points have no global ids: to write a decomposed case, save the output of Cartesian "
      "Mesher itself.");
  }
  std::vector<std::int32_t> numbers;
  numbers.reserve(faces.pointOf.size());
  for (const vtkIdType point : faces.pointOf)
  {
    numbers.push_back(static_cast<std::int32_t>(ids->GetValue(point)));
  }
  return numbers;
}

// Faces that were not in the mesh's boundary have none.
BoundaryKnowledge readBoundaries(vtkUnstructuredGrid* grid, const GridFaces& faces, FaceList& list,
  std::vector<vtkIdType>& boundary, Execution& execution)
{
  const BoundaryKnowledge known =
    readBoundaryOfFaces(grid, faces.cells, faces.cellOf, list, boundary, execution);
  std::replace(boundary.begin(), boundary.end(), UnknownBoundary, vtkIdType(NoBoundary));
  return known;
}

// Of a mesh that knows the boxes of its cells; else empty.
std::vector<BoxLevel> boxLevelsOf(vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& cells)
{
  auto* levels = vtkUnsignedCharArray::SafeDownCast(grid->GetCellData()->GetArray("Level"));
  auto* fractions = vtkDoubleArray::SafeDownCast(grid->GetCellData()->GetArray("VolumeFraction"));
  if (!levels || levels->GetNumberOfComponents() != 3 || !fractions)
  {
    return {};
  }
  vtkDataArray* const layers = grid->GetCellData()->GetArray("Layer"); // of prisms at walls
  std::vector<BoxLevel> result;
  result.reserve(cells.size());
  for (const vtkIdType cell : cells)
  {
    const unsigned char* const level = levels->GetPointer(3 * cell);
    const auto [least, most] = std::minmax({ level[0], level[1], level[2] });
    const bool isUncut = std::abs(fractions->GetValue(cell) - 1) < Rounding &&
      (!layers || layers->GetComponent(cell, 0) == 0);
    result.push_back({ most, least == most && isUncut });
  }
  return result;
}

}

WholeMesh wholeMesh(vtkUnstructuredGrid* grid, Execution& execution)
{
  GridFaces faces(grid, execution);
  turnOutward(faces.cells, faces.points.data(), execution);
  FaceList list = listFaces(faces.cells, faces.points.size() / 3, Clashes::Refused, execution);
  std::vector<vtkIdType> boundaryOf;
  const BoundaryKnowledge known = readBoundaries(grid, faces, list, boundaryOf, execution);
  std::vector<FoamPatch> patches;
  if (known == BoundaryKnowledge::All)
  {
    const auto [boundaries, counts] = sortByBoundary(boundaryOf, list);
    patches = patchesOf(grid, boundaries, counts);
  }
  else if (!boundaryOf.empty())
  {
    patches.push_back({ "boundary", boundaryOf.size() });
  }
  FoamRegions regions = regionsOf(grid, faces.cellOf, RegionsAsked::WithCells);
  FoamMesh mesh =
    foamMesh(std::move(faces.points), faces.cells, std::move(list), std::move(patches), execution);
  if (grid->GetFieldData()->HasArray(
        "IsotropicLevels")) // levels take a third of the time of writing
  {
    mesh.boxLevels = boxLevelsOf(grid, faces.cellOf);
    mesh = withThirdEdges(std::move(mesh));
  }
  return { std::move(mesh), std::move(regions), known == BoundaryKnowledge::Unfit };
}

FoamPiece foamPiece(vtkUnstructuredGrid* grid, Execution& execution)
{
  if (grid->GetNumberOfCells() == 0)
  {
    throw Error(Fault::BadMesh,
      "A piece of the mesh has no cells, which OpenFOAM does not accept: write fewer pieces.");
  }
  GridFaces faces(grid, execution);
  turnOutward(faces.cells, faces.points.data(), execution);
  FaceList list = listFaces(faces.cells, faces.points.size() / 3, Clashes::Refused, execution);
  std::vector<vtkIdType> boundaryOf;
  if (readBoundaries(grid, faces, list, boundaryOf, execution) != BoundaryKnowledge::All)
  {
    throw Error(Fault::BadMesh,
      "Cells were changed after meshing: to write a decomposed case, save the output of Cartesian "
      "Mesher itself.");
  }
  const auto [boundaries, counts] = sortByBoundary(boundaryOf, list);
  FoamPiece piece{ {}, pointNumbers(grid, faces), firstCellOf(grid, faces), {},
    regionsOf(grid, faces.cellOf, RegionsAsked::AllOfTheMesh) };
  for (std::size_t i = 0; i < boundaries.size() && boundaries[i] != NoBoundary; ++i)
  {
    piece.boundaries.emplace_back(static_cast<std::int32_t>(boundaries[i]), counts[i]);
  }
  piece.mesh = foamMesh(std::move(faces.points), faces.cells, std::move(list), {}, execution);
  return piece;
}

}
