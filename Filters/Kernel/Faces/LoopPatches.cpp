// SPDX-License-Identifier: BSD-3-Clause
#include "Faces/LoopPatches.h"

#include <algorithm>

namespace cartesian
{

LoopPatches::LoopPatches(const Boxes& boxes, const Patches& patches, const Sides& sides,
  const Nodes& nodes, const std::vector<Point>& added,
  const std::vector<std::uint32_t>& newChordsOf,
  const std::vector<std::vector<SideEdge>>& newChords)
  : boxes_(boxes)
  , patches_(patches)
  , sides_(sides)
  , nodes_(nodes)
  , added_(added)
  , newChordsOf_(newChordsOf)
  , newChords_(newChords)
  , sideChords_(boxes, patches, sides, nodes)
{
}

// Lists the chords on a box's sides, in the direction of its patches.
void LoopPatches::gatherChords(std::size_t n)
{
  boxChords_.clear();
  normals_.clear();
  for (std::size_t i = sides_.boxStart[n]; i < sides_.boxStart[n + 1]; ++i)
  {
    const auto [s, upper] = sides_.ofBox[i];
    if (newChordsOf_[s] != None)
    {
      chords_ = newChords_[newChordsOf_[s]];
    }
    else
    {
      sideChords_.find(s, sideChords_.rectangle(s), chords_);
      dropOpposite(chords_, scratch_);
    }
    const std::size_t axis = sides_.common[s].axis;
    Vector up{ 0, 0, 0 };
    up[axis] = 1;
    for (const SideEdge& chord : chords_)
    {
      boxChords_.push_back(upper ? SideEdge{ chord.to, chord.from } : chord);
      normals_.push_back(unit(cross(minus(at(chord.to), at(chord.from)), up)));
    }
  }
}

std::uint32_t LoopPatches::local(std::uint32_t node) const
{
  return static_cast<std::uint32_t>(
    std::lower_bound(boxNodes_.begin(), boxNodes_.end(), node) - boxNodes_.begin());
}

// Lists the ends of the chords, and numbers them from 0 in the chords.
void LoopPatches::listBoxNodes()
{
  boxNodes_.clear();
  for (const SideEdge& chord : boxChords_)
  {
    boxNodes_.push_back(chord.from);
    boxNodes_.push_back(chord.to);
  }
  std::sort(boxNodes_.begin(), boxNodes_.end());
  boxNodes_.erase(std::unique(boxNodes_.begin(), boxNodes_.end()), boxNodes_.end());
  for (SideEdge& chord : boxChords_)
  {
    chord = { local(chord.from), local(chord.to) };
  }
}

void LoopPatches::add(std::uint32_t n, Patches& result)
{
  gatherChords(n);
  listBoxNodes();
  listLoopNodes(boxes_.box(sides_.polyhedral[n]));
  listSources(n);
  loops_.forEachTriangle(
    boxChords_, [&](const std::array<std::uint32_t, 3>& corners, const Vector& normal) {
      const std::size_t source = mostAlike(normal);
      for (const std::uint32_t corner : corners)
      {
        result.corners.push_back(numberOf(loops_.nodes[corner].id));
      }
      result.start.push_back(result.corners.size());
      result.triangle.push_back(patches_.triangle[source]);
      result.boundary.push_back(patches_.boundary[source]);
    });
}

void LoopPatches::listLoopNodes(const Box& box)
{
  std::vector<LoopNode>& nodes = loops_.nodes;
  nodes.assign(boxNodes_.size(), LoopNode{ 0, { 0, 0, 0 }, { 0, 0, 0 }, 0 });
  for (std::size_t c = 0; c < boxChords_.size(); ++c)
  {
    for (const std::uint32_t node : { boxChords_[c].from, boxChords_[c].to })
    {
      nodes[node].normal = plus(nodes[node].normal, normals_[c]);
    }
  }
  for (std::uint32_t i = 0; i < boxNodes_.size(); ++i)
  {
    const Point& p = at(boxNodes_[i]);
    nodes[i].id = boxNodes_[i];
    nodes[i].at = minus(p, box.low);
    nodes[i].normal = unit(nodes[i].normal);
    nodes[i].planes = planesOf(box, p);
  }
}

std::uint32_t LoopPatches::numberOf(std::uint32_t node) const
{
  return node < nodes_.patchPoints
    ? node
    : static_cast<std::uint32_t>(node - nodes_.at.size() + nodes_.patchPoints);
}

// Lists the patches that the box had, or else those of its neighbours, or else the first of all.
void LoopPatches::listSources(std::uint32_t n)
{
  sources_.clear();
  const auto addOf = [&](std::uint32_t polyhedral) {
    const std::uint32_t box = polyhedral == None ? None : sides_.patchBox[polyhedral];
    for (std::size_t p = box == None ? 0 : patches_.boxStart[box];
         box != None && p < patches_.boxStart[box + 1]; ++p)
    {
      sources_.push_back({ p, unit(areaOf(p)) });
    }
  };
  addOf(n);
  for (std::size_t i = sides_.boxStart[n]; sources_.empty() && i < sides_.boxStart[n + 1]; ++i)
  {
    const Side& side = sides_.common[sides_.ofBox[i].side];
    addOf(sides_.polyhedralOrdinal(sides_.ofBox[i].upper ? side.high : side.low));
  }
  if (sources_.empty())
  {
    sources_.push_back({ 0, { 0, 0, 0 } });
  }
}

Vector LoopPatches::areaOf(std::size_t patch) const
{
  Vector area{ 0, 0, 0 };
  const Point& first = patches_.points[patches_.corners[patches_.start[patch]]];
  for (std::size_t c = patches_.start[patch] + 1; c + 1 < patches_.start[patch + 1]; ++c)
  {
    area = plus(area,
      cross(minus(patches_.points[patches_.corners[c]], first),
        minus(patches_.points[patches_.corners[c + 1]], first)));
  }
  return area;
}

std::size_t LoopPatches::mostAlike(const Vector& normal) const
{
  return std::max_element(sources_.begin(), sources_.end(), [&](const Source& a, const Source& b) {
    return dot(a.normal, normal) < dot(b.normal, normal);
  })->patch;
}

}
