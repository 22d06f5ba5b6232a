// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolyMeshWriter.h"

#include "Base/Error.h"
#include "BoundaryOfFaces.h"
#include "FoamFromVTK.h"
#include "FoamPieceStore.h"
#include "GridFaces.h"
#include "MeshUnion.h"
#include "Processes.h"
#include "ReportErrors.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <optional>

vtkStandardNewMacro(vtkPolyMeshWriter);

// What one process has written of the pieces that it makes one after the other.
struct vtkPolyMeshWriter::PiecesSoFar
{
  std::vector<cartesian::FoamPieceStore> pieces;
  std::vector<cartesian::FoamOutline> outlines;
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

// What one process cannot do, none does: the others need not wait for it.
template <class Work>
void OnAll(const cartesian::Processes& processes, Work&& work)
{
  std::optional<cartesian::Error> mine;
  try
  {
    work();
  }
  catch (const cartesian::Error& error)
  {
    mine = error;
  }
  const std::vector<double> failures = processes.sum({ mine ? 1.0 : 0.0 });
  if (mine)
  {
    throw *mine;
  }
  if (failures[0] > 0)
  {
    throw cartesian::Error(cartesian::Fault::BadMesh,
      "Another rank cannot write its piece, for the reason that it gives.");
  }
}

cartesian::FoamPiece ReadPiece(
  vtkUnstructuredGrid* grid, int regionsAs, cartesian::Execution& execution)
{
  cartesian::FoamPiece piece = cartesian::foamPiece(grid, execution);
  if (!piece.mesh.zones.empty() && regionsAs == vtkPolyMeshWriter::Meshes)
  {
    throw cartesian::Error(cartesian::Fault::BadParameter,
      "A decomposed case has one mesh for all regions: set Regions As to Zones.");
  }
  return piece;
}

// Writes a piece beside what is there.
cartesian::PolyMeshFiles WriteBeside(cartesian::FoamPiece&& piece, std::size_t number,
  const std::vector<cartesian::FaceNumbers>& numbersOfAll, vtkUnstructuredGrid* grid,
  const std::filesystem::path& folder, cartesian::FoamFormat format)
{
  const cartesian::FaceNumbers& numbers = numbersOfAll[number];
  std::vector<vtkIdType> boundaries;
  std::vector<std::size_t> counts;
  for (const cartesian::FaceNumbers::Boundary& boundary : numbers.boundaries)
  {
    boundaries.push_back(boundary.boundary);
    counts.push_back(boundary.count);
  }
  cartesian::PolyMeshFiles files(
    folder, format, { static_cast<int>(number), static_cast<int>(numbersOfAll.size()) });
  files.write(cartesian::completed(
    std::move(piece), number, numbers, cartesian::patchesOf(grid, boundaries, counts)));
  return files;
}

}

vtkPolyMeshWriter::vtkPolyMeshWriter() = default;

vtkPolyMeshWriter::~vtkPolyMeshWriter()
{
  this->SetFileName(nullptr);
}

int vtkPolyMeshWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

vtkTypeBool vtkPolyMeshWriter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
  const bool isAlone = CountProcesses() == 1;
  if (request->Has(Pipeline::REQUEST_UPDATE_EXTENT()) && (processes || this->Pieces > 1))
  {
    vtkInformation* info = input[0]->GetInformationObject(0);
    const int next = this->SoFar ? static_cast<int>(this->SoFar->pieces.size()) : 0;
    info->Set(Pipeline::UPDATE_PIECE_NUMBER(), isAlone ? next : processes->GetLocalProcessId());
    info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), isAlone ? this->Pieces : CountProcesses());
  }
  const vtkTypeBool done = this->Superclass::ProcessRequest(request, input, output);
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

vtkSmartPointer<vtkUnstructuredGrid> vtkPolyMeshWriter::Gather()
{
  vtkSmartPointer<vtkUnstructuredGrid> mine = vtkUnstructuredGrid::SafeDownCast(this->GetInput());
  vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
  if (!processes || processes->GetNumberOfProcesses() == 1)
  {
    return mine;
  }
  const vtkIdType cells = mine->GetNumberOfCells();
  std::vector<vtkIdType> cellsOf(static_cast<std::size_t>(processes->GetNumberOfProcesses()));
  processes->AllGather(&cells, cellsOf.data(), 1);
  const bool first = processes->GetLocalProcessId() == 0;
  if (std::all_of(cellsOf.begin() + 1, cellsOf.end(), [](vtkIdType n) { return n == 0; }))
  {
    return first ? mine : nullptr;
  }
  std::vector<vtkSmartPointer<vtkDataObject>> pieces;
  processes->Gather(mine, pieces, 0);
  if (!first)
  {
    return nullptr;
  }
  return cartesian::unitePieces(pieces);
}

template <class Action>
void vtkPolyMeshWriter::Try(Action&& act)
{
  cartesian::reportErrors(act, [this](unsigned long code, const std::string& message) {
    this->SetErrorCode(code);
    vtkErrorMacro(<< message);
    this->SoFar.reset();
  });
}

void vtkPolyMeshWriter::WriteData()
{
  this->Try([&] {
    const bool isNamed = this->FileName && *this->FileName;
    auto* own = vtkUnstructuredGrid::SafeDownCast(this->GetInput());
    if (isNamed && this->Pieces > 1 && CountProcesses() > 1)
    {
      this->WriteOwnPiece(own);
      return;
    }
    if (isNamed && this->Pieces > 1)
    {
      this->AddPiece(own, this->SoFar ? static_cast<int>(this->SoFar->pieces.size()) : 0);
      return;
    }
    const vtkSmartPointer<vtkUnstructuredGrid> grid = this->Gather();
    if (!grid)
    {
      return;
    }
    if (!isNamed)
    {
      this->SetErrorCode(vtkErrorCode::NoFileNameError);
      vtkErrorMacro("There is no file name: set one, such as case.foam.");
      return;
    }
    this->WriteCase(grid);
  });
}

void vtkPolyMeshWriter::WritePiece(vtkUnstructuredGrid* piece, int number)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  this->Try([&] { this->AddPiece(piece, number); });
}

void vtkPolyMeshWriter::CheckDecomposition(int processes)
{
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
      next.string() + " is there, of a case in more pieces than the " +
        std::to_string(this->Pieces) + " to write: remove the old ones.");
  }
}

void vtkPolyMeshWriter::AddPiece(vtkUnstructuredGrid* grid, int number)
{
  if (number == 0)
  {
    this->CheckDecomposition(1);
    this->SoFar = std::make_unique<PiecesSoFar>();
  }
  if (!this->SoFar || this->SoFar->pieces.size() != static_cast<std::size_t>(number))
  {
    throw cartesian::Error(cartesian::Fault::BadParameter,
      "Pieces are written in order from 0, and number " + std::to_string(number) +
        " is not the next.");
  }
  std::filesystem::path file =
    cartesian::folderOfProcess(std::filesystem::path(this->FileName).parent_path(), number);
  file += ".unfinished";
  cartesian::Execution execution(0);
  const cartesian::FoamPiece piece = ReadPiece(grid, this->RegionsAs, execution);
  this->SoFar->outlines.push_back(cartesian::outlineOf(piece));
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
  std::vector<cartesian::PolyMeshFiles> written;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    written.push_back(WriteBeside(this->SoFar->pieces[i].load(), i, numbers, grid,
      file.parent_path(), FormatOf(this->FileType)));
  }
  for (cartesian::PolyMeshFiles& files : written)
  {
    this->WarnOfKept(files.replace());
  }
  cartesian::createMarker(file);
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
    this->CheckDecomposition(count);
    piece = ReadPiece(grid, this->RegionsAs, execution);
  });
  this->UpdateProgress(0.4);
  std::vector<cartesian::FoamOutline> outlines;
  for (const auto& numbers : processes.gather(cartesian::outlineOf(piece).toNumbers()))
  {
    outlines.push_back(cartesian::FoamOutline::fromNumbers(numbers));
  }
  const auto numbers = cartesian::numberFaces(outlines);
  this->UpdateProgress(0.5);
  std::optional<cartesian::PolyMeshFiles> files;
  OnAll(processes, [&] {
    files = WriteBeside(std::move(piece), processes.ownNumber(), numbers, grid, file.parent_path(),
      FormatOf(this->FileType));
  });
  OnAll(processes, [&] {
    this->WarnOfKept(files->replace());
    if (processes.ownNumber() == 0)
    {
      cartesian::createMarker(file);
    }
  });
}

void vtkPolyMeshWriter::WriteCase(vtkUnstructuredGrid* grid)
{
  cartesian::Execution execution(0);
  cartesian::GridFaces faces(grid);
  cartesian::turnOutward(faces.cells, faces.points, execution);
  cartesian::FaceList list = cartesian::listFaces(
    faces.cells, faces.points.size() / 3, cartesian::Clashes::Refused, execution);
  this->UpdateProgress(0.4);

  std::vector<vtkIdType> boundaryOf;
  const auto known = cartesian::readBoundaryOfFaces(grid, faces, list, boundaryOf);
  std::vector<cartesian::FoamPatch> patches;
  if (known == cartesian::BoundaryKnowledge::All)
  {
    const auto [boundaries, counts] = cartesian::sortByBoundary(boundaryOf, list);
    patches = cartesian::patchesOf(grid, boundaries, counts);
  }
  else if (!boundaryOf.empty())
  {
    patches.push_back({ "boundary", boundaryOf.size() });
  }
  if (known == cartesian::BoundaryKnowledge::Unfit)
  {
    vtkWarningMacro("Cells were cut or put together since the mesh was made, so that its "
                    "boundaries are lost: there is one patch. To have them all, save the mesh of "
                    "Cartesian Mesher itself.");
  }
  this->UpdateProgress(0.5);

  const std::filesystem::path file = this->FileName;
  cartesian::PolyMeshFiles files(file.parent_path(), FormatOf(this->FileType));
  const cartesian::FoamRegions regions =
    cartesian::regionsOf(grid, faces, cartesian::RegionsAsked::WithCells);
  cartesian::FoamMesh mesh =
    cartesian::foamMesh(std::move(faces.points), faces.cells, list, std::move(patches));
  if (regions.names.empty() || this->RegionsAs == Zones)
  {
    mesh.zones = cartesian::zonesOf(regions);
    files.write(mesh);
  }
  else
  {
    for (std::uint32_t region = 0; region < regions.names.size(); ++region)
    {
      files.write(cartesian::meshOfRegion(mesh, regions, region), regions.names[region]);
    }
  }
  this->WarnOfKept(files.replace());
  cartesian::createMarker(file);
}

void vtkPolyMeshWriter::WarnOfKept(const std::vector<std::filesystem::path>& kept)
{
  for (const std::filesystem::path& path : kept)
  {
    vtkWarningMacro(
      "What was in the case and does not belong to the new mesh is now in " << path.string());
  }
}

void vtkPolyMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "FileType: " << this->FileType << "\n";
  os << indent << "RegionsAs: " << this->RegionsAs << "\n";
  os << indent << "Pieces: " << this->Pieces << "\n";
}
