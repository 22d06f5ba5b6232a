// SPDX-License-Identifier: BSD-3-Clause
#include "LengthUnit.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkFieldData.h"

namespace cartesian
{

namespace
{

// 0: nothing is said.
double saidBy(vtkDataObject* data)
{
  vtkFieldData* const fields = data ? data->GetFieldData() : nullptr;
  vtkDataArray* const said = fields ? fields->GetArray(MetresPerUnitField) : nullptr;
  return said && said->GetNumberOfValues() == 1 ? said->GetComponent(0, 0) : 0;
}

}

double metresPerUnit(vtkDataObject* data)
{
  double said = saidBy(data);
  if (auto* const blocks = vtkDataObjectTree::SafeDownCast(data); blocks && said == 0)
  {
    for (vtkDataObject* block :
      vtk::Range(blocks,
        vtk::DataObjectTreeOptions::TraverseSubTree | vtk::DataObjectTreeOptions::VisitOnlyLeaves |
          vtk::DataObjectTreeOptions::SkipEmptyNodes))
    {
      said = said > 0 ? said : saidBy(block);
    }
  }
  return said > 0 ? said : 1;
}

}
