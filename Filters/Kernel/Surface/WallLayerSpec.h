// SPDX-License-Identifier: BSD-3-Clause
// User options for boundary layers.
#pragma once

#include "Surface/WallFlow.h"
#include "Surface/Walls.h"

#include <cstdint>
#include <vector>

namespace cartesian
{

struct WallLayerSpec
{
  static constexpr int Automatic = -1;
  static constexpr int MostLayers = 50;
  static constexpr Range Counts{ Automatic, MostLayers };
  static constexpr Range Ratios{ 1, 3 };
  static constexpr Range Thicknesses{ 0 };
  static constexpr Range LastLayers{ 0.01, 1 };

  int count =
    0; // 0: no layers; Automatic: as many as lead from the first thickness to the last layer
  double ratio = 1.2; // of the thicknesses of two layers, away from the wall

  // User units; the first that is not 0 applies. Both 0: if the flow has a target y+, the first layer follows from that;
  // else all layers together are a third of the box at that place.
  double firstThickness = 0;
  double thickness = 0; // of all layers

  WallFlow flow;

  // With an automatic number of layers: the most that the last one takes of the box beside it.
  double lastByBox = 0.1;

  bool refine = true; // boxes in which a wall with layers bends (SizingSpec.h)

  // Boundaries that are unlike the others; of several entries the first applies.
  struct OfBoundary
  {
    std::int32_t boundary;
    double thickness; // of all layers, in user units; 0: none
  };
  std::vector<OfBoundary> boundaries;

  std::vector<std::int32_t> regions; // with layers; none: all (Walls.h)

  // Of all layers on a boundary. `usual`: on others.
  double thicknessAt(std::int32_t boundary, double usual) const;
  bool isIn(std::int32_t region) const;
  bool any() const { return count != 0; }
  bool hasLayers(std::int32_t boundary) const { return thicknessAt(boundary, 1) > 0; }
};

// Whether there are layers on any side of a wall.
bool hasLayersOn(const WallLayerSpec& spec, const Walls& walls, std::int32_t wall);

// Throws Error: BadParameter.
void requireValid(const WallLayerSpec& spec);

// With the first thickness that follows from a target y+, if there is one. `longestSide`: of the surface, in user units.
WallLayerSpec forFlow(WallLayerSpec spec, double longestSide);

// How many layers lead from the first one, as thick as it is, at the ratio, to the last layer beside a box, which may be
// more than MostLayers; with layers that do not grow, 1. `box`: its shortest side, in user units.
int layersTo(const WallLayerSpec& spec, double box);

// With that number, at most MostLayers, if it was automatic.
WallLayerSpec withNumber(WallLayerSpec spec, double box);

// Of all layers, in user units, except on `boundaries`. `box`: the shortest side of the box there.
double totalThickness(const WallLayerSpec& spec, double box);

// Whether the first layer is low by a box of this side.
bool isFlat(const WallLayerSpec& spec, double box);
bool isFlat(double first, double box); // user units

// The height above the wall at which each layer ends, as a part of the total: 0, ..., 1.
std::vector<double> heightsOfLayers(const WallLayerSpec& spec);

}
