// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFiniteVolumeQuality.h"

#include "CellSelection.h"
#include "FieldData.h"
#include "GridFaces.h"
#include "Quality/QualityMeasures.h"
#include "Quality/WorstMeasure.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedIntArray.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkFiniteVolumeQuality);

namespace
{

template <class Array, class Values>
void AddArray(vtkCellData* data, const char* name, const Values& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  data->AddArray(array);
}

void SetMeasures(const std::array<cartesian::RawVector<double>, cartesian::MeasureCount>& measures,
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

cartesian::QualityLimits LimitsOf(vtkFiniteVolumeQuality& filter)
{
  cartesian::QualityLimits limits = cartesian::standardLimits();
  limits[cartesian::Openness] = filter.GetOpennessLimit();
  limits[cartesian::BoundaryAngle] = filter.GetBoundaryAngleLimit();
  limits[cartesian::InnerAngle] = filter.GetInnerAngleLimit();
  limits[cartesian::NonOrthogonality] = filter.GetNonOrthogonalityLimit();
  limits[cartesian::Skewness] = filter.GetSkewnessLimit();
  limits[cartesian::FaceWeight] = filter.GetFaceWeightLimit();
  limits[cartesian::VolumeRatio] = filter.GetVolumeRatioLimit();
  limits[cartesian::Determinant] = filter.GetDeterminantLimit();
  limits[cartesian::AspectRatio] = filter.GetAspectRatioLimit();
  return limits;
}

double OverAllProcesses(const cartesian::SummaryValue& entry)
{
  vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
  if (!processes || processes->GetNumberOfProcesses() == 1)
  {
    return entry.value;
  }
  using Reduction = cartesian::SummaryValue::Reduction;
  double result = 0;
  processes->AllReduce(&entry.value, &result, 1,
    entry.reduction == Reduction::Sum         ? vtkCommunicator::SUM_OP
      : entry.reduction == Reduction::Maximum ? vtkCommunicator::MAX_OP
                                              : vtkCommunicator::MIN_OP);
  return result;
}

void SetFaces(const cartesian::CellFaces& cells, const cartesian::FaceList& faces,
  vtkUnstructuredGrid* grid, vtkPolyData* output)
{
  vtkNew<vtkCellArray> polygons;
  polygons->AllocateEstimate(static_cast<vtkIdType>(faces.face.size()), 4);
  for (const std::uint32_t face : faces.face)
  {
    const std::size_t end = cells.firstCorner[face + 1];
    polygons->InsertNextCell(static_cast<int>(end - cells.firstCorner[face]));
    for (std::size_t i = cells.firstCorner[face]; i < end; ++i)
    {
      polygons->InsertCellPoint(cells.corners[i]);
    }
  }
  output->SetPoints(grid->GetPoints());
  output->GetPointData()->PassData(grid->GetPointData());
  output->SetPolys(polygons);
  AddArray<vtkIdTypeArray>(output->GetCellData(), "Owner", faces.owner);
  std::vector<vtkIdType> neighbour(faces.neighbour.begin(), faces.neighbour.end());
  neighbour.resize(faces.owner.size(), -1);
  AddArray<vtkIdTypeArray>(output->GetCellData(), "Neighbour", neighbour);
}

// By the cell array Layer.
void ForgiveLayers(vtkUnstructuredGrid* grid, cartesian::Quality& quality)
{
  vtkDataArray* const layers = grid->GetCellData()->GetArray("Layer");
  for (std::size_t cell = 0; layers && cell < quality.cellFailures.size(); ++cell)
  {
    const bool isLayer = layers->GetComponent(static_cast<vtkIdType>(cell), 0) > 0;
    for (std::size_t m = 0; isLayer && m < cartesian::MeasureCount; ++m)
    {
      if (cartesian::isGoodInLayers(static_cast<cartesian::Measure>(m), quality.cells[m][cell]))
      {
        quality.cellFailures[cell] &= ~(1U << m);
      }
    }
  }
}

void SetFailing(const std::vector<std::uint32_t>& failures, const unsigned char* ghosts,
  vtkUnstructuredGrid* mesh, vtkUnstructuredGrid* output)
{
  std::vector<unsigned char> isChosen(failures.size());
  for (std::size_t cell = 0; cell < failures.size(); ++cell)
  {
    const bool fails = (failures[cell] & cartesian::FailuresForSolvers) != 0;
    isChosen[cell] = fails && !(ghosts && ghosts[cell] != 0) ? 1 : 0;
  }
  cartesian::selectCells(mesh, isChosen, output);
}

}

vtkFiniteVolumeQuality::vtkFiniteVolumeQuality()
{
  this->SetNumberOfOutputPorts(3);
}

int vtkFiniteVolumeQuality::FillInputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

int vtkFiniteVolumeQuality::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 1 ? "vtkPolyData" : "vtkUnstructuredGrid");
  return 1;
}

int vtkFiniteVolumeQuality::RequestUpdateExtent(
  vtkInformation* /*request*/, vtkInformationVector** input, vtkInformationVector* /*output*/)
{
  return AskForNeighbours(input);
}

int vtkFiniteVolumeQuality::RequestData(
  vtkInformation* /*request*/, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkUnstructuredGrid* grid = vtkUnstructuredGrid::GetData(input[0]);
  vtkUnstructuredGrid* mesh = vtkUnstructuredGrid::GetData(output, 0);
  vtkPolyData* faces = vtkPolyData::GetData(output, 1);
  // Empty at first: processes that fail must take part in the sums.
  std::vector<cartesian::SummaryValue> summary = cartesian::summarise({}, {});
  const cartesian::QualityLimits limits = LimitsOf(*this);
  this->Run(0, 1, [&](cartesian::Execution& execution) {
    execution.stage("Faces", 0, 0.5);
    const cartesian::CellFaces cells = cartesian::facesOfCells(grid, execution);
    const cartesian::FaceList list =
      cartesian::listFaces(cells, static_cast<std::size_t>(grid->GetNumberOfPoints()),
        cartesian::Clashes::AreBoundary, execution);
    execution.stage("Quality measures", 0.5, 1);
    std::vector<double> copy;
    cartesian::Quality quality = cartesian::measureQuality(
      cartesian::coordinatesOf(grid, copy), cells, list, execution, limits);
    ForgiveLayers(grid, quality);
    mesh->ShallowCopy(grid);
    SetMeasures(quality.cells, quality.cellFailures, mesh->GetCellData());
    SetFaces(cells, list, grid, faces);
    SetMeasures(quality.faces, quality.faceFailures, faces->GetCellData());
    vtkUnsignedCharArray* ghosts = grid->GetCellGhostArray();
    const unsigned char* isGhost = ghosts ? ghosts->GetPointer(0) : nullptr;
    SetFailing(quality.cellFailures, isGhost, mesh, vtkUnstructuredGrid::GetData(output, 2));
    summary = cartesian::summarise(quality, list, isGhost);
  });
  for (cartesian::SummaryValue& entry : summary)
  {
    entry.value = OverAllProcesses(entry);
    for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
    {
      cartesian::setField(
        vtkDataObject::GetData(output, port), entry.name.c_str(), { entry.value });
    }
  }
  this->WorstMeasure = cartesian::MeasureSpecs[cartesian::worstMeasure(summary, limits)].name;
  return 1;
}

void vtkFiniteVolumeQuality::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OpennessLimit: " << this->OpennessLimit << "\n";
  os << indent << "BoundaryAngleLimit: " << this->BoundaryAngleLimit << "\n";
  os << indent << "InnerAngleLimit: " << this->InnerAngleLimit << "\n";
  os << indent << "NonOrthogonalityLimit: " << this->NonOrthogonalityLimit << "\n";
  os << indent << "SkewnessLimit: " << this->SkewnessLimit << "\n";
  os << indent << "FaceWeightLimit: " << this->FaceWeightLimit << "\n";
  os << indent << "VolumeRatioLimit: " << this->VolumeRatioLimit << "\n";
  os << indent << "DeterminantLimit: " << this->DeterminantLimit << "\n";
  os << indent << "AspectRatioLimit: " << this->AspectRatioLimit << "\n";
}
