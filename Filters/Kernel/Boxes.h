// Box Generation (section 4.5; steps 7 and 8): the boxes that cover the domain.
//
// Only boxes inside or intersected are kept: memory grows with the mesh, not with the grid.
#pragma once

#include "Shoeboxes.h"
#include "SurfaceCheck.h"

namespace cartesian
{

enum class BoxStatus : std::uint8_t
{
  Outside = 0, // never kept
  Inside = 1,
  Intersected = 2, // a triangle passes through it
};

// Region of a vertex or a cell: 0 outside; domains count from 1.
constexpr std::int32_t OutsideRegion = 0;
constexpr std::int32_t FirstRegion = 1;

struct Box
{
  Point low;
  Point high;
  std::array<std::uint32_t, 3> global; // I, J, K of the global box
  std::uint8_t corners;                // bit x + 2 y + 4 z: that corner is inside
  BoxStatus status;
};

constexpr std::uint8_t AllCorners = 0xff;

inline Point cornerOf(const Box& box, unsigned corner)
{
  return { corner & 1 ? box.high[0] : box.low[0], corner & 2 ? box.high[1] : box.low[1],
    corner & 4 ? box.high[2] : box.low[2] };
}

struct Boxes
{
  Lattice lattice;
  Meshlines planes;
  std::vector<Box> boxes;            // by rows along x (J + K * boxes along y), then by I
  std::vector<std::size_t> rowStart; // first box of each row, and the end

  bool closed = true; // every line enters the domain as often as it leaves it

  std::size_t row(std::size_t j, std::size_t k) const { return j + k * (planes[1].size() - 1); }
};

// Statuses from the crossings along x where the surface is closed; where it is not, each vertex
// takes the vote of its six rays (4.4).
Boxes generateBoxes(const Surface& surface, const SurfaceCheck& check, const Meshlines& planes,
  const SurfaceRows& rows, Execution& execution);

// How many boxes and bytes the mesh will take, roughly, before anything is built.
struct Estimate
{
  double boxes;
  double bytes;
};
Estimate estimateMesh(const Surface& surface, const Meshlines& planes);

}
