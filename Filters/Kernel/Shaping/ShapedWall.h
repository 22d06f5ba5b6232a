// SPDX-License-Identifier: BSD-3-Clause
// Data shared by the slabs of one stage of shaping (CellShaping.h), and measures of all cells before any change: most
// never do, and are measured once.
#pragma once

#include "Parts/Slabs.h"
#include "Shaping/CellView.h"

#include <unordered_map>

namespace cartesian
{

enum class IsAtFault : std::uint8_t
{
  Unknown,
  No,
  Yes
};

// Measures of each cell before changes.
struct KnownCells
{
  std::vector<IsAtFault> atFault;    // Unknown: so is the rest
  std::vector<std::uint8_t> isPlain; // as isPlain (CellFaults.h) and isEasy (CellCost.h)
  std::vector<NeighbourCell> places; // from the lower corner of its box
  std::vector<double> shares;        // of its box's volume

  void reserve(std::size_t cells);
  void resize(std::size_t cells);
  void append(const KnownCells& others, std::size_t begin, std::size_t end);
};

// Of faces of sides and those after them (WallFaces), from the cells below and above.
using Sights = std::vector<std::array<CentreOffset, 2>>;

// Data shared by the slabs of one stage.
struct ShapedWall
{
  // `featureAngle` in degrees: edges of the wall that turn by more stay.
  ShapedWall(const Boxes& boxes, const Patches& patches, Sides& sides, Nodes& nodes, WallMesh& mesh,
    double featureAngle);

  const Boxes& boxes;
  const Patches& patches;
  Sides& sides;
  Nodes& nodes;
  WallMesh& mesh;
  double featureCosine;

  KnownCells known; // of polyhedral boxes, as they were
  std::unordered_map<std::uint32_t, NeighbourCell> movedHexahedra; // by box, from its lower corner
  Sights sights; // likewise; those of hexahedra too

  // Measures the cells in these layers that are not measured yet, before any slab changes.
  void measure(Layers layers, Execution& execution);

  // The cells of polyhedral boxes in these layers: begin and end.
  std::array<CellKey, 2> cellsIn(Layers layers) const
  {
    return cartesian::cellsIn(boxes, sides, mesh, layers);
  }
};

}
