// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/FluentFile.h"

#include "Base/OutputFile.h"
#include "Formats/AsciiNames.h"
#include "Formats/UniqueNames.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <numeric>

namespace cartesian
{

namespace
{

constexpr int Points = 1; // the number of the zone of points
constexpr std::size_t MostBytes = 80;

// Fluent's name and number for a type of face zone.
struct Kind
{
  const char* name;
  int number;
};

constexpr Kind Interior = { "interior", 2 };
constexpr Kind Wall = { "wall", 3 };
constexpr Kind Periodic = { "periodic", 12 };

Kind fluentKind(const FoamPatch& patch)
{
  if (patch.type == "cyclic" && patch.pair != 0)
  {
    return patch.pair > 0 ? Periodic : Kind{ "shadow", 8 };
  }
  switch (kindOf(patch))
  {
    case BoundaryKind::Wall:
      return Wall;
    case BoundaryKind::Symmetry:
      return { "symmetry", 7 };
    case BoundaryKind::Inlet:
      return { "velocity-inlet", 10 };
    default:
      return { "pressure-outlet", 5 };
  }
}

std::string fluentName(const std::string& given)
{
  std::string name = asciiName(given);
  std::replace_if(
    name.begin(), name.end(),
    [](unsigned char c) { return !(std::isalnum(c) || c == '-' || c == '.'); }, '_');
  return name;
}

class FluentWriter
{
public:
  FluentWriter(const FoamMesh& mesh, const FoamRegions& regions, const std::filesystem::path& path)
    : mesh_(mesh)
    , regions_(regions)
    , file_(path)
  {
  }

  std::vector<ChangedName> run()
  {
    file_.text("(0 \"Written by Cartesian Mesher\")\n(2 3)\n");
    numberCells();
    sortFaces();
    writePoints();
    writeCells();
    writeFaces();
    writePeriodicPairs();
    writeZoneNames();
    file_.close();
    return std::move(changed_);
  }

private:
  struct CellZone
  {
    std::string name;
    std::size_t count;
    std::vector<FoamPatch> patches = {};
  };

  struct FaceZone
  {
    std::string name;
    Kind kind;
    std::vector<std::uint32_t> faces;
    int pair = 0; // as FoamPatch has it
    std::uint32_t region = 0;
  };

  std::size_t regionCount() const { return std::max<std::size_t>(1, regions_.names.size()); }
  std::uint32_t regionOf(std::uint32_t cell) const
  {
    return regions_.names.empty() ? 0 : regions_.ofCell[cell];
  }

  // Cells of a region follow each other.
  void numberCells()
  {
    for (std::size_t region = 0; region < regionCount(); ++region)
    {
      const std::string name = regions_.names.empty() ? "cells" : regions_.names[region];
      cellZones_.push_back({ name, 0 });
    }
    for (std::uint32_t cell = 0; cell < mesh_.cellCount; ++cell)
    {
      ++cellZones_[regionOf(cell)].count;
    }
    std::vector<std::uint32_t> next = { 1 };
    for (const CellZone& zone : cellZones_)
    {
      next.push_back(next.back() + static_cast<std::uint32_t>(zone.count));
    }
    number_.reserve(mesh_.cellCount);
    for (std::uint32_t cell = 0; cell < mesh_.cellCount; ++cell)
    {
      number_.push_back(next[regionOf(cell)]++);
    }
  }

  void sortFaces()
  {
    sortInnerFaces();
    auto face = static_cast<std::uint32_t>(mesh_.neighbour.size());
    for (const FoamPatch& patch : mesh_.patches)
    {
      std::map<std::uint32_t, std::vector<std::uint32_t>> ofRegion;
      for (const std::size_t end = face + patch.count; face < end; ++face)
      {
        ofRegion[regionOf(mesh_.owner[face])].push_back(face);
      }
      for (auto& [region, faces] : ofRegion)
      {
        const std::string name =
          ofRegion.size() == 1 ? patch.name : patch.name + "_" + cellZones_[region].name;
        cellZones_[region].patches.push_back(patch);
        faceZones_.push_back({ name, fluentKind(patch), std::move(faces), patch.pair, region });
      }
    }
  }

  void sortInnerFaces()
  {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> between;
    for (std::uint32_t face = 0; face < mesh_.neighbour.size(); ++face)
    {
      const auto [first, second] =
        std::minmax({ regionOf(mesh_.owner[face]), regionOf(mesh_.neighbour[face]) });
      between[{ first, second }].push_back(face);
    }
    for (auto& [pair, faces] : between)
    {
      const std::string& first = cellZones_[pair.first].name;
      faceZones_.push_back(pair.first == pair.second
          ? FaceZone{ "interior_" + first, Interior, std::move(faces) }
          : FaceZone{ first + "_to_" + cellZones_[pair.second].name,
              regions_.areZones ? Interior : Wall, std::move(faces) });
    }
  }

  void list(std::initializer_list<std::size_t> numbers)
  {
    const char* before = "(";
    for (const std::size_t number : numbers)
    {
      file_.text(before);
      file_.hexadecimal(number);
      before = " ";
    }
    file_.text(")");
  }

  void section(const char* number, std::initializer_list<std::size_t> numbers)
  {
    file_.text("(");
    file_.text(number);
    file_.text(" ");
    list(numbers);
  }

  void writePoints()
  {
    const std::size_t count = mesh_.points.size() / 3;
    section("10", { 0, 1, count, 0, 3 });
    file_.text(")\n");
    section("10", { Points, 1, count, 1, 3 });
    file_.text("(\n");
    for (std::size_t i = 0; i < mesh_.points.size(); ++i)
    {
      file_.decimal(mesh_.points[i]);
      file_.text(i % 3 == 2 ? "\n" : " ");
    }
    file_.text("))\n");
  }

  void writeCells()
  {
    constexpr std::size_t Active = 1;
    constexpr std::size_t Polyhedra = 7;
    section("12", { 0, 1, mesh_.cellCount, 0, 0 });
    file_.text(")\n");
    std::size_t zone = Points;
    std::size_t first = 1;
    for (const CellZone& cells : cellZones_)
    {
      section("12", { ++zone, first, first + cells.count - 1, Active, Polyhedra });
      file_.text(")\n");
      first += cells.count;
    }
  }

  void writeFaces()
  {
    constexpr std::size_t Polygons = 5;
    section("13", { 0, 1, mesh_.owner.size(), 0, 0 });
    file_.text(")\n");
    std::size_t zone = Points + cellZones_.size();
    std::size_t first = 1;
    for (const FaceZone& faces : faceZones_)
    {
      firstFace_.push_back(first);
      section("13",
        { ++zone, first, first + faces.faces.size() - 1,
          static_cast<std::size_t>(faces.kind.number), Polygons });
      file_.text("(\n");
      for (const std::uint32_t face : faces.faces)
      {
        writeFace(face);
      }
      file_.text("))\n");
      first += faces.faces.size();
    }
  }

  // The faces of a pair are in the same order.
  void writePeriodicPairs()
  {
    for (std::size_t a = 0; a < faceZones_.size(); ++a)
    {
      for (std::size_t b = 0; b < faceZones_.size(); ++b)
      {
        const FaceZone& own = faceZones_[a];
        const FaceZone& other = faceZones_[b];
        if (own.pair > 0 && own.kind.number == Periodic.number && other.pair == -own.pair &&
          other.region == own.region && own.faces.size() == other.faces.size())
        {
          writePeriodicPair(a, b);
        }
      }
    }
  }

  void writePeriodicPair(std::size_t a, std::size_t b)
  {
    const std::size_t before = Points + cellZones_.size() + 1;
    const std::size_t count = faceZones_[a].faces.size();
    section("18", { 1, count, before + a, before + b });
    file_.text("(\n");
    for (std::size_t i = 0; i < count; ++i)
    {
      file_.hexadecimal(firstFace_[a] + i);
      file_.text(" ");
      file_.hexadecimal(firstFace_[b] + i);
      file_.text("\n");
    }
    file_.text("))\n");
  }

  void writeFace(std::uint32_t face)
  {
    file_.hexadecimal(mesh_.start[face + 1] - mesh_.start[face]);
    for (std::size_t i = mesh_.start[face + 1]; i > mesh_.start[face]; --i)
    {
      file_.text(" ");
      file_.hexadecimal(mesh_.corners[i - 1] + std::size_t{ 1 });
    }
    file_.text(" ");
    file_.hexadecimal(number_[mesh_.owner[face]]);
    file_.text(" ");
    file_.hexadecimal(face < mesh_.neighbour.size() ? number_[mesh_.neighbour[face]] : 0U);
    file_.text("\n");
  }

  void writeZoneNames()
  {
    UniqueNames names(MostBytes);
    int zone = Points;
    const auto write = [&](const char* kind, const std::string& name) {
      const std::string written = names.take(fluentName(name));
      file_.text("(45 (" + std::to_string(++zone) + " " + kind + " " + written + ")())\n");
      if (written != name)
      {
        changed_.push_back({ name, written });
      }
    };
    for (const CellZone& cells : cellZones_)
    {
      const bool isSolid =
        regionCount() > 1 && !regions_.areZones && !isFluid(cells.name, cells.patches);
      write(isSolid ? "solid" : "fluid", cells.name);
    }
    for (const FaceZone& faces : faceZones_)
    {
      write(faces.kind.name, faces.name);
    }
  }

  const FoamMesh& mesh_;
  const FoamRegions& regions_;
  OutputFile file_;
  std::vector<CellZone> cellZones_;
  std::vector<std::uint32_t> number_;  // of each cell, from one
  std::vector<FaceZone> faceZones_;    // inner ones first
  std::vector<std::size_t> firstFace_; // of each: its number in the file
  std::vector<ChangedName> changed_;
};

}

std::vector<ChangedName> writeFluent(
  const FoamMesh& mesh, const FoamRegions& regions, const std::filesystem::path& path)
{
  std::vector<ChangedName> changed;
  replaceFiles({ path }, [&](const std::vector<std::filesystem::path>& unfinished) {
    changed = FluentWriter(mesh, regions, unfinished.front()).run();
  });
  return changed;
}

}
