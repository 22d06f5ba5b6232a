// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshSummary.h"

#include "Base/Error.h"
#include "MeshCheck.h"
#include "Quality/QualityMeasures.h"
#include "vtkFiniteVolumeQuality.h"

#include "vtkCellData.h"
#include "vtkCommunicator.h"
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
  { "TrianglesTurned", "Triangles of the surface reoriented" },
  { "DuplicatesLeftOut", "Duplicate triangles left out" },
  { "LooseTrianglesLeftOut", "Triangles that touch no other left out" },
  { "HolesClosed", "Holes in the surface closed" },
  { "LeaksClosed", "Holes wider than a box closed" },
  { "BoxesRebuilt", "Boxes rebuilt because the surface does not close there" },
  { "BoxesFlawed", "Boxes left out because they do not close" },
  { "SmallCellsMerged", "Small cells merged" },
  { "SmallCellsRemoved", "Small cells left out" },
  { "RefusedCellsRemoved", "Failing cells left out (solvers would reject them)" },
  { "FragmentCellsRemoved", "Cells left out because the grid cuts them off" },
  { "IsolatedCells", "Cells connected to few or no others" },
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

// Failures in words, the worst for a solver first.
constexpr std::array<Told, 12> WhatFails{ {
  { "Volume", "no volume" },
  { "Openness", "faces that do not close it" },
  { "OpenEdges", "open edges" },
  { "BoundaryAngle", "an inverted boundary face" },
  { "InnerAngle", "an inner face tilted by 75 degrees or more" },
  { "Skewness", "very skew" },
  { "NonOrthogonality", "very non-orthogonal, for limited schemes" },
  { "AspectRatio", "very long" },
  { "FaceWeight", "a neighbour much nearer to a face (weight)" },
  { "VolumeRatio", "a neighbour of very different volume" },
  { "Determinant", "inner faces in fewer than three directions" },
  { "StarTriangulation", "a face that is not star-shaped" },
} };

// Of all processes, each of which must call this.
double Sum(double mine)
{
  vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
  double sum = mine;
  if (processes && processes->GetNumberOfProcesses() > 1)
  {
    processes->AllReduce(&mine, &sum, 1, vtkCommunicator::SUM_OP);
  }
  return sum;
}

std::string Cells(double number)
{
  return cartesian::number(number) + (number == 1 ? " cell" : " cells");
}

// What checkMesh counts, by region; over several processes, which need not know the same regions, of all together.
void TellFindings(const cartesian::MeshCheck& check, std::ostream& text)
{
  vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
  const bool isAlone = !processes || processes->GetNumberOfProcesses() == 1;
  bool any = false;
  for (std::size_t r = 0; r < (isAlone ? check.regions.size() : 1); ++r)
  {
    const std::string name = isAlone ? check.regions[r] : "";
    const cartesian::Findings findings = isAlone ? check.ofRegions[r] : check.sum();
    for (std::size_t f = 0; f < cartesian::FindingCount; ++f)
    {
      const cartesian::FindingSpec& spec = cartesian::FindingSpecs[f];
      const double count = Sum(static_cast<double>(findings[f]));
      if (count > 0)
      {
        text << (any ? "" : "What checkMesh counts:\n");
        any = true;
        text << "  " << (name.empty() ? "" : name + ": ") << cartesian::number(count) << " "
             << (count == 1 ? spec.one : spec.several) << "\n";
      }
    }
  }
}

void TellVerdict(vtkUnstructuredGrid* mesh, const cartesian::MeshCheck& check, std::ostream& text)
{
  const double refused = Sum(static_cast<double>(check.failing.size()));
  if (Field(mesh, "Cells") == 0) // it could not be measured
  {
    return;
  }
  text << (refused == 0 ? "OpenFOAM accepts all cells\n"
                        : "OpenFOAM's checkMesh fails on " + Cells(refused) + "\n");
  bool any = false;
  for (const Told& told : WhatFails)
  {
    // Long prisms are good cells.
    const double good = std::string(told.field) == "AspectRatio"
      ? Sum(static_cast<double>(check.sum()[cartesian::LongLayers]))
      : 0;
    if (const double failing = Field(mesh, std::string(told.field) + "Failures") - good;
        failing > 0)
    {
      text << "  " << Cells(failing) << ": " << told.text << "\n";
      any = true;
    }
  }
  text << (any ? "  To see them, show the output Worst Cells and choose a Measure\n" : "");
  TellFindings(check, text);
}

void TellWorst(vtkUnstructuredGrid* mesh, std::ostream& text)
{
  text << "Worst values:\n";
  for (const cartesian::MeasureSpec& spec : cartesian::MeasureSpecs)
  {
    Place worst;
    if (WorstPlace(mesh, spec, worst) && std::isfinite(worst[0]) && worst[0] != spec.best)
    {
      text << "  " << spec.name << " " << cartesian::number(worst[0]) << " at ("
           << cartesian::number(worst[1]) << ", " << cartesian::number(worst[2]) << ", "
           << cartesian::number(worst[3]) << ")\n";
    }
  }
}

void TellRegions(vtkDataObject* mesh, std::ostream& text)
{
  auto* names = vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray("RegionNames"));
  for (vtkIdType i = 0; names && i < names->GetNumberOfValues(); ++i)
  {
    const double parts = Field(mesh, "RegionParts", i);
    text << (i == 0 ? "Regions:\n" : "") << "  " << names->GetValue(i) << ": volume "
         << cartesian::number(Field(mesh, "RegionVolumes", i))
         << (parts > 1 ? ", in " + cartesian::number(parts) + " parts" : "") << "\n";
  }
}

// Rounded down: all is all.
std::string InPercent(double share)
{
  return cartesian::number(std::floor(10 * Percent * share) / 10) + " %";
}

// Those without layers because none were to be there: by type, name or row.
void TellBoundariesWithoutLayers(vtkDataObject* mesh, vtkStringArray* names, std::ostream& text)
{
  const char* separator = "No layers asked on ";
  for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
  {
    if (Field(mesh, "BoundaryLayersAsked", i) == 0 && Field(mesh, "BoundaryAreas", i) > 0)
    {
      text << separator << names->GetValue(i);
      separator = ", ";
    }
  }
  text << (separator[0] == ',' ? "\n" : "");
}

// The largest ones.
void TellBoundaries(vtkDataObject* mesh, std::ostream& text)
{
  constexpr std::size_t Most = 10;
  auto* names =
    vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray("BoundaryNames"));
  std::vector<vtkIdType> order(static_cast<std::size_t>(names ? names->GetNumberOfValues() : 0));
  std::iota(order.begin(), order.end(), 0);
  const auto areaOf = [&](vtkIdType i) { return Field(mesh, "BoundaryAreas", i); };
  std::stable_sort(
    order.begin(), order.end(), [&](vtkIdType a, vtkIdType b) { return areaOf(a) > areaOf(b); });
  const bool hasLayers = mesh->GetFieldData()->HasArray("BoundaryLayerCoverages") != 0;
  for (std::size_t i = 0; i < std::min(order.size(), Most); ++i)
  {
    const vtkIdType n = order[i];
    const double coverage = Field(mesh, "BoundaryLayerCoverages", n);
    text << (i == 0 ? "Boundaries:\n" : "") << "  " << names->GetValue(n) << ": area "
         << cartesian::number(areaOf(n))
         << (hasLayers && coverage > 0 ? ", layers on " + InPercent(coverage) + ", " +
                  cartesian::number(Field(mesh, "BoundaryLayerThicknesses", n)) +
                  " thick, whole stacks on " + InPercent(Field(mesh, "BoundaryWholeStacks", n)) +
                  ", the last layer 1:" +
                  cartesian::number(
                    std::round(1 / std::max(1e-9, Field(mesh, "BoundaryLastLayerRatios", n)))) +
                  " of the cell beside it"
                                       : "")
         << "\n";
  }
  if (order.size() > Most)
  {
    text << "  and " << order.size() - Most << " more\n";
  }
  if (hasLayers && names)
  {
    text << "Layers on " << InPercent(Field(mesh, "LayerCoverage")) << " of the walls\n";
    TellBoundariesWithoutLayers(mesh, names, text);
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
  if (const double volume = Field(mesh, "VolumeLeftOut"); volume > 0)
  {
    text << "Volume of the cells left out: " << cartesian::number(volume) << "\n";
  }
  if (const double enclosed = Field(mesh, "SurfaceVolume"); enclosed > 0)
  {
    text << "Volume error: "
         << cartesian::number(Percent * (Field(mesh, "TotalVolume") / enclosed - 1))
         << " % of what the surface encloses\n";
  }
  if (const double relaxed = Field(mesh, "SizesRelaxed"); relaxed > 0)
  {
    text << "Requested sizes are enlarged by " << cartesian::number(Percent * relaxed)
         << " % to meet the Cell Budget\n";
  }
}

// `mesh`: with the measures, on all processes.
std::string Summary(vtkUnstructuredGrid* mesh, const cartesian::MeshCheck& check)
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
  TellVerdict(mesh, check, text);
  TellRegions(mesh, text);
  TellBoundaries(mesh, text);
  TellWhatWasDone(mesh, text);
  TellWorst(mesh, text);
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
  vtkNew<vtkUnstructuredGrid> none;
  cartesian::Execution execution(this->NumberOfThreads);
  const std::string text = Summary(mesh,
    cartesian::checkMesh(
      this->ErrorCode == 0 ? mesh : none.Get(), cartesian::Checked::All, execution));
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
