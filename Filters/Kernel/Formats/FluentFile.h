// SPDX-License-Identifier: BSD-3-Clause
// A mesh as a file of ANSYS Fluent (.msh), in ASCII: faces of any number of corners between zones of polyhedra.
//
// The format is that of the appendix "Mesh File Format" of Fluent's user's guide. The sections are: 0 comment, 2
// dimension, 10 points, 12 cells, 13 faces, 18 pairs of periodic faces, 45 zones; numbers in 10, 12 and 13 are hexadecimal, from one. The corners
// of a face run counter-clockwise seen from its first cell's inside; the second cell is 0 at a boundary.
#pragma once

#include "OpenFoam/FoamRegions.h"

namespace cartesian
{

// A name and what the file has instead.
struct ChangedName
{
  std::string given;
  std::string written;
};

// Each region is a zone of cells (one called "cells", if there are none), fluid or, where there are several and this
// one is not fluid (isFluid), solid. Inner faces are a zone "interior" for each; faces between two
// regions one of type wall, <region>_to_<other>; where regions are zones of one fluid (areZones), interior. Each patch is a zone with its
// name, by its kind wall, symmetry, velocity-inlet or pressure-outlet (which other openings are too); a pair of type cyclic, whose
// faces must be in the same order (orderCyclicFaces), is periodic and shadow. One of several regions is divided,
// <patch>_<region>, as faces of a zone are of one zone of cells. Letters that Fluent does not allow in names
// are written as others (asciiName), other characters become underscores, and all names differ. Returns the names that
// had to change. Throws Error (CannotWrite).
std::vector<ChangedName> writeFluent(
  const FoamMesh& mesh, const FoamRegions& regions, const std::filesystem::path& path);

}
