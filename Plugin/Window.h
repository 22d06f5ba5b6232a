// SPDX-License-Identifier: BSD-3-Clause
// What the user has selected in ParaView's window, and how things are shown there that are not the user's.
#pragma once

class vtkCommand;
class vtkSMProxy;
class vtkSMRenderViewProxy;
class vtkSMSessionProxyManager;
class vtkSMUndoStackBuilder;

namespace cartesian
{

// The source that is selected; null: none.
vtkSMProxy* selectedSource(vtkSMSessionProxyManager* proxies);

// The active view, in scripts too; null: none.
vtkSMProxy* activeView(vtkSMSessionProxyManager* proxies);

// The same, if it is a window's: null in scripts.
vtkSMRenderViewProxy* activeWindow(vtkSMSessionProxyManager* proxies);

// Calls the command (CurrentChangedEvent) when another source or view is selected.
void observeSelections(vtkSMSessionProxyManager* proxies, vtkCommand* command);

// A representation that no list or state has, as those of ParaView's own widgets.
void addHidden(vtkSMProxy* representation, vtkSMRenderViewProxy* view);
void removeHidden(vtkSMProxy* representation, vtkSMRenderViewProxy* view);

// Sets a colour of a proxy to one of the user's palette.
void setPaletteColour(vtkSMProxy* proxy, const char* property, const char* colour);

// While it lives, nothing that changes can be undone.
class WithoutUndo
{
public:
  WithoutUndo();
  ~WithoutUndo();
  WithoutUndo(const WithoutUndo&) = delete;
  WithoutUndo& operator=(const WithoutUndo&) = delete;

private:
  vtkSMUndoStackBuilder* builder_;
  bool before_;
};

}
