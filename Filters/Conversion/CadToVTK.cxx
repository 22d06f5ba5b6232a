// SPDX-License-Identifier: BSD-3-Clause
#include "CadToVTK.h"

#include "BoundaryNames.h"
#include "FieldData.h"
#include "LengthUnit.h"
#include "SurfaceFromVTK.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <set>

namespace cartesian
{

namespace
{

void setPoints(const CadSolid& solid, vtkPolyData* block)
{
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(solid.points.size() / 3));
  std::copy(solid.points.begin(), solid.points.end(), coordinates->GetPointer(0));
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  block->SetPoints(points);
}

// Of `size` points each.
vtkSmartPointer<vtkCellArray> cellsOf(const std::vector<std::int64_t>& corners, vtkIdType size)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  std::vector<vtkIdType> cell(static_cast<std::size_t>(size));
  for (std::size_t i = 0; i < corners.size(); i += cell.size())
  {
    std::copy_n(corners.begin() + static_cast<std::ptrdiff_t>(i), size, cell.begin());
    cells->InsertNextCell(size, cell.data());
  }
  return cells;
}

void setCellData(const CadSolid& solid, const std::vector<std::string>& names, vtkPolyData* block)
{
  std::vector<std::int32_t> boundary = solid.boundaryOfLine;
  boundary.insert(boundary.end(), solid.boundary.begin(), solid.boundary.end());
  vtkNew<vtkIntArray> ids;
  ids->SetName(BoundaryIdArray);
  vtkNew<vtkStringArray> texts;
  texts->SetName("BoundaryName");
  vtkNew<vtkUnsignedCharArray> sharp;
  sharp->SetName("SharpEdge");
  for (std::size_t i = 0; i < boundary.size(); ++i)
  {
    ids->InsertNextValue(boundary[i]);
    texts->InsertNextValue(names[static_cast<std::size_t>(boundary[i])]);
    sharp->InsertNextValue(i < solid.boundaryOfLine.size() ? 1 : 0);
  }
  block->GetCellData()->AddArray(ids);
  block->GetCellData()->AddArray(texts);
  if (solid.knowsEdges)
  {
    block->GetCellData()->AddArray(sharp);
  }
  vtkNew<vtkUnsignedCharArray> open;
  open->SetName(OpenBodyArray);
  open->SetNumberOfValues(static_cast<vtkIdType>(boundary.size()));
  open->Fill(solid.isOpenBody);
  block->GetCellData()->AddArray(open);
}

void setFieldData(const CadSolid& solid, const std::vector<std::string>& names, vtkPolyData* block)
{
  BoundaryNames numbered;
  for (const std::int32_t id : std::set<std::int32_t>(solid.boundary.begin(), solid.boundary.end()))
  {
    numbered.emplace(id, names[static_cast<std::size_t>(id)]);
  }
  setBoundaryNames(block, numbered);
  vtkNew<vtkStringArray> name;
  name->SetName("SolidName");
  name->InsertNextValue(solid.name);
  block->GetFieldData()->AddArray(name);
  setField(block, "Volume", { solid.volume });
  setField(block, "VolumeOfTriangles", { solid.volumeOfTriangles });
  setField(block, "Area", { solid.area });
  setField(block, "Deflection", { solid.deflection });
  setField(block, "OpenEdges", { double(solid.openEdges) });
}

}

void cadBlocks(const CadContent& content, double metresPerUnit, vtkMultiBlockDataSet* blocks)
{
  for (const CadSolid& solid : content.solids)
  {
    vtkNew<vtkPolyData> block;
    setPoints(solid, block);
    block->SetLines(cellsOf(solid.lines, 2));
    block->SetPolys(cellsOf(solid.triangles, 3));
    setCellData(solid, content.boundaries, block);
    setFieldData(solid, content.boundaries, block);
    setField(block, MetresPerUnitField, { metresPerUnit });
    const unsigned int number = blocks->GetNumberOfBlocks();
    blocks->SetBlock(number, block);
    blocks->GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), solid.name.c_str());
  }
}

}
