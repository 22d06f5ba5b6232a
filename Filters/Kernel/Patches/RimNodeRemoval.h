// SPDX-License-Identifier: BSD-3-Clause
// Removal of nodes along the rims of sheets (ThinSheets.h, and section 6, A2).
//
// Where a box is larger than the triangles, a rim has many nodes in it, and at each a cell would have to be cut once
// more, as it cannot reach around the rim. Those close to the chord beside them are removed, and the polygons on both
// sides of the sheet are rebuilt.
#pragma once

#include "Lattice/MarchingCubes.h"
#include "Patches/BoxPolygons.h"

namespace cartesian
{

// Keeps its storage from box to box.
class RimNodeRemoval
{
public:
  explicit RimNodeRemoval(BoxPolygons& box)
    : box_(box)
  {
  }

  // `rims`: edges of polygons, each once. Removes nodes inside the box on two of these, the nearest to its chord first,
  // where polygons on either side turn by no more than `turn` radians.
  void run(const std::vector<PolygonEdge>& rims, double turn);

private:
  // A node on a rim that goes on there, or not.
  struct Link
  {
    std::array<std::uint32_t, 2> next{ None, None };
    std::array<double, 2> off{}; // how far what was removed is from the chords to these
    int edges = 0;
  };

  // The replacement of the polygons on one side of the sheet.
  struct Sector
  {
    std::vector<std::uint32_t> fan; // polygons
    std::vector<std::uint32_t> loop;
    std::vector<LoopTriangulation::Triangle> triangles; // of the loop
    Vector axis{};
  };

  static constexpr std::uint32_t None = ~std::uint32_t(0);

  void listLinks(const std::vector<PolygonEdge>& rims);
  double offWithout(std::uint32_t node) const;
  bool remove(std::uint32_t node);
  bool gather(std::uint32_t node, std::uint32_t from, std::uint32_t to, Sector& sector);
  bool triangulate(Sector& sector);
  bool isFree(std::uint32_t node, std::uint32_t p, std::uint32_t q) const;
  void replace(const Sector& sector);
  void relink(std::uint32_t node);

  BoxPolygons& box_;
  double turn_ = 0;
  std::vector<Link> links_; // of points
  std::array<Sector, 2> sectors_;
  std::vector<LoopNode> nodes_; // of a loop
  LoopTriangulation triangulation_;
};

}
