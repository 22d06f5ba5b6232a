// SPDX-License-Identifier: BSD-3-Clause
#include "PeriodicMesh.h"

#include "Base/Error.h"
#include "FacedGrid.h"
#include "PeriodicPairs.h"
#include "Sections/PeriodicFaces.h"
#include "Sections/SidePlane.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkFieldData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>

namespace cartesian
{

namespace
{

// Angles that divide a turn up to this are meant to.
constexpr double SameAngle = 1e-4; // degrees: surfaces in single precision are no better

struct Side
{
  Vector area{}; // doubled, outwards
  Vector low;
  Vector high;
};

Side sideOf(const GridFaces& mesh, const std::vector<std::size_t>& faces)
{
  constexpr double Far = std::numeric_limits<double>::max();
  Side side{ {}, { Far, Far, Far }, { -Far, -Far, -Far } };
  for (const std::size_t face : faces)
  {
    side.area = plus(side.area, doubledArea(mesh.cells, face, mesh.points));
    for (std::size_t i = mesh.cells.firstCorner[face]; i < mesh.cells.firstCorner[face + 1]; ++i)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const double at = mesh.points[3 * std::size_t(mesh.cells.corners[i]) + k];
        side.low[k] = std::min(side.low[k], at);
        side.high[k] = std::max(side.high[k], at);
      }
    }
  }
  return side;
}

class PeriodicMesh
{
public:
  PeriodicMesh(vtkUnstructuredGrid* grid, const PeriodicBoundarySpec& spec, Execution& execution)
    : grid_(grid)
    , spec_(spec)
    , boundaries_(grid)
    , mesh_(grid, execution)
  {
    turnOutward(mesh_.cells, mesh_.points.data(), execution);
    boundaryOf_ = neighboursOf(grid, mesh_, execution).boundary;
    pair_.boundary = { numberOf(spec.names[0]), numberOf(spec.names[1]) };
    for (std::size_t face = 0; face < boundaryOf_.size(); ++face)
    {
      for (std::size_t k = 0; k < 2; ++k)
      {
        if (boundaryOf_[face] == pair_.boundary[k])
        {
          sides_[k].push_back(face);
        }
      }
    }
    const std::array both{ sideOf(mesh_, sides_[0]), sideOf(mesh_, sides_[1]) };
    areas_ = { both[0].area, both[1].area };
    pair_.motion = spec.turns ? turn() : translation(both[0], both[1]);
  }

  void write(vtkUnstructuredGrid* output)
  {
    for (std::size_t k = 0; k < 2; ++k)
    {
      boundaries_.add(pair_.boundary[k], spec_.names[k], spec_.keepsFaces ? "cyclicAMI" : "cyclic");
    }
    output->GetFieldData()->ShallowCopy(grid_->GetFieldData());
    match();
    writeCells(output);
    boundaries_.write(rows(), output);
    addPeriodicPair(pair_, output);
  }

  PeriodicResult result() const
  {
    PeriodicResult result{ {}, matched_.farthest };
    for (std::size_t face = 0; face < matched_.source.size(); ++face)
    {
      for (std::size_t k = 0; k < 2; ++k)
      {
        if (boundaryOf_[matched_.source[face]] == pair_.boundary[k])
        {
          result.areas[k] += norm(doubledArea(matched_.cells, face, matched_.points)) / 2;
        }
      }
    }
    return result;
  }

private:
  vtkIdType numberOf(const std::string& name) const
  {
    std::string all;
    for (const auto& [number, own] : boundaries_.names())
    {
      const bool hasFaces =
        std::find(boundaryOf_.begin(), boundaryOf_.end(), number) != boundaryOf_.end();
      if (own == name && hasFaces)
      {
        return number;
      }
      all += hasFaces ? (all.empty() ? "" : ", ") + own : "";
    }
    throw Error(Fault::BadParameter,
      "There is no boundary \"" + name + "\" on the mesh. Choose two of these: " + all + ".");
  }

  static SideMotion translation(const Side& first, const Side& second)
  {
    SideMotion motion;
    motion.translation =
      scaled(minus(plus(second.low, second.high), plus(first.low, first.high)), 0.5);
    return motion;
  }

  SideMotion turn() const
  {
    SideMotion motion;
    motion.axis = unit(spec_.axis);
    motion.centre = spec_.centre;
    if (motion.axis == Vector{})
    {
      throw Error(
        Fault::BadParameter, "Axis is 0: give the direction that sides are turned around.");
    }
    const auto across = [&](const Vector& area) {
      return minus(area, scaled(motion.axis, dot(motion.axis, area)));
    };
    const Vector from = across(areas_[0]);
    const Vector to = scaled(across(areas_[1]), -1);
    motion.angle = std::atan2(dot(motion.axis, cross(from, to)), dot(from, to)) * 180 / Pi;
    const double parts = std::round(360 / motion.angle);
    motion.angle = std::abs(360 / parts - motion.angle) < SameAngle ? 360 / parts : motion.angle;
    return motion;
  }

  void match()
  {
    try
    {
      matched_ = matchSides(mesh_.cells, mesh_.points, sides_, pair_.motion,
        spec_.keepsFaces ? FacesOfPair::Own : FacesOfPair::Same);
    }
    catch (const Error& error)
    {
      throw Error(
        error.fault, "\"" + spec_.names[0] + "\" and \"" + spec_.names[1] + "\": " + error.what());
    }
  }

  static std::size_t cornersOf(const CellFaces& cells, std::size_t cell)
  {
    return cells.firstCorner[cells.firstFace[cell + 1]] - cells.firstCorner[cells.firstFace[cell]];
  }

  // Hexahedra that have got no points stay hexahedra.
  void writeCells(vtkUnstructuredGrid* output)
  {
    output->SetPoints(pointsOf(matched_.points));
    std::vector<std::uint32_t> numberOf(static_cast<std::size_t>(grid_->GetNumberOfPoints()), 0);
    for (std::size_t p = 0; p < mesh_.pointOf.size(); ++p)
    {
      numberOf[static_cast<std::size_t>(mesh_.pointOf[p])] = static_cast<std::uint32_t>(p);
    }
    CellWriter cells;
    vtkCellData* const to = output->GetCellData();
    to->CopyGlobalIdsOff();
    to->CopyAllocate(grid_->GetCellData(), grid_->GetNumberOfCells());
    vtkIdType count = 0;
    const auto isHexahedron = [&](std::size_t cell) {
      return grid_->GetCellType(mesh_.cellOf[cell]) == VTK_HEXAHEDRON &&
        cornersOf(mesh_.cells, cell) == cornersOf(matched_.cells, cell);
    };
    for (const bool hexahedra : { true, false })
    {
      vtkNew<vtkIdList> points;
      for (std::size_t cell = 0; cell < mesh_.cellOf.size(); ++cell)
      {
        if (isHexahedron(cell) != hexahedra)
        {
          continue;
        }
        if (hexahedra)
        {
          grid_->GetCellPoints(mesh_.cellOf[cell], points);
          std::array<vtkIdType, 8> corners{};
          for (vtkIdType i = 0; i < 8; ++i)
          {
            corners[static_cast<std::size_t>(i)] =
              numberOf[static_cast<std::size_t>(points->GetId(i))];
          }
          cells.addHexahedron(corners);
        }
        else
        {
          cells.addPolyhedron(matched_.cells, cell);
        }
        to->CopyData(grid_->GetCellData(), mesh_.cellOf[cell], count++);
      }
    }
    cells.finish(output);
  }

  // In order of CellId, as the mesh's cells are.
  std::vector<BoundaryFaceRow> rows() const
  {
    auto* ids = vtkIdTypeArray::SafeDownCast(grid_->GetCellData()->GetAbstractArray(CellId));
    std::vector<BoundaryFaceRow> all;
    const CellFaces& cells = matched_.cells;
    for (std::size_t cell = 0; cell < cells.cellCount(); ++cell)
    {
      for (std::size_t f = cells.firstFace[cell]; f < cells.firstFace[cell + 1]; ++f)
      {
        const vtkIdType boundary = boundaryOf_[matched_.source[f]];
        if (boundary != InnerFace)
        {
          const vtkIdType place = mesh_.cellOf[cell];
          all.push_back({ ids ? ids->GetValue(place) : place,
            static_cast<vtkIdType>(f - cells.firstFace[cell]), boundary });
        }
      }
    }
    return all;
  }

  vtkUnstructuredGrid* grid_;
  const PeriodicBoundarySpec& spec_;
  BoundaryTable boundaries_;
  GridFaces mesh_;
  std::vector<vtkIdType> boundaryOf_; // of each face
  std::array<std::vector<std::size_t>, 2> sides_;
  std::array<Vector, 2> areas_{}; // doubled
  PeriodicPair pair_{};
  PeriodicFaces matched_;
};

}

PeriodicResult makePeriodic(vtkUnstructuredGrid* grid, const PeriodicBoundarySpec& spec,
  vtkUnstructuredGrid* output, Execution& execution)
{
  if (spec.names[0] == spec.names[1])
  {
    throw Error(Fault::BadParameter,
      "A pair of \"" + spec.names[0] + "\" and itself: name two different boundaries.");
  }
  PeriodicMesh periodic(grid, spec, execution);
  periodic.write(output);
  return periodic.result();
}

}
