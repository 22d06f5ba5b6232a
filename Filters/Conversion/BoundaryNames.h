// SPDX-License-Identifier: BSD-3-Clause
// Names of boundaries as field data: the arrays BoundaryIds (int) and BoundaryNames (string), of the same
// length, in order of the numbers. Surfaces may have them; boxes, patches, meshes and their boundaries
// always do.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataObject;

namespace cartesian
{

using BoundaryNames = std::map<std::int32_t, std::string>;

// The number of the boundary (or NoBoundary) with this name. Throws Error (BadParameter) if there is none;
// `property` is where the user entered the name.
std::int32_t boundaryCalled(
  const BoundaryNames& names, const std::string& name, const std::string& property);

// The name of a boundary without one. That of faces without a patch, -1, is "no_surface".
std::string unnamedBoundary(std::int32_t boundary);

// Empty if `data` has no names. Throws Error (MissingArray): only one array, or different lengths.
BoundaryNames boundaryNames(vtkDataObject* data);

void setBoundaryNames(vtkDataObject* data, const BoundaryNames& names);

// For files that name parts, some alike: gives parts of one name the number of the first of them. `labels`:
// the part of each cell, which becomes its boundary. Parts without a name are "unnamed".
BoundaryNames uniteNames(const std::vector<std::string>& names, vtkDataArray* labels);

// Sets the field data BoundaryTypes (string), OpenFOAM's type of each boundary in `names`, or empty where the
// type is unknown. No array if all are unknown.
void setBoundaryTypes(vtkDataObject* data, const BoundaryNames& names, const BoundaryNames& types);

}
