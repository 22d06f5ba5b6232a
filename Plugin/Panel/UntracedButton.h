// SPDX-License-Identifier: BSD-3-Clause
// A button for a property without values. ParaView 5.11's own fails while a trace is recorded; what this one does is traced, if
// anything is.
#pragma once

#include "pqPropertyWidget.h"

namespace cartesian
{

class UntracedButton : public pqPropertyWidget
{
public:
  UntracedButton(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent);
};

}
