// SPDX-License-Identifier: BSD-3-Clause
// The parts of a surface that become boundaries, with their names.
#pragma once

#include "BoundarySettings.h"
#include "Surface/SurfaceSplit.h"

#include "vtkType.h"

#include <map>
#include <string>
#include <vector>

namespace cartesian
{

class SurfaceParts
{
public:
  // `names`: of the patches. `cells`: of each triangle the cell that it is all or a part of; borrowed.
  SurfaceParts(const SurfaceSplit& split, const std::vector<std::string>& names,
    const std::vector<vtkIdType>& cells);

  // The selected cells become the part of that name, or join it: they alone, or all parts that have one. Throws Error
  // (BadParameter): no triangle is of a selected cell, or the name is empty.
  void select(const std::vector<bool>& cells, bool wholeParts, const std::string& name);

  // Which patches are no part any more, or one that joined others: that is called `joined`.
  std::vector<bool> areGone(const std::string& joined) const;

  // Gives the others these names.
  void nameLeft(const std::vector<std::string>& names, const std::string& joined);

  // Gives parts other names, of which those that are equal become one. Throws what mergedNames does.
  void rename(const BoundarySettings& settings);

  // After that, of what is left of each patch; empty: nothing.
  std::vector<std::string> namesOfPatches() const;

  // In order, numbered from 0.
  std::vector<std::string> names() const;

  // What each part was called before it was renamed, in the same order.
  std::vector<std::string> formerNames() const;

  // The part of each triangle, by its number.
  std::vector<std::int32_t> ofTriangles() const;

  // That of each cell's first triangle; NoBoundary where there is none.
  std::vector<std::int32_t> ofCells(vtkIdType count) const;

private:
  void dropEmpty();

  const std::vector<vtkIdType>& cells_;
  std::vector<std::int32_t> of_; // of each triangle
  std::size_t patches_ = 0;      // the first parts
  BoundaryNames names_;
  BoundaryNames former_;
  BoundaryNames given_;
};

}
