// SPDX-License-Identifier: BSD-3-Clause
// The table Boundaries of the panel: lists the boundaries of the surface, with what is set for each.
#pragma once

#include "BoundaryPatches.h"
#include "BoundaryRows.h"
#include "ClickInView.h"

#include "pqPropertyGroupWidget.h"
#include "vtkNew.h"

#include <vector>

class QModelIndex;
class QTableWidget;
class QTableWidgetItem;
class vtkCallbackCommand;

namespace cartesian
{

class PanelColumn;

// The group of properties says in its hints what a row is made of, and what lists boundaries (BoundaryPatches):
//
//   <PropertyCollectionWidgetPrototype group="misc" name="CartesianMesherBoundary"/>
//   <Patches group="internal_filters" name="SurfaceBoundaries"/>
//
// Selected rows are lit in the view, and a click there selects a row.
class BoundaryTable : public pqPropertyGroupWidget
{
public:
  BoundaryTable(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent);
  ~BoundaryTable() override;

  void select() override;
  void deselect() override;

private:
  void addColumns();
  void addTable();
  void watchProperties();
  BoundaryRows rowsNow() const;
  void readSurface();
  void fill();
  void fillRow(int row);
  QTableWidgetItem* valueItem(int row, int column) const;
  QTableWidgetItem* nameItem(int row) const;
  void set(const QModelIndex& cell, const QVariant& value);
  void setRows(const std::vector<int>& rows, int column, const QVariant& value);
  void clearSelected();
  std::vector<int> selectedRows() const;
  void lightSelected();
  void selectAt(int x, int y, bool adds);

  BoundaryPatches patches_;
  ClickInView click_;
  std::vector<PatchOfSurface> listed_;
  std::vector<PanelColumn*> columns_;      // of the filter
  std::vector<vtkSMProperty*> prototypes_; // of each
  BoundaryRows rows_;
  QTableWidget* table_ = nullptr;
  vtkNew<vtkCallbackCommand> onChange_;
  bool isSetting_ = false;
};

}
