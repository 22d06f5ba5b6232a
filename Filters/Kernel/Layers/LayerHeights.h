// SPDX-License-Identifier: BSD-3-Clause
// Where the layers of a stack end above the wall.
#pragma once

#include "Surface/WallLayerSpec.h"

namespace cartesian
{

// A stack with less room than requested keeps the height of its first layer as long as possible, since that sets y+:
// its layers grow more slowly. If one of them would be thinner than half the requested thickness, or there is not
// even room for layers of equal height, all become thinner.
//
// Flat stacks have fewer layers instead, each as high as requested. Layers that grew more slowly would lean more from one to the
// next, where the room differs from node to node, and the line between two centres would hardly cross the face between them,
// which is far wider than the prisms are high.
class LayerHeights
{
public:
  // At least one layer.
  explicit LayerHeights(const WallLayerSpec& spec);

  std::size_t layers() const { return full_.size() - 1; }

  // How many layers fit in a part (0 to 1) of the way, and what these take of it.
  std::size_t layersIn(double part, bool isFlat) const;
  double fitting(double part, bool isFlat) const;

  // Between nodes with at least and at most so many layers, how many of these are cells by themselves: what is above them
  // is as high at least as it differs, and its centre lies aside of theirs by no more than half its height. `slenderness`: the
  // width of the face by the height of all layers.
  std::size_t layersBelow(std::size_t least, std::size_t most, double slenderness) const;

  // The end of the k-th layer, from the wall, of a stack that takes a part of its way; as a part of the way.
  double at(double part, std::size_t k, bool isFlat) const;

private:
  // Where layers as high as the first become a part t as high as they should: the end of the k-th.
  double blend(double t, std::size_t k) const;

  std::vector<double> full_; // of all layers, as parts of the way: 0, ..., 1
  double
    grown_; // of the height that layers gain over the first, where the last has half the requested thickness
  double kept_; // the least part of the way with a first layer as requested
};

}
