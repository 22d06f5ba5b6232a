// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCartesianGridAlgorithm.h"

#include "AskedMesh.h"
#include "Base/Error.h"
#include "BoundarySettings.h"
#include "Boxes/FlowRefinement.h"
#include "DefectsToVTK.h"
#include "ExpectedTable.h"
#include "LengthUnit.h"
#include "Mesher/Mesher.h"
#include "Mesher/Messages.h"
#include "Parts/Decomposition.h"
#include "RegionShapes.h"
#include "Repair/SurfaceDefects.h"
#include "ReportErrors.h"
#include "SizesFromVTK.h"
#include "SurfaceBlocks.h"
#include "SurfaceFromVTK.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <set>

namespace
{

template <class Table>
void PrintTable(ostream& os, vtkIndent indent, const char* name, const Table& table)
{
  os << indent << name << ":\n";
  for (const auto& row : table)
  {
    os << indent.GetNextIndent();
    for (const double value : row)
    {
      os << value << " ";
    }
    os << "\n";
  }
}

// Tables hold doubles; all their numbers are whole.
int WholeNumber(double value, const std::string& where)
{
  if (value != std::floor(value) || std::abs(value) > std::numeric_limits<int>::max())
  {
    throw cartesian::Error(cartesian::Fault::BadParameter,
      "In " + where + ", " + std::to_string(value) +
        " is not a whole number: give whole numbers only.");
  }
  return static_cast<int>(value);
}

}

std::vector<vtkCartesianGridAlgorithm::RegionSurface> vtkCartesianGridAlgorithm::RegionSurfaces(
  const std::vector<vtkSmartPointer<vtkDataObject>>& given) const
{
  std::vector<RegionSurface> regions;
  for (const auto& data : given)
  {
    for (const cartesian::SurfaceBlock& block : cartesian::surfaceBlocks(data))
    {
      vtkDataArray* own = block.surface->GetFieldData()->GetArray(cartesian::RegionDepthField);
      RegionSurface& region = regions.emplace_back();
      region.shape = block.surface;
      region.surface = std::make_unique<cartesian::SurfaceFromVTK>(block.surface, "");
      region.depth = own && own->GetNumberOfTuples() == 1
        ? WholeNumber(own->GetComponent(0, 0), "the field data of Refinement Regions")
        : this->RegionDepth;
    }
  }
  const std::size_t rows = this->RefinementShapes.size();
  if (this->RefinementPositions.size() != rows || this->RefinementLengths.size() != rows ||
    this->RefinementShapeDepths.size() != rows)
  {
    throw cartesian::Error(cartesian::Fault::BadParameter,
      "Refinement Positions, Refinement Lengths and Refinement Shape Depths must each have as many "
      "rows as Refinement Shapes.");
  }
  for (std::size_t row = 0; row < rows; ++row)
  {
    const auto shape = cartesian::shapeInBox(
      this->RefinementShapes[row], this->RefinementPositions[row], this->RefinementLengths[row]);
    RegionSurface& region = regions.emplace_back();
    region.shape = shape;
    region.surface = std::make_unique<cartesian::SurfaceFromVTK>(shape, "");
    region.depth = this->RefinementShapeDepths[row];
  }
  return regions;
}

bool vtkCartesianGridAlgorithm::RefinesFlow(const cartesian::DomainSpec& domain) const
{
  return domain.isOutside() && this->RefinementDepth == 0 && domain.boxesAlong > 0;
}

cartesian::FlowRefinement vtkCartesianGridAlgorithm::FlowOf(
  const cartesian::SurfaceFromVTK& source, const cartesian::Options& options) const
{
  return this->RefinesFlow(options.domain)
    ? cartesian::flowRefinement(options.domain, options.grid, cartesian::boundsOf(source.view()))
    : cartesian::FlowRefinement();
}

int vtkCartesianGridAlgorithm::DepthAtSurface(
  const cartesian::SurfaceFromVTK& source, const cartesian::Options& options) const
{
  int depth = std::max(this->RefinementDepth, this->FlowOf(source, options).depth);
  for (const int ofBoundary : this->BoundaryDepths)
  {
    depth = std::max(depth, ofBoundary);
  }
  for (const std::array<double, 4>& row : this->BoundaryRefinements)
  {
    depth = std::max(depth, static_cast<int>(std::min(row[1], double(cartesian::DeepestLevel))));
  }
  const bool isBySize = this->CurvatureAngle > 0 || this->CellsAcrossGaps > 0;
  return std::max({ depth, this->FeatureDepth, isBySize ? this->LargestDepth : 0,
    this->RefinedBoundaries.empty() ? 0 : this->RefinedBoundaryDepth });
}

void vtkCartesianGridAlgorithm::AddFlowRefinement(const cartesian::SurfaceFromVTK& source,
  cartesian::Options& options, std::vector<RegionSurface>& regions) const
{
  if (!this->RefinesFlow(options.domain))
  {
    return;
  }
  const cartesian::FlowRefinement flow = this->FlowOf(source, options);
  options.refinement.depth = flow.depth;
  if (!regions.empty())
  {
    return;
  }
  for (const cartesian::FlowZone& zone : flow.zones)
  {
    const auto& [low, high] = zone.box;
    const auto shape =
      cartesian::shapeInBox("box", low, { high[0] - low[0], high[1] - low[1], high[2] - low[2] });
    regions.push_back(
      { shape, std::make_unique<cartesian::SurfaceFromVTK>(shape, ""), zone.depth });
  }
}

vtkCartesianGridAlgorithm::vtkCartesianGridAlgorithm()
{
  this->SetNumberOfInputPorts(3);
}

vtkCartesianGridAlgorithm::~vtkCartesianGridAlgorithm() = default;

void vtkCartesianGridAlgorithm::SetRefinedBoundaryArrayStatus(const char* name, int chosen)
{
  const bool isChanged =
    chosen ? this->RefinedBoundaries.insert(name).second : this->RefinedBoundaries.erase(name) > 0;
  if (isChanged)
  {
    this->Modified();
  }
}

void vtkCartesianGridAlgorithm::ChooseNoRefinedBoundaries()
{
  if (!this->RefinedBoundaries.empty())
  {
    this->RefinedBoundaries.clear();
    this->Modified();
  }
}

void vtkCartesianGridAlgorithm::SetNumberOfRefinementBlocks(int number)
{
  this->Resize(this->RefinementBlocks, number);
}

void vtkCartesianGridAlgorithm::SetRefinementBlock(int row, double firstI, double lastI,
  double firstJ, double lastJ, double firstK, double lastK, double allowed, double forced)
{
  this->SetRow(
    this->RefinementBlocks, row, { firstI, lastI, firstJ, lastJ, firstK, lastK, allowed, forced });
}

void vtkCartesianGridAlgorithm::SetNumberOfBoundaryRefinements(int number)
{
  this->Resize(this->BoundaryRefinements, number);
}

void vtkCartesianGridAlgorithm::SetBoundaryRefinement(
  int row, double boundary, double depth, double blendLayers, double blendBelow)
{
  this->SetRow(this->BoundaryRefinements, row, { boundary, depth, blendLayers, blendBelow });
}

void vtkCartesianGridAlgorithm::SetNumberOfRefinementShapes(int number)
{
  this->Resize(this->RefinementShapes, number);
}

void vtkCartesianGridAlgorithm::SetRefinementShape(int row, const char* shape)
{
  this->SetRow(this->RefinementShapes, row, std::string(shape ? shape : ""));
}

void vtkCartesianGridAlgorithm::SetNumberOfRefinementPositions(int number)
{
  this->Resize(this->RefinementPositions, number);
}

void vtkCartesianGridAlgorithm::SetRefinementPosition(int row, double x, double y, double z)
{
  this->SetRow(this->RefinementPositions, row, { x, y, z });
}

void vtkCartesianGridAlgorithm::SetNumberOfRefinementLengths(int number)
{
  this->Resize(this->RefinementLengths, number);
}

void vtkCartesianGridAlgorithm::SetRefinementLength(int row, double x, double y, double z)
{
  this->SetRow(this->RefinementLengths, row, { x, y, z });
}

void vtkCartesianGridAlgorithm::SetNumberOfRefinementShapeDepths(int number)
{
  this->Resize(this->RefinementShapeDepths, number);
}

void vtkCartesianGridAlgorithm::SetRefinementShapeDepth(int row, int depth)
{
  this->SetRow(this->RefinementShapeDepths, row, depth);
}

void vtkCartesianGridAlgorithm::SetNumberOfMeshlines(int axis, int number)
{
  if (axis < 0 || axis > 2 || number < 0)
  {
    vtkErrorMacro("Axis " << axis << " cannot have " << number
                          << " meshlines: axes are 0 to 2, numbers 0 or more.");
    return;
  }
  auto& lines = this->Meshlines[axis];
  if (lines.size() != static_cast<std::size_t>(number))
  {
    lines.resize(number, 0.0);
    this->Modified();
  }
}

int vtkCartesianGridAlgorithm::GetNumberOfMeshlines(int axis)
{
  return axis < 0 || axis > 2 ? 0 : static_cast<int>(this->Meshlines[axis].size());
}

bool vtkCartesianGridAlgorithm::HasMeshline(int axis, int i)
{
  if (i >= 0 && i < this->GetNumberOfMeshlines(axis))
  {
    return true;
  }
  vtkErrorMacro(
    "There is no meshline " << i << " on axis " << axis << ": set the number of meshlines first.");
  return false;
}

void vtkCartesianGridAlgorithm::SetMeshline(int axis, int i, double position)
{
  if (this->HasMeshline(axis, i) && this->Meshlines[axis][i] != position)
  {
    this->Meshlines[axis][i] = position;
    this->Modified();
  }
}

double vtkCartesianGridAlgorithm::GetMeshline(int axis, int i)
{
  return this->HasMeshline(axis, i) ? this->Meshlines[axis][i] : 0.0;
}

void vtkCartesianGridAlgorithm::UpdateOptionalInputs()
{
  for (int port = 1; port < this->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < this->GetNumberOfInputConnections(port); ++i)
    {
      this->GetInputAlgorithm(port, i)->Update();
    }
  }
}

std::vector<vtkSmartPointer<vtkDataObject>> vtkCartesianGridAlgorithm::OptionalRegions()
{
  std::vector<vtkSmartPointer<vtkDataObject>> regions;
  if (this->GetNumberOfInputPorts() == 1)
  {
    return regions; // Surface Inspector has only a surface
  }
  regions.reserve(static_cast<std::size_t>(this->GetNumberOfInputConnections(1)));
  for (int i = 0; i < this->GetNumberOfInputConnections(1); ++i)
  {
    regions.emplace_back(this->GetInputDataObject(1, i));
  }
  return regions;
}

vtkDataObject* vtkCartesianGridAlgorithm::UpdatedSurface()
{
  vtkAlgorithm* source = this->GetInputAlgorithm();
  if (!source)
  {
    return nullptr;
  }
  source->Update();
  return this->GetInputDataObject(0, 0);
}

void vtkCartesianGridAlgorithm::DescribeBoundaries(vtkDataObject* result)
{
  this->Run(0, 1, [&](cartesian::Execution&) {
    const cartesian::SurfaceFromVTK surface = this->ReadWithSides(this->UpdatedSurface());
    cartesian::setBoundaryNames(result, surface.names());
  });
}

double* vtkCartesianGridAlgorithm::EstimateSize()
{
  this->EstimatedSize = {};
  this->Run(0, 1, [&](cartesian::Execution& execution) {
    this->UpdateOptionalInputs();
    const cartesian::SurfaceFromVTK surface = this->ReadWithSides(this->UpdatedSurface());
    this->Inspect(this->Prepare(surface, execution), surface, vtkNew<vtkPolyData>(), execution);
    const Asked asked = this->Ask(surface);
    const cartesian::ExpectedMesh mesh =
      cartesian::expectedMesh(surface.view(), asked.options, execution);
    this->EstimatedSize = { mesh.boxes, mesh.cells, mesh.bytes };
  });
  this->TellWarnings();
  return this->EstimatedSize.data();
}

int vtkCartesianGridAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port > 0 ? 1 : 0);
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), port == 1 ? 1 : 0);
  AcceptAnything(info);
  return 1;
}

vtkBoundingBox vtkCartesianGridAlgorithm::BoundsOfInput()
{
  vtkBoundingBox box;
  // Not read yet, or no surface: the work itself will say so.
  cartesian::reportErrors(
    [&] {
      for (const cartesian::SurfaceBlock& block :
        cartesian::surfaceBlocks(this->GetInputDataObject(0, 0)))
      {
        box.AddBounds(block.surface->GetBounds());
      }
    },
    [](unsigned long, const std::string&) {});
  return box;
}

const char* vtkCartesianGridAlgorithm::GetSurfaceSize()
{
  this->SurfaceSize.clear();
  const vtkBoundingBox box = this->BoundsOfInput();
  if (box.IsValid())
  {
    this->SurfaceSize =
      cartesian::describeLengths({ box.GetLength(0), box.GetLength(1), box.GetLength(2) }) +
      this->NoteOfLength(box.GetMaxLength());
  }
  return this->SurfaceSize.c_str();
}

vtkMTimeType vtkCartesianGridAlgorithm::LastChange()
{
  vtkMTimeType time = this->GetMTime();
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < this->GetNumberOfInputConnections(port); ++i)
    {
      vtkDataObject* const data = this->GetInputDataObject(port, i);
      time = std::max(time, data ? data->GetMTime() : 0);
    }
  }
  return time;
}

vtkStringArray* vtkCartesianGridAlgorithm::GetExpectedBoxes()
{
  if (this->LastChange() != this->ExpectedTime)
  {
    this->Expect(cartesian::expectedRows);
  }
  return this->ExpectedBoxes;
}

void vtkCartesianGridAlgorithm::ExpectCellSizeAlone()
{
  this->Expect([](auto&... asked) -> std::vector<cartesian::ExpectedRow> {
    return { { cartesian::expectedMesh(asked...), true } };
  });
}

vtkCartesianGridAlgorithm::Asked vtkCartesianGridAlgorithm::Ask(
  const cartesian::SurfaceFromVTK& surface)
{
  Asked asked{ this->RegionSurfaces(this->OptionalRegions()), this->MakeOptions() };
  asked.options.depthAtSurface = this->DepthAtSurface(surface, asked.options);
  this->AddBoundaryOptions(surface, asked.options);
  vtkDataObject* const sizes =
    this->GetNumberOfInputPorts() > 2 ? this->GetInputDataObject(2, 0) : nullptr;
  this->AddRefinement(surface, asked.regions,
    this->ReadSizes(this->GetInputDataObject(0, 0), surface, sizes), asked.options);
  return asked;
}

void vtkCartesianGridAlgorithm::Expect(Estimate* estimate)
{
  this->ExpectedTime = this->LastChange();
  this->ExpectedBoxes->Initialize();
  this->BeginEstimate(nullptr);
  // Not read yet, or refused: the work itself will say so.
  cartesian::reportErrors(
    [&] {
      const cartesian::SurfaceFromVTK surface = this->ReadWithSides(this->GetInputDataObject(0, 0));
      const Asked asked = this->Ask(surface);
      this->BeginEstimate(&asked.options);
      cartesian::Execution execution(this->NumberOfThreads);
      cartesian::toVTK(estimate(surface.view(), asked.options, execution), this->ExpectedBoxes);
    },
    [](unsigned long, const std::string&) {});
}

cartesian::Options vtkCartesianGridAlgorithm::MakeOptions()
{
  cartesian::Options options;
  options.grid.cellSize = this->CellSize;
  options.grid.meshlines = this->Meshlines;
  options.memoryLimit = this->MemoryLimit;
  return options;
}

void vtkCartesianGridAlgorithm::AddBoundaryOptions(
  const cartesian::SurfaceFromVTK& /*surface*/, cartesian::Options& /*options*/)
{
}

cartesian::BoundarySettings vtkCartesianGridAlgorithm::Boundaries() const
{
  cartesian::BoundarySettings boundaries;
  boundaries.names = this->BoundaryNames;
  boundaries.depths = this->BoundaryDepths;
  return boundaries;
}

cartesian::SurfaceFromVTK vtkCartesianGridAlgorithm::Read(vtkDataObject* surface) const
{
  cartesian::SurfaceFromVTK read(surface, this->BoundaryArray);
  read.leaveOutOpenBodies({});
  return read;
}

cartesian::SurfaceFromVTK vtkCartesianGridAlgorithm::ReadWithSides(vtkDataObject* data)
{
  cartesian::SurfaceFromVTK surface = this->Read(data);
  if (const cartesian::DomainSpec domain = this->MakeOptions().domain; domain.isOutside())
  {
    surface.addSides(cartesian::namesOfSides(domain));
  }
  this->AddGaps(surface);
  return surface;
}

void vtkCartesianGridAlgorithm::AddGaps(cartesian::SurfaceFromVTK& surface)
{
  cartesian::Options options = this->MakeOptions();
  if (options.closeGaps == 0)
  {
    return;
  }
  options.domain.sides = surface.sides();
  options.depthAtSurface = this->DepthAtSurface(surface, options);
  options.baffles.clear();
  for (const std::int32_t baffle : cartesian::baffleBoundaries(this->Boundaries(), surface.names()))
  {
    options.baffles.push_back({ baffle, baffle });
  }
  cartesian::Execution execution(this->NumberOfThreads);
  surface.addGaps(cartesian::closedGaps(surface.view(), options, execution));
}

cartesian::PreparedSurface vtkCartesianGridAlgorithm::Prepare(
  const cartesian::SurfaceFromVTK& surface, cartesian::Execution& execution, int parts)
{
  cartesian::Options options = this->MakeOptions();
  options.domain.sides = surface.sides();
  options.depthAtSurface = this->DepthAtSurface(surface, options);
  cartesian::PreparedSurface prepared =
    cartesian::prepareSurface(surface.view(), options, execution, parts);
  std::string text;
  for (const std::string& part :
    { surface.describeLeftOut(), cartesian::describe(surface.gaps(), surface.view()),
      cartesian::describeFlaws(prepared, surface.cells(), surface.names()) })
  {
    text += (text.empty() || part.empty() ? "" : "\n") + part;
  }
  this->Warn(text);
  return prepared;
}

void vtkCartesianGridAlgorithm::Inspect(const cartesian::PreparedSurface& prepared,
  const cartesian::SurfaceFromVTK& surface, vtkPolyData* defects, cartesian::Execution& execution)
{
  execution.stage("Defects of the surface", cartesian::AfterSurface, cartesian::AfterDefects);
  if (prepared.surface.walls.any())
  {
    // Triangles between regions are others than the user's: what was closed is listed with those.
    cartesian::SurfaceDefects closed =
      cartesian::listContacts(prepared.contacts, prepared.surface.lattice);
    cartesian::list(surface.gaps(), surface.view(), closed);
    cartesian::toVTK(closed, surface.cells(), defects, execution);
    return;
  }
  cartesian::SurfaceDefects found = cartesian::findDefects(prepared.inspected(),
    prepared.trianglesGiven(), prepared.repair, prepared.cracks, prepared.planes, execution);
  const std::vector<vtkIdType> cells = cartesian::cellsOf(prepared.inspected(), surface.cells());
  cartesian::list(surface.gaps(), surface.view(), found);
  cartesian::toVTK(found, cells, defects, execution);
  this->Warn(cartesian::describe(found, cells));
}

cartesian::RefinementSpec vtkCartesianGridAlgorithm::MakeSpec(
  const cartesian::SurfaceFromVTK& surface) const
{
  cartesian::RefinementSpec spec;
  spec.depth = this->RefinementDepth;
  spec.transitionLayers = this->TransitionLayers;
  spec.isotropic = this->IsotropicLevels;
  spec.periodic = static_cast<unsigned>(this->PeriodicSides);
  spec.sizing.curvatureAngle = this->CurvatureAngle;
  spec.sizing.featureDepth = this->FeatureDepth;
  spec.sizing.cellsAcrossGaps = this->CellsAcrossGaps;
  spec.sizing.largestDepth = this->LargestDepth;
  for (std::size_t n = 0; n < this->RefinementBlocks.size(); ++n)
  {
    const std::string name = "row " + std::to_string(n) + " of Refinement Blocks";
    std::array<int, 8> whole;
    for (std::size_t i = 0; i < whole.size(); ++i)
    {
      whole[i] = WholeNumber(this->RefinementBlocks[n][i], name);
    }
    spec.blocks.push_back(
      { { whole[0], whole[2], whole[4] }, { whole[1], whole[3], whole[5] }, whole[6], whole[7] });
  }
  for (std::size_t n = 0; n < this->BoundaryRefinements.size(); ++n)
  {
    const std::string name = "row " + std::to_string(n) + " of Boundary Refinement";
    const std::array<double, 4>& row = this->BoundaryRefinements[n];
    spec.boundaries.push_back({ WholeNumber(row[0], name), WholeNumber(row[1], name),
      WholeNumber(row[2], name), WholeNumber(row[3], name) != 0 });
  }
  for (const auto& [boundary, depth] :
    cartesian::boundaryDepths(this->Boundaries(), surface.names(), surface.sides()))
  {
    spec.addUnlessThere({ boundary, depth, 0, false });
  }
  for (const std::string& name : this->RefinedBoundaries)
  {
    spec.addUnlessThere({ cartesian::boundaryCalled(surface.names(), name, "Refined Boundaries"),
      this->RefinedBoundaryDepth, 0, false });
  }
  return spec;
}

std::vector<vtkSmartPointer<vtkDataObject>> vtkCartesianGridAlgorithm::Regions(
  vtkInformationVector* input)
{
  std::vector<vtkSmartPointer<vtkDataObject>> regions;
  regions.reserve(static_cast<std::size_t>(input->GetNumberOfInformationObjects()));
  for (int i = 0; i < input->GetNumberOfInformationObjects(); ++i)
  {
    regions.emplace_back(vtkDataObject::GetData(input, i));
  }
  return regions;
}

cartesian::AskedSizes vtkCartesianGridAlgorithm::ReadSizes(
  vtkDataObject* surface, const cartesian::SurfaceFromVTK& source, vtkDataObject* field) const
{
  if (this->SizeArray.empty())
  {
    return {};
  }
  return field ? cartesian::sizesInField(this->SizeArray, field)
               : cartesian::sizesOnSurface(this->SizeArray, surface, source.cells());
}

void vtkCartesianGridAlgorithm::AddRefinement(const cartesian::SurfaceFromVTK& source,
  std::vector<RegionSurface>& regions, cartesian::AskedSizes sizes, cartesian::Options& options)
{
  options.refinement = this->MakeSpec(source);
  this->AddFlowRefinement(source, options, regions);
  options.refinement.sizing.sizes = std::move(sizes.boxes);
  options.refinement.sizing.sizeOfTriangle = std::move(sizes.ofTriangles);
  for (const RegionSurface& region : regions)
  {
    options.refinement.regions.push_back({ region.surface->view(), region.depth });
  }
}

std::unique_ptr<cartesian::Decomposition> vtkCartesianGridAlgorithm::Divide(
  const cartesian::SurfaceFromVTK& source, const cartesian::PreparedSurface& prepared,
  const std::vector<vtkSmartPointer<vtkDataObject>>& regions, cartesian::AskedSizes sizes,
  cartesian::Execution& execution)
{
  if (!this->SizeArray.empty() && !sizes.isThere)
  {
    throw cartesian::Error(cartesian::Fault::MissingArray,
      "Size Array \"" + this->SizeArray + "\" is not a point or cell array of the " +
        (this->GetNumberOfInputConnections(2) > 0 ? "Size Field" : "surface") +
        " with one number per point or cell: choose another, or none.");
  }
  if (!this->RefinedBoundaries.empty())
  {
    this->Warn("Refined Boundaries is deprecated: give each of these boundaries a row in Boundary "
               "Names and its "
               "refinement level in Boundary Depths.");
  }
  std::vector<RegionSurface> surfaces = this->RegionSurfaces(regions);
  for (const RegionSurface& region : surfaces)
  {
    const std::string undivided = region.surface->describeLeftOut();
    this->Warn(undivided.empty() ? "" : "In a refinement region: " + undivided);
  }
  cartesian::Options options = this->MakeOptions();
  this->AddRefinement(source, surfaces, std::move(sizes), options);
  auto decomposition = cartesian::decompose(prepared, options, execution);
  for (const std::string& warning :
    { cartesian::describeOverhang(prepared), cartesian::describeTiny(prepared, options),
      cartesian::describeShortfall(options.domain, this->FlowOf(source, options)),
      decomposition->warnings() })
  {
    this->Warn(warning);
  }
  return decomposition;
}

void vtkCartesianGridAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CellSize: " << this->CellSize << "\n";
  for (int axis = 0; axis < 3; ++axis)
  {
    PrintColumn(os, indent, std::string("Meshlines") + "XYZ"[axis], this->Meshlines[axis]);
  }
  os << indent << "BoundaryArray: " << this->BoundaryArray << "\n";
  os << indent << "RefinementDepth: " << this->RefinementDepth << "\n";
  os << indent << "TransitionLayers: " << this->TransitionLayers << "\n";
  os << indent << "IsotropicLevels: " << this->IsotropicLevels << "\n";
  os << indent << "PeriodicSides: " << this->PeriodicSides << "\n";
  PrintTable(os, indent, "RefinementBlocks", this->RefinementBlocks);
  PrintTable(os, indent, "BoundaryRefinements", this->BoundaryRefinements);
  PrintColumn(os, indent, "BoundaryNames", this->BoundaryNames);
  PrintColumn(os, indent, "BoundaryDepths", this->BoundaryDepths);
  os << indent << "RefinedBoundaries:";
  for (const std::string& name : this->RefinedBoundaries)
  {
    os << " " << name;
  }
  os << "\n";
  os << indent << "RefinedBoundaryDepth: " << this->RefinedBoundaryDepth << "\n";
  os << indent << "RegionDepth: " << this->RegionDepth << "\n";
  PrintColumn(os, indent, "RefinementShapes", this->RefinementShapes);
  PrintTable(os, indent, "RefinementPositions", this->RefinementPositions);
  PrintTable(os, indent, "RefinementLengths", this->RefinementLengths);
  PrintColumn(os, indent, "RefinementShapeDepths", this->RefinementShapeDepths);
  os << indent << "CurvatureAngle: " << this->CurvatureAngle << "\n";
  os << indent << "FeatureDepth: " << this->FeatureDepth << "\n";
  os << indent << "CellsAcrossGaps: " << this->CellsAcrossGaps << "\n";
  os << indent << "LargestDepth: " << this->LargestDepth << "\n";
  os << indent << "SizeArray: " << this->SizeArray << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
}
