// SPDX-License-Identifier: BSD-3-Clause
#include "Faces/LoopPatches.h"

#include "Base/Loops.h"

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

// The chords on a box's sides, as its patches run along them.
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
}

void LoopPatches::linkChords()
{
  leaving_.assign(boxNodes_.size(), None);
  sameFrom_.assign(boxChords_.size(), None);
  for (std::uint32_t c = 0; c < boxChords_.size(); ++c)
  {
    const std::uint32_t from = local(boxChords_[c].from);
    sameFrom_[c] = leaving_[from];
    leaving_[from] = c;
  }
}

void LoopPatches::add(std::uint32_t n, Patches& result)
{
  gatherChords(n);
  const Box box = boxes_.box(sides_.polyhedral[n]);
  listBoxNodes();
  listLoopNodes(box);
  listSources(n);
  linkChords();
  for (const SideEdge& first : boxChords_)
  {
    walk_.clear();
    for (std::uint32_t here = local(first.from); leaving_[here] != None;)
    {
      walk_.push_back(here);
      const std::uint32_t c = leaving_[here];
      leaving_[here] = sameFrom_[c];
      here = local(boxChords_[c].to);
    }
    forEachSimpleLoop(walk_, [&](const std::uint32_t* begin, const std::uint32_t* end) {
      triangulate(begin, end, result);
    });
  }
}

void LoopPatches::listLoopNodes(const Box& box)
{
  loopNodes_.assign(boxNodes_.size(), LoopNode{ 0, { 0, 0, 0 }, { 0, 0, 0 }, 0 });
  for (std::size_t c = 0; c < boxChords_.size(); ++c)
  {
    for (const std::uint32_t node : { boxChords_[c].from, boxChords_[c].to })
    {
      LoopNode& loopNode = loopNodes_[local(node)];
      loopNode.normal = plus(loopNode.normal, normals_[c]);
    }
  }
  for (std::uint32_t i = 0; i < boxNodes_.size(); ++i)
  {
    const Point& p = at(boxNodes_[i]);
    loopNodes_[i].id = boxNodes_[i];
    loopNodes_[i].at = minus(p, box.low);
    loopNodes_[i].normal = unit(loopNodes_[i].normal);
    loopNodes_[i].planes = planesOf(box, p);
  }
}

void LoopPatches::triangulate(const std::uint32_t* begin, const std::uint32_t* end, Patches& result)
{
  loop_.clear();
  for (const std::uint32_t* node = begin; node != end; ++node)
  {
    loop_.push_back(loopNodes_[*node]);
  }
  for (const auto& t : triangulation_.triangulate(loop_))
  {
    const Vector normal =
      unit(cross(minus(loop_[t[1]].at, loop_[t[0]].at), minus(loop_[t[2]].at, loop_[t[0]].at)));
    const std::size_t source = mostAlike(normal);
    for (const std::uint32_t i : t)
    {
      result.corners.push_back(numberOf(loop_[i].id));
    }
    result.start.push_back(result.corners.size());
    result.triangle.push_back(patches_.triangle[source]);
    result.boundary.push_back(patches_.boundary[source]);
  }
}

std::uint32_t LoopPatches::numberOf(std::uint32_t node) const
{
  return node < nodes_.patchPoints
    ? node
    : static_cast<std::uint32_t>(node - nodes_.at.size() + nodes_.patchPoints);
}

// The patches that the box had, or its neighbours, or the first one of all.
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
