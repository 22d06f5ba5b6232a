// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/PolyMeshReader.h"

#include "Base/Error.h"
#include "OpenFoam/FoamListReader.h"

#include <algorithm>
#include <numeric>

namespace cartesian
{

namespace
{

// The four files.
struct Lists
{
  std::vector<double> points;
  std::vector<std::size_t> start; // of each face in `corners`, and the end
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> owner;
  std::vector<std::uint32_t> neighbour;

  std::size_t faceCount() const { return start.size() - 1; }
};

[[noreturn]] void refuse(const std::filesystem::path& folder, const std::string& what)
{
  throw Error(Fault::BadMesh,
    "The mesh in " + folder.string() + " does not fit together: " + what +
      ". Write all its files again with the program that made it.");
}

Lists readLists(const std::filesystem::path& folder)
{
  Lists lists;
  lists.points = FoamListReader(folder / "points").vectors();
  FoamListReader(folder / "faces").labelLists(lists.start, lists.corners);
  lists.owner = FoamListReader(folder / "owner").labels(lists.faceCount());
  lists.neighbour = FoamListReader(folder / "neighbour").labels(lists.faceCount());
  return lists;
}

// Returns the number of cells.
std::size_t check(const Lists& lists, const std::filesystem::path& folder)
{
  if (lists.owner.size() != lists.faceCount())
  {
    refuse(folder,
      std::to_string(lists.faceCount()) + " faces have " + std::to_string(lists.owner.size()) +
        " owners");
  }
  const auto largest = [](const std::vector<std::uint32_t>& labels) {
    return labels.empty() ? 0 : *std::max_element(labels.begin(), labels.end());
  };
  if (!lists.corners.empty() && largest(lists.corners) >= lists.points.size() / 3)
  {
    refuse(folder,
      "a face has the point " + std::to_string(largest(lists.corners)) + " of " +
        std::to_string(lists.points.size() / 3) + ", counted from 0");
  }
  for (std::size_t face = 0; face < lists.faceCount(); ++face)
  {
    const bool isOfOne =
      face < lists.neighbour.size() && lists.owner[face] == lists.neighbour[face];
    if (lists.start[face + 1] - lists.start[face] < 3 || isOfOne)
    {
      refuse(folder,
        "face " + std::to_string(face) +
          (isOfOne ? " has the same cell on both sides" : " has less than three points"));
    }
  }
  std::vector<bool> hasFace(lists.owner.size() + lists.neighbour.size());
  for (const std::vector<std::uint32_t>* const labels : { &lists.owner, &lists.neighbour })
  {
    for (const std::uint32_t cell : *labels)
    {
      if (cell < hasFace.size())
      {
        hasFace[cell] = true;
      }
    }
  }
  const auto cells =
    static_cast<std::size_t>(std::find(hasFace.begin(), hasFace.end(), false) - hasFace.begin());
  const std::uint32_t last = std::max(largest(lists.owner), largest(lists.neighbour));
  if (!lists.owner.empty() && last >= cells)
  {
    refuse(folder,
      "cell " + std::to_string(cells) + " has no face, but there is a cell " +
        std::to_string(last));
  }
  return cells;
}

// A face as one of its cells has it.
struct Side
{
  std::size_t face;
  bool isNeighbours;
};

// Of all cells in order, from `firstFace` on. `ofOwners`: where the owner's side of each face is.
std::vector<Side> sidesOfCells(
  const Lists& lists, RawVector<std::size_t>& firstFace, std::vector<std::uint32_t>& ofOwners)
{
  for (const std::vector<std::uint32_t>* const labels : { &lists.owner, &lists.neighbour })
  {
    for (const std::uint32_t cell : *labels)
    {
      ++firstFace[cell + 1];
    }
  }
  std::partial_sum(firstFace.begin(), firstFace.end(), firstFace.begin());
  RawVector<std::size_t> next = firstFace;
  std::vector<Side> sides(firstFace.back());
  for (std::size_t face = 0; face < lists.owner.size(); ++face)
  {
    std::size_t& place = next[lists.owner[face]];
    ofOwners.push_back(static_cast<std::uint32_t>(place));
    sides[place++] = { face, false };
    if (face < lists.neighbour.size())
    {
      sides[next[lists.neighbour[face]]++] = { face, true };
    }
  }
  return sides;
}

}

PolyMesh readPolyMesh(const std::filesystem::path& folder)
{
  Lists lists = readLists(folder);
  PolyMesh mesh;
  mesh.cells.firstFace.assign(check(lists, folder) + 1, 0);
  mesh.cells.firstCorner = { 0 };
  for (const Side& side : sidesOfCells(lists, mesh.cells.firstFace, mesh.faces.face))
  {
    RawVector<std::uint32_t>& corners = mesh.cells.corners;
    corners.insert(corners.end(),
      lists.corners.begin() + static_cast<std::ptrdiff_t>(lists.start[side.face]),
      lists.corners.begin() + static_cast<std::ptrdiff_t>(lists.start[side.face + 1]));
    if (side.isNeighbours) // the same first corner, as everywhere
    {
      std::reverse(corners.begin() + static_cast<std::ptrdiff_t>(mesh.cells.firstCorner.back() + 1),
        corners.end());
    }
    mesh.cells.firstCorner.push_back(corners.size());
  }
  mesh.points = std::move(lists.points);
  mesh.faces.owner = std::move(lists.owner);
  mesh.faces.neighbour = std::move(lists.neighbour);
  return mesh;
}

}
