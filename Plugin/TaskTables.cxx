// SPDX-License-Identifier: BSD-3-Clause
#include "TaskTables.h"

#include "vtkPVXMLElement.h"
#include "vtkSMArraySelectionDomain.h"
#include "vtkSMBooleanDomain.h"
#include "vtkSMEnumerationDomain.h"
#include "vtkSMInputProperty.h"
#include "vtkSMIntVectorProperty.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMStringVectorProperty.h"
#include "vtkSMVectorProperty.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>
#include <stdexcept>

namespace cartesian
{

namespace
{

// One value; `kind`: the property that says what it is, itself or that of a table's row.
std::string elementOf(vtkSMProperty* property, unsigned int i, vtkSMProperty* kind)
{
  const vtkSMPropertyHelper values(property);
  if (auto* choices = kind->FindDomain<vtkSMEnumerationDomain>())
  {
    return tomlText(choices->GetEntryTextForValue(values.GetAsInt(i)));
  }
  if (kind->FindDomain<vtkSMBooleanDomain>())
  {
    return values.GetAsInt(i) != 0 ? "true" : "false";
  }
  if (vtkSMStringVectorProperty::SafeDownCast(property))
  {
    return tomlText(values.GetAsString(i));
  }
  return vtkSMIntVectorProperty::SafeDownCast(property) ? std::to_string(values.GetAsInt(i))
                                                        : tomlNumber(values.GetAsDouble(i));
}

std::string join(const std::vector<std::string>& parts, const char* open, const char* close)
{
  std::string text = open;
  for (const std::string& part : parts)
  {
    text += (&part == parts.data() ? "" : ", ") + part;
  }
  return text + close;
}

// `count` values from `first` on, as a list.
std::string listOf(
  vtkSMProperty* property, unsigned int first, unsigned int count, vtkSMProperty* kind)
{
  std::vector<std::string> values;
  for (unsigned int i = first; i < first + count; ++i)
  {
    values.push_back(elementOf(property, i, kind));
  }
  return join(values, "[", "]");
}

std::vector<std::string> columnsOf(vtkSMProperty* property)
{
  vtkPVXMLElement* const hints = property->GetHints();
  vtkPVXMLElement* const labels =
    hints ? hints->FindNestedElementByName("ShowComponentLabels") : nullptr;
  std::vector<std::string> columns;
  for (unsigned int i = 0; labels && i < labels->GetNumberOfNestedElements(); ++i)
  {
    columns.push_back(keyOf(labels->GetNestedElement(i)->GetAttribute("label")));
  }
  return columns;
}

// Any number of rows, each a list, or a table if its columns have names.
std::string rowsOf(vtkSMProperty* property, unsigned int total, unsigned int width)
{
  const std::vector<std::string> columns = columnsOf(property);
  std::vector<std::string> rows;
  for (unsigned int first = 0; first < total; first += width)
  {
    std::vector<std::string> row;
    for (unsigned int i = 0; i < columns.size() && i < width; ++i)
    {
      row.push_back(columns[i] + " = " + elementOf(property, first + i, property));
    }
    rows.push_back(
      row.size() == width ? join(row, "{ ", " }") : listOf(property, first, width, property));
  }
  return join(rows, "[\n  ", ",\n]");
}

// Names of an array selection that are chosen.
std::string chosenOf(vtkSMProperty* property)
{
  const vtkSMPropertyHelper values(property);
  std::vector<std::string> names;
  for (unsigned int i = 0; i + 1 < values.GetNumberOfElements(); i += 2)
  {
    if (std::atoi(values.GetAsString(i + 1)) != 0)
    {
      names.push_back(tomlText(values.GetAsString(i)));
    }
  }
  return join(names, "[", "]");
}

bool isSetting(vtkSMProperty* property)
{
  return vtkSMVectorProperty::SafeDownCast(property) &&
    !vtkSMInputProperty::SafeDownCast(property) && property->GetInformationOnly() == 0 &&
    !property->GetIsInternal();
}

bool isEqual(vtkSMProperty* a, vtkSMProperty* b)
{
  const vtkSMPropertyHelper left(a);
  const vtkSMPropertyHelper right(b);
  if (a->FindDomain<vtkSMArraySelectionDomain>())
  {
    return chosenOf(a) == chosenOf(b);
  }
  bool isSame = left.GetNumberOfElements() == right.GetNumberOfElements();
  for (unsigned int i = 0; isSame && i < left.GetNumberOfElements(); ++i)
  {
    isSame = left.GetAsVariant(i) == right.GetAsVariant(i);
  }
  return isSame;
}

vtkPVXMLElement* hintOf(vtkSMPropertyGroup* group, const char* name)
{
  return group->GetHints() ? group->GetHints()->FindNestedElementByName(name) : nullptr;
}

std::string tableOf(vtkSMPropertyGroup* group)
{
  vtkPVXMLElement* const hint = hintOf(group, "TaskTable");
  const char* const label = group->GetXMLLabel();
  return hint ? hint->GetAttribute("name") : keyOf(label ? label : "");
}

// Lists that the panel shows as one table; `row`: what a row is, with its defaults.
void addRows(std::vector<TaskTable>& tables, vtkSMPropertyGroup* group, vtkSMProxy* row)
{
  const std::string name = tableOf(group);
  unsigned int rows = 0;
  for (unsigned int c = 0; c < group->GetNumberOfProperties(); ++c)
  {
    auto* column = vtkSMVectorProperty::SafeDownCast(group->GetProperty(c));
    vtkSMProperty* const kind = row->GetProperty(group->GetFunction(column));
    const unsigned int width = vtkSMPropertyHelper(kind).GetNumberOfElements();
    const unsigned int length = column->GetNumberOfElements() / width;
    if (c == 0)
    {
      rows = length;
      tables.resize(tables.size() + rows, { name, true, {} });
    }
    if (length > rows)
    {
      throw std::runtime_error(std::string(column->GetXMLLabel()) + " has " +
        std::to_string(length) + " values, but " + group->GetProperty(0U)->GetXMLLabel() + " " +
        std::to_string(rows) + ": as many are needed.");
    }
    const std::string usual = valueOf(kind);
    for (unsigned int r = 0; r < length; ++r)
    {
      const std::string value =
        width == 1 ? elementOf(column, r, kind) : listOf(column, r * width, width, kind);
      if (c == 0 || value != usual)
      {
        tables[tables.size() - rows + r].entries.emplace_back(keyOf(kind->GetXMLLabel()), value);
      }
    }
  }
}

}

TaskTable& tableCalled(std::vector<TaskTable>& tables, const std::string& name)
{
  auto found = std::find_if(tables.begin(), tables.end(),
    [&](const TaskTable& table) { return table.name == name && !table.isRow; });
  return found == tables.end() ? tables.emplace_back(TaskTable{ name, false, {} }) : *found;
}

std::string keyOf(const std::string& label)
{
  std::string key;
  for (const char c : label)
  {
    const bool isPart = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (isPart)
    {
      key += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    else if (!key.empty() && key.back() != '_')
    {
      key += '_';
    }
  }
  return key.substr(0, key.find_last_not_of('_') + 1);
}

std::string tomlText(const std::string& text)
{
  std::string result = "\"";
  for (const char c : text)
  {
    if (c == '"' || c == '\\')
    {
      result += '\\';
    }
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f')
    {
      std::array<char, 8> escape{};
      std::snprintf(escape.data(), escape.size(), "\\u%04X", static_cast<unsigned int>(c));
      result += escape.data();
    }
    else
    {
      result += c;
    }
  }
  return result + "\"";
}

std::string tomlNumber(double value)
{
  if (!std::isfinite(value))
  {
    return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
  }
  constexpr int Fewest = 15;
  constexpr int Enough = 17;
  std::array<char, 32> text{};
  for (int digits = Fewest; digits <= Enough; ++digits)
  {
    std::snprintf(text.data(), text.size(), "%.*g", digits, value);
    if (std::strtod(text.data(), nullptr) == value)
    {
      break;
    }
  }
  return text.data();
}

std::string valueOf(vtkSMProperty* property)
{
  auto* const vector = vtkSMVectorProperty::SafeDownCast(property);
  const unsigned int count = vector->GetNumberOfElements();
  const auto width = static_cast<unsigned int>(vector->GetNumberOfElementsPerCommand());
  if (property->FindDomain<vtkSMArraySelectionDomain>())
  {
    return chosenOf(property);
  }
  if (property->GetRepeatable() && width > 1)
  {
    return rowsOf(property, count, width);
  }
  return property->GetRepeatable() || count > 1 ? listOf(property, 0, count, property)
                                                : elementOf(property, 0, property);
}

bool hasDefault(vtkSMProxy* proxy, const char* name)
{
  vtkSMProxy* const usual =
    proxy->GetSessionProxyManager()->GetPrototypeProxy(proxy->GetXMLGroup(), proxy->GetXMLName());
  return isEqual(proxy->GetProperty(name), usual->GetProperty(name));
}

std::string textOf(const std::vector<TaskTable>& tables)
{
  std::string text;
  for (const TaskTable& table : tables)
  {
    if (table.entries.empty())
    {
      continue;
    }
    text += (table.isRow ? "\n[[" : "\n[") + table.name + (table.isRow ? "]]\n" : "]\n");
    for (const auto& [key, value] : table.entries)
    {
      text += key;
      text += " = " + value + "\n";
    }
  }
  return text;
}

std::vector<TaskTable> tablesOf(vtkSMProxy* proxy)
{
  std::vector<TaskTable> tables;
  std::vector<TaskTable> rows;
  std::map<vtkSMProperty*, std::string> groupOf;
  std::set<vtkSMProperty*> inRows;
  for (std::size_t i = 0; i < proxy->GetNumberOfPropertyGroups(); ++i)
  {
    vtkSMPropertyGroup* const group = proxy->GetPropertyGroup(i);
    vtkPVXMLElement* const row = hintOf(group, "PropertyCollectionWidgetPrototype");
    for (unsigned int j = 0; j < group->GetNumberOfProperties(); ++j)
    {
      groupOf[group->GetProperty(j)] = tableOf(group);
      if (row)
      {
        inRows.insert(group->GetProperty(j));
      }
    }
    if (row)
    {
      addRows(rows, group,
        proxy->GetSessionProxyManager()->GetPrototypeProxy(
          row->GetAttribute("group"), row->GetAttribute("name")));
    }
    else
    {
      tableCalled(tables, tableOf(group)); // in the panel's order
    }
  }
  vtkSmartPointer<vtkSMPropertyIterator> properties;
  properties.TakeReference(proxy->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    vtkSMProperty* const property = properties->GetProperty();
    if (isSetting(property) && inRows.count(property) == 0 &&
      !hasDefault(proxy, properties->GetKey()))
    {
      tableCalled(tables, groupOf[property])
        .entries.emplace_back(keyOf(property->GetXMLLabel()), valueOf(property));
    }
  }
  tables.insert(tables.end(), rows.begin(), rows.end());
  return tables;
}

}
