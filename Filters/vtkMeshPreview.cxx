// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshPreview.h"

#include "AskedMesh.h"
#include "PreviewToVTK.h"
#include "ReportErrors.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkMeshPreview);

namespace
{

// Of more, box sizes take too long.
constexpr std::size_t MostTriangles = 500000;

// Colours differ within triangles that are larger than the longest side of the surface by this.
constexpr double PiecesAlongSurface = 64;

// The work itself will report errors.
template <class Work>
bool Try(Work&& work)
{
  return cartesian::reportErrors(work, [](unsigned long, const std::string&) {});
}

}

int vtkMeshPreview::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

int vtkMeshPreview::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  // NOLINTNEXTLINE(bugprone-parent-virtual-call): the mesher asks for pieces
  return this->vtkCartesianAlgorithm::RequestUpdateExtent(request, input, output);
}

vtkStringArray* vtkMeshPreview::GetBoxSizes()
{
  return this->BoxSizes;
}

double* vtkMeshPreview::GetBoxAroundSurface()
{
  this->BoxAroundSurface = {};
  const vtkBoundingBox bounds = this->BoundsOfInput();
  Try([&] {
    if (bounds.IsValid())
    {
      cartesian::DomainSpec domain = this->MakeOptions().domain;
      domain.boxFrom = cartesian::BoxSource::Surface;
      domain.ground = cartesian::DomainSide::NoSide;
      domain.half = cartesian::Half::Whole;
      cartesian::Bounds surface{};
      bounds.GetMinPoint(surface.low.data());
      bounds.GetMaxPoint(surface.high.data());
      const cartesian::Bounds box = cartesian::boxAround(domain, surface);
      this->BoxAroundSurface = { box.low[0], box.high[0], box.low[1], box.high[1], box.low[2],
        box.high[2] };
    }
  });
  return this->BoxAroundSurface.data();
}

int vtkMeshPreview::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  this->BoxSizes->Initialize();
  if (IsLeftToFirstProcess(request, output))
  {
    return 1;
  }
  Try([&] {
    const cartesian::SurfaceFromVTK surface = this->ReadWithSides(vtkDataObject::GetData(input[0]));
    const bool isSmall = surface.view().triangleCount <= MostTriangles;
    if (!isSmall || !Try([&] { this->ShowBoxes(surface, output); }))
    {
      this->ShowWithoutBoxes(surface, output);
    }
  });
  return 1;
}

void vtkMeshPreview::ShowBoxes(
  const cartesian::SurfaceFromVTK& surface, vtkInformationVector* output)
{
  const Asked asked = this->Ask(surface);
  std::vector<cartesian::ZoneShape> zones;
  for (const RegionSurface& region : asked.regions)
  {
    zones.push_back({ region.shape, region.depth });
  }
  cartesian::zonesToVTK(zones, vtkPolyData::GetData(output, 3));
  const cartesian::SurfacePieces pieces = cartesian::piecesOf(
    surface.view(), cartesian::hasSeveralDepths(asked.options) ? PiecesAlongSurface : 0);
  cartesian::Execution execution(this->NumberOfThreads);
  const cartesian::ExpectedDepths expected =
    cartesian::expectedDepths(surface.view(), asked.options, pieces.centres(), execution);
  cartesian::surfaceToVTK(pieces, expected, vtkPolyData::GetData(output, 0));
  cartesian::sizesToVTK(expected, zones, this->BoxSizes);
  ShowDomain(expected.grid, asked.options.domain, output);
}

void vtkMeshPreview::ShowWithoutBoxes(
  const cartesian::SurfaceFromVTK& surface, vtkInformationVector* output)
{
  if (surface.view().triangleCount <= MostTriangles)
  {
    cartesian::surfaceToVTK(
      cartesian::piecesOf(surface.view(), 0), {}, vtkPolyData::GetData(output, 0));
  }
  const cartesian::DomainSpec domain = this->MakeOptions().domain;
  ShowDomain(cartesian::boxAround(domain, cartesian::boundsOf(surface.view())), domain, output);
}

void vtkMeshPreview::ShowDomain(
  const cartesian::Bounds& box, const cartesian::DomainSpec& domain, vtkInformationVector* output)
{
  if (domain.isOutside())
  {
    cartesian::domainToVTK(box, domain.flow, vtkPolyData::GetData(output, 1));
  }
  cartesian::labelsToVTK(box, domain, vtkPolyData::GetData(output, 2));
}

void vtkMeshPreview::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
