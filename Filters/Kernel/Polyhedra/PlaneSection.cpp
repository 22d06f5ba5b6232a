// SPDX-License-Identifier: BSD-3-Clause
#include "Polyhedra/PlaneSection.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

// Nodes closer to the plane than this count as lying on it: positions are rounded to whole numbers.
constexpr double RoundingLevels = 2;

// An end of an edge is taken instead of a new node where the edge meets the plane so close to it
// that the cutting polygon deviates from the plane by less than this (4.11): tan 5 degrees.
constexpr double SnapSlope = 0.0874886635259240;

}

bool PlaneSection::find(
  const Polyhedron& cell, const CutPlane& plane, std::vector<CellCut::NewNode>& newNodes)
{
  cell_ = &cell;
  newNodes_ = &newNodes;
  newNodes.clear();
  findDistances(plane);
  if (!hasBothSides())
  {
    return false;
  }
  snapNodes();
  return hasBothSides() && addNewNodes();
}

void PlaneSection::findDistances(const CutPlane& plane)
{
  distance_.resize(cell_->nodes.size());
  for (std::size_t n = 0; n < distance_.size(); ++n)
  {
    distance_[n] = dot(minus(cell_->nodes[n], plane.at), plane.normal);
    if (std::abs(distance_[n]) < RoundingLevels)
    {
      distance_[n] = 0;
    }
  }
  for (const std::uint32_t n : plane.through)
  {
    distance_[n] = 0;
  }
}

bool PlaneSection::hasBothSides() const
{
  const auto above = [](double d) { return d > 0; };
  const auto below = [](double d) { return d < 0; };
  return std::any_of(distance_.begin(), distance_.end(), above) &&
    std::any_of(distance_.begin(), distance_.end(), below);
}

Vector PlaneSection::crossing(std::uint32_t from, std::uint32_t to) const
{
  const double t = distance_[from] / (distance_[from] - distance_[to]);
  return plus(cell_->nodes[from], scaled(minus(cell_->nodes[to], cell_->nodes[from]), t));
}

bool PlaneSection::crosses(std::size_t face) const
{
  bool above = false;
  bool below = false;
  for (std::size_t i = cell_->start[face]; i < cell_->start[face + 1]; ++i)
  {
    const double distance = distance_[cell_->corners[i]];
    above = above || distance > 0;
    below = below || distance < 0;
  }
  return above && below;
}

// For each edge that crosses the plane, the lengths of the two edges of the cutting polygon that
// meet there, sorted by edge and length. Each runs across one face.
void PlaneSection::listLengths()
{
  lengths_.clear();
  for (std::size_t f = 0; f < cell_->faces(); ++f)
  {
    if (!crosses(f))
    {
      continue;
    }
    ends_.clear();
    forEachEdge(f, [&](std::uint32_t from, std::uint32_t to) {
      if (crosses(from, to))
      {
        ends_.push_back(crossing(from, to));
      }
      else if (sign(to) == 0)
      {
        ends_.push_back(cell_->nodes[to]);
      }
    });
    double length = 0;
    for (const Vector& end : ends_)
    {
      length = std::max(length, norm(minus(end, ends_.front())));
    }
    forEachEdge(f, [&](std::uint32_t from, std::uint32_t to) {
      if (crosses(from, to))
      {
        lengths_.emplace_back(edgeBetween(from, to), length);
      }
    });
  }
  std::sort(lengths_.begin(), lengths_.end());
}

// All decisions are made before any node moves onto the plane.
void PlaneSection::snapNodes()
{
  listLengths();
  snapped_.clear();
  for (std::size_t i = 0; i < lengths_.size(); ++i)
  {
    const auto& [edge, length] = lengths_[i];
    if (i > 0 && lengths_[i - 1].first == edge)
    {
      continue; // the shorter one counts
    }
    const bool first = std::abs(distance_[edge.first]) <= std::abs(distance_[edge.second]);
    const std::uint32_t nearest = first ? edge.first : edge.second;
    if (std::abs(distance_[nearest]) < SnapSlope * length)
    {
      snapped_.push_back(nearest);
    }
  }
  for (const std::uint32_t node : snapped_)
  {
    distance_[node] = 0;
  }
}

bool PlaneSection::addNewNodes()
{
  bool distinct = true;
  for (std::size_t f = 0; f < cell_->faces(); ++f)
  {
    if (!crosses(f))
    {
      continue;
    }
    forEachEdge(f, [&](std::uint32_t from, std::uint32_t to) {
      const Edge edge = edgeBetween(from, to);
      if (crosses(from, to) && newNodeOn(edge) == NoNode)
      {
        Vector at = crossing(edge.first, edge.second);
        for (double& x : at)
        {
          x = std::round(x);
        }
        distinct = distinct && at != cell_->nodes[from] && at != cell_->nodes[to];
        newNodes_->push_back({ edge.first, edge.second, at });
      }
    });
  }
  return distinct;
}

std::uint32_t PlaneSection::newNodeOn(const Edge& edge) const
{
  for (std::size_t i = 0; i < newNodes_->size(); ++i) // there are few
  {
    if ((*newNodes_)[i].low == edge.first && (*newNodes_)[i].high == edge.second)
    {
      return static_cast<std::uint32_t>(cell_->nodes.size() + i);
    }
  }
  return NoNode;
}

}
