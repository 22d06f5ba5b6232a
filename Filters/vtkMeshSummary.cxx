// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshSummary.h"

#include "CellSelection.h"
#include "MeshInWords.h"
#include "Quality/WorstMeasure.h"
#include "vtkFiniteVolumeQuality.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedIntArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

vtkStandardNewMacro(vtkMeshSummary);

namespace
{

void AddText(const char* name, const std::string& text, vtkTable* table)
{
  vtkNew<vtkStringArray> column;
  column->SetName(name);
  column->InsertNextValue(text);
  table->AddColumn(column);
}

// Those that fail a measure or checkMesh; long prisms are good cells.
void SelectFailing(
  vtkUnstructuredGrid* mesh, const cartesian::MeshCheck& check, vtkUnstructuredGrid* output)
{
  auto* failures = vtkUnsignedIntArray::SafeDownCast(mesh->GetCellData()->GetArray("Failures"));
  vtkUnsignedCharArray* ghosts = mesh->GetCellGhostArray();
  std::vector<unsigned char> isChosen(static_cast<std::size_t>(mesh->GetNumberOfCells()));
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const bool isGhost = ghosts && ghosts->GetValue(cell) != 0;
    const unsigned int failing = failures->GetValue(cell) & cartesian::FailuresForSolvers;
    isChosen[static_cast<std::size_t>(cell)] = !isGhost && failing != 0 ? 1 : 0;
  }
  for (const vtkIdType cell : check.failing)
  {
    isChosen[static_cast<std::size_t>(cell)] = 1;
  }
  cartesian::selectCells(mesh, isChosen, output);
}

void SelectWorst(
  vtkUnstructuredGrid* mesh, cartesian::Measure measure, int number, vtkUnstructuredGrid* output)
{
  vtkNew<vtkIntArray> rank;
  rank->SetName("Rank");
  rank->SetNumberOfValues(mesh->GetNumberOfCells());
  rank->FillValue(0);
  const std::vector<vtkIdType> cells = cartesian::rankedCells(mesh, measure);
  const std::size_t count = std::min(cells.size(), static_cast<std::size_t>(number));
  std::vector<unsigned char> isChosen(static_cast<std::size_t>(mesh->GetNumberOfCells()));
  for (std::size_t i = 0; i < count; ++i)
  {
    rank->SetValue(cells[i], static_cast<int>(i) + 1);
    isChosen[static_cast<std::size_t>(cells[i])] = 1;
  }
  vtkNew<vtkUnstructuredGrid> ranked;
  ranked->ShallowCopy(mesh);
  ranked->GetCellData()->AddArray(rank);
  cartesian::selectCells(ranked, isChosen, output);
}

}

vtkMeshSummary::vtkMeshSummary()
{
  this->SetNumberOfOutputPorts(3);
}

int vtkMeshSummary::FillInputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

int vtkMeshSummary::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkTable" : "vtkUnstructuredGrid");
  return 1;
}

int vtkMeshSummary::RequestUpdateExtent(
  vtkInformation* /*request*/, vtkInformationVector** input, vtkInformationVector* /*output*/)
{
  return AskForNeighbours(input);
}

int vtkMeshSummary::RequestData(
  vtkInformation* /*request*/, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkNew<vtkUnstructuredGrid> grid;
  grid->ShallowCopy(vtkUnstructuredGrid::GetData(input[0]));
  vtkNew<vtkFiniteVolumeQuality> quality;
  quality->SetNumberOfThreads(this->NumberOfThreads);
  quality->SetInputData(grid);
  quality->Update();
  this->ErrorCode = quality->GetErrorCode();
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(quality->GetOutputDataObject(0));
  vtkNew<vtkUnstructuredGrid> none;
  cartesian::Execution execution(this->NumberOfThreads);
  const cartesian::MeshCheck check = cartesian::checkMesh(
    this->ErrorCode == 0 ? mesh : none.Get(), cartesian::Checked::All, execution);
  constexpr std::size_t MostOfABriefText = 3; // worst values: a long text would hide the mesh
  const cartesian::MeshInWords words = cartesian::inWords(mesh, check);
  this->Text = words.verdict + words.size + words.worst(cartesian::MeasureCount) + words.regions +
    words.boundaries + words.done;
  this->WorstMeasure = quality->GetWorstMeasure();
  AddText("Brief", words.verdict + words.size + words.worst(MostOfABriefText),
    vtkTable::GetData(output, 0));
  AddText("Text", this->Text, vtkTable::GetData(output, 0));
  if (this->ErrorCode == 0)
  {
    SelectWorst(mesh, static_cast<cartesian::Measure>(this->Measure), this->NumberOfWorstCells,
      vtkUnstructuredGrid::GetData(output, 1));
    SelectFailing(mesh, check, vtkUnstructuredGrid::GetData(output, 2));
  }
  return 1;
}

void vtkMeshSummary::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Measure: " << this->Measure << "\n";
  os << indent << "NumberOfWorstCells: " << this->NumberOfWorstCells << "\n";
}
