// SPDX-License-Identifier: BSD-3-Clause
// A surface from VTK, in one piece or in blocks, as the kernel takes it.
#pragma once

#include "BoundaryNames.h"
#include "GapsInWords.h"
#include "Mesher/Options.h"
#include "OpenBodies.h"
#include "Surface/Surface.h"

#include "vtkType.h"

#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace cartesian
{

struct SurfaceBlock;

// The array in which vtkSTLReader numbers the named solids of a file.
constexpr const char* StlSolids = "STLSolidLabeling";

// The array in which vtkNamedOBJReader, and outputs of this module, number boundaries.
constexpr const char* BoundaryIdArray = "BoundaryId";

// The cell array of surfaces that know their sharp edges, as CAD systems do: not 0 on lines that are such edges, 0 on other
// lines. On polygons 0, or not 0 if the edges of this one are not known.
constexpr const char* SharpEdgeArray = "SharpEdge";

// Field data of a block that is a solid: its name (string). It has boundaries of its own (BoundaryIdArray).
constexpr const char* SolidNameField = "SolidName";

// The boundary array that means the same as none: what the surface has is found out.
constexpr const char* AutomaticBoundaries = "Automatic";

// Copies the triangles of a vtkPolyData, or of all those in a vtkMultiBlockDataSet, vtkPartitionedDataSet or
// vtkPartitionedDataSetCollection. Polygons with more corners are triangulated; verts, lines, and cells that
// vtkGhostType hides are left out. Cells are numbered continuously over all blocks.
//
// In a block with SharpEdgeArray, sharp edges are known: those between two points that a marked line joins, no others,
// whatever their angle. Points with equal coordinates count as one; lines that are no edges of polygons are ignored.
class SurfaceFromVTK
{
public:
  // `boundaryArray`: cell array that numbers or names the boundaries. Equal strings are one boundary,
  // numbered from 0 in the order in which they first appear. Empty or AutomaticBoundaries: each block is a
  // boundary with the name of the block, without the suffix of a file, unless it is a solid (SolidNameField) with named
  // boundaries of its own, of which those with one name are one over all blocks; without blocks StlSolids or
  // BoundaryIdArray if present, else all 0.
  // Throws Error: EmptySurface, MissingArray, BadParameter.
  //
  // With `regionsFrom` Blocks each block at the top is a region; where it is no blocks itself, StlSolids or
  // BoundaryIdArray in it are its boundaries. With Array, `regionArray` numbers or names the regions, in
  // the order in which they first appear.
  SurfaceFromVTK(vtkDataObject* input, const std::string& boundaryArray,
    RegionSource regionsFrom = RegionSource::One, const std::string& regionArray = "");

  SurfaceView view() const;

  // The cell of the input that each triangle is, or is part of; -1: it closes a gap.
  const std::vector<vtkIdType>& cells() const { return cells_; }

  // Of each triangle, 1: of an open body (OpenBodyArray). Empty: none is.
  const std::vector<std::uint8_t>& openBodies() const { return isOfOpenBody_; }

  // Leaves open bodies out where there is anything else, except for boundaries that are baffles: those are of the region that
  // they lie in, if their block has no solid.
  void leaveOutOpenBodies(const std::set<std::int32_t>& baffles);

  // A message about polygons that could not be triangulated, and open bodies that were left out; empty if there are none.
  std::string describeLeftOut() const;

  // The names of all boundaries that triangles have: from strings, blocks, or the input's field data.
  const BoundaryNames& names() const { return names_; }

  // Adds the sides of a box around the surface as boundaries; equal names are one boundary, and boundaries of the
  // surface with these names are continued there.
  void addSides(const std::array<std::string, 6>& names);
  const EndBoundaries& sides() const { return sides_; }

  // Adds the triangles that close gaps, which are of no cell (-1): each gap is a boundary, gap_1 and so on. Triangles that
  // they cut are replaced; those of panes are sheets.
  void addGaps(ClosedGaps closed);
  const ClosedGaps& gaps() const { return gaps_; }

  // Gives boundaries other names. Those of one name become one, also with one that has the name already.
  void rename(const BoundaryNames& given);

  // Adds the back of a boundary as a boundary, NAME_back, unless it exists. Returns its number.
  std::int32_t addBack(std::int32_t boundary);

  // In order; empty if there is one.
  const std::vector<std::string>& regionNames() const { return regionNames_; }

private:
  void readTriangles(vtkPolyData* block, bool isDivided);
  void readSharpEdges(vtkPolyData* block, std::size_t pointsBefore);
  void readOpenBodies(vtkPolyData* block);
  void findUndivided(vtkPolyData* block);
  void readBoundaries(vtkPolyData* block, const std::string& name);
  void readBoundaryOfBlock(
    const SurfaceBlock& block, std::ptrdiff_t number, RegionSource regionsFrom);
  void readBoundariesByName(vtkPolyData* block, const std::string& name);
  void readRegions(vtkPolyData* block, const std::string& name);
  void addRegion(const std::string& given);
  std::string describeUndivided() const;
  void placeBaffles();
  void addTriangle(
    const std::array<std::uint32_t, 3>& points, std::int32_t boundary, vtkIdType cell);
  void replace(const ClosedGaps& closed);
  void drop(const std::vector<std::uint8_t>& triangles);
  void dropEmptyRegions();
  std::int32_t numberOf(const std::string& given);
  std::int32_t numberOfAdded(const std::string& name);

  vtkIdType cellsBefore_ = 0; // in the blocks before the one being read
  std::vector<double> points_;
  std::vector<std::uint32_t> triangles_;
  std::vector<vtkIdType> cells_;
  std::vector<std::uint32_t> sharpEdges_;  // points, two each
  std::vector<std::uint8_t> knowsEdges_;   // of each triangle; empty: all 0
  std::vector<std::uint8_t> isOfOpenBody_; // of each triangle; empty: all 0
  LeftOutBodies leftOut_;
  std::vector<std::int32_t> boundary_;
  std::vector<vtkIdType> undivided_; // polygons
  BoundaryNames names_;
  EndBoundaries sides_ = NoEnds;
  ClosedGaps gaps_;
  std::vector<std::uint8_t> isSheet_; // of each triangle; empty: all 0
  std::vector<std::int32_t> region_;
  std::vector<std::string> regionNames_;
  std::map<std::string, std::int32_t> numbers_; // of boundaries that are only given by name
};

}
