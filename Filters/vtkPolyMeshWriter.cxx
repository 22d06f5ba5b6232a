// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolyMeshWriter.h"

#include "Base/Error.h"
#include "BoundaryOfFaces.h"
#include "CaseTables.h"
#include "FoamFromVTK.h"
#include "FoamPieceStore.h"
#include "LengthUnit.h"
#include "OpenFoam/CaseTemplates.h"
#include "OpenFoam/CyclicFaces.h"
#include "OpenFoam/FoamBoundary.h"
#include "OpenFoam/FoamPieceRegions.h"
#include "OpenFoam/FrontalArea.h"
#include "OpenFoam/Rotations.h"
#include "OpenFoam/SolverSetup.h"
#include "PeriodicPairs.h"
#include "Processes.h"

#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <exception>
#include <set>

vtkStandardNewMacro(vtkPolyMeshWriter);

// The pieces that one process has written so far.
struct vtkPolyMeshWriter::PiecesSoFar
{
  std::vector<cartesian::FoamPieceStore> pieces;
  std::vector<cartesian::FoamOutline> outlines;
  bool hasRegions = false;
};

namespace
{

cartesian::FoamFormat FormatOf(int fileType)
{
  return fileType == VTK_ASCII ? cartesian::FoamFormat::Ascii : cartesian::FoamFormat::Binary;
}

int CountProcesses()
{
  vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
  return processes ? processes->GetNumberOfProcesses() : 1;
}

// If one process fails, all stop: the others need not wait for it.
template <class Work>
void OnAll(const cartesian::Processes& processes, Work&& work)
{
  std::exception_ptr mine;
  try
  {
    work();
  }
  catch (...) // the others wait whatever it is: no memory, too
  {
    mine = std::current_exception();
  }
  const std::vector<double> failures = processes.sum({ mine ? 1.0 : 0.0 });
  if (mine)
  {
    std::rethrow_exception(mine);
  }
  if (failures[0] > 0)
  {
    throw cartesian::Error(cartesian::Fault::BadMesh,
      "Another rank cannot write its piece: see the error message of that rank.");
  }
}

cartesian::CompletePiece Complete(cartesian::FoamPiece&& piece, std::size_t number,
  const std::vector<cartesian::FaceNumbers>& numbersOfAll, vtkUnstructuredGrid* grid)
{
  const cartesian::FaceNumbers& numbers = numbersOfAll[number];
  std::vector<vtkIdType> boundaries;
  std::vector<std::size_t> counts;
  for (const cartesian::FaceNumbers::Boundary& boundary : numbers.boundaries)
  {
    boundaries.push_back(boundary.boundary);
    counts.push_back(boundary.count);
  }
  return cartesian::completed(
    std::move(piece), number, numbers, cartesian::patchesOf(grid, boundaries, counts));
}

// Regions that are meshes.
std::vector<cartesian::RegionLabels> LabelsOf(const cartesian::CompletePiece& piece, int regionsAs)
{
  return regionsAs == vtkPolyMeshWriter::Meshes ? cartesian::labelsOfRegions(piece)
                                                : std::vector<cartesian::RegionLabels>();
}

void Join(std::vector<cartesian::RegionLabels>& regions,
  const std::vector<cartesian::RegionLabels>& ofNextPiece)
{
  regions.resize(ofNextPiece.size());
  for (std::size_t i = 0; i < regions.size(); ++i)
  {
    regions[i].add(ofNextPiece[i]);
  }
}

void Enlarge(std::vector<double>& points, double scale)
{
  for (double& coordinate : points)
  {
    coordinate *= scale;
  }
}

// Of a mesh around bodies.
std::optional<cartesian::FlowAround> FlowOf(vtkUnstructuredGrid* grid)
{
  vtkDataArray* const direction = grid->GetFieldData()->GetArray("FlowDirection");
  if (!direction || direction->GetNumberOfComponents() != 3 || direction->GetNumberOfTuples() != 1)
  {
    return {};
  }
  cartesian::FlowAround flow;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double along = direction->GetComponent(0, axis);
    flow.direction = along == 0 ? flow.direction : 2 * axis + (along < 0 ? 1 : 0);
  }
  return flow;
}

// As one mesh or, if there are labels of regions, one for each that has cells.
void WriteMeshes(cartesian::CompletePiece&& piece,
  const std::vector<cartesian::RegionLabels>& regions, double scale,
  cartesian::PolyMeshFiles& files)
{
  cartesian::Execution execution(0);
  Enlarge(piece.mesh.points, scale);
  if (regions.empty())
  {
    piece.mesh.zones = cartesian::zonesOf(piece.regions);
    files.write(piece.mesh, {}, execution);
    return;
  }
  const auto count = std::count_if(regions.begin(), regions.end(),
    [](const cartesian::RegionLabels& region) { return region.cells.size() > 0; });
  for (std::uint32_t i = 0; i < regions.size(); ++i)
  {
    if (regions[i].cells.size() > 0)
    {
      files.write(cartesian::pieceOfRegion(piece, i, regions[i]),
        count == 1 ? std::string() : piece.regions.names[i], execution);
    }
  }
}

}

vtkPolyMeshWriter::vtkPolyMeshWriter() = default;

vtkPolyMeshWriter::~vtkPolyMeshWriter() = default;

vtkTypeBool vtkPolyMeshWriter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const bool isAlone = CountProcesses() == 1;
  const vtkTypeBool done = this->Superclass::ProcessRequest(request, input, output);
  if (request->Has(Pipeline::REQUEST_UPDATE_EXTENT()) && isAlone && this->Pieces > 1)
  {
    vtkInformation* info = input[0]->GetInformationObject(0);
    info->Set(Pipeline::UPDATE_PIECE_NUMBER(),
      this->SoFar ? static_cast<int>(this->SoFar->pieces.size()) : 0);
    info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), this->Pieces);
  }
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()) && isAlone && this->Pieces > 1)
  {
    if (this->SoFar)
    {
      request->Set(Pipeline::CONTINUE_EXECUTING(), 1);
    }
    else
    {
      request->Remove(Pipeline::CONTINUE_EXECUTING());
    }
  }
  return done;
}

void vtkPolyMeshWriter::WriteData()
{
  auto* own = vtkUnstructuredGrid::SafeDownCast(this->GetInput());
  this->WarnOfLongNames(own);
  if (this->Pieces == 1 || !this->HasFileName())
  {
    this->Superclass::WriteData();
  }
  else if (CountProcesses() > 1)
  {
    this->Try([&] { this->WriteOwnPiece(own); });
  }
  else
  {
    this->TryToAdd(own, this->SoFar ? static_cast<int>(this->SoFar->pieces.size()) : 0);
  }
}

void vtkPolyMeshWriter::TryToAdd(vtkUnstructuredGrid* grid, int number)
{
  if (!this->Try([&] { this->AddPiece(grid, number); }))
  {
    this->SoFar.reset();
  }
}

void vtkPolyMeshWriter::WritePiece(vtkUnstructuredGrid* piece, int number)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  if (number == 0)
  {
    this->WarnOfLongNames(piece);
  }
  this->TryToAdd(piece, number);
}

void vtkPolyMeshWriter::CheckDecomposition(vtkUnstructuredGrid* grid, int processes)
{
  this->CheckNumbers();
  if (!this->ZoneRegions.empty() || this->ZoneBorders == CyclicAMI)
  {
    throw cartesian::Error(cartesian::Fault::BadParameter,
      "In a decomposed case, either all regions are meshes or all are zones: leave Zone Regions "
      "empty and Zone Borders at Face Zones, or write the case whole and run decomposePar.");
  }
  if (this->SolverSetup != None && !this->RotationZones.empty())
  {
    throw cartesian::Error(cartesian::Fault::BadParameter,
      "Rotating Zones: a piece does not know which boundaries are only in a zone. Nothing is "
      "written: write the case whole and run decomposePar.");
  }
  if (!cartesian::readPeriodicPairs(grid).empty())
  {
    throw cartesian::Error(cartesian::Fault::BadParameter,
      "A decomposed case cannot have periodic boundaries: set Pieces to 1 and run decomposePar.");
  }
  if (processes > 1 && this->Pieces != processes)
  {
    throw cartesian::Error(cartesian::Fault::BadParameter,
      "Pieces is " + std::to_string(this->Pieces) + " on " + std::to_string(processes) +
        " ranks, each of which writes one: set it to 1 or " + std::to_string(processes) + ".");
  }
  // OpenFOAM runs on as many processes as there are folders.
  const auto next =
    cartesian::folderOfProcess(std::filesystem::path(this->FileName).parent_path(), this->Pieces);
  if (std::filesystem::exists(next))
  {
    throw cartesian::Error(cartesian::Fault::CannotWrite,
      next.string() + " exists, left from a case with more pieces than the " +
        std::to_string(this->Pieces) + " to write: remove the old folders.");
  }
}

void vtkPolyMeshWriter::AddPiece(vtkUnstructuredGrid* grid, int number)
{
  if (number == 0)
  {
    this->CheckDecomposition(grid, 1);
    this->SoFar = std::make_unique<PiecesSoFar>();
  }
  if (!this->SoFar || this->SoFar->pieces.size() != static_cast<std::size_t>(number))
  {
    throw cartesian::Error(cartesian::Fault::BadParameter,
      "Pieces must be written in order from 0: number " + std::to_string(number) +
        " is not the next one. Write all pieces again.");
  }
  std::filesystem::path file =
    cartesian::folderOfProcess(std::filesystem::path(this->FileName).parent_path(), number);
  file += ".unfinished";
  cartesian::Execution execution(0);
  const cartesian::FoamPiece piece = cartesian::foamPiece(grid, execution);
  this->SoFar->outlines.push_back(cartesian::outlineOf(piece));
  this->SoFar->hasRegions = !piece.regions.names.empty();
  this->SoFar->pieces.emplace_back(piece, file);
  this->UpdateProgress(static_cast<double>(number + 1) / (this->Pieces + 1));
  if (number + 1 == this->Pieces)
  {
    this->FinishPieces(grid);
    this->SoFar.reset();
  }
}

void vtkPolyMeshWriter::FinishPieces(vtkUnstructuredGrid* grid)
{
  const std::filesystem::path file = this->FileName;
  const auto numbers = cartesian::numberFaces(this->SoFar->outlines);
  const auto load = [&](std::size_t i) {
    return Complete(this->SoFar->pieces[i].load(), i, numbers, grid);
  };
  std::vector<cartesian::RegionLabels> regions;
  for (std::size_t i = 0; i < numbers.size() && this->SoFar->hasRegions; ++i)
  {
    Join(regions, LabelsOf(load(i), this->RegionsAs));
  }
  std::vector<cartesian::PolyMeshFiles> written;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    written.emplace_back(file.parent_path(), FormatOf(this->FileType),
      cartesian::FoamPlace{ static_cast<int>(i), this->Pieces });
    WriteMeshes(load(i), regions, this->ScaleOfMesh(), written.back());
  }
  cartesian::requireSuitable(this->MakeSetup(), written.front().meshes(), FlowOf(grid));
  for (cartesian::PolyMeshFiles& files : written)
  {
    this->WarnOfKept(files.replace());
  }
  cartesian::createMarker(file);
  this->WriteSolverCase(written.front(), nullptr, grid);
}

void vtkPolyMeshWriter::WriteOwnPiece(vtkUnstructuredGrid* grid)
{
  const int count = CountProcesses();
  const cartesian::Processes processes(
    vtkMultiProcessController::GetGlobalController()->GetLocalProcessId(), count);
  const std::filesystem::path file = this->FileName;
  cartesian::Execution execution(0);
  cartesian::FoamPiece piece;
  OnAll(processes, [&] {
    this->CheckDecomposition(grid, count);
    piece = cartesian::foamPiece(grid, execution);
  });
  this->UpdateProgress(0.4);
  std::vector<double> outline;
  OnAll(processes, [&] { outline = cartesian::outlineOf(piece).toNumbers(); });
  const std::vector<std::vector<double>> outlinesOfAll = processes.gather(outline);
  this->UpdateProgress(0.5);
  cartesian::CompletePiece complete;
  std::vector<double> labels;
  OnAll(processes, [&] {
    std::vector<cartesian::FoamOutline> outlines;
    outlines.reserve(outlinesOfAll.size());
    for (const auto& numbers : outlinesOfAll)
    {
      outlines.push_back(cartesian::FoamOutline::fromNumbers(numbers));
    }
    complete =
      Complete(std::move(piece), processes.ownNumber(), cartesian::numberFaces(outlines), grid);
    labels = cartesian::toNumbers(LabelsOf(complete, this->RegionsAs));
  });
  const std::vector<std::vector<double>> labelsOfAll = processes.gather(labels);
  this->UpdateProgress(0.6);
  cartesian::PolyMeshFiles files(file.parent_path(), FormatOf(this->FileType),
    { static_cast<int>(processes.ownNumber()), count });
  OnAll(processes, [&] {
    std::vector<cartesian::RegionLabels> regions;
    for (const auto& numbers : labelsOfAll)
    {
      Join(regions, cartesian::regionLabels(numbers));
    }
    WriteMeshes(std::move(complete), regions, this->ScaleOfMesh(), files);
    cartesian::requireSuitable(this->MakeSetup(), files.meshes(), FlowOf(grid));
  });
  OnAll(processes, [&] {
    this->WarnOfKept(files.replace());
    if (processes.ownNumber() == 0)
    {
      cartesian::createMarker(file);
      this->WriteSolverCase(files, nullptr, grid);
    }
  });
}

void vtkPolyMeshWriter::WriteMesh(cartesian::WholeMesh& whole)
{
  this->CheckNumbers();
  const std::filesystem::path file = this->FileName;
  cartesian::PolyMeshFiles files(file.parent_path(), FormatOf(this->FileType));
  Enlarge(whole.mesh.points, this->ScaleOfMesh());
  for (cartesian::FoamPatch& patch : whole.mesh.patches)
  {
    patch.motion = patch.motion.enlarged(this->ScaleOfMesh());
  }
  const cartesian::FoamRegions& regions = whole.regions;
  cartesian::Execution execution(0);
  if (regions.names.empty() && !this->ZoneRegions.empty())
  {
    throw cartesian::Error(cartesian::Fault::BadParameter,
      "Zone Regions: the mesh has only one region. Leave Zone Regions empty.");
  }
  if (regions.names.empty())
  {
    cartesian::orderCyclicFaces(whole.mesh);
    files.write(whole.mesh, {}, execution);
  }
  else
  {
    cartesian::FoamZoning zoning = this->RegionsAs == Zones
      ? cartesian::allZones(regions)
      : cartesian::zonesOfNames(whole.mesh, regions, this->ZoneRegions);
    zoning.border =
      this->ZoneBorders == CyclicAMI ? cartesian::ZoneBorder::Pair : cartesian::ZoneBorder::Faces;
    const std::set<std::uint32_t> meshes(zoning.meshOf.begin(), zoning.meshOf.end());
    for (const std::uint32_t region : meshes)
    {
      cartesian::FoamMesh mesh = cartesian::meshOfRegion(whole.mesh, regions, zoning, region);
      cartesian::orderCyclicFaces(mesh);
      files.write(mesh, meshes.size() == 1 ? std::string() : regions.names[region], execution);
    }
  }
  auto* const grid = vtkUnstructuredGrid::SafeDownCast(this->GetInput());
  cartesian::requireSuitable(this->MakeSetup(), files.meshes(), FlowOf(grid));
  this->WarnOfKept(files.replace());
  cartesian::createMarker(file);
  this->WriteSolverCase(files, &whole.mesh, grid);
}

double vtkPolyMeshWriter::ScaleOfMesh()
{
  return this->Scale > 0 ? this->Scale : cartesian::metresPerUnit(this->GetInput());
}

// Without a speed or viscosity: those that the mesh's layers were made for, if they were.
cartesian::SolverSetup vtkPolyMeshWriter::MakeSetup()
{
  const auto ofMesh = [&](const char* name, double scale, double initial) {
    vtkDataObject* mesh = this->GetInput();
    vtkDataArray* array = mesh ? mesh->GetFieldData()->GetArray(name) : nullptr;
    return array ? array->GetComponent(0, 0) * scale : initial;
  };
  const double scale = this->ScaleOfMesh();
  cartesian::SolverSetup setup;
  setup.solver = static_cast<cartesian::Solver>(this->SolverSetup);
  setup.turbulence = static_cast<cartesian::Turbulence>(this->Turbulence);
  setup.speed = this->Speed == 0 ? ofMesh("FlowSpeed", scale, setup.speed) : this->Speed;
  setup.viscosity = this->Viscosity == 0 ? ofMesh("FlowViscosity", scale * scale, setup.viscosity)
                                         : this->Viscosity;
  setup.density = this->Density;
  setup.temperature = this->InletTemperature;
  if (this->Iterations != 0)
  {
    setup.iterations = this->Iterations;
    setup.heatIterations = this->Iterations;
  }
  setup.overwrites = this->OverwriteSetup;
  setup.times = { this->EndTime, this->WriteInterval, this->TimeStep, this->CourantNumber };
  setup.templates = std::filesystem::u8path(this->CaseTemplates);
  this->AddTables(setup);
  return setup;
}

void vtkPolyMeshWriter::AddTables(cartesian::SolverSetup& setup) const
{
  setup.conditions = cartesian::readConditions({ this->ConditionBoundaries, this->ConditionFlows,
    this->ConditionFlowValues, this->ConditionHeats, this->ConditionHeatValues,
    this->ConditionTurbulenceIntensities, this->ConditionTurbulenceLengths });
  setup.materials = cartesian::readMaterials(
    { this->MaterialRegions, this->Materials, this->MaterialDensities, this->MaterialHeatCapacities,
      this->MaterialConductivities, this->MaterialViscosities, this->HeatSources });
  setup.rotations = cartesian::readRotations({ this->RotationZones, this->RotationSpeeds,
    this->RotationOrigins, this->RotationAxes, this->StillBoundaries });
}

void vtkPolyMeshWriter::WriteSolverCase(const cartesian::PolyMeshFiles& files,
  const cartesian::FoamMesh* whole, vtkUnstructuredGrid* grid)
{
  if (this->SolverSetup == None)
  {
    return;
  }
  const std::vector<cartesian::MeshOfCase> meshes = files.meshes();
  std::optional<cartesian::FlowAround> flow = FlowOf(grid);
  if (flow && whole)
  {
    const cartesian::BodySize size = cartesian::sizeOfBodies(*whole,
      cartesian::namesOf(meshes.front(), cartesian::PatchRole::Wall, flow), flow->direction / 2);
    flow->up = cartesian::flatAxisOf(
      *whole, cartesian::namesOf(meshes.front(), cartesian::PatchRole::Ground, flow))
                 .value_or(flow->up);
    flow->length = size.length;
    flow->frontalArea = size.frontalArea;
  }
  const auto kept = cartesian::writeSolverCase(std::filesystem::path(this->FileName).parent_path(),
    this->MakeSetup(), meshes, flow, this->Pieces);
  const cartesian::SolverSetup setup = this->MakeSetup();
  vtkOutputWindowDisplayText(("The case is written in " +
    std::filesystem::path(this->FileName).parent_path().string() + ": run ./Allrun there. Speed " +
    cartesian::number(setup.speed) + " m/s, viscosity " + cartesian::number(setup.viscosity) +
    " m2/s.\n" + cartesian::rotationsInWords(setup, meshes, flow))
                               .c_str());
  if (!kept.empty())
  {
    vtkWarningMacro("Solver Setup: existing files are kept, "
      << kept.size() << " in all, such as " << kept.front().string()
      << ". Turn on Overwrite Setup to replace them.");
  }
}

void vtkPolyMeshWriter::CheckNumbers()
{
  cartesian::requireInRange(cartesian::Range{ 0 }, this->Scale, "Scale");
  if (this->SolverSetup != None)
  {
    const cartesian::SolverSetup setup = this->MakeSetup();
    cartesian::requireInRange(setup);
    const cartesian::CaseTemplates known(setup.templates); // or it throws
  }
}

void vtkPolyMeshWriter::AddZoneRegion(const std::string& name)
{
  this->ZoneRegions.push_back(name);
  this->Modified();
}

void vtkPolyMeshWriter::ClearZoneRegions()
{
  this->ZoneRegions.clear();
  this->Modified();
}

int vtkPolyMeshWriter::GetNumberOfZoneRegions()
{
  return static_cast<int>(this->ZoneRegions.size());
}

std::string vtkPolyMeshWriter::GetZoneRegion(int i)
{
  return this->ZoneRegions.at(i);
}

void vtkPolyMeshWriter::WarnOfKept(const std::vector<std::filesystem::path>& kept)
{
  for (const std::filesystem::path& path : kept)
  {
    vtkWarningMacro("Old files of the case that do not belong to the new mesh are now in "
      << path.string() << ". Remove them if you do not need them.");
  }
}

void vtkPolyMeshWriter::WarnOfLongNames(vtkUnstructuredGrid* grid)
{
  if (!grid)
  {
    return;
  }
  for (const auto& [boundary, name] : cartesian::readBoundaryTexts(grid, "BoundaryNames"))
  {
    if (name.size() > cartesian::LongestWord)
    {
      vtkWarningMacro("The name of boundary "
        << boundary << " has " << name.size()
        << " characters, but OpenFOAM reads at most 1023: its patch is named by the first "
        << cartesian::LongestWord << ". Shorten the name, which begins with \""
        << name.substr(0, 40) << "\".");
    }
  }
}

void vtkPolyMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileType: " << this->FileType << "\n";
  os << indent << "RegionsAs: " << this->RegionsAs << "\n";
  os << indent << "ZoneRegions: " << this->ZoneRegions.size() << "\n";
  os << indent << "ZoneBorders: " << this->ZoneBorders << "\n";
  os << indent << "Pieces: " << this->Pieces << "\n";
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "SolverSetup: " << this->SolverSetup << "\n";
  os << indent << "Turbulence: " << this->Turbulence << "\n";
  os << indent << "Speed: " << this->Speed << "\n";
  os << indent << "Viscosity: " << this->Viscosity << "\n";
  os << indent << "InletTemperature: " << this->InletTemperature << "\n";
  os << indent << "Iterations: " << this->Iterations << "\n";
  os << indent << "OverwriteSetup: " << this->OverwriteSetup << "\n";
  os << indent << "CaseTemplates: " << this->CaseTemplates << "\n";
  os << indent << "Density: " << this->Density << "\n";
  os << indent << "EndTime: " << this->EndTime << "\n";
  os << indent << "WriteInterval: " << this->WriteInterval << "\n";
  os << indent << "TimeStep: " << this->TimeStep << "\n";
  os << indent << "CourantNumber: " << this->CourantNumber << "\n";
  os << indent << "Conditions: " << this->ConditionBoundaries.size() << "\n";
  os << indent << "Materials: " << this->MaterialRegions.size() << "\n";
  os << indent << "Rotations: " << this->RotationZones.size() << "\n";
}
