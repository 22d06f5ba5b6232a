// SPDX-License-Identifier: BSD-3-Clause
#include "RefinementLevel.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace cartesian
{

void setRefinementLevel(vtkCellData* data)
{
  auto* const levels = vtkUnsignedCharArray::SafeDownCast(data->GetArray("Level"));
  vtkNew<vtkUnsignedCharArray> deepest;
  deepest->SetName("RefinementLevel");
  deepest->SetNumberOfValues(levels->GetNumberOfTuples());
  for (vtkIdType i = 0; i < levels->GetNumberOfTuples(); ++i)
  {
    const unsigned char* const level = levels->GetPointer(3 * i);
    deepest->SetValue(i, *std::max_element(level, level + 3));
  }
  data->SetScalars(deepest);
}

}
