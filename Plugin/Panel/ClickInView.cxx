// SPDX-License-Identifier: BSD-3-Clause
#include "ClickInView.h"

#include "vtkCallbackCommand.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSMRenderViewProxy.h"

#include <cstdlib>
#include <utility>

namespace cartesian
{

namespace
{

constexpr int MostPixels = 2; // that a hand moves in a click
constexpr float BeforeCamera = 1;

}

ClickInView::ClickInView(Action action)
  : action_(std::move(action))
{
  command_->SetClientData(this);
  command_->SetCallback([](vtkObject*, unsigned long event, void* self, void*) {
    static_cast<ClickInView*>(self)->handle(event);
  });
}

ClickInView::~ClickInView()
{
  this->watch(nullptr);
}

void ClickInView::watch(vtkSMRenderViewProxy* view)
{
  vtkRenderWindowInteractor* const interactor = view ? view->GetInteractor() : nullptr;
  if (interactor == interactor_)
  {
    return;
  }
  if (interactor_)
  {
    interactor_->RemoveObserver(command_);
  }
  interactor_ = interactor;
  if (interactor)
  {
    interactor->AddObserver(vtkCommand::LeftButtonPressEvent, command_, BeforeCamera);
    interactor->AddObserver(vtkCommand::LeftButtonReleaseEvent, command_, BeforeCamera);
  }
}

void ClickInView::handle(unsigned long event)
{
  const int* const at = interactor_->GetEventPosition();
  if (event == vtkCommand::LeftButtonPressEvent)
  {
    pressedAt_ = { at[0], at[1] };
  }
  else if (std::abs(at[0] - pressedAt_[0]) <= MostPixels &&
    std::abs(at[1] - pressedAt_[1]) <= MostPixels)
  {
    action_(at[0], at[1], interactor_->GetControlKey() != 0 || interactor_->GetShiftKey() != 0);
  }
}

}
