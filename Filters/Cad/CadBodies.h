// SPDX-License-Identifier: BSD-3-Clause
// Bodies that touch, among loose faces that were sewn together: in an edge of both, more than two faces meet.
#pragma once

#include <TopoDS_Shape.hxx>

#include <cstddef>
#include <vector>

namespace cartesian
{

// The faces of each closed body, then those that are left, if any, by their numbers. Across an edge of two faces both are of
// one body; at others a body goes on with the nearest face in order: files list the faces of one body after those of another.
// Empty if no edge has more than two. `faces`: sewn, in the order of the file.
std::vector<std::vector<std::size_t>> bodiesOf(const std::vector<TopoDS_Shape>& faces);

}
