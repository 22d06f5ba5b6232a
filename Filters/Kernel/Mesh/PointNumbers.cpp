// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/PointNumbers.h"

#include <atomic>
#include <tuple>

namespace cartesian
{

namespace
{

constexpr std::size_t RowsAChunk = 64;
constexpr std::size_t ItemsAChunk = 4096;

// Rows of points that come row by row, or nearly so.
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

// A node that shaping added between the grid's vertices.
struct AddedNode
{
  std::size_t row;
  Point at;
  std::size_t node;

  bool operator<(const AddedNode& other) const
  {
    return std::tie(row, at) < std::tie(other.row, other.at);
  }
};

// In order.
std::vector<AddedNode> addedNodes(
  const Nodes& nodes, const Meshlines& planes, const std::vector<Use>& used)
{
  RowFinder finder(planes);
  std::vector<AddedNode> added;
  for (std::size_t node = nodes.patchPoints + nodes.rowStart.back(); node < used.size(); ++node)
  {
    if (used[node] == Use::Between)
    {
      added.push_back({ finder.rowOf(nodes.at[node]), nodes.at[node], node });
    }
  }
  std::sort(added.begin(), added.end());
  return added;
}

}

PointNumbers::PointNumbers(const MeshParts& parts, Layers layers, Execution& execution)
  : PointNumbers(parts, layers, usedNodes(parts, layers, execution), execution)
{
}

PointNumbers::PointNumbers(
  const MeshParts& parts, Layers layers, std::vector<Use>&& used, Execution& execution)
  : rowLength_(parts.boxes.planes[1].size())
  , vertices_(parts.boxes, parts.sides, parts.nodes, used, layers, execution)
{
  const Nodes& nodes = parts.nodes;
  const Meshlines& planes = parts.boxes.planes;
  const std::size_t rows = pointRows(planes);
  rowStart_.assign(rows + 1, 0);
  ofNode_.assign(used.size(), None);
  for (const VertexNode& vertex : nodes.moreVertices)
  {
    used[vertex.node] = used[vertex.node] == Use::Nowhere ? Use::Nowhere : Use::AsVertex;
  }
  const auto forEachGridNode = [&](std::size_t row, auto&& visit) {
    for (std::size_t c = nodes.rowStart[row]; c < nodes.rowStart[row + 1]; ++c)
    {
      visit(nodes.patchPoints + c);
    }
  };
  execution.forEach(rows, RowsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
    {
      const std::size_t j = row % rowLength_;
      const std::size_t k = row / rowLength_;
      rowStart_[row] = vertices_.count(row);
      forEachGridNode(row, [&](std::size_t node) {
        std::uint32_t i = 0;
        if (used[node] != Use::Nowhere &&
          VertexRows::isVertex(planes, nodes.grid[node - nodes.patchPoints], j, k, i))
        {
          used[node] = Use::AsVertex;
          ofNode_[node] = i;
        }
        rowStart_[row] += used[node] == Use::Between ? 1 : 0;
      });
    }
  });
  const std::vector<AddedNode> added = addedNodes(nodes, planes, used);
  RowFinder finder(planes);
  for (std::size_t node = 0; node < nodes.patchPoints; ++node)
  {
    rowStart_[finder.rowOf(nodes.at[node])] += used[node] == Use::Nowhere ? 0 : 1;
  }
  for (const AddedNode& node : added)
  {
    ++rowStart_[node.row];
  }
  scan(rowStart_);

  std::vector<std::size_t> next(rows);
  execution.forEach(rows, RowsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
    {
      const auto j = static_cast<std::uint32_t>(row % rowLength_);
      const auto k = static_cast<std::uint32_t>(row / rowLength_);
      next[row] = rowStart_[row] + vertices_.count(row);
      forEachGridNode(row, [&](std::size_t node) {
        if (used[node] != Use::Nowhere)
        {
          ofNode_[node] = used[node] == Use::AsVertex ? ofVertex(ofNode_[node], j, k)
                                                      : static_cast<std::uint32_t>(next[row]++);
        }
      });
    }
  });
  for (std::size_t node = 0; node < nodes.patchPoints; ++node)
  {
    if (used[node] != Use::Nowhere)
    {
      ofNode_[node] = static_cast<std::uint32_t>(next[finder.rowOf(nodes.at[node])]++);
    }
  }
  for (const AddedNode& node : added)
  {
    ofNode_[node.node] = static_cast<std::uint32_t>(next[node.row]++);
  }
  for (const VertexNode& vertex : nodes.moreVertices)
  {
    if (used[vertex.node] != Use::Nowhere)
    {
      ofNode_[vertex.node] = ofVertex(vertex.i, vertex.j, vertex.k);
    }
  }
}

std::vector<Use> PointNumbers::usedNodes(
  const MeshParts& parts, Layers layers, Execution& execution)
{
  const Boxes& boxes = parts.boxes;
  const Cells& cells = parts.cells;
  std::vector<std::atomic<Use>> marked(parts.nodes.at.size());
  const auto mark = [&](std::uint32_t node) {
    marked[node].store(Use::Between, std::memory_order_relaxed);
  };
  const auto markFace = [&](const FaceRef& face) {
    forEachNode(face, parts.patches, parts.inner, cells.shaped, mark);
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
  forEach(cells.size(), [&](std::size_t c) {
    const bool counts = !cells.cells[c].removed && isHere(cells.cells[c].box);
    for (std::size_t f = cells.cells[c].firstFace; counts && f < cells.cells[c + 1].firstFace; ++f)
    {
      markFace(cells.faces[f]);
    }
  });
  // A hexahedron keeps its faces, whatever became of the cells beyond.
  const auto isHexahedronHere = [&](std::uint32_t box) {
    return box != None && parts.sides.polyhedralOrdinal(box) == None && isHere(box);
  };
  forEach(parts.sides.common.size(), [&](std::size_t s) {
    const Side& side = parts.sides.common[s];
    const bool keeps = isHexahedronHere(side.low) || isHexahedronHere(side.high);
    for (std::size_t f = parts.inner.sideStart[s]; keeps && f < parts.inner.sideStart[s + 1]; ++f)
    {
      markFace(FaceRef(f, FaceRef::Kind::Inner));
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
