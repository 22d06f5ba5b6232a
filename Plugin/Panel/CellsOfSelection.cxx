// SPDX-License-Identifier: BSD-3-Clause
#include "CellsOfSelection.h"

#include "PanelColumn.h"
#include "Window.h"

#include "vtkOutputWindow.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSelectionHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSelectionNode.h"
#include "vtkSmartPointer.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>
#include <set>

namespace cartesian
{

namespace
{

// Numbers come as the process and the cell, or with the part of the data before them.
void addIds(vtkSMProxy* selection, std::set<qlonglong>& cells)
{
  const char* const name = selection->GetProperty("IDs") ? "IDs" : nullptr;
  if (!name)
  {
    return;
  }
  const vtkSMPropertyHelper ids(selection, name);
  const bool isOfParts = selection->GetXMLName() == std::string("CompositeDataIDSelectionSource");
  const unsigned int width = isOfParts ? 3 : 2;
  for (unsigned int i = width - 1; i < ids.GetNumberOfElements(); i += width)
  {
    cells.insert(ids.GetAsIdType(i));
  }
}

// Empty: nothing is selected there.
std::set<qlonglong> selectedCells(vtkSMSourceProxy* source, unsigned int port)
{
  std::set<qlonglong> cells;
  vtkSMSourceProxy* const selections = source->GetSelectionInput(port);
  if (!selections)
  {
    return cells;
  }
  const WithoutUndo withoutUndo;
  bool isChanged = false;
  vtkSmartPointer<vtkSMProxy> byId;
  byId.TakeReference(vtkSMSelectionHelper::ConvertAppendSelections(
    vtkSelectionNode::INDICES, selections, source, static_cast<int>(port), isChanged));
  if (!byId)
  {
    return cells;
  }
  const vtkSMPropertyHelper inputs(byId, "Input");
  for (unsigned int i = 0; i < inputs.GetNumberOfElements(); ++i)
  {
    addIds(inputs.GetAsProxy(i), cells);
  }
  return cells;
}

}

CellsOfSelection::CellsOfSelection(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
  : pqPropertyWidget(proxy, parent)
  , cells_(new PanelColumn(this))
  , told_(new QLabel(this))
{
  this->setShowLabel(false);
  this->setChangeAvailableAsChangeFinished(true);
  auto* const copy = new QPushButton("Copy Active Selection", this);
  copy->setObjectName("Copy");
  auto* const clear = new QPushButton("Clear", this);
  clear->setObjectName("Clear");
  auto* const row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(told_, 1);
  row->addWidget(copy);
  row->addWidget(clear);
  QObject::connect(copy, &QPushButton::clicked, this, &CellsOfSelection::copySelection);
  QObject::connect(clear, &QPushButton::clicked, this, [this] { cells_->setValues({}); });
  QObject::connect(cells_, &PanelColumn::valuesChanged, this, &CellsOfSelection::tell);
  this->addPropertyLink(cells_, "values", SIGNAL(valuesChanged()), property);
  this->tell();
}

void CellsOfSelection::copySelection()
{
  std::set<qlonglong> cells;
  if (auto* const own = vtkSMSourceProxy::SafeDownCast(this->proxy()))
  {
    cells = selectedCells(own, 0);
  }
  const vtkSMPropertyHelper input(this->proxy(), "Input");
  auto* const before = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  if (cells.empty() && before)
  {
    cells = selectedCells(before, input.GetOutputPort());
  }
  if (cells.empty())
  {
    vtkOutputWindowDisplayText("No cell of this surface is selected: select some in the view "
                               "(Select Cells On), then copy.\n");
    return;
  }
  QVariantList values;
  std::transform(cells.begin(), cells.end(), std::back_inserter(values),
    [](qlonglong cell) { return QVariant(cell); });
  cells_->setValues(values);
}

void CellsOfSelection::tell()
{
  const auto count = cells_->values().size();
  told_->setText(
    count == 0 ? QString("No cell") : QString("%1 cell%2").arg(count).arg(count == 1 ? "" : "s"));
}

}
