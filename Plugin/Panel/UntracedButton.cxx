// SPDX-License-Identifier: BSD-3-Clause
#include "UntracedButton.h"

#include "vtkSMProperty.h"
#include "vtkSMProxy.h"

#include <QPushButton>
#include <QVBoxLayout>

namespace cartesian
{

UntracedButton::UntracedButton(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
  : pqPropertyWidget(proxy, parent)
{
  this->setShowLabel(false);
  auto* const button = new QPushButton(property->GetXMLLabel(), this);
  button->setObjectName("Button");
  auto* const rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addWidget(button);
  const char* const name = proxy->GetPropertyName(property);
  QObject::connect(button, &QPushButton::clicked, [proxy, name] { proxy->InvokeCommand(name); });
}

}
