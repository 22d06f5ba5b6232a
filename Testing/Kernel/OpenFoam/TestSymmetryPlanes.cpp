// Which boundaries are symmetries by their names, and which of these are planes; TestSymmetries.py asks OpenFOAM.

#include "OpenFoam/SymmetryPlanes.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

// Two triangles of one patch, z = 0 and, to a fourth corner, up to z = rise.
FoamMesh twoTriangles(const FoamPatch& patch, double rise)
{
  return { { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, rise }, { 0, 3, 6 }, { 0, 1, 2, 0, 2, 3 }, { 0, 0 },
    {}, 1, { patch } };
}

std::string typeOf(const FoamPatch& patch, double rise = 0)
{
  return withSymmetries(twoTriangles(patch, rise)).front().type;
}

}

TEST(SymmetryPlanes, AreFlat)
{
  EXPECT_EQ(typeOf({ "symmetry", 2 }), "symmetryPlane");
  EXPECT_EQ(typeOf({ "SymmetryLeft", 2 }), "symmetryPlane");
  EXPECT_EQ(typeOf({ "symmetry", 2 }, 1e-6), "symmetry"); // OpenFOAM would die
  EXPECT_EQ(typeOf({ "wall_symmetry", 2 }), "");
}

TEST(SymmetryPlanes, AreNoneOfAnotherType)
{
  EXPECT_EQ(typeOf({ "symmetry", 2, "wall" }), "wall");
  EXPECT_EQ(typeOf({ "symmetry_to_other", 2, {}, { "other", "other_to_symmetry" } }), "");
  EXPECT_EQ(typeOf({ "symmetry_to_other", 2, {}, {}, {}, "other_to_symmetry" }), "");
}

// The rest of the patch may be in other pieces.
TEST(SymmetryPlanes, AreNotKnownOfAPiece)
{
  FoamMesh piece = twoTriangles({ "symmetry", 2 }, 0);
  piece.addressing.emplace();
  EXPECT_EQ(withSymmetries(piece).front().type, "symmetry");
}

TEST(BoundaryKinds, FollowFromTypesElseNames)
{
  EXPECT_EQ(kindOf({ "symmetry_1", 1 }), BoundaryKind::Symmetry);
  EXPECT_EQ(kindOf({ "symmetry_1", 1, "wall" }), BoundaryKind::Wall);
  EXPECT_EQ(kindOf({ "side", 1 }), BoundaryKind::Wall);
  EXPECT_EQ(kindOf({ "side", 1, "symmetryPlane" }), BoundaryKind::Symmetry);
}

TEST(FluidRegions, AreThoseOfTheirNameElseThoseWithAnOpening)
{
  EXPECT_TRUE(isFluid("fluid_1", { { "side", 1, "wall" } }));
  EXPECT_TRUE(isFluid("Fluid", {}));
  EXPECT_FALSE(isFluid("solid", { { "inlet", 1, "patch" } }));
  EXPECT_TRUE(isFluid("gas", { { "side", 1 }, { "inlet", 1 } }));
  EXPECT_TRUE(isFluid("gas", { { "side", 1, "patch" } }));
  EXPECT_FALSE(
    isFluid("gas", { { "inlet", 1, "wall" }, { "symmetry", 1 }, { "x", 1, "symmetryPlane" } }));
}
