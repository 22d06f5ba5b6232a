// SPDX-License-Identifier: BSD-3-Clause
// Properties that several filters have (vtkCartesianProperties.h) as options of the kernel, and as text.
#pragma once

#include "BoundarySettings.h"
#include "Mesher/Options.h"

#include "vtkIndent.h"

namespace cartesian
{

template <class Filter>
void setDomainOptions(Filter* filter, Options& options)
{
  DomainSpec& domain = options.domain;
  domain.domain = static_cast<Domain>(filter->GetDomain());
  domain.boxFrom = static_cast<BoxSource>(filter->GetBoxFrom());
  domain.flow = static_cast<FlowDirection>(filter->GetFlowDirection());
  domain.before = filter->GetLengthsBefore();
  domain.behind = filter->GetLengthsBehind();
  domain.beside = filter->GetLengthsBeside();
  domain.ground = static_cast<DomainSide>(filter->GetGround());
  domain.half = static_cast<Half>(filter->GetHalf());
  domain.sideNames = static_cast<SideNames>(filter->GetSideNames());
  domain.boxesAlong = filter->GetBoxesAlongBody();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    domain.bounds.low[axis] = filter->GetDomainBounds()[2 * axis];
    domain.bounds.high[axis] = filter->GetDomainBounds()[2 * axis + 1];
  }
  domain.keepPoints = filter->GetKeepPoints();
  domain.keepOut = filter->GetKeepOut();
}

template <class Filter>
void printDomainProperties(Filter* filter, ostream& os, vtkIndent indent)
{
  os << indent << "Domain: " << filter->GetDomain() << "\n";
  os << indent << "BoxFrom: " << filter->GetBoxFrom() << "\n";
  os << indent << "DomainBounds:";
  for (int i = 0; i < 6; ++i)
  {
    os << " " << filter->GetDomainBounds()[i];
  }
  os << "\n";
  for (const auto& [name, points] : { std::pair("KeepPoints:", &filter->GetKeepPoints()),
         std::pair("KeepOut:", &filter->GetKeepOut()) })
  {
    os << indent << name;
    for (const auto& point : *points)
    {
      os << " (" << point[0] << " " << point[1] << " " << point[2] << ")";
    }
    os << "\n";
  }
  os << indent << "FlowDirection: " << filter->GetFlowDirection() << "\n";
  os << indent << "LengthsBefore: " << filter->GetLengthsBefore() << "\n";
  os << indent << "LengthsBehind: " << filter->GetLengthsBehind() << "\n";
  os << indent << "LengthsBeside: " << filter->GetLengthsBeside() << "\n";
  os << indent << "Ground: " << filter->GetGround() << "\n";
  os << indent << "Half: " << filter->GetHalf() << "\n";
  os << indent << "SideNames: " << filter->GetSideNames() << "\n";
  os << indent << "BoxesAlongBody: " << filter->GetBoxesAlongBody() << "\n";
}

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
  options.shaping.trueVolume = filter->GetTrueVolume();
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
  os << indent << "TrueVolume: " << filter->GetTrueVolume() << "\n";
  os << indent << "SplitConcaveCells: " << filter->GetSplitConcaveCells() << "\n";
  os << indent << "OptimiseNodes: " << filter->GetOptimiseNodes() << "\n";
  os << indent << "RefusedCellRatio: " << filter->GetRefusedCellRatio() << "\n";
}

template <class Filter>
void printLayerProperties(Filter* filter, ostream& os, vtkIndent indent)
{
  os << indent << "Layers: " << filter->GetLayers() << "\n";
  os << indent << "LayerExpansionRatio: " << filter->GetLayerExpansionRatio() << "\n";
  os << indent << "FirstLayerThickness: " << filter->GetFirstLayerThickness() << "\n";
  os << indent << "TargetYPlus: " << filter->GetTargetYPlus() << "\n";
  os << indent << "LengthUnit: " << filter->GetLengthUnit() << "\n";
  os << indent << "FlowSpeed: " << filter->GetFlowSpeed() << "\n";
  os << indent << "FlowViscosity: " << filter->GetFlowViscosity() << "\n";
  os << indent << "FlowLength: " << filter->GetFlowLength() << "\n";
  os << indent << "LastLayer: " << filter->GetLastLayer() << "\n";
  os << indent << "RefineForLayers: " << filter->GetRefineForLayers() << "\n";
  os << indent << "LayersThickness: " << filter->GetLayersThickness() << "\n";
}

}
