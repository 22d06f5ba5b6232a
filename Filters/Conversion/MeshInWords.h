// SPDX-License-Identifier: BSD-3-Clause
// A mesh in words: whether solvers accept it, its sizes and worst values, its boundaries and what was done to it.
#pragma once

#include "MeshCheck.h"
#include "Quality/QualityMeasures.h"

#include <string>
#include <vector>

namespace cartesian
{

struct WorstValue
{
  double nearness; // to the limit
  std::string measure;
  std::string value;
  std::string limit; // empty: none
  std::string place;
  double failing; // cells
};

// Texts are lines, each with its end.
struct MeshInWords
{
  std::string verdict; // the first line: whether OpenFOAM accepts all cells
  std::string size;
  std::string regions;
  std::string boundaries;              // the largest
  std::string done;                    // to surface and cells
  std::vector<WorstValue> worstValues; // the nearest to its limit first

  // The first of the worst values.
  std::string worst(std::size_t most) const;
};

// `mesh`: with the arrays of vtkFiniteVolumeQuality. All processes must call this, each with its part; the words are of all.
MeshInWords inWords(vtkUnstructuredGrid* mesh, const MeshCheck& check);

// Of the cells of this process, the worst first; ghosts, cells without a value and, for what does them no harm, those of layers
// do not count.
std::vector<vtkIdType> rankedCells(vtkUnstructuredGrid* mesh, Measure measure);

}
