// SPDX-License-Identifier: BSD-3-Clause
// The values in a source's panel, also those that were not applied yet.
#pragma once

#include <functional>
#include <string>

class vtkSMProperty;
class vtkSMProxy;

namespace cartesian
{

// All that can be set, by name.
void forEachProperty(
  vtkSMProxy* proxy, const std::function<void(const char*, vtkSMProperty*)>& action);

// The values in the panel, or those that were applied.
std::string textOf(vtkSMProxy* proxy, bool inPanel);

// Gives the properties that another proxy has too the values in the panel.
void takeFromPanel(vtkSMProxy* source, vtkSMProxy* other);

// Apply sets the values of a source one by one and sends them after the last: what is drawn in between would update it with
// some of them.
class SentValues
{
public:
  void note(vtkSMProxy* source)
  {
    text_ = textOf(source, false);
  } // when they are sent (vtkCommand::UpdateEvent)
  bool areAll(vtkSMProxy* source) const { return textOf(source, false) == text_; }

private:
  std::string text_;
};

}
