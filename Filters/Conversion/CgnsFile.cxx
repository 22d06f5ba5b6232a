// SPDX-License-Identifier: BSD-3-Clause
#include "CgnsFile.h"

#include "Base/Error.h"
#include "Base/OutputFile.h"
#include "Formats/FacesOfCells.h"
#include "Formats/UniqueNames.h"

#include "vtk_cgns.h"
// clang-format off
#include VTK_CGNS(cgnslib.h)
// clang-format on

#include <array>
#include <numeric>
#include <set>

namespace cartesian
{

namespace
{

namespace fs = std::filesystem;

constexpr std::size_t MostBytes = 32; // of a name

void check(int code)
{
  if (code != CG_OK)
  {
    throw Error(Fault::CannotWrite,
      std::string("The CGNS file cannot be written (") + cg_get_error() +
        "): choose another folder, or free disk space.");
  }
}

// Open as long as it lives.
class File
{
public:
  explicit File(const fs::path& path) { check(cg_open(path.c_str(), CG_MODE_WRITE, &number_)); }
  ~File()
  {
    if (isOpen_)
    {
      cg_close(number_);
    }
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  void close()
  {
    isOpen_ = false;
    check(cg_close(number_));
  }
  int number() const { return number_; }

private:
  int number_ = 0;
  bool isOpen_ = true;
};

CGNS_ENUMT(BCType_t) typeOf(const FoamPatch& patch)
{
  switch (kindOf(patch))
  {
    case BoundaryKind::Wall:
      return CGNS_ENUMV(BCWall);
    case BoundaryKind::Symmetry:
      return CGNS_ENUMV(BCSymmetryPlane);
    case BoundaryKind::Inlet:
      return CGNS_ENUMV(BCInflow);
    case BoundaryKind::Outlet:
      return CGNS_ENUMV(BCOutflow);
    default:
      return CGNS_ENUMV(BCGeneral);
  }
}

// Elements are the faces, then the cells, from 1.
class ZoneWriter
{
public:
  ZoneWriter(int file, int base, const FoamMesh& mesh)
    : file_(file)
    , base_(base)
    , mesh_(mesh)
    , faces_(static_cast<cgsize_t>(mesh.owner.size()))
    , cells_(static_cast<cgsize_t>(mesh.cellCount))
  {
  }

  void write(const std::string& name)
  {
    const std::array<cgsize_t, 3> size = { static_cast<cgsize_t>(mesh_.points.size() / 3), cells_,
      0 };
    check(cg_zone_write(file_, base_, name.c_str(), size.data(), CGNS_ENUMV(Unstructured), &zone_));
    writePoints();
    writeFaces();
    writeCells();
  }

  // The faces of patch `i`.
  std::vector<cgsize_t> facesOf(std::size_t i) const
  {
    std::size_t first = mesh_.neighbour.size() + 1;
    for (std::size_t before = 0; before < i; ++before)
    {
      first += mesh_.patches[before].count;
    }
    std::vector<cgsize_t> faces(mesh_.patches[i].count);
    std::iota(faces.begin(), faces.end(), static_cast<cgsize_t>(first));
    return faces;
  }

  void writeBoundary(std::size_t i, const std::string& name, const std::string& family) const
  {
    const std::vector<cgsize_t> faces = facesOf(i);
    int number = 0;
    check(cg_boco_write(file_, base_, zone_, name.c_str(), CGNS_ENUMV(FamilySpecified),
      CGNS_ENUMV(PointList), static_cast<cgsize_t>(faces.size()), faces.data(), &number));
    check(cg_boco_gridlocation_write(file_, base_, zone_, number, CGNS_ENUMV(FaceCenter)));
    check(cg_goto(file_, base_, "Zone_t", zone_, "ZoneBC_t", 1, "BC_t", number, "end"));
    check(cg_famname_write(family.c_str()));
  }

  void writeConnection(std::size_t i, const std::string& name, const std::string& donor,
    const std::vector<cgsize_t>& donorFaces) const
  {
    const std::vector<cgsize_t> faces = facesOf(i);
    const auto count = static_cast<cgsize_t>(faces.size());
    int number = 0;
    check(cg_conn_write(file_, base_, zone_, name.c_str(), CGNS_ENUMV(FaceCenter),
      CGNS_ENUMV(Abutting1to1), CGNS_ENUMV(PointList), count, faces.data(), donor.c_str(),
      CGNS_ENUMV(Unstructured), CGNS_ENUMV(PointListDonor), CGNS_ENUMV(DataTypeNull), count,
      donorFaces.data(), &number));
  }

private:
  void writePoints() const
  {
    constexpr std::array<double, 5> Length = { 0, 1, 0, 0, 0 }; // of mass, length, time, ...
    const std::array<const char*, 3> names = { "CoordinateX", "CoordinateY", "CoordinateZ" };
    std::vector<double> numbers(mesh_.points.size() / 3);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (std::size_t p = 0; p < numbers.size(); ++p)
      {
        numbers[p] = mesh_.points[3 * p + axis];
      }
      int number = 0;
      check(cg_coord_write(
        file_, base_, zone_, CGNS_ENUMV(RealDouble), names[axis], numbers.data(), &number));
      check(cg_goto(
        file_, base_, "Zone_t", zone_, "GridCoordinates_t", 1, "DataArray_t", number, "end"));
      check(cg_exponents_write(CGNS_ENUMV(RealDouble), Length.data()));
    }
  }

  void writeSection(const char* name, CGNS_ENUMT(ElementType_t) type, cgsize_t first,
    cgsize_t count, const std::vector<cgsize_t>& elements, const std::vector<cgsize_t>& start) const
  {
    int number = 0;
    check(cg_poly_section_write(file_, base_, zone_, name, type, first, first + count - 1, 0,
      elements.data(), start.data(), &number));
  }

  void writeFaces() const
  {
    std::vector<cgsize_t> corners;
    corners.reserve(mesh_.corners.size());
    for (const std::uint32_t point : mesh_.corners)
    {
      corners.push_back(static_cast<cgsize_t>(point) + 1);
    }
    const std::vector<cgsize_t> start(mesh_.start.begin(), mesh_.start.end());
    writeSection("Faces", CGNS_ENUMV(NGON_n), 1, faces_, corners, start);
  }

  // Negative: the face points into the cell.
  void writeCells() const
  {
    const FacesOfCells cells(mesh_);
    const std::vector<cgsize_t> start(cells.start.begin(), cells.start.end());
    std::vector<cgsize_t> faces;
    faces.reserve(cells.uses.size());
    for (const OrientedFace use : cells.uses)
    {
      const auto number = static_cast<cgsize_t>(use.face) + 1;
      faces.push_back(use.pointsInward ? -number : number);
    }
    writeSection("Cells", CGNS_ENUMV(NFACE_n), faces_ + 1, cells_, faces, start);
  }

  int file_;
  int base_;
  const FoamMesh& mesh_;
  cgsize_t faces_;
  cgsize_t cells_;
  int zone_ = 0;
};

class Writer
{
public:
  Writer(const std::vector<CgnsZone>& zones, const fs::path& path)
    : zones_(zones)
    , file_(path)
  {
  }

  void run()
  {
    check(cg_base_write(file_.number(), "Base", 3, 3, &base_));
    check(cg_goto(file_.number(), base_, "end"));
    check(cg_dataclass_write(CGNS_ENUMV(NormalizedByUnknownDimensional)));
    for (const CgnsZone& zone : zones_)
    {
      zoneNames_.of(zone.name);
    }
    families_.avoid(zoneNames_);
    writeFamilies();
    for (const CgnsZone& zone : zones_)
    {
      writers_.emplace_back(file_.number(), base_, zone.mesh);
      writers_.back().write(zoneNames_.of(zone.name));
    }
    for (std::size_t z = 0; z < zones_.size(); ++z)
    {
      for (std::size_t i = 0; i < zones_[z].mesh.patches.size(); ++i)
      {
        writePatch(z, i);
      }
    }
    file_.close();
  }

private:
  void writeFamilies()
  {
    std::set<std::string> written;
    for (const CgnsZone& zone : zones_)
    {
      for (const FoamPatch& patch : zone.mesh.patches)
      {
        if (patch.sample.region.empty() && written.insert(patch.name).second)
        {
          const std::string& name = families_.of(patch.name);
          int family = 0;
          int condition = 0;
          check(cg_family_write(file_.number(), base_, name.c_str(), &family));
          check(cg_fambc_write(file_.number(), base_, family, "FamBC", typeOf(patch), &condition));
        }
      }
    }
  }

  void writePatch(std::size_t z, std::size_t i)
  {
    const FoamPatch& patch = zones_[z].mesh.patches[i];
    const std::string& name = conditions_.of(patch.name);
    if (patch.sample.region.empty())
    {
      writers_[z].writeBoundary(i, name, families_.of(patch.name));
      return;
    }
    for (std::size_t other = 0; other < zones_.size(); ++other)
    {
      const std::vector<FoamPatch>& patches = zones_[other].mesh.patches;
      for (std::size_t j = 0; j < patches.size(); ++j)
      {
        if (zones_[other].name == patch.sample.region && patches[j].name == patch.sample.patch)
        {
          writers_[z].writeConnection(
            i, name, zoneNames_.of(zones_[other].name), writers_[other].facesOf(j));
        }
      }
    }
  }

  const std::vector<CgnsZone>& zones_;
  File file_;
  int base_ = 0;
  UniqueNames zoneNames_{ MostBytes };
  UniqueNames families_{ MostBytes };   // siblings of zones
  UniqueNames conditions_{ MostBytes }; // of boundaries in zones
  std::vector<ZoneWriter> writers_;
};

}

void writeCgns(const std::vector<CgnsZone>& zones, const std::filesystem::path& path)
{
  replaceFiles({ path },
    [&](const std::vector<fs::path>& unfinished) { Writer(zones, unfinished.front()).run(); });
}

}
