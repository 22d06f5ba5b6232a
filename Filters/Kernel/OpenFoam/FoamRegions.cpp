// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/FoamRegions.h"

#include "Base/Error.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

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
  std::vector<bool> isTurned = {}; // seen from the neighbour; empty: none
};

class RegionMesh
{
public:
  RegionMesh(const FoamMesh& whole, const FoamRegions& regions, const FoamZoning& zoning,
    std::uint32_t region)
    : whole_(whole)
    , regions_(regions)
    , zoning_(zoning)
    , region_(region)
  {
  }

  FoamMesh run()
  {
    numberCells();
    addInnerFaces();
    for (const std::vector<Part>& parts :
      { boundaries(), interfaces(), pairs(), sharedBoundaries() })
    {
      std::for_each(parts.begin(), parts.end(), [this](const Part& part) { addPatch(part); });
    }
    numberPoints();
    addZones();
    return std::move(mesh_);
  }

private:
  std::uint32_t meshOf(std::uint32_t cell) const { return zoning_.meshOf[regions_.ofCell[cell]]; }

  bool isOurs(std::uint32_t cell) const { return meshOf(cell) == region_; }

  bool isPiece() const { return whole_.addressing.has_value(); }

  // The mesh of the cell behind a face of a patch between processes, which come last.
  std::uint32_t meshBeyond(std::size_t face) const
  {
    const std::size_t fromEnd = whole_.owner.size() - face;
    return zoning_.meshOf[regions_.beyond[regions_.beyond.size() - fromEnd]];
  }

  // Whether other processes have the cells behind its faces, of this mesh or of another.
  static bool isShared(const FoamPatch& patch) { return patch.processes.other >= 0; }

  // Cells with inner faces between them are of one.
  std::uint32_t partOf(std::uint32_t cell) const
  {
    return zoning_.border == ZoneBorder::Pair ? regions_.ofCell[cell] : meshOf(cell);
  }

  void numberCells()
  {
    number_.assign(whole_.cellCount, None);
    mesh_.cellCount = 0;
    if (isPiece())
    {
      mesh_.addressing.emplace();
    }
    for (std::size_t cell = 0; cell < whole_.cellCount; ++cell)
    {
      if (isOurs(static_cast<std::uint32_t>(cell)))
      {
        number_[cell] = static_cast<std::uint32_t>(mesh_.cellCount++);
        if (isPiece())
        {
          mesh_.addressing->cells.push_back(whole_.addressing->cells[cell]);
        }
        if (!whole_.boxLevels.empty())
        {
          mesh_.boxLevels.push_back(whole_.boxLevels[cell]);
        }
      }
    }
  }

  // Seen from the owner, or from the neighbour.
  void addFace(std::size_t face, bool turned)
  {
    const auto first = static_cast<std::ptrdiff_t>(mesh_.corners.size());
    mesh_.corners.insert(mesh_.corners.end(), whole_.corners.data() + whole_.start[face],
      whole_.corners.data() + whole_.start[face + 1]);
    if (turned)
    {
      std::reverse(mesh_.corners.begin() + first, mesh_.corners.end());
    }
    mesh_.start.push_back(mesh_.corners.size());
    mesh_.owner.push_back(number_[turned ? whole_.neighbour[face] : whole_.owner[face]]);
    if (isPiece())
    {
      mesh_.addressing->faces.push_back(whole_.addressing->faces[face]);
    }
  }

  void addInnerFaces()
  {
    mesh_.start = { 0 };
    for (std::size_t face = 0; face < whole_.neighbour.size(); ++face)
    {
      const std::uint32_t owner = whole_.owner[face];
      const std::uint32_t neighbour = whole_.neighbour[face];
      if (isOurs(owner) && partOf(owner) == partOf(neighbour))
      {
        addToBorder(regions_.ofCell[owner], regions_.ofCell[neighbour]);
        addFace(face, false);
        mesh_.neighbour.push_back(number_[neighbour]);
      }
    }
  }

  // The face that comes next is between these regions.
  void addToBorder(std::uint32_t ofOwner, std::uint32_t ofNeighbour)
  {
    if (ofOwner != ofNeighbour)
    {
      FoamFaceZone& zone = borders_[std::minmax(ofOwner, ofNeighbour)];
      zone.faces.push_back(static_cast<std::uint32_t>(mesh_.owner.size()));
      zone.isTurned.push_back(ofOwner > ofNeighbour);
    }
  }

  void addPatch(const Part& part)
  {
    if (part.faces.empty() && (!isPiece() || isShared(part.patch)))
    {
      return;
    }
    for (std::size_t i = 0; i < part.faces.size(); ++i)
    {
      addFace(part.faces[i], !part.isTurned.empty() && part.isTurned[i]);
      if (isPiece() && !isShared(part.patch))
      {
        turnToOwner();
      }
    }
    mesh_.patches.push_back(part.patch);
    mesh_.patches.back().count = part.faces.size();
  }

  // The last face is a boundary face of its mesh, whatever it is in the mesh of all regions: its corners begin where
  // they do when a face of that is reversed.
  void turnToOwner()
  {
    std::int32_t& label = mesh_.addressing->faces.back();
    if (label < 0)
    {
      const auto first =
        mesh_.corners.begin() + static_cast<std::ptrdiff_t>(*std::prev(mesh_.start.end(), 2));
      std::rotate(first, std::next(first), mesh_.corners.end());
      label = -label;
    }
  }

  std::vector<Part> boundaries() const
  {
    return partsOfPatches(
      [](const FoamPatch& patch) { return !isShared(patch); }, [](std::size_t) { return true; });
  }

  // Between processes, with cells of this mesh on both sides.
  std::vector<Part> sharedBoundaries() const
  {
    return partsOfPatches(
      isShared, [this](std::size_t face) { return meshBeyond(face) == region_; });
  }

  // Of the patches that are wanted, the faces of our cells that are wanted.
  template <class IsPatchWanted, class IsFaceWanted>
  std::vector<Part> partsOfPatches(IsPatchWanted&& isPatchWanted, IsFaceWanted&& isFaceWanted) const
  {
    std::vector<Part> parts;
    std::size_t face = whole_.neighbour.size();
    for (const FoamPatch& patch : whole_.patches)
    {
      const std::size_t end = face + patch.count;
      if (isPatchWanted(patch))
      {
        parts.push_back({ patch, {} });
        for (; face < end; ++face)
        {
          if (isOurs(whole_.owner[face]) && isFaceWanted(face))
          {
            parts.back().faces.push_back(face);
          }
        }
      }
      face = end;
    }
    return parts;
  }

  // Faces to cells of other processes that are of other meshes too.
  void addShared(std::vector<Part>& interfaces) const
  {
    for (std::size_t face = whole_.owner.size() - regions_.beyond.size();
         face < whole_.owner.size(); ++face)
    {
      if (isOurs(whole_.owner[face]) && meshBeyond(face) != region_)
      {
        Part& part = interfaces[meshBeyond(face)];
        part.faces.push_back(face);
        part.isTurned.push_back(false);
      }
    }
    for (Part& part : interfaces)
    {
      sortByLabel(part);
    }
  }

  // In the order that the mesh of all pieces has them in.
  void sortByLabel(Part& part) const
  {
    std::vector<std::tuple<std::int32_t, std::size_t, bool>> order;
    for (std::size_t i = 0; i < part.faces.size(); ++i)
    {
      const std::int32_t label = std::abs(whole_.addressing->faces[part.faces[i]]);
      order.emplace_back(label, part.faces[i], part.isTurned[i]);
    }
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      part.faces[i] = std::get<1>(order[i]);
      part.isTurned[i] = std::get<2>(order[i]);
    }
  }

  // Faces to other meshes.
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
        Part& part = parts[meshOf(isOurs(owner) ? neighbour : owner)];
        part.faces.push_back(face);
        part.isTurned.push_back(isOurs(neighbour));
      }
    }
    if (isPiece())
    {
      addShared(parts);
    }
    return parts;
  }

  // Faces between parts of this mesh, twice.
  std::vector<Part> pairs() const
  {
    std::map<std::pair<std::uint32_t, std::uint32_t>, Part> parts;
    for (std::size_t face = 0; face < whole_.neighbour.size(); ++face)
    {
      const std::uint32_t owner = whole_.owner[face];
      const std::uint32_t neighbour = whole_.neighbour[face];
      if (isOurs(owner) && isOurs(neighbour) && partOf(owner) != partOf(neighbour))
      {
        for (const bool turned : { false, true })
        {
          const std::uint32_t from = regions_.ofCell[turned ? neighbour : owner];
          const std::uint32_t to = regions_.ofCell[turned ? owner : neighbour];
          Part& part = parts[{ from, to }];
          part.patch.name = nameOf(from, to);
          part.patch.partner = nameOf(to, from);
          part.faces.push_back(face);
          part.isTurned.push_back(turned);
        }
      }
    }
    std::vector<Part> result;
    result.reserve(parts.size());
    for (auto& [regions, part] : parts)
    {
      result.push_back(std::move(part));
    }
    return result;
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

  // Parts share no points.
  void numberPoints()
  {
    std::vector<std::vector<std::size_t>> facesOf(regions_.names.size());
    std::vector<std::uint32_t> partOfCell;
    for (std::uint32_t cell = 0; cell < whole_.cellCount; ++cell)
    {
      if (isOurs(cell))
      {
        partOfCell.push_back(partOf(cell));
      }
    }
    for (std::size_t face = 0; face < mesh_.owner.size(); ++face)
    {
      facesOf[partOfCell[mesh_.owner[face]]].push_back(face);
    }
    for (const std::vector<std::size_t>& faces : facesOf)
    {
      numberPoints(faces);
    }
  }

  void numberPoints(const std::vector<std::size_t>& faces)
  {
    std::vector<std::uint32_t> number(whole_.points.size() / 3, None);
    forCornersOf(faces, [&](std::uint32_t point) { number[point] = 0; });
    for (std::size_t point = 0; point < number.size(); ++point)
    {
      if (number[point] != None)
      {
        number[point] = static_cast<std::uint32_t>(mesh_.points.size() / 3);
        const double* const at = whole_.points.data() + 3 * point;
        mesh_.points.insert(mesh_.points.end(), at, at + 3);
        if (isPiece())
        {
          mesh_.addressing->points.push_back(whole_.addressing->points[point]);
        }
      }
    }
    forCornersOf(faces, [&](std::uint32_t& point) { point = number[point]; });
  }

  template <class Work>
  void forCornersOf(const std::vector<std::size_t>& faces, Work&& work)
  {
    for (const std::size_t face : faces)
    {
      for (std::size_t i = mesh_.start[face]; i < mesh_.start[face + 1]; ++i)
      {
        work(mesh_.corners[i]);
      }
    }
  }

  void addZones()
  {
    for (std::uint32_t region = 0; region < regions_.names.size(); ++region)
    {
      if (zoning_.meshOf[region] == region_ && zoning_.isZone[region])
      {
        mesh_.zones.push_back({ regions_.names[region], cellsOf(region) });
      }
    }
    for (auto& [regions, zone] : borders_)
    {
      zone.name = regions_.names[regions.first] + "_to_" + regions_.names[regions.second];
      mesh_.faceZones.push_back(std::move(zone));
    }
  }

  std::vector<std::uint32_t> cellsOf(std::uint32_t region) const
  {
    std::vector<std::uint32_t> cells;
    for (std::size_t cell = 0; cell < whole_.cellCount; ++cell)
    {
      if (regions_.ofCell[cell] == region)
      {
        cells.push_back(number_[cell]);
      }
    }
    return cells;
  }

  const FoamMesh& whole_;
  const FoamRegions& regions_;
  const FoamZoning& zoning_;
  std::uint32_t region_;
  std::vector<std::uint32_t> number_;                                       // of each cell of ours
  std::map<std::pair<std::uint32_t, std::uint32_t>, FoamFaceZone> borders_; // of two regions
  FoamMesh mesh_{};
};

// Pairs of regions with faces between them, either way.
std::set<std::pair<std::uint32_t, std::uint32_t>> contactsOf(
  const FoamMesh& whole, const FoamRegions& regions)
{
  std::set<std::pair<std::uint32_t, std::uint32_t>> contacts;
  for (std::size_t face = 0; face < whole.neighbour.size(); ++face)
  {
    const std::uint32_t a = regions.ofCell[whole.owner[face]];
    const std::uint32_t b = regions.ofCell[whole.neighbour[face]];
    if (a != b)
    {
      contacts.insert({ a, b });
      contacts.insert({ b, a });
    }
  }
  return contacts;
}

std::string listed(const std::vector<std::string>& names)
{
  return std::accumulate(std::next(names.begin()), names.end(), names.front(),
    [](const std::string& list, const std::string& name) { return list + ", " + name; });
}

std::vector<bool> regionsOfNames(const FoamRegions& regions, const std::vector<std::string>& names)
{
  std::vector<bool> isNamed(regions.names.size(), false);
  for (const std::string& name : names)
  {
    const auto found = std::find(regions.names.begin(), regions.names.end(), foamWord(name));
    if (found == regions.names.end())
    {
      throw Error(Fault::BadParameter,
        "Zone Regions: the mesh has no region " + name + ". Choose from " + listed(regions.names) +
          ".");
    }
    isNamed[static_cast<std::size_t>(found - regions.names.begin())] = true;
  }
  return isNamed;
}

}

FoamZoning separateMeshes(const FoamRegions& regions)
{
  FoamZoning zoning{ std::vector<std::uint32_t>(regions.names.size()),
    std::vector<bool>(regions.names.size(), false) };
  std::iota(zoning.meshOf.begin(), zoning.meshOf.end(), 0);
  return zoning;
}

FoamZoning allZones(const FoamRegions& regions)
{
  return { std::vector<std::uint32_t>(regions.names.size(), 0),
    std::vector<bool>(regions.names.size(), true) };
}

FoamZoning zonesOfNames(
  const FoamMesh& whole, const FoamRegions& regions, const std::vector<std::string>& names)
{
  FoamZoning zoning = separateMeshes(regions);
  zoning.isZone = regionsOfNames(regions, names);
  const auto contacts = contactsOf(whole, regions);
  std::vector<bool> isPlaced = zoning.isZone;
  isPlaced.flip();
  // In rounds: zones that touch a mesh, zones that touch those, and so on.
  for (std::vector<bool> before; before != isPlaced;)
  {
    before = isPlaced;
    for (const auto& [zone, other] : contacts)
    {
      if (!before[zone] && before[other])
      {
        const std::uint32_t mesh = zoning.meshOf[other];
        zoning.meshOf[zone] = isPlaced[zone] ? std::min(zoning.meshOf[zone], mesh) : mesh;
        isPlaced[zone] = true;
      }
    }
  }
  const auto alone = std::find(isPlaced.begin(), isPlaced.end(), false);
  if (alone != isPlaced.end())
  {
    throw Error(Fault::BadParameter,
      "Zone Regions: " + regions.names[static_cast<std::size_t>(alone - isPlaced.begin())] +
        " touches only regions that are zones themselves: remove from Zone Regions the region "
        "whose mesh should contain it.");
  }
  return zoning;
}

FoamMesh meshOfRegion(
  const FoamMesh& whole, const FoamRegions& regions, const FoamZoning& zoning, std::uint32_t region)
{
  return RegionMesh(whole, regions, zoning, region).run();
}

}
