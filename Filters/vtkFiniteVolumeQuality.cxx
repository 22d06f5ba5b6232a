// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFiniteVolumeQuality.h"

#include "CellFacesFromVTK.h"
#include "FieldData.h"
#include "QualityMeasures.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedIntArray.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkFiniteVolumeQuality);

namespace
{

template <class Array, class Value>
vtkNew<Array> MakeArray(const std::vector<Value>& values)
{
  vtkNew<Array> array;
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

template <class Array, class Value>
void AddArray(vtkCellData* data, const char* name, const std::vector<Value>& values)
{
  const vtkNew<Array> array = MakeArray<Array>(values);
  array->SetName(name);
  data->AddArray(array);
}

void SetMeasures(const std::array<std::vector<double>, cartesian::MeasureCount>& measures,
  const std::vector<std::uint32_t>& failures, vtkCellData* data)
{
  AddArray<vtkUnsignedIntArray>(data, "Failures", failures);
  for (std::size_t m = 0; m < measures.size(); ++m)
  {
    if (measures[m].size() == failures.size())
    {
      AddArray<vtkDoubleArray>(data, cartesian::MeasureSpecs[m].name, measures[m]);
    }
  }
}

void SetFaces(const cartesian::FaceList& faces, vtkUnstructuredGrid* grid, vtkPolyData* output)
{
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(MakeArray<vtkIdTypeArray>(faces.start), MakeArray<vtkIdTypeArray>(faces.nodes));
  output->SetPoints(grid->GetPoints());
  output->GetPointData()->PassData(grid->GetPointData());
  output->SetPolys(polygons);
  AddArray<vtkIdTypeArray>(output->GetCellData(), "Owner", faces.owner);
  std::vector<cartesian::Id> neighbour = faces.neighbour;
  neighbour.resize(faces.owner.size(), -1);
  AddArray<vtkIdTypeArray>(output->GetCellData(), "Neighbour", neighbour);
}

}

vtkFiniteVolumeQuality::vtkFiniteVolumeQuality()
{
  this->SetNumberOfOutputPorts(2);
}

int vtkFiniteVolumeQuality::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

int vtkFiniteVolumeQuality::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

int vtkFiniteVolumeQuality::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  return 1; // each process asks for the piece that is asked of it
}

int vtkFiniteVolumeQuality::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkUnstructuredGrid* grid = vtkUnstructuredGrid::GetData(input[0]);
  vtkUnstructuredGrid* mesh = vtkUnstructuredGrid::GetData(output, 0);
  vtkPolyData* faces = vtkPolyData::GetData(output, 1);
  this->Run(0, 1, [&](cartesian::Execution& execution) {
    execution.stage("Faces", 0, 0.5);
    const cartesian::FaceList list = cartesian::shareFaces(
      cartesian::cellFacesFromVTK(grid), grid->GetNumberOfPoints(), execution);
    execution.stage("Quality measures", 0.5, 1);
    std::vector<double> copy;
    const cartesian::Quality quality = cartesian::measureQuality(
      cartesian::coordinates(grid, copy), list, grid->GetNumberOfCells(), execution);
    mesh->ShallowCopy(grid);
    SetMeasures(quality.cells, quality.cellFailures, mesh->GetCellData());
    SetFaces(list, grid, faces);
    SetMeasures(quality.faces, quality.faceFailures, faces->GetCellData());
    for (const auto& [name, value] : cartesian::summarise(quality, list))
    {
      cartesian::setField(mesh, name.c_str(), { value });
      cartesian::setField(faces, name.c_str(), { value });
    }
  });
  return 1;
}
