// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceInspector
 * @brief shows what is wrong with a surface, and where
 *
 * Input: a surface (vtkPolyData). Output "Defects": lines and triangles (vtkPolyData), the same as
 * port 2 of vtkCartesianMesher with the same Cell Size or meshlines, which decide which holes are leaks and
 * which components are small. Step 4 in section 6 of the paper.
 *
 * Cell arrays: DefectKind (int), SurfaceCell and OtherCell (the input cells at fault; -1
 * for none). Kinds:
 *
 *  1 open edge: of an odd number of triangles (line)
 *  2 non-manifold edge: of four triangles or more (line)
 *  3 inconsistent edge: connected triangles cannot all face one way, as on a Moebius band (line)
 *  4 degenerate triangle: zero area (line around it)
 *  5 duplicate triangle: same vertices as another, in either orientation; dropped (triangle)
 *  6 folded triangle: folds back onto a neighbour, within a degree (triangle)
 *  7 overlapped triangle: shares an area with another in the same plane (triangle)
 *  8 intersection: two triangles cross (their common line)
 *  9 component smaller than a box in all directions (its triangles)
 * 10 hole narrower than a box, closed in the mesh (line around it)
 * 11 leak: a hole at least as wide as a box, closed by a lid of boundary -1 (line around it)
 * 12 closed contact, only from vtkCartesianMesher: a wall replaced by that of another region (triangle)
 * 13 cell left out, only from vtkCartesianMesher: it fails the quality limits, or the grid cuts it off from the rest
 *    (the six sides of its box; Volume is the cell's)
 * 14 failing cell, only from vtkCartesianMesher: OpenFOAM's checkMesh fails on it (its faces)
 * 15 to 17 wall face without a whole stack of layers, only from vtkCartesianMesher: in a gap; at a corner that leaves no way
 *    inwards; where a cell or face would fail
 * 18 open edge that ran along another and is joined with it (line; Width of the crack)
 * 19 gap, closed by a boundary of its own, only from vtkCartesianMesher (line around it; Width)
 *
 * Field data: the number of each kind, OpenEdges, NonManifoldEdges, InconsistentEdges, DegenerateTriangles,
 * DuplicateTriangles, FoldedTriangles, OverlappedTriangles, Intersections, TrianglesOfSmallComponents,
 * Holes, Leaks, TrianglesOfClosedContacts, CracksJoined, Gaps, CellsLeftOut, FailingCells; Components (pieces without a common vertex);
 * TrianglesNotCompared (triangles with more than 512 larger ones nearby; 64 in surfaces of half a million). At most a
 * million of each kind are listed.
 *
 * Errors: EmptySurface, BadCoordinate, BadCellSize, BadMeshlines, TooManyBoxes.
 *
 * @sa vtkCartesianMesher
 */
#ifndef vtkSurfaceInspector_h
#define vtkSurfaceInspector_h

#include "vtkCartesianGridAlgorithm.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro

class VTKCARTESIANMESHERFILTERS_EXPORT vtkSurfaceInspector : public vtkCartesianGridAlgorithm
{
public:
  static vtkSurfaceInspector* New();
  vtkTypeMacro(vtkSurfaceInspector, vtkCartesianGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSurfaceInspector();
  ~vtkSurfaceInspector() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkSurfaceInspector(const vtkSurfaceInspector&) = delete;
  void operator=(const vtkSurfaceInspector&) = delete;
};

#endif
