// SPDX-License-Identifier: BSD-3-Clause
// Which box is where: an octree over each divided global box.
//
// A node divides a cube into units, 2, 4 or 8 along each axis. In each unit there is no box, or one,
// which may contain other units and parts of other nodes too; or the unit is divided by a node of
// its own. The units of nodes without others are as small as the smallest box in them: memory grows
// with the boxes, however deep they are.
#pragma once

#include "Boxes/LocalBox.h"

#include <vector>

namespace cartesian
{

// Nodes follow each other: first a node's bits and number, then the content of each of its
// units, x fastest.
class BoxTree
{
public:
  static constexpr int MostBits = 3;
  // What is in a unit: None, the number of a box; or with NodeBit, what divides it: the node at the rest, or with
  // OtherTree too, the first node of another tree of this number.
  static constexpr std::uint32_t NodeBit = 1U << 31;
  static constexpr std::uint32_t OtherTree = 1U << 30;

  static bool isNode(std::uint32_t content) { return content != None && (content & NodeBit) != 0; }
  static bool isOtherTree(std::uint32_t content)
  {
    return isNode(content) && (content & OtherTree) != 0;
  }
  static std::uint32_t treeAt(std::uint32_t content) { return content & ~(NodeBit | OtherTree); }
  static std::uint32_t nodeAt(std::uint32_t content) { return content & ~NodeBit; }

  // How often a node of this level halves its cube, if its smallest boxes are `deepest` levels down: of the
  // nodes on the way to them, all but the first have MostBits.
  static int bitsFor(int deepest, int level) { return (deepest - level - 1) % MostBits + 1; }

  // The index in a node of the unit at a place, which is given in units.
  static std::size_t unitAt(const FinePoint& at, int bits)
  {
    const std::int64_t mask = (std::int64_t(1) << bits) - 1;
    return static_cast<std::size_t>(
      (at[0] & mask) | (at[1] & mask) << bits | (at[2] & mask) << 2 * bits);
  }

  bool empty() const { return words_.empty(); }
  std::uint32_t size() const { return static_cast<std::uint32_t>(words_.size()); }
  std::uint32_t nodes() const { return nodes_; }

  int bitsOf(std::uint32_t node) const { return static_cast<int>(words_[node] & BitsMask); }
  std::uint32_t numberOf(std::uint32_t node) const { return words_[node] >> BitsInHeader; }
  std::uint32_t content(std::uint32_t node, std::size_t unit) const
  {
    return words_[node + 1 + unit];
  }
  void setContent(std::uint32_t node, std::size_t unit, std::uint32_t content)
  {
    words_[node + 1 + unit] = content;
  }

  // The box at a place of the fine grid, below a node of this level, or None. `size` receives the size of
  // the unit there, fine.
  std::uint32_t boxAt(
    const FinePoint& fine, std::uint32_t node, int level, std::int64_t& size) const
  {
    for (;;)
    {
      const int bits = bitsOf(node);
      level += bits;
      const int shift = DeepestLevel - level;
      const std::uint32_t content =
        this->content(node, unitAt({ fine[0] >> shift, fine[1] >> shift, fine[2] >> shift }, bits));
      if (!isNode(content))
      {
        size = std::int64_t(1) << shift;
        return content;
      }
      node = nodeAt(content);
    }
  }

  // Appends a node, with those below it, for the boxes in a cube: those of `boxes` with these numbers.
  // Returns whether no two of them overlap there.
  template <class BoxInGlobal>
  bool add(
    const Cube& cube, int bits, const BoxInGlobal* boxes, const std::vector<std::uint32_t>& numbers)
  {
    const std::uint32_t node = addEmpty(bits);
    bool isFree = true;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> inParts; // unit, box
    for (const std::uint32_t number : numbers)
    {
      const BoxInGlobal& box = boxes[number];
      const bool fits = deepestOf(box) <= cube.level + bits;
      forEachUnit(cube, bits, box, [&](std::uint32_t unit) {
        std::uint32_t& content = words_[node + 1 + unit];
        isFree = isFree && content == None;
        content = fits ? number : content;
        if (!fits)
        {
          inParts.emplace_back(unit, number);
        }
      });
    }
    std::sort(inParts.begin(), inParts.end());
    std::vector<std::uint32_t> ofUnit;
    for (std::size_t i = 0; i < inParts.size();)
    {
      const std::uint32_t unit = inParts[i].first;
      int deepest = 0;
      ofUnit.clear();
      for (; i < inParts.size() && inParts[i].first == unit; ++i)
      {
        ofUnit.push_back(inParts[i].second);
        deepest = std::max(deepest, deepestOf(boxes[inParts[i].second]));
      }
      isFree = isFree && content(node, unit) == None;
      setContent(node, unit, NodeBit | size());
      const Cube part = cube.part(bits, unit);
      isFree = add(part, bitsFor(deepest, part.level), boxes, ofUnit) && isFree;
    }
    return isFree;
  }

  // Room for so many words and nodes, to be filled by place().
  void allocate(std::size_t words, std::uint32_t nodes)
  {
    words_.resize(words);
    nodes_ = nodes;
  }

  // Copies another tree to `at`, where nodes have numbers from `firstNode` on. Its boxes have numbers from `firstBox`
  // on; otherTree(n) is where tree n begins.
  template <class OtherTreeAt>
  void place(const BoxTree& other, std::uint32_t at, std::uint32_t firstNode,
    std::uint32_t firstBox, OtherTreeAt&& otherTree)
  {
    for (std::size_t node = 0; node < other.words_.size();)
    {
      const std::size_t end = node + 1 + (std::size_t(1) << 3 * (other.words_[node] & BitsMask));
      words_[at + node] = other.words_[node] + (firstNode << BitsInHeader);
      for (std::size_t unit = node + 1; unit < end; ++unit)
      {
        const std::uint32_t content = other.words_[unit];
        words_[at + unit] = content == None ? None
          : isOtherTree(content)            ? NodeBit | otherTree(treeAt(content))
          : isNode(content)                 ? content + at
                                            : content + firstBox;
      }
      node = end;
    }
  }

  void clear()
  {
    words_.clear();
    nodes_ = 0;
  }

private:
  static constexpr int BitsInHeader = 2;
  static constexpr std::uint32_t BitsMask = 3;

  template <class BoxInGlobal>
  static int deepestOf(const BoxInGlobal& box)
  {
    return std::max({ box.level[0], box.level[1], box.level[2] });
  }

  std::uint32_t addEmpty(int bits)
  {
    const std::uint32_t node = size();
    words_.push_back(nodes_++ << BitsInHeader | static_cast<std::uint32_t>(bits));
    words_.resize(words_.size() + (std::size_t(1) << 3 * bits), None);
    return node;
  }

  // Calls visit(unit) for the units of a cube that a box is in.
  template <class BoxInGlobal, class Visitor>
  static void forEachUnit(const Cube& cube, int bits, const BoxInGlobal& box, Visitor&& visit)
  {
    const int shift = DeepestLevel - cube.level - bits;
    std::array<std::uint32_t, 3> first;
    std::array<std::uint32_t, 3> last;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::int64_t low = cube.offset[axis];
      const std::int64_t from = std::max<std::int64_t>(0, box.offset[axis] - low);
      const std::int64_t to = std::min(
        FinePerBox >> cube.level, box.offset[axis] + (FinePerBox >> box.level[axis]) - low);
      first[axis] = static_cast<std::uint32_t>(from >> shift);
      last[axis] = static_cast<std::uint32_t>((to - 1) >> shift);
    }
    for (std::uint32_t z = first[2]; z <= last[2]; ++z)
    {
      for (std::uint32_t y = first[1]; y <= last[1]; ++y)
      {
        for (std::uint32_t x = first[0]; x <= last[0]; ++x)
        {
          visit(x | y << bits | z << 2 * bits);
        }
      }
    }
  }

  std::vector<std::uint32_t> words_;
  std::uint32_t nodes_ = 0;
};

}
