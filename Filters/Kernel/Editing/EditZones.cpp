// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/EditZones.h"

#include "Base/DisjointSets.h"
#include "Base/Sorting.h"

#include <array>
#include <cmath>

namespace cartesian
{

namespace
{

constexpr std::size_t LeastCellsAZone = 3072;
constexpr std::size_t MostZones = 60000; // each has an arena of its own
constexpr std::size_t CellsAChunk = 4096;

// Cells next to fixed ones by so many faces are looked at in a later round: edits reach no farther, as a rule.
constexpr int Margin = 3;

// The last zones reach so far beyond what is left.
constexpr int Surroundings = 5;

// Where the curve begins in each round, by the extent of the mesh: then no two rounds have their zones end in the same
// places.
constexpr std::array<Vector, 3> Shifts{ Vector{ 0, 0, 0 }, Vector{ 0.2887, 0.3511, 0.3173 },
  Vector{ 0.1429, 0.1871, 0.4437 } };

struct PlaceOnCurve
{
  std::uint64_t key;
  std::uint32_t cell;

  bool operator<(const PlaceOnCurve& other) const
  {
    return key != other.key ? key < other.key : cell < other.cell;
  }
};

// Every third bit of 63.
std::uint64_t spread(std::uint64_t x)
{
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

// What one zone has in a round.
struct Zone
{
  std::size_t begin; // in the order of cells
  std::size_t end;
  std::vector<std::uint32_t> cells; // to be looked at
  std::size_t costly = 0;           // how many faces of theirs cost much
  FreeSlots slots;
};

class ZoneRounds
{
public:
  ZoneRounds(
    EditStore& store, Execution& execution, const std::function<void(const ZoneTask&)>& work)
    : store_(store)
    , execution_(execution)
    , work_(work)
    , isOver_(store.cells.size())
  {
    for (std::size_t c = 0; c < isOver_.size(); ++c)
    {
      isOver_[c] = isEditable(c) ? 0 : 1;
    }
  }

  void run()
  {
    for (const Vector& shift : Shifts)
    {
      divideByCurve(shift);
      look(Margin);
    }
    divideByGroups();
    look(0);
    for (EditCell& cell : store_.cells)
    {
      cell.zone = 0;
    }
  }

private:
  bool isEditable(std::size_t c) const
  {
    return !store_.cells[c].gone && store_.cells[c].state == CellState::Free;
  }

  bool isAnyLeft() const { return std::find(isOver_.begin(), isOver_.end(), 0) != isOver_.end(); }

  // --- zones

  void divideByCurve(const Vector& shift)
  {
    zones_.clear();
    order_.clear();
    if (!isAnyLeft())
    {
      return;
    }
    RawVector<PlaceOnCurve> places = placesOnCurve(shift);
    sortAll(places, execution_);
    const std::size_t count =
      std::max<std::size_t>(1, std::min(places.size() / LeastCellsAZone, MostZones));
    order_.resize(places.size());
    for (std::size_t z = 0; z < count; ++z)
    {
      zones_.push_back({ places.size() * z / count, places.size() * (z + 1) / count, {}, 0, {} });
    }
    execution_.forEach(count, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t z = begin; z < end; ++z)
      {
        for (std::size_t i = zones_[z].begin; i < zones_[z].end; ++i)
        {
          order_[i] = places[i].cell;
          store_.cells[places[i].cell].zone = static_cast<std::uint32_t>(z);
        }
        std::sort(order_.begin() + static_cast<std::ptrdiff_t>(zones_[z].begin),
          order_.begin() + static_cast<std::ptrdiff_t>(zones_[z].end));
      }
    });
  }

  RawVector<PlaceOnCurve> placesOnCurve(const Vector& shift) const
  {
    Vector low{ HUGE_VAL, HUGE_VAL, HUGE_VAL };
    Vector high = scaled(low, -1);
    std::size_t count = 0;
    for (std::size_t c = 0; c < store_.cells.size(); ++c)
    {
      for (std::size_t axis = 0; isEditable(c) && axis < 3; ++axis)
      {
        low[axis] = std::min(low[axis], store_.cells[c].centre[axis]);
        high[axis] = std::max(high[axis], store_.cells[c].centre[axis]);
      }
      count += isEditable(c) ? 1 : 0;
    }
    const Vector size = minus(high, low);
    const double extent = std::max({ size[0], size[1], size[2], 1e-9 });
    RawVector<PlaceOnCurve> places;
    places.reserve(count);
    for (std::size_t c = 0; c < store_.cells.size(); ++c)
    {
      if (isEditable(c))
      {
        std::uint64_t key = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          constexpr double Steps = 1 << 20;
          const double along = (store_.cells[c].centre[axis] - low[axis]) / extent + shift[axis];
          key |= spread(static_cast<std::uint64_t>(along * Steps)) << axis;
        }
        places.push_back({ key, static_cast<std::uint32_t>(c) });
      }
    }
    return places;
  }

  // Each connected group of what is left, with its surroundings.
  void divideByGroups()
  {
    zones_.clear();
    order_.clear();
    for (EditCell& cell : store_.cells)
    {
      cell.zone = None;
    }
    std::vector<std::uint32_t> members;
    std::vector<std::uint8_t> isMember(store_.cells.size(), 0);
    const auto add = [&](std::uint32_t c) {
      if (isMember[c] == 0 && isEditable(c))
      {
        isMember[c] = 1;
        members.push_back(c);
      }
    };
    for (std::uint32_t c = 0; c < isOver_.size(); ++c)
    {
      isOver_[c] == 0 ? add(c) : void();
    }
    std::size_t begin = 0;
    for (int ring = 0; ring < Surroundings; ++ring)
    {
      const std::size_t end = members.size();
      for (; begin < end; ++begin)
      {
        forEachBeside(members[begin], add);
      }
    }
    nameGroups(sortedUnique(std::move(members)));
  }

  void nameGroups(const std::vector<std::uint32_t>& members)
  {
    DisjointSets groups(store_.cells.size());
    for (const std::uint32_t c : members)
    {
      store_.cells[c].zone = 0;
    }
    for (const std::uint32_t c : members)
    {
      forEachBeside(c, [&](std::uint32_t other) {
        if (store_.cells[other].zone == 0)
        {
          groups.unite(c, other);
        }
      });
    }
    std::vector<std::array<std::uint32_t, 2>> byGroup;
    byGroup.reserve(members.size());
    for (const std::uint32_t c : members)
    {
      byGroup.push_back({ groups.find(c), c });
    }
    std::sort(byGroup.begin(), byGroup.end());
    for (std::size_t i = 0; i < byGroup.size(); ++i)
    {
      if (i == 0 || byGroup[i][0] != byGroup[i - 1][0])
      {
        zones_.push_back({ i, i, {}, 0, {} });
      }
      zones_.back().end = i + 1;
      store_.cells[byGroup[i][1]].zone = static_cast<std::uint32_t>(zones_.size() - 1);
      order_.push_back(byGroup[i][1]);
    }
  }

  template <class Visitor>
  void forEachBeside(std::uint32_t c, Visitor&& visit) const
  {
    for (const std::uint32_t f : listOf(store_.cells[c].faces))
    {
      const EditFace& face = store_.faces[f];
      const std::uint32_t other = face.below == c ? face.above : face.below;
      if (other != None)
      {
        visit(other);
      }
    }
  }

  Items listOf(const ItemList& list) const
  {
    const std::uint32_t* first = store_.arenas[list.arena].data() + list.first;
    return { first, first + list.size };
  }

  // --- a round

  void look(int margin)
  {
    if (zones_.empty())
    {
      return;
    }
    fix();
    chooseCells(margin);
    giveSlots();
    const std::size_t before = isOver_.size();
    store_.arenas.resize(1 + zones_.size());
    execution_.forEach(zones_.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t z = begin; z < end; ++z)
      {
        Zone& zone = zones_[z];
        EditMesh editor(store_, static_cast<std::uint32_t>(z), static_cast<std::uint16_t>(z + 1),
          std::move(zone.slots));
        const Items all{ order_.data() + zone.begin, order_.data() + zone.end };
        work_({ editor, zone.cells, all, isOver_ });
        zone.slots = editor.takeSlots();
      }
    });
    takeSlotsBack();
    isOver_.resize(std::max(before, store_.cells.size()), 1);
    for (const Zone& zone : zones_)
    {
      for (const std::uint32_t c : zone.cells)
      {
        isOver_[c] = 1;
      }
    }
    for (std::size_t c = 0; c < before; ++c)
    {
      isOver_[c] = store_.cells[c].gone ? 1 : isOver_[c];
    }
    store_.compact(execution_);
  }

  // Cells that share a node with another zone belong to none.
  void fix()
  {
    std::vector<std::uint8_t> isBetween(store_.nodes.size()); // of nodes
    execution_.forEach(store_.nodes.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
      {
        isBetween[n] = !store_.nodes[n].gone && isBetweenZones(store_.nodes[n]) ? 1 : 0;
      }
    });
    isFixed_.assign(store_.cells.size(), 0);
    execution_.forEach(order_.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        EditCell& cell = store_.cells[order_[i]];
        for (const std::uint32_t f : listOf(cell.faces))
        {
          for (const std::uint32_t n : listOf(store_.faces[f].corners))
          {
            isFixed_[order_[i]] |= isBetween[n];
          }
        }
        cell.zone = isFixed_[order_[i]] != 0 ? None : cell.zone;
      }
    });
  }

  bool isBetweenZones(const EditNode& node) const
  {
    std::uint32_t zone = None;
    bool isFirst = true;
    for (const std::uint32_t f : listOf(node.faces))
    {
      for (const std::uint32_t c : { store_.faces[f].below, store_.faces[f].above })
      {
        if (c == None || !isEditable(c))
        {
          continue;
        }
        if (!isFirst && store_.cells[c].zone != zone)
        {
          return true;
        }
        zone = store_.cells[c].zone;
        isFirst = false;
      }
    }
    return false;
  }

  void chooseCells(int margin)
  {
    execution_.forEach(zones_.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t z = begin; z < end; ++z)
      {
        const auto first = order_.begin() + static_cast<std::ptrdiff_t>(zones_[z].begin);
        const auto last = order_.begin() + static_cast<std::ptrdiff_t>(zones_[z].end);
        for (int ring = 1; ring <= margin; ++ring) // isFixed_: 1 + faces away from a fixed cell
        {
          std::for_each(first, last,
            [&](std::uint32_t c) { extendMargin(c, ring, static_cast<std::uint32_t>(z)); });
        }
        std::copy_if(first, last, std::back_inserter(zones_[z].cells),
          [&](std::uint32_t c) { return isFixed_[c] == 0 && isOver_[c] == 0; });
        zones_[z].costly = countCostly(zones_[z].cells);
      }
    });
  }

  std::size_t countCostly(const std::vector<std::uint32_t>& cells) const
  {
    std::size_t count = 0;
    for (const std::uint32_t c : cells)
    {
      for (const std::uint32_t f : listOf(store_.cells[c].faces))
      {
        count += store_.faces[f].cost > CostlyFrom ? 1 : 0;
      }
    }
    return count;
  }

  void extendMargin(std::uint32_t c, int ring, std::uint32_t zone)
  {
    if (isFixed_[c] == ring)
    {
      forEachBeside(c, [&](std::uint32_t other) {
        if (store_.cells[other].zone == zone && isFixed_[other] == 0)
        {
          isFixed_[other] = static_cast<std::uint8_t>(ring + 1);
        }
      });
    }
  }

  // --- slots

  void giveSlots()
  {
    const auto give = [](auto& all, std::vector<std::uint32_t>& spare, std::size_t count,
                        Slots& slots) {
      for (std::size_t i = 0; i < count; ++i)
      {
        if (spare.empty())
        {
          spare.push_back(static_cast<std::uint32_t>(all.size()));
          all.emplace_back().gone = true;
        }
        slots.numbers.push_back(spare.back());
        spare.pop_back();
      }
    };
    for (Zone& zone : zones_)
    {
      const std::size_t cells = zone.cells.size();
      give(store_.nodes, spareNodes_, LeastSlots + cells / 16 + 4 * zone.costly, zone.slots.nodes);
      give(store_.faces, spareFaces_, LeastSlots + cells / 16 + 6 * zone.costly, zone.slots.faces);
      give(store_.cells, spareCells_, LeastSlots + 2 * zone.costly, zone.slots.cells);
    }
  }

  void takeSlotsBack()
  {
    const auto take = [](const Slots& slots, std::vector<std::uint32_t>& spare) {
      spare.insert(spare.end(), slots.numbers.begin() + static_cast<std::ptrdiff_t>(slots.used),
        slots.numbers.end());
    };
    for (const Zone& zone : zones_)
    {
      take(zone.slots.nodes, spareNodes_);
      take(zone.slots.faces, spareFaces_);
      take(zone.slots.cells, spareCells_);
    }
  }

  static constexpr std::size_t LeastSlots = 64;
  static constexpr double CostlyFrom = 3;

  EditStore& store_;
  Execution& execution_;
  const std::function<void(const ZoneTask&)>& work_;
  std::vector<std::uint8_t> isOver_; // of cells
  std::vector<Zone> zones_;
  std::vector<std::uint32_t> order_;      // cells, by zones
  std::vector<std::uint8_t> isFixed_;     // of cells, and how near they are
  std::vector<std::uint32_t> spareNodes_; // gone, and not used
  std::vector<std::uint32_t> spareFaces_;
  std::vector<std::uint32_t> spareCells_;
};

}

void editInZones(
  EditStore& store, Execution& execution, const std::function<void(const ZoneTask&)>& work)
{
  ZoneRounds(store, execution, work).run();
}

}
