// SPDX-License-Identifier: BSD-3-Clause
// The values of cells that histograms are of: the measures of vtkFiniteVolumeQuality, the share of its box that a cell
// fills, and the height of first layers.
#pragma once

#include "Quality/QualityMeasures.h"

#include <optional>
#include <string>
#include <vector>

class vtkPolyData;
class vtkUnstructuredGrid;

namespace cartesian
{

// After the measures, in the order of Measure.
enum MeshValue : std::size_t
{
  VolumeFraction = MeasureCount, // the array of this name
  FirstLayerHeight,              // volume by wall area of cells of Layer 1
  MeshValueCount
};

struct MeshValues
{
  std::string name;  // as in the panel
  std::string limit; // in words, or empty
  double limitAt = 0;
  std::vector<double>
    values; // of each cell that is no ghost (of first layers only, for their height)
};

// `mesh` and `faces`: those of vtkFiniteVolumeQuality, with its standard limits. None: the mesh lacks the array.
std::optional<MeshValues> valuesOf(
  vtkUnstructuredGrid* mesh, vtkPolyData* faces, std::size_t which);

}
