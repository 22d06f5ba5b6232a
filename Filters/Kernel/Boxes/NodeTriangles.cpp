// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/NodeTriangles.h"

#include "Boxes/UnitPlanes.h"

namespace cartesian
{

NodeTriangles::NodeTriangles(
  const Surface& surface, const Boxes& boxes, const Shoeboxes& shoeboxes, Execution& execution)
  : boxes_(boxes)
  , shoeboxes_(shoeboxes)
  , lists_(boxes.tree.nodes())
{
  std::vector<Place> tier = roots();
  while (!tier.empty())
  {
    std::vector<std::vector<Place>> below(tier.size());
    execution.forEach(tier.size(), 1, [&](std::size_t i, std::size_t) {
      execution.poll();
      distribute(surface, tier[i], below[i]);
    });
    tier.clear();
    for (const std::vector<Place>& places : below)
    {
      tier.insert(tier.end(), places.begin(), places.end());
    }
  }
}

std::vector<NodeTriangles::Place> NodeTriangles::roots() const
{
  std::vector<Place> roots;
  for (std::uint32_t g = 0; !lists_.empty() && g + 1 < boxes_.globals.size(); ++g)
  {
    if (boxes_.globals[g].node != None)
    {
      roots.push_back({ boxes_.globals[g].node, g, {} });
    }
  }
  return roots;
}

TriangleRange NodeTriangles::trianglesOf(const GlobalBox& global) const
{
  return shoeboxes_.triangles(boxes_.row(global.index[1], global.index[2]), global.index[0]);
}

TriangleRange NodeTriangles::trianglesOf(const Place& place) const
{
  if (place.cube.level == 0)
  {
    return trianglesOf(boxes_.globals[place.global]);
  }
  const std::vector<std::uint32_t>& list = lists_[boxes_.tree.numberOf(place.node)];
  return { list.data(), list.data() + list.size() };
}

void NodeTriangles::distribute(
  const Surface& surface, const Place& place, std::vector<Place>& below)
{
  const BoxTree& tree = boxes_.tree;
  const int bits = tree.bitsOf(place.node);
  for (std::size_t unit = 0; unit < std::size_t(1) << 3 * bits; ++unit)
  {
    const std::uint32_t content = tree.content(place.node, unit);
    if (BoxTree::isNode(content))
    {
      below.push_back({ BoxTree::nodeAt(content), place.global, place.cube.part(bits, unit) });
    }
  }
  if (below.empty())
  {
    return;
  }
  UnitPlanes planes;
  planes.set(boxes_.planes, boxes_.globals[place.global].index, place.cube, bits);
  const TriangleRange triangles = trianglesOf(place);
  for (const std::uint32_t* t = triangles.first; t != triangles.second; ++t)
  {
    planes.forEachUnit(surface.corners(*t), [&](std::size_t unit) {
      const std::uint32_t content = tree.content(place.node, unit);
      if (BoxTree::isNode(content))
      {
        std::vector<std::uint32_t>& list = lists_[tree.numberOf(BoxTree::nodeAt(content))];
        if (list.empty() || list.back() != *t)
        {
          list.push_back(*t);
        }
      }
    });
  }
  below.erase(std::remove_if(below.begin(), below.end(),
                [&](const Place& part) { return lists_[tree.numberOf(part.node)].empty(); }),
    below.end());
}

NodeTriangles::Near NodeTriangles::of(const PackedBox& box) const
{
  const GlobalBox& global = boxes_.globalOf(box);
  const auto nodes = static_cast<std::uint32_t>(lists_.size());
  if (global.node == None)
  {
    return { trianglesOf(global), nodes + box.global };
  }
  const int coarsest = std::min({ box.level[0], box.level[1], box.level[2] });
  std::uint32_t node = global.node;
  int level = 0;
  for (;;)
  {
    const int bits = boxes_.tree.bitsOf(node);
    const int shift = DeepestLevel - level - bits;
    const std::uint32_t content = boxes_.tree.content(node,
      BoxTree::unitAt(
        { box.offset[0] >> shift, box.offset[1] >> shift, box.offset[2] >> shift }, bits));
    if (level + bits > coarsest || !BoxTree::isNode(content))
    {
      break;
    }
    node = BoxTree::nodeAt(content);
    level += bits;
  }
  return { trianglesOf(Place{ node, box.global, { {}, level } }), boxes_.tree.numberOf(node) };
}

}
