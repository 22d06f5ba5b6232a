// SPDX-License-Identifier: BSD-3-Clause
// Cells on the same side of two faces with the same nodes: the smaller one is found, whichever way round the faces are.
#include "Cells/OverlappingCells.h"
#include "Mesher/Assembly.h"
#include "Support/Pipeline.h"
#include "Support/Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cartesian
{

namespace
{

class OverlappingCells : public ::testing::Test
{
protected:
  std::vector<std::uint32_t> found() const
  {
    Execution execution(2);
    return overlappingCells(
      assembly_->boxes, assembly_->nodes.at.size(), assembly_->wall, execution);
  }

  // The first face between two cells of the wall that are not equally large.
  std::uint32_t someInnerFace() const
  {
    const auto& cells = assembly_->wall.faces.cells;
    const auto at = std::find_if(cells.begin(), cells.end(), [&](const auto& of) {
      return of[0] < FirstHexahedron && of[1] < FirstHexahedron && shareOf(of[0]) != shareOf(of[1]);
    });
    return static_cast<std::uint32_t>(at - cells.begin());
  }

  double shareOf(CellKey cell) const { return assembly_->wall.cells[cell].volumeFraction; }

  // The face once more, starting elsewhere, between these.
  void repeat(std::uint32_t face, bool turned, const std::array<CellKey, 2>& between)
  {
    WallFaces& faces = assembly_->wall.faces;
    std::vector<std::uint32_t> ring(
      faces.corners.begin() + faces.start[face], faces.corners.begin() + faces.start[face + 1]);
    std::rotate(ring.begin(), ring.begin() + 1, ring.end());
    if (turned)
    {
      std::reverse(ring.begin(), ring.end());
    }
    faces.corners.insert(faces.corners.end(), ring.begin(), ring.end());
    faces.add(between, NoBoundary);
  }

  Execution execution_;
  std::unique_ptr<Assembly> assembly_{ assembledOf(
    sphere(4, 1), cellsOf(0.4), asTheyAre(), execution_) };
};

TEST_F(OverlappingCells, AreNoneInASoundMesh)
{
  EXPECT_TRUE(found().empty());
}

TEST_F(OverlappingCells, AreNotThoseOnEitherSideOfAWall)
{
  const std::uint32_t face = someInnerFace();
  auto& cells = assembly_->wall.faces.cells;
  repeat(face, true, { cells[face][1], None });
  cells[face][1] = None;
  EXPECT_TRUE(found().empty());
}

TEST_F(OverlappingCells, OnTheSameSideTheSmallerOneGoes)
{
  const std::uint32_t face = someInnerFace();
  const auto [one, other] = assembly_->wall.faces.cells[face];
  const std::vector<std::uint32_t> smaller{ shareOf(one) < shareOf(other) ? one : other };
  for (const bool turned : { false, true })
  {
    SCOPED_TRACE(turned);
    const WallFaces before = assembly_->wall.faces;
    auto& cells = assembly_->wall.faces.cells;
    cells[face] = { one, None };
    repeat(face, turned,
      turned ? std::array<CellKey, 2>{ None, other } : std::array<CellKey, 2>{ other, None });
    EXPECT_EQ(found(), smaller);
    assembly_->wall.cells[smaller[0]].removed = true;
    EXPECT_TRUE(found().empty());
    assembly_->wall.cells[smaller[0]].removed = false;
    assembly_->wall.faces = before;
  }
}

}

}
