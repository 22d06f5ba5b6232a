// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryRows.h"

#include "Base/NamePatterns.h"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

namespace cartesian
{

BoundaryRows::BoundaryRows(std::vector<PatchOfSurface> patches, std::vector<ColumnOfRows> columns)
  : patches_(std::move(patches))
  , columns_(std::move(columns))
{
  for (ColumnOfRows& column : columns_)
  {
    while (column.values.size() < this->names().size())
    {
      column.values.append(column.usual);
    }
  }
  this->makeRows();
}

void BoundaryRows::makeRows()
{
  rows_.clear();
  std::set<int> taken;
  for (std::size_t i = 0; i < patches_.size(); ++i)
  {
    const QString name = QString::fromStdString(patches_[i].name);
    rows_.push_back({ name, static_cast<int>(i), static_cast<int>(this->names().indexOf(name)) });
    taken.insert(rows_.back().listed);
  }
  for (int i = 0; i < this->names().size(); ++i)
  {
    if (taken.count(i) == 0)
    {
      rows_.push_back({ this->names()[i].toString(), -1, i });
    }
  }
  rows_.emplace_back();
}

const PatchOfSurface* BoundaryRows::patch(int row) const
{
  const int patch = rows_[static_cast<std::size_t>(row)].patch;
  return patch < 0 ? nullptr : &patches_[static_cast<std::size_t>(patch)];
}

int BoundaryRows::rowCalled(const QString& name) const
{
  const auto found =
    std::find_if(rows_.begin(), rows_.end(), [&](const Row& row) { return row.name == name; });
  return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

QVariant BoundaryRows::own(int row, int column) const
{
  const int listed = rows_[static_cast<std::size_t>(row)].listed;
  return listed < 0 ? QVariant() : columns_[static_cast<std::size_t>(column)].values[listed];
}

int BoundaryRows::patternOf(const Row& row) const
{
  const PatchOfSurface* const patch =
    row.patch < 0 ? nullptr : &patches_[static_cast<std::size_t>(row.patch)];
  for (int i = 0; patch && !patch->isSide() && i < this->names().size(); ++i)
  {
    const std::string pattern = this->names()[i].toString().toStdString();
    if (isPattern(pattern) && isOf(patch->name, pattern))
    {
      return i;
    }
  }
  return -1;
}

QVariant BoundaryRows::applied(int row, int column) const
{
  const Row& asked = rows_[static_cast<std::size_t>(row)];
  const ColumnOfRows& values = columns_[static_cast<std::size_t>(column)];
  const int listed = asked.listed >= 0 ? asked.listed : this->patternOf(asked);
  return listed >= 0 ? values.values[listed] : values.usual;
}

bool BoundaryRows::isOfAny(int row) const
{
  const std::string name = this->name(row).toStdString();
  return std::any_of(patches_.begin(), patches_.end(),
    [&](const PatchOfSurface& patch) { return !patch.isSide() && isOf(patch.name, name); });
}

void BoundaryRows::add(Row& row)
{
  row.listed = static_cast<int>(this->names().size());
  for (ColumnOfRows& column : columns_)
  {
    column.values.append(&column == &columns_.front() ? QVariant(row.name) : column.usual);
  }
}

void BoundaryRows::set(const std::vector<int>& rows, int column, const QVariant& value)
{
  if (column == 0 && this->names().contains(value))
  {
    return; // each name once
  }
  ColumnOfRows& values = columns_[static_cast<std::size_t>(column)];
  for (int i : rows)
  {
    Row& row = rows_[static_cast<std::size_t>(i)];
    if (column == 0 && row.patch < 0)
    {
      row.name = value.toString();
    }
    if (row.listed < 0 && !row.name.isEmpty())
    {
      this->add(row);
    }
    if (row.listed >= 0 && (column > 0 || row.patch < 0))
    {
      values.values[row.listed] = value.isValid() ? value : values.usual;
    }
  }
  std::set<int, std::greater<>> needless;
  for (int i : rows)
  {
    const Row& row = rows_[static_cast<std::size_t>(i)];
    if (row.listed >= 0 && this->isNeedless(row, value.isValid()))
    {
      needless.insert(row.listed);
    }
  }
  for (int listed : needless)
  {
    for (ColumnOfRows& each : columns_)
    {
      each.values.removeAt(listed);
    }
  }
  this->makeRows();
}

QVariantList BoundaryRows::listed(int column) const
{
  const ColumnOfRows& listed = columns_[static_cast<std::size_t>(column)];
  const bool isNeeded = column == 0 ||
    std::any_of(listed.values.begin(), listed.values.end(),
      [&](const QVariant& value) { return value != listed.usual; });
  return isNeeded ? listed.values : QVariantList();
}

bool BoundaryRows::isNeedless(const Row& row, bool isSet) const
{
  return row.patch < 0 ? this->names()[row.listed].toString().isEmpty()
                       : this->isUsual(row.listed) && !(isSet && this->patternOf(row) >= 0);
}

bool BoundaryRows::isUsual(int listed) const
{
  return std::all_of(columns_.begin() + 1, columns_.end(),
    [&](const ColumnOfRows& column) { return column.values[listed] == column.usual; });
}

}
