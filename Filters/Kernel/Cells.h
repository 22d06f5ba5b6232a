// Assembling of cells (section 6, part B; 4.10).
#pragma once

#include "InnerFaces.h"

namespace cartesian
{

// A face of a cell: a patch, or an inner face of a side as it is (its normal points up, so the
// cell is the one below) or turned over.
struct FaceRef
{
  enum class Kind : std::uint32_t
  {
    Patch,
    Inner,
    TurnedInner,
  };

  std::uint32_t index : 30;
  std::uint32_t kindBits : 2;

  FaceRef(std::size_t i, Kind kind)
    : index(static_cast<std::uint32_t>(i) & MostFaces)
    , kindBits(static_cast<std::uint32_t>(kind) & 3u)
  {
  }
  Kind kind() const { return static_cast<Kind>(kindBits); }

  static constexpr std::uint32_t MostFaces = (1u << 30) - 1;
};

// A separated volume (B2) of a polyhedral box (Sides.h).
struct Cell
{
  std::uint32_t box;
  std::int32_t boundary; // that most of its patches (by area) belong to, or NoBoundary
  double volumeFraction; // of its box
  std::size_t firstFace; // in Cells::faces; up to the next cell's first
  bool sliver;           // of no volume but that of rounding
  bool removed;          // a sliver, or smaller than R of its box (4.10)
};

struct Cells
{
  std::vector<Cell> cells; // of polyhedral boxes, in order; one more at the end
  std::vector<FaceRef> faces;
  std::vector<std::size_t> boxStart; // first cell of the n-th polyhedral box, and the end
  std::vector<std::uint8_t> flawed;  // 1: the box's faces do not close (a hole), it has no cells
  std::size_t folds = 0;             // walls without thickness inside one cell, left out
  std::size_t voids = 0;             // closed pieces of surface inside one cell, now holes of it

  // The cells below and above each inner face, or None: there is no box, or it is a hexahedron.
  std::vector<std::array<std::uint32_t, 2>> ofInnerFace;

  std::size_t size() const { return cells.size() - 1; }
};

struct CellSpec
{
  // R, from 0 to less than 1: cells below this part of their box's volume are removed.
  double smallCellRatio = 1e-3;
};

// Distinguishes the separated volumes of each polyhedral box and marks small ones as removed.
// Cells less thick than a hundredth of a lattice step (slivers that rounding closed) are removed
// whatever R is.
Cells assembleCells(const Boxes& boxes, const Patches& patches, const Sides& sides,
  const Nodes& nodes, const InnerFaces& inner, const CellSpec& spec, Execution& execution);

}
