// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceBoundaries.h"

#include "ListedBoundaries.h"
#include "ReportErrors.h"
#include "Surface/FlowDomain.h"
#include "SurfaceFromVTK.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <array>
#include <cstdio>

vtkStandardNewMacro(vtkSurfaceBoundaries);

namespace
{

std::string InText(double value)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

}

vtkSurfaceBoundaries::vtkSurfaceBoundaries()
{
  this->SetNumberOfOutputPorts(1);
}

vtkSurfaceBoundaries::~vtkSurfaceBoundaries() = default;

void vtkSurfaceBoundaries::SetNumberOfShown(int number)
{
  this->Resize(this->Shown, number);
}

void vtkSurfaceBoundaries::SetShown(int row, const char* name)
{
  this->SetRow(this->Shown, row, std::string(name ? name : ""));
}

vtkStringArray* vtkSurfaceBoundaries::GetList()
{
  return this->List;
}

const char* vtkSurfaceBoundaries::GetBoundaryOnWay()
{
  const double* const way = this->Way;
  this->BoundaryOnWay = this->Surface ? cartesian::boundaryBetween(*this->Surface,
                                          { way[0], way[1], way[2] }, { way[3], way[4], way[5] })
                                      : std::string();
  return this->BoundaryOnWay.c_str();
}

int vtkSurfaceBoundaries::FillOutputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

int vtkSurfaceBoundaries::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  // NOLINTNEXTLINE(bugprone-parent-virtual-call): the mesher asks for pieces
  return this->vtkCartesianAlgorithm::RequestUpdateExtent(request, input, output);
}

// Before boundaries merge, and with open bodies, which are left out unless a row says that they are baffles.
void vtkSurfaceBoundaries::ReadAnew(vtkDataObject* data)
{
  this->Surface.reset();
  this->List->Initialize();
  cartesian::reportErrors(
    [&] {
      auto surface = std::make_unique<cartesian::SurfaceFromVTK>(data, this->BoundaryArray,
        static_cast<cartesian::RegionSource>(this->RegionsFrom), this->RegionArray);
      if (const cartesian::DomainSpec domain = this->MakeOptions().domain; domain.isOutside())
      {
        surface->addSides(cartesian::namesOfSides(domain));
      }
      this->AddGaps(*surface);
      for (const cartesian::ListedBoundary& boundary : cartesian::listBoundaries(*surface))
      {
        const bool hasNone = boundary.triangles == 0;
        this->List->InsertNextValue(boundary.name);
        this->List->InsertNextValue(hasNone ? "" : InText(boundary.area));
        this->List->InsertNextValue(hasNone ? "" : std::to_string(boundary.triangles));
      }
      this->Surface = std::move(surface);
    },
    [](unsigned long, const std::string&) {});
}

int vtkSurfaceBoundaries::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  if (!IsLeftToFirstProcess(request, output))
  {
    this->ReadAnew(vtkDataObject::GetData(input[0]));
    if (this->Surface)
    {
      cartesian::boundariesToVTK(*this->Surface, this->Shown, vtkPolyData::GetData(output));
    }
  }
  return 1;
}

void vtkSurfaceBoundaries::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  PrintColumn(os, indent, "Shown", this->Shown);
  os << indent << "Way:";
  for (double coordinate : this->Way)
  {
    os << " " << coordinate;
  }
  os << "\n";
}
