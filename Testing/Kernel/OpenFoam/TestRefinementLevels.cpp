// Levels for OpenFOAM's solvers that refine; Testing/Validation/TestRefining.py runs one.
#include "OpenFoam/RefinementLevels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace cartesian
{
namespace
{

using Place = std::array<int, 3>;

struct TestBox
{
  Place low;
  Place size;
  BoxLevel level;
};

// Of boxes that fill a part of space; places are whole numbers.
class MeshOfBoxes
{
public:
  explicit MeshOfBoxes(const std::vector<TestBox>& boxes)
    : boxes_(boxes)
  {
    for (const TestBox& box : boxes)
    {
      for (int corner = 0; corner < 8; ++corner)
      {
        Place at = box.low;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          at[axis] += (corner >> axis & 1) * box.size[axis];
        }
        number_.emplace(at, 0);
      }
      mesh_.boxLevels.push_back(box.level);
    }
    for (auto& [at, number] : number_)
    {
      number = static_cast<std::uint32_t>(mesh_.points.size() / 3);
      mesh_.points.insert(mesh_.points.end(), at.begin(), at.end());
    }
    mesh_.cellCount = boxes.size();
    mesh_.start = { 0 };
    addFaces(true);
    addFaces(false);
  }

  const FoamMesh& mesh() const { return mesh_; }
  std::uint32_t point(const Place& at) const { return number_.at(at); }

private:
  // A side of each that is not larger than what is beyond.
  void addFaces(bool inner)
  {
    for (std::uint32_t b = 0; b < boxes_.size(); ++b)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        addSides(b, axis, inner);
      }
    }
  }

  void addSides(std::uint32_t b, std::size_t axis, bool inner)
  {
    const TestBox& box = boxes_[b];
    for (const bool upper : { false, true })
    {
      Place beyond = box.low;
      beyond[axis] += upper ? box.size[axis] : -1;
      const auto other = std::find_if(boxes_.begin(), boxes_.end(),
        [&](const TestBox& candidate) { return contains(candidate, beyond); });
      if (other == boxes_.end() && !inner)
      {
        addFace(box, axis, upper, b);
      }
      else if (other != boxes_.end() && inner && isFinest(box, *other, axis, upper))
      {
        addFace(box, axis, upper, b);
        mesh_.neighbour.push_back(static_cast<std::uint32_t>(other - boxes_.begin()));
      }
    }
  }

  // Of two alike, the face is that of the lower one.
  static bool isFinest(const TestBox& box, const TestBox& other, std::size_t axis, bool upper)
  {
    const std::size_t a = (axis + 1) % 3;
    const std::size_t b = (axis + 2) % 3;
    const bool alike = box.size[a] == other.size[a] && box.size[b] == other.size[b];
    return alike ? upper : box.size[a] <= other.size[a] && box.size[b] <= other.size[b];
  }

  static bool contains(const TestBox& box, const Place& at)
  {
    bool in = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      in = in && at[axis] >= box.low[axis] && at[axis] < box.low[axis] + box.size[axis];
    }
    return in;
  }

  // With the points on its edges.
  void addFace(const TestBox& box, std::size_t axis, bool upper, std::uint32_t owner)
  {
    const std::size_t a = (axis + 1) % 3;
    const std::size_t b = (axis + 2) % 3;
    Place at = box.low;
    at[axis] += upper ? box.size[axis] : 0;
    const auto walk = [&](std::size_t along, int step) {
      for (int n = 0; n < box.size[along]; ++n)
      {
        const auto found = number_.find(at);
        if (found != number_.end())
        {
          corners_.push_back(found->second);
        }
        at[along] += step;
      }
    };
    walk(a, 1);
    walk(b, 1);
    walk(a, -1);
    walk(b, -1);
    mesh_.corners.resize(corners_.size());
    std::copy(corners_.begin(), corners_.end(), mesh_.corners.data());
    mesh_.start.push_back(corners_.size());
    mesh_.owner.push_back(owner);
  }

  std::vector<TestBox> boxes_;
  std::map<Place, std::uint32_t> number_;
  std::vector<std::uint32_t> corners_;
  FoamMesh mesh_{};
};

// A cube of `across`^3 boxes of this size, from `low`.
std::vector<TestBox> cubes(const Place& low, int across, int size, BoxLevel level)
{
  std::vector<TestBox> boxes;
  for (int n = 0; n < across * across * across; ++n)
  {
    const Place at = { low[0] + size * (n % across), low[1] + size * (n / across % across),
      low[2] + size * (n / across / across) };
    boxes.push_back({ at, { size, size, size }, level });
  }
  return boxes;
}

std::vector<TestBox> together(std::vector<TestBox> a, const std::vector<TestBox>& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

int anchorsOf(const FoamMesh& mesh, const RefinementLevels& levels, std::uint32_t cell)
{
  std::vector<std::uint32_t> points;
  for (std::size_t f = 0; f < mesh.owner.size(); ++f)
  {
    if (mesh.owner[f] == cell || (f < mesh.neighbour.size() && mesh.neighbour[f] == cell))
    {
      std::copy_if(mesh.corners.data() + mesh.start[f], mesh.corners.data() + mesh.start[f + 1],
        std::back_inserter(points),
        [&](std::uint32_t p) { return levels.ofPoints[p] <= levels.ofCells[cell]; });
    }
  }
  std::sort(points.begin(), points.end());
  return static_cast<int>(std::unique(points.begin(), points.end()) - points.begin());
}

TEST(RefinementLevels, AreThoseOfHalvedBoxes)
{
  const MeshOfBoxes boxes(
    together(cubes({ 0, 0, 0 }, 1, 4, { 0, true }), cubes({ 4, 0, 0 }, 2, 2, { 1, true })));
  const auto levels = refinementLevels(boxes.mesh());
  ASSERT_TRUE(levels);
  EXPECT_EQ(levels->ofCells, (std::vector<std::int32_t>{ 0, 1, 1, 1, 1, 1, 1, 1, 1 }));
  EXPECT_EQ(levels->edge, 4);
  for (const auto& [at, level] : std::map<Place, int>{ { { 0, 0, 0 }, 0 }, { { 4, 4, 4 }, 0 },
         { { 4, 2, 0 }, 1 }, { { 4, 2, 2 }, 1 }, { { 6, 2, 2 }, 1 }, { { 8, 0, 0 }, 1 } })
  {
    EXPECT_EQ(levels->ofPoints[boxes.point(at)], level);
  }
  for (std::uint32_t cell = 0; cell < 9; ++cell)
  {
    EXPECT_EQ(anchorsOf(boxes.mesh(), *levels, cell), 8);
  }
}

// A box that is cut, though it looks whole, in the middle of others.
TEST(RefinementLevels, ProtectWhatIsNotWhole)
{
  std::vector<TestBox> all = cubes({ 0, 0, 0 }, 5, 2, { 1, true });
  all[62].level.isWhole = false;
  const MeshOfBoxes boxes(all);
  const auto levels = refinementLevels(boxes.mesh());
  ASSERT_TRUE(levels);
  EXPECT_NE(anchorsOf(boxes.mesh(), *levels, 62), 8);
  int refinable = 0;
  for (std::uint32_t cell = 0; cell < 125; ++cell)
  {
    refinable += anchorsOf(boxes.mesh(), *levels, cell) == 8 ? 1 : 0;
  }
  EXPECT_EQ(refinable, 117); // all but those around one of its points
}

// Beside a box that is halved along one axis, sides are halves.
TEST(RefinementLevels, ProtectWhatIsHalvedAlongOneAxis)
{
  std::vector<TestBox> all = cubes({ 0, 0, 0 }, 5, 2, { 0, true });
  all[62] = { { 4, 4, 4 }, { 1, 2, 2 }, { 1, false } };
  all.push_back({ { 5, 4, 4 }, { 1, 2, 2 }, { 1, false } });
  const MeshOfBoxes boxes(all);
  const auto levels = refinementLevels(boxes.mesh());
  ASSERT_TRUE(levels);
  for (const std::uint32_t cell : { 37u, 57u, 62u, 67u, 87u, 125u })
  {
    EXPECT_NE(anchorsOf(boxes.mesh(), *levels, cell), 8) << cell;
  }
  int refinable = 0;
  for (std::uint32_t cell = 0; cell < 126; ++cell)
  {
    refinable += anchorsOf(boxes.mesh(), *levels, cell) == 8 ? 1 : 0;
  }
  EXPECT_GT(refinable, 90);
}

TEST(RefinementLevels, AreNoneWhereNothingCanBeRefined)
{
  EXPECT_FALSE(refinementLevels(MeshOfBoxes(cubes({ 0, 0, 0 }, 2, 2, { 1, false })).mesh()));
  FoamMesh unknown = MeshOfBoxes(cubes({ 0, 0, 0 }, 1, 2, { 0, true })).mesh();
  unknown.boxLevels.clear();
  EXPECT_FALSE(refinementLevels(unknown));
}

}
}
