// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/PointNumbers.h"

#include <algorithm>
#include <atomic>
#include <tuple>

namespace cartesian
{

namespace
{

constexpr std::size_t RowsAChunk = 4;
constexpr std::size_t ItemsAChunk = 1024;

// Finds the rows of points that come row by row, or nearly so.
class RowFinder
{
public:
  explicit RowFinder(const Meshlines& planes)
    : planes_(planes)
  {
  }

  std::size_t rowOf(const Point& p)
  {
    j_ = interval(1, p[1], j_);
    k_ = interval(2, p[2], k_);
    return static_cast<std::size_t>(j_) + static_cast<std::size_t>(k_) * planes_[1].size();
  }

private:
  std::int64_t interval(std::size_t axis, Level level, std::int64_t guess) const
  {
    const std::vector<Level>& lines = planes_[axis];
    const auto i = static_cast<std::size_t>(guess);
    return level >= lines[i] && (i + 1 == lines.size() || level < lines[i + 1])
      ? guess
      : intervalOf(lines, level);
  }

  const Meshlines& planes_;
  std::int64_t j_ = 0;
  std::int64_t k_ = 0;
};

}

// A node that edits added between the grid's vertices.
struct PointNumbers::AddedNode
{
  std::size_t row;
  Point at;
  std::size_t node;

  bool operator<(const AddedNode& other) const
  {
    return std::tie(row, at) < std::tie(other.row, other.at);
  }
};

// Those that are used, in order.
std::vector<PointNumbers::AddedNode> PointNumbers::addedNodes(
  const Nodes& nodes, const Meshlines& planes, const std::vector<NodeRole>& roles)
{
  RowFinder finder(planes);
  std::vector<AddedNode> added;
  for (std::size_t node = nodes.patchPoints + nodes.rowStart.back(); node < roles.size(); ++node)
  {
    if (roles[node] == NodeRole::Plain)
    {
      added.push_back({ finder.rowOf(nodes.at[node]), nodes.at[node], node });
    }
  }
  std::sort(added.begin(), added.end());
  return added;
}

PointNumbers::PointNumbers(const MeshParts& parts, SlabRange layers, Execution& execution)
  : PointNumbers(parts, layers, usedNodes(parts, layers, execution), execution)
{
}

PointNumbers::PointNumbers(
  const MeshParts& parts, SlabRange layers, std::vector<NodeRole>&& roles, Execution& execution)
  : rowLength_(parts.boxes.planes[1].size())
  , vertices_(parts.boxes, parts.sides, parts.nodes, roles, layers, execution)
{
  markVertices(parts, roles, execution);
  const std::vector<AddedNode> added = addedNodes(parts.nodes, parts.boxes.planes, roles);
  countPoints(parts, roles, added, execution);
  numberNodes(parts, roles, added, execution);
}

template <class Visitor>
void PointNumbers::forEachGridNode(const Nodes& nodes, Execution& execution, Visitor&& visit) const
{
  execution.forEach(nodes.rowStart.size() - 1, RowsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
    {
      for (std::size_t c = nodes.rowStart[row]; c < nodes.rowStart[row + 1]; ++c)
      {
        visit(row, nodes.patchPoints + c);
      }
    }
  });
}

// Whether a grid node of a row is a vertex of the global mesh; then `i`.
bool PointNumbers::isVertex(
  const MeshParts& parts, std::size_t row, std::size_t node, std::uint32_t& i) const
{
  return UsedVertices::isVertex(parts.boxes.planes,
    parts.nodes.grid[node - parts.nodes.patchPoints], row % rowLength_, row / rowLength_, i);
}

// Finds out which used nodes are vertices of the global mesh.
void PointNumbers::markVertices(
  const MeshParts& parts, std::vector<NodeRole>& roles, Execution& execution) const
{
  for (const VertexNode& vertex : parts.nodes.moreVertices)
  {
    NodeRole& role = roles[vertex.node];
    role = role == NodeRole::Unused ? NodeRole::Unused : NodeRole::Vertex;
  }
  forEachGridNode(parts.nodes, execution, [&](std::size_t row, std::size_t node) {
    std::uint32_t i = 0;
    if (roles[node] != NodeRole::Unused && isVertex(parts, row, node, i))
    {
      roles[node] = NodeRole::Vertex;
    }
  });
}

// Fills rowStart_.
void PointNumbers::countPoints(const MeshParts& parts, const std::vector<NodeRole>& roles,
  const std::vector<AddedNode>& added, Execution& execution)
{
  const Meshlines& planes = parts.boxes.planes;
  const std::size_t rows = pointRows(planes);
  rowStart_.resize(rows + 1);
  for (std::size_t row = 0; row < rows; ++row)
  {
    rowStart_[row] = vertices_.count(row);
  }
  forEachGridNode(parts.nodes, execution, [&](std::size_t row, std::size_t node) {
    rowStart_[row] += roles[node] == NodeRole::Plain ? 1 : 0;
  });
  RowFinder finder(planes);
  for (std::size_t node = 0; node < parts.nodes.patchPoints; ++node)
  {
    rowStart_[finder.rowOf(parts.nodes.at[node])] += roles[node] == NodeRole::Unused ? 0 : 1;
  }
  for (const AddedNode& node : added)
  {
    ++rowStart_[node.row];
  }
  scan(rowStart_);
}

// Fills ofNode_.
void PointNumbers::numberNodes(const MeshParts& parts, const std::vector<NodeRole>& roles,
  const std::vector<AddedNode>& added, Execution& execution)
{
  ofNode_.assign(roles.size(), None);
  std::vector<std::size_t> next(rowStart_.size() - 1); // of each row
  for (std::size_t row = 0; row < next.size(); ++row)
  {
    next[row] = rowStart_[row] + vertices_.count(row);
  }
  const auto take = [&](std::size_t row) { return static_cast<std::uint32_t>(next[row]++); };
  forEachGridNode(parts.nodes, execution, [&](std::size_t row, std::size_t node) {
    std::uint32_t i = 0;
    if (roles[node] == NodeRole::Vertex && isVertex(parts, row, node, i))
    {
      ofNode_[node] = ofVertex(i, static_cast<std::uint32_t>(row % rowLength_),
        static_cast<std::uint32_t>(row / rowLength_));
    }
    else if (roles[node] == NodeRole::Plain)
    {
      ofNode_[node] = take(row);
    }
  });
  RowFinder finder(parts.boxes.planes);
  for (std::size_t node = 0; node < parts.nodes.patchPoints; ++node)
  {
    if (roles[node] != NodeRole::Unused)
    {
      ofNode_[node] = take(finder.rowOf(parts.nodes.at[node]));
    }
  }
  for (const AddedNode& node : added)
  {
    ofNode_[node.node] = take(node.row);
  }
  for (const VertexNode& vertex : parts.nodes.moreVertices)
  {
    if (roles[vertex.node] != NodeRole::Unused)
    {
      ofNode_[vertex.node] = ofVertex(vertex.i, vertex.j, vertex.k);
    }
  }
}

std::vector<NodeRole> PointNumbers::usedNodes(
  const MeshParts& parts, SlabRange layers, Execution& execution)
{
  const Boxes& boxes = parts.boxes;
  const WallMesh& wall = parts.wall;
  std::vector<std::atomic<NodeRole>> marked(parts.nodes.at.size());
  const auto mark = [&](std::uint32_t node) {
    marked[node].store(NodeRole::Plain, std::memory_order_relaxed);
  };
  const auto isHere = [&](std::uint32_t box) {
    return layers.contains(boxes.globalOf(boxes.packed[box]).index[2]);
  };
  const auto forEach = [&](std::size_t count, auto&& visit) {
    execution.forEach(count, ItemsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        visit(i);
      }
    });
  };
  forEach(wall.size(), [&](std::size_t c) {
    if (!wall.cells[c].removed && isHere(wall.cells[c].box))
    {
      wall.forEachNodeOf(c, mark);
    }
  });
  // A hexahedron keeps its faces, whatever happened to the cells beyond.
  const auto isHexahedronHere = [&](std::uint32_t box) {
    return box != None && parts.sides.polyhedralOrdinal(box) == None && isHere(box);
  };
  forEach(wall.faces.size(), [&](std::size_t f) {
    const auto& cells = wall.faces.cells[f];
    if (std::any_of(cells.begin(), cells.end(),
          [&](CellKey key) { return isHexahedron(key) && isHere(boxOfHexahedron(key)); }))
    {
      wall.faces.forEachNode({ f, false }, mark);
    }
  });
  forEach(parts.nodes.ofDivided.size(), [&](std::size_t i) {
    const bool keeps = isHexahedronHere(parts.sides.divided[i]);
    for (std::size_t corner = 0; keeps && corner < 8; ++corner)
    {
      mark(parts.nodes.ofDivided[i][corner]);
    }
  });
  return { marked.begin(), marked.end() };
}

std::size_t PointNumbers::firstOfLayer(std::size_t k) const
{
  return rowStart_[std::min(k * rowLength_, rowStart_.size() - 1)];
}

}
