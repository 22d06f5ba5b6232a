// SPDX-License-Identifier: BSD-3-Clause
// Faces and cells that fail in a mesh with layers and passed, or were absent, without them; and thin slices beside
// thick stacks, which pass every check but make solvers slow or diverge.
#pragma once

#include "Layers/NearCells.h"
#include "Layers/PrismStacks.h"

#include <optional>

namespace cartesian
{

struct LayerFault
{
  std::vector<std::uint32_t> points; // of a face or a cell, the mesh's, then those of the stacks
  std::vector<std::uint32_t> around; // if it is of the mesh alone: all points of its cells
  bool mendsThinner = true;          // or only where there are no layers
};

class LayerFaults
{
public:
  // Borrows the cells. `points`: of the mesh without layers.
  LayerFaults(const NearCells& near, const std::vector<double>& points, Execution& execution);

  struct Changes
  {
    std::vector<std::uint8_t> cells; // of the near ones
    std::vector<std::uint8_t>
      isTouched; // of each of the mesh's points: a near cell there has changed
    std::vector<std::uint8_t> ofStacks; // of each point of the stacks: cells there have
  };

  // Of the mesh. `hasMoved`: of each of its points.
  Changes changesBy(const std::vector<std::uint8_t>& hasMoved) const;

  // Of all cells. `points`: of the mesh, then those of the stacks.
  std::vector<LayerFault> find(
    const PrismStacks& stacks, const std::vector<double>& points, Execution& execution) const;

  // Of cells that have changed. `stacks`: at least these and those with a face in common with what has changed.
  std::vector<LayerFault> find(const PrismStacks& stacks, const std::vector<double>& points,
    const Changes& changes, Execution& execution) const;

private:
  // The results of measureQuality for some cells.
  struct Faults
  {
    FaceList list;
    std::vector<std::uint8_t> face; // of each listed face
    std::vector<double> weight;     // FaceWeight of each inner face
    std::vector<double> volume;     // of each cell
    std::vector<std::uint8_t> cell;
    std::vector<std::uint8_t>
      isOdd; // cells at fault for their gain, for which thinner layers hardly help
    std::vector<std::uint8_t> isLong; // ... for their aspect ratio, at which prisms are good
  };
  struct Selection;

  static Faults measure(
    const CellFaces& cells, const std::vector<double>& points, Execution& execution);
  Selection select(const CellFaces& ofStacks, const Changes& changes) const;
  Selection selectAll(const CellFaces& ofStacks) const;
  std::vector<LayerFault> findIn(const Selection& selected, const PrismStacks& stacks,
    const std::vector<double>& points, Execution& execution) const;
  bool isNewFace(const Selection& selected, const Faults& faults, std::size_t f) const;
  std::optional<LayerFault> ofSlice(const Selection& selected, const Faults& faults, std::size_t f,
    const PrismStacks& stacks) const;
  LayerFault ofFace(const Selection& selected, const Faults& faults, std::size_t f,
    const PrismStacks& stacks) const;

  const NearCells& near_;
  std::vector<std::uint8_t> faceWasAtFault_; // of the near cells, as the owner has it
  std::vector<std::uint8_t> cellWasAtFault_;
  std::vector<std::uint8_t> cellWasOdd_;
  std::vector<std::uint8_t> cellWasLong_;
};

}
