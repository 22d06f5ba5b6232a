// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/PrimitiveEdits.h"

#include "Base/Rings.h"
#include "Editing/FixedList.h"

#include <cassert>
#include <cmath>

namespace cartesian
{

namespace
{

// Faces with more corners, and cells and nodes with more faces, are not edited.
constexpr std::size_t Most = 256;
using Few = FixedList<std::uint32_t, Most>;

bool copy(Items items, Few& list)
{
  if (items.size() > Most)
  {
    return false;
  }
  list.resize(items.size());
  std::copy(items.begin(), items.end(), list.begin());
  return true;
}

bool isFrozen(const MeshView& mesh, std::uint32_t c)
{
  return c != None && !mesh.isFree(c);
}

bool haveSameCorners(const MeshView& mesh, std::uint32_t f, std::uint32_t g)
{
  const Items corners = mesh.cornersOf(f);
  const Items others = mesh.cornersOf(g);
  return corners.size() == others.size() &&
    std::all_of(corners.begin(), corners.end(),
      [&](std::uint32_t n) { return placeOf(others, n) < others.size(); });
}

void touch(MeshEditor& mesh, std::uint32_t c)
{
  mesh.dirty.cells.add(c);
  mesh.dirty.shapes.add(c);
}

// A cell between two faces of the same corners goes: one face is left of two, between what was beyond them, or none.
bool dropFlat(MeshEditor& mesh, std::uint32_t c)
{
  const Items faces = mesh.facesOf(c);
  if (faces.size() != 2)
  {
    return faces.size() > 2;
  }
  std::uint32_t stays = faces[0];
  std::uint32_t goes = faces[1];
  if (!haveSameCorners(mesh, stays, goes))
  {
    return false;
  }
  if (mesh.isWall(stays))
  {
    std::swap(stays, goes);
  }
  const std::uint32_t x = mesh.beyond(stays, c);
  const std::uint32_t y = mesh.beyond(goes, c);
  if (isFrozen(mesh, x) || isFrozen(mesh, y))
  {
    return false;
  }
  const auto regionOf = [&](std::uint32_t i) { return mesh.cell(i).region; };
  const bool isOfX = x != None && regionOf(x) == regionOf(c);
  const bool isOfY = y != None && regionOf(y) == regionOf(c);
  if ((x != None || y != None) && !isOfX && (y == None || !isOfY))
  {
    return false; // a region would end at walls of another
  }
  if (x == y) // nothing, or one cell on both sides: then its wall has closed
  {
    mesh.removeFace(stays);
    mesh.removeFace(goes);
    mesh.removeCell(c);
    return x == None || dropFlat(mesh, x);
  }
  const EditFace wall = mesh.face(goes);
  mesh.removeFace(goes);
  if (y == None)
  {
    makeWall(mesh, stays, c, wall.wall);
    EditFace& face = mesh.changeFace(stays);
    face.original = wall.original;
    face.volumeDeficit = wall.volumeDeficit;
    face.accumulatedDeviation = wall.accumulatedDeviation;
  }
  else
  {
    mesh.giveFace(stays, c, y);
    mesh.addFaceTo(y, stays);
    mesh.dirty.faces.add(stays);
    EditFace& face = mesh.changeFace(stays);
    face.wall = std::max(face.wall, wall.wall);
  }
  touch(mesh, x);
  mesh.removeCell(c);
  return true;
}

[[maybe_unused]] bool isThere(const MeshView& mesh, std::uint32_t f)
{
  return f < mesh.faceCount() && !mesh.face(f).gone;
}

[[maybe_unused]] bool isOf(const MeshView& mesh, std::uint32_t f, std::uint32_t c)
{
  return mesh.face(f).below == c || mesh.face(f).above == c;
}

// Takes u out of the corners of its faces, for v. Faces of two corners are left as `flat`.
bool replaceNode(MeshEditor& mesh, std::uint32_t u, std::uint32_t v, const Few& faces, Few& flat)
{
  for (const std::uint32_t f : faces)
  {
    Few ring;
    if (!mesh.areCellsFree(f) || !copy(mesh.cornersOf(f), ring))
    {
      return false;
    }
    const bool hasBoth = ring.contains(v);
    std::uint32_t* end = ring.end();
    if (hasBoth)
    {
      end = std::remove(ring.begin(), ring.end(), u);
    }
    else
    {
      std::replace(ring.begin(), ring.end(), u, v);
    }
    ring.resize(static_cast<std::size_t>(end - ring.begin()));
    mesh.setCorners(f, ring.data(), ring.size());
    if (ring.size() < 3 && !flat.add(f))
    {
      return false;
    }
  }
  return true;
}

// Whether u and v follow each other in every face that has both.
bool isEdgeEverywhere(const MeshView& mesh, std::uint32_t u, std::uint32_t v)
{
  const Items faces = mesh.facesAround(u);
  return std::all_of(faces.begin(), faces.end(), [&](std::uint32_t f) {
    const Items ring = mesh.cornersOf(f);
    const std::size_t i = placeOf(ring, u);
    const std::size_t j = placeOf(ring, v);
    const std::size_t apart = i < j ? j - i : i - j;
    return j == ring.size() || apart == 1 || apart == ring.size() - 1;
  });
}

// The corners of two faces around what they share: one row of edges from a[first] on.
struct SharedRow
{
  std::size_t first = 0;
  std::size_t edges = 0;
};

// False: they share none, several rows, or all.
bool findSharedRow(const Few& a, const Few& b, SharedRow& row)
{
  const auto isShared = [&](std::size_t i) {
    const std::uint32_t from = a[i];
    const std::uint32_t to = following(a, i);
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      if (b[j] == to)
      {
        return following(b, j) == from;
      }
    }
    return false;
  };
  std::size_t rows = 0;
  bool before = isShared(a.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    const bool is = isShared(i);
    if (is && !before)
    {
      row.first = i;
      ++rows;
    }
    row.edges += is ? 1 : 0;
    before = is;
  }
  return rows == 1 && row.edges < b.size();
}

// The corners of the union; false: it would meet itself.
bool traceUnion(const Few& a, const Few& b, const SharedRow& row, Few& ring)
{
  const std::uint32_t from = a[row.first];
  const std::uint32_t to = a[(row.first + row.edges) % a.size()];
  for (std::size_t i = 0; i <= a.size() - row.edges; ++i)
  {
    if (!ring.add(a[(row.first + row.edges + i) % a.size()]))
    {
      return false;
    }
  }
  const auto start = static_cast<std::size_t>(std::find(b.begin(), b.end(), from) - b.begin());
  for (std::size_t j = (start + 1) % b.size(); b[j] != to; j = (j + 1) % b.size())
  {
    if (!ring.add(b[j]))
    {
      return false;
    }
  }
  if (ring.size() < 3 || ring.size() != a.size() + b.size() - 2 * row.edges)
  {
    return false;
  }
  Few sorted = ring;
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
}

}

std::size_t placeOf(Items corners, std::uint32_t n)
{
  return static_cast<std::size_t>(std::find(corners.begin(), corners.end(), n) - corners.begin());
}

Vector onLattice(const MeshView& mesh, const Vector& place, std::uint8_t held)
{
  Vector rounded = place;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if ((held >> axis & 1) == 0)
    {
      const double at = (2 * std::floor(place[axis] / mesh.level() / 2) + 1) * mesh.level();
      rounded[axis] =
        std::clamp(at, mesh.low()[axis] + mesh.level(), mesh.high()[axis] - mesh.level());
    }
  }
  return rounded;
}

bool collapseEdge(MeshEditor& mesh, std::uint32_t u, std::uint32_t v, const Vector& at)
{
  assert(u < mesh.nodeCount() && v < mesh.nodeCount());
  assert(std::isfinite(at[0] + at[1] + at[2]));
  Few faces;
  Few flat;
  if (u == v || mesh.node(u).gone || mesh.node(v).gone || !copy(mesh.facesAround(u), faces) ||
    !isEdgeEverywhere(mesh, u, v) || !replaceNode(mesh, u, v, faces, flat))
  {
    return false;
  }
  for (const std::uint32_t f : flat)
  {
    const std::array<std::uint32_t, 2> cells{ mesh.face(f).below, mesh.face(f).above };
    mesh.removeFace(f);
    for (const std::uint32_t c : cells)
    {
      if (c != None && !mesh.cell(c).gone && !dropFlat(mesh, c))
      {
        return false;
      }
    }
  }
  if (mesh.node(v).gone)
  {
    return false;
  }
  if (mesh.node(u).atWall && !mesh.node(v).atWall)
  {
    mesh.changeNode(v).atWall = true;
  }
  if (at != mesh.node(v).at)
  {
    for (const std::uint32_t f : mesh.facesAround(v))
    {
      if (!mesh.areCellsFree(f))
      {
        return false;
      }
    }
    mesh.moveNode(v, at);
  }
  return true;
}

bool joinFaces(MeshEditor& mesh, std::uint32_t f, std::uint32_t g)
{
  assert(f < mesh.faceCount() && g < mesh.faceCount());
  const EditFace x = mesh.face(f);
  const EditFace y = mesh.face(g);
  const bool isSame = x.below == y.below && x.above == y.above;
  const bool isTurned = x.below == y.above && x.above == y.below;
  if (f == g || x.gone || y.gone || (!isSame && !isTurned) || x.wall != y.wall ||
    !mesh.areCellsFree(f))
  {
    return false;
  }
  Few a;
  Few b;
  Few ring;
  SharedRow row;
  if (!copy(mesh.cornersOf(f), a) || !copy(mesh.cornersOf(g), b))
  {
    return false;
  }
  if (isTurned)
  {
    std::reverse(b.begin(), b.end());
  }
  if (!findSharedRow(a, b, row) || !traceUnion(a, b, row, ring))
  {
    return false;
  }
  for (std::size_t i = 1; i < row.edges; ++i)
  {
    if (mesh.node(a[(row.first + i) % a.size()]).faces.size != 2)
    {
      return false;
    }
  }
  mesh.removeFace(g);
  mesh.setCorners(f, ring.data(), ring.size());
  EditFace& face = mesh.changeFace(f);
  face.original = isSame ? plus(x.original, y.original) : minus(x.original, y.original);
  face.volumeDeficit = x.volumeDeficit + y.volumeDeficit;
  face.accumulatedDeviation = std::max(x.accumulatedDeviation, y.accumulatedDeviation);
  return true;
}

bool passFace(MeshEditor& mesh, std::uint32_t c, std::uint32_t f, std::uint32_t g)
{
  assert(isThere(mesh, f) && isThere(mesh, g));
  assert(isOf(mesh, f, c) && isOf(mesh, g, c));
  const EditFace over = mesh.face(f);
  const EditFace passed = mesh.face(g);
  const std::uint32_t to = mesh.beyond(f, c);
  Few a;
  Few b;
  Few ring;
  SharedRow row;
  if (f == g || over.gone || passed.gone || to == None || mesh.isSurface(f) ||
    mesh.beyond(g, c) == to || mesh.cell(to).region != mesh.cell(c).region ||
    !mesh.areCellsFree(f) || !mesh.areCellsFree(g) || !copy(mesh.cornersOf(f), a) ||
    !copy(mesh.cornersOf(g), b))
  {
    return false;
  }
  if ((over.below == c) != (passed.below == c))
  {
    std::reverse(b.begin(), b.end());
  }
  if (!findSharedRow(a, b, row) || !traceUnion(a, b, row, ring))
  {
    return false;
  }
  mesh.setCorners(f, ring.data(), ring.size());
  mesh.giveFace(g, c, to);
  Few kept;
  for (const std::uint32_t h : mesh.facesOf(c))
  {
    if (h != g && !kept.add(h))
    {
      return false;
    }
  }
  mesh.setFaces(c, kept.data(), kept.size());
  mesh.addFaceTo(to, g);
  mesh.dirty.faces.add(g);
  return true;
}

std::uint32_t splitFace(MeshEditor& mesh, std::uint32_t f, std::size_t i, std::size_t j)
{
  assert(isThere(mesh, f));
  assert(i < mesh.cornersOf(f).size() && j < mesh.cornersOf(f).size());
  Few ring;
  if (!mesh.areCellsFree(f) || !copy(mesh.cornersOf(f), ring))
  {
    return None;
  }
  if (i > j)
  {
    std::swap(i, j);
  }
  const std::size_t size = ring.size();
  if (j - i < 2 || size - (j - i) < 2)
  {
    return None;
  }
  Few kept;
  Few cut;
  for (std::size_t k = i; k <= j; ++k)
  {
    kept.push(ring[k]);
  }
  for (std::size_t k = j; k <= i + size; ++k)
  {
    cut.push(ring[k % size]);
  }
  EditFace made = mesh.face(f);
  const double part = 0.5; // of the deficit, until both are measured
  made.cost = 0;
  made.behind = 0;
  made.fails = 0;
  made.strains = false;
  made.inverted = 0;
  made.skew = false;
  made.volumeDeficit *= part;
  mesh.setCorners(f, kept.data(), kept.size());
  mesh.changeFace(f).volumeDeficit *= part;
  return mesh.makeFace(made, cut.data(), cut.size());
}

bool mergeCells(MeshEditor& mesh, std::uint32_t a, std::uint32_t b)
{
  assert(a < mesh.cellCount() && b < mesh.cellCount());
  Few ofB;
  Few kept;
  if (a == b || !mesh.isFree(a) || !mesh.isFree(b) || mesh.cell(a).region != mesh.cell(b).region ||
    !copy(mesh.facesOf(b), ofB))
  {
    return false;
  }
  bool areNeighbours = false;
  for (const std::uint32_t f : ofB)
  {
    if (mesh.beyond(f, b) == a)
    {
      mesh.removeFace(f, false);
      areNeighbours = true;
    }
  }
  for (const std::uint32_t c : { a, b })
  {
    for (const std::uint32_t f : mesh.facesOf(c))
    {
      if (!mesh.face(f).gone && !kept.add(f))
      {
        return false;
      }
    }
  }
  if (!areNeighbours)
  {
    return false;
  }
  for (const std::uint32_t f : ofB)
  {
    if (!mesh.face(f).gone)
    {
      mesh.giveFace(f, b, a);
    }
  }
  EditCell& merged = mesh.changeCell(a);
  merged.eulerDefect = static_cast<std::int16_t>(merged.eulerDefect + mesh.cell(b).eulerDefect);
  mesh.removeCell(b);
  mesh.setFaces(a, kept.data(), kept.size());
  return true;
}

void makeWall(MeshEditor& mesh, std::uint32_t f, std::uint32_t without, std::int32_t wall)
{
  assert(isThere(mesh, f) && isOf(mesh, f, without));
  assert(mesh.beyond(f, without) != None);
  EditFace& face = mesh.changeFace(f);
  if (face.below == without)
  {
    Few ring;
    copy(mesh.cornersOf(f), ring);
    std::reverse(ring.begin(), ring.end());
    face.below = face.above;
    face.above = None;
    mesh.setCorners(f, ring.data(), ring.size());
  }
  face.above = None;
  face.shaped = true;
  face.wall = wall;
  face.behind = 0;
  face.original = Vector{};
  face.volumeDeficit = 0;
  mesh.dirty.faces.add(f);
  mesh.dirty.shapes.add(face.below);
  for (const std::uint32_t n : mesh.cornersOf(f))
  {
    mesh.changeNode(n).atWall = true;
  }
}

bool removeCell(MeshEditor& mesh, std::uint32_t c)
{
  assert(c < mesh.cellCount());
  Few faces;
  if (!mesh.isFree(c) || !copy(mesh.facesOf(c), faces))
  {
    return false;
  }
  const std::int32_t wall = mesh.cell(c).wall;
  mesh.removeCell(c);
  for (const std::uint32_t f : faces)
  {
    if (mesh.isWall(f))
    {
      mesh.removeFace(f, false);
      continue;
    }
    const std::uint32_t x = mesh.beyond(f, c);
    if (isFrozen(mesh, x) || mesh.isSurface(f))
    {
      return false;
    }
    const Vector outward = scaled(mesh.face(f).area, mesh.face(f).below == x ? 1 : -1);
    makeWall(mesh, f, c, wall);
    for (const std::uint32_t n : mesh.cornersOf(f))
    {
      EditNode& node = mesh.changeNode(n);
      if (node.kind == NodeKind::Free)
      {
        node.kind = NodeKind::OnSurface;
        node.along = unit(outward);
        node.referencePosition = node.at;
        node.maxDisplacement = DisplacementOfNewWalls * static_cast<float>(mesh.cell(x).edge);
      }
    }
  }
  return true;
}

}
