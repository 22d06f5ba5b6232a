// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshSummary.h"

#include "Base/Error.h"
#include "Quality/QualityMeasures.h"
#include "vtkFiniteVolumeQuality.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkThreshold.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <sstream>

vtkStandardNewMacro(vtkMeshSummary);

namespace
{

constexpr double Percent = 100;

// A line for each statistic that is not 0.
struct Told
{
  const char* field;
  const char* text;
};
constexpr std::array<Told, 14> WhatWasDone{ {
  { "TrianglesTurned", "Triangles of the surface turned over" },
  { "DuplicatesLeftOut", "Duplicate triangles left out" },
  { "LooseTrianglesLeftOut", "Triangles that touch no other left out" },
  { "HolesClosed", "Holes in the surface closed" },
  { "LeaksClosed", "Holes wider than a box closed" },
  { "BoxesRebuilt", "Boxes made anew, as the surface does not close there" },
  { "BoxesFlawed", "Boxes left out, as they do not close" },
  { "SmallCellsMerged", "Small cells merged" },
  { "SmallCellsRemoved", "Small cells left out" },
  { "RefusedCellsRemoved", "Cells left out that solvers would refuse" },
  { "FragmentCellsRemoved", "Cells left out that the grid cuts off" },
  { "IsolatedCells", "Cells that few or no others are connected with" },
  { "PartsLeftOut", "Parts without a Keep Point left out" },
  { "VoidsInsideCells", "Closed pieces of surface inside one cell" },
} };

// The value of a field data array, or 0.
double Field(vtkDataObject* data, const std::string& name, vtkIdType i = 0)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name.c_str());
  return array && i < array->GetNumberOfTuples() ? array->GetComponent(i, 0) : 0;
}

// Of cells, the worst first; ghosts and cells without a value do not count.
std::vector<vtkIdType> Ranked(vtkUnstructuredGrid* mesh, const cartesian::MeasureSpec& spec)
{
  vtkDataArray* values = mesh->GetCellData()->GetArray(spec.name);
  vtkUnsignedCharArray* ghosts = mesh->GetCellGhostArray();
  std::vector<vtkIdType> cells;
  for (vtkIdType cell = 0; values && cell < values->GetNumberOfTuples(); ++cell)
  {
    if (!std::isnan(values->GetComponent(cell, 0)) && !(ghosts && ghosts->GetValue(cell) != 0))
    {
      cells.push_back(cell);
    }
  }
  std::stable_sort(cells.begin(), cells.end(), [&](vtkIdType a, vtkIdType b) {
    const double x = values->GetComponent(a, 0);
    const double y = values->GetComponent(b, 0);
    return spec.largeIsWorse ? x > y : x < y;
  });
  return cells;
}

std::array<double, 3> MiddleOf(vtkUnstructuredGrid* mesh, vtkIdType cell)
{
  std::array<double, 6> bounds;
  mesh->GetCellBounds(cell, bounds.data());
  return { (bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2, (bounds[4] + bounds[5]) / 2 };
}

// A value and its place.
using Place = std::array<double, 4>;

// The worst cell of all processes, each of which must call this; false: there is none.
bool WorstPlace(vtkUnstructuredGrid* mesh, const cartesian::MeasureSpec& spec, Place& worst)
{
  const double none = std::nan("");
  Place mine{ none, 0, 0, 0 };
  if (const std::vector<vtkIdType> cells = Ranked(mesh, spec); !cells.empty())
  {
    const auto [x, y, z] = MiddleOf(mesh, cells[0]);
    mine = { mesh->GetCellData()->GetArray(spec.name)->GetComponent(cells[0], 0), x, y, z };
  }
  std::vector<Place> all{ mine };
  vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
  if (processes && processes->GetNumberOfProcesses() > 1)
  {
    all.resize(static_cast<std::size_t>(processes->GetNumberOfProcesses()));
    processes->AllGather(mine.data(), all.data()->data(), static_cast<vtkIdType>(mine.size()));
  }
  worst = all[0];
  for (const Place& place : all)
  {
    const bool isWorse = spec.largeIsWorse ? place[0] > worst[0] : place[0] < worst[0];
    worst = isWorse || std::isnan(worst[0]) ? place : worst;
  }
  return !std::isnan(worst[0]);
}

void TellMeasures(vtkUnstructuredGrid* mesh, std::ostream& text)
{
  text << "Worst cells:\n";
  for (const cartesian::MeasureSpec& spec : cartesian::MeasureSpecs)
  {
    Place worst;
    if (WorstPlace(mesh, spec, worst) && std::isfinite(worst[0]) && worst[0] != spec.best)
    {
      text << "  " << spec.name << " " << cartesian::number(worst[0]) << " at ("
           << cartesian::number(worst[1]) << ", " << cartesian::number(worst[2]) << ", "
           << cartesian::number(worst[3]) << ")";
      const double failures = Field(mesh, std::string(spec.name) + "Failures");
      text << (failures > 0 ? ", " + cartesian::number(failures) + " at fault" : "") << "\n";
    }
  }
  const double failing = Field(mesh, "FailingCells");
  text << (failing > 0 ? cartesian::number(failing) + " cells are at fault\n"
                       : "No cell is at fault\n");
}

void TellNamed(vtkDataObject* mesh, const char* title, const char* namesOf, const char* valuesOf,
  const char* what, std::ostream& text)
{
  auto* names = vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray(namesOf));
  for (vtkIdType i = 0; names && i < names->GetNumberOfValues(); ++i)
  {
    text << (i == 0 ? title : "") << "  " << names->GetValue(i) << ": " << what << " "
         << cartesian::number(Field(mesh, valuesOf, i)) << "\n";
  }
}

void TellWhatWasDone(vtkDataObject* mesh, std::ostream& text)
{
  for (const Told& told : WhatWasDone)
  {
    if (const double count = Field(mesh, told.field); count > 0)
    {
      text << told.text << ": " << cartesian::number(count) << "\n";
    }
  }
  if (const double relaxed = Field(mesh, "SizesRelaxed"); relaxed > 0)
  {
    text << "Sizes asked for are " << cartesian::number(Percent * relaxed)
         << " % larger, for the Cell Budget\n";
  }
}

// `mesh`: with the measures, on all processes.
std::string Summary(vtkUnstructuredGrid* mesh)
{
  std::ostringstream text;
  text.precision(12);
  text << Field(mesh, "Cells") << " cells";
  if (mesh->GetFieldData()->HasArray("Hexahedra"))
  {
    text << " (" << Field(mesh, "Hexahedra") << " hexahedra), " << Field(mesh, "Points")
         << " points";
  }
  text << "\nVolume " << cartesian::number(Field(mesh, "TotalVolume")) << ", boundary "
       << cartesian::number(Field(mesh, "BoundaryArea")) << "\n";
  TellNamed(mesh, "Regions:\n", "RegionNames", "RegionVolumes", "volume", text);
  TellNamed(mesh, "Boundaries:\n", "BoundaryNames", "BoundaryAreas", "area", text);
  TellMeasures(mesh, text);
  TellWhatWasDone(mesh, text);
  return text.str();
}

void SelectWorst(
  vtkUnstructuredGrid* mesh, const cartesian::MeasureSpec& spec, int number, vtkDataObject* output)
{
  vtkNew<vtkIntArray> rank;
  rank->SetName("Rank");
  rank->SetNumberOfValues(mesh->GetNumberOfCells());
  rank->FillValue(0);
  const std::vector<vtkIdType> cells = Ranked(mesh, spec);
  const std::size_t count = std::min(cells.size(), static_cast<std::size_t>(number));
  for (std::size_t i = 0; i < count; ++i)
  {
    rank->SetValue(cells[i], static_cast<int>(i) + 1);
  }
  vtkNew<vtkUnstructuredGrid> ranked;
  ranked->ShallowCopy(mesh);
  ranked->GetCellData()->AddArray(rank);
  vtkNew<vtkThreshold> worst;
  worst->SetInputData(ranked);
  worst->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Rank");
  worst->SetThresholdFunction(vtkThreshold::THRESHOLD_UPPER);
  worst->SetUpperThreshold(1);
  worst->Update();
  output->ShallowCopy(worst->GetOutput());
}

}

vtkMeshSummary::vtkMeshSummary()
{
  this->SetNumberOfOutputPorts(2);
}

int vtkMeshSummary::FillInputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

int vtkMeshSummary::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkTable" : "vtkUnstructuredGrid");
  return 1;
}

int vtkMeshSummary::RequestUpdateExtent(
  vtkInformation* /*request*/, vtkInformationVector** input, vtkInformationVector* /*output*/)
{
  return AskForNeighbours(input);
}

int vtkMeshSummary::RequestData(
  vtkInformation* /*request*/, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkNew<vtkUnstructuredGrid> grid;
  grid->ShallowCopy(vtkUnstructuredGrid::GetData(input[0]));
  vtkNew<vtkFiniteVolumeQuality> quality;
  quality->SetNumberOfThreads(this->NumberOfThreads);
  quality->SetInputData(grid);
  quality->Update();
  this->ErrorCode = quality->GetErrorCode();
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(quality->GetOutputDataObject(0));
  const std::string text = Summary(mesh);
  vtkNew<vtkStringArray> texts;
  texts->SetName("Text");
  texts->InsertNextValue(text);
  vtkTable::GetData(output, 0)->AddColumn(texts);
  if (this->ErrorCode == 0)
  {
    SelectWorst(mesh, cartesian::MeasureSpecs[static_cast<std::size_t>(this->Measure)],
      this->NumberOfWorstCells, vtkUnstructuredGrid::GetData(output, 1));
  }
  return 1;
}

void vtkMeshSummary::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Measure: " << this->Measure << "\n";
  os << indent << "NumberOfWorstCells: " << this->NumberOfWorstCells << "\n";
}
