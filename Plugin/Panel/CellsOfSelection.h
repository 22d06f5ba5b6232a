// SPDX-License-Identifier: BSD-3-Clause
// Numbers of cells that are copied from what is selected in the view.
#pragma once

#include "pqPropertyWidget.h"

class QLabel;

namespace cartesian
{

class PanelColumn;

// Of a property that is a list of cells, on the output of its filter or on its input, which have the same cells. Numbers can be
// traced, and saved in states and tasks; ParaView's selections, which it does not register, can not.
class CellsOfSelection : public pqPropertyWidget
{
public:
  CellsOfSelection(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent);

private:
  void copySelection();
  void tell();

  PanelColumn* cells_;
  QLabel* told_;
};

}
