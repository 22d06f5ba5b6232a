// A surface and a grid made of arbitrary bytes, for the fuzzer and for the tests of what it found.
#pragma once

#include "Support/MeshChecker.h"

namespace cartesian
{

// Random triangles on a small or a large lattice, or closed shapes edited: triangles dropped, turned,
// doubled, collapsed, vertices moved, shapes moved through each other; each patch method, small cells
// removed or merged, concave ones split or not. What the bytes do not say is zero. Success: a valid mesh,
// or a refusal that names the surface.
::testing::AssertionResult meshesFromBytes(const std::uint8_t* bytes, std::size_t size);

}
