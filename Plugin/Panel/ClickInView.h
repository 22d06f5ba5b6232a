// SPDX-License-Identifier: BSD-3-Clause
// Clicks in a view: those that do not move the camera.
#pragma once

#include "vtkNew.h"
#include "vtkWeakPointer.h"

#include <array>
#include <functional>

class vtkCallbackCommand;
class vtkRenderWindowInteractor;
class vtkSMRenderViewProxy;

namespace cartesian
{

class ClickInView
{
public:
  // In pixels from the lower left corner; `adds`: with the control or shift key.
  using Action = std::function<void(int x, int y, bool adds)>;

  explicit ClickInView(Action action);
  ~ClickInView();
  ClickInView(const ClickInView&) = delete;
  ClickInView& operator=(const ClickInView&) = delete;

  // Null: nowhere.
  void watch(vtkSMRenderViewProxy* view);

private:
  void handle(unsigned long event);

  Action action_;
  vtkNew<vtkCallbackCommand> command_;
  vtkWeakPointer<vtkRenderWindowInteractor> interactor_;
  std::array<int, 2> pressedAt_{};
};

}
