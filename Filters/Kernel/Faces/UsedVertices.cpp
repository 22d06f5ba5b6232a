// SPDX-License-Identifier: BSD-3-Clause
#include "Faces/UsedVertices.h"

namespace cartesian
{

namespace
{

constexpr std::size_t RowsAChunk = 8;

// Marks the used vertices of one row.
class RowMarks
{
public:
  RowMarks(const Boxes& boxes, const Sides& sides, const Nodes& nodes,
    const std::vector<NodeRole>& used, SlabRange layers)
    : boxes_(boxes)
    , sides_(sides)
    , nodes_(nodes)
    , used_(used)
    , layers_(layers)
    , marks_(boxes.planes[0].size() + 1)
  {
  }

  // Calls visit(begin, end) for the runs of used vertices in row (j, k) of vertices.
  template <class Visitor>
  void forEachRun(std::size_t j, std::size_t k, Visitor&& visit)
  {
    first_ = marks_.size();
    last_ = 0;
    for (std::size_t up = 0; up < 2; ++up)
    {
      for (std::size_t back = 0; back < 2; ++back)
      {
        markBoxes(j - up, k - back);
      }
    }
    markNodes(j, k);
    for (std::size_t i = first_; i <= last_ && i < marks_.size();)
    {
      std::size_t end = i;
      for (; marks_[end]; ++end)
      {
        marks_[end] = 0;
      }
      if (end > i)
      {
        visit(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(end));
      }
      i = end + 1;
    }
  }

private:
  void mark(std::size_t i)
  {
    marks_[i] = 1;
    first_ = std::min(first_, i);
    last_ = std::max(last_, i);
  }

  // Rows before the first wrap around to huge indices.
  void markBoxes(std::size_t j, std::size_t k)
  {
    if (j >= boxes_.planes[1].size() - 1 || k < layers_.begin || k >= layers_.end)
    {
      return;
    }
    const std::size_t row = boxes_.row(j, k);
    for (std::size_t g = boxes_.rowStart[row]; g < boxes_.rowStart[row + 1]; ++g)
    {
      const GlobalBox& global = boxes_.globals[g];
      if (global.depth == 0 && sides_.ordinal[global.firstBox] == None)
      {
        mark(global.index[0]);
        mark(global.index[0] + 1);
      }
    }
  }

  void markNodes(std::size_t j, std::size_t k)
  {
    const std::size_t row = j + k * boxes_.planes[1].size();
    for (std::size_t c = nodes_.rowStart[row]; c < nodes_.rowStart[row + 1]; ++c)
    {
      const std::size_t node = nodes_.patchPoints + c;
      std::uint32_t i = 0;
      if (used_[node] != NodeRole::Unused &&
        UsedVertices::isVertex(boxes_.planes, nodes_.grid[c], j, k, i))
      {
        mark(i);
      }
    }
    const VertexNode first{ static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(j), 0, 0 };
    for (auto v = std::lower_bound(nodes_.moreVertices.begin(), nodes_.moreVertices.end(), first);
         v != nodes_.moreVertices.end() && v->k == k && v->j == j; ++v)
    {
      if (used_[v->node] != NodeRole::Unused)
      {
        mark(v->i);
      }
    }
  }

  const Boxes& boxes_;
  const Sides& sides_;
  const Nodes& nodes_;
  const std::vector<NodeRole>& used_;
  SlabRange layers_;
  std::vector<std::uint8_t> marks_;
  std::size_t first_ = 0;
  std::size_t last_ = 0;
};

}

bool UsedVertices::isVertex(
  const Meshlines& planes, const Point& node, std::size_t j, std::size_t k, std::uint32_t& i)
{
  if (node[1] != planes[1][j] || node[2] != planes[2][k])
  {
    return false;
  }
  i = static_cast<std::uint32_t>(intervalOf(planes[0], node[0]));
  return planes[0][i] == node[0];
}

UsedVertices::UsedVertices(const Boxes& boxes, const Sides& sides, const Nodes& nodes,
  const std::vector<NodeRole>& used, SlabRange layers, Execution& execution)
  : rowLength_(boxes.planes[1].size())
{
  const std::size_t rows = rowLength_ * boxes.planes[2].size();
  std::vector<std::vector<VertexRun>> parts(chunks(rows, RowsAChunk));
  rowStart_.assign(rows + 1, 0);
  execution.forEach(rows, RowsAChunk, [&](std::size_t begin, std::size_t end) {
    RowMarks marks(boxes, sides, nodes, used, layers);
    for (std::size_t row = begin; row < end; ++row)
    {
      std::uint32_t rank = 0;
      marks.forEachRun(
        row % rowLength_, row / rowLength_, [&](std::uint32_t first, std::uint32_t last) {
          parts[begin / RowsAChunk].push_back({ first, last, rank });
          rank += last - first;
          ++rowStart_[row];
        });
    }
  });
  runs_.reserve(scan(rowStart_));
  for (const auto& part : parts)
  {
    runs_.insert(runs_.end(), part.begin(), part.end());
  }
}

std::size_t UsedVertices::rank(std::uint32_t i, std::uint32_t j, std::uint32_t k) const
{
  const std::size_t row = j + k * rowLength_;
  const auto begin = runs_.begin() + static_cast<std::ptrdiff_t>(rowStart_[row]);
  const auto end = runs_.begin() + static_cast<std::ptrdiff_t>(rowStart_[row + 1]);
  const auto after = std::upper_bound(
    begin, end, i, [](std::uint32_t x, const VertexRun& run) { return x < run.begin; });
  const VertexRun& run = *(after - 1);
  return run.rank + (i - run.begin);
}

}
