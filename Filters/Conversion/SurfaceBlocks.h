// SPDX-License-Identifier: BSD-3-Clause
// The surfaces in a data object, with the names of their blocks.
#pragma once

#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace cartesian
{

// Field data of a surface that bounds a region to refine: its depth (one whole number).
constexpr const char* RegionDepthField = "RegionDepth";

struct SurfaceBlock
{
  vtkPolyData* surface;
  std::string name; // empty if there are no blocks, or this one has no name
  std::size_t top;  // the block at the top, of which this is a part, by number
  std::string topName;
};

// All surfaces with polygons: a vtkPolyData itself, or those in a vtkMultiBlockDataSet, vtkPartitionedDataSet
// or vtkPartitionedDataSetCollection, in order. A nested block without a name has the name of its parent.
// Throws Error (EmptySurface) if there is none, or a block is of another kind.
std::vector<SurfaceBlock> surfaceBlocks(vtkDataObject* input);

}
