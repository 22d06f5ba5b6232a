// The place of a triangle nearest to another place.
#include "Lattice/NearestPlace.h"

#include <gtest/gtest.h>

namespace cartesian
{

namespace
{

constexpr Vector A{ 1, 1, 5 };
constexpr Vector B{ 5, 1, 5 };
constexpr Vector C{ 1, 9, 5 };

// In each region of the plane: beyond a corner, beside an edge, inside.
TEST(NearestPlace, IsACornerOnAnEdgeOrInside)
{
  EXPECT_EQ(nearestPlace(A, B, C, { 0, -1, 7 }), A);
  EXPECT_EQ(nearestPlace(A, B, C, { 7, 1, 4 }), B);
  EXPECT_EQ(nearestPlace(A, B, C, { 1, 11, 9 }), C);
  EXPECT_EQ(nearestPlace(A, B, C, { 3, -2, 3 }), (Vector{ 3, 1, 5 }));
  EXPECT_EQ(nearestPlace(A, B, C, { 0, 4, 6 }), (Vector{ 1, 4, 5 }));
  EXPECT_EQ(nearestPlace(A, B, C, { 7, 7, 6 }), (Vector{ 3, 5, 5 }));
  EXPECT_EQ(nearestPlace(A, B, C, { 2, 3, 8 }), (Vector{ 2, 3, 5 }));
}

TEST(NearestPlace, IsTheSameOnTheLattice)
{
  EXPECT_EQ(
    nearestPlace(Corners{ Point{ 1, 1, 5 }, Point{ 5, 1, 5 }, Point{ 1, 9, 5 } }, { 7, 7, 6 }),
    (Vector{ 3, 5, 5 }));
}

// Without area, and without length.
TEST(NearestPlace, IsOnWhatIsLeftOfATriangle)
{
  EXPECT_EQ(nearestPlace(A, B, { 3, 1, 5 }, { 4, 3, 5 }), (Vector{ 4, 1, 5 }));
  EXPECT_EQ(nearestPlace(A, A, B, { 2, 3, 5 }), (Vector{ 2, 1, 5 }));
  EXPECT_EQ(nearestPlace(A, B, A, { 2, 3, 5 }), (Vector{ 2, 1, 5 }));
  EXPECT_EQ(nearestPlace(A, B, B, { 2, 3, 5 }), (Vector{ 2, 1, 5 }));
  EXPECT_EQ(nearestPlace(A, A, A, { 2, 3, 5 }), A);
}

}

}
