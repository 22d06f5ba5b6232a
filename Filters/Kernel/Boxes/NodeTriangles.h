// SPDX-License-Identifier: BSD-3-Clause
// The triangles that pass through each node of the tree of boxes, however deep it is.
#pragma once

#include "Boxes/Boxes.h"
#include "Boxes/Shoeboxes.h"

namespace cartesian
{

class NodeTriangles
{
public:
  // Borrows `boxes` and `shoeboxes`.
  NodeTriangles(
    const Surface& surface, const Boxes& boxes, const Shoeboxes& shoeboxes, Execution& execution);

  struct Near
  {
    TriangleRange triangles; // ascending
    std::uint32_t list;      // the same for boxes with the same triangles
  };

  // Of the smallest node that contains a box; of the global box if that is undivided, or the box as large.
  Near of(const PackedBox& box) const;

private:
  // A node, and its cube in a global box.
  struct Place
  {
    std::uint32_t node;
    std::uint32_t global;
    Cube cube;
  };
  TriangleRange trianglesOf(const GlobalBox& global) const;
  TriangleRange trianglesOf(const Place& place) const;
  std::vector<Place> roots() const;

  // Fills the lists of the nodes below one; appends these nodes.
  void distribute(const Surface& surface, const Place& place, std::vector<Place>& below);

  const Boxes& boxes_;
  const Shoeboxes& shoeboxes_;
  std::vector<std::vector<std::uint32_t>>
    lists_; // by the number of the node; of global boxes empty
};

}
