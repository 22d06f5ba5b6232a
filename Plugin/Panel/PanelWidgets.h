// SPDX-License-Identifier: BSD-3-Clause
// Makes the widgets that panels of the plugin name in their XML (panel_widget).
#pragma once

#include "pqPropertyWidgetInterface.h"

#include <QObject>

namespace cartesian
{

class PanelWidgets
  : public QObject
  , public pqPropertyWidgetInterface
{
  Q_OBJECT
  Q_INTERFACES(pqPropertyWidgetInterface)

public:
  using QObject::QObject;

  pqPropertyWidget* createWidgetForProperty(
    vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent) override;
  pqPropertyWidget* createWidgetForPropertyGroup(
    vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent) override;
};

}
