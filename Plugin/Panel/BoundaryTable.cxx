// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryTable.h"

#include "BoundaryEditor.h"
#include "PanelColumn.h"
#include "PanelValues.h"
#include "Window.h"

#include "pqView.h"
#include "vtkCallbackCommand.h"
#include "vtkPVXMLElement.h"
#include "vtkSMDoubleVectorProperty.h"
#include "vtkSMIntVectorProperty.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QScrollBar>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <functional>
#include <numeric>

namespace cartesian
{

namespace
{

// Of the table; then those of the filter's properties, without the name.
enum Column
{
  Name,
  Area,
  Triangles,
  FirstValue
};

constexpr int MostRowsSeen = 10;

int propertyAt(int column)
{
  return column == Name ? 0 : column - FirstValue + 1;
}

vtkPVXMLElement* hint(vtkSMPropertyGroup* group, const char* name)
{
  return group->GetHints()->FindNestedElementByName(name);
}

QVariant usualValue(vtkSMProperty* property)
{
  const vtkSMPropertyHelper value(property);
  if (vtkSMIntVectorProperty::SafeDownCast(property))
  {
    return value.GetAsInt();
  }
  if (vtkSMDoubleVectorProperty::SafeDownCast(property))
  {
    return value.GetAsDouble();
  }
  return QString::fromUtf8(value.GetAsString());
}

// Usual numbers stand for none.
QString textOf(const QVariant& value, const QVariant& usual)
{
  return value == usual && value.userType() != QMetaType::QString ? QString() : value.toString();
}

// Rows are selected by their names; what is typed in a selected row is for all that are.
class Cells : public QTableWidget
{
public:
  explicit Cells(std::function<void()> clearSelected)
    : clearSelected_(std::move(clearSelected))
  {
  }

protected:
  QItemSelectionModel::SelectionFlags selectionCommand(
    const QModelIndex& cell, const QEvent* event) const override
  {
    const bool stays = cell.isValid() && cell.column() >= FirstValue &&
      this->selectionModel()->isRowSelected(cell.row(), QModelIndex());
    return stays ? QItemSelectionModel::NoUpdate : QTableWidget::selectionCommand(cell, event);
  }

  void keyPressEvent(QKeyEvent* event) override
  {
    if (event->key() == Qt::Key_Delete)
    {
      clearSelected_();
    }
    else
    {
      QTableWidget::keyPressEvent(event);
    }
  }

private:
  std::function<void()> clearSelected_;
};

}

BoundaryTable::BoundaryTable(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent)
  : pqPropertyGroupWidget(proxy, group, parent)
  , patches_(proxy, hint(group, "Patches"))
  , click_([this](int x, int y, bool adds) { this->selectAt(x, y, adds); })
  , rows_({}, { {} })
{
  this->addColumns();
  this->addTable();
  this->watchProperties();
  connect(this, &pqPropertyWidget::viewChanged, this, [this] {
    if (this->isSelected())
    {
      click_.watch(activeWindow(this->proxy()->GetSessionProxyManager()));
    }
  });
  this->readSurface();
}

BoundaryTable::~BoundaryTable()
{
  onChange_->SetClientData(nullptr);
}

void BoundaryTable::addColumns()
{
  vtkPVXMLElement* const row = hint(this->propertyGroup(), "PropertyCollectionWidgetPrototype");
  vtkSMProxy* const prototype = this->proxy()->GetSessionProxyManager()->GetPrototypeProxy(
    row->GetAttribute("group"), row->GetAttribute("name"));
  for (unsigned int i = 0; i < this->propertyGroup()->GetNumberOfProperties(); ++i)
  {
    vtkSMProperty* const property = this->propertyGroup()->GetProperty(i);
    prototypes_.push_back(prototype->GetProperty(this->propertyGroup()->GetFunction(property)));
    columns_.push_back(new PanelColumn(this));
    this->addPropertyLink(columns_.back(), "values", SIGNAL(valuesChanged()), property);
    connect(columns_.back(), &PanelColumn::valuesChanged, this, [this] {
      if (!isSetting_)
      {
        this->fill();
      }
    });
  }
}

void BoundaryTable::addTable()
{
  table_ = new Cells([this] { this->clearSelected(); });
  table_->setObjectName("Table");
  table_->setToolTip("Selected rows are lit in the view, where a click selects a row. What you "
                     "enter in one is for all "
                     "that are selected.");
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::SelectedClicked |
    QAbstractItemView::EditKeyPressed | QAbstractItemView::AnyKeyPressed);
  table_->setColumnCount(FirstValue + static_cast<int>(columns_.size()) - 1);
  table_->verticalHeader()->hide();
  QStringList titles{ "Boundary", "Area", "Triangles" };
  std::vector<vtkSMProperty*> edited{ prototypes_.front(), nullptr, nullptr };
  for (std::size_t i = 1; i < prototypes_.size(); ++i)
  {
    titles.append(QString(prototypes_[i]->GetXMLLabel()).replace(' ', '\n'));
    edited.push_back(prototypes_[i]);
  }
  table_->setHorizontalHeaderLabels(titles);
  for (int i = 0; i < table_->columnCount(); ++i)
  {
    if (vtkSMProperty* const property = edited[static_cast<std::size_t>(i)])
    {
      table_->horizontalHeaderItem(i)->setToolTip(getTooltip(property));
    }
  }
  // What is set most stands beside the names, as far as the panel is wide.
  int place = 1;
  for (const char* const title : { "Type", "Depth", "Layers\nThickness" })
  {
    if (titles.contains(title))
    {
      table_->horizontalHeader()->moveSection(
        table_->horizontalHeader()->visualIndex(static_cast<int>(titles.indexOf(title))), place++);
    }
  }
  table_->setItemDelegate(new BoundaryEditor(
    edited, [this](const QModelIndex& cell, const QVariant& value) { this->set(cell, value); },
    table_));
  connect(table_, &QTableWidget::itemSelectionChanged, this, [this] { this->lightSelected(); });
  auto* const layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(table_);
}

// Those that tell boundaries apart.
void BoundaryTable::watchProperties()
{
  onChange_->SetClientData(this);
  onChange_->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
    if (self)
    {
      static_cast<BoundaryTable*>(self)->readSurface();
    }
  });
  forEachProperty(this->proxy(), [this](const char* name, vtkSMProperty* property) {
    if (patches_.dependOn(name))
    {
      property->AddObserver(vtkCommand::UncheckedPropertyModifiedEvent, onChange_);
    }
  });
}

void BoundaryTable::select()
{
  pqPropertyGroupWidget::select();
  this->readSurface();
  click_.watch(activeWindow(this->proxy()->GetSessionProxyManager()));
}

void BoundaryTable::deselect()
{
  pqPropertyGroupWidget::deselect();
  click_.watch(nullptr);
  table_->clearSelection();
}

void BoundaryTable::readSurface()
{
  listed_ = patches_.list();
  this->fill();
}

BoundaryRows BoundaryTable::rowsNow() const
{
  std::vector<ColumnOfRows> columns;
  for (std::size_t i = 0; i < columns_.size(); ++i)
  {
    columns.push_back({ usualValue(prototypes_[i]), columns_[i]->values() });
  }
  return { listed_, columns };
}

void BoundaryTable::fill()
{
  if (!table_)
  {
    return; // columns get their first values
  }
  rows_ = this->rowsNow();
  table_->setRowCount(rows_.count());
  for (int row = 0; row < rows_.count(); ++row)
  {
    this->fillRow(row);
  }
  table_->resizeColumnsToContents();
  table_->resizeRowsToContents();
  int height = table_->horizontalHeader()->sizeHint().height() + 2 * table_->frameWidth() +
    table_->horizontalScrollBar()->sizeHint().height();
  for (int row = 0; row < std::min(rows_.count(), MostRowsSeen); ++row)
  {
    height += table_->rowHeight(row);
  }
  table_->setFixedHeight(height);
}

void BoundaryTable::fillRow(int row)
{
  table_->setItem(row, Name, this->nameItem(row));
  const PatchOfSurface* const patch = rows_.patch(row);
  for (int column : { Area, Triangles })
  {
    auto* const item = new QTableWidgetItem(
      patch ? QString::fromStdString(column == Area ? patch->area : patch->triangles) : QString());
    item->setFlags(item->flags() & ~Qt::ItemIsEditable);
    item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    table_->setItem(row, column, item);
  }
  for (int column = FirstValue; column < table_->columnCount(); ++column)
  {
    table_->setItem(row, column, this->valueItem(row, propertyAt(column)));
  }
}

QTableWidgetItem* BoundaryTable::nameItem(int row) const
{
  auto* const item = new QTableWidgetItem(rows_.name(row));
  if (rows_.patch(row))
  {
    item->setFlags(item->flags() & ~Qt::ItemIsEditable);
  }
  else if (row == rows_.count() - 1)
  {
    item->setToolTip("For a pattern: * is any text, ? any character");
  }
  else if (!rows_.isOfAny(row))
  {
    item->setForeground(Qt::red);
    item->setToolTip("No boundary of the surface is called so");
  }
  return item;
}

// Grey: not of the row itself.
QTableWidgetItem* BoundaryTable::valueItem(int row, int column) const
{
  const QVariant usual = rows_.usual(column);
  auto* const item = new QTableWidgetItem(
    rows_.name(row).isEmpty() ? QString() : textOf(rows_.applied(row, column), usual));
  const QVariant own = rows_.own(row, column);
  if (!own.isValid() || own == usual)
  {
    item->setForeground(table_->palette().brush(QPalette::Disabled, QPalette::Text));
  }
  if (rows_.name(row).isEmpty())
  {
    item->setFlags(item->flags() & ~Qt::ItemIsEditable);
  }
  return item;
}

std::vector<int> BoundaryTable::selectedRows() const
{
  std::vector<int> rows;
  for (const QModelIndex& row : table_->selectionModel()->selectedRows())
  {
    rows.push_back(row.row());
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

void BoundaryTable::set(const QModelIndex& cell, const QVariant& value)
{
  std::vector<int> rows{ cell.row() };
  if (cell.column() != Name && table_->selectionModel()->isRowSelected(cell.row(), QModelIndex()))
  {
    rows = this->selectedRows();
  }
  if (rows.size() > 1 || value.toString() != cell.data(Qt::EditRole).toString())
  {
    this->setRows(rows, propertyAt(cell.column()), value);
  }
}

void BoundaryTable::setRows(const std::vector<int>& rows, int column, const QVariant& value)
{
  rows_.set(rows, column, value);
  // A preview follows each list: names without values are a table too, values without names are none.
  std::vector<std::size_t> order(columns_.size());
  std::iota(order.begin(), order.end(), 0);
  if (rows_.listed(0).size() < columns_.front()->values().size())
  {
    std::reverse(order.begin(), order.end());
  }
  isSetting_ = true;
  for (std::size_t i : order)
  {
    columns_[i]->setValues(rows_.listed(static_cast<int>(i)));
  }
  isSetting_ = false;
  this->fill();
}

// Patterns go, boundaries get usual values.
void BoundaryTable::clearSelected()
{
  const std::vector<int> rows = this->selectedRows();
  for (int column = rows_.columnCount() - 1; column >= 0; --column)
  {
    this->setRows(rows, column, QVariant());
  }
}

void BoundaryTable::lightSelected()
{
  std::vector<std::string> names;
  for (int row : this->selectedRows())
  {
    if (!rows_.name(row).isEmpty())
    {
      names.push_back(rows_.name(row).toStdString());
    }
  }
  patches_.light(names, activeWindow(this->proxy()->GetSessionProxyManager()));
}

void BoundaryTable::selectAt(int x, int y, bool adds)
{
  vtkSMRenderViewProxy* const view = activeWindow(this->proxy()->GetSessionProxyManager());
  const QString name = view ? QString::fromStdString(patches_.at(view, x, y)) : QString();
  const int row = name.isEmpty() ? -1 : rows_.rowCalled(name);
  if (row >= 0)
  {
    table_->selectionModel()->select(table_->model()->index(row, Name),
      QItemSelectionModel::Rows |
        (adds ? QItemSelectionModel::Select : QItemSelectionModel::ClearAndSelect));
    table_->scrollToItem(table_->item(row, Name));
  }
  else if (!adds)
  {
    table_->clearSelection();
  }
}

}
