// SPDX-License-Identifier: BSD-3-Clause
// Properties that several filters have (vtkCartesianProperties.h) as options of the kernel, and as text.
#pragma once

#include "BoundarySettings.h"
#include "Mesher/Options.h"

#include "vtkIndent.h"

namespace cartesian
{

template <class Filter>
void setPatchOptions(Filter* filter, Options& options)
{
  options.patches.method = static_cast<PatchMethod>(filter->GetPatchMethod());
  options.patches.featureAngle = filter->GetFeatureAngle();
  options.patches.mergeAngle = filter->GetMergeAngle();
  options.patches.tying = static_cast<Tying>(filter->GetTying());
}

template <class Filter>
void setCellOptions(Filter* filter, Options& options)
{
  options.collapse.ratio = filter->GetCollapseRatio();
  options.smallCells.ratio = filter->GetSmallCellRatio();
  options.smallCells.handling = static_cast<SmallCells>(filter->GetSmallCells());
  options.shaping.mergeRatio = filter->GetMergeRatio();
  options.shaping.splitConcave = filter->GetSplitConcaveCells();
  options.shaping.optimiseNodes = filter->GetOptimiseNodes();
  options.shaping.refusedCellRatio = filter->GetRefusedCellRatio();
}

template <class Filter>
void printPatchProperties(Filter* filter, ostream& os, vtkIndent indent)
{
  os << indent << "PatchMethod: " << filter->GetPatchMethod() << "\n";
  os << indent << "FeatureAngle: " << filter->GetFeatureAngle() << "\n";
  os << indent << "MergeAngle: " << filter->GetMergeAngle() << "\n";
  os << indent << "Tying: " << filter->GetTying() << "\n";
}

template <class Filter>
void printCellProperties(Filter* filter, ostream& os, vtkIndent indent)
{
  os << indent << "CollapseRatio: " << filter->GetCollapseRatio() << "\n";
  os << indent << "SmallCells: " << filter->GetSmallCells() << "\n";
  os << indent << "MergeRatio: " << filter->GetMergeRatio() << "\n";
  os << indent << "SmallCellRatio: " << filter->GetSmallCellRatio() << "\n";
  os << indent << "SplitConcaveCells: " << filter->GetSplitConcaveCells() << "\n";
  os << indent << "OptimiseNodes: " << filter->GetOptimiseNodes() << "\n";
  os << indent << "RefusedCellRatio: " << filter->GetRefusedCellRatio() << "\n";
}

}
