// SPDX-License-Identifier: BSD-3-Clause
#include "CellFacesFromVTK.h"

#include "Error.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <type_traits>

namespace cartesian
{

static_assert(std::is_same<Id, vtkIdType>::value, "the kernel's ids are VTK's");

namespace
{

class Collector
{
public:
  explicit Collector(vtkUnstructuredGrid* grid)
    : grid_(grid)
  {
  }

  CellFaces run() &&
  {
    for (vtkIdType cell = 0; cell < grid_->GetNumberOfCells(); ++cell)
    {
      switch (grid_->GetCellType(cell))
      {
        case VTK_POLYHEDRON:
          addPolyhedron(cell);
          break;
        case VTK_HEXAHEDRON:
          addHexahedron(cell);
          break;
        default:
          addOther(cell);
      }
    }
    return std::move(faces_);
  }

private:
  template <class Corners>
  void add(vtkIdType cell, const Corners& corners)
  {
    faces_.nodes.insert(faces_.nodes.end(), corners.begin(), corners.end());
    faces_.start.push_back(static_cast<Id>(faces_.nodes.size()));
    faces_.cell.push_back(cell);
  }

  void addPolyhedron(vtkIdType cell)
  {
    grid_->GetFaceStream(cell, ids_);
    const vtkIdType* stream = ids_->GetPointer(0);
    const vtkIdType count = *stream++;
    for (vtkIdType face = 0; face < count; ++face)
    {
      const vtkIdType size = *stream++;
      faces_.nodes.insert(faces_.nodes.end(), stream, stream + size);
      faces_.start.push_back(static_cast<Id>(faces_.nodes.size()));
      faces_.cell.push_back(cell);
      stream += size;
    }
  }

  void addHexahedron(vtkIdType cell)
  {
    constexpr int Corners[6][4] = { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 }, { 3, 7, 6, 2 },
      { 0, 3, 2, 1 }, { 4, 5, 6, 7 } };
    grid_->GetCellPoints(cell, ids_);
    for (const auto& face : Corners)
    {
      add(cell,
        std::array<Id, 4>{
          ids_->GetId(face[0]), ids_->GetId(face[1]), ids_->GetId(face[2]), ids_->GetId(face[3]) });
    }
  }

  void addOther(vtkIdType id)
  {
    grid_->GetCell(id, cell_);
    if (cell_->GetCellDimension() == 3 && !cell_->IsLinear())
    {
      throw Error(Fault::BadParameter,
        "Cell " + std::to_string(id) +
          " has curved edges (a quadratic or higher-order cell): apply the filter Tessellate "
          "first.");
    }
    for (int f = 0; f < cell_->GetNumberOfFaces(); ++f)
    {
      vtkCell* face = cell_->GetFace(f);
      const vtkIdType* p = face->GetPointIds()->GetPointer(0);
      if (face->GetCellType() == VTK_PIXEL)
      {
        add(id, std::array<Id, 4>{ p[0], p[1], p[3], p[2] });
      }
      else
      {
        add(id, std::vector<Id>(p, p + face->GetNumberOfPoints()));
      }
    }
  }

  vtkUnstructuredGrid* grid_;
  vtkNew<vtkIdList> ids_;
  vtkNew<vtkGenericCell> cell_;
  CellFaces faces_;
};

}

CellFaces cellFacesFromVTK(vtkUnstructuredGrid* grid)
{
  return Collector(grid).run();
}

const double* coordinates(vtkUnstructuredGrid* grid, std::vector<double>& copy)
{
  if (!grid->GetPoints())
  {
    return nullptr;
  }
  if (auto* doubles = vtkDoubleArray::SafeDownCast(grid->GetPoints()->GetData()))
  {
    return doubles->GetPointer(0);
  }
  copy.resize(3 * static_cast<std::size_t>(grid->GetNumberOfPoints()));
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    grid->GetPoint(p, copy.data() + 3 * p);
  }
  return copy.data();
}

}
