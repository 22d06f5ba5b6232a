// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryNames.h"

#include "Base/Error.h"
#include "Surface/Surface.h"
#include "Utf8.h"

#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

namespace cartesian
{

namespace
{

constexpr const char* Ids = "BoundaryIds";
constexpr const char* Names = "BoundaryNames";

}

std::string unnamedBoundary(std::int32_t boundary)
{
  return boundary < 0 ? "no_surface" : "boundary_" + std::to_string(boundary);
}

std::int32_t boundaryCalled(
  const BoundaryNames& names, const std::string& name, const std::string& property)
{
  std::string known;
  for (const auto& named : names)
  {
    if (named.second == name)
    {
      return named.first;
    }
    known += (known.empty() ? "" : ", ") + named.second;
  }
  if (name == unnamedBoundary(NoBoundary))
  {
    return NoBoundary;
  }
  throw Error(Fault::BadParameter,
    property + " has \"" + name + "\", which is not a boundary of the surface. Choose from " +
      known + ".");
}

BoundaryNames boundaryNames(vtkDataObject* data)
{
  vtkFieldData* fields = data->GetFieldData();
  vtkDataArray* ids = fields->GetArray(Ids);
  auto* names = vtkStringArray::SafeDownCast(fields->GetAbstractArray(Names));
  if (!ids && !names)
  {
    return {};
  }
  if (!ids || !names || ids->GetNumberOfValues() != names->GetNumberOfValues())
  {
    throw Error(Fault::MissingArray,
      std::string("The field data ") + Ids + " and " + Names +
        " must have the same number of values: give both, or neither.");
  }
  BoundaryNames result;
  for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
  {
    result[static_cast<std::int32_t>(ids->GetComponent(i, 0))] = toUtf8(names->GetValue(i));
  }
  return result;
}

void setBoundaryNames(vtkDataObject* data, const BoundaryNames& names)
{
  vtkNew<vtkIntArray> idArray;
  idArray->SetName(Ids);
  vtkNew<vtkStringArray> nameArray;
  nameArray->SetName(Names);
  for (const auto& [id, name] : names)
  {
    idArray->InsertNextValue(id);
    nameArray->InsertNextValue(name);
  }
  data->GetFieldData()->AddArray(idArray);
  data->GetFieldData()->AddArray(nameArray);
}

BoundaryNames uniteNames(const std::vector<std::string>& names, vtkDataArray* labels)
{
  BoundaryNames result;
  std::map<std::string, std::int32_t> numbers;
  for (const std::string& name : names)
  {
    const auto number = static_cast<std::int32_t>(numbers.size());
    if (numbers.emplace(name, number).second)
    {
      result[number] = name.empty() ? "unnamed" : name;
    }
  }
  for (vtkIdType cell = 0; cell < labels->GetNumberOfTuples(); ++cell)
  {
    const auto part = static_cast<std::size_t>(labels->GetComponent(cell, 0));
    labels->SetComponent(cell, 0, numbers.at(names.at(part)));
  }
  return result;
}

void setBoundaryTypes(vtkDataObject* data, const BoundaryNames& names, const BoundaryNames& types)
{
  if (types.empty())
  {
    return;
  }
  vtkNew<vtkStringArray> array;
  array->SetName("BoundaryTypes");
  for (const auto& named : names)
  {
    const auto type = types.find(named.first);
    array->InsertNextValue(type == types.end() ? "" : type->second);
  }
  data->GetFieldData()->AddArray(array);
}

}
