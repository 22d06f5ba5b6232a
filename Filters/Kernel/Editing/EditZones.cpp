// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/EditZones.h"

#include "Base/DisjointSets.h"
#include "Base/Sorting.h"
#include "Editing/ZoneDivision.h"
#include "Editing/ZoneSlots.h"

#include <array>
#include <atomic>
#include <numeric>

namespace cartesian
{

namespace
{

constexpr std::size_t LeastCellsAZone = 2048;
constexpr std::size_t MostArenas = 1 << 16; // each zone has one of its own
constexpr std::size_t MostZones = MostArenas - 1;
constexpr std::size_t ItemsAChunk = 1024;
constexpr std::size_t CellsASample = 16;

// The last zones reach so far beyond what is left.
constexpr int Surroundings = 5;

// ... and those around refused cells, which may touch others at nodes alone.
constexpr int SurroundingsByNodes = 3;

using Directions = std::array<Vector, 3>;

struct Round
{
  Directions across; // zones are divided: at right angles, and of one length
  int margin;        // cells next to fixed ones by so many faces are looked at in a later round
};

// In each round zones end across other directions, in other places than the others with few exceptions. Edits reach no
// farther than the first margins, as a rule; for the last cells less must do, so that few are left for one zone.
constexpr std::array<Round, 10> Rounds{
  Round{ { Vector{ 1, 0, 0 }, Vector{ 0, 1, 0 }, Vector{ 0, 0, 1 } }, 2 },
  Round{ { Vector{ 2, -1, 2 }, Vector{ 2, 2, -1 }, Vector{ -1, 2, 2 } }, 2 },
  Round{ { Vector{ 2, 3, 6 }, Vector{ 3, -6, 2 }, Vector{ 6, 2, -3 } }, 2 },
  Round{ { Vector{ 1, 4, 8 }, Vector{ 4, 7, -4 }, Vector{ 8, -4, 1 } }, 2 },
  Round{ { Vector{ 1, 2, 2 }, Vector{ 2, 1, -2 }, Vector{ 2, -2, 1 } }, 1 },
  Round{ { Vector{ 3, 2, 6 }, Vector{ -6, 3, 2 }, Vector{ 2, 6, -3 } }, 1 },
  Round{ { Vector{ 4, 4, 7 }, Vector{ 1, -8, 4 }, Vector{ 8, -1, -4 } }, 1 },
  Round{ { Vector{ 6, 2, 3 }, Vector{ -2, -3, 6 }, Vector{ 3, -6, -2 } }, 1 },
  Round{ { Vector{ 8, 1, 4 }, Vector{ -4, 4, 7 }, Vector{ -1, -8, 4 } }, 1 },
  Round{ { Vector{ 2, 6, 9 }, Vector{ 6, 7, -6 }, Vector{ -9, 6, -2 } }, 1 }
};

// Fewer cells than such a part of all are left for the last zones.
constexpr std::size_t FewOf = 64;

// What one zone has in a round.
struct Zone
{
  std::size_t begin; // in the order of cells
  std::size_t end;
  std::vector<std::uint32_t> cells; // to be looked at
  std::size_t costly = 0;           // how many faces of theirs cost much
};

class ZoneRounds
{
public:
  ZoneRounds(EditMesh& mesh, Execution& execution, const std::function<void(const ZoneTask&)>& work,
    bool looksAgain)
    : mesh_(mesh)
    , execution_(execution)
    , work_(work)
    , looksAgain_(looksAgain)
    , isDone_(mesh.cells.size(), 0)
  {
    listLeft();
  }

  void runAround(const std::vector<std::uint32_t>& cells)
  {
    std::fill(isDone_.begin(), isDone_.end(), 1);
    for (const std::uint32_t c : cells)
    {
      isDone_[c] = 0;
    }
    listLeft();
    divideByGroups(SurroundingsByNodes,
      [&](std::uint32_t c, auto&& visit) { view().forEachCellAround(c, visit); });
    look(0);
    setZones(0);
    mesh_.compact(execution_);
  }

  void run()
  {
    for (const Round& round : Rounds)
    {
      if (left_.size() * FewOf > isDone_.size())
      {
        divideByPlanes(round.across);
        look(round.margin);
      }
    }
    if (looksAgain_)
    {
      addFailing();
    }
    if (!left_.empty())
    {
      divideByGroups(Surroundings, [&](std::uint32_t c, auto&& visit) { forEachBeside(c, visit); });
      look(0);
    }
    setZones(0);
    mesh_.compact(execution_);
  }

private:
  bool isEditable(std::size_t c) const
  {
    return !mesh_.cells[c].gone && mesh_.cells[c].state == CellState::Free;
  }

  template <class Visitor>
  void forEach(std::size_t count, Visitor&& visit)
  {
    execution_.forEach(count, ItemsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        visit(static_cast<std::uint32_t>(i));
      }
    });
  }

  // What visit(i, found) finds, in order.
  template <class Item, class Visitor>
  std::vector<Item> find(std::size_t count, Visitor&& visit)
  {
    std::vector<std::vector<Item>> ofChunks(chunks(count, ItemsAChunk));
    forEach(count, [&](std::uint32_t i) { visit(i, ofChunks[i / ItemsAChunk]); });
    return concatenated(ofChunks);
  }

  void setZones(std::uint32_t zone)
  {
    forEach(mesh_.cells.size(), [&](std::uint32_t c) { mesh_.cells[c].zone = zone; });
  }

  // Cells that no zone has looked at; those made in a zone were looked at there.
  void listLeft()
  {
    isDone_.resize(mesh_.cells.size(), 1);
    left_ = find<std::uint32_t>(isDone_.size(), [&](std::uint32_t c, auto& found) {
      if (isDone_[c] == 0 && isEditable(c))
      {
        found.push_back(c);
      }
      else
      {
        isDone_[c] = 1;
      }
    });
  }

  // What still fails is looked at again, now with all its surroundings.
  void addFailing()
  {
    forEach(isDone_.size(), [&](std::uint32_t c) {
      if (isDone_[c] != 0 && isEditable(c))
      {
        const Items faces = view().facesOf(c);
        isDone_[c] = std::any_of(faces.begin(), faces.end(),
                       [&](std::uint32_t f) { return mesh_.faces[f].fails > 0; })
          ? 0
          : 1;
      }
    });
    listLeft();
  }

  // --- zones

  void divideByPlanes(const Directions& directions)
  {
    const auto placeOf = [&](std::uint32_t c) {
      const Vector& at = mesh_.cells[c].centre;
      return Vector{ dot(at, directions[0]), dot(at, directions[1]), dot(at, directions[2]) };
    };
    const std::vector<std::uint32_t> cells =
      find<std::uint32_t>(mesh_.cells.size(), [&](std::uint32_t c, auto& found) {
        if (isEditable(c))
        {
          found.push_back(c);
        }
      });
    const std::size_t count =
      std::max<std::size_t>(1, std::min(cells.size() / LeastCellsAZone, MostZones));
    std::vector<Vector> sample(chunks(cells.size(), CellsASample));
    forEach(sample.size(), [&](std::uint32_t i) { sample[i] = placeOf(cells[i * CellsASample]); });
    const ZoneDivision division(std::move(sample), count);
    forEach(cells.size(),
      [&](std::uint32_t i) { mesh_.cells[cells[i]].zone = division.zoneOf(placeOf(cells[i])); });
    const auto byZone = fillBuckets<std::uint32_t>(
      cells.size(), ItemsAChunk, count,
      [&](std::size_t begin, std::size_t end, auto&& add) {
        for (std::size_t i = begin; i < end; ++i)
        {
          add(mesh_.cells[cells[i]].zone, cells[i]);
        }
      },
      execution_);
    order_.assign(byZone.items.begin(), byZone.items.end());
    zones_.clear();
    for (std::size_t z = 0; z < count; ++z)
    {
      zones_.push_back({ byZone.start[z], byZone.start[z + 1], {}, 0 });
    }
  }

  // Each connected group of what is left, with so many rings around it. forEachNear(c, visit): what is in the ring of c.
  template <class ForEachNear>
  void divideByGroups(int rings, ForEachNear&& forEachNear)
  {
    setZones(None);
    std::vector<std::atomic<std::uint8_t>> isMember(mesh_.cells.size());
    forEach(left_.size(), [&](std::uint32_t i) { isMember[left_[i]] = 1; });
    std::vector<std::uint32_t> members = left_;
    std::size_t begin = 0;
    for (int ring = 0; ring < rings; ++ring)
    {
      const std::size_t first = begin;
      begin = members.size();
      const std::vector<std::uint32_t> more =
        find<std::uint32_t>(begin - first, [&](std::uint32_t i, auto& found) {
          forEachNear(members[first + i], [&](std::uint32_t c) {
            if (isEditable(c) && isMember[c].exchange(1, std::memory_order_relaxed) == 0)
            {
              found.push_back(c);
            }
          });
        });
      members.insert(members.end(), more.begin(), more.end());
    }
    sortAll(members, execution_);
    nameGroups(members, forEachNear);
  }

  template <class ForEachNear>
  void nameGroups(const std::vector<std::uint32_t>& members, ForEachNear&& forEachNear)
  {
    forEach(members.size(), [&](std::uint32_t i) { mesh_.cells[members[i]].zone = 0; });
    DisjointSets groups(mesh_.cells.size());
    for (const std::uint32_t c : members)
    {
      forEachNear(c, [&](std::uint32_t other) {
        if (other < c && mesh_.cells[other].zone == 0)
        {
          groups.unite(c, other);
        }
      });
    }
    std::vector<std::array<std::uint32_t, 2>> byGroup(members.size());
    for (std::size_t i = 0; i < members.size(); ++i)
    {
      byGroup[i] = { groups.find(members[i]), members[i] };
    }
    sortAll(byGroup, execution_);
    order_.resize(byGroup.size());
    zones_.clear();
    const std::size_t least =
      byGroup.size() / MostZones; // one zone has several groups if there are too many
    for (std::size_t i = 0; i < byGroup.size(); ++i)
    {
      const bool isFirst = i == 0 || byGroup[i][0] != byGroup[i - 1][0];
      if (zones_.empty() || (isFirst && i - zones_.back().begin >= least))
      {
        zones_.push_back({ i, i, {}, 0 });
      }
      zones_.back().end = i + 1;
      mesh_.cells[byGroup[i][1]].zone = static_cast<std::uint32_t>(zones_.size() - 1);
      order_[i] = byGroup[i][1];
    }
  }

  template <class Visitor>
  void forEachBeside(std::uint32_t c, Visitor&& visit) const
  {
    for (const std::uint32_t f : view().facesOf(c))
    {
      if (const std::uint32_t other = view().beyond(f, c); other != None)
      {
        visit(other);
      }
    }
  }

  MeshView view() const { return MeshView(mesh_); }

  // --- a round

  void look(int margin)
  {
    fix();
    chooseCells(margin);
    std::vector<FreeSlots> slots = giveSlots(mesh_, slotCounts(), execution_);
    // Lists stay in the arenas of zones that made them, as long as there are numbers for more.
    if (mesh_.arenas.size() + zones_.size() > MostArenas)
    {
      mesh_.compact(execution_);
    }
    const std::size_t firstArena = mesh_.arenas.size();
    mesh_.arenas.resize(firstArena + zones_.size());
    const std::vector<std::uint32_t> order = byCost();
    execution_.nextLoop(ShareOfRound);
    execution_.forEach(order.size(), 1, [&](std::size_t i, std::size_t) {
      const std::uint32_t z = order[i];
      const Zone& zone = zones_[z];
      MeshEditor editor(mesh_, z, static_cast<std::uint16_t>(firstArena + z), std::move(slots[z]));
      const Items all{ order_.data() + zone.begin, order_.data() + zone.end };
      work_({ editor, zone.cells, all, isDone_ });
      slots[z] = editor.takeSlots();
    });
    takeSlotsBack(mesh_, slots);
    execution_.forEach(zones_.size(), 1, [&](std::size_t z, std::size_t) {
      for (const std::uint32_t c : zones_[z].cells)
      {
        isDone_[c] = 1;
      }
    });
    listLeft();
  }

  std::vector<SlotCounts> slotCounts() const
  {
    std::vector<SlotCounts> counts;
    for (const Zone& zone : zones_)
    {
      const std::size_t few = LeastSlots + zone.cells.size() / 16;
      counts.push_back(
        { few + 4 * zone.costly, few + 6 * zone.costly, LeastSlots + 2 * zone.costly });
    }
    return counts;
  }

  // So that no thread still works at a large one when the others have ended.
  std::vector<std::uint32_t> byCost() const
  {
    const auto work = [&](std::uint32_t z) {
      return zones_[z].cells.size() + CostlyByCell * zones_[z].costly;
    };
    std::vector<std::uint32_t> order(zones_.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return work(a) != work(b) ? work(a) > work(b) : a < b;
    });
    return order;
  }

  // Cells that share a node with another zone belong to none.
  void fix()
  {
    markNodes();
    isFixed_ = std::vector<std::atomic<std::uint8_t>>(mesh_.cells.size());
    forEach(mesh_.nodes.size(), [&](std::uint32_t n) {
      if (marks_[n].load(std::memory_order_relaxed) != Between)
      {
        return;
      }
      for (const std::uint32_t f : view().facesAround(n))
      {
        for (const std::uint32_t c : { mesh_.faces[f].below, mesh_.faces[f].above })
        {
          c != None ? isFixed_[c].store(1, std::memory_order_relaxed) : void();
        }
      }
    });
    forEach(order_.size(), [&](std::uint32_t i) {
      EditCell& cell = mesh_.cells[order_[i]];
      cell.zone = isFixed_[order_[i]] != 0 ? None : cell.zone;
    });
  }

  // Between two zones, or a zone and what is in none: nodes of a face that has one on each side; and those with ends, walls
  // or faces of what cannot be edited, of several, which touch there without a face between them.
  void markNodes()
  {
    RawVector<std::uint32_t> markOf(mesh_.cells.size());
    forEach(markOf.size(), [&](std::uint32_t c) {
      const std::uint32_t zone = mesh_.cells[c].zone;
      markOf[c] = !isEditable(c) ? NotEditable : zone == None ? InNone : FirstZone + zone;
    });
    marks_ = std::vector<std::atomic<std::uint32_t>>(mesh_.nodes.size());
    forEach(mesh_.faces.size(), [&](std::uint32_t f) {
      const EditFace& face = mesh_.faces[f];
      const std::uint32_t below = face.gone ? NotEditable : markOf[face.below];
      const std::uint32_t above =
        face.gone || face.above == None ? NotEditable : markOf[face.above];
      if (below == above)
      {
        return;
      }
      const bool isEnd = below == NotEditable || above == NotEditable;
      for (const std::uint32_t n : view().cornersOf(f))
      {
        isEnd ? markEnd(n, std::max(below, above))
              : marks_[n].store(Between, std::memory_order_relaxed);
      }
    });
  }

  void markEnd(std::uint32_t n, std::uint32_t mark)
  {
    std::uint32_t before = marks_[n].load(std::memory_order_relaxed);
    while (before != mark && before != Between &&
      !marks_[n].compare_exchange_weak(
        before, before == NotEditable ? mark : Between, std::memory_order_relaxed))
    {
    }
  }

  void chooseCells(int margin)
  {
    execution_.forEach(zones_.size(), 1, [&](std::size_t z, std::size_t) {
      const auto first = order_.begin() + static_cast<std::ptrdiff_t>(zones_[z].begin);
      const auto last = order_.begin() + static_cast<std::ptrdiff_t>(zones_[z].end);
      for (int ring = 1; ring <= margin; ++ring) // isFixed_: 1 + faces away from a fixed cell
      {
        std::for_each(first, last,
          [&](std::uint32_t c) { extendMargin(c, ring, static_cast<std::uint32_t>(z)); });
      }
      std::copy_if(first, last, std::back_inserter(zones_[z].cells),
        [&](std::uint32_t c) { return isFixed_[c] == 0 && isDone_[c] == 0; });
      zones_[z].costly = countCostly(zones_[z].cells);
    });
  }

  std::size_t countCostly(const std::vector<std::uint32_t>& cells) const
  {
    std::size_t count = 0;
    for (const std::uint32_t c : cells)
    {
      for (const std::uint32_t f : view().facesOf(c))
      {
        count += mesh_.faces[f].cost > CostlyFrom ? 1 : 0;
      }
    }
    return count;
  }

  void extendMargin(std::uint32_t c, int ring, std::uint32_t zone)
  {
    if (isFixed_[c] == ring)
    {
      forEachBeside(c, [&](std::uint32_t other) {
        if (mesh_.cells[other].zone == zone && isFixed_[other] == 0)
        {
          isFixed_[other] = static_cast<std::uint8_t>(ring + 1);
        }
      });
    }
  }

  // Marks of nodes and cells.
  static constexpr std::uint32_t NotEditable = 0; // or unknown
  static constexpr std::uint32_t Between = 1;
  static constexpr std::uint32_t InNone = 2;
  static constexpr std::uint32_t FirstZone = 3;

  static constexpr double ShareOfRound = 0.35; // of what is left of the stage: for its progress
  static constexpr std::size_t LeastSlots = 64;
  static constexpr double CostlyFrom = 3;
  static constexpr std::size_t CostlyByCell = 4; // what it takes to look at a costly face

  EditMesh& mesh_;
  Execution& execution_;
  const std::function<void(const ZoneTask&)>& work_;
  bool looksAgain_;
  std::vector<std::uint8_t> isDone_; // of cells
  std::vector<std::uint32_t> left_;  // those that are not
  std::vector<Zone> zones_;
  std::vector<std::uint32_t> order_;               // cells, by zones
  std::vector<std::atomic<std::uint32_t>> marks_;  // of nodes
  std::vector<std::atomic<std::uint8_t>> isFixed_; // of cells, and how near they are
};

}

void editInZones(EditMesh& mesh, Execution& execution,
  const std::function<void(const ZoneTask&)>& work, bool looksAgain)
{
  ZoneRounds(mesh, execution, work, looksAgain).run();
}

void editInGroups(EditMesh& mesh, Execution& execution, const std::vector<std::uint32_t>& cells,
  const std::function<void(const ZoneTask&)>& work)
{
  ZoneRounds(mesh, execution, work, false).runAround(cells);
}

}
