// SPDX-License-Identifier: BSD-3-Clause
#include "Optimisation/FaceEdits.h"

#include "Base/Sorting.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// Without corners twice in a row, and without edges there and back.
void removeSpikes(std::vector<std::uint32_t>& ring)
{
  const auto erase = [&](std::size_t i) { ring.erase(ring.begin() + std::ptrdiff_t(i)); };
  for (std::size_t i = 0; i < ring.size() && ring.size() > 2;)
  {
    const std::size_t next = (i + 1) % ring.size();
    const std::size_t last = (i + ring.size() - 1) % ring.size();
    if (ring[i] == ring[next])
    {
      erase(i);
      i = 0;
    }
    else if (ring[last] == ring[next])
    {
      erase(std::max(i, next));
      erase(std::min(i, next));
      i = 0;
    }
    else
    {
      ++i;
    }
  }
}

}

void NumberLists::set(std::size_t i, const std::vector<std::uint32_t>& numbers)
{
  if (numbers.size() > size_[i])
  {
    begin_[i] = values_.size();
    values_.resize(values_.size() + numbers.size());
  }
  size_[i] = numbers.size();
  std::copy(numbers.begin(), numbers.end(), values_.begin() + std::ptrdiff_t(begin_[i]));
}

FaceEdits::FaceEdits(NodeMesh& mesh)
  : m_(mesh)
  , closed_(mesh)
  , isEdited_(mesh.faces.size())
  , isGone_(mesh.faces.size())
{
  facesOf_.fill(mesh.nodes.at.size(), [&](auto&& add) {
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
    {
      mesh.forEachCorner(f, [&](std::uint32_t node) { add(node, f); });
    }
  });
}

void FaceEdits::copyRing(std::uint32_t f, Numbers& ring) const
{
  ring.assign(
    m_.faces.corners.begin() + m_.faces.start[f], m_.faces.corners.begin() + m_.faces.stop[f]);
}

bool FaceEdits::hasCorner(std::uint32_t f, std::uint32_t node) const
{
  const auto end = m_.faces.corners.begin() + m_.faces.stop[f];
  return std::find(m_.faces.corners.begin() + m_.faces.start[f], end, node) != end;
}

void FaceEdits::lookAround(Surroundings& around) const
{
  around.cells.clear();
  for (const std::uint32_t f : around.faces)
  {
    for (const std::uint32_t c : m_.faces.cells[f])
    {
      if (c < m_.cells.changing)
      {
        around.cells.push_back(c);
      }
    }
  }
  around.cells = sortedUnique(std::move(around.cells));
  around.facesOfCells.clear();
  for (const std::uint32_t c : around.cells)
  {
    around.facesOfCells.insert(around.facesOfCells.end(),
      m_.cells.uses.begin() + m_.cells.firstUse[c], m_.cells.uses.begin() + m_.cells.endUse[c]);
  }
  around.facesOfCells = sortedUnique(std::move(around.facesOfCells));
}

bool FaceEdits::mayChange(std::uint32_t f) const
{
  const auto& cells = m_.faces.cells[f];
  return m_.faces.number[f] != None &&
    std::all_of(cells.begin(), cells.end(), [&](std::uint32_t c) {
      return c == None || (c < m_.cells.changing && m_.cells.number[c] != None);
    });
}

bool FaceEdits::areBetweenTheSame(std::uint32_t f, std::uint32_t g) const
{
  const auto& mine = m_.faces.cells[f];
  const auto& other = m_.faces.cells[g];
  return (mine == other || (mine[0] == other[1] && mine[1] == other[0])) &&
    m_.faces.boundary[f] == m_.faces.boundary[g];
}

// --- one edit

void FaceEdits::keep(const Surroundings& around)
{
  now_.faces = around.faces;
  now_.cells = around.cells;
  now_.remaining = around.faces;
  now_.corners = m_.faces.corners.size();
  now_.kept.clear();
  now_.rings.clear();
  for (const std::uint32_t f : now_.faces)
  {
    now_.rings.push_back(kept(m_.faces.corners, m_.faces.start[f], m_.faces.stop[f]));
  }
  now_.cornersKept = now_.kept.size();
  now_.uses.clear();
  for (const std::uint32_t c : now_.cells)
  {
    now_.uses.push_back(kept(m_.cells.uses, m_.cells.firstUse[c], m_.cells.endUse[c]));
  }
}

FaceEdits::Range FaceEdits::kept(const Numbers& from, std::uint32_t begin, std::uint32_t end)
{
  const Range range{ begin, end, now_.kept.size() };
  now_.kept.insert(now_.kept.end(), from.begin() + begin, from.begin() + end);
  return range;
}

void FaceEdits::putBack(const Range& range, Numbers& into) const
{
  const auto first = now_.kept.begin() + std::ptrdiff_t(range.kept);
  std::copy(first, first + (range.end - range.begin), into.begin() + range.begin);
}

void FaceEdits::putBack()
{
  m_.faces.corners.resize(now_.corners);
  for (std::size_t i = 0; i < now_.faces.size(); ++i)
  {
    m_.faces.start[now_.faces[i]] = now_.rings[i].begin;
    m_.faces.stop[now_.faces[i]] = now_.rings[i].end;
    putBack(now_.rings[i], m_.faces.corners);
    isGone_[now_.faces[i]] = 0;
  }
  for (std::size_t i = 0; i < now_.cells.size(); ++i)
  {
    m_.cells.endUse[now_.cells[i]] = now_.uses[i].end;
    putBack(now_.uses[i], m_.cells.uses);
  }
}

void FaceEdits::commit()
{
  for (const std::uint32_t f : now_.faces)
  {
    isEdited_[f] = 1;
  }
  // Corners that were lose faces, those that are get some.
  ring_.assign(now_.kept.begin(), now_.kept.begin() + std::ptrdiff_t(now_.cornersKept));
  for (const std::uint32_t f : now_.remaining)
  {
    m_.forEachCorner(f, [&](std::uint32_t node) { ring_.push_back(node); });
  }
  ring_ = sortedUnique(std::move(ring_));
  for (const std::uint32_t node : ring_)
  {
    const NumberLists::List faces = facesOf_[node];
    other_.assign(faces.begin(), faces.end());
    other_.insert(other_.end(), now_.remaining.begin(), now_.remaining.end());
    other_.erase(std::remove_if(other_.begin(), other_.end(),
                   [&](std::uint32_t f) { return isGone_[f] || !hasCorner(f, node); }),
      other_.end());
    other_ = sortedUnique(std::move(other_));
    facesOf_.set(node, other_);
  }
}

void FaceEdits::remove(std::uint32_t f)
{
  isGone_[f] = 1;
  now_.remaining.erase(
    std::remove(now_.remaining.begin(), now_.remaining.end(), f), now_.remaining.end());
  for (const std::uint32_t c : m_.faces.cells[f])
  {
    if (c < m_.cells.changing)
    {
      const auto begin = m_.cells.uses.begin() + m_.cells.firstUse[c];
      const auto end = m_.cells.uses.begin() + m_.cells.endUse[c];
      m_.cells.endUse[c] -= static_cast<std::uint32_t>(end - std::remove(begin, end, f));
    }
  }
}

// In its place, or, if it is larger than before, behind all others.
void FaceEdits::setRing(std::uint32_t f, const Numbers& ring)
{
  const auto size = static_cast<std::uint32_t>(ring.size());
  if (size > m_.faces.sizeOf(f))
  {
    m_.faces.start[f] = static_cast<std::uint32_t>(m_.faces.corners.size());
    m_.faces.corners.resize(m_.faces.corners.size() + size);
  }
  std::copy(ring.begin(), ring.end(), m_.faces.corners.begin() + m_.faces.start[f]);
  m_.faces.stop[f] = m_.faces.start[f] + size;
}

bool FaceEdits::collapse(std::uint32_t from, std::uint32_t into, const Surroundings& around)
{
  keep(around);
  return std::all_of(now_.faces.begin(), now_.faces.end(), [&](std::uint32_t f) {
    copyRing(f, ring_);
    std::replace(ring_.begin(), ring_.end(), from, into);
    removeSpikes(ring_);
    if (ring_.size() < 3)
    {
      remove(f);
      return true;
    }
    if (std::count(ring_.begin(), ring_.end(), into) > 1)
    {
      return false;
    }
    setRing(f, ring_);
    return true;
  });
}

bool FaceEdits::join(std::uint32_t f, std::uint32_t g, const Surroundings& around)
{
  keep(around);
  edges_.clear();
  listEdges(f, false);
  listEdges(g, m_.faces.cells[f] != m_.faces.cells[g]);
  if (!traceUnion())
  {
    return false;
  }
  const auto stays = [&](std::uint32_t node) {
    return std::find(ring_.begin(), ring_.end(), node) != ring_.end() || areOnlyOf(node, f, g);
  };
  bool isMesh = true;
  for (const std::uint32_t face : { f, g })
  {
    m_.forEachCorner(face, [&](std::uint32_t node) { isMesh = isMesh && stays(node); });
  }
  if (!isMesh)
  {
    return false;
  }
  setRing(f, ring_);
  remove(g);
  return true;
}

void FaceEdits::listEdges(std::uint32_t f, bool turned)
{
  std::uint32_t from = m_.faces.corners[m_.faces.stop[f] - 1];
  m_.forEachCorner(f, [&](std::uint32_t to) {
    edges_.push_back({ turned ? to : from, turned ? from : to });
    from = to;
  });
}

// One ring of all edges that are not there in both directions; false where there are several, or one meets itself.
bool FaceEdits::traceUnion()
{
  ring_.clear();
  const auto isInner = [&](const std::array<std::uint32_t, 2>& edge) {
    return std::find(edges_.begin(), edges_.end(),
             std::array<std::uint32_t, 2>{ edge[1], edge[0] }) != edges_.end();
  };
  outer_.clear();
  std::copy_if(edges_.begin(), edges_.end(), std::back_inserter(outer_),
    [&](const auto& edge) { return !isInner(edge); });
  if (outer_.size() < 3 || outer_.size() == edges_.size())
  {
    return false;
  }
  for (std::uint32_t at = outer_.front()[0]; ring_.size() < outer_.size();)
  {
    const auto next =
      std::find_if(outer_.begin(), outer_.end(), [&](const auto& edge) { return edge[0] == at; });
    if (next == outer_.end() || std::find(ring_.begin(), ring_.end(), at) != ring_.end())
    {
      return false;
    }
    ring_.push_back(at);
    at = (*next)[1];
  }
  return true;
}

// Whether no other face has a node.
bool FaceEdits::areOnlyOf(std::uint32_t node, std::uint32_t f, std::uint32_t g) const
{
  return m_.nodes.mayMove[node] &&
    std::all_of(facesOf_[node].begin(), facesOf_[node].end(),
      [&](std::uint32_t other) { return other == f || other == g; });
}

// --- soundness

bool FaceEdits::isSound()
{
  return std::all_of(now_.cells.begin(), now_.cells.end(),
           [&](std::uint32_t c) { return closed_.isClosed(c); }) &&
    std::none_of(
      now_.remaining.begin(), now_.remaining.end(), [&](std::uint32_t f) { return hasTwin(f); });
}

// Whether another face has the same nodes, or, where that is not known, may have.
bool FaceEdits::hasTwin(std::uint32_t f)
{
  copyRing(f, ring_);
  std::sort(ring_.begin(), ring_.end());
  const auto node = std::find_if(
    ring_.begin(), ring_.end(), [&](std::uint32_t n) { return m_.nodes.mayMove[n] != 0; });
  const auto isTwin = [&](std::uint32_t g) {
    if (g == f || isGone_[g] || m_.faces.sizeOf(g) != ring_.size())
    {
      return false;
    }
    copyRing(g, other_);
    std::sort(other_.begin(), other_.end());
    return other_ == ring_;
  };
  return node == ring_.end() ||
    std::any_of(facesOf_[*node].begin(), facesOf_[*node].end(), isTwin) ||
    std::any_of(now_.remaining.begin(), now_.remaining.end(), isTwin);
}

std::vector<FaceEdit> FaceEdits::edits() const
{
  std::vector<FaceEdit> edits;
  for (std::uint32_t f = 0; f < m_.faces.size(); ++f)
  {
    if (!isEdited_[f])
    {
      continue;
    }
    FaceEdit edit{ m_.faces.number[f], {} };
    if (!isGone_[f])
    {
      m_.forEachCorner(f, [&](std::uint32_t n) { edit.ring.push_back(m_.nodes.number[n]); });
    }
    if (m_.faces.isTurned[f])
    {
      std::reverse(edit.ring.begin(), edit.ring.end());
    }
    edits.push_back(std::move(edit));
  }
  std::sort(edits.begin(), edits.end(),
    [](const FaceEdit& a, const FaceEdit& b) { return a.face < b.face; });
  return edits;
}

}
