// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/NearWallSelection.h"

#include "Base/Sorting.h"

#include <atomic>

namespace cartesian
{

namespace
{

constexpr std::size_t ItemsAChunk = 1024;

class RingSearch
{
public:
  RingSearch(const MeshParts& parts, Execution& execution)
    : parts_(parts)
    , boxes_(parts.boxes)
    , sides_(parts.sides)
    , wall_(parts.wall)
    , execution_(execution)
    , marked_(parts.nodes.at.size())
    , nearby_(boxes_.globals.size())
    , chosen_(parts.wall.size())
  {
  }

  std::vector<CellKey> run()
  {
    chooseAtWalls();
    choosePolyhedra();
    chooseDivided();
    chooseUndivided();
    sortAll(found_, execution_);
    keys_.resize(found_.size());
    forEach(found_.size(), [&](std::size_t i) { keys_[i] = static_cast<CellKey>(found_[i]); });
    sortWithinBoxes();
    return std::move(keys_);
  }

private:
  using Found = std::vector<std::uint64_t>; // box and key: in this order

  template <class Visitor>
  void forEach(std::size_t count, Visitor&& visit)
  {
    execution_.forEach(count, ItemsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        visit(i);
      }
    });
  }

  // visit(i, found) lists what is chosen.
  template <class Visitor>
  void find(std::size_t count, Visitor&& visit)
  {
    std::vector<Found> ofChunks(chunks(count, ItemsAChunk));
    execution_.forEach(count, ItemsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        visit(i, ofChunks[begin / ItemsAChunk]);
      }
    });
    for (const Found& found : ofChunks)
    {
      found_.insert(found_.end(), found.begin(), found.end());
    }
  }

  static void add(std::uint32_t box, CellKey key, Found& found)
  {
    found.push_back(std::uint64_t(box) << 32 | key);
  }

  void chooseAtWalls()
  {
    forEach(sides_.polyhedral.size(), [&](std::size_t n) {
      bool isAny = false;
      for (std::size_t c = wall_.boxStart[n]; c < wall_.boxStart[n + 1]; ++c)
      {
        chosen_[c] = !wall_.cells[c].removed && (sides_.patchBox[n] != None || isAtWall(c));
        if (chosen_[c])
        {
          wall_.forEachNodeOf(
            c, [&](std::uint32_t node) { marked_[node].store(1, std::memory_order_relaxed); });
          isAny = true;
        }
      }
      if (isAny)
      {
        markGlobalsAround(sides_.polyhedral[n]);
      }
    });
  }

  // All boxes that touch one are in global boxes around its own.
  void markGlobalsAround(std::uint32_t box)
  {
    const auto& at = boxes_.globalOf(boxes_.packed[box]).index;
    for (int i = 0; i < 27; ++i)
    {
      const std::uint32_t global = boxes_.globalAt(std::int64_t(at[0]) + i % 3 - 1,
        std::int64_t(at[1]) + i / 3 % 3 - 1, std::int64_t(at[2]) + i / 9 - 1);
      if (global != None)
      {
        nearby_[global].store(1, std::memory_order_relaxed);
      }
    }
  }

  // Beside a cell that was removed, or a box without cells.
  bool isAtWall(std::size_t c) const
  {
    bool is = false;
    wall_.forEachUse(c, [&](const FaceUse& use) {
      const CellKey other = wall_.faces.beyond(use);
      is = is ||
        (other == None ? wall_.faces.boundary[use.face] != NoBoundary : wall_.isRemoved(other));
    });
    return is;
  }

  bool isMarked(std::uint32_t node) const
  {
    return marked_[node].load(std::memory_order_relaxed) != 0;
  }

  void choosePolyhedra()
  {
    find(wall_.size(), [&](std::size_t c, Found& found) {
      bool is = chosen_[c] != 0;
      if (!is && !wall_.cells[c].removed)
      {
        wall_.forEachNodeOf(c, [&](std::uint32_t node) { is = is || isMarked(node); });
      }
      if (is)
      {
        add(wall_.cells[c].box, static_cast<CellKey>(c), found);
      }
    });
  }

  void chooseDivided()
  {
    find(sides_.divided.size(), [&](std::size_t i, Found& found) {
      const std::uint32_t box = sides_.divided[i];
      const auto& corners = parts_.nodes.ofDivided[i];
      if (sides_.polyhedralOrdinal(box) == None &&
        std::any_of(
          corners.begin(), corners.end(), [&](std::uint32_t node) { return isMarked(node); }))
      {
        add(box, keyOfHexahedron(box), found);
      }
    });
  }

  void chooseUndivided()
  {
    find(boxes_.globals.size() - 1, [&](std::size_t global, Found& found) {
      if (nearby_[global].load(std::memory_order_relaxed) != 0)
      {
        chooseUndivided(boxes_.globals[global].firstBox, found);
      }
    });
  }

  void chooseUndivided(std::uint32_t box, Found& found) const
  {
    bool touches = false;
    for (unsigned corner = 0; sides_.ordinal[box] == None && corner < 8 && !touches; ++corner)
    {
      const std::uint32_t node = nodeOfCorner(boxes_, sides_, parts_.nodes, box, corner);
      touches = node != None && isMarked(node);
    }
    if (touches)
    {
      add(box, keyOfHexahedron(box), found);
    }
  }

  void sortWithinBoxes()
  {
    const auto boxAt = [&](std::size_t i) { return found_[i] >> 32; };
    forEach(keys_.size(), [&](std::size_t begin) {
      std::size_t end = begin + 1;
      for (; end < keys_.size() && boxAt(end) == boxAt(begin); ++end)
      {
      }
      if (end - begin > 1 && (begin == 0 || boxAt(begin - 1) != boxAt(begin)))
      {
        sortByPlaces(begin, end);
      }
    });
  }

  void sortByPlaces(std::size_t begin, std::size_t end)
  {
    std::vector<std::pair<std::vector<Point>, CellKey>> cells;
    for (std::size_t i = begin; i < end; ++i)
    {
      cells.push_back({ {}, keys_[i] });
      std::vector<Point>& places = cells.back().first;
      wall_.forEachNodeOf(
        keys_[i], [&](std::uint32_t node) { places.push_back(parts_.nodes.at[node]); });
      std::sort(places.begin(), places.end());
    }
    std::sort(cells.begin(), cells.end());
    for (std::size_t i = begin; i < end; ++i)
    {
      keys_[i] = cells[i - begin].second;
    }
  }

  const MeshParts& parts_;
  const Boxes& boxes_;
  const Sides& sides_;
  const WallMesh& wall_;
  Execution& execution_;
  std::vector<std::atomic<std::uint8_t>> marked_; // nodes of cells at walls
  std::vector<std::atomic<std::uint8_t>> nearby_; // global boxes around those of cells at walls
  std::vector<std::uint8_t> chosen_;              // cells at walls
  Found found_;
  std::vector<CellKey> keys_;
};

}

std::vector<CellKey> cellsToEdit(const MeshParts& parts, Execution& execution)
{
  return RingSearch(parts, execution).run();
}

}
