// SPDX-License-Identifier: BSD-3-Clause
// Properties as the keys and values of a task file (Task/parameters.py reads them back).
#pragma once

#include <string>
#include <utility>
#include <vector>

class vtkSMProperty;
class vtkSMProxy;

namespace cartesian
{

// A table [name] of a task file, or one of those called [[name]].
struct TaskTable
{
  std::string name;
  bool isRow;
  std::vector<std::pair<std::string, std::string>> entries; // key and value, in TOML
};

// A label as a key: "Cell Size" is cell_size.
std::string keyOf(const std::string& label);

// A text in TOML.
std::string tomlText(const std::string& text);

// The shortest that reads back to the same number.
std::string tomlNumber(double value);

// All values of a property, in TOML.
std::string valueOf(vtkSMProperty* property);

// Whether a property has the values that a new one of its proxy has.
bool hasDefault(vtkSMProxy* proxy, const char* name);

// The properties that differ from their defaults, by the panel's groups; tables of rows come last. Throws
// std::runtime_error where the columns of a table of rows do not match.
std::vector<TaskTable> tablesOf(vtkSMProxy* proxy);

// The table [name], which is added if there is none.
TaskTable& tableCalled(std::vector<TaskTable>& tables, const std::string& name);

// A task file of these tables, without the empty ones.
std::string textOf(const std::vector<TaskTable>& tables);

}
