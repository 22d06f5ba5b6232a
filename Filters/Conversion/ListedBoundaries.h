// SPDX-License-Identifier: BSD-3-Clause
// The boundaries of a surface to choose from: what they are, where they are, and which of them is behind a place of a picture.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class vtkPolyData;

namespace cartesian
{

class SurfaceFromVTK;

struct ListedBoundary
{
  std::int32_t number;
  std::string name;
  double area = 0;           // user units
  std::size_t triangles = 0; // none: a side of a flow domain, or a name alone
};

// In order of their numbers.
std::vector<ListedBoundary> listBoundaries(const SurfaceFromVTK& surface);

// The triangles of a boundary that any of these names and patterns is of, each on both sides of itself, so near that
// it covers the surface.
void boundariesToVTK(
  const SurfaceFromVTK& surface, const std::vector<std::string>& patterns, vtkPolyData* triangles);

// The boundary of the first triangle on the way from a point to another; empty: none is.
std::string boundaryBetween(const SurfaceFromVTK& surface, const std::array<double, 3>& from,
  const std::array<double, 3>& to);

}
