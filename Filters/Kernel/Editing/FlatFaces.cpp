// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/FlatFaces.h"

#include "Base/Rings.h"
#include "Base/Sorting.h"
#include "Editing/CellClosure.h"
#include "Editing/EditDecision.h"
#include "Editing/EditMeasures.h"
#include "Editing/FixedList.h"
#include "Editing/PrimitiveEdits.h"
#include "Editing/VolumeDeficits.h"
#include "Quality/Limits.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t ItemsAChunk = 4096;
constexpr std::size_t Most = 256; // corners of a face, faces of a node

// Differences of places are exact, products of them are rounded: by less than this part of the square of a length. What is
// nearer to a line is so by far less than a step of the lattice.
constexpr double Rounding = 0x1p-50;

using Few = FixedList<std::uint32_t, Most>;
using OnEdge = FixedList<std::pair<double, std::uint32_t>, Most>;

bool isOnLine(const Vector& way, const Vector& along)
{
  const double square = dot(along, along);
  const Vector area = cross(way, along);
  return dot(area, area) <= Rounding * square * Rounding * square;
}

// Whether the places corner(0) to corner(size - 1) lie on a line.
template <class Corner>
bool areOnLine(std::size_t size, Corner&& corner)
{
  const Vector origin = corner(0);
  if (size > 2 && !isOnLine(minus(corner(1), origin), minus(corner(2), origin)) &&
    !isOnLine(minus(corner(2), origin), minus(corner(1), origin)))
  {
    return false; // as nearly all
  }
  Vector along{};
  for (std::size_t i = 1; i < size; ++i)
  {
    const Vector way = minus(corner(i), origin);
    along = dot(way, way) > dot(along, along) ? way : along;
  }
  for (std::size_t i = 1; i < size; ++i)
  {
    if (!isOnLine(minus(corner(i), origin), along))
    {
      return false;
    }
  }
  return true;
}

bool copy(Items items, Few& list)
{
  list.resize(items.size());
  std::copy_n(items.begin(), list.size(), list.begin());
  return items.size() <= Most;
}

bool areTwins(const MeshView& mesh, std::uint32_t f, std::uint32_t g)
{
  const Items ring = mesh.cornersOf(f);
  const Items other = mesh.cornersOf(g);
  return f != g && ring.size() == other.size() &&
    std::all_of(
      ring.begin(), ring.end(), [&](std::uint32_t n) { return placeOf(other, n) < other.size(); });
}

// Takes a flat face out of the mesh. Each step returns false where that cannot be: then all is undone.
class Removal
{
public:
  // `mayTouch`: cells may touch themselves along its edges afterwards, as others do, and two walls each other.
  Removal(MeshEditor& mesh, std::uint32_t f, bool mayTouch = false)
    : mesh_(mesh)
    , face_(f)
    , mayTouch_(mayTouch)
  {
  }

  // Without it: its edges divided.
  bool divide()
  {
    if (!copy(mesh_.cornersOf(face_), ring_))
    {
      return false;
    }
    for (std::size_t i = 0; i < ring_.size(); ++i)
    {
      if (!divideEdge(ring_[i], following(ring_, i)))
      {
        return false;
      }
    }
    mesh_.removeFace(face_);
    return isSound();
  }

  // A cell of few other faces only holds what these are warped: it becomes part of another.
  bool merge(std::uint32_t c, std::uint32_t into) { return mergeCells(mesh_, into, c) && finish(); }

  // ... or it goes, with what it held.
  bool remove(std::uint32_t c)
  {
    return mesh_.facesOf(c).size() <= SolverLimits::Faces && removeCell(mesh_, c) && finish();
  }

  // A corner becomes the one before.
  bool collapse(std::uint32_t u, std::uint32_t v)
  {
    const EditNode& from = mesh_.node(u);
    const EditNode& to = mesh_.node(v);
    return (from.constrainedAxes & ~to.constrainedAxes) == 0 && (to.atWall || !from.atWall) &&
      collapseEdge(mesh_, u, v, to.at) && isSound();
  }

private:
  bool finish() { return mesh_.face(face_).gone ? isSound() : divide(); }

  bool isSound()
  {
    for (const std::uint32_t f : mesh_.dirty.faces)
    {
      if (!mesh_.face(f).gone && !dropFold(f))
      {
        return false;
      }
    }
    const auto& cells = mesh_.dirty.shapes;
    return std::all_of(cells.begin(), cells.end(),
      [&](std::uint32_t c) { return mesh_.cell(c).gone || isWhole(c); });
  }

  bool isWhole(std::uint32_t c)
  {
    if (mesh_.isGhost(c))
    {
      return false;
    }
    if (mayTouch_ && !mesh_.cell(c).touches && touchesItself(mesh_, c))
    {
      mesh_.changeCell(c).touches = true;
    }
    return isClosed(mesh_, c);
  }

  // Two walls with the same corners are a wall without thickness: inside a cell it goes, between two it may stay. Other
  // faces have no twins.
  bool dropFold(std::uint32_t f)
  {
    const Items around = mesh_.facesAround(mesh_.cornersOf(f)[0]);
    const std::uint32_t* twin = std::find_if(
      around.begin(), around.end(), [&](std::uint32_t g) { return areTwins(mesh_, f, g); });
    if (twin == around.end())
    {
      return true;
    }
    const std::uint32_t g = *twin;
    if (!mesh_.isWall(f) || !mesh_.isWall(g))
    {
      return false;
    }
    if (mesh_.face(f).below != mesh_.face(g).below)
    {
      return mayTouch_;
    }
    mesh_.removeFace(f);
    mesh_.removeFace(g);
    return true;
  }

  // The corners of the flat face within an edge of it, from u on.
  OnEdge cornersWithin(std::uint32_t u, std::uint32_t v) const
  {
    const Vector& from = mesh_.node(u).at;
    const Vector along = minus(mesh_.node(v).at, from);
    OnEdge within;
    for (const std::uint32_t n : ring_)
    {
      const double part = dot(minus(mesh_.node(n).at, from), along);
      if (n != u && n != v && part > 0 && part < dot(along, along))
      {
        within.push({ part, n });
      }
    }
    std::sort(within.begin(), within.end());
    return within;
  }

  // In all other faces that have it.
  bool divideEdge(std::uint32_t u, std::uint32_t v)
  {
    const OnEdge within = cornersWithin(u, v);
    Few faces;
    if (within.empty())
    {
      return true;
    }
    if (!copy(mesh_.facesAround(u), faces))
    {
      return false;
    }
    return std::all_of(faces.begin(), faces.end(), [&](std::uint32_t f) {
      return f == face_ || mesh_.face(f).gone || divideEdgeOf(f, u, v, within);
    });
  }

  bool divideEdgeOf(std::uint32_t f, std::uint32_t u, std::uint32_t v, const OnEdge& within)
  {
    Few ring;
    if (!copy(mesh_.cornersOf(f), ring))
    {
      return false;
    }
    Few divided;
    bool isWhole = true;
    bool has = false;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const std::uint32_t next = following(ring, i);
      const bool isForward = ring[i] == u && next == v;
      const bool isBackward = ring[i] == v && next == u;
      isWhole = divided.add(ring[i]) && isWhole;
      has = has || isForward || isBackward;
      for (std::size_t k = 0; (isForward || isBackward) && k < within.size(); ++k)
      {
        isWhole = divided.add(within[isForward ? k : within.size() - 1 - k].second) && isWhole;
      }
    }
    return !has || (isWhole && !touchesGhost(f) && setCorners(f, divided));
  }

  bool touchesGhost(std::uint32_t f) const
  {
    const EditFace& face = mesh_.face(f);
    return mesh_.isGhost(face.below) || (face.above != None && mesh_.isGhost(face.above));
  }

  // Where a face goes along an edge and back, it ends before.
  bool setCorners(std::uint32_t f, Few& ring)
  {
    for (std::size_t i = 0; i < ring.size() && ring.size() > 2;)
    {
      const std::size_t next = (i + 1) % ring.size();
      const std::size_t after = (i + 2) % ring.size();
      if (ring[i] != ring[after])
      {
        ++i;
        continue;
      }
      Few kept;
      for (std::size_t k = 0; k < ring.size(); ++k)
      {
        k != next&& k != after ? void(kept.add(ring[k])) : void();
      }
      ring = kept;
      i = 0;
    }
    if (ring.size() < 3) // it was flat itself
    {
      mesh_.removeFace(f);
      return true;
    }
    mesh_.setCorners(f, ring.data(), ring.size());
    Few sorted = ring;
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
  }

  MeshEditor& mesh_;
  std::uint32_t face_;
  bool mayTouch_;
  Few ring_;
};

class FlatFaceRemover
{
public:
  FlatFaceRemover(MeshEditor& mesh, const EditRules& rules)
    : mesh_(mesh)
    , rules_(rules)
  {
  }

  // The first way that leaves the mesh sound.
  void remove(std::uint32_t f)
  {
    const auto divide = [&](bool mayTouch) {
      return tryEdit([&] { return Removal(mesh_, f, mayTouch).divide(); });
    };
    const EditFace face = mesh_.face(f);
    divide(false) || divide(true) || removeCellOf(f, face.below) ||
      (face.above != None && removeCellOf(f, face.above)) || collapse(f);
  }

  std::vector<MadeEdit> takeEdits() { return std::move(edits_); }

private:
  bool removeCellOf(std::uint32_t f, std::uint32_t c)
  {
    if (!mesh_.isFree(c))
    {
      return false;
    }
    for (const std::uint32_t other : largestNeighbours(mesh_, c))
    {
      if (mayMerge(mesh_, rules_, other, c) &&
        tryEdit([&] { return Removal(mesh_, f, true).merge(c, other); }))
      {
        edits_.push_back(madeEdit(mesh_, EditKind::Merge, other));
        return true;
      }
    }
    const MadeEdit edit = madeEdit(mesh_, EditKind::Remove, c);
    const bool isRemoved = tryEdit([&] { return Removal(mesh_, f, true).remove(c); });
    if (isRemoved)
    {
      edits_.push_back(edit);
      edits_.back().reason = RemovalReason::Refused;
    }
    return isRemoved;
  }

  bool collapse(std::uint32_t f)
  {
    Few ring;
    if (!rules_.mayChangeWalls || !copy(mesh_.cornersOf(f), ring))
    {
      return false;
    }
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const std::uint32_t u = ring[i];
      const std::uint32_t v = following(ring, i);
      if (tryEdit([&] { return Removal(mesh_, f).collapse(u, v); }) ||
        tryEdit([&] { return Removal(mesh_, f).collapse(v, u); }))
      {
        return true;
      }
    }
    return false;
  }

  // False: the mesh is as before.
  template <class Edit>
  bool tryEdit(Edit&& edit)
  {
    const MeshEditor::Mark mark = mesh_.mark();
    if (!edit() || !measureDirty(mesh_))
    {
      mesh_.undo(mark);
      return false;
    }
    passOnDeficits(mesh_);
    std::vector<std::uint32_t> changed;
    listChanged(mesh_, changed);
    mesh_.commit();
    changed = sortedUnique(std::move(changed));
    costCells(mesh_, { changed.data(), changed.data() + changed.size() }, rules_.objective);
    return true;
  }

  MeshEditor& mesh_;
  const EditRules& rules_;
  std::vector<MadeEdit> edits_;
};

}

bool isFlat(const MeshView& mesh, std::uint32_t f)
{
  return areOnLine(
    mesh.face(f).corners.size, [&](std::size_t i) -> const Vector& { return mesh.corner(f, i); });
}

std::vector<MadeEdit> removeFlatFaces(EditMesh& whole, const EditRules& rules, Execution& execution)
{
  std::vector<std::vector<std::uint32_t>> ofChunks(chunks(whole.faces.size(), ItemsAChunk));
  execution.forEach(whole.faces.size(), ItemsAChunk, [&](std::size_t begin, std::size_t end) {
    const MeshView mesh(whole);
    for (auto f = static_cast<std::uint32_t>(begin); f < end; ++f)
    {
      if (!mesh.face(f).gone && isFlat(mesh, f))
      {
        ofChunks[begin / ItemsAChunk].push_back(f);
      }
    }
  });
  MeshEditor mesh(whole, 0, 0, {});
  FlatFaceRemover remover(mesh, rules);
  for (const std::uint32_t f : concatenated(ofChunks))
  {
    if (!mesh.face(f).gone)
    {
      remover.remove(f);
    }
  }
  return remover.takeEdits();
}

bool hasFlatFaces(const Nodes& nodes, const WallMesh& wall, Execution& execution)
{
  const WallFaces& faces = wall.faces;
  std::vector<std::uint8_t> has(chunks(faces.size(), ItemsAChunk));
  execution.forEach(faces.size(), ItemsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end && has[begin / ItemsAChunk] == 0; ++f)
    {
      const std::uint32_t* corners = faces.corners.data() + faces.start[f];
      const Point& origin = nodes.at[*corners];
      const bool isUsed = faces.cells[f][0] != None || faces.cells[f][1] != None;
      const bool is = isUsed && areOnLine(faces.start[f + 1] - faces.start[f], [&](std::size_t i) {
        return minus(nodes.at[corners[i]], origin);
      });
      has[begin / ItemsAChunk] = is ? 1 : 0;
    }
  });
  return std::find(has.begin(), has.end(), 1) != has.end();
}

}
