// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWholeMeshWriter.h"

#include "FoamFromVTK.h"
#include "MeshUnion.h"
#include "ReportErrors.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

vtkWholeMeshWriter::~vtkWholeMeshWriter()
{
  delete[] this->FileName;
}

int vtkWholeMeshWriter::FillInputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

vtkTypeBool vtkWholeMeshWriter::ProcessRequest(
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

vtkSmartPointer<vtkUnstructuredGrid> vtkWholeMeshWriter::Gather()
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

bool vtkWholeMeshWriter::Try(const std::function<void()>& action)
{
  return cartesian::reportErrors(action, [this](unsigned long code, const std::string& message) {
    this->SetErrorCode(code);
    vtkErrorMacro(<< message);
  });
}

void vtkWholeMeshWriter::WriteData()
{
  this->Try([&] {
    const vtkSmartPointer<vtkUnstructuredGrid> grid = this->Gather();
    if (grid && !this->HasFileName())
    {
      this->SetErrorCode(vtkErrorCode::NoFileNameError);
      vtkErrorMacro("There is no file name: set one, such as case.foam.");
    }
    else if (grid)
    {
      this->WriteGrid(grid);
    }
  });
}

void vtkWholeMeshWriter::WriteGrid(vtkUnstructuredGrid* grid)
{
  cartesian::Execution execution(0);
  cartesian::WholeMesh whole = cartesian::wholeMesh(grid, execution);
  if (whole.lostBoundaries)
  {
    vtkWarningMacro(<< cartesian::LostBoundaries);
  }
  this->UpdateProgress(0.5);
  this->WriteMesh(whole);
}

void vtkWholeMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
