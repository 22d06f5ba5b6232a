// SPDX-License-Identifier: BSD-3-Clause
#include "Sections/SideFaces.h"

#include <algorithm>
#include <map>

namespace cartesian
{

namespace
{

using DirectedEdge = std::array<std::uint32_t, 2>;

struct Corner
{
  std::uint32_t point;
  std::size_t beside; // face
};

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
    result_.firstCorner.push_back(0);
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
      return at != faceAt.end() ? at->second : cells_.faceCount();
    };
    if (own_.size() > 1 && addUnited(cell, beside))
    {
      return;
    }
    for (const std::size_t f : own_)
    {
      forEachEdge(f, [&](const DirectedEdge& edge) {
        result_.corners.push_back(edge[0]);
        result_.beside.push_back(beside(edge));
      });
      finish(cell);
    }
  }

  // False if their border is more than one loop.
  template <class Beside>
  bool addUnited(std::uint32_t cell, Beside&& beside)
  {
    std::map<std::uint32_t, DirectedEdge> from; // edges of the border, by their first points
    std::size_t count = 0;
    for (const std::size_t f : own_)
    {
      forEachEdge(f, [&](const DirectedEdge& edge) {
        if (std::find(own_.begin(), own_.end(), beside(edge)) == own_.end())
        {
          from.emplace(edge[0], edge);
          ++count;
        }
      });
    }
    std::vector<DirectedEdge> loop;
    for (auto at = from.begin(); at != from.end(); at = from.find(loop.back()[1]))
    {
      loop.push_back(at->second);
      from.erase(at);
    }
    if (loop.size() != count || loop.empty() || loop.back()[1] != loop.front()[0])
    {
      return false;
    }
    for (const DirectedEdge& edge : loop)
    {
      result_.corners.push_back(edge[0]);
      result_.beside.push_back(beside(edge));
    }
    finish(cell);
    return true;
  }

  void finish(std::uint32_t cell)
  {
    result_.firstCorner.push_back(result_.corners.size());
    result_.cellOf.push_back(cell);
  }

  const CellFaces& cells_;
  std::vector<std::uint8_t> isOnSide_; // of each point
  std::vector<std::size_t> own_;       // faces of one cell
  SideFaces result_;
};

}

SideFaces facesOfSide(const CellFaces& cells, const std::vector<double>& points, std::size_t axis)
{
  return SideFinder(cells, points, axis).find();
}

}
