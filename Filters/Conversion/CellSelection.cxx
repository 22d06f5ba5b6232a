// SPDX-License-Identifier: BSD-3-Clause
#include "CellSelection.h"

#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkThreshold.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace cartesian
{

void selectCells(vtkUnstructuredGrid* grid, const std::vector<unsigned char>& isChosen,
  vtkUnstructuredGrid* output)
{
  constexpr const char* Chosen = "IsChosenCell";
  vtkNew<vtkUnsignedCharArray> chosen;
  chosen->SetName(Chosen);
  chosen->SetNumberOfValues(grid->GetNumberOfCells());
  std::copy(isChosen.begin(), isChosen.end(), chosen->GetPointer(0));
  vtkNew<vtkUnstructuredGrid> marked;
  marked->ShallowCopy(grid);
  marked->GetCellData()->AddArray(chosen);
  vtkNew<vtkThreshold> threshold;
  threshold->SetInputData(marked);
  threshold->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, Chosen);
  threshold->SetThresholdFunction(vtkThreshold::THRESHOLD_UPPER);
  threshold->SetUpperThreshold(1);
  threshold->Update();
  output->ShallowCopy(threshold->GetOutput());
  output->GetCellData()->RemoveArray(Chosen);
}

}
