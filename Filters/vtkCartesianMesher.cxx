// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCartesianMesher.h"

#include "AreaWarning.h"
#include "Base/Error.h"
#include "BoundarySettings.h"
#include "DefectsToVTK.h"
#include "ExpectedTable.h"
#include "FieldData.h"
#include "FilterOptions.h"
#include "GhostCells.h"
#include "LayerWarning.h"
#include "LengthUnit.h"
#include "MeshCheck.h"
#include "MeshCut.h"
#include "MeshToVTK.h"
#include "Mesher/CellBudget.h"
#include "Mesher/Mesher.h"
#include "Mesher/Messages.h"
#include "Mesher/VolumeLoss.h"
#include "OpenFoam/FoamBoundary.h"
#include "Parts/Decomposition.h"
#include "ReportErrors.h"
#include "SizesFromVTK.h"
#include "SurfaceFromVTK.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <numeric>

vtkStandardNewMacro(vtkCartesianMesher);

namespace
{

constexpr const char* HowToSee = "\nTo see these places, show the output Defects and use Zoom to "
                                 "Data; for one of them, Find Data and Zoom to Selection.";

cartesian::Bounds BoundsOf(const vtkBoundingBox& box)
{
  cartesian::Bounds bounds{};
  box.GetMinPoint(bounds.low.data());
  box.GetMaxPoint(bounds.high.data());
  return bounds;
}

// Calls `work`; adds the way of a leak that it throws to the defects.
template <class Work>
void ShowLeak(vtkPolyData* defects, cartesian::Execution& execution, Work&& work)
{
  try
  {
    work();
  }
  catch (const cartesian::Leak& leak)
  {
    cartesian::addLeak(leak.path, defects, execution);
    throw;
  }
}

}

// What all pieces of a mesh have in common.
struct vtkCartesianMesher::Task
{
  vtkMTimeType time = 0; // of the filter and its inputs
  std::unique_ptr<cartesian::SurfaceFromVTK> surface;
  cartesian::BoundaryNames types; // of boundaries
  std::vector<std::string> regionNames;
  cartesian::Options options; // all but refinement
  cartesian::PreparedSurface prepared;
  std::unique_ptr<cartesian::Decomposition> decomposition;
  std::vector<cartesian::SlabRange> pieces;
  std::vector<cartesian::Id> cells; // of each piece made so far
  std::vector<cartesian::Id> points;
};

// A mesh of which pieces are cut.
struct vtkCartesianMesher::WholeMesh
{
  vtkMTimeType time = 0;
  vtkNew<vtkUnstructuredGrid> mesh;
  vtkNew<vtkPolyData> boundary;
  vtkNew<vtkPolyData> defects;
  vtkNew<vtkPolyData> interfaces;
  std::vector<cartesian::SlabRange> pieces;
};

// One piece, before it is written.
struct vtkCartesianMesher::Piece
{
  int number = 0;
  int count = 1;
  int ghostLevels = 0;
  std::unique_ptr<cartesian::Assembly> assembly;
};

vtkCartesianMesher::vtkCartesianMesher()
{
  this->SetNumberOfOutputPorts(4);
}

vtkCartesianMesher::~vtkCartesianMesher() = default;

int vtkCartesianMesher::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

int vtkCartesianMesher::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  return !this->InPieces && IsLeftToFirstProcess(request, output) ? 1 : AskForWholeInputs(input);
}

cartesian::Options vtkCartesianMesher::MakeOptions()
{
  cartesian::Options options = this->Superclass::MakeOptions();
  cartesian::setDomainOptions(this, options);
  cartesian::setPatchOptions(this, options);
  cartesian::setCellOptions(this, options);
  options.cracks.width = this->CrackWidth;
  options.closeGaps = this->CloseGaps;
  options.contactTolerance = this->ContactTolerance;
  options.sheets = static_cast<cartesian::SheetHandling>(this->Sheets);
  options.cellBudget = this->CellBudget;
  options.layers.count = this->Layers;
  options.layers.ratio = this->LayerExpansionRatio;
  options.layers.firstThickness = this->FirstLayerThickness;
  options.layers.thickness = this->LayersThickness;
  options.layers.lastByBox = this->LastLayer;
  options.layers.refine = this->RefineForLayers;
  const double unit = this->MetresInUnit();
  options.layers.flow = { this->TargetYPlus, this->FlowSpeed / unit,
    this->FlowViscosity / (unit * unit), this->FlowLength };
  for (const auto& [boundary, back] : this->Baffles)
  {
    options.baffles.push_back({ boundary, back });
  }
  options.zones = this->Zones;
  return options;
}

double vtkCartesianMesher::MetresInUnit()
{
  return this->LengthUnit == FromInput
    ? cartesian::metresPerUnit(this->GetInputDataObject(0, 0))
    : cartesian::MetresPerUnits.at(static_cast<std::size_t>(this->LengthUnit - Metre));
}

std::string vtkCartesianMesher::NoteOfLength(double longest)
{
  return cartesian::describeLength(longest * this->MetresInUnit());
}

vtkStringArray* vtkCartesianMesher::GetFlowZones()
{
  this->FlowZones->Initialize();
  const vtkBoundingBox box = this->BoundsOfInput();
  const cartesian::Options options = this->MakeOptions();
  if (!box.IsValid() || !this->RefinesFlow(options.domain))
  {
    return this->FlowZones;
  }
  const cartesian::Bounds surface = BoundsOf(box);
  // What is out of range the work itself will say.
  cartesian::reportErrors(
    [&] {
      cartesian::FlowRefinement flow =
        cartesian::flowRefinement(options.domain, options.grid, surface);
      if (!this->RefinementShapes.empty() || this->GetNumberOfInputConnections(1) > 0)
      {
        flow.zones.clear();
      }
      cartesian::toVTK(flow, this->FlowZones);
    },
    [](unsigned long, const std::string&) {});
  return this->FlowZones;
}

const char* vtkCartesianMesher::GetDomainNote()
{
  const vtkBoundingBox box = this->BoundsOfInput();
  this->DomainNote =
    box.IsValid() ? cartesian::describeAcross(this->MakeOptions().domain, BoundsOf(box)) : "";
  return this->DomainNote.c_str();
}

vtkStringArray* vtkCartesianMesher::GetExpectedLayers()
{
  this->GetExpectedBoxes();
  return this->ExpectedLayers;
}

void vtkCartesianMesher::BeginEstimate(const cartesian::Options* options)
{
  this->ExpectedLayers->Initialize();
  if (options && options->layers.any())
  {
    cartesian::requireValid(options->layers);
    const auto [layers, box] = cartesian::expectedLayers(*options, BoundsOf(this->BoundsOfInput()));
    cartesian::toVTK(
      layers, cartesian::totalThickness(layers, box), this->MetresInUnit(), this->ExpectedLayers);
  }
}

cartesian::BoundarySettings vtkCartesianMesher::GivenBoundaries() const
{
  return { this->BoundaryNames, this->BoundaryTypes, this->BoundaryRatios, this->BoundaryLayers,
    this->BoundaryDepths, this->BoundaryMergedNames };
}

cartesian::BoundarySettings vtkCartesianMesher::Boundaries() const
{
  return cartesian::merged(this->GivenBoundaries());
}

cartesian::SurfaceFromVTK vtkCartesianMesher::Read(vtkDataObject* data) const
{
  cartesian::SurfaceFromVTK surface(data, this->BoundaryArray,
    static_cast<cartesian::RegionSource>(this->RegionsFrom), this->RegionArray);
  surface.rename(cartesian::mergedNames(this->GivenBoundaries(), surface.names()));
  surface.leaveOutOpenBodies(cartesian::baffleBoundaries(this->Boundaries(), surface.names()));
  return surface;
}

void vtkCartesianMesher::AddBoundaryOptions(
  const cartesian::SurfaceFromVTK& surface, cartesian::Options& options)
{
  const cartesian::BoundarySettings boundaries = this->Boundaries();
  options.layers.boundaries =
    cartesian::boundaryLayers(boundaries, surface.names(), surface.sides());
  options.layers.regions = cartesian::layerRegions(this->LayerRegions, surface.regionNames());
  options.smallCells.boundaryRatios = cartesian::boundaryRatios(
    boundaries, surface.names(), surface.sides(), options.smallCells.handling);
}

// But for the ground, flow passes through the sides of the box.
void vtkCartesianMesher::AddTypesOfSides(Task& task) const
{
  for (int side = 0; task.options.domain.isOutside() && side < 6; ++side)
  {
    const bool isSymmetric = this->Half > 0 && side == 2 * (this->Half - 1);
    const char* type = isSymmetric ? "symmetryPlane" : side + 1 == this->Ground ? "wall" : "patch";
    task.types.emplace(task.surface->sides()[static_cast<std::size_t>(side)], type);
  }
}

// Boundaries that are symmetries by their names alone.
void vtkCartesianMesher::WarnOfSymmetries(const Task& task)
{
  const cartesian::EndBoundaries& sides = task.surface->sides();
  std::string found;
  for (const auto& [boundary, name] : task.surface->names())
  {
    const bool isSide = std::find(sides.begin(), sides.end(), boundary) != sides.end();
    if (!isSide && task.types.count(boundary) == 0 && cartesian::isSymmetry(name))
    {
      found += (found.empty() ? "" : ", ") + name;
    }
  }
  this->Warn(found.empty()
      ? ""
      : "By name, these boundaries are symmetries, which have no layers: " + found +
        ". Where that is not meant, set their Boundary Type to wall; where it is, to symmetry or, "
        "if "
        "flat, symmetryPlane, and this warning ends.");
}

// Both sides of a baffle are walls.
void vtkCartesianMesher::AddBaffles(Task& task)
{
  this->Baffles.clear();
  for (const auto& [boundary, type] : std::map<std::int32_t, std::string>(task.types))
  {
    if (type == cartesian::BaffleType)
    {
      const std::int32_t back = task.surface->addBack(boundary);
      this->Baffles.emplace_back(boundary, back);
      task.types[boundary] = "wall";
      task.types[back] = "wall";
    }
  }
}

// They divide the domain, and bound nothing.
void vtkCartesianMesher::AddZones(Task& task)
{
  this->Zones.clear();
  task.regionNames = task.surface->regionNames();
  for (const auto& [boundary, type] : std::map<std::int32_t, std::string>(task.types))
  {
    if (type == cartesian::ZoneType)
    {
      if (this->Zones.empty())
      {
        task.regionNames = { "fluid" };
      }
      this->Zones.push_back(boundary);
      task.regionNames.push_back(task.surface->names().at(boundary));
      task.types.erase(boundary);
    }
  }
}

void vtkCartesianMesher::Begin(Task& task, const Piece& piece,
  const cartesian::Processes& processes, vtkInformationVector** input, vtkInformationVector* output,
  cartesian::Execution& execution)
{
  const vtkSmartPointer<vtkDataObject> surface = processes.whole(vtkDataObject::GetData(input[0]));
  std::vector<vtkSmartPointer<vtkDataObject>> regions = Regions(input[1]);
  for (auto& region : regions)
  {
    region = processes.whole(region);
  }
  // All that needs the others comes first: any of them may fail from here on.
  vtkDataObject* const field = vtkDataObject::GetData(input[2]);
  cartesian::AskedSizes inField;
  if (field && !this->SizeArray.empty())
  {
    inField = cartesian::sizesInField(this->SizeArray, field);
    inField.boxes = processes.all(inField.boxes);
    inField.isThere = processes.sum({ inField.isThere ? 1.0 : 0.0 })[0] > 0;
  }
  task.surface = std::make_unique<cartesian::SurfaceFromVTK>(this->ReadWithSides(surface));
  task.types =
    cartesian::boundaryTypes(this->Boundaries(), task.surface->names(), task.surface->sides());
  this->WarnOfSymmetries(task);
  this->AddBaffles(task);
  this->AddZones(task);
  task.options = this->MakeOptions();
  this->AddBoundaryOptions(*task.surface, task.options);
  this->AddTypesOfSides(task);
  cartesian::planStages(task.options, execution);
  task.prepared = this->Prepare(*task.surface, execution, piece.count);
  if (piece.number == 0)
  {
    this->Inspect(task.prepared, *task.surface, vtkPolyData::GetData(output, 2), execution);
  }
  cartesian::AskedSizes sizes =
    field ? std::move(inField) : this->ReadSizes(surface, *task.surface, nullptr);
  task.decomposition =
    this->Divide(*task.surface, task.prepared, regions, std::move(sizes), execution);
  task.pieces = { task.decomposition->allLayers() };
  if (piece.count > 1)
  {
    task.pieces = task.decomposition->split(
      task.decomposition->estimateLayers(execution), static_cast<std::size_t>(piece.count));
  }
}

void vtkCartesianMesher::Make(const Task& task, Piece& piece, cartesian::Execution& execution)
{
  if (task.options.cellBudget > 0)
  {
    piece.assembly =
      cartesian::meshWithinBudget(task.prepared, *task.decomposition, task.options, execution);
    return;
  }
  piece.assembly = cartesian::meshPart(task.prepared, *task.decomposition,
    task.pieces[static_cast<std::size_t>(piece.number)], task.options, execution);
}

void vtkCartesianMesher::CountPiecesBefore(
  Task& task, const Piece& piece, cartesian::Execution& execution)
{
  while (task.cells.size() < static_cast<std::size_t>(piece.number))
  {
    Piece before;
    before.number = static_cast<int>(task.cells.size());
    before.count = piece.count;
    Make(task, before, execution);
    task.cells.push_back(before.assembly->mesh->cellCount());
    task.points.push_back(before.assembly->mesh->ownPointCount());
  }
}

int vtkCartesianMesher::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  this->Made->Initialize(); // after an error there is none
  Piece piece;
  vtkInformation* info = AskedOutput(request, output);
  if (info->Has(Pipeline::UPDATE_PIECE_NUMBER()))
  {
    piece.number = info->Get(Pipeline::UPDATE_PIECE_NUMBER());
    piece.count = std::max(1, info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()));
    piece.ghostLevels = info->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS());
  }
  if (!this->InPieces)
  {
    piece.count = 1;
  }
  if (piece.number >= piece.count)
  {
    return 1;
  }
  const cartesian::Processes processes(piece.number, piece.count);
  this->IsSilent = processes.areSeveral() && piece.number > 0;
  if (piece.count > 1 && this->NeedsWholeMesh())
  {
    this->RequestCutPiece(piece, processes, input, output);
  }
  else if (processes.areSeveral())
  {
    this->RequestPieceOfProcess(piece, processes, input, output);
  }
  else
  {
    this->RequestPieceAlone(piece, input, output);
  }
  this->IsSilent = false;
  return 1;
}

// Of the filter and its inputs.
vtkMTimeType vtkCartesianMesher::TimeWith(vtkInformationVector** input)
{
  vtkMTimeType time = this->GetMTime();
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < input[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkDataObject* data = vtkDataObject::GetData(input[port], i);
      time = std::max(time, data ? data->GetMTime() : 0);
    }
  }
  return time;
}

// Each process makes all of it: the same everywhere.
bool vtkCartesianMesher::MakeWholeMesh(
  WholeMesh& whole, int pieces, const cartesian::Processes& processes, vtkInformationVector** input)
{
  vtkNew<vtkInformationVector> outputs;
  for (vtkDataObject* data : std::initializer_list<vtkDataObject*>{
         whole.mesh, whole.boundary, whole.defects, whole.interfaces })
  {
    vtkNew<vtkInformation> info;
    info->Set(vtkDataObject::DATA_OBJECT(), data);
    outputs->Append(info);
  }
  Task task;
  Piece all;
  this->HasOtherFailed = [&] { return processes.hasOtherFailed(); };
  const bool isDone = this->Run(0, 1, [&](cartesian::Execution& execution) {
    ShowLeak(whole.defects, execution, [&] {
      this->Begin(task, all, processes, input, outputs, execution);
      Make(task, all, execution);
    });
    this->Write(task, all, {}, outputs, execution);
    whole.pieces = task.decomposition->split(
      task.decomposition->estimateLayers(execution), static_cast<std::size_t>(pieces));
  });
  this->HasOtherFailed = nullptr;
  if (!isDone)
  {
    processes.tellFailure();
  }
  const unsigned long code = CodeOfAll(
    processes.gather({ isDone ? 0.0 : static_cast<double>(this->GetErrorCode()) }), processes);
  if (code != vtkErrorCode::NoError)
  {
    this->ErrorCode = code;
  }
  return code == vtkErrorCode::NoError;
}

void vtkCartesianMesher::RequestCutPiece(const Piece& piece, const cartesian::Processes& processes,
  vtkInformationVector** input, vtkInformationVector* output)
{
  const vtkMTimeType time = this->TimeWith(input);
  std::unique_ptr<WholeMesh> whole = std::move(this->KeptWhole);
  const bool isSame = whole && !processes.areSeveral() && whole->time == time &&
    whole->pieces.size() == static_cast<std::size_t>(piece.count);
  if (!isSame)
  {
    whole = std::make_unique<WholeMesh>();
    whole->time = time;
    if (!this->MakeWholeMesh(*whole, piece.count, processes, input))
    {
      vtkPolyData::GetData(output, 2)->ShallowCopy(whole->defects);
      return;
    }
  }
  vtkUnstructuredGrid* const mesh = vtkUnstructuredGrid::GetData(output, 0);
  cartesian::cutPiece({ whole->mesh, whole->boundary, whole->interfaces }, whole->pieces,
    static_cast<std::size_t>(piece.number), processes,
    { mesh, vtkPolyData::GetData(output, 1), vtkPolyData::GetData(output, 3) });
  if (piece.number == 0)
  {
    vtkPolyData::GetData(output, 2)->ShallowCopy(whole->defects);
  }
  if (piece.ghostLevels > 0 && processes.areSeveral())
  {
    cartesian::addGhostCells(mesh, piece.ghostLevels, processes);
  }
  if (piece.number + 1 < piece.count && !processes.areSeveral())
  {
    this->KeptWhole = std::move(whole);
  }
}

void vtkCartesianMesher::RequestPieceAlone(
  Piece& piece, vtkInformationVector** input, vtkInformationVector* output)
{
  const vtkMTimeType time = this->TimeWith(input);
  const bool isSame = this->Kept && this->Kept->time == time &&
    this->Kept->pieces.size() == static_cast<std::size_t>(piece.count);
  std::unique_ptr<Task> task = isSame ? std::move(this->Kept) : std::make_unique<Task>();
  this->Kept.reset();
  const bool isDone = this->Run(0, 1, [&](cartesian::Execution& execution) {
    ShowLeak(vtkPolyData::GetData(output, 2), execution, [&] {
      if (!isSame)
      {
        this->Begin(*task, piece, {}, input, output, execution);
        task->time = time;
      }
      this->CountPiecesBefore(*task, piece, execution);
      Make(*task, piece, execution);
    });
    const auto number = static_cast<std::ptrdiff_t>(piece.number);
    const cartesian::MeshPiece place{ std::accumulate(task->cells.begin(),
                                        task->cells.begin() + number, cartesian::Id(0)),
      std::accumulate(task->points.begin(), task->points.begin() + number, cartesian::Id(0)),
      piece.count == 1, {} };
    const cartesian::OutputMesh& mesh = *piece.assembly->mesh;
    if (piece.number + 1 == piece.count && place.cellsBefore + mesh.cellCount() == 0)
    {
      throw cartesian::nothingToMesh(*piece.assembly, task->options);
    }
    if (task->cells.size() == static_cast<std::size_t>(piece.number))
    {
      task->cells.push_back(mesh.cellCount());
      task->points.push_back(mesh.ownPointCount());
    }
    this->Write(*task, piece, place, output, execution);
  });
  if (isDone && piece.number + 1 < piece.count)
  {
    this->Kept = std::move(task);
  }
}

// The first error code of any process; that it was stopped only if none has another: others failing stops it.
unsigned long vtkCartesianMesher::CodeOfAll(
  const std::vector<std::vector<double>>& counts, const cartesian::Processes& processes)
{
  unsigned long code = vtkErrorCode::NoError;
  std::vector<std::size_t> failed;
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    const auto own = static_cast<unsigned long>(counts[i][0]);
    if (own != vtkErrorCode::NoError)
    {
      failed.push_back(i);
      code = code == vtkErrorCode::NoError || code == Stopped ? own : code;
    }
  }
  processes.forgetFailures(failed);
  return code;
}

// Where one process fails, all do; nobody waits for it.
void vtkCartesianMesher::RequestPieceOfProcess(Piece& piece, const cartesian::Processes& processes,
  vtkInformationVector** input, vtkInformationVector* output)
{
  Task task;
  this->HasOtherFailed = [&] { return processes.hasOtherFailed(); };
  const bool isDone = this->Run(0, cartesian::AfterLayers, [&](cartesian::Execution& execution) {
    this->Begin(task, piece, processes, input, output, execution);
    Make(task, piece, execution);
  });
  this->HasOtherFailed = nullptr;
  if (!isDone)
  {
    processes.tellFailure();
  }
  const cartesian::OutputMesh* mesh = isDone ? piece.assembly->mesh.get() : nullptr;
  const std::vector<std::vector<double>> counts =
    processes.gather({ isDone ? 0.0 : static_cast<double>(this->GetErrorCode()),
      isDone ? static_cast<double>(mesh->cellCount()) : 0,
      isDone ? static_cast<double>(mesh->ownPointCount()) : 0 });
  cartesian::MeshPiece place{ 0, 0, false, processes };
  if (const unsigned long code = CodeOfAll(counts, processes); code != vtkErrorCode::NoError)
  {
    this->ErrorCode = code;
    return;
  }
  double cells = 0;
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    place.cellsBefore += static_cast<int>(i) < piece.number ? cartesian::Id(counts[i][1]) : 0;
    place.pointsBefore += static_cast<int>(i) < piece.number ? cartesian::Id(counts[i][2]) : 0;
    cells += counts[i][1];
  }
  this->IsWaitedFor = true;
  this->Run(cartesian::AfterLayers, 1, [&](cartesian::Execution& execution) {
    if (cells == 0)
    {
      throw cartesian::nothingToMesh(*piece.assembly, task.options);
    }
    this->Write(task, piece, place, output, execution);
  });
  this->IsWaitedFor = false;
}

void vtkCartesianMesher::Write(const Task& task, const Piece& piece,
  const cartesian::MeshPiece& place, vtkInformationVector* output, cartesian::Execution& execution)
{
  vtkUnstructuredGrid* mesh = vtkUnstructuredGrid::GetData(output, 0);
  cartesian::setRepairs(task.prepared.repair, mesh);
  cartesian::setRepairs(task.prepared.repair, vtkPolyData::GetData(output, 1));
  if (this->MetresInUnit() != 1)
  {
    cartesian::setField(mesh, cartesian::MetresPerUnitField, { this->MetresInUnit() });
  }
  if (this->IsotropicLevels)
  {
    cartesian::setField(mesh, "IsotropicLevels", { 1 });
  }
  if (!this->Zones.empty())
  {
    cartesian::setField(mesh, "RegionsAreZones", { 1 });
  }
  if (task.options.domain.isOutside())
  {
    cartesian::setVector(mesh, "FlowDirection", cartesian::unitAlong(task.options.domain.flow));
  }
  cartesian::toVTK(*piece.assembly, { task.surface->names(), task.types, task.regionNames }, place,
    mesh, vtkPolyData::GetData(output, 1), vtkPolyData::GetData(output, 3), execution);
  cartesian::addCellsLeftOut(*piece.assembly, vtkPolyData::GetData(output, 2));
  const bool wasSilent = this->IsSilent; // flaws of a piece are told by its own process
  this->IsSilent = wasSilent && place.isWhole;
  const auto checked =
    piece.assembly->layers ? cartesian::Checked::All : cartesian::Checked::AtWalls;
  const cartesian::MeshCheck check = cartesian::checkMesh(mesh, checked, execution);
  cartesian::toVTK(check, mesh->GetNumberOfCells(), this->Made);
  cartesian::addFailingCells(mesh, check.failing, vtkPolyData::GetData(output, 2));
  std::string flaws = cartesian::describeFlaws(*piece.assembly, task.surface->names());
  const std::string failures = cartesian::describeFailures(check, mesh);
  flaws += (flaws.empty() || failures.empty() ? "" : "\n") + failures;
  this->Warn(flaws.empty() ? "" : flaws + HowToSee);
  cartesian::setFindings(cartesian::sum(check, place.processes), mesh);
  this->Warn(cartesian::describeNoSurface(mesh));
  if (place.isWhole)
  {
    this->WarnOfLosses(task, piece, mesh, execution);
  }
  if (piece.assembly->layers)
  {
    cartesian::addEndedLayers(
      *piece.assembly->layers, vtkPolyData::GetData(output, 1), vtkPolyData::GetData(output, 2));
    this->Warn(cartesian::describeBareWalls(*piece.assembly->layers, mesh));
    this->Warn(cartesian::describeJumps(*piece.assembly->layers, mesh));
  }
  if (task.options.cellBudget > 0)
  {
    this->Warn(cartesian::describeBudget(*piece.assembly, task.options));
  }
  this->IsSilent = wasSilent;
  if (piece.ghostLevels > 0 && place.processes.areSeveral())
  {
    cartesian::addGhostCells(mesh, piece.ghostLevels, place.processes);
  }
}

// Of volume and of areas.
void vtkCartesianMesher::WarnOfLosses(
  const Task& task, const Piece& piece, vtkUnstructuredGrid* mesh, cartesian::Execution& execution)
{
  const cartesian::Assembly& assembly = *piece.assembly;
  this->Warn(cartesian::describe(
    cartesian::findVolumeLoss(task.prepared, assembly, execution), task.regionNames));
  if (assembly.separate.leftOut == 0)
  {
    this->Warn(cartesian::describeWrongAreas(
      task.prepared.surface, assembly.boxes.planes, task.surface->names(), mesh));
  }
}

int vtkCartesianMesher::EstimateNumberOfPieces()
{
  if (!this->InPieces || this->NeedsWholeMesh())
  {
    return 1;
  }
  std::size_t pieces = 0;
  this->Run(0, 1, [&](cartesian::Execution& execution) {
    vtkDataObject* const data = this->UpdatedSurface();
    const cartesian::SurfaceFromVTK surface = this->ReadWithSides(data);
    constexpr int Many = 1 << 20;
    const cartesian::PreparedSurface prepared = this->Prepare(surface, execution, Many);
    this->UpdateOptionalInputs();
    const auto decomposition = this->Divide(surface, prepared, this->OptionalRegions(),
      this->ReadSizes(data, surface, this->GetInputDataObject(2, 0)), execution);
    pieces = decomposition->partsNeeded(decomposition->estimateLayers(execution));
  });
  return static_cast<int>(pieces);
}

void vtkCartesianMesher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  cartesian::printPatchProperties(this, os, indent);
  cartesian::printCellProperties(this, os, indent);
  this->PrintBoundarySettings(os, indent);
  os << indent << "InPieces: " << this->InPieces << "\n";
  os << indent << "CellBudget: " << this->CellBudget << "\n";
  cartesian::printLayerProperties(this, os, indent);
  PrintColumn(os, indent, "LayerRegions", this->LayerRegions);
  PrintColumn(os, indent, "BoundaryLayersThickness", this->BoundaryLayers);
  PrintColumn(os, indent, "BoundaryMergedNames", this->BoundaryMergedNames);
  cartesian::printDomainProperties(this, os, indent);
  os << indent << "RegionsFrom: " << this->RegionsFrom << "\n";
  os << indent << "RegionArray: " << this->RegionArray << "\n";
  os << indent << "CrackWidth: " << this->CrackWidth << "\n";
  os << indent << "CloseGaps: " << this->CloseGaps << "\n";
  os << indent << "ContactTolerance: " << this->ContactTolerance << "\n";
  os << indent << "Sheets: " << this->Sheets << "\n";
}
