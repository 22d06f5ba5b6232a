// SPDX-License-Identifier: BSD-3-Clause
// The rows of the table Boundaries: one for each boundary of the surface, then those of patterns and other names.
#pragma once

#include "BoundaryPatches.h"

#include <QString>
#include <QVariantList>

#include <vector>

namespace cartesian
{

// A column of the filter's lists, of which the first has names: each list is empty or as long as that.
struct ColumnOfRows
{
  QVariant usual; // the value of a new row
  QVariantList values;
};

class BoundaryRows
{
public:
  // Lists that are too short are filled up.
  BoundaryRows(std::vector<PatchOfSurface> patches, std::vector<ColumnOfRows> columns);

  // The last one is empty: it becomes a row when it gets a name.
  int count() const { return static_cast<int>(rows_.size()); }
  int columnCount() const { return static_cast<int>(columns_.size()); }
  QString name(int row) const { return rows_[static_cast<std::size_t>(row)].name; }
  const PatchOfSurface* patch(int row) const; // null: none of the surface
  int rowCalled(const QString& name) const;   // -1: none

  // Of the row itself; invalid: it has none of its own.
  QVariant own(int row, int column) const;
  // As it applies: of the row, of the first pattern for its name, or the usual one.
  QVariant applied(int row, int column) const;
  // Whether a row, which is none of a boundary of the surface, applies to one that is.
  bool isOfAny(int row) const;

  // Sets a value of rows; invalid: the usual one. Then those of the surface with nothing but usual values, unless these
  // were set where a pattern says something else, and others without a name are no longer in the lists.
  void set(const std::vector<int>& rows, int column, const QVariant& value);

  QVariant usual(int column) const { return columns_[static_cast<std::size_t>(column)].usual; }
  // The filter's list; empty if all values are usual.
  QVariantList listed(int column) const;

private:
  struct Row
  {
    QString name;
    int patch = -1;
    int listed = -1; // in the lists
  };

  void makeRows();
  void add(Row& row);
  bool isNeedless(const Row& row, bool isSet) const;
  bool isUsual(int listed) const;
  int patternOf(const Row& row) const; // in the lists; -1: none
  const QVariantList& names() const { return columns_.front().values; }

  std::vector<PatchOfSurface> patches_;
  std::vector<ColumnOfRows> columns_;
  std::vector<Row> rows_;
};

}
