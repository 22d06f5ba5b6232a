// SPDX-License-Identifier: BSD-3-Clause
#include "MeshReport.h"

#include "Base/Error.h"
#include "BoundaryOfFaces.h"
#include "MeshInWords.h"
#include "MeshValues.h"
#include "Quality/FaceCorners.h"
#include "Quality/WorstMeasure.h"
#include "ReportPictures.h"
#include "vtkFiniteVolumeQuality.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDummyController.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnsignedIntArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <sstream>

namespace cartesian
{

namespace
{

constexpr std::size_t WorstCellsShown = 10;

// Filters that work on this process only: the others do not take part.
class Alone
{
public:
  Alone()
    : before_(vtkMultiProcessController::GetGlobalController())
  {
    vtkMultiProcessController::SetGlobalController(alone_);
  }
  ~Alone() { vtkMultiProcessController::SetGlobalController(before_); }
  Alone(const Alone&) = delete;
  Alone& operator=(const Alone&) = delete;

private:
  vtkSmartPointer<vtkMultiProcessController> before_;
  vtkNew<vtkDummyController> alone_;
};

struct BoundaryRow
{
  std::size_t faces = 0;
  double area = 0;
};

std::vector<std::string> linesOf(const std::string& text)
{
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
  {
    lines.push_back(line);
  }
  return lines;
}

// Of a field data array with a value for each boundary; 0 where there is none.
double fieldOf(vtkDataObject* data, const char* name, vtkIdType row)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array && row >= 0 && row < array->GetNumberOfTuples() ? array->GetComponent(row, 0) : 0;
}

class Report
{
public:
  Report(vtkUnstructuredGrid* grid, const Upstream& upstream)
    : upstream_(upstream)
  {
    vtkNew<vtkUnstructuredGrid> input;
    input->ShallowCopy(grid);
    quality_->SetInputData(input);
    quality_->Update();
    mesh_ = vtkUnstructuredGrid::SafeDownCast(quality_->GetOutputDataObject(0));
    if (quality_->GetErrorCode() != 0 || mesh_->GetNumberOfCells() == 0)
    {
      throw Error(
        Fault::BadMesh, "There are no cells to report of, or their quality cannot be measured.");
    }
    cells_ = facesOfCells(mesh_, execution_);
    faces_ = listFaces(cells_, static_cast<std::size_t>(mesh_->GetNumberOfPoints()),
      Clashes::AreBoundary, execution_);
    std::vector<vtkIdType> cellOf(cells_.cellCount());
    std::iota(cellOf.begin(), cellOf.end(), 0);
    const bool isKnown = readBoundaryOfFaces(mesh_, cells_, cellOf, faces_, boundary_,
                           execution_) == BoundaryKnowledge::All;
    boundary_.resize(faces_.face.size() - faces_.neighbour.size(), UnknownBoundary);
    if (!isKnown)
    {
      std::fill(boundary_.begin(), boundary_.end(), UnknownBoundary);
    }
    points_ = coordinatesOf(mesh_, copy_);
    measureBoundaries();
  }

  ReportPage run()
  {
    const MeshCheck check = checkMesh(mesh_, Checked::All, execution_);
    const MeshInWords words = inWords(mesh_, check);
    ReportPage page;
    page.title = "Mesh report";
    page.lines = linesOf(words.verdict);
    page.verdict = page.lines.front();
    page.lines.erase(page.lines.begin());
    page.isGood = check.failing.empty();
    for (const std::string& line : linesOf(words.size))
    {
      page.lines.push_back(line);
    }
    addPictures(page);
    addBoundaries(page);
    addWorst(words.worstValues, page);
    addHistograms(page);
    addLists(words, page);
    return page;
  }

private:
  void measureBoundaries()
  {
    for (std::size_t i = 0; i < boundary_.size(); ++i)
    {
      BoundaryRow& row = rows_[boundary_[i]];
      const std::size_t face = faces_.face[faces_.neighbour.size() + i];
      row.faces += 1;
      row.area += norm(FaceCorners(cells_, points_).geometry(face).area);
    }
  }

  // As the window has them: in the order of the boundaries' numbers.
  Colour colourOf(vtkIdType boundary) const
  {
    return boundary == UnknownBoundary ? Colour{ 0.8, 0.8, 0.8 }
                                       : colourOfBoundary(static_cast<std::size_t>(
                                           boundary == NoBoundary ? rows_.size() : boundary));
  }

  static std::string nameOf(vtkIdType boundary, const std::map<vtkIdType, std::string>& names)
  {
    const auto name = names.find(boundary);
    return name != names.end()      ? name->second
      : boundary == NoBoundary      ? "no_surface"
      : boundary == UnknownBoundary ? "(not of a surface)"
                                    : "boundary_" + std::to_string(boundary);
  }

  // In the field data of boundaries.
  vtkIdType rowOf(vtkIdType boundary) const
  {
    vtkDataArray* ids = mesh_->GetFieldData()->GetArray("BoundaryIds");
    vtkIdType row = 0;
    while (ids && row < ids->GetNumberOfTuples() &&
      static_cast<vtkIdType>(ids->GetComponent(row, 0)) != boundary)
    {
      ++row;
    }
    return row;
  }

  void addBoundaries(ReportPage& page) const
  {
    const auto names = readBoundaryTexts(mesh_, "BoundaryNames");
    const auto types = readBoundaryTexts(mesh_, "BoundaryTypes");
    const bool hasLayers = mesh_->GetFieldData()->HasArray("BoundaryLayerCoverages") != 0;
    ReportTable table{ "Boundaries", { "Name", "Type", "Faces", "Area" }, {} };
    if (hasLayers)
    {
      table.heads.insert(table.heads.end(), { "Layers on", "Thickness of layers" });
    }
    for (const auto& [boundary, row] : rows_)
    {
      const auto type = types.find(boundary);
      std::vector<std::string> texts{ nameOf(boundary, names),
        type == types.end() || type->second.empty() ? "automatic" : type->second,
        std::to_string(row.faces), number(row.area) };
      if (hasLayers)
      {
        constexpr double Percent = 100;
        const vtkIdType at = rowOf(boundary);
        const double share = fieldOf(mesh_, "BoundaryLayerCoverages", at);
        texts.push_back(share > 0 ? number(std::floor(10 * Percent * share) / 10) + " %" : "");
        texts.push_back(share > 0 ? number(fieldOf(mesh_, "BoundaryLayerThicknesses", at)) : "");
      }
      table.rows.push_back(texts);
      table.colours.push_back(colourOf(boundary));
    }
    page.tables.push_back(table);
  }

  // Those that fail; if none does, the worst by the worst measure.
  std::vector<std::uint32_t> cellsToShow(std::string& caption) const
  {
    const std::string measure = quality_->GetWorstMeasure();
    const auto* const spec = std::find_if(MeasureSpecs.begin(), MeasureSpecs.end(),
      [&](const MeasureSpec& known) { return known.name == measure; });
    const std::vector<vtkIdType> ranked =
      rankedCells(mesh_, static_cast<Measure>(spec - MeasureSpecs.begin()));
    auto* failures = vtkUnsignedIntArray::SafeDownCast(mesh_->GetCellData()->GetArray("Failures"));
    std::vector<std::uint32_t> which;
    for (const vtkIdType cell : ranked)
    {
      if ((failures->GetValue(cell) & FailuresForSolvers) != 0)
      {
        which.push_back(static_cast<std::uint32_t>(cell));
      }
    }
    caption = std::to_string(which.size()) + (which.size() == 1 ? " cell fails" : " cells fail");
    if (which.empty())
    {
      which.assign(ranked.begin(),
        ranked.begin() + static_cast<std::ptrdiff_t>(std::min(ranked.size(), WorstCellsShown)));
      caption = "No cell fails; the worst " + std::to_string(which.size()) + " by " + measure;
    }
    return which;
  }

  void addPictures(ReportPage& page) const
  {
    DrawnMesh drawn{ points_, cells_, faces_, {}, {} };
    if (vtkDataArray* flow = mesh_->GetFieldData()->GetArray("FlowDirection");
        flow && flow->GetNumberOfComponents() == 3 && flow->GetNumberOfTuples() > 0)
    {
      drawn.flow.emplace();
      flow->GetTuple(0, drawn.flow->data());
    }
    for (const vtkIdType boundary : boundary_)
    {
      drawn.colours.push_back(colourOf(boundary));
    }
    page.pictures.push_back(pictureOfBoundary(drawn));
    page.pictures.push_back(pictureOfCut(drawn));
    std::string caption;
    const std::vector<std::uint32_t> which = cellsToShow(caption);
    page.pictures.push_back(pictureOfCells(drawn, which));
    page.pictures.back().caption = caption;
  }

  static void addWorst(const std::vector<WorstValue>& values, ReportPage& page)
  {
    ReportTable table{ "Worst values, the nearest to its limit first",
      { "Measure", "Worst", "Limit", "Cells that fail", "At" }, {} };
    for (const WorstValue& value : values)
    {
      table.rows.push_back(
        { value.measure, value.value, value.limit, number(value.failing), value.place });
    }
    page.tables.push_back(table);
  }

  void addHistograms(ReportPage& page) const
  {
    constexpr std::size_t Bins = 40;
    auto* faces = vtkPolyData::SafeDownCast(quality_->GetOutputDataObject(1));
    for (const std::size_t which : { std::size_t(Skewness), std::size_t(NonOrthogonality),
           std::size_t(VolumeFraction), std::size_t(FirstLayerHeight) })
    {
      const auto values = valuesOf(mesh_, faces, which);
      if (values && !values->values.empty())
      {
        page.histograms.push_back({ values->name, values->limit, values->limitAt,
          !values->limit.empty(), histogramOf(values->values, rangeOf(values->values), Bins) });
      }
    }
  }

  void addLists(const MeshInWords& words, ReportPage& page) const
  {
    if (!words.regions.empty())
    {
      page.lists.push_back(
        { "Regions", linesOf(words.regions.substr(words.regions.find('\n') + 1)) });
    }
    if (!words.done.empty())
    {
      page.lists.push_back({ "What the mesher did", linesOf(words.done) });
    }
    if (!upstream_.hasMesher)
    {
      page.lists.push_back({ "Settings and warnings",
        { "Not known: save the report from the output of Cartesian Mesher itself." } });
      return;
    }
    ReportTable settings{ "Settings that differ from the defaults", { "Of", "Property", "Value" },
      {} };
    for (const UpstreamSetting& setting : upstream_.settings)
    {
      settings.rows.push_back({ setting.filter, setting.property, setting.value });
    }
    page.tables.push_back(settings);
    page.lists.push_back({ "Warnings",
      upstream_.warnings.empty() ? std::vector<std::string>{ "None" } : upstream_.warnings });
  }

  const Upstream& upstream_;
  Alone alone_;
  Execution execution_{ 0 };
  vtkNew<vtkFiniteVolumeQuality> quality_;
  vtkUnstructuredGrid* mesh_;
  CellFaces cells_;
  FaceList faces_;
  std::vector<vtkIdType> boundary_; // of each boundary face
  std::vector<double> copy_;
  const double* points_;
  std::map<vtkIdType, BoundaryRow> rows_;
};

}

ReportPage reportOf(vtkUnstructuredGrid* grid, const Upstream& upstream)
{
  return Report(grid, upstream).run();
}

}
