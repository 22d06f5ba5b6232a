// SPDX-License-Identifier: BSD-3-Clause
// How values of the table Boundaries are typed and chosen.
#pragma once

#include <QStyledItemDelegate>
#include <QVariant>

#include <functional>
#include <vector>

class vtkSMProperty;

namespace cartesian
{

class BoundaryEditor : public QStyledItemDelegate
{
public:
  using Action = std::function<void(const QModelIndex& cell, const QVariant& value)>;

  // `columns`: the property of a row that a column has; null: it cannot be edited. `set`: gets what was typed or chosen;
  // invalid: the usual value.
  BoundaryEditor(std::vector<vtkSMProperty*> columns, Action set, QObject* parent);

  QWidget* createEditor(
    QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& cell) const override;
  void setEditorData(QWidget* editor, const QModelIndex& cell) const override;
  void setModelData(
    QWidget* editor, QAbstractItemModel* model, const QModelIndex& cell) const override;

private:
  std::vector<vtkSMProperty*> columns_;
  Action set_;
};

}
