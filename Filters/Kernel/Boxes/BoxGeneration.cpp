// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/BoxGeneration.h"

#include "Base/Error.h"
#include "Boxes/Balance.h"
#include "Boxes/BlockDivision.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t RowsAChunk = 16;
constexpr std::size_t GlobalsAChunk = 64;
constexpr std::size_t CountedAChunk = 1024;
constexpr std::size_t BlocksAChunk = 4;

// The boxes before a pass, as a box in this block sees them.
class BlocksBefore : public LevelsAround
{
public:
  BlocksBefore(const Blocks& blocks, const Block& near)
    : blocks_(blocks)
    , near_(near)
  {
  }

  const std::array<std::uint8_t, 3>* at(const FinePoint& fine, std::int64_t& size) const override
  {
    return blocks_.levelsAt(fine, near_, size);
  }

private:
  const Blocks& blocks_;
  const Block& near_;
};

// Where the final boxes of a block are.
struct BlockPlace
{
  std::uint32_t firstBox;
  std::uint32_t firstWord; // in Boxes::tree
  std::uint32_t firstNode; // its number
};

class BoxGenerator
{
public:
  BoxGenerator(const Surface& surface, const Meshlines& planes, const Shoeboxes& shoeboxes,
    const Refinement& refinement, const GlobalStatuses& statuses, SlabRange core,
    std::vector<SlabRange> layers, Execution& execution)
    : surface_(surface)
    , planes_(planes)
    , shoeboxes_(shoeboxes)
    , refinement_(refinement)
    , statuses_(statuses)
    , layers_(std::move(layers))
    , execution_(execution)
  {
    boxes_.lattice = surface.lattice;
    boxes_.planes = planes;
    boxes_.planes.planeLevel = std::max(planes.planeLevel, refinement.deepest());
    boxes_.core = core;
    boxes_.ends = surface.ends;
  }

  // `kept`: the layers that stay once the boxes are balanced.
  Boxes generate(SlabRange kept)
  {
    boxes_.kept = kept;
    listGlobals();
    Blocks blocks(boxes_, EndlessGrid(refinement_.periodic(), planes_), execution_);
    if (refinement_.any())
    {
      addRoots(blocks);
      BlockDivision(surface_, boxes_, shoeboxes_, refinement_.isIsotropic(), execution_)
        .divide(blocks);
      for (int level = refinement_.deepest(); level > 0; --level)
      {
        for (int layer = 1; layer < refinement_.transitionLayers(); ++layer)
        {
          balance(blocks, growthOf(level));
        }
        if (level > 1)
        {
          balance(blocks, balanceOf(level - 1, refinement_.isIsotropic()));
        }
      }
    }
    const std::size_t first = leaveOutAllBut(kept);
    flatten(blocks, first);
    return std::move(boxes_);
  }

private:
  template <class Visitor>
  void forEachRow(Visitor&& visit)
  {
    const std::size_t rowsAlongY = planes_[1].size() - 1;
    for (const SlabRange& layers : layers_)
    {
      const std::size_t first = boxes_.row(0, layers.begin);
      const std::size_t count = boxes_.row(0, layers.end) - first;
      execution_.forEach(count, RowsAChunk, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = first + begin; row < first + end; ++row)
        {
          visit(row, static_cast<std::uint32_t>(row % rowsAlongY),
            static_cast<std::uint32_t>(row / rowsAlongY));
        }
      });
    }
  }

  template <class Visitor>
  void forEachGlobal(Visitor&& visit)
  {
    execution_.forEach(statusOf_.size(), GlobalsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t g = begin; g < end; ++g)
      {
        visit(g);
      }
    });
  }

  void listGlobals()
  {
    boxes_.rowStart.assign((planes_[1].size() - 1) * (planes_[2].size() - 1) + 1, 0);
    forEachRow([&](std::size_t row, std::uint32_t j, std::uint32_t k) {
      statuses_.forEachBox(j, k, [&](std::uint32_t, BoxStatus) { ++boxes_.rowStart[row]; });
    });
    const std::size_t count = scan(boxes_.rowStart);
    if (count >= None)
    {
      throw Error(Fault::TooManyBoxes,
        "The mesh has more boxes than can be numbered in 32 bits: choose a larger Cell Size.");
    }
    boxes_.globals.resize(count + 1);
    boxes_.globals.back() = { { 0, 0, 0 }, 0, None, 0, 0 };
    statusOf_.resize(count);
    forEachRow([&](std::size_t row, std::uint32_t j, std::uint32_t k) {
      std::size_t next = boxes_.rowStart[row];
      statuses_.forEachBox(j, k, [&](std::uint32_t i, BoxStatus status) {
        boxes_.globals[next] = { { i, j, k }, 0, None, 0, 0 };
        statusOf_[next++] = status;
      });
    });
  }

  void requireDivisible(const std::array<std::uint32_t, 3>& at, const Depths& depths) const
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const Level size = planes_[axis][at[axis] + 1] - planes_[axis][at[axis]];
      const Level least = std::max(leastWidth(depths.deepest()), Level(2) << refinement_.deepest());
      if (depths.deepest() > 0 && size < least)
      {
        throw Error(Fault::BadParameter,
          "Global box " + std::to_string(at[0]) + ", " + std::to_string(at[1]) + ", " +
            std::to_string(at[2]) + " is too thin to be divided on this lattice, which has " +
            number(LevelsOfTheDomain) +
            " levels along the whole grid: choose a larger Cell Size, refine less, or make the "
            "domain smaller.");
      }
    }
  }

  void addRoots(Blocks& blocks)
  {
    std::vector<std::vector<Block>> found(chunks(statusOf_.size(), GlobalsAChunk));
    execution_.forEach(statusOf_.size(), GlobalsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t g = begin; g < end; ++g)
      {
        const auto& at = boxes_.globals[g].index;
        const Depths depths = refinement_.at(at[0], at[1], at[2]);
        requireDivisible(at, depths);
        const bool isCut = statusOf_[g] == BoxStatus::Intersected;
        if (depths.inPart() || depths.forced > 0 || (isCut && depths.allowed > 0))
        {
          found[begin / GlobalsAChunk].push_back(rootOf(static_cast<std::uint32_t>(g), depths));
        }
      }
    });
    for (std::vector<Block>& chunk : found)
    {
      for (Block& root : chunk)
      {
        blocks.addRoot(std::move(root));
      }
    }
  }

  Block rootOf(std::uint32_t g, const Depths& depths) const
  {
    const bool isCut = statusOf_[g] == BoxStatus::Intersected;
    Block root;
    root.global = g;
    root.status = statusOf_[g];
    root.allowed = depths.allowed;
    root.forcing = refinement_.forcingOf(boxes_.globals[g].index, depths);
    root.low = statuses_.lowCorner(boxes_.globals[g].index);
    const int forced = std::max({ depths.forced, depths.touched, depths.sized });
    root.bits = BoxTree::bitsFor(isCut ? std::max(forced, depths.allowed) : forced, 0);
    return root;
  }

  std::uint8_t cornersOf(std::size_t g) const
  {
    const auto& at = boxes_.globals[g].index;
    return statuses_.corners(at[0], at[1], at[2], statusOf_[g]);
  }

  LocalBox undivided(std::size_t g) const
  {
    return { { 0, 0, 0 }, { 0, 0, 0 }, statusOf_[g], cornersOf(g) };
  }

  // One pass (Balance.h).
  void balance(Blocks& blocks, const BalancePass& pass)
  {
    std::vector<std::vector<LocalBox>> halved = halvedBoxes(blocks, pass);
    std::vector<Block> added = halvedGlobals(blocks, pass);
    std::vector<std::uint32_t> changed;
    for (std::uint32_t b = 0; b < halved.size(); ++b)
    {
      if (!halved[b].empty())
      {
        blocks[b].boxes.swap(halved[b]);
        changed.push_back(b);
      }
    }
    for (Block& root : added)
    {
      changed.push_back(blocks.addRoot(std::move(root)));
    }
    if (!changed.empty())
    {
      blocks.update(changed);
    }
  }

  // Of each block that changes, the boxes after the pass.
  std::vector<std::vector<LocalBox>> halvedBoxes(
    const Blocks& blocks, const BalancePass& pass) const
  {
    std::vector<std::vector<LocalBox>> boxes(blocks.size());
    execution_.forEach(blocks.size(), BlocksAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b)
      {
        const Block& block = blocks[b];
        const bool mayHalve = block.coarsest < pass.level && block.nearDepth >= pass.touching;
        bool changes = false;
        for (std::size_t i = 0; mayHalve && i < block.boxes.size(); ++i)
        {
          changes |= balance(blocks, block, block.boxes[i], pass, boxes[b]);
        }
        if (!changes)
        {
          boxes[b].clear();
        }
      }
    });
    return boxes;
  }

  // Blocks for global boxes without one that change.
  std::vector<Block> halvedGlobals(const Blocks& blocks, const BalancePass& pass) const
  {
    std::vector<std::vector<Block>> found(chunks(statusOf_.size(), GlobalsAChunk));
    execution_.forEach(statusOf_.size(), GlobalsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t g = begin; g < end; ++g)
      {
        if (blocks.rootOf(g) != None || blocks.nearDepthOf(g) < pass.touching)
        {
          continue;
        }
        Block root = rootOf(static_cast<std::uint32_t>(g), Depths());
        if (balance(blocks, root, undivided(g), pass, root.boxes))
        {
          root.bits = BoxTree::bitsFor(pass.level, 0);
          found[begin / GlobalsAChunk].push_back(std::move(root));
        }
      }
    });
    std::vector<Block> all;
    for (std::vector<Block>& chunk : found)
    {
      std::move(chunk.begin(), chunk.end(), std::back_inserter(all));
    }
    return all;
  }

  // Appends what a pass makes of a box of a block, without parts that are outside; true if it was halved.
  bool balance(const Blocks& blocks, const Block& block, const LocalBox& box,
    const BalancePass& pass, std::vector<LocalBox>& parts) const
  {
    const auto& index = boxes_.globals[block.global].index;
    BoxToBalance placed{ {}, box.level };
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      placed.low[axis] = index[axis] * FinePerBox + box.offset[axis];
    }
    const unsigned axes = axesToHalve(BlocksBefore(blocks, block), placed, pass);
    if (axes == 0)
    {
      parts.push_back(box);
      return false;
    }
    for (unsigned upper = 0; upper < 8; ++upper)
    {
      if ((upper & ~axes) != 0)
      {
        continue; // not halved along one of these axes
      }
      const LocalBox part = partOf(block, box, axes, upper);
      if (part.status != BoxStatus::Outside)
      {
        balance(blocks, block, part, pass, parts);
      }
    }
    return true;
  }

  // The part of a box that is halved along these axes on the upper sides of some of them.
  LocalBox partOf(const Block& block, const LocalBox& whole, unsigned axes, unsigned upper) const
  {
    LocalBox part = whole;
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      if ((axes >> axis & 1) != 0)
      {
        part = halfOf(part, axis, (upper >> axis & 1) != 0);
      }
    }
    if (whole.status == BoxStatus::Intersected)
    {
      findStatus(block, part);
    }
    return part;
  }

  static PackedBox packed(std::size_t g, const LocalBox& part)
  {
    return { static_cast<std::uint32_t>(g), part.offset, part.level, part.corners, part.status };
  }

  Winding windingAt(const Block& block, const Point& point) const
  {
    const auto& at = boxes_.globals[block.global].index;
    Point corner;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      corner[axis] = planeAt(planes_, axis, at[axis], block.cube.offset[axis]);
    }
    return cartesian::windingAt(
      surface_, trianglesOf(block, boxes_, shoeboxes_), corner, block.low, point);
  }

  void findStatus(const Block& block, LocalBox& part) const
  {
    const Box box = boxes_.placed(packed(block.global, part));
    unsigned bits = 0;
    for (unsigned c = 0; c < 8; ++c)
    {
      bits |= static_cast<unsigned>(windingAt(block, cornerOf(box, c)).inside()) << c;
    }
    part.corners = static_cast<std::uint8_t>(bits);
    part.status = (bits & 1) != 0 ? BoxStatus::Inside : BoxStatus::Outside;
    const TriangleRange triangles = trianglesOf(block, boxes_, shoeboxes_);
    for (const std::uint32_t* t = triangles.first; t != triangles.second; ++t)
    {
      if (clip(surface_.corners(*t), box.low, box.high).size > 0)
      {
        part.status = BoxStatus::Intersected;
        return;
      }
    }
  }

  // Returns how many global boxes before the others are left out.
  std::size_t leaveOutAllBut(SlabRange kept)
  {
    const std::size_t first = boxes_.rowStart[boxes_.row(0, kept.begin)];
    const std::size_t end = boxes_.rowStart[boxes_.row(0, kept.end)];
    const auto slice = [&](auto& ofGlobals) {
      ofGlobals.erase(ofGlobals.begin() + std::ptrdiff_t(end), ofGlobals.end());
      ofGlobals.erase(ofGlobals.begin(), ofGlobals.begin() + std::ptrdiff_t(first));
    };
    slice(boxes_.globals);
    boxes_.globals.push_back({ { 0, 0, 0 }, 0, None, 0, 0 });
    slice(statusOf_);
    for (std::size_t& start : boxes_.rowStart)
    {
      start = std::clamp(start, first, end) - first;
    }
    return first;
  }

  // Lists all boxes: those of a block follow each other. `first`: how many global boxes were left out before them.
  void flatten(Blocks& blocks, std::size_t first)
  {
    const std::vector<BlockPlace> places = placesOf(blocks, first);
    if (surface_.walls.any())
    {
      boxes_.regions.resize(boxes_.packed.size());
    }
    forEachGlobal([&](std::size_t g) {
      GlobalBox& global = boxes_.globals[g];
      const std::uint32_t root = blocks.rootOf(first + g);
      if (root == None)
      {
        writeBox(global.firstBox, packed(g, undivided(g)), nullptr);
        return;
      }
      global.depth = blocks[root].depth;
      global.node = places[root].firstWord;
      blocks.forEachBelow(root, [&](std::uint32_t b) { writeBlock(blocks[b], g, places, b); });
    });
    if (!boxes_.tree.empty())
    {
      boxes_.findNearDepths(execution_);
    }
  }

  // What chunks of global boxes hold.
  struct Sizes
  {
    std::size_t boxes = 0;
    std::size_t words = 0; // of trees
    std::uint32_t nodes = 0;

    void add(const Block& block)
    {
      boxes += block.boxes.size();
      words += block.tree.size();
      nodes += block.tree.nodes();
    }
  };

  // By block. Sizes the lists.
  std::vector<BlockPlace> placesOf(const Blocks& blocks, std::size_t first)
  {
    const auto forEachOfChunk = [&](std::size_t begin, std::size_t end, Sizes& sizes,
                                  const auto& visit) {
      for (std::size_t g = begin; g < end; ++g)
      {
        boxes_.globals[g].firstBox = static_cast<std::uint32_t>(sizes.boxes);
        const std::uint32_t root = blocks.rootOf(first + g);
        sizes.boxes += root == None ? 1 : 0;
        if (root != None)
        {
          blocks.forEachBelow(root, [&](std::uint32_t b) {
            visit(b);
            sizes.add(blocks[b]);
          });
        }
      }
    };
    const std::size_t count = statusOf_.size();
    std::vector<Sizes> before(chunks(count, CountedAChunk) + 1);
    execution_.forEach(count, CountedAChunk, [&](std::size_t begin, std::size_t end) {
      forEachOfChunk(begin, end, before[begin / CountedAChunk + 1], [](std::uint32_t) {});
    });
    for (std::size_t i = 1; i < before.size(); ++i)
    {
      before[i].boxes += before[i - 1].boxes;
      before[i].words += before[i - 1].words;
      before[i].nodes += before[i - 1].nodes;
    }
    const Sizes& all = before.back();
    if (std::max(all.boxes, all.words) >= BoxTree::OtherTree)
    {
      throw Error(Fault::TooManyBoxes,
        "The mesh has more boxes than can be numbered in 30 bits: choose a larger Cell Size, or "
        "refine less.");
    }
    std::vector<BlockPlace> places(blocks.size());
    execution_.forEach(count, CountedAChunk, [&](std::size_t begin, std::size_t end) {
      Sizes next = before[begin / CountedAChunk];
      forEachOfChunk(begin, end, next, [&](std::uint32_t b) {
        places[b] = { static_cast<std::uint32_t>(next.boxes),
          static_cast<std::uint32_t>(next.words), next.nodes };
      });
    });
    boxes_.globals.back().firstBox = static_cast<std::uint32_t>(all.boxes);
    boxes_.packed.resize(all.boxes);
    boxes_.tree.allocate(all.words, all.nodes);
    return places;
  }

  // `g`: the number of its global box now.
  void writeBlock(
    Block& block, std::size_t g, const std::vector<BlockPlace>& places, std::uint32_t number)
  {
    const BlockPlace& place = places[number];
    boxes_.tree.place(block.tree, place.firstWord, place.firstNode, place.firstBox,
      [&](std::uint32_t child) { return places[child].firstWord; });
    block.global = static_cast<std::uint32_t>(g);
    for (std::size_t i = 0; i < block.boxes.size(); ++i)
    {
      writeBox(place.firstBox + i, packed(g, block.boxes[i]), &block);
    }
    block.boxes = {};
    block.tree = {};
    block.triangles = {};
  }

  void writeBox(std::size_t b, const PackedBox& box, const Block* block)
  {
    boxes_.packed[b] = box;
    for (unsigned corner = 0; corner < 8 && !boxes_.regions.empty(); ++corner)
    {
      boxes_.regions[b][corner] = regionAt(box, block, corner);
    }
  }

  std::int32_t regionAt(const PackedBox& box, const Block* block, unsigned corner) const
  {
    const auto& at = boxes_.globals[box.global].index;
    std::array<std::uint32_t, 3> vertex = at;
    bool isVertex = true; // of the global mesh
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      const std::int64_t fine = box.offset[axis] +
        ((corner >> axis & 1) != 0 ? Boxes::fineSize(box, static_cast<int>(axis)) : 0);
      isVertex = isVertex && fine % FinePerBox == 0;
      vertex[axis] += fine == FinePerBox ? 1 : 0;
    }
    if (isVertex || block == nullptr)
    {
      return statuses_.lowCorner(vertex).region();
    }
    return windingAt(*block, cornerOf(boxes_.placed(box), corner)).region();
  }

  const Surface& surface_;
  const Meshlines& planes_;
  const Shoeboxes& shoeboxes_;
  const Refinement& refinement_;
  const GlobalStatuses& statuses_;
  std::vector<SlabRange> layers_;
  Execution& execution_;
  Boxes boxes_;
  RawVector<BoxStatus> statusOf_; // of global boxes
};

// The layers on which the levels of those kept depend: near them, and those that these see beyond an end of the grid.
std::vector<SlabRange> layersToBalance(
  const Refinement& refinement, SlabRange kept, std::uint32_t all)
{
  const std::uint32_t reach = balanceReach(refinement.deepest(), refinement.transitionLayers());
  const SlabRange near = kept.grown(reach, all);
  if (!refinement.periodic()[2] || near.begin == near.end)
  {
    return { near };
  }
  const std::uint32_t below = reach - (kept.begin - near.begin);
  const std::uint32_t above = reach - (near.end - kept.end);
  return { { 0, std::min(near.begin, above) }, near,
    { std::max(near.end, all - std::min(all, below)), all } };
}

}

Boxes generateBoxes(const Surface& surface, const Meshlines& planes, const Shoeboxes& shoeboxes,
  const Refinement& refinement, const GlobalStatuses& statuses, SlabRange core, SlabRange kept,
  Execution& execution)
{
  const auto end = static_cast<std::uint32_t>(planes[2].size() - 1);
  return BoxGenerator(surface, planes, shoeboxes, refinement, statuses, core,
    layersToBalance(refinement, kept, end), execution)
    .generate(kept);
}

}
