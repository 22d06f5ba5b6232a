// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolyMeshWriter.h"

#include "BoundaryOfFaces.h"
#include "Cells/Cells.h"
#include "GridFaces.h"
#include "MeshUnion.h"
#include "OpenFoam/FoamRegions.h"
#include "ReportErrors.h"

#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <set>

vtkStandardNewMacro(vtkPolyMeshWriter);

namespace
{

// Numbers in order, NoBoundary last.
bool Before(vtkIdType a, vtkIdType b)
{
  return (a == cartesian::NoBoundary) != (b == cartesian::NoBoundary) ? b == cartesian::NoBoundary
                                                                      : a < b;
}

// The name as a word that is not taken yet: with the number, if need be.
std::string TakeWord(const std::string& name, vtkIdType number, std::set<std::string>& taken)
{
  std::string word = cartesian::foamWord(name);
  while (!taken.insert(word).second)
  {
    word += "_" + std::to_string(number);
  }
  return word;
}

// A distinct word for each boundary.
std::vector<std::string> PatchNames(
  vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& boundaries)
{
  const std::map<vtkIdType, std::string> given =
    cartesian::readBoundaryTexts(grid, "BoundaryNames");
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (const vtkIdType boundary : boundaries)
  {
    const auto name = given.find(boundary);
    const std::string plain =
      boundary == cartesian::NoBoundary ? "no_surface" : "boundary_" + std::to_string(boundary);
    names.push_back(TakeWord(
      name == given.end() || name->second.empty() ? plain : name->second, boundary, taken));
  }
  return names;
}

// Sorts the boundary faces by the boundaries they are of.
std::vector<cartesian::FoamPatch> SortPatches(
  vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& boundaryOf, cartesian::FaceList& list)
{
  std::vector<vtkIdType> boundaries = boundaryOf;
  std::sort(boundaries.begin(), boundaries.end(), Before);
  boundaries.erase(std::unique(boundaries.begin(), boundaries.end()), boundaries.end());
  std::vector<std::uint32_t> patchOf;
  patchOf.reserve(boundaryOf.size());
  for (const vtkIdType boundary : boundaryOf)
  {
    patchOf.push_back(static_cast<std::uint32_t>(
      std::lower_bound(boundaries.begin(), boundaries.end(), boundary, Before) -
      boundaries.begin()));
  }
  const std::vector<std::size_t> counts = cartesian::sortByPatch(list, patchOf, boundaries.size());
  const std::vector<std::string> names = PatchNames(grid, boundaries);
  std::map<vtkIdType, std::string> types = cartesian::readBoundaryTexts(grid, "BoundaryTypes");
  std::vector<cartesian::FoamPatch> patches;
  patches.reserve(names.size());
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    patches.push_back({ names[i], counts[i], types[boundaries[i]] });
  }
  return patches;
}

// Those regions that have cells; none, if all cells are of one.
cartesian::FoamRegions RegionsOf(vtkUnstructuredGrid* grid, const cartesian::GridFaces& faces)
{
  auto* names = vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray("RegionNames"));
  auto* regions = vtkIntArray::SafeDownCast(grid->GetCellData()->GetArray("Region"));
  std::map<int, std::uint32_t> number;
  for (std::size_t cell = 0; names && regions && cell < faces.cellOf.size(); ++cell)
  {
    number[regions->GetValue(faces.cellOf[cell])] = 0;
  }
  if (number.size() < 2 || number.begin()->first < 1 ||
    number.rbegin()->first > names->GetNumberOfValues())
  {
    return {};
  }
  cartesian::FoamRegions result;
  std::set<std::string> taken;
  for (auto& [region, index] : number)
  {
    index = static_cast<std::uint32_t>(result.names.size());
    result.names.push_back(TakeWord(names->GetValue(region - 1), region, taken));
  }
  for (const vtkIdType cell : faces.cellOf)
  {
    result.ofCell.push_back(number[regions->GetValue(cell)]);
  }
  return result;
}

std::vector<cartesian::FoamZone> ZonesOf(const cartesian::FoamRegions& regions)
{
  std::vector<cartesian::FoamZone> zones;
  for (const std::string& name : regions.names)
  {
    zones.push_back({ name, {} });
  }
  for (std::uint32_t cell = 0; cell < regions.ofCell.size(); ++cell)
  {
    zones[regions.ofCell[cell]].cells.push_back(cell);
  }
  return zones;
}

}

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
  vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
  if (processes && request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT()))
  {
    vtkInformation* info = input[0]->GetInformationObject(0);
    info->Set(
      vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), processes->GetLocalProcessId());
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(),
      processes->GetNumberOfProcesses());
  }
  return this->Superclass::ProcessRequest(request, input, output);
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

void vtkPolyMeshWriter::WriteData()
{
  const auto write = [&] {
    const vtkSmartPointer<vtkUnstructuredGrid> grid = this->Gather();
    if (!grid)
    {
      return;
    }
    if (!this->FileName || !*this->FileName)
    {
      this->SetErrorCode(vtkErrorCode::NoFileNameError);
      vtkErrorMacro("There is no file name: set one, such as case.foam.");
      return;
    }
    this->WriteCase(grid);
  };
  cartesian::reportErrors(write, [this](unsigned long code, const std::string& message) {
    this->SetErrorCode(code);
    vtkErrorMacro(<< message);
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
    patches = SortPatches(grid, boundaryOf, list);
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
  cartesian::PolyMeshFiles files(file.parent_path(),
    this->FileType == VTK_ASCII ? cartesian::FoamFormat::Ascii : cartesian::FoamFormat::Binary);
  const cartesian::FoamRegions regions = RegionsOf(grid, faces);
  cartesian::FoamMesh mesh =
    cartesian::foamMesh(std::move(faces.points), faces.cells, list, std::move(patches));
  if (regions.names.empty() || this->RegionsAs == Zones)
  {
    mesh.zones = ZonesOf(regions);
    files.write(mesh);
  }
  else
  {
    for (std::uint32_t region = 0; region < regions.names.size(); ++region)
    {
      files.write(cartesian::meshOfRegion(mesh, regions, region), regions.names[region]);
    }
  }
  for (const std::filesystem::path& kept : files.replace())
  {
    vtkWarningMacro(
      "What was in the case and does not belong to the new mesh is now in " << kept.string());
  }
  cartesian::createMarker(file);
}

void vtkPolyMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "FileType: " << this->FileType << "\n";
  os << indent << "RegionsAs: " << this->RegionsAs << "\n";
}
