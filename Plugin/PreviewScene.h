// SPDX-License-Identifier: BSD-3-Clause
// What shows a preview of a mesh in a view.
#pragma once

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <string>
#include <vector>

class vtkSMProxy;
class vtkSMRenderViewProxy;
class vtkSMSourceProxy;

namespace cartesian
{

// Its proxies are registered nowhere: ParaView's own widgets are in views in the same way.
class PreviewScene
{
public:
  // `preview`: with the outputs of vtkMeshPreview. What the view shows of `source` and of its input is hidden until the
  // end while a surface with boxes of several sizes is in its place; their properties stay.
  PreviewScene(vtkSMSourceProxy* preview, vtkSMProxy* source, vtkSMRenderViewProxy* view);
  ~PreviewScene(); // leaves the view to be drawn

  PreviewScene(const PreviewScene&) = delete;
  PreviewScene& operator=(const PreviewScene&) = delete;

  vtkSMRenderViewProxy* view() const;
  vtkSMSourceProxy* preview() const { return preview_; }

  // After the preview has changed.
  void draw();

private:
  vtkSMProxy* add(const char* name, int port);
  void addSurface();
  void addDomain();
  void addLabels();
  void addZones();
  void addLegend();
  void showOthers(bool shown);
  void nameSizes();
  bool has(int output) const;
  bool hasSeveralDepths() const;

  vtkSmartPointer<vtkSMSourceProxy> preview_;
  vtkWeakPointer<vtkSMProxy> source_;
  vtkWeakPointer<vtkSMRenderViewProxy> view_;
  vtkSmartPointer<vtkSMProxy> colours_; // of depths
  vtkSmartPointer<vtkSMProxy> legend_;
  vtkSmartPointer<vtkSMProxy> surface_;
  std::vector<vtkSmartPointer<vtkSMProxy>> representations_;
  bool hadDomain_ = false;
};

}
