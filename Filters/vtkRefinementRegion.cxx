// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRefinementRegion.h"

#include "ReportErrors.h"
#include "SurfaceBlocks.h"
#include "vtkCartesianAlgorithm.h"

#include "vtkAppendPolyData.h"
#include "vtkCompositeDataSet.h"
#include "vtkCubeSource.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

#include <algorithm>

namespace
{

// Of a sphere, once around.
constexpr int Facets = 64;

void CopyBlocks(vtkDataObject* blocks, vtkPolyData* output)
{
  if (blocks->GetNumberOfElements(vtkDataObject::CELL) == 0)
  {
    return; // those of other processes than the first
  }
  vtkNew<vtkAppendPolyData> together;
  together->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  for (const cartesian::SurfaceBlock& block : cartesian::surfaceBlocks(blocks))
  {
    together->AddInputData(block.surface);
  }
  together->Update();
  output->ShallowCopy(together->GetOutput());
}

}

vtkStandardNewMacro(vtkRefinementRegion);

int vtkRefinementRegion::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

int vtkRefinementRegion::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
  if (this->Shape == Input && vtkPolyData::SafeDownCast(input))
  {
    output->ShallowCopy(input);
  }
  else if (this->Shape == Input && vtkCompositeDataSet::SafeDownCast(input))
  {
    cartesian::reportErrors([&] { CopyBlocks(input, output); },
      [this](unsigned long code, const std::string& message) {
        this->SetErrorCode(code);
        vtkErrorMacro(<< message);
      });
  }
  else if (this->Shape == Sphere && this->Radius > 0)
  {
    this->MakeSphere(output);
  }
  else if (this->Shape == Box && *std::min_element(this->Length, this->Length + 3) > 0)
  {
    this->MakeBox(output);
  }
  else
  {
    this->SetErrorCode(vtkCartesianAlgorithm::BadParameter);
    vtkErrorMacro("The region has no volume: a box needs a positive Length along all three axes, a "
                  "sphere a positive Radius, and Shape Input a surface as input.");
  }
  vtkNew<vtkIntArray> depth;
  depth->SetName(cartesian::RegionDepthField);
  depth->InsertNextValue(this->Depth);
  output->GetFieldData()->AddArray(depth);
  return 1;
}

void vtkRefinementRegion::MakeBox(vtkPolyData* output)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(0, 1, 0, 1, 0, 1);
  vtkNew<vtkTransform> place;
  place->Translate(this->Position);
  place->RotateZ(this->Rotation[2]);
  place->RotateX(this->Rotation[0]);
  place->RotateY(this->Rotation[1]);
  place->Scale(this->Length);
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetInputConnection(cube->GetOutputPort());
  filter->SetTransform(place);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->Update();
  output->CopyStructure(filter->GetOutput());
}

void vtkRefinementRegion::MakeSphere(vtkPolyData* output)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(this->Center);
  sphere->SetRadius(this->Radius);
  sphere->SetThetaResolution(Facets);
  sphere->SetPhiResolution(Facets / 2);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();
  output->CopyStructure(sphere->GetOutput());
}

void vtkRefinementRegion::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const double* x) {
    os << indent << name << ": " << x[0] << " " << x[1] << " " << x[2] << "\n";
  };
  os << indent << "Shape: " << this->Shape << "\n";
  print("Position", this->Position);
  print("Rotation", this->Rotation);
  print("Length", this->Length);
  print("Center", this->Center);
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "Depth: " << this->Depth << "\n";
}
