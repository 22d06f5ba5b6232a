// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/EditMesh.h"

#include "Base/Error.h"
#include "Base/Sorting.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <numeric>

namespace cartesian
{

namespace
{

constexpr std::size_t RecordsAChunk = 4096;

// Copies the lists of all records behind those that are in an arena already.
template <class Record>
void copyLists(RecordVector<Record>& all, const std::vector<RawVector<std::uint32_t>>& arenas,
  RawVector<std::uint32_t>& to, Execution& execution)
{
  std::vector<std::size_t> start(chunks(all.size(), RecordsAChunk) + 1, 0);
  execution.forEach(all.size(), RecordsAChunk, [&](std::size_t begin, std::size_t end) {
    std::size_t size = 0;
    for (std::size_t i = begin; i < end; ++i)
    {
      size += all[i].gone ? 0 : listOf(all[i]).size;
    }
    start[begin / RecordsAChunk + 1] = size;
  });
  start[0] = to.size();
  std::partial_sum(start.begin(), start.end(), start.begin());
  to.resize(start.back());
  execution.forEach(all.size(), RecordsAChunk, [&](std::size_t begin, std::size_t end) {
    std::size_t at = start[begin / RecordsAChunk];
    for (std::size_t i = begin; i < end; ++i)
    {
      ItemList& list = listOf(all[i]);
      list.size = all[i].gone ? std::uint16_t(0) : list.size;
      const std::uint32_t* from = arenas[list.arena].data() + list.first;
      std::copy_n(from, list.size, to.begin() + static_cast<std::ptrdiff_t>(at));
      list.first = static_cast<std::uint32_t>(at);
      list.arena = 0;
      at += list.size;
    }
  });
}

}

// A cell of 65,536 faces, or lists of a hundred million cells, do not fit.
ItemList listAt(std::size_t first, std::size_t size, std::uint16_t arena)
{
  if (first + size > std::numeric_limits<std::uint32_t>::max() ||
    size > std::numeric_limits<std::uint16_t>::max())
  {
    throw Error(Fault::TooManyBoxes,
      "A cell at the surface has too many faces, or there are too many such cells, to improve "
      "them. Try smaller cells or "
      "fewer triangles in the first case, larger cells in the second.");
  }
  return { static_cast<std::uint32_t>(first), static_cast<std::uint16_t>(size), arena };
}

// --- the mesh

void EditMesh::connect(Execution& execution)
{
  const auto cornersOf = [&](const EditFace& face) {
    const std::uint32_t* first = arenas[0].data() + face.corners.first;
    return Items{ first, first + face.corners.size };
  };
  const auto lists = fillBuckets<std::uint32_t>(
    faces.size(), RecordsAChunk, cells.size() + nodes.size(),
    [&](std::size_t begin, std::size_t end, auto&& add) {
      for (auto f = static_cast<std::uint32_t>(begin); f < end; ++f)
      {
        for (const std::uint32_t c : { faces[f].below, faces[f].above })
        {
          c != None ? add(c, f) : void();
        }
        for (const std::uint32_t n : cornersOf(faces[f]))
        {
          add(cells.size() + n, f);
        }
      }
    },
    execution);
  const std::size_t first = arenas[0].size();
  arenas[0].resize(first + lists.items.size());
  const auto copy = [&](std::size_t list) {
    std::copy(lists.begin(list), lists.end(list),
      arenas[0].begin() + static_cast<std::ptrdiff_t>(first + lists.start[list]));
    return listAt(first + lists.start[list], lists.start[list + 1] - lists.start[list], 0);
  };
  execution.forEach(cells.size(), RecordsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c)
    {
      cells[c].faces = copy(c);
    }
  });
  execution.forEach(nodes.size(), RecordsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      const std::size_t list = cells.size() + n;
      nodes[n].faces = copy(list);
      nodes[n].atWall = std::any_of(
        lists.begin(list), lists.end(list), [&](std::uint32_t f) { return isSurface(faces[f]); });
    }
  });
}

void EditMesh::compact(Execution& execution)
{
  RawVector<std::uint32_t> whole;
  whole.reserve(arenas[0].size());
  copyLists(nodes, arenas, whole, execution);
  copyLists(faces, arenas, whole, execution);
  copyLists(cells, arenas, whole, execution);
  arenas.resize(1);
  arenas[0] = std::move(whole);
}

void EditMesh::release(Execution& execution)
{
  // Braces alone would keep the memory.
  const auto free = [](auto& list) { list = std::decay_t<decltype(list)>(); };
  const std::array<std::function<void()>, 4> parts{ [&] { free(faces); }, [&] { free(nodes); },
    [&] { free(cells); }, [&] { free(arenas); } };
  execution.forEach(parts.size(), 1, [&](std::size_t i, std::size_t) { parts[i](); });
}

}
