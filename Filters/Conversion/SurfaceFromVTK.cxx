// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceFromVTK.h"

#include "Base/Error.h"
#include "Lattice/Vector.h"
#include "Repair/SurfaceDefects.h"
#include "SurfaceBlocks.h"
#include "SurfacePolygons.h"
#include "Utf8.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>

namespace cartesian
{

namespace
{

// Which lines are sharp edges; null: not known.
vtkDataArray* sharpEdgesOf(vtkPolyData* block)
{
  vtkDataArray* array = block->GetCellData()->GetArray(SharpEdgeArray);
  return array && array->GetNumberOfComponents() == 1 &&
      array->GetNumberOfTuples() == block->GetNumberOfCells()
    ? array
    : nullptr;
}

// The boundary that a cell array gives for `cell`, which the user knows as `userCell`.
std::int32_t boundaryNumber(vtkDataArray* array, vtkIdType cell, vtkIdType userCell)
{
  const double value = array->GetComponent(cell, 0);
  if (!(std::abs(value) <= std::numeric_limits<std::int32_t>::max()))
  {
    throw Error(Fault::MissingArray,
      std::string("Boundary Array \"") + array->GetName() + "\" holds " + number(value) +
        " at cell " + std::to_string(userCell) +
        ", which is not a valid boundary number: correct it, or choose another array.");
  }
  return static_cast<std::int32_t>(std::lround(value));
}

// Blocks have the names of their files.
std::string withoutSuffix(const std::string& name)
{
  for (const char* suffix : { ".stl", ".obj", ".ply", ".vtp", ".vtk" })
  {
    if (name.size() > std::strlen(suffix) &&
      vtksys::SystemTools::StringEndsWith(vtksys::SystemTools::LowerCase(name), suffix))
    {
      return name.substr(0, name.size() - std::strlen(suffix));
    }
  }
  return name;
}

// The array that numbers the boundaries of a surface that is no blocks, where none is chosen; or null.
const char* boundaryArrayOf(vtkPolyData* surface)
{
  for (const char* name : { StlSolids, BoundaryIdArray })
  {
    if (surface->GetCellData()->HasArray(name))
    {
      return name;
    }
  }
  return nullptr;
}

}

SurfaceFromVTK::SurfaceFromVTK(vtkDataObject* input, const std::string& boundaryArray,
  RegionSource regionsFrom, const std::string& regionArray)
{
  const std::vector<SurfaceBlock> blocks = surfaceBlocks(input);
  const bool isWhole = blocks.front().surface == input;
  const bool isChosen = !boundaryArray.empty() && boundaryArray != AutomaticBoundaries;
  const char* const found = isWhole ? boundaryArrayOf(blocks.front().surface) : nullptr;
  names_ = isWhole ? boundaryNames(input) : BoundaryNames();
  for (const SurfaceBlock& block : blocks)
  {
    const std::size_t pointsBefore = points_.size() / 3;
    const bool isDivided = allTriangles(block.surface);
    readTriangles(block.surface, isDivided);
    readSharpEdges(block.surface, pointsBefore);
    readOpenBodies(block.surface);
    if (!isDivided)
    {
      findUndivided(block.surface);
    }
    if (isChosen || found)
    {
      readBoundaries(block.surface, isChosen ? boundaryArray : found);
    }
    else if (isWhole)
    {
      boundary_.resize(cells_.size(), 0);
    }
    else
    {
      readBoundaryOfBlock(block, &block - blocks.data(), regionsFrom);
    }
    if (regionsFrom == RegionSource::Blocks)
    {
      addRegion(block.topName.empty() ? "region_" + std::to_string(block.top + 1)
                                      : withoutSuffix(block.topName));
    }
    else if (regionsFrom == RegionSource::Array)
    {
      readRegions(block.surface, regionArray);
    }
    cellsBefore_ += block.surface->GetNumberOfCells();
  }
  for (std::size_t t = 0; t < boundary_.size(); ++t)
  {
    const std::int32_t boundary = boundary_[t];
    const bool isNext = t == 0 || boundary != boundary_[t - 1];
    if (isNext && names_.count(boundary) == 0)
    {
      names_.emplace(boundary, unnamedBoundary(boundary));
    }
  }
}

// A block is a boundary of its name; of a region or a solid, its own boundaries come first.
void SurfaceFromVTK::readBoundaryOfBlock(
  const SurfaceBlock& block, std::ptrdiff_t number, RegionSource regionsFrom)
{
  const std::string name =
    block.name.empty() ? "block_" + std::to_string(number) : withoutSuffix(block.name);
  if (regionsFrom == RegionSource::Blocks ||
    block.surface->GetFieldData()->HasArray(SolidNameField))
  {
    readBoundariesByName(block.surface, name);
  }
  if (boundary_.size() < cells_.size())
  {
    boundary_.resize(cells_.size(), numberOf(name));
  }
}

void SurfaceFromVTK::readTriangles(vtkPolyData* block, bool isDivided)
{
  const std::size_t pointsBefore = points_.size() / 3;
  if (pointsBefore + static_cast<std::size_t>(block->GetNumberOfPoints()) >=
    std::numeric_limits<std::uint32_t>::max())
  {
    throw Error(Fault::BadParameter,
      "The surface has more points than can be numbered in 32 bits: coarsen it.");
  }
  vtkSmartPointer<vtkPolyData> surface = block;
  vtkIdTypeArray* ids = nullptr;
  if (!isDivided)
  {
    surface = triangulated(block);
    ids = vtkIdTypeArray::SafeDownCast(surface->GetCellData()->GetArray(CellIds));
  }
  const std::vector<bool> hidden = hiddenCells(block);
  const vtkIdType before = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  auto cell = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  triangles_.reserve(triangles_.size() + 3 * static_cast<std::size_t>(surface->GetNumberOfPolys()));
  cells_.reserve(cells_.size() + static_cast<std::size_t>(surface->GetNumberOfPolys()));
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cell->GetCurrentCell(size, corners);
    const vtkIdType place = before + cell->GetCurrentCellId();
    const vtkIdType id = ids ? ids->GetValue(place) : place;
    // A polygon of fewer corners has no area.
    if (size != 3 || (!hidden.empty() && hidden[static_cast<std::size_t>(id)]))
    {
      continue;
    }
    for (int i = 0; i < 3; ++i)
    {
      triangles_.push_back(
        static_cast<std::uint32_t>(pointsBefore + static_cast<std::size_t>(corners[i])));
    }
    cells_.push_back(cellsBefore_ + id);
  }
  points_.resize(points_.size() + 3 * static_cast<std::size_t>(surface->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    surface->GetPoint(i, points_.data() + 3 * (pointsBefore + static_cast<std::size_t>(i)));
  }
}

void SurfaceFromVTK::readSharpEdges(vtkPolyData* block, std::size_t pointsBefore)
{
  vtkDataArray* sharp = sharpEdgesOf(block);
  if (sharp)
  {
    knowsEdges_.resize(cells_.size());
    for (auto t = cells_.size(); t > 0 && cells_[t - 1] >= cellsBefore_; --t)
    {
      knowsEdges_[t - 1] = sharp->GetComponent(cells_[t - 1] - cellsBefore_, 0) == 0 ? 1 : 0;
    }
  }
  else if (!knowsEdges_.empty())
  {
    knowsEdges_.resize(cells_.size());
  }
  const std::vector<bool> hidden = sharp ? hiddenCells(block) : std::vector<bool>();
  vtkIdType id = block->GetNumberOfVerts();
  auto line = vtk::TakeSmartPointer(block->GetLines()->NewIterator());
  for (line->GoToFirstCell(); sharp && !line->IsDoneWithTraversal(); line->GoToNextCell(), ++id)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    line->GetCurrentCell(size, points);
    const bool there = hidden.empty() || !hidden[static_cast<std::size_t>(id)];
    for (vtkIdType i = 1; there && sharp->GetComponent(id, 0) != 0 && i < size; ++i)
    {
      for (const vtkIdType point : { points[i - 1], points[i] })
      {
        sharpEdges_.push_back(
          static_cast<std::uint32_t>(pointsBefore + static_cast<std::size_t>(point)));
      }
    }
  }
}

void SurfaceFromVTK::readOpenBodies(vtkPolyData* block)
{
  vtkDataArray* const open = block->GetCellData()->GetArray(OpenBodyArray);
  const bool isKnown = open && open->GetNumberOfComponents() == 1 &&
    open->GetNumberOfTuples() == block->GetNumberOfCells();
  if (!isKnown && isOfOpenBody_.empty())
  {
    return;
  }
  isOfOpenBody_.resize(cells_.size());
  for (auto t = cells_.size(); isKnown && t > 0 && cells_[t - 1] >= cellsBefore_; --t)
  {
    isOfOpenBody_[t - 1] = open->GetComponent(cells_[t - 1] - cellsBefore_, 0) == 0 ? 0 : 1;
  }
}

// VTK leaves polygons that cross or touch themselves out, or a part of them.
void SurfaceFromVTK::findUndivided(vtkPolyData* block)
{
  std::vector<std::size_t> made(static_cast<std::size_t>(block->GetNumberOfCells()));
  for (auto cell = cells_.rbegin(); cell != cells_.rend() && *cell >= cellsBefore_; ++cell)
  {
    ++made[static_cast<std::size_t>(*cell - cellsBefore_)];
  }
  const std::vector<bool> hidden = hiddenCells(block);
  auto id = static_cast<std::size_t>(block->GetNumberOfVerts() + block->GetNumberOfLines());
  auto cell = vtk::TakeSmartPointer(block->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell(), ++id)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cell->GetCurrentCell(size, corners);
    const bool there = hidden.empty() || !hidden[id];
    if (there && size > 3 && !isFlat(block->GetPoints(), size, corners) &&
      made[id] + 2 < differentCorners(block->GetPoints(), size, corners))
    {
      undivided_.push_back(cellsBefore_ + static_cast<vtkIdType>(id));
    }
  }
}

std::string SurfaceFromVTK::describeLeftOut() const
{
  const std::string undivided = describeUndivided();
  const std::string open = leftOut_.describe(names_);
  return undivided + (undivided.empty() || open.empty() ? "" : "\n") + open;
}

void SurfaceFromVTK::addGaps(ClosedGaps closed)
{
  points_.insert(points_.end(), closed.added.begin(), closed.added.end());
  for (const ClosedGap& gap : closed.gaps)
  {
    const std::int32_t number = numberOfAdded(nameOfGap(&gap - closed.gaps.data()));
    for (const auto& triangle : gap.triangles)
    {
      addTriangle(triangle, number, -1);
      if (!region_.empty())
      {
        region_.push_back(gap.region);
      }
    }
  }
  for (const std::uint32_t pane : closed.panes)
  {
    isSheet_.resize(cells_.size());
    isSheet_[pane] = 1;
  }
  replace(closed);
  gaps_ = std::move(closed);
}

// Region apart.
void SurfaceFromVTK::addTriangle(
  const std::array<std::uint32_t, 3>& points, std::int32_t boundary, vtkIdType cell)
{
  triangles_.insert(triangles_.end(), points.begin(), points.end());
  boundary_.push_back(boundary);
  cells_.push_back(cell);
  for (std::vector<std::uint8_t>* flags : { &knowsEdges_, &isOfOpenBody_, &isSheet_ })
  {
    flags->resize(flags->empty() ? 0 : cells_.size());
  }
}

// A triangle that stays as it is keeps what is known of its edges.
void SurfaceFromVTK::replace(const ClosedGaps& closed)
{
  std::vector<std::uint8_t> isReplaced(cells_.size());
  for (const std::uint32_t t : closed.replaced)
  {
    isReplaced[t] = 1;
  }
  for (const ClosedGaps::Piece& piece : closed.pieces)
  {
    const std::size_t given = piece.given;
    std::array<std::uint32_t, 3> before;
    std::copy_n(triangles_.begin() + std::ptrdiff_t(3 * given), 3, before.begin());
    addTriangle(piece.points, boundary_[given], cells_[given]);
    if (!knowsEdges_.empty() &&
      std::is_permutation(before.begin(), before.end(), piece.points.begin()))
    {
      knowsEdges_.back() = knowsEdges_[given];
    }
    if (!region_.empty())
    {
      region_.push_back(region_[given]);
    }
  }
  isReplaced.resize(cells_.size());
  drop(isReplaced);
}

std::string SurfaceFromVTK::describeUndivided() const
{
  if (undivided_.empty())
  {
    return "";
  }
  const std::string first = std::to_string(undivided_.front());
  return undivided_.size() == 1
    ? "1 polygon, cell " + first +
      ", crosses or touches itself and is left out at least in part: correct it, or divide it into "
      "triangles."
    : std::to_string(undivided_.size()) + " polygons, the first of them cell " + first +
      ", cross or touch themselves and are left out at least in part: correct them, or divide them "
      "into triangles.";
}

void SurfaceFromVTK::readBoundaries(vtkPolyData* block, const std::string& name)
{
  vtkAbstractArray* array = block->GetCellData()->GetAbstractArray(name.c_str());
  auto* strings = vtkStringArray::SafeDownCast(array);
  auto* numbers = vtkDataArray::SafeDownCast(array);
  if ((!strings && !numbers) || array->GetNumberOfComponents() != 1 ||
    array->GetNumberOfTuples() != block->GetNumberOfCells())
  {
    throw Error(Fault::MissingArray,
      "Boundary Array \"" + name +
        "\" is not a cell array of the surface with one number or string per cell: choose another, "
        "or none.");
  }
  for (std::size_t t = boundary_.size(); t < cells_.size(); ++t)
  {
    const vtkIdType cell = cells_[t] - cellsBefore_;
    boundary_.push_back(
      strings ? numberOf(strings->GetValue(cell)) : boundaryNumber(numbers, cell, cells_[t]));
  }
}

// Those that the block numbers and names by itself: other blocks may use the same numbers for others.
void SurfaceFromVTK::readBoundariesByName(vtkPolyData* block, const std::string& name)
{
  const BoundaryNames own = boundaryNames(block);
  const char* const array = boundaryArrayOf(block);
  vtkDataArray* numbers = array ? block->GetCellData()->GetArray(array) : nullptr;
  if (!numbers || own.empty())
  {
    return;
  }
  for (std::size_t t = boundary_.size(); t < cells_.size(); ++t)
  {
    const auto found = own.find(boundaryNumber(numbers, cells_[t] - cellsBefore_, cells_[t]));
    boundary_.push_back(numberOf(found == own.end() ? name : found->second));
  }
}

// Triangles read since the last are of this region: a new one, unless it has the name of one that is there.
void SurfaceFromVTK::addRegion(const std::string& given)
{
  const std::string name = toUtf8(given);
  const auto found = std::find(regionNames_.begin(), regionNames_.end(), name);
  region_.resize(
    cells_.size(), FirstRegion + static_cast<std::int32_t>(found - regionNames_.begin()));
  if (found == regionNames_.end())
  {
    regionNames_.push_back(name);
  }
}

void SurfaceFromVTK::readRegions(vtkPolyData* block, const std::string& name)
{
  vtkAbstractArray* array = block->GetCellData()->GetAbstractArray(name.c_str());
  if (!array || array->GetNumberOfComponents() != 1 ||
    array->GetNumberOfTuples() != block->GetNumberOfCells())
  {
    throw Error(Fault::MissingArray,
      "Region Array \"" + name +
        "\" is not a cell array of the surface with one number or string per cell: choose another, "
        "or set Regions From to One or Blocks.");
  }
  auto* strings = vtkStringArray::SafeDownCast(array);
  std::map<std::string, std::int32_t> known;
  for (std::size_t i = 0; i < regionNames_.size(); ++i)
  {
    known[regionNames_[i]] = FirstRegion + static_cast<std::int32_t>(i);
  }
  for (std::size_t t = region_.size(); t < cells_.size(); ++t)
  {
    const vtkIdType cell = cells_[t] - cellsBefore_;
    const std::string value = strings ? toUtf8(strings->GetValue(cell))
                                      : "region_" + array->GetVariantValue(cell).ToString();
    const auto [at, isNew] =
      known.emplace(value, FirstRegion + static_cast<std::int32_t>(regionNames_.size()));
    if (isNew)
    {
      regionNames_.push_back(value);
    }
    region_.push_back(at->second);
  }
}

void SurfaceFromVTK::leaveOutOpenBodies(const std::set<std::int32_t>& baffles)
{
  const bool isAllOpen =
    std::find(isOfOpenBody_.begin(), isOfOpenBody_.end(), 0) == isOfOpenBody_.end();
  if (isAllOpen)
  {
    return;
  }
  const SurfaceView all = view();
  std::vector<std::uint8_t> isLeftOut = isOfOpenBody_;
  for (std::size_t t = 0; t < isLeftOut.size(); ++t)
  {
    isLeftOut[t] = isLeftOut[t] != 0 && baffles.count(boundary_[t]) == 0 ? 1 : 0;
    if (isLeftOut[t] != 0)
    {
      leftOut_.add(boundary_[t], all.corners(t));
    }
  }
  placeBaffles();
  drop(isLeftOut);
  dropEmptyRegions();
}

// Open bodies in blocks of their own are in no region yet.
void SurfaceFromVTK::placeBaffles()
{
  std::set<std::int32_t> bounded;
  for (std::size_t t = 0; t < region_.size(); ++t)
  {
    if (isOfOpenBody_[t] == 0)
    {
      bounded.insert(region_[t]);
    }
  }
  std::vector<std::int32_t> placed = region_;
  for (std::size_t t = 0; t < region_.size(); ++t)
  {
    if (bounded.count(region_[t]) == 0)
    {
      const SurfaceView all = view();
      const std::array<Vector, 3> c = all.corners(t);
      placed[t] = regionAround(all, isOfOpenBody_, scaled(plus(plus(c[0], c[1]), c[2]), 1.0 / 3));
    }
  }
  region_ = std::move(placed);
}

void SurfaceFromVTK::drop(const std::vector<std::uint8_t>& triangles)
{
  const auto keep = [&](auto& values, std::size_t size) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      if (triangles[i / size] == 0)
      {
        values[kept++] = values[i];
      }
    }
    values.resize(kept);
  };
  keep(triangles_, 3);
  keep(cells_, 1);
  keep(knowsEdges_, 1);
  keep(boundary_, 1);
  keep(region_, 1);
  keep(isOfOpenBody_, 1);
  keep(isSheet_, 1);
}

void SurfaceFromVTK::dropEmptyRegions()
{
  std::vector<std::string> names;
  std::vector<std::int32_t> becomes;
  for (std::size_t i = 0; i < regionNames_.size(); ++i)
  {
    const std::int32_t region = FirstRegion + static_cast<std::int32_t>(i);
    becomes.push_back(FirstRegion + static_cast<std::int32_t>(names.size()));
    if (std::find(region_.begin(), region_.end(), region) != region_.end())
    {
      names.push_back(regionNames_[i]);
    }
  }
  for (std::int32_t& region : region_)
  {
    region = becomes[static_cast<std::size_t>(region - FirstRegion)];
  }
  regionNames_ = std::move(names);
}

// A boundary that no triangle has may have the name of one that is there.
std::int32_t SurfaceFromVTK::numberOfAdded(const std::string& name)
{
  const auto same = std::find_if(
    names_.begin(), names_.end(), [&](const auto& named) { return named.second == name; });
  const std::int32_t next = names_.empty() ? 0 : std::max(0, names_.rbegin()->first + 1);
  const std::int32_t number = same == names_.end() ? next : same->first;
  names_.emplace(number, name);
  return number;
}

void SurfaceFromVTK::addSides(const std::array<std::string, 6>& names)
{
  std::transform(names.begin(), names.end(), sides_.begin(),
    [&](const std::string& name) { return numberOfAdded(name); });
}

void SurfaceFromVTK::rename(const BoundaryNames& given)
{
  std::map<std::string, std::int32_t> numbers;
  for (const auto& [number, name] : names_)
  {
    if (given.count(number) == 0)
    {
      numbers.emplace(name, number);
    }
  }
  std::map<std::int32_t, std::int32_t> becomes;
  for (const auto& [number, name] : given)
  {
    becomes[number] = numbers.emplace(name, number).first->second;
    names_.erase(number);
  }
  for (const auto& [name, number] : numbers)
  {
    names_.emplace(number, name);
  }
  for (std::int32_t& number : boundary_)
  {
    const auto other = becomes.find(number);
    number = other == becomes.end() ? number : other->second;
  }
}

std::int32_t SurfaceFromVTK::addBack(std::int32_t boundary)
{
  return numberOfAdded(names_.at(boundary) + "_back");
}

std::int32_t SurfaceFromVTK::numberOf(const std::string& given)
{
  const std::string name = toUtf8(given);
  const auto [place, isNew] = numbers_.emplace(name, static_cast<std::int32_t>(numbers_.size()));
  if (isNew)
  {
    names_[place->second] = name;
  }
  return place->second;
}

SurfaceView SurfaceFromVTK::view() const
{
  return { points_.data(), points_.size() / 3, triangles_.data(), cells_.size(), boundary_.data(),
    cells_.data(), regionNames_.size() > 1 ? region_.data() : nullptr, &regionNames_,
    sharpEdges_.data(), sharpEdges_.size() / 2, knowsEdges_.empty() ? nullptr : knowsEdges_.data(),
    isSheet_.empty() ? nullptr : isSheet_.data() };
}

}
