// A surface and a grid from arbitrary bytes, for the fuzzer and for the tests of its findings.
#pragma once

#include "Support/MeshChecker.h"

namespace cartesian
{

// The bytes choose random triangles on a small or a large lattice, or closed shapes that are edited
// (triangles dropped, flipped, duplicated or collapsed, vertices moved, shapes moved through each
// other), the patch method, whether small cells are removed or merged, and whether concave ones are
// split. Missing bytes are zero. Success: a valid mesh, or an error about the surface.
::testing::AssertionResult meshesFromBytes(const std::uint8_t* bytes, std::size_t size);

// The edited shapes alone.
Soup editedShapes(const std::uint8_t* bytes, std::size_t size);

}
