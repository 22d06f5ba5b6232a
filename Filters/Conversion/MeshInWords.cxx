// SPDX-License-Identifier: BSD-3-Clause
#include "MeshInWords.h"

#include "Base/Error.h"
#include "Base/Words.h"
#include "Quality/WorstMeasure.h"

#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <sstream>

namespace cartesian
{

namespace
{

constexpr double Percent = 100;

// A line for each statistic that is not 0.
struct Told
{
  const char* field;
  const char* text;
};
constexpr std::array<Told, 15> WhatWasDone{ {
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
  { "BoxesForLayers", "Boxes added where walls with layers bend (Refine For Layers)" },
  { "VoidsInsideCells", "Closed pieces of surface inside one cell" },
} };

// The value of a field data array, or 0.
double field(vtkDataObject* data, const std::string& name, vtkIdType i = 0)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name.c_str());
  return array && i < array->GetNumberOfTuples() ? array->GetComponent(i, 0) : 0;
}

std::array<double, 3> middleOf(vtkUnstructuredGrid* mesh, vtkIdType cell)
{
  std::array<double, 6> bounds;
  mesh->GetCellBounds(cell, bounds.data());
  return { (bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2, (bounds[4] + bounds[5]) / 2 };
}

// A value and its place.
using Place = std::array<double, 4>;

// The worst cell of all processes, each of which must call this; false: there is none.
bool worstPlace(vtkUnstructuredGrid* mesh, Measure measure, Place& worst)
{
  const MeasureSpec& spec = MeasureSpecs[measure];
  const double none = std::nan("");
  Place mine{ none, 0, 0, 0 };
  if (const std::vector<vtkIdType> cells = rankedCells(mesh, measure); !cells.empty())
  {
    const auto [x, y, z] = middleOf(mesh, cells[0]);
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
  { "Volume", "No volume" },
  { "Openness", "Open: the faces do not close the cell" },
  { "OpenEdges", "Open edges" },
  { "BoundaryAngle", "Face pyramid: a boundary face is inverted" },
  { "InnerAngle", "Face pyramid: an inner face is tilted by 75 degrees or more" },
  { "Skewness", "Skewness" },
  { "NonOrthogonality", "Non-orthogonality, for limited schemes" },
  { "AspectRatio", "Aspect ratio" },
  { "FaceWeight", "Face weight: a neighbour is much nearer to the face" },
  { "VolumeRatio", "Volume ratio of two neighbours" },
  { "Determinant", "Cell determinant: inner faces in fewer than three directions" },
  { "StarTriangulation", "A face that is not star-shaped" },
} };

// Of all processes, each of which must call this.
double sum(double mine)
{
  vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
  double sum = mine;
  if (processes && processes->GetNumberOfProcesses() > 1)
  {
    processes->AllReduce(&mine, &sum, 1, vtkCommunicator::SUM_OP);
  }
  return sum;
}

std::string cellCount(double count)
{
  return number(count) + (count == 1 ? " cell" : " cells");
}

// What checkMesh counts, by region; over several processes, which need not know the same regions, of all together.
void tellFindings(const MeshCheck& check, std::ostream& text)
{
  vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
  const bool isAlone = !processes || processes->GetNumberOfProcesses() == 1;
  bool any = false;
  for (std::size_t r = 0; r < (isAlone ? check.regions.size() : 1); ++r)
  {
    const std::string name = isAlone ? check.regions[r] : "";
    const Findings findings = isAlone ? check.ofRegions[r] : check.sum();
    for (std::size_t f = 0; f < FindingCount; ++f)
    {
      const FindingSpec& spec = FindingSpecs[f];
      const double count = sum(static_cast<double>(findings[f]));
      if (count > 0)
      {
        text << (any ? "" : "What checkMesh counts:\n");
        any = true;
        text << "  " << (name.empty() ? "" : name + ": ") << number(count) << " "
             << (count == 1 ? spec.one : spec.several) << "\n";
      }
    }
  }
}

void tellVerdict(vtkUnstructuredGrid* mesh, const MeshCheck& check, std::ostream& text)
{
  const double refused = sum(static_cast<double>(check.failing.size()));
  if (field(mesh, "Cells") == 0) // it could not be measured
  {
    return;
  }
  text << (refused == 0 ? "OpenFOAM accepts all cells\n"
                        : "OpenFOAM's checkMesh fails: " + cellCount(refused) + "\n");
  bool any = false;
  for (const Told& told : WhatFails)
  {
    if (const double failing = field(mesh, std::string(told.field) + "Failures"); failing > 0)
    {
      text << "  " << told.text << ": " << cellCount(failing) << "\n";
      any = true;
    }
  }
  text << (any ? "  To see them, press Show Failing Cells\n" : "");
  tellFindings(check, text);
}

void tellSize(vtkDataObject* mesh, std::ostream& text)
{
  text << "Cells: " << field(mesh, "Cells");
  if (mesh->GetFieldData()->HasArray("Hexahedra"))
  {
    text << " (hexahedra: " << field(mesh, "Hexahedra") << "), points: " << field(mesh, "Points");
  }
  text << "\nVolume: " << number(field(mesh, "TotalVolume"))
       << ", boundary: " << number(field(mesh, "BoundaryArea")) << "\n";
}

std::string limitOf(const MeasureSpec& spec)
{
  return spec.limit == NoLimit || spec.limit == 0
    ? ""
    : std::string(spec.largeIsWorse ? "at most " : "at least ") + number(spec.limit);
}

// The nearest to its limit first. All processes must call this.
std::vector<WorstValue> worstValues(vtkUnstructuredGrid* mesh)
{
  std::vector<WorstValue> values;
  for (std::size_t m = 0; m < MeasureCount; ++m)
  {
    const MeasureSpec& spec = MeasureSpecs[m];
    Place worst;
    if (worstPlace(mesh, static_cast<Measure>(m), worst) && std::isfinite(worst[0]) &&
      worst[0] != spec.best)
    {
      const double failing = field(mesh, std::string(spec.name) + "Failures");
      const bool isFailure = failing > 0 && (FailuresForSolvers >> m & 1U) != 0;
      const double nearness = nearnessToLimit(static_cast<Measure>(m), worst[0], standardLimits());
      values.push_back({ std::max(nearness, isFailure ? 1.0 : 0.0), wordsOf(spec.name),
        number(worst[0]), limitOf(spec),
        "(" + number(worst[1]) + ", " + number(worst[2]) + ", " + number(worst[3]) + ")",
        failing });
    }
  }
  std::stable_sort(values.begin(), values.end(),
    [](const WorstValue& a, const WorstValue& b) { return a.nearness > b.nearness; });
  return values;
}

void tellRegions(vtkDataObject* mesh, std::ostream& text)
{
  auto* names = vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray("RegionNames"));
  for (vtkIdType i = 0; names && i < names->GetNumberOfValues(); ++i)
  {
    const double parts = field(mesh, "RegionParts", i);
    text << (i == 0 ? "Regions:\n" : "") << "  " << names->GetValue(i) << ": volume "
         << number(field(mesh, "RegionVolumes", i))
         << (parts > 1 ? ", in " + number(parts) + " parts" : "") << "\n";
  }
}

// Rounded down: all is all.
std::string inPercent(double share)
{
  return number(std::floor(10 * Percent * share) / 10) + " %";
}

// Those without layers because none were to be there: by type, name or row.
void tellBoundariesWithoutLayers(vtkDataObject* mesh, vtkStringArray* names, std::ostream& text)
{
  const char* separator = "No layers asked on ";
  for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
  {
    if (field(mesh, "BoundaryLayersAsked", i) == 0 && field(mesh, "BoundaryAreas", i) > 0)
    {
      text << separator << names->GetValue(i);
      separator = ", ";
    }
  }
  text << (separator[0] == ',' ? "\n" : "");
}

// The largest ones.
void tellBoundaries(vtkDataObject* mesh, std::ostream& text)
{
  constexpr std::size_t Most = 10;
  auto* names =
    vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray("BoundaryNames"));
  std::vector<vtkIdType> order(static_cast<std::size_t>(names ? names->GetNumberOfValues() : 0));
  std::iota(order.begin(), order.end(), 0);
  const auto areaOf = [&](vtkIdType i) { return field(mesh, "BoundaryAreas", i); };
  std::stable_sort(
    order.begin(), order.end(), [&](vtkIdType a, vtkIdType b) { return areaOf(a) > areaOf(b); });
  const bool hasLayers = mesh->GetFieldData()->HasArray("BoundaryLayerCoverages") != 0;
  for (std::size_t i = 0; i < std::min(order.size(), Most); ++i)
  {
    const vtkIdType n = order[i];
    const double coverage = field(mesh, "BoundaryLayerCoverages", n);
    text << (i == 0 ? "Boundaries:\n" : "") << "  " << names->GetValue(n) << ": area "
         << number(areaOf(n))
         << (hasLayers && coverage > 0 ? ", layers on " + inPercent(coverage) + ", " +
                  number(field(mesh, "BoundaryLayerThicknesses", n)) + " thick, whole stacks on " +
                  inPercent(field(mesh, "BoundaryWholeStacks", n)) +
                  ", the first layer as asked on " +
                  inPercent(field(mesh, "BoundaryFirstLayersKept", n)) + ", bare " +
                  number(field(mesh, "BoundaryBareAreas", n)) + ", the last layer 1:" +
                  number(
                    std::round(1 / std::max(1e-9, field(mesh, "BoundaryLastLayerRatios", n)))) +
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
    text << "Layers on " << inPercent(field(mesh, "LayerCoverage")) << " of the walls\n";
    tellBoundariesWithoutLayers(mesh, names, text);
  }
}

void tellWhatWasDone(vtkDataObject* mesh, std::ostream& text)
{
  for (const Told& told : WhatWasDone)
  {
    if (const double count = field(mesh, told.field); count > 0)
    {
      text << told.text << ": " << number(count) << "\n";
    }
  }
  if (const double volume = field(mesh, "VolumeLeftOut"); volume > 0)
  {
    text << "Volume of the cells left out: " << number(volume) << "\n";
  }
  if (const double enclosed = field(mesh, "SurfaceVolume"); enclosed > 0)
  {
    text << "Volume error: " << number(Percent * (field(mesh, "TotalVolume") / enclosed - 1))
         << " % of what the surface encloses\n";
  }
  if (const double relaxed = field(mesh, "SizesRelaxed"); relaxed > 0)
  {
    text << "Requested sizes are enlarged by " << number(Percent * relaxed)
         << " % to meet the Cell Budget\n";
  }
}

// What `tell` writes.
template <class Tell>
std::string textOf(Tell&& tell)
{
  std::ostringstream text;
  text.precision(12);
  tell(text);
  return text.str();
}

}

// Of cells, the worst first; ghosts and cells without a value do not count.
std::vector<vtkIdType> rankedCells(vtkUnstructuredGrid* mesh, Measure measure)
{
  const MeasureSpec& spec = MeasureSpecs[measure];
  vtkDataArray* values = mesh->GetCellData()->GetArray(spec.name);
  vtkUnsignedCharArray* ghosts = mesh->GetCellGhostArray();
  vtkDataArray* const layers = mesh->GetCellData()->GetArray("Layer");
  const auto isGood = [&](vtkIdType cell) {
    return layers && layers->GetComponent(cell, 0) > 0 &&
      isGoodInLayers(measure, values->GetComponent(cell, 0));
  };
  std::vector<vtkIdType> cells;
  for (vtkIdType cell = 0; values && cell < values->GetNumberOfTuples(); ++cell)
  {
    if (!std::isnan(values->GetComponent(cell, 0)) && !(ghosts && ghosts->GetValue(cell) != 0) &&
      !isGood(cell))
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

std::string MeshInWords::worst(std::size_t most) const
{
  std::string text;
  for (std::size_t i = 0; i < std::min(worstValues.size(), most); ++i)
  {
    const WorstValue& value = worstValues[i];
    text += (i == 0 ? "Worst values, the nearest to its limit first:\n  " : "  ") + value.measure +
      ": " + value.value + (value.limit.empty() ? "" : " of " + value.limit) + " at " +
      value.place + "\n";
  }
  return text;
}

MeshInWords inWords(vtkUnstructuredGrid* mesh, const MeshCheck& check)
{
  MeshInWords words;
  words.verdict = textOf([&](std::ostream& text) { tellVerdict(mesh, check, text); });
  words.size = textOf([&](std::ostream& text) { tellSize(mesh, text); });
  words.regions = textOf([&](std::ostream& text) { tellRegions(mesh, text); });
  words.boundaries = textOf([&](std::ostream& text) { tellBoundaries(mesh, text); });
  words.done = textOf([&](std::ostream& text) { tellWhatWasDone(mesh, text); });
  words.worstValues = worstValues(mesh);
  return words;
}

}
