// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/FoamRegions.h"

#include <algorithm>
#include <limits>

namespace cartesian
{

namespace
{

constexpr std::uint32_t None = std::numeric_limits<std::uint32_t>::max();

// Faces of the whole mesh that become a patch.
struct Part
{
  FoamPatch patch;
  std::vector<std::size_t> faces;
};

class RegionMesh
{
public:
  RegionMesh(const FoamMesh& whole, const FoamRegions& regions, std::uint32_t region)
    : whole_(whole)
    , regions_(regions)
    , region_(region)
  {
  }

  FoamMesh run()
  {
    numberCells();
    addInnerFaces();
    for (const Part& part : boundaries())
    {
      addPatch(part);
    }
    for (const Part& part : interfaces())
    {
      addPatch(part);
    }
    numberPoints();
    return std::move(mesh_);
  }

private:
  bool isOurs(std::uint32_t cell) const { return regions_.ofCell[cell] == region_; }

  void numberCells()
  {
    number_.assign(whole_.cellCount, None);
    mesh_.cellCount = 0;
    for (std::size_t cell = 0; cell < whole_.cellCount; ++cell)
    {
      if (isOurs(static_cast<std::uint32_t>(cell)))
      {
        number_[cell] = static_cast<std::uint32_t>(mesh_.cellCount++);
      }
    }
  }

  // Seen from our cell.
  void addFace(std::size_t face)
  {
    const bool turned = !isOurs(whole_.owner[face]);
    const auto first = static_cast<std::ptrdiff_t>(mesh_.corners.size());
    mesh_.corners.insert(mesh_.corners.end(), whole_.corners.data() + whole_.start[face],
      whole_.corners.data() + whole_.start[face + 1]);
    if (turned)
    {
      std::reverse(mesh_.corners.begin() + first, mesh_.corners.end());
    }
    mesh_.start.push_back(mesh_.corners.size());
    mesh_.owner.push_back(number_[turned ? whole_.neighbour[face] : whole_.owner[face]]);
  }

  void addInnerFaces()
  {
    mesh_.start = { 0 };
    for (std::size_t face = 0; face < whole_.neighbour.size(); ++face)
    {
      if (isOurs(whole_.owner[face]) && isOurs(whole_.neighbour[face]))
      {
        addFace(face);
        mesh_.neighbour.push_back(number_[whole_.neighbour[face]]);
      }
    }
  }

  void addPatch(const Part& part)
  {
    if (part.faces.empty())
    {
      return;
    }
    for (const std::size_t face : part.faces)
    {
      addFace(face);
    }
    mesh_.patches.push_back(part.patch);
    mesh_.patches.back().count = part.faces.size();
  }

  std::vector<Part> boundaries() const
  {
    std::vector<Part> parts;
    std::size_t face = whole_.neighbour.size();
    for (const FoamPatch& patch : whole_.patches)
    {
      parts.push_back({ patch, {} });
      for (const std::size_t end = face + patch.count; face < end; ++face)
      {
        if (isOurs(whole_.owner[face]))
        {
          parts.back().faces.push_back(face);
        }
      }
    }
    return parts;
  }

  std::vector<Part> interfaces() const
  {
    std::vector<Part> parts;
    for (std::uint32_t other = 0; other < regions_.names.size(); ++other)
    {
      const FoamSample sample{ regions_.names[other], nameOf(other, region_) };
      parts.push_back({ { nameOf(region_, other), 0, {}, sample }, {} });
    }
    for (std::size_t face = 0; face < whole_.neighbour.size(); ++face)
    {
      const std::uint32_t owner = whole_.owner[face];
      const std::uint32_t neighbour = whole_.neighbour[face];
      if (isOurs(owner) != isOurs(neighbour))
      {
        parts[regions_.ofCell[isOurs(owner) ? neighbour : owner]].faces.push_back(face);
      }
    }
    return parts;
  }

  // Of the patch of `from` that faces `to`, unlike all boundaries.
  std::string nameOf(std::uint32_t from, std::uint32_t to) const
  {
    std::string name = regions_.names[from] + "_to_" + regions_.names[to];
    while (std::any_of(whole_.patches.begin(), whole_.patches.end(),
      [&](const FoamPatch& patch) { return patch.name == name; }))
    {
      name += "_";
    }
    return name;
  }

  void numberPoints()
  {
    std::vector<std::uint32_t> number(whole_.points.size() / 3, None);
    for (const std::uint32_t point : mesh_.corners)
    {
      number[point] = 0;
    }
    std::uint32_t count = 0;
    for (std::size_t point = 0; point < number.size(); ++point)
    {
      if (number[point] != None)
      {
        number[point] = count++;
        const double* const at = whole_.points.data() + 3 * point;
        mesh_.points.insert(mesh_.points.end(), at, at + 3);
      }
    }
    for (std::uint32_t& point : mesh_.corners)
    {
      point = number[point];
    }
  }

  const FoamMesh& whole_;
  const FoamRegions& regions_;
  std::uint32_t region_;
  std::vector<std::uint32_t> number_; // of each cell of ours
  FoamMesh mesh_{};
};

}

FoamMesh meshOfRegion(const FoamMesh& whole, const FoamRegions& regions, std::uint32_t region)
{
  return RegionMesh(whole, regions, region).run();
}

}
