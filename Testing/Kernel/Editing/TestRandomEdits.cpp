// A million edits at random: the mesh stays one, and all that is counted along the way is right.
#include "Editing/EditDecision.h"
#include "Support/EditMeshes.h"
#include "Support/Effort.h"
#include "Support/RandomEdits.h"

#include <gtest/gtest.h>

namespace cartesian
{

namespace
{

// What was committed, by the delta.
struct Totals
{
  double cost = 0;
  double volume = 0;
  int failures = 0;
  int strains = 0;

  static Totals of(const MeshEditor& mesh)
  {
    Totals totals{ sumOfCosts(mesh), volumeBehindWalls(mesh) };
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
    {
      totals.failures += mesh.face(f).gone ? 0 : int(mesh.face(f).fails);
      totals.strains += !mesh.face(f).gone && mesh.face(f).strains ? 1 : 0;
    }
    for (std::uint32_t c = 0; c < mesh.cellCount(); ++c)
    {
      totals.strains += !mesh.cell(c).gone && mesh.cell(c).strains ? 1 : 0;
    }
    return totals;
  }

  void add(const EditDelta& delta)
  {
    cost += delta.cost;
    volume += delta.volume;
    failures += delta.failures;
    strains += delta.strains;
  }
};

void expectNear(const Totals& counted, const Totals& now)
{
  EXPECT_NEAR(counted.cost, now.cost, 1e-9 * (1 + now.cost));
  EXPECT_NEAR(counted.volume, now.volume, 1e-12 * (1 + std::abs(now.volume)));
  EXPECT_EQ(counted.failures, now.failures);
  EXPECT_EQ(counted.strains, now.strains);
}

void expectTheSame(const MeshEditor& mesh, const Totals& totals)
{
  MeshEditor fresh = copyOf(mesh);
  measureAgain(fresh);
  const Totals now = Totals::of(fresh);
  expectNear(Totals::of(mesh), now);
  expectNear(totals, now);
  EXPECT_NEAR(volumeOf(mesh), volumeBehindWalls(mesh), 1e-12 * (1 + volumeOf(mesh)));
}

// Edits one mesh after another, each until hardly a cell is left of it.
class Editor
{
public:
  explicit Editor(unsigned seed)
    : random_(seed)
  {
  }

  void run(unsigned edits)
  {
    while (count_ < edits && !testing::Test::HasFailure())
    {
      MeshEditor mesh = randomMesh(random_);
      if (faultOf(mesh).empty()) // or nodes were moved too far
      {
        edit(mesh);
      }
    }
    for (const unsigned count : committed_)
    {
      EXPECT_GT(count, edits / 1000);
    }
  }

private:
  static constexpr unsigned EditsOfMesh = 4000;
  static constexpr unsigned EditsACheck = 1000;
  static constexpr unsigned UndosACheck = 64;

  // Cuts take longest.
  static constexpr std::array<int, 17> OftenAs{ 0, 0, 0, 1, 1, 1, 1, 2, 2, 3, 3, 4, 5, 6, 6, 6, 6 };

  static std::size_t countEditable(const MeshEditor& mesh)
  {
    std::size_t count = 0;
    for (std::uint32_t c = 0; c < mesh.cellCount() && count < 2; ++c)
    {
      count += mesh.isFree(c) ? 1 : 0;
    }
    return count;
  }

  void edit(MeshEditor& mesh)
  {
    Totals totals = Totals::of(mesh);
    for (unsigned i = 0; i < EditsOfMesh && countEditable(mesh) > 1; ++i)
    {
      editOnce(mesh, totals);
      if (count_ % EditsACheck == 0)
      {
        ASSERT_EQ(faultOf(mesh), "") << count_;
        expectTheSame(mesh, totals);
      }
    }
  }

  void editOnce(MeshEditor& mesh, Totals& totals)
  {
    const bool isChecked = ++count_ % UndosACheck == 0;
    const MeshEditor before = isChecked ? copyOf(mesh) : MeshEditor();
    const int kind = OftenAs[random_() % OftenAs.size()];
    const MeshEditor::Mark mark = mesh.mark();
    const bool isValid = RandomEdits(mesh, random_).make(kind) &&
      updateAndValidate(mesh, ObjectiveSpec()) && areAllClosed(mesh, mark);
    if (isValid && random_() % 4 == 0)
    {
      totals.add(mesh.delta);
      mesh.commit();
      ++committed_[std::size_t(kind)];
      return;
    }
    mesh.undo(mark);
    if (isChecked)
    {
      ASSERT_EQ(differenceOf(mesh, before), "") << "edit of kind " << kind;
    }
  }

  std::mt19937 random_;
  unsigned count_ = 0;
  std::array<unsigned, RandomEdits::Kinds> committed_{};
};

}

TEST(RandomEdits, KeepTheMeshOne)
{
  Editor(1).run(repeats(1000000));
}

}
