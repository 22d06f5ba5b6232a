// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceInspector
 * @brief shows what is wrong with a surface, and where
 *
 * Input: a surface (vtkPolyData). Output "Defects": lines and triangles (vtkPolyData), the same as
 * port 2 of vtkCartesianMesher with the same Cell Size or meshlines, which say what holes are leaks and
 * what components are small. Step 4 in section 6 of the paper.
 *
 * Cell arrays: DefectKind (int), SurfaceCell and OtherCell (cells of the input that are at fault; -1
 * where there is none). Kinds:
 *
 *  1 open edge: of an odd number of triangles (line)
 *  2 non-manifold edge: of four triangles or more (line)
 *  3 inconsistent edge: what hangs together cannot face one way, as a Moebius band (line)
 *  4 degenerate triangle: without area (line around it)
 *  5 duplicate triangle: its vertices are those of another, whichever way round; left out of the
 *    mesh (triangle)
 *  6 folded triangle: lies back on a neighbour, within a degree (triangle)
 *  7 overlapped triangle: shares an area with another in the same plane (triangle)
 *  8 intersection: two triangles cross (the line that they share)
 *  9 component smaller than a box in all directions (its triangles)
 * 10 hole narrower than a box, closed in the mesh (line around it)
 * 11 leak: a hole as wide as a box or wider, closed by a lid of boundary -1 (line around it)
 * 12 closed contact, of vtkCartesianMesher alone: a wall that became that of another region (triangle)
 * 13 cell left out, of vtkCartesianMesher alone: solvers would refuse it, or the grid cuts it off from the rest (the six
 *    sides of its box; Volume is the cell's)
 *
 * Field data: their numbers OpenEdges, NonManifoldEdges, InconsistentEdges, DegenerateTriangles,
 * DuplicateTriangles, FoldedTriangles, OverlappedTriangles, Intersections, TrianglesOfSmallComponents,
 * Holes, Leaks, TrianglesOfClosedContacts, CellsLeftOut; Components (pieces without a common vertex); TrianglesNotCompared (with more than
 * 512 larger ones nearby; 64 in surfaces of half a million). Of each kind the first million is listed.
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
