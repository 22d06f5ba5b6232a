// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/ZoneSlots.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t RecordsAChunk = 1024;

template <class Visitor>
void forEach(std::size_t count, Execution& execution, Visitor&& visit)
{
  execution.forEach(count, RecordsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      visit(i);
    }
  });
}

// On all threads, where records have to move.
template <class Records>
void extend(Records& all, std::size_t size, Execution& execution)
{
  if (size <= all.capacity())
  {
    all.resize(size);
    return;
  }
  Records larger;
  larger.reserve(size + size / 4);
  larger.resize(size);
  forEach(all.size(), execution, [&](std::size_t i) { larger[i] = all[i]; });
  all.swap(larger);
}

// Of nodes, faces or cells.
template <class Record>
struct Kind
{
  RecordVector<Record> EditMesh::*all;
  Slots FreeSlots::*slots;
  std::size_t SlotCounts::*count;
};

// Spare ones first, the last of them before the others.
template <class Record>
void give(EditMesh& mesh, const Kind<Record>& kind, const std::vector<SlotCounts>& counts,
  std::vector<FreeSlots>& given, Execution& execution)
{
  RecordVector<Record>& all = mesh.*kind.all;
  std::vector<std::uint32_t>& spare = (mesh.spare.*kind.slots).numbers;
  std::size_t missing = 0;
  for (std::size_t z = 0; z < counts.size(); ++z)
  {
    const std::size_t count = counts[z].*kind.count;
    std::vector<std::uint32_t>& numbers = (given[z].*kind.slots).numbers;
    const std::size_t known = std::min(count, spare.size());
    numbers.assign(spare.rbegin(), spare.rbegin() + static_cast<std::ptrdiff_t>(known));
    spare.resize(spare.size() - known);
    for (std::size_t i = known; i < count; ++i)
    {
      numbers.push_back(static_cast<std::uint32_t>(all.size() + missing++));
    }
  }
  const std::size_t before = all.size();
  extend(all, before + missing, execution);
  forEach(missing, execution, [&](std::size_t i) {
    all[before + i] = {};
    all[before + i].gone = true;
  });
}

}

std::vector<FreeSlots> giveSlots(
  EditMesh& mesh, const std::vector<SlotCounts>& counts, Execution& execution)
{
  std::vector<FreeSlots> given(counts.size());
  give<EditNode>(
    mesh, { &EditMesh::nodes, &FreeSlots::nodes, &SlotCounts::nodes }, counts, given, execution);
  give<EditFace>(
    mesh, { &EditMesh::faces, &FreeSlots::faces, &SlotCounts::faces }, counts, given, execution);
  give<EditCell>(
    mesh, { &EditMesh::cells, &FreeSlots::cells, &SlotCounts::cells }, counts, given, execution);
  return given;
}

void takeSlotsBack(EditMesh& mesh, const std::vector<FreeSlots>& slots)
{
  for (const FreeSlots& some : slots)
  {
    for (Slots FreeSlots::*kind : { &FreeSlots::nodes, &FreeSlots::faces, &FreeSlots::cells })
    {
      const Slots& rest = some.*kind;
      std::vector<std::uint32_t>& spare = (mesh.spare.*kind).numbers;
      spare.insert(spare.end(), rest.numbers.begin() + static_cast<std::ptrdiff_t>(rest.used),
        rest.numbers.end());
    }
  }
}

}
