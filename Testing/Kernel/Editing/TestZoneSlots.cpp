// Numbers for what zones make: each once, none lost, the same on any threads.
#include "Editing/ZoneSlots.h"
#include "Support/EditMeshes.h"

#include <gtest/gtest.h>

#include <numeric>

namespace cartesian
{

namespace
{

using Numbers = std::vector<std::uint32_t>;

constexpr std::array<Slots FreeSlots::*, 3> Kinds{ &FreeSlots::nodes, &FreeSlots::faces,
  &FreeSlots::cells };

std::array<std::size_t, 3> sizesOf(const EditMesh& mesh)
{
  return { mesh.nodes.size(), mesh.faces.size(), mesh.cells.size() };
}

// In order.
Numbers allOf(const std::vector<FreeSlots>& slots, Slots FreeSlots::*kind)
{
  Numbers all;
  for (const FreeSlots& some : slots)
  {
    all.insert(all.end(), (some.*kind).numbers.begin(), (some.*kind).numbers.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

Numbers range(std::size_t begin, std::size_t end)
{
  Numbers numbers(end - begin);
  std::iota(numbers.begin(), numbers.end(), static_cast<std::uint32_t>(begin));
  return numbers;
}

template <class Record>
std::size_t goneFrom(const RecordVector<Record>& all, std::size_t begin)
{
  return static_cast<std::size_t>(std::count_if(all.begin() + static_cast<std::ptrdiff_t>(begin),
    all.end(), [](const Record& record) { return record.gone; }));
}

// More than one chunk of each kind.
const std::vector<SlotCounts> Many{ { 3000, 1, 700 }, { 0, 5000, 0 }, { 1, 0, 2500 },
  { 2200, 900, 1 } };

// Rounds of giving, using and taking back.
struct Rounds
{
  MeshEditor mesh = meshOfBoxes(blockOfBoxes(3, 2, 1));
  std::vector<Numbers> given;

  explicit Rounds(int threads)
  {
    Execution execution(threads);
    for (std::size_t round = 0; round < 4; ++round)
    {
      std::vector<FreeSlots> slots = giveSlots(mesh.mesh(), Many, execution);
      for (std::size_t z = 0; z < slots.size(); ++z)
      {
        for (Slots FreeSlots::*kind : Kinds)
        {
          Slots& some = slots[z].*kind;
          given.push_back(some.numbers);
          some.used = some.numbers.size() * (z + round) / 8;
        }
      }
      takeSlotsBack(mesh.mesh(), slots);
    }
  }
};

}

TEST(ZoneSlots, GivesEachNumberOnce)
{
  MeshEditor mesh = meshOfBoxes(blockOfBoxes(3, 2, 1));
  const MeshEditor before = copyOf(mesh);
  const auto had = sizesOf(mesh.mesh());
  Execution execution(2);
  const std::vector<FreeSlots> slots = giveSlots(mesh.mesh(), Many, execution);
  ASSERT_EQ(slots.size(), Many.size());
  for (std::size_t z = 0; z < Many.size(); ++z)
  {
    EXPECT_EQ(slots[z].nodes.numbers.size(), Many[z].nodes);
    EXPECT_EQ(slots[z].faces.numbers.size(), Many[z].faces);
    EXPECT_EQ(slots[z].cells.numbers.size(), Many[z].cells);
  }
  const auto has = sizesOf(mesh.mesh());
  for (std::size_t kind = 0; kind < 3; ++kind)
  {
    EXPECT_EQ(allOf(slots, Kinds[kind]), range(had[kind], has[kind]));
  }
  // What was there is the same; what is new is not there yet.
  EXPECT_EQ(differenceOf(mesh, before), "");
  EXPECT_EQ(goneFrom(mesh.mesh().nodes, had[0]), has[0] - had[0]);
  EXPECT_EQ(goneFrom(mesh.mesh().faces, had[1]), has[1] - had[1]);
  EXPECT_EQ(goneFrom(mesh.mesh().cells, had[2]), has[2] - had[2]);
  EXPECT_EQ(faultOf(mesh), "");
}

TEST(ZoneSlots, TakesBackWhatWasNotUsedZoneByZone)
{
  MeshEditor mesh = meshOfBoxes(blockOfBoxes(1, 1, 1)); // 8 nodes, 6 faces, a cell
  Execution execution(1);
  std::vector<FreeSlots> slots =
    giveSlots(mesh.mesh(), { { 3, 0, 1 }, { 2, 2, 0 }, { 1, 1, 2 } }, execution);
  slots[0].nodes.used = 1; // 8 of 8 9 10
  slots[1].nodes.used = 2; // all of 11 12
  slots[1].faces.used = 1; // 6 of 6 7
  slots[2].cells.used = 1; // 2 of 2 3
  takeSlotsBack(mesh.mesh(), slots);
  const FreeSlots& spare = mesh.mesh().spare;
  EXPECT_EQ(spare.nodes.numbers, (Numbers{ 9, 10, 13 }));
  EXPECT_EQ(spare.faces.numbers, (Numbers{ 7, 8 }));
  EXPECT_EQ(spare.cells.numbers, (Numbers{ 1, 3 }));
  for (Slots FreeSlots::*kind : Kinds)
  {
    EXPECT_EQ((spare.*kind).used, 0U);
  }
}

TEST(ZoneSlots, GivesSpareNumbersBeforeNewOnes)
{
  MeshEditor mesh = meshOfBoxes(blockOfBoxes(1, 1, 1));
  Execution execution(1);
  takeSlotsBack(mesh.mesh(), giveSlots(mesh.mesh(), { { 4, 4, 4 } }, execution));
  const auto had = sizesOf(mesh.mesh());
  EXPECT_EQ(had, (std::array<std::size_t, 3>{ 12, 10, 5 }));
  // The last ones first; more than there are of cells alone.
  const std::vector<FreeSlots> slots =
    giveSlots(mesh.mesh(), { { 2, 1, 3 }, { 1, 3, 3 } }, execution);
  EXPECT_EQ(slots[0].nodes.numbers, (Numbers{ 11, 10 }));
  EXPECT_EQ(slots[1].nodes.numbers, (Numbers{ 9 }));
  EXPECT_EQ(slots[0].faces.numbers, (Numbers{ 9 }));
  EXPECT_EQ(slots[1].faces.numbers, (Numbers{ 8, 7, 6 }));
  EXPECT_EQ(slots[0].cells.numbers, (Numbers{ 4, 3, 2 }));
  EXPECT_EQ(slots[1].cells.numbers, (Numbers{ 1, 5, 6 }));
  EXPECT_EQ(sizesOf(mesh.mesh()), (std::array<std::size_t, 3>{ 12, 10, 7 }));
  EXPECT_EQ(mesh.mesh().spare.nodes.numbers, (Numbers{ 8 }));
  EXPECT_TRUE(mesh.mesh().spare.faces.numbers.empty());
  EXPECT_TRUE(mesh.mesh().spare.cells.numbers.empty());
}

TEST(ZoneSlots, DoNotDependOnThreads)
{
  const Rounds one(1);
  for (const int threads : { 2, 5 })
  {
    SCOPED_TRACE(threads);
    const Rounds other(threads);
    EXPECT_EQ(other.given, one.given);
    EXPECT_EQ(differenceOf(other.mesh, one.mesh), "");
    for (Slots FreeSlots::*kind : Kinds)
    {
      EXPECT_EQ((other.mesh.mesh().spare.*kind).numbers, (one.mesh.mesh().spare.*kind).numbers);
    }
  }
}

// Over all rounds: numbers are used once, or spare; none is both, or neither.
TEST(ZoneSlots, LosesNone)
{
  MeshEditor mesh = meshOfBoxes(blockOfBoxes(3, 2, 1));
  std::array<Numbers, 3> known;
  const auto had = sizesOf(mesh.mesh());
  Execution execution(2);
  for (std::size_t round = 0; round < 5; ++round)
  {
    std::vector<FreeSlots> slots = giveSlots(mesh.mesh(), Many, execution);
    for (std::size_t kind = 0; kind < 3; ++kind)
    {
      for (std::size_t z = 0; z < slots.size(); ++z)
      {
        Slots& some = slots[z].*Kinds[kind];
        some.used = some.numbers.size() * (z + 1) / 7;
        known[kind].insert(known[kind].end(), some.numbers.begin(),
          some.numbers.begin() + static_cast<std::ptrdiff_t>(some.used));
      }
    }
    takeSlotsBack(mesh.mesh(), slots);
  }
  const auto has = sizesOf(mesh.mesh());
  for (std::size_t kind = 0; kind < 3; ++kind)
  {
    const Numbers& spare = (mesh.mesh().spare.*Kinds[kind]).numbers;
    known[kind].insert(known[kind].end(), spare.begin(), spare.end());
    std::sort(known[kind].begin(), known[kind].end());
    EXPECT_EQ(known[kind], range(had[kind], has[kind]));
  }
}

}
