// SPDX-License-Identifier: BSD-3-Clause
// The surfaces in a data object, with the names of the blocks that they are.
#pragma once

#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace cartesian
{

// Field data of a surface around a region to refine: its depth (one whole number).
constexpr const char* RegionDepthField = "RegionDepth";

struct SurfaceBlock
{
  vtkPolyData* surface;
  std::string name; // empty: there are no blocks, or this one has no name
};

// All that have polygons: a vtkPolyData itself, those in a vtkMultiBlockDataSet or a
// vtkPartitionedDataSetCollection in their order. A nested block without a name has its parent's.
// Throws Error (EmptySurface): none, or a block of another kind.
std::vector<SurfaceBlock> surfaceBlocks(vtkDataObject* input);

}
