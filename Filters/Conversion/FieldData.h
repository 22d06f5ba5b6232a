// SPDX-License-Identifier: BSD-3-Clause
// Field data: small named arrays of numbers that describe a whole data object.
#pragma once

#include "Base/Error.h"

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"

#include <array>
#include <vector>

namespace cartesian
{

inline void setField(vtkDataObject* data, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  data->GetFieldData()->AddArray(array);
}

inline void setVector(vtkDataObject* data, const char* name, const std::array<double, 3>& value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->InsertNextTuple(value.data());
  data->GetFieldData()->AddArray(array);
}

// Throws Error (MissingArray) unless there is such an array of `size` numbers (0: any size).
inline std::vector<double> getField(vtkDataObject* data, const char* name, vtkIdType size)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfComponents() != 1 ||
    (size != 0 && array->GetNumberOfTuples() != size))
  {
    throw Error(Fault::MissingArray,
      std::string("The field data array \"") + name +
        "\" is missing or has the wrong size: connect the output of Cartesian Boxer.");
  }
  std::vector<double> values;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
}

}
