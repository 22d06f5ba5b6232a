// SPDX-License-Identifier: BSD-3-Clause
#include "vtkQualityHistogram.h"

#include "Base/Error.h"
#include "FieldData.h"
#include "MeshValues.h"
#include "Quality/Histogram.h"
#include "vtkFiniteVolumeQuality.h"

#include "vtkCommunicator.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkQualityHistogram);

namespace
{

constexpr double NoCell = 0.5; // where a logarithmic axis begins

vtkMultiProcessController* SeveralProcesses()
{
  vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
  return processes && processes->GetNumberOfProcesses() > 1 ? processes : nullptr;
}

// Of all processes, each of which must call this.
template <class Number>
std::vector<Number> Reduced(const std::vector<Number>& mine, int operation)
{
  std::vector<Number> all = mine;
  if (vtkMultiProcessController* processes = SeveralProcesses())
  {
    processes->AllReduce(mine.data(), all.data(), static_cast<vtkIdType>(mine.size()), operation);
  }
  return all;
}

// Of all processes.
cartesian::Histogram Counted(const std::vector<double>& values, std::size_t bins)
{
  const cartesian::ValueRange mine = cartesian::rangeOf(values);
  const std::vector<double> ends =
    Reduced<double>({ -mine.low, mine.high }, vtkCommunicator::MAX_OP);
  cartesian::Histogram histogram = cartesian::histogramOf(values, { -ends[0], ends[1] }, bins);
  const std::vector<vtkIdType> counts = Reduced<vtkIdType>(
    { histogram.counts.begin(), histogram.counts.end() }, vtkCommunicator::SUM_OP);
  std::copy(counts.begin(), counts.end(), histogram.counts.begin());
  return histogram;
}

template <class Array, class Values>
void AddColumn(vtkTable* table, const std::string& name, const Values& values)
{
  vtkNew<Array> column;
  column->SetName(name.c_str());
  for (const auto value : values)
  {
    column->InsertNextValue(value);
  }
  table->AddColumn(column);
}

void FillBins(const cartesian::Histogram& histogram, vtkTable* table)
{
  std::vector<double> low;
  std::vector<double> high;
  std::vector<vtkIdType> cells;
  for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin)
  {
    low.push_back(histogram.edge(bin));
    high.push_back(histogram.edge(bin + 1));
    cells.push_back(static_cast<vtkIdType>(histogram.counts[bin]));
  }
  AddColumn<vtkDoubleArray>(table, "Low", low);
  AddColumn<vtkDoubleArray>(table, "High", high);
  AddColumn<vtkIdTypeArray>(table, "Cells", cells);
}

void FillOutline(
  const cartesian::Histogram& histogram, const cartesian::MeshValues& of, vtkTable* table)
{
  std::vector<double> at{ histogram.range.low };
  std::vector<double> cells{ NoCell };
  double most = 1;
  for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin)
  {
    const double count = std::max(NoCell, static_cast<double>(histogram.counts[bin]));
    at.insert(at.end(), { histogram.edge(bin), histogram.edge(bin + 1) });
    cells.insert(cells.end(), { count, count });
    most = std::max(most, count);
  }
  at.push_back(histogram.range.high);
  cells.push_back(NoCell);
  if (!of.limit.empty())
  {
    std::vector<double> limit(at.size(), std::nan(""));
    limit.insert(limit.end(), { NoCell, most });
    at.insert(at.end(), { of.limitAt, of.limitAt });
    cells.insert(cells.end(), { std::nan(""), std::nan("") });
    AddColumn<vtkDoubleArray>(table, of.name, at);
    AddColumn<vtkDoubleArray>(table, "Cells", cells);
    AddColumn<vtkDoubleArray>(table, of.limit, limit);
    return;
  }
  AddColumn<vtkDoubleArray>(table, of.name, at);
  AddColumn<vtkDoubleArray>(table, "Cells", cells);
}

void FillTables(const cartesian::Histogram& histogram, const cartesian::MeshValues& of,
  vtkTable* outline, vtkTable* bins)
{
  FillOutline(histogram, of, outline);
  FillBins(histogram, bins);
  if (!of.limit.empty())
  {
    cartesian::setField(outline, "Limit", { of.limitAt });
    cartesian::setField(bins, "Limit", { of.limitAt });
  }
}

}

vtkQualityHistogram::vtkQualityHistogram()
{
  this->SetNumberOfOutputPorts(2);
}

int vtkQualityHistogram::FillInputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

int vtkQualityHistogram::FillOutputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

int vtkQualityHistogram::RequestUpdateExtent(
  vtkInformation* /*request*/, vtkInformationVector** input, vtkInformationVector* /*output*/)
{
  return AskForNeighbours(input);
}

int vtkQualityHistogram::RequestData(
  vtkInformation* /*request*/, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkNew<vtkUnstructuredGrid> grid;
  grid->ShallowCopy(vtkUnstructuredGrid::GetData(input[0]));
  vtkNew<vtkFiniteVolumeQuality> quality;
  quality->SetNumberOfThreads(this->NumberOfThreads);
  quality->SetInputData(grid);
  quality->Update();
  this->ErrorCode = quality->GetErrorCode();
  const auto values =
    cartesian::valuesOf(vtkUnstructuredGrid::SafeDownCast(quality->GetOutputDataObject(0)),
      vtkPolyData::SafeDownCast(quality->GetOutputDataObject(1)),
      static_cast<std::size_t>(this->Measure));
  const double known = Reduced<double>({ values ? 1.0 : 0.0 }, vtkCommunicator::MAX_OP)[0];
  if (this->ErrorCode == 0 && known == 0)
  {
    const bool isShare = this->Measure == cartesian::VolumeFraction;
    this->ErrorCode = MissingArray;
    vtkErrorMacro("The mesh has no array " << (isShare ? "VolumeFraction" : "Layer")
                                           << ": connect the Mesh of Cartesian Mesher"
                                           << (isShare ? "." : ", made with Layers."));
    return 1;
  }
  const cartesian::MeshValues mine = values.value_or(cartesian::MeshValues{});
  const cartesian::Histogram histogram = Counted(mine.values, static_cast<std::size_t>(this->Bins));
  this->AxisTitle = mine.name + (mine.limit.empty() ? "" : " (" + mine.limit + ")");
  vtkMultiProcessController* processes = SeveralProcesses();
  if (this->ErrorCode == 0 && (!processes || processes->GetLocalProcessId() == 0))
  {
    FillTables(histogram, mine, vtkTable::GetData(output, 0), vtkTable::GetData(output, 1));
  }
  return 1;
}

void vtkQualityHistogram::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Measure: " << this->Measure << "\n";
  os << indent << "Bins: " << this->Bins << "\n";
}
