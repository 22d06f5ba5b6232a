// SPDX-License-Identifier: BSD-3-Clause
// What OpenFOAM's checkMesh will find in the case written of a mesh (SolverCheck.h).
#pragma once

#include "Processes.h"
#include "Quality/SolverCheck.h"

#include "vtkType.h"

#include <string>

class vtkStringArray;
class vtkUnstructuredGrid;

namespace cartesian
{

struct MeshCheck
{
  std::vector<std::string> regions; // names; one that is empty: the case has one mesh
  std::vector<Findings> ofRegions;  // of each
  std::vector<vtkIdType> failing;   // cells of the grid

  // The worst of the faces that are looked at.
  double skewness = 0;
  double nonOrthogonality = 0; // degrees

  Findings sum() const;
};

// Which cells can fail.
enum class Checked
{
  All,
  AtWalls, // all that are no whole boxes, as in a mesh without layers
};

// Of a grid with any cells; ghosts do not count. Without cells, nothing is found.
MeshCheck checkMesh(vtkUnstructuredGrid* grid, Checked which, Execution& execution);

// Over all processes: of one region.
MeshCheck sum(MeshCheck check, const Processes& processes);

// As field data: each finding's number and, of several regions, that of each (Region<name>).
void setFindings(const MeshCheck& check, vtkUnstructuredGrid* grid);

// Four texts a row: the number of cells, how many of them fail, and the worst measures. The first row has the column titles.
void toVTK(const MeshCheck& check, vtkIdType cells, vtkStringArray* table);

// The failures in words, by region, with places; empty if there are none.
std::string describeFailures(const MeshCheck& check, vtkUnstructuredGrid* grid);

}
