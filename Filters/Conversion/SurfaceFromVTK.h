// SPDX-License-Identifier: BSD-3-Clause
// A surface of VTK's, in one piece or in blocks, as the kernel wants it.
#pragma once

#include "BoundaryNames.h"
#include "Surface/Surface.h"

#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace cartesian
{

// Name that vtkSTLReader gives the array of the solids a file names.
constexpr const char* StlSolids = "STLSolidLabeling";

// Triangles copied out of a vtkPolyData, or out of all those in a vtkMultiBlockDataSet or
// vtkPartitionedDataSetCollection: polygons with more corners are triangulated, verts and lines left
// out. Cells are counted on from block to block.
class SurfaceFromVTK
{
public:
  // `boundaryArray`: cell array that numbers the boundaries, or names them: equal strings are one
  // boundary, numbered from 0 as they first appear. Empty: each block is a boundary, called as the
  // block is; without blocks StlSolids if there, else all 0.
  // Throws Error: EmptySurface, MissingArray, BadParameter.
  SurfaceFromVTK(vtkDataObject* input, const std::string& boundaryArray);

  SurfaceView view() const;

  // The input's cell that each triangle is, or is a part of.
  const std::vector<vtkIdType>& cells() const { return cells_; }

  // Of all boundaries that triangles have: strings, blocks, or what the input's field data says.
  const BoundaryNames& names() const { return names_; }

private:
  void readTriangles(vtkPolyData* block);
  void readBoundaries(vtkPolyData* block, const std::string& boundaryArray);
  std::int32_t numberOf(const std::string& name);

  vtkIdType cellsBefore_ = 0; // in the blocks before the one being read
  std::vector<double> points_;
  std::vector<std::uint32_t> triangles_;
  std::vector<vtkIdType> cells_;
  std::vector<std::int32_t> boundary_;
  BoundaryNames names_;
  std::map<std::string, std::int32_t> numbers_; // of boundaries that have names only
};

}
