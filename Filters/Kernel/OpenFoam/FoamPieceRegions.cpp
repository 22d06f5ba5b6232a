// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/FoamPieceRegions.h"

#include <algorithm>
#include <cstdlib>

namespace cartesian
{

namespace
{

// With the addressing of the mesh of all regions.
FoamMesh cutOut(const CompletePiece& piece, std::uint32_t region)
{
  return meshOfRegion(piece.mesh, piece.regions, separateMeshes(piece.regions), region);
}

// Calls visit(patch, first face, end) of patches in order.
template <class Visitor>
void forEachPatch(const FoamMesh& mesh, Visitor&& visit)
{
  std::size_t face = mesh.neighbour.size();
  for (const FoamPatch& patch : mesh.patches)
  {
    visit(patch, face, face + patch.count);
    face += patch.count;
  }
}

bool isBetweenProcesses(const FoamPatch& patch)
{
  return patch.processes.other >= 0;
}

RegionLabels labelsOf(const FoamMesh& mesh)
{
  const FoamAddressing& addressing = *mesh.addressing;
  const auto append = [&](std::vector<std::int32_t>& labels, std::size_t begin, std::size_t end) {
    for (std::size_t face = begin; face < end; ++face)
    {
      labels.push_back(std::abs(addressing.faces[face]) - 1);
    }
  };
  RegionLabels result{ LabelRuns(addressing.cells), LabelRuns(addressing.points), {}, {} };
  std::vector<std::int32_t> inner;
  append(inner, 0, mesh.neighbour.size());
  forEachPatch(mesh, [&](const FoamPatch& patch, std::size_t begin, std::size_t end) {
    std::vector<std::int32_t> ofPatch;
    const bool isInner = isBetweenProcesses(patch);
    append(isInner ? inner : ofPatch, begin, end);
    if (!isInner)
    {
      result.patches.emplace_back(std::move(ofPatch));
    }
  });
  result.innerFaces = LabelRuns(std::move(inner));
  return result;
}

void renumber(std::vector<std::int32_t>& labels, const LabelRuns& among)
{
  for (std::int32_t& label : labels)
  {
    label = static_cast<std::int32_t>(among.countBelow(label));
  }
}

void renumberFaces(FoamMesh& mesh, const RegionLabels& ofAll)
{
  const auto renumber = [&](std::size_t begin, std::size_t end, const LabelRuns& among,
                          std::size_t before) {
    for (std::size_t face = begin; face < end; ++face)
    {
      std::int32_t& label = mesh.addressing->faces[face];
      const auto number = static_cast<std::int32_t>(before + among.countBelow(std::abs(label) - 1));
      label = label < 0 ? -number - 1 : number + 1;
    }
  };
  renumber(0, mesh.neighbour.size(), ofAll.innerFaces, 0);
  std::size_t before = ofAll.innerFaces.size();
  auto ofPatch = ofAll.patches.begin();
  forEachPatch(mesh, [&](const FoamPatch& patch, std::size_t begin, std::size_t end) {
    if (isBetweenProcesses(patch))
    {
      renumber(begin, end, ofAll.innerFaces, 0);
      return;
    }
    renumber(begin, end, *ofPatch, before);
    before += (ofPatch++)->size();
  });
}

// Without those that no piece has faces of.
void choosePatches(FoamMesh& mesh, const RegionLabels& ofAll)
{
  std::vector<FoamPatch> patches;
  std::vector<std::int32_t> numbers;
  auto ofPatch = ofAll.patches.begin();
  for (FoamPatch& patch : mesh.patches)
  {
    const bool isShared = isBetweenProcesses(patch);
    if (isShared || (ofPatch++)->size() > 0)
    {
      numbers.push_back(isShared ? -1 : static_cast<std::int32_t>(patches.size()));
      patches.push_back(std::move(patch));
    }
  }
  mesh.patches = std::move(patches);
  mesh.addressing->patches = std::move(numbers);
}

}

void RegionLabels::add(const RegionLabels& ofOtherPiece)
{
  cells.add(ofOtherPiece.cells);
  points.add(ofOtherPiece.points);
  innerFaces.add(ofOtherPiece.innerFaces);
  patches.resize(ofOtherPiece.patches.size());
  for (std::size_t i = 0; i < patches.size(); ++i)
  {
    patches[i].add(ofOtherPiece.patches[i]);
  }
}

std::vector<RegionLabels> labelsOfRegions(const CompletePiece& piece)
{
  std::vector<RegionLabels> result;
  for (std::uint32_t region = 0; region < piece.regions.names.size(); ++region)
  {
    result.push_back(labelsOf(cutOut(piece, region)));
  }
  return result;
}

std::vector<double> toNumbers(const std::vector<RegionLabels>& regions)
{
  std::vector<double> numbers;
  for (const RegionLabels& region : regions)
  {
    region.cells.appendTo(numbers);
    region.points.appendTo(numbers);
    region.innerFaces.appendTo(numbers);
    numbers.push_back(static_cast<double>(region.patches.size()));
    for (const LabelRuns& patch : region.patches)
    {
      patch.appendTo(numbers);
    }
  }
  return numbers;
}

std::vector<RegionLabels> regionLabels(const std::vector<double>& numbers)
{
  std::vector<RegionLabels> regions;
  for (auto next = numbers.begin(); next != numbers.end();)
  {
    RegionLabels& region = regions.emplace_back();
    region.cells = LabelRuns::takeFrom(next);
    region.points = LabelRuns::takeFrom(next);
    region.innerFaces = LabelRuns::takeFrom(next);
    region.patches.resize(static_cast<std::size_t>(*next++));
    std::generate(
      region.patches.begin(), region.patches.end(), [&next] { return LabelRuns::takeFrom(next); });
  }
  return regions;
}

FoamMesh pieceOfRegion(const CompletePiece& piece, std::uint32_t region, const RegionLabels& ofAll)
{
  FoamMesh mesh = cutOut(piece, region);
  renumber(mesh.addressing->cells, ofAll.cells);
  renumber(mesh.addressing->points, ofAll.points);
  renumberFaces(mesh, ofAll);
  choosePatches(mesh, ofAll);
  return mesh;
}

}
