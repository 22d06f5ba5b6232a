// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/WallRing.h"

#include <algorithm>

namespace cartesian
{

namespace
{

class RingSearch
{
public:
  explicit RingSearch(const MeshParts& parts)
    : parts_(parts)
    , boxes_(parts.boxes)
    , sides_(parts.sides)
    , wall_(parts.wall)
    , marked_(parts.nodes.at.size())
    , chosen_(parts.wall.size())
  {
  }

  std::vector<CellKey> run()
  {
    chooseAtWalls();
    choosePolyhedra();
    chooseDivided();
    chooseUndivided();
    for (std::uint32_t c = 0; c < wall_.size(); ++c)
    {
      if (chosen_[c])
      {
        keys_.push_back(c);
      }
    }
    std::sort(keys_.begin(), keys_.end(), [&](CellKey a, CellKey b) {
      const std::uint32_t x = boxOf(wall_, a);
      const std::uint32_t y = boxOf(wall_, b);
      return x != y ? x < y : a < b;
    });
    sortWithinBoxes();
    return std::move(keys_);
  }

private:
  void chooseAtWalls()
  {
    for (std::size_t n = 0; n < sides_.polyhedral.size(); ++n)
    {
      for (std::size_t c = wall_.boxStart[n]; c < wall_.boxStart[n + 1]; ++c)
      {
        chosen_[c] = !wall_.cells[c].removed && (sides_.patchBox[n] != None || isAtWall(c));
        if (chosen_[c])
        {
          wall_.forEachNodeOf(c, [&](std::uint32_t node) { marked_[node] = 1; });
          seeds_.push_back(sides_.polyhedral[n]);
        }
      }
    }
    seeds_.erase(std::unique(seeds_.begin(), seeds_.end()), seeds_.end());
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

  void choosePolyhedra()
  {
    for (std::size_t c = 0; c < wall_.size(); ++c)
    {
      if (!chosen_[c] && !wall_.cells[c].removed)
      {
        wall_.forEachNodeOf(
          c, [&](std::uint32_t node) { chosen_[c] = chosen_[c] | marked_[node]; });
      }
    }
  }

  void chooseDivided()
  {
    for (std::size_t i = 0; i < sides_.divided.size(); ++i)
    {
      const auto& corners = parts_.nodes.ofDivided[i];
      if (sides_.polyhedralOrdinal(sides_.divided[i]) == None &&
        std::any_of(
          corners.begin(), corners.end(), [&](std::uint32_t node) { return marked_[node] != 0; }))
      {
        keys_.push_back(keyOfHexahedron(sides_.divided[i]));
      }
    }
  }

  // All that touch a cell at a wall are in global boxes around its own.
  void chooseUndivided()
  {
    std::vector<std::uint8_t> seen(boxes_.globals.size());
    for (const std::uint32_t seed : seeds_)
    {
      const auto& at = boxes_.globalOf(boxes_.packed[seed]).index;
      for (int i = 0; i < 27; ++i)
      {
        const std::uint32_t global = boxes_.globalAt(std::int64_t(at[0]) + i % 3 - 1,
          std::int64_t(at[1]) + i / 3 % 3 - 1, std::int64_t(at[2]) + i / 9 - 1);
        if (global != None && seen[global] == 0)
        {
          seen[global] = 1;
          chooseUndivided(boxes_.globals[global].firstBox);
        }
      }
    }
  }

  void chooseUndivided(std::uint32_t box)
  {
    bool touches = false;
    for (unsigned corner = 0; sides_.ordinal[box] == None && corner < 8 && !touches; ++corner)
    {
      const std::uint32_t node = nodeOfCorner(boxes_, sides_, parts_.nodes, box, corner);
      touches = node != None && marked_[node] != 0;
    }
    if (touches)
    {
      keys_.push_back(keyOfHexahedron(box));
    }
  }

  void sortWithinBoxes()
  {
    for (std::size_t begin = 0, end = 0; begin < keys_.size(); begin = end)
    {
      for (end = begin + 1;
           end < keys_.size() && boxOf(wall_, keys_[end]) == boxOf(wall_, keys_[begin]); ++end)
      {
      }
      if (end - begin > 1)
      {
        sortByPlaces(begin, end);
      }
    }
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
  std::vector<std::uint8_t> marked_; // nodes of cells at walls
  std::vector<std::uint8_t> chosen_; // cells of polyhedral boxes
  std::vector<std::uint32_t> seeds_; // boxes of cells at walls
  std::vector<CellKey> keys_;
};

}

std::vector<CellKey> cellsToEdit(const MeshParts& parts)
{
  return RingSearch(parts).run();
}

}
