// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryEditor.h"

#include "vtkSMDoubleVectorProperty.h"
#include "vtkSMIntVectorProperty.h"
#include "vtkSMProperty.h"
#include "vtkSMStringListDomain.h"

#include <QComboBox>
#include <QDoubleValidator>
#include <QIntValidator>
#include <QLineEdit>
#include <QSignalBlocker>

#include <utility>

namespace cartesian
{

namespace
{

QComboBox* choice(vtkSMStringListDomain* texts, QWidget* parent)
{
  auto* const box = new QComboBox(parent);
  for (unsigned int i = 0; i < texts->GetNumberOfStrings(); ++i)
  {
    box->addItem(texts->GetString(i));
  }
  return box;
}

QWidget* line(vtkSMProperty* property, QWidget* parent)
{
  auto* const edit = new QLineEdit(parent);
  edit->setFrame(false);
  if (vtkSMIntVectorProperty::SafeDownCast(property))
  {
    edit->setValidator(new QIntValidator(edit));
  }
  else if (vtkSMDoubleVectorProperty::SafeDownCast(property))
  {
    auto* const numbers = new QDoubleValidator(edit);
    numbers->setLocale(QLocale::c());
    edit->setValidator(numbers);
  }
  return edit;
}

}

BoundaryEditor::BoundaryEditor(std::vector<vtkSMProperty*> columns, Action set, QObject* parent)
  : QStyledItemDelegate(parent)
  , columns_(std::move(columns))
  , set_(std::move(set))
{
}

QWidget* BoundaryEditor::createEditor(
  QWidget* parent, const QStyleOptionViewItem& /*option*/, const QModelIndex& cell) const
{
  vtkSMProperty* const property = columns_[static_cast<std::size_t>(cell.column())];
  auto* const texts = property ? property->FindDomain<vtkSMStringListDomain>() : nullptr;
  if (!texts)
  {
    return line(property, parent);
  }
  QComboBox* const box = choice(texts, parent);
  auto* const self = const_cast<BoundaryEditor*>(this); // Qt's signals are not const
  connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), self, [self, box] {
    Q_EMIT self->commitData(box);
    Q_EMIT self->closeEditor(box);
  });
  return box;
}

void BoundaryEditor::setEditorData(QWidget* editor, const QModelIndex& cell) const
{
  const QString text = cell.data(Qt::EditRole).toString();
  if (auto* const box = qobject_cast<QComboBox*>(editor))
  {
    const QSignalBlocker notChosen(box);
    box->setCurrentText(text);
  }
  else if (auto* const edit = qobject_cast<QLineEdit*>(editor))
  {
    edit->setText(text);
  }
}

void BoundaryEditor::setModelData(
  QWidget* editor, QAbstractItemModel* /*model*/, const QModelIndex& cell) const
{
  vtkSMProperty* const property = columns_[static_cast<std::size_t>(cell.column())];
  auto* const box = qobject_cast<QComboBox*>(editor);
  const QString text =
    box ? box->currentText() : qobject_cast<QLineEdit*>(editor)->text().trimmed();
  QVariant value;
  if (!text.isEmpty())
  {
    value = text;
    if (vtkSMIntVectorProperty::SafeDownCast(property))
    {
      value = text.toInt();
    }
    else if (vtkSMDoubleVectorProperty::SafeDownCast(property))
    {
      value = QLocale::c().toDouble(text);
    }
  }
  set_(cell, value);
}

}
