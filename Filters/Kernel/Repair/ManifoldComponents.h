// SPDX-License-Identifier: BSD-3-Clause
// Sheets of a surface: triangles connected across edges of exactly two triangles, and how each
// triangle is turned relative to the first one of its sheet.
#pragma once

#include "Surface/SurfaceEdges.h"

namespace cartesian
{

// Disjoint sets (union-find) that also keep each member's orientation relative to its root.
class ManifoldComponents
{
public:
  ManifoldComponents(const Surface& surface, const SurfaceEdges& edges, Execution& execution);

  // The sheet's number: that of its first triangle.
  std::uint32_t of(std::size_t triangle) const { return parent_[triangle]; }
  bool closed(std::uint32_t sheet) const { return open_[sheet] == 0; }

  // Whether a triangle faces the other way than the first one of its sheet, once these agree.
  bool turned(std::size_t triangle) const { return turned_[triangle] != 0; }

private:
  void findOpen(const SurfaceEdges& edges, Execution& execution);
  void joinAsGiven(const Surface& surface, const SurfaceEdges& edges);
  int netUse(std::uint32_t sheet, const EdgeUse* begin, const EdgeUse* end);
  std::uint32_t find(std::uint32_t t);
  void join(std::uint32_t a, std::uint32_t b, bool opposite);

  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> turned_; // relative to the parent; 0 for a root
  std::vector<std::uint8_t> open_;   // of roots: whether the sheet has a border
};

}
