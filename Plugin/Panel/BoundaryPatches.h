// SPDX-License-Identifier: BSD-3-Clause
// The boundaries of the surface that a filter in the panel gets: listed, lit in a view, and found there.
#pragma once

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <string>
#include <vector>

class vtkPVXMLElement;
class vtkSMProxy;
class vtkSMRenderViewProxy;
class vtkSMSourceProxy;

namespace cartesian
{

struct PatchOfSurface
{
  std::string name;
  std::string area;
  std::string triangles;

  // Of the box around the surface; no pattern is of its name.
  bool isSide() const { return triangles.empty(); }
};

class BoundaryPatches
{
public:
  // `hint`: names the proxy of vtkSurfaceBoundaries, which gets those values in the panel that it has properties for.
  BoundaryPatches(vtkSMProxy* source, vtkPVXMLElement* hint);
  ~BoundaryPatches(); // leaves the view to be drawn
  BoundaryPatches(const BoundaryPatches&) = delete;
  BoundaryPatches& operator=(const BoundaryPatches&) = delete;

  bool dependOn(const char* property) const;

  // With the values in the panel.
  std::vector<PatchOfSurface> list();

  // Those of these names and patterns, in the view's colour of selections; none, or without a view: none is.
  void light(const std::vector<std::string>& names, vtkSMRenderViewProxy* view);

  // The name of the patch at a place of the view, in pixels; empty: there is none.
  std::string at(vtkSMRenderViewProxy* view, int x, int y);

private:
  void show(vtkSMRenderViewProxy* view);
  void hide();

  vtkWeakPointer<vtkSMProxy> source_;
  vtkSmartPointer<vtkSMSourceProxy> patches_;
  vtkSmartPointer<vtkSMProxy> representation_; // null: none is lit
  vtkWeakPointer<vtkSMRenderViewProxy> view_;
};

}
