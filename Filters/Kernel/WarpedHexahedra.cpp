#include "WarpedHexahedra.h"

#include "Polyhedron.h"
#include "VertexRows.h"

#include <algorithm>
#include <map>

namespace cartesian
{

namespace
{

class WarpedList
{
public:
  WarpedList(const Boxes& boxes, const Sides& sides, const Nodes& nodes)
    : boxes_(boxes)
    , sides_(sides)
    , nodes_(nodes)
  {
  }

  std::vector<WarpedHexahedron> run(const std::vector<std::uint32_t>& moved)
  {
    listBoxesAround(moved);
    addUndivided();
    addDivided();
    return std::move(warped_);
  }

private:
  void listBoxesAround(const std::vector<std::uint32_t>& moved)
  {
    const std::size_t rowLength = boxes_.planes[1].size();
    for (const std::uint32_t node : moved)
    {
      const std::size_t c = node - nodes_.patchPoints;
      const std::size_t row = static_cast<std::size_t>(
        std::upper_bound(nodes_.rowStart.begin(), nodes_.rowStart.end(), c) -
        nodes_.rowStart.begin() - 1);
      const std::array<std::size_t, 2> jk{ row % rowLength, row / rowLength };
      std::uint32_t i = 0;
      if (!VertexRows::isVertex(boxes_.planes, nodes_.grid[c], jk[0], jk[1], i))
      {
        continue;
      }
      nodeOfVertex_[{ i, static_cast<std::uint32_t>(jk[0]), static_cast<std::uint32_t>(jk[1]) }] =
        node;
      for (unsigned corner = 0; corner < 8; ++corner)
      {
        const std::uint32_t global = boxes_.globalAt(std::int64_t(i) - (corner & 1),
          std::int64_t(jk[0]) - (corner >> 1 & 1), std::int64_t(jk[1]) - (corner >> 2));
        if (global != None && boxes_.globals[global].depth == 0 &&
          sides_.ordinal[boxes_.globals[global].firstBox] == None)
        {
          around_.push_back(boxes_.globals[global].firstBox);
        }
      }
    }
  }

  void addUndivided()
  {
    std::sort(around_.begin(), around_.end());
    around_.erase(std::unique(around_.begin(), around_.end()), around_.end());
    for (const std::uint32_t box : around_)
    {
      const auto& low = boxes_.globalOf(boxes_.boxes[box]).index;
      addWarped(box, [&](unsigned corner) {
        const auto found = nodeOfVertex_.find(
          { low[0] + (corner & 1), low[1] + (corner >> 1 & 1), low[2] + (corner >> 2) });
        return found == nodeOfVertex_.end() ? cornerOf(boxes_.boxes[box], corner)
                                            : nodes_.at[found->second];
      });
    }
  }

  void addDivided()
  {
    for (std::size_t d = 0; d < sides_.divided.size(); ++d)
    {
      const auto& nodes = nodes_.ofDivided[d];
      const bool warped = std::any_of(nodes.begin(), nodes.end(), [&](std::uint32_t node) {
        return nodes_.at[node] != nodes_.grid[node - nodes_.patchPoints];
      });
      if (warped)
      {
        addWarped(sides_.divided[d], [&](unsigned corner) { return nodes_.at[nodes[corner]]; });
      }
    }
  }

  template <class Corner>
  void addWarped(std::uint32_t box, Corner&& corner)
  {
    const Box& whole = boxes_.boxes[box];
    Polyhedron polyhedron;
    for (unsigned c = 0; c < 8; ++c)
    {
      polyhedron.nodes.push_back(minus(corner(c), whole.low));
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const unsigned upper : { 0u, 1u })
      {
        std::array<unsigned, 4> ring = sideCorners(axis, upper);
        if (!upper)
        {
          std::reverse(ring.begin(), ring.end());
        }
        std::for_each(ring.begin(), ring.end(), [&](unsigned c) { polyhedron.addCorner(c); });
        polyhedron.closeFace(false);
      }
    }
    CellShape shape;
    measure(polyhedron, shape);
    const Vector size = minus(whole.high, whole.low);
    warped_.push_back({ box, shape.volume / (size[0] * size[1] * size[2]) });
  }

  const Boxes& boxes_;
  const Sides& sides_;
  const Nodes& nodes_;
  std::vector<std::uint32_t> around_;                                  // undivided hexahedra
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> nodeOfVertex_; // that moved
  std::vector<WarpedHexahedron> warped_;
};

}

std::vector<WarpedHexahedron> warpedHexahedra(const Boxes& boxes, const Sides& sides,
  const Nodes& nodes, const std::vector<std::uint32_t>& moved)
{
  return WarpedList(boxes, sides, nodes).run(moved);
}

}
