// SPDX-License-Identifier: BSD-3-Clause
#include "Mesher/OptionTable.h"

#include "Base/Execution.h"
#include "Mesher/Options.h"
#include "Repair/Regions.h"

namespace cartesian
{

namespace
{

constexpr const char* Length = "units of the surface";
constexpr const char* Degrees = "degrees";

template <class Enum>
NamedOption choice(const char* name, Enum initial, std::vector<const char*> texts)
{
  const Range range{ 0, static_cast<double>(texts.size()) - 1 };
  return { name, static_cast<double>(initial), range, "", std::move(texts) };
}

}

std::vector<NamedOption> optionTable()
{
  const Options d; // defaults
  return {
    choice("Regions From", d.regionsFrom, { "One", "Blocks", "Array" }),
    { "Crack Width", d.cracks.width, CrackSpec::Widths, Length },
    { "Close Gaps", d.closeGaps, Options::GapWidths, Length },
    { "Contact Tolerance", d.contactTolerance, RegionSpec::ContactTolerances, Length },
    choice("Sheets", d.sheets, { "Automatic", "Leave Out", "Keep" }),
    choice("Domain", d.domain.domain, { "Inside", "Outside", "Around Points" }),
    choice("Box From", d.domain.boxFrom, { "Surface", "Bounds" }),
    choice("Flow Direction", d.domain.flow,
      { "Plus X", "Minus X", "Plus Y", "Minus Y", "Plus Z", "Minus Z" }),
    { "Lengths Before", d.domain.before, DomainSpec::Lengths, "" },
    { "Lengths Behind", d.domain.behind, DomainSpec::Lengths, "" },
    { "Lengths Beside", d.domain.beside, DomainSpec::Lengths, "" },
    choice("Ground", d.domain.ground, { "None", "xMin", "xMax", "yMin", "yMax", "zMin", "zMax" }),
    choice("Half", d.domain.half, { "None", "Across X", "Across Y", "Across Z" }),
    choice("Side Names", d.domain.sideNames, { "Axes", "Flow" }),
    { "Boxes Along Body", double(d.domain.boxesAlong), DomainSpec::BoxesAlong, "" },
    { "Cell Size", d.grid.cellSize, GridSpec::CellSizes, Length },
    { "Refinement Depth", double(d.refinement.depth), RefinementSpec::AllDepths, "" },
    { "Transition Layers", double(d.refinement.transitionLayers),
      RefinementSpec::AllTransitionLayers, "" },
    { "Isotropic Levels", double(d.refinement.isotropic), { 0, 1 }, "" },
    choice("Periodic Sides", d.refinement.periodic.to_ulong(),
      { "None", "X", "Y", "X and Y", "Z", "X and Z", "Y and Z", "All" }),
    { "Refined Boundary Depth", double(BoundaryRefinement{}.depth), RefinementSpec::AllDepths, "" },
    { "Region Depth", double(RefinementRegion{}.depth), RefinementSpec::AllDepths, "" },
    { "Curvature Angle", d.refinement.sizing.curvatureAngle, SizingSpec::CurvatureAngles, Degrees },
    { "Feature Depth", double(d.refinement.sizing.featureDepth), RefinementSpec::AllDepths, "" },
    { "Cells Across Gaps", double(d.refinement.sizing.cellsAcrossGaps), SizingSpec::GapCells, "" },
    { "Largest Depth", double(d.refinement.sizing.largestDepth), RefinementSpec::AllDepths, "" },
    { "Cell Budget", d.cellBudget, Options::CellBudgets, "" },
    { "Depth", double(RefinementRegion{}.depth), RefinementSpec::AllDepths, "" },
    choice("Patch Method", d.patches.method, { "Automatic", "Exact Fit", "Marching Cubes" }),
    { "Feature Angle", d.patches.featureAngle, PatchSpec::FeatureAngles, Degrees },
    { "Merge Angle", d.patches.mergeAngle, PatchSpec::MergeAngles, Degrees },
    choice("Tying", d.patches.tying, { "Keep Nodes", "Move Nodes" }),
    { "Collapse Ratio", d.collapse.ratio, ShortEdgeSpec::Ratios, "" },
    choice("Small Cells", d.smallCells.handling, { "Remove", "Merge" }),
    { "Merge Ratio", d.shaping.mergeRatio, CellShapeSpec::MergeRatios, "" },
    { "Small Cell Ratio", d.smallCells.ratio, SmallCellSpec::Ratios, "" },
    { "True Volume", double(d.shaping.trueVolume), { 0, 1 }, "" },
    { "Split Concave Cells", double(d.shaping.splitConcave), { 0, 1 }, "" },
    { "Optimise Nodes", double(d.shaping.optimiseNodes), { 0, 1 }, "" },
    { "Refused Cell Ratio", d.shaping.refusedCellRatio, CellShapeSpec::RefusedCellRatios, "" },
    { "Layers", double(d.layers.count), WallLayerSpec::Counts, "" },
    { "Layer Expansion Ratio", d.layers.ratio, WallLayerSpec::Ratios, "" },
    { "First Layer Thickness", d.layers.firstThickness, WallLayerSpec::Thicknesses, Length },
    { "Target Y Plus", d.layers.flow.targetYPlus, WallFlow::YPlus, "" },
    { "Flow Speed", d.layers.flow.speed, WallFlow::Speeds, "m/s" },
    { "Flow Viscosity", d.layers.flow.viscosity, WallFlow::Viscosities, "m2/s" },
    { "Flow Length", d.layers.flow.length, WallFlow::Lengths, Length },
    { "Last Layer", d.layers.lastByBox, WallLayerSpec::LastLayers, "" },
    { "Refine For Layers", double(d.layers.refine), { 0, 1 }, "" },
    { "Layers Thickness", d.layers.thickness, WallLayerSpec::Thicknesses, Length },
    { "Memory Limit", d.memoryLimit, Options::MemoryLimits, "GiB" },
    { "Number Of Threads", double(Execution::AllCores), { 0 }, "" },
  };
}

}
