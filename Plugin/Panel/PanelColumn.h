// SPDX-License-Identifier: BSD-3-Clause
// The values of a property that is a column of a table, for pqPropertyLinks.
#pragma once

#include <QObject>
#include <QVariantList>

namespace cartesian
{

class PanelColumn : public QObject
{
  Q_OBJECT
  Q_PROPERTY(QVariantList values READ values WRITE setValues NOTIFY valuesChanged)

public:
  using QObject::QObject;

  const QVariantList& values() const { return values_; }
  void setValues(const QVariantList& values)
  {
    if (values_ != values)
    {
      values_ = values;
      Q_EMIT this->valuesChanged();
    }
  }

Q_SIGNALS:
  void valuesChanged();

private:
  QVariantList values_;
};

}
