// SPDX-License-Identifier: BSD-3-Clause
// Names of boundaries, as field data: BoundaryIds (int) and BoundaryNames (string), of the same
// length, in order of the numbers. Surfaces may bring them; boxes, patches, meshes and their
// boundaries do.
#pragma once

#include <cstdint>
#include <map>
#include <string>

class vtkDataObject;

namespace cartesian
{

using BoundaryNames = std::map<std::int32_t, std::string>;

// The number of a boundary, or of NoBoundary, by name. Throws Error (BadParameter): there is none of
// the name that `property` has.
std::int32_t boundaryCalled(
  const BoundaryNames& names, const std::string& name, const std::string& property);

// What a boundary is called that nobody named; -1, where no patch was, is "no_surface".
std::string unnamedBoundary(std::int32_t boundary);

// Empty where `data` has none. Throws Error (MissingArray): one array only, or of other lengths.
BoundaryNames boundaryNames(vtkDataObject* data);

void setBoundaryNames(vtkDataObject* data, const BoundaryNames& names);

// Field data BoundaryTypes (string): OpenFOAM's types of the boundaries in `names`, empty where none is
// known; nothing where there are none at all.
void setBoundaryTypes(vtkDataObject* data, const BoundaryNames& names, const BoundaryNames& types);

}
