// SPDX-License-Identifier: BSD-3-Clause
#include "RefinementLevel.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <functional>

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
  const unsigned char* const first = deepest->GetPointer(0);
  const unsigned char* const end = first + deepest->GetNumberOfValues();
  const bool differs = std::adjacent_find(first, end, std::not_equal_to<>()) != end;
  differs ? data->SetScalars(deepest) : data->AddArray(deepest);
}

}
