// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/EditBlocks.h"

#include "Base/Sorting.h"
#include "Editing/EditBlockDivision.h"
#include "Editing/Marks.h"
#include "Editing/ZoneSlots.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <numeric>

namespace cartesian
{

namespace
{

constexpr std::size_t ItemsAChunk = 1024;

// What a thread keeps from block to block.
struct Lane
{
  explicit Lane(EditMesh& mesh)
    : editor(mesh, 0, 0, {})
  {
  }

  MeshEditor editor;
  LoopMemory memory;
  Marks boxes;
  ValuesByNumber<std::uint32_t> sides; // of faces at nodes
  std::vector<std::uint32_t> listed;   // nodes
  Marks borderNodes;
};

class Lanes
{
public:
  Lanes(EditMesh& mesh, int count)
  {
    for (int i = 0; i < count; ++i)
    {
      free_.push_back(std::make_unique<Lane>(mesh));
    }
  }

  // Calls work with one that no other thread has.
  template <class Work>
  void with(Work&& work)
  {
    std::unique_ptr<Lane> lane = take();
    work(*lane);
    const std::lock_guard<std::mutex> lock(mutex_);
    free_.push_back(std::move(lane));
  }

private:
  std::unique_ptr<Lane> take()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::unique_ptr<Lane> lane = std::move(free_.back());
    free_.pop_back();
    return lane;
  }

  std::mutex mutex_;
  std::vector<std::unique_ptr<Lane>> free_;
};

}

class BlockEditing::State
{
public:
  State(EditMesh& mesh, Execution& execution)
    : mesh_(mesh)
    , view_(mesh)
    , execution_(execution)
    , lanes_(mesh, execution.threads())
  {
    listBoxes();
  }

  void finish() { mesh_.compact(execution_); }

  std::vector<std::uint32_t> allCells() const
  {
    std::vector<std::uint32_t> all(mesh_.cells.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
  }

  void edit(
    const std::vector<std::uint32_t>& cells, const EditBlockSize& size, const ZoneWork& work)
  {
    const std::vector<AskedBox> asked = markAsked(cells);
    if (asked.empty())
    {
      execution_.nextLoop(ShareOfEdit);
      execution_.forEach(1, 1, [](std::size_t, std::size_t) {}); // progress goes on
      return;
    }
    divide(asked, size);
    giveArenas();
    setTurns();
    slots_ = giveSlots(mesh_, slotCounts(size), execution_);
    boxOf_.resize(mesh_.cells.size(), None);
    execution_.nextLoop(ShareOfEdit);
    execution_.forEachInOrder(division_.after,
      [&](std::uint32_t b) { lanes_.with([&](Lane& lane) { editBlock(b, work, lane); }); });
    takeSlotsBack(mesh_, slots_);
    forEach(mesh_.cells.size(), [&](std::uint32_t c) { mesh_.cells[c].zone = 0; });
  }

private:
  bool isEditable(std::uint32_t c) const
  {
    return !mesh_.cells[c].gone && mesh_.cells[c].state == CellState::Free;
  }

  Items facesOf(std::uint32_t c) const
  {
    return mesh_.cells[c].gone ? Items{ nullptr, nullptr } : view_.facesOf(c);
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

  // --- boxes: those that have cells, by number

  void listBoxes()
  {
    using OfBox = std::array<std::uint32_t, 2>; // its index, and the cell
    std::vector<std::vector<OfBox>> ofChunks(chunks(mesh_.cells.size(), ItemsAChunk));
    forEach(mesh_.cells.size(), [&](std::uint32_t c) {
      if (!mesh_.cells[c].gone && mesh_.cells[c].state != CellState::Ghost)
      {
        ofChunks[c / ItemsAChunk].push_back({ mesh_.cells[c].boxIndex, c });
      }
    });
    std::vector<OfBox> all = concatenated(ofChunks);
    sortAll(all, execution_);
    boxOf_.assign(mesh_.cells.size(), None);
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      if (i == 0 || all[i][0] != all[i - 1][0])
      {
        indices_.push_back(all[i][0]);
        cellsOf_.emplace_back();
        places_.push_back(mesh_.cells[all[i][1]].place);
      }
      cellsOf_.back().push_back(all[i][1]);
      boxOf_[all[i][1]] = static_cast<std::uint32_t>(cellsOf_.size() - 1);
    }
  }

  // Those that have cells which touch cells of a box, at nodes; some several times.
  void listBeside(std::uint32_t box, Marks& nodes, std::vector<std::uint32_t>& beside) const
  {
    nodes.begin();
    forEachNode(cellsOf_[box], nodes, [&](std::uint32_t n) {
      forEachCellAt(
        n, [&](std::uint32_t c) { boxOf_[c] != None ? beside.push_back(boxOf_[c]) : void(); });
    });
  }

  // Of cells, each node once.
  template <class Visitor>
  void forEachNode(const std::vector<std::uint32_t>& cells, Marks& seen, Visitor&& visit) const
  {
    for (const std::uint32_t c : cells)
    {
      for (const std::uint32_t f : facesOf(c))
      {
        for (const std::uint32_t n : view_.cornersOf(f))
        {
          seen.mark(n) ? visit(n) : void();
        }
      }
    }
  }

  // Some several times.
  template <class Visitor>
  void forEachCellAt(std::uint32_t n, Visitor&& visit) const
  {
    for (const std::uint32_t f : view_.facesAround(n))
    {
      visit(view_.face(f).below);
      view_.isWall(f) ? void() : visit(view_.face(f).above);
    }
  }

  // --- blocks

  void divide(const std::vector<AskedBox>& asked, EditBlockSize size)
  {
    const Beside beside = [&](std::uint32_t box, Marks& nodes, std::vector<std::uint32_t>& found) {
      listBeside(box, nodes, found);
    };
    do
    {
      division_ = divideIntoEditBlocks(places_, asked, size, beside, execution_);
      size.width *= 2;
    } while (division_.blocks.size() >= MostArenas);
  }

  // Each block has one of its own, which stays where it is while others read its lists.
  void giveArenas()
  {
    if (mesh_.arenas.size() + division_.blocks.size() > MostArenas)
    {
      mesh_.compact(execution_);
    }
    firstArena_ = mesh_.arenas.size();
    mesh_.arenas.resize(firstArena_ + division_.blocks.size());
  }

  std::vector<AskedBox> markAsked(const std::vector<std::uint32_t>& cells)
  {
    std::vector<std::uint32_t> weights(cellsOf_.size(), 0);
    turns_.assign(mesh_.cells.size(), 0);
    for (const std::uint32_t c : cells)
    {
      if (boxOf_[c] != None && isEditable(c))
      {
        weights[boxOf_[c]] += 1 + static_cast<std::uint32_t>(costlyFaces(c));
        turns_[c] = 1;
      }
    }
    std::vector<AskedBox> asked;
    for (std::uint32_t box = 0; box < weights.size(); ++box)
    {
      weights[box] != 0 ? asked.push_back({ box, weights[box] }) : void();
    }
    return asked;
  }

  static std::uint32_t turnOf(std::size_t block) { return static_cast<std::uint32_t>(block + 1); }

  void setTurns()
  {
    execution_.forEach(division_.blocks.size(), 1, [&](std::size_t b, std::size_t) {
      for (const std::uint32_t box : division_.blocks[b].own)
      {
        for (const std::uint32_t c : cellsOf_[box])
        {
          turns_[c] = turns_[c] != 0 ? turnOf(b) : 0;
        }
      }
    });
  }

  std::vector<SlotCounts> slotCounts(const EditBlockSize& size) const
  {
    std::vector<SlotCounts> counts;
    for (const EditBlock& block : division_.blocks)
    {
      std::size_t cells = 0;
      std::size_t costly = 0; // faces
      for (const std::uint32_t box : block.own)
      {
        for (const std::uint32_t c : cellsOf_[box])
        {
          cells += turns_[c] != 0 ? 1 : 0;
          costly += turns_[c] != 0 ? costlyFaces(c) : 0;
        }
      }
      const std::size_t few = LeastSlots + cells / 16;
      const std::size_t made = size.mostMade * costly; // cells
      counts.push_back({ few + 2 * made, few + 3 * made, LeastSlots + made });
    }
    return counts;
  }

  std::size_t costlyFaces(std::uint32_t c) const
  {
    const Items faces = view_.facesOf(c);
    return static_cast<std::size_t>(std::count_if(faces.begin(), faces.end(),
      [&](std::uint32_t f) { return view_.face(f).cost > CostlyFrom; }));
  }

  void editBlock(std::uint32_t b, const ZoneWork& work, Lane& lane)
  {
    const std::vector<std::uint32_t> zone = freeCells(division_.blocks[b], lane);
    for (const std::uint32_t c : zone)
    {
      mesh_.cells[c].zone = turnOf(b);
    }
    std::vector<std::uint32_t> cells;
    std::copy_if(zone.begin(), zone.end(), std::back_inserter(cells),
      [&](std::uint32_t c) { return c < turns_.size() && turns_[c] == turnOf(b); });
    lane.editor.enter(turnOf(b), static_cast<std::uint16_t>(firstArena_ + b), std::move(slots_[b]));
    const Items all{ zone.data(), zone.data() + zone.size() };
    work({ lane.editor, lane.memory, cells, all, turns_, turnOf(b) });
    noteMade(lane.editor.madeCells());
    slots_[b] = lane.editor.takeSlots();
  }

  // Those in a zone that share no node with one that is not: no other editor changes what touches them.
  std::vector<std::uint32_t> freeCells(const EditBlock& block, Lane& lane) const
  {
    lane.boxes.begin();
    for (const std::uint32_t box : block.zone)
    {
      lane.boxes.mark(box);
    }
    listNodes(block, lane);
    lane.borderNodes.begin();
    for (const std::uint32_t n : lane.listed)
    {
      const bool isBorder =
        lane.sides.at(n) < 2 * view_.node(n).faces.size && touchesBeyond(n, lane.boxes);
      isBorder ? void(lane.borderNodes.mark(n)) : void();
    }
    std::vector<std::uint32_t> cells;
    for (const std::uint32_t box : block.zone)
    {
      std::copy_if(cellsOf_[box].begin(), cellsOf_[box].end(), std::back_inserter(cells),
        [&](std::uint32_t c) { return isEditable(c) && !isAtBorder(c, lane.borderNodes); });
    }
    std::sort(cells.begin(), cells.end());
    return cells;
  }

  // Of the cells of a zone, with how many sides of faces they have there; a wall counts twice.
  void listNodes(const EditBlock& block, Lane& lane) const
  {
    lane.sides.begin();
    lane.listed.clear();
    for (const std::uint32_t box : block.zone)
    {
      for (const std::uint32_t c : cellsOf_[box])
      {
        for (const std::uint32_t f : facesOf(c))
        {
          for (const std::uint32_t n : view_.cornersOf(f))
          {
            std::uint32_t& sides = lane.sides[n];
            sides == 0 ? lane.listed.push_back(n) : void();
            sides += view_.isWall(f) ? 2 : 1;
          }
        }
      }
    }
  }

  // Whether a node has a cell of another box.
  bool touchesBeyond(std::uint32_t n, const Marks& boxes) const
  {
    const auto isBeyond = [&](std::uint32_t c) {
      return c != None && boxOf_[c] != None && !boxes.contains(boxOf_[c]);
    };
    const Items faces = view_.facesAround(n);
    return std::any_of(faces.begin(), faces.end(), [&](std::uint32_t f) {
      return isBeyond(view_.face(f).below) || isBeyond(view_.face(f).above);
    });
  }

  bool isAtBorder(std::uint32_t c, const Marks& nodes) const
  {
    const Items faces = view_.facesOf(c);
    return std::any_of(faces.begin(), faces.end(), [&](std::uint32_t f) {
      const Items corners = view_.cornersOf(f);
      return std::any_of(
        corners.begin(), corners.end(), [&](std::uint32_t n) { return nodes.contains(n); });
    });
  }

  // For blocks that come later.
  void noteMade(Items cells)
  {
    for (const std::uint32_t c : cells)
    {
      if (!mesh_.cells[c].gone)
      {
        const auto at = std::lower_bound(indices_.begin(), indices_.end(), mesh_.cells[c].boxIndex);
        boxOf_[c] = static_cast<std::uint32_t>(at - indices_.begin());
        cellsOf_[boxOf_[c]].push_back(c);
      }
    }
  }

  static constexpr double ShareOfEdit = 0.35; // of what is left of the stage: for its progress
  static constexpr std::size_t MostArenas = std::size_t(1) << 16;
  static constexpr std::size_t LeastSlots = 32;
  static constexpr double CostlyFrom = 3;

  EditMesh& mesh_;
  MeshView view_;
  Execution& execution_;
  Lanes lanes_;
  std::vector<std::uint32_t> indices_;              // of boxes: CellOrigin::boxIndex
  std::vector<std::vector<std::uint32_t>> cellsOf_; // ... with those made in them, and gone
  std::vector<BoxPlace> places_;
  std::vector<std::uint32_t> boxOf_; // cells
  std::vector<std::uint32_t> turns_;
  EditBlockDivision division_;
  std::vector<FreeSlots> slots_;
  std::size_t firstArena_ = 0;
};

BlockEditing::BlockEditing(EditMesh& mesh, Execution& execution)
  : state_(std::make_unique<State>(mesh, execution))
{
}

BlockEditing::~BlockEditing() = default;

void BlockEditing::finish()
{
  state_->finish();
}

void BlockEditing::edit(
  const std::vector<std::uint32_t>& cells, const EditBlockSize& size, const ZoneWork& work)
{
  state_->edit(cells, size, work);
}

void BlockEditing::edit(const EditBlockSize& size, const ZoneWork& work)
{
  state_->edit(state_->allCells(), size, work);
}

}
