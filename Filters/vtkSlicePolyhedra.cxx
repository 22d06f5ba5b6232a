// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSlicePolyhedra.h"

#include "Base/Error.h"
#include "SectionOfGrid.h"

#include "vtkAppendFilter.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkSlicePolyhedra);

int vtkSlicePolyhedra::FillInputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

int vtkSlicePolyhedra::FillOutputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

// Each process slices its own cells.
int vtkSlicePolyhedra::RequestUpdateExtent(
  vtkInformation* /*request*/, vtkInformationVector** /*input*/, vtkInformationVector* /*output*/)
{
  return 1;
}

int vtkSlicePolyhedra::RequestData(
  vtkInformation* /*request*/, vtkInformationVector** input, vtkInformationVector* output)
{
  this->Run(0, 1, [&](cartesian::Execution& execution) {
    const cartesian::Vector normal{ this->Normal[0], this->Normal[1], this->Normal[2] };
    if (!(cartesian::norm(normal) > 0))
    {
      throw cartesian::Error(cartesian::Fault::BadParameter,
        "Normal has no length: give the direction that the plane faces.");
    }
    vtkDataSet* data = vtkDataSet::GetData(input[0]);
    vtkNew<vtkAppendFilter> converted; // of other kinds of grids
    auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
    if (!grid)
    {
      converted->SetInputData(data);
      converted->Update();
      grid = converted->GetOutput();
    }
    execution.stage("Sections", 0, 1);
    cartesian::SectionOfGrid section(
      grid, { this->Origin[0], this->Origin[1], this->Origin[2] }, cartesian::unit(normal));
    for (const double offset : this->Offsets)
    {
      section.add(offset, execution);
    }
    section.write(vtkPolyData::GetData(output));
  });
  return 1;
}

void vtkSlicePolyhedra::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Origin: " << this->Origin[0] << " " << this->Origin[1] << " " << this->Origin[2]
     << "\n";
  os << indent << "Normal: " << this->Normal[0] << " " << this->Normal[1] << " " << this->Normal[2]
     << "\n";
  this->PrintColumn(os, indent, "Offsets", this->Offsets);
}
