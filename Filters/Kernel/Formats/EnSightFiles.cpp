// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/EnSightFiles.h"

#include "Base/OutputFile.h"
#include "Formats/FacesOfCells.h"
#include "Formats/UniqueNames.h"

#include <algorithm>
#include <limits>

namespace cartesian
{

namespace
{

namespace fs = std::filesystem;

constexpr std::size_t RecordBytes = 80;

class GeometryWriter
{
public:
  GeometryWriter(const FoamMesh& mesh, const FoamRegions& regions, const fs::path& path)
    : mesh_(mesh)
    , regions_(regions)
    , file_(path)
    , cells_(mesh)
    , placeOf_(mesh.points.size() / 3, None)
  {
  }

  void run()
  {
    record("C Binary");
    record("Written by Cartesian Mesher");
    record("");
    record("node id given");
    record("element id assign");
    writeRegions();
    writePatches();
    file_.close();
  }

private:
  static constexpr std::int32_t None = std::numeric_limits<std::int32_t>::max();

  void record(const std::string& words)
  {
    std::string bytes = words;
    bytes.resize(RecordBytes);
    file_.text(bytes);
  }

  void writeRegions()
  {
    std::vector<std::vector<std::uint32_t>> cellsOf(
      std::max<std::size_t>(1, regions_.names.size()));
    for (std::uint32_t cell = 0; cell < mesh_.cellCount; ++cell)
    {
      cellsOf[regions_.names.empty() ? 0 : regions_.ofCell[cell]].push_back(cell);
    }
    for (std::size_t region = 0; region < cellsOf.size(); ++region)
    {
      writeCells(regions_.names.empty() ? "cells" : regions_.names[region], cellsOf[region]);
    }
  }

  void writePatches()
  {
    auto face = static_cast<std::uint32_t>(mesh_.neighbour.size());
    for (const FoamPatch& patch : mesh_.patches)
    {
      std::vector<OrientedFace> uses;
      for (const std::size_t end = face + patch.count; face < end; ++face)
      {
        uses.push_back({ face, false });
      }
      beginPart(patch.name, uses);
      record("nsided");
      number(uses.size());
      writeSizes(uses);
      writeCorners(uses);
    }
  }

  void writeCells(const std::string& name, const std::vector<std::uint32_t>& cells)
  {
    std::vector<OrientedFace> uses;
    for (const std::uint32_t cell : cells)
    {
      uses.insert(uses.end(), cells_.uses.begin() + static_cast<std::ptrdiff_t>(cells_.start[cell]),
        cells_.uses.begin() + static_cast<std::ptrdiff_t>(cells_.start[cell + 1]));
    }
    beginPart(name, uses);
    record("nfaced");
    number(cells.size());
    for (const std::uint32_t cell : cells)
    {
      number(cells_.start[cell + 1] - cells_.start[cell]);
    }
    writeSizes(uses);
    writeCorners(uses);
  }

  // The part's number, name and points, in the order of the whole mesh.
  void beginPart(const std::string& name, const std::vector<OrientedFace>& uses)
  {
    record("part");
    number(++part_);
    record(names_.take(name));
    std::fill(placeOf_.begin(), placeOf_.end(), None);
    forEachCorner(uses, [&](std::uint32_t point) { placeOf_[point] = 0; });
    std::vector<std::size_t> points;
    for (std::size_t point = 0; point < placeOf_.size(); ++point)
    {
      if (placeOf_[point] != None)
      {
        points.push_back(point);
        placeOf_[point] = static_cast<std::int32_t>(points.size());
      }
    }
    record("coordinates");
    number(points.size());
    for (const std::size_t point : points)
    {
      number(point + 1);
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (const std::size_t point : points)
      {
        file_.raw(static_cast<float>(mesh_.points[3 * point + axis]));
      }
    }
  }

  void writeSizes(const std::vector<OrientedFace>& uses)
  {
    for (const OrientedFace use : uses)
    {
      number(mesh_.start[use.face + 1] - mesh_.start[use.face]);
    }
  }

  void writeCorners(const std::vector<OrientedFace>& uses)
  {
    forEachCorner(uses, [&](std::uint32_t point) { file_.raw(placeOf_[point]); });
  }

  // From outside the cell.
  template <class Visit>
  void forEachCorner(const std::vector<OrientedFace>& uses, Visit&& visit) const
  {
    for (const OrientedFace use : uses)
    {
      const std::uint32_t* const begin = mesh_.corners.data() + mesh_.start[use.face];
      const std::uint32_t* const end = mesh_.corners.data() + mesh_.start[use.face + 1];
      for (const std::uint32_t* at = begin; at != end; ++at)
      {
        visit(use.pointsInward ? *(end - 1 - (at - begin)) : *at);
      }
    }
  }

  void number(std::size_t value) { file_.raw(static_cast<std::int32_t>(value)); }

  const FoamMesh& mesh_;
  const FoamRegions& regions_;
  OutputFile file_;
  FacesOfCells cells_;
  std::vector<std::int32_t> placeOf_; // of each point in the current part, from one
  UniqueNames names_{ RecordBytes - 1 };
  std::size_t part_ = 0;
};

void writeCase(const std::string& geometry, const fs::path& path)
{
  OutputFile file(path);
  file.text("FORMAT\ntype: ensight gold\n\nGEOMETRY\nmodel: " + geometry + "\n");
  file.close();
}

}

void writeEnSight(const FoamMesh& mesh, const FoamRegions& regions, const fs::path& path)
{
  std::string name = fs::path(path).replace_extension(".geo").filename().string();
  std::replace(name.begin(), name.end(), ' ', '_');
  const fs::path geometry = fs::path(path).replace_filename(name);
  replaceFiles({ geometry, path }, [&](const std::vector<fs::path>& unfinished) {
    GeometryWriter(mesh, regions, unfinished[0]).run();
    writeCase(name, unfinished[1]);
  });
}

}
