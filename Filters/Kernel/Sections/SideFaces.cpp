// SPDX-License-Identifier: BSD-3-Clause
#include "Sections/SideFaces.h"

#include <algorithm>
#include <map>
#include <set>

namespace cartesian
{

namespace
{

using DirectedEdge = std::array<std::uint32_t, 2>;

class SideFinder
{
public:
  SideFinder(const CellFaces& cells, const std::vector<double>& points, std::size_t axis)
    : cells_(cells)
  {
    const std::size_t count = points.size() / 3;
    double lowest = points[axis];
    for (std::size_t p = 0; p < count; ++p)
    {
      lowest = std::min(lowest, points[3 * p + axis]);
    }
    isOnSide_.resize(count);
    for (std::size_t p = 0; p < count; ++p)
    {
      isOnSide_[p] = points[3 * p + axis] == lowest;
    }
  }

  SideFaces find()
  {
    for (std::uint32_t cell = 0; cell < cells_.cellCount(); ++cell)
    {
      own_.clear();
      for (std::size_t f = cells_.firstFace[cell]; f < cells_.firstFace[cell + 1]; ++f)
      {
        if (isOnSide(f))
        {
          own_.push_back(f);
        }
      }
      if (!own_.empty())
      {
        addPolygonsOf(cell);
      }
    }
    return std::move(result_);
  }

private:
  bool isOnSide(std::size_t face) const
  {
    return std::all_of(cells_.corners.begin() + std::ptrdiff_t(cells_.firstCorner[face]),
      cells_.corners.begin() + std::ptrdiff_t(cells_.firstCorner[face + 1]),
      [&](std::uint32_t point) { return isOnSide_[point] != 0; });
  }

  template <class Visitor>
  void forEachEdge(std::size_t face, Visitor&& visit) const
  {
    const std::size_t first = cells_.firstCorner[face];
    const std::size_t size = cells_.firstCorner[face + 1] - first;
    for (std::size_t i = 0; i < size; ++i)
    {
      visit(DirectedEdge{ cells_.corners[first + i], cells_.corners[first + (i + 1) % size] });
    }
  }

  void addPolygonsOf(std::uint32_t cell)
  {
    std::map<DirectedEdge, std::size_t> faceAt; // of the cell
    for (std::size_t f = cells_.firstFace[cell]; f < cells_.firstFace[cell + 1]; ++f)
    {
      forEachEdge(f, [&](const DirectedEdge& edge) { faceAt.emplace(edge, f); });
    }
    const auto beside = [&](const DirectedEdge& edge) {
      const auto at = faceAt.find({ edge[1], edge[0] });
      return at != faceAt.end() ? at->second : NoFace;
    };
    std::vector<std::vector<BorderEdge>> each; // of the faces on the side
    std::vector<BorderEdge> all;
    for (const std::size_t f : own_)
    {
      each.emplace_back();
      forEachEdge(f, [&](const DirectedEdge& edge) {
        each.back().push_back({ edge[0], edge[1], beside(edge) });
      });
      all.insert(all.end(), each.back().begin(), each.back().end());
    }
    if (const std::vector<BorderEdge> border = borderOf(all); !border.empty())
    {
      each = { border };
    }
    for (const std::vector<BorderEdge>& border : each)
    {
      addPolygon(border, cell, result_);
    }
  }

  const CellFaces& cells_;
  std::vector<std::uint8_t> isOnSide_; // of each point
  std::vector<std::size_t> own_;       // faces of one cell
  SideFaces result_;
};

// The face of a cell, other than one, that runs along an edge from one point to the other.
std::size_t faceAlong(const CellFaces& cells, std::size_t except, const DirectedEdge& edge)
{
  const auto cell = static_cast<std::size_t>(
    std::upper_bound(cells.firstFace.begin(), cells.firstFace.end(), except) -
    cells.firstFace.begin() - 1);
  for (std::size_t f = cells.firstFace[cell]; f < cells.firstFace[cell + 1]; ++f)
  {
    const std::size_t first = cells.firstCorner[f];
    const std::size_t size = cells.firstCorner[f + 1] - first;
    for (std::size_t i = 0; i < size; ++i)
    {
      if (f != except && cells.corners[first + i] == edge[0] &&
        cells.corners[first + (i + 1) % size] == edge[1])
      {
        return f;
      }
    }
  }
  return NoFace;
}

// From cell to cell around the edge.
std::size_t boundaryAround(
  const CellFaces& cells, const BorderEdge& edge, const std::vector<std::size_t>& opposite)
{
  constexpr int MostCells = 64;
  std::size_t face = edge.beside;
  for (int i = 0; i < MostCells && face < opposite.size() && opposite[face] != NoFace; ++i)
  {
    face = faceAlong(cells, opposite[face], { edge.to, edge.from });
  }
  return face;
}

}

std::vector<BorderEdge> borderOf(const std::vector<BorderEdge>& edges)
{
  std::map<DirectedEdge, std::size_t> all;
  for (const BorderEdge& edge : edges)
  {
    all.emplace(DirectedEdge{ edge.from, edge.to }, edge.beside);
  }
  std::map<std::uint32_t, BorderEdge> from;
  std::size_t count = 0;
  for (const auto& [edge, beside] : all)
  {
    if (all.count({ edge[1], edge[0] }) == 0)
    {
      from.emplace(edge[0], BorderEdge{ edge[0], edge[1], beside });
      ++count;
    }
  }
  std::vector<BorderEdge> border;
  for (auto at = from.begin(); at != from.end(); at = from.find(border.back().to))
  {
    border.push_back(at->second);
    from.erase(at);
  }
  const bool isLoop =
    border.size() == count && count > 0 && border.back().to == border.front().from;
  return isLoop ? border : std::vector<BorderEdge>();
}

void addPolygon(const std::vector<BorderEdge>& border, std::uint32_t cell, SideFaces& side)
{
  for (const BorderEdge& edge : border)
  {
    side.corners.push_back(edge.from);
    side.beside.push_back(edge.beside);
  }
  side.firstCorner.push_back(side.corners.size());
  side.cellOf.push_back(cell);
}

SideFaces facesOfSide(const CellFaces& cells, const std::vector<double>& points, std::size_t axis,
  const std::vector<std::size_t>& opposite)
{
  SideFaces side = SideFinder(cells, points, axis).find();
  std::set<DirectedEdge> all;
  for (std::size_t p = 0; p < side.count(); ++p)
  {
    for (std::size_t i = 0; i < side.size(p); ++i)
    {
      all.insert({ side.edge(p, i).from, side.edge(p, i).to });
    }
  }
  for (std::size_t p = 0; p < side.count(); ++p)
  {
    for (std::size_t i = 0; i < side.size(p); ++i)
    {
      const BorderEdge edge = side.edge(p, i);
      if (all.count({ edge.to, edge.from }) == 0)
      {
        side.beside[side.firstCorner[p] + i] = boundaryAround(cells, edge, opposite);
      }
    }
  }
  return side;
}

}
