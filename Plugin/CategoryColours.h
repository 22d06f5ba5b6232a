// SPDX-License-Identifier: BSD-3-Clause
// The colours of arrays whose values are names, which all meshes share.
#pragma once

#include <array>
#include <set>
#include <string>
#include <vector>

class vtkSMProxy;

namespace cartesian
{

constexpr const char* Boundaries = "BoundaryName";
constexpr const char* Defects = "DefectName";
constexpr const char* Regions = "Region";
constexpr const char* Interfaces = "InterfaceName";
constexpr std::array<const char*, 4> Arrays{ Boundaries, Defects, Regions, Interfaces };

// As vtkSMTransferFunctionManager names them.
constexpr const char* ColoursGroup = "lookup_tables";

std::string nameOfColours(const std::string& array);

struct Category
{
  std::string value;
  std::string name;
};

// The entries "array/value" or "array/value/name" of a property LegendInfo.
std::vector<Category> categoriesOf(vtkSMProxy* source, const std::string& array);

// Those of a source that are not there yet are added, and names are the last ones.
void addCategories(vtkSMProxy* colours, vtkSMProxy* source, const std::string& array);

// The colours of others stay as they are.
void removeCategories(vtkSMProxy* colours, const std::set<std::string>& gone);

}
