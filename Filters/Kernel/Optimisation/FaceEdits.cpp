// SPDX-License-Identifier: BSD-3-Clause
#include "Optimisation/FaceEdits.h"

#include "Acceptance/CellFaults.h"
#include "Base/Sorting.h"

#include <algorithm>
#include <tuple>

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

bool FaceEdits::Side::operator<(const Side& other) const
{
  return std::tie(low, high, isUp, face) < std::tie(other.low, other.high, other.isUp, other.face);
}

bool FaceEdits::Side::hasSameEdge(const Side& other) const
{
  return low == other.low && high == other.high;
}

bool FaceEdits::Side::isOpposite(const Side& other) const
{
  return hasSameEdge(other) && isUp != other.isUp;
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
  faces_ = around.faces;
  cells_ = around.cells;
  remaining_ = around.faces;
  corners_ = m_.faces.corners.size();
  kept_.clear();
  rings_.clear();
  for (const std::uint32_t f : faces_)
  {
    rings_.push_back(kept(m_.faces.corners, m_.faces.start[f], m_.faces.stop[f]));
  }
  cornersKept_ = kept_.size();
  uses_.clear();
  for (const std::uint32_t c : cells_)
  {
    uses_.push_back(kept(m_.cells.uses, m_.cells.firstUse[c], m_.cells.endUse[c]));
  }
}

FaceEdits::Range FaceEdits::kept(const Numbers& from, std::uint32_t begin, std::uint32_t end)
{
  const Range range{ begin, end, kept_.size() };
  kept_.insert(kept_.end(), from.begin() + begin, from.begin() + end);
  return range;
}

void FaceEdits::putBack(const Range& range, Numbers& into) const
{
  const auto first = kept_.begin() + std::ptrdiff_t(range.kept);
  std::copy(first, first + (range.end - range.begin), into.begin() + range.begin);
}

void FaceEdits::putBack()
{
  m_.faces.corners.resize(corners_);
  for (std::size_t i = 0; i < faces_.size(); ++i)
  {
    m_.faces.start[faces_[i]] = rings_[i].begin;
    m_.faces.stop[faces_[i]] = rings_[i].end;
    putBack(rings_[i], m_.faces.corners);
    isGone_[faces_[i]] = 0;
  }
  for (std::size_t i = 0; i < cells_.size(); ++i)
  {
    m_.cells.endUse[cells_[i]] = uses_[i].end;
    putBack(uses_[i], m_.cells.uses);
  }
}

void FaceEdits::commit()
{
  for (const std::uint32_t f : faces_)
  {
    isEdited_[f] = 1;
  }
  // Corners that were lose faces, those that are get some.
  ring_.assign(kept_.begin(), kept_.begin() + std::ptrdiff_t(cornersKept_));
  for (const std::uint32_t f : remaining_)
  {
    m_.forEachCorner(f, [&](std::uint32_t node) { ring_.push_back(node); });
  }
  ring_ = sortedUnique(std::move(ring_));
  for (const std::uint32_t node : ring_)
  {
    const NumberLists::List faces = facesOf_[node];
    other_.assign(faces.begin(), faces.end());
    other_.insert(other_.end(), remaining_.begin(), remaining_.end());
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
  remaining_.erase(std::remove(remaining_.begin(), remaining_.end(), f), remaining_.end());
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
  if (size > sizeOf(f))
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
  return std::all_of(faces_.begin(), faces_.end(), [&](std::uint32_t f) {
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
  pairs_.clear();
  std::copy_if(edges_.begin(), edges_.end(), std::back_inserter(pairs_),
    [&](const auto& edge) { return !isInner(edge); });
  if (pairs_.size() < 3 || pairs_.size() == edges_.size())
  {
    return false;
  }
  for (std::uint32_t at = pairs_.front()[0]; ring_.size() < pairs_.size();)
  {
    const auto next =
      std::find_if(pairs_.begin(), pairs_.end(), [&](const auto& edge) { return edge[0] == at; });
    if (next == pairs_.end() || std::find(ring_.begin(), ring_.end(), at) != ring_.end())
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
  return std::all_of(cells_.begin(), cells_.end(), [&](std::uint32_t c) { return isClosed(c); }) &&
    std::none_of(remaining_.begin(), remaining_.end(), [&](std::uint32_t f) { return hasTwin(f); });
}

// Whether each edge of a cell is between two faces, which have others too.
bool FaceEdits::isClosed(std::uint32_t c)
{
  if (m_.cells.endUse[c] - m_.cells.firstUse[c] < LeastFaces)
  {
    return false;
  }
  sides_.clear();
  for (std::uint32_t u = m_.cells.firstUse[c]; u < m_.cells.endUse[c]; ++u)
  {
    const std::uint32_t f = m_.cells.uses[u];
    const bool turned = m_.faces.cells[f][0] != c;
    std::uint32_t from = m_.faces.corners[m_.faces.stop[f] - 1];
    m_.forEachCorner(f, [&](std::uint32_t to) {
      sides_.push_back({ std::min(from, to), std::max(from, to), (from < to) != turned, f });
      from = to;
    });
  }
  std::sort(sides_.begin(), sides_.end());
  pairs_.clear();
  for (std::size_t i = 0; i < sides_.size(); i += 2)
  {
    if (i + 1 == sides_.size() || !sides_[i].isOpposite(sides_[i + 1]) ||
      (i + 2 < sides_.size() && sides_[i].hasSameEdge(sides_[i + 2])))
    {
      return false;
    }
    pairs_.push_back({ std::min(sides_[i].face, sides_[i + 1].face),
      std::max(sides_[i].face, sides_[i + 1].face) });
  }
  return !areFoldedTogether();
}

// Whether two of the faces that share an edge share all edges of one of them: nothing is between.
bool FaceEdits::areFoldedTogether()
{
  std::sort(pairs_.begin(), pairs_.end());
  for (auto begin = pairs_.begin(); begin != pairs_.end();)
  {
    const auto end =
      std::find_if(begin, pairs_.end(), [&](const auto& pair) { return pair != *begin; });
    const auto shared = static_cast<std::size_t>(end - begin);
    if (shared >= std::min(sizeOf((*begin)[0]), sizeOf((*begin)[1])))
    {
      return true;
    }
    begin = end;
  }
  return false;
}

// Whether another face has the same nodes, or, where that is not known, may have.
bool FaceEdits::hasTwin(std::uint32_t f)
{
  copyRing(f, ring_);
  std::sort(ring_.begin(), ring_.end());
  const auto node = std::find_if(
    ring_.begin(), ring_.end(), [&](std::uint32_t n) { return m_.nodes.mayMove[n] != 0; });
  const auto isTwin = [&](std::uint32_t g) {
    if (g == f || isGone_[g] || sizeOf(g) != ring_.size())
    {
      return false;
    }
    copyRing(g, other_);
    std::sort(other_.begin(), other_.end());
    return other_ == ring_;
  };
  return node == ring_.end() ||
    std::any_of(facesOf_[*node].begin(), facesOf_[*node].end(), isTwin) ||
    std::any_of(remaining_.begin(), remaining_.end(), isTwin);
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
