// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/CellComplex.h"

#include <algorithm>
#include <tuple>

namespace cartesian
{

// --- cutting

bool CellComplex::hasEdge(const FaceUse& use, std::uint32_t u, std::uint32_t v) const
{
  std::uint32_t first = None;
  std::uint32_t before = None;
  bool found = false;
  const auto isEdge = [&](std::uint32_t p, std::uint32_t q) {
    return (p == u && q == v) || (p == v && q == u);
  };
  forEachNodeOf(use, [&](std::uint32_t node) {
    first = first == None ? node : first;
    found = found || isEdge(before, node);
    before = node;
  });
  return found || isEdge(before, first);
}

std::vector<CellKey> CellComplex::cellsAround(CellKey key, std::uint32_t u, std::uint32_t v)
{
  std::vector<CellKey> found{ key };
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    open(found[i]);
    forEachFace(found[i], [&](const FaceUse& use) {
      const CellKey other = hasEdge(use, u, v) ? across(use) : None;
      if (other != None && std::find(found.begin(), found.end(), other) == found.end())
      {
        found.push_back(other);
      }
    });
  }
  return found;
}

std::vector<CellKey> CellComplex::touchedBy(CellKey key, const CellView& view, const CellCut& cut)
{
  std::vector<CellKey> touched{ key };
  for (const CellCut::NewNode& point : cut.points)
  {
    const std::vector<CellKey> around =
      cellsAround(key, view.nodes[point.low], view.nodes[point.high]);
    touched.insert(touched.end(), around.begin(), around.end());
  }
  std::vector<int> pieces(view.faces.size());
  for (const CellCut::Face& face : cut.faces)
  {
    if (face.source != CellCut::NoSource && ++pieces[face.source] > 1 &&
      view.across[face.source] != None)
    {
      open(view.across[face.source]);
      touched.push_back(view.across[face.source]);
    }
  }
  std::sort(touched.begin() + 1, touched.end());
  touched.erase(std::unique(touched.begin() + 1, touched.end()), touched.end());
  touched.erase(std::remove(touched.begin() + 1, touched.end(), key), touched.end());
  return touched;
}

// The number of the face, which becomes a shaped one where it is not yet.
std::uint32_t CellComplex::own(std::uint32_t face)
{
  if (isMadeHere(face))
  {
    return face;
  }
  const FaceNodes nodes = nodesOf(face);
  MadeFace copy{ { nodes.first, nodes.first + nodes.size }, cellsOf(face), boundaryOf(face) };
  const std::uint32_t number = firstMade() + static_cast<std::uint32_t>(madeFaces_.all.size());
  for (const CellKey key : copy.cells)
  {
    if (key == None)
    {
      continue;
    }
    open(key);
    OpenCell& owner = *opened(key);
    if (isOfWall(key))
    {
      owner.change(now_);
    }
    for (FaceUse& other : owner.faces)
    {
      other.face = (other.face == face ? number : other.face) & FaceUse::Most;
    }
  }
  madeFaces_.all.push_back(std::move(copy));
  madeFaces_.numberOf[face] = number;
  return number;
}

// The number that a face has got since a view was taken.
std::uint32_t CellComplex::renamed(std::uint32_t face) const
{
  const auto found = madeFaces_.numberOf.find(face);
  return found == madeFaces_.numberOf.end() ? face : found->second;
}

void CellComplex::insertNode(CellKey cell, std::uint32_t u, std::uint32_t v, std::uint32_t node)
{
  opened(cell)->change(now_);
  const std::size_t count = opened(cell)->faces.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const FaceUse use = opened(cell)->faces[i];
    if (!hasEdge(use, u, v))
    {
      continue;
    }
    std::vector<std::uint32_t>& nodes = made(own(use.face)).nodes;
    for (std::size_t k = 0; k < nodes.size(); ++k)
    {
      const std::uint32_t p = nodes[k];
      const std::uint32_t q = nodes[(k + 1) % nodes.size()];
      if ((p == u && q == v) || (p == v && q == u))
      {
        nodes.insert(nodes.begin() + static_cast<std::ptrdiff_t>(k) + 1, node);
        ++k;
      }
    }
  }
}

void CellComplex::setCell(const FaceUse& use, CellKey key)
{
  (isMadeHere(use.face) ? made(use.face).cells : whole_.mesh.faces.cells[use.face])[use.turned] =
    key;
}

Point CellComplex::placeOfPoint(CellKey key, const CellCut::NewNode& point) const
{
  const Point origin = whole_.boxes.lowOf(boxOf(key));
  Point place;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    place[axis] = static_cast<Level>(
      static_cast<std::int64_t>(origin[axis]) + static_cast<std::int64_t>(point.at[axis]));
  }
  return place;
}

bool CellComplex::allows(
  const std::vector<CellKey>& touched, const CellView& view, const CellCut& cut) const
{
  const auto thin = [&](CellKey key) { return isThin(measured(key)); };
  const auto free = [&](CellKey key) { return isFree(key); };
  return std::all_of(touched.begin(), touched.end(), free) && !meetsNode(touched, view, cut) &&
    std::none_of(touched.begin() + 1, touched.end(), thin);
}

bool CellComplex::meetsNode(
  const std::vector<CellKey>& touched, const CellView& view, const CellCut& cut) const
{
  std::vector<Point> places;
  for (const CellCut::NewNode& point : cut.points)
  {
    places.push_back(placeOfPoint(touched.front(), point));
  }
  std::sort(places.begin(), places.end());
  bool found =
    std::adjacent_find(places.begin(), places.end()) != places.end() || meetsFace(view, cut);
  for (const CellKey key : touched)
  {
    forEachFace(key, [&](const FaceUse& use) {
      forEachNodeOf(use, [&](std::uint32_t node) {
        found = found || std::binary_search(places.begin(), places.end(), placeOf(node));
      });
      found = found || (key != touched.front() && losesStar(use, touched.front(), view, cut));
    });
  }
  return found;
}

bool CellComplex::meetsFace(const CellView& view, const CellCut& cut) const
{
  std::vector<int> pieces(view.faces.size());
  for (const CellCut::Face& face : cut.faces)
  {
    if (face.source != CellCut::NoSource)
    {
      ++pieces[face.source];
    }
  }
  std::vector<std::uint32_t> piece;
  std::vector<std::uint32_t> nodes;
  const auto isThere = [&](const CellCut::Face& face) {
    const bool whole = face.source == CellCut::NoSource || pieces[face.source] < 2 ||
      view.across[face.source] == None;
    const CellCut::FaceCorners corners = cut.cornersOf(face);
    if (whole || std::any_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
          return corner >= view.nodes.size();
        }))
    {
      return false;
    }
    piece.clear();
    for (const std::uint32_t corner : corners)
    {
      piece.push_back(view.nodes[corner]);
    }
    std::sort(piece.begin(), piece.end());
    bool found = false;
    forEachFace(view.across[face.source], [&](const FaceUse& use) {
      nodes.clear();
      forEachNodeOf(use, [&](std::uint32_t node) { nodes.push_back(node); });
      std::sort(nodes.begin(), nodes.end());
      found = found || nodes == piece;
    });
    return found;
  };
  return std::any_of(cut.faces.begin(), cut.faces.end(), isThere);
}

// Whether the new points on its edges move the mean of a face's corners so that its star folds over.
bool CellComplex::losesStar(
  const FaceUse& use, CellKey key, const CellView& view, const CellCut& cut) const
{
  const auto isBetween = [&](const CellCut::NewNode& point, std::uint32_t from, std::uint32_t to) {
    const std::uint32_t low = view.nodes[point.low];
    const std::uint32_t high = view.nodes[point.high];
    return (low == from && high == to) || (high == from && low == to);
  };
  const FaceNodes ring = nodesOf(use.face);
  bool divided = false;
  for (std::size_t i = 0; i < ring.size && !divided; ++i)
  {
    const std::uint32_t from = ring.first[i > 0 ? i - 1 : ring.size - 1];
    divided = std::any_of(cut.points.begin(), cut.points.end(),
      [&](const CellCut::NewNode& point) { return isBetween(point, from, ring.first[i]); });
  }
  if (!divided)
  {
    return false;
  }
  const Point origin = whole_.boxes.lowOf(boxOf(key));
  Polyhedron face;
  const auto addCorner = [&](const Vector& at) {
    face.addCorner(static_cast<std::uint32_t>(face.nodes.size()));
    face.nodes.push_back(at);
  };
  for (std::size_t i = 0; i < ring.size; ++i)
  {
    const auto corner = [&](
                          std::size_t k) { return ring.first[use.turned ? ring.size - 1 - k : k]; };
    addCorner(minus(placeOf(corner(i)), origin));
    for (const CellCut::NewNode& point : cut.points)
    {
      if (isBetween(point, corner(i), corner(i + 1 < ring.size ? i + 1 : 0)))
      {
        addCorner(point.at);
      }
    }
  }
  face.closeFace(false);
  CellShape shape;
  measure(face, shape);
  return !isStar(ringOf(face, 0), unit(shape.faces[0].area));
}

// Of nodes in the order of their places, the one there, or None.
std::uint32_t CellComplex::nodeAt(
  const Point& place, const std::vector<std::uint32_t>& inOrder) const
{
  const auto found = std::lower_bound(inOrder.begin(), inOrder.end(), place,
    [&](std::uint32_t node, const Point& p) { return whole_.nodes.at[node] < p; });
  return found != inOrder.end() && whole_.nodes.at[*found] == place ? *found : None;
}

// Those of the cells that the slab sees, as they were, in the order of their places.
const std::vector<std::uint32_t>& CellComplex::nodesInOrder()
{
  if (!nodesInOrder_.empty())
  {
    return nodesInOrder_;
  }
  std::vector<bool> isUsed(whole_.nodes.at.size());
  const auto [first, last] = whole_.cellsIn(slab_.layers);
  for (CellKey key = first; key < last; ++key)
  {
    if (!whole_.mesh.isRemoved(key))
    {
      whole_.mesh.forEachNodeOf(key, [&](std::uint32_t node) { isUsed[node] = true; });
    }
  }
  for (std::uint32_t node = 0; node < isUsed.size(); ++node)
  {
    if (isUsed[node])
    {
      nodesInOrder_.push_back(node);
    }
  }
  std::sort(nodesInOrder_.begin(), nodesInOrder_.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tie(whole_.nodes.at[a], a) < std::tie(whole_.nodes.at[b], b);
  });
  return nodesInOrder_;
}

// No two nodes are at one place: cells that touch in an edge only have the same points on it, and where walls
// touch, the point of one may be a node of the other.
std::uint32_t CellComplex::addNode(const Point& place)
{
  if (const std::uint32_t given = nodeAt(place, whole_.nodes.ofCuts); given != None)
  {
    return given;
  }
  if (const auto made = madeNodes_.ofCuts.find(place); made != madeNodes_.ofCuts.end())
  {
    return made->second;
  }
  if (const std::uint32_t given = nodeAt(place, nodesInOrder()); given != None)
  {
    return given;
  }
  const std::uint32_t node = nextNode();
  madeNodes_.ofCuts.emplace(place, node);
  madeNodes_.at.push_back(place);
  return node;
}

// Also where other cells have the edges that they are on. Returns the nodes of the view and of the cut.
std::vector<std::uint32_t> CellComplex::insertNodes(
  CellKey key, const CellView& view, const CellCut& cut, std::vector<CellKey>& touched)
{
  std::vector<std::uint32_t> nodes = view.nodes;
  for (const CellCut::NewNode& point : cut.points)
  {
    nodes.push_back(addNode(placeOfPoint(key, point)));
    const std::uint32_t u = view.nodes[point.low];
    const std::uint32_t v = view.nodes[point.high];
    for (const CellKey around : cellsAround(key, u, v))
    {
      insertNode(around, u, v, nodes.back());
      touched.push_back(around);
    }
  }
  return nodes;
}

// The cell, then new ones, without faces.
std::vector<CellKey> CellComplex::addParts(CellKey key, std::uint32_t count)
{
  std::vector<CellKey> keys{ key };
  opened(key)->faces.clear();
  for (std::uint32_t part = 1; part < count; ++part)
  {
    const OpenCell& whole = *opened(key);
    OpenCell cell;
    cell.box = whole.box;
    cell.origin = whole.origin;
    cell.region = whole.region;
    cell.boundary = whole.boundary;
    cell.reach = whole.reach;
    open_.add(nextKey_, std::move(cell));
    keys.push_back(nextKey_++);
  }
  return keys;
}

void CellComplex::addCutFace(MadeFace face)
{
  const std::array<CellKey, 2> cells = face.cells;
  FaceUse use = addFace(std::move(face));
  opened(cells[0])->faces.push_back(use);
  use.turned = 1;
  opened(cells[1])->faces.push_back(use);
}

void CellComplex::cut(
  CellKey key, const CellView& view, const CellCut& cut, std::vector<CellKey>& parts)
{
  changed_ = true;
  std::vector<CellKey> touched;
  const std::vector<std::uint32_t> nodes = insertNodes(key, view, cut, touched);
  const std::vector<CellKey> keys = addParts(key, cut.parts);
  std::vector<std::uint32_t> pieces(view.faces.size());
  for (const CellCut::Face& face : cut.faces)
  {
    if (face.source != CellCut::NoSource)
    {
      ++pieces[face.source];
    }
  }
  // Of divided faces that have a piece already.
  std::vector<std::uint32_t> owned(view.faces.size(), None);
  for (const CellCut::Face& face : cut.faces)
  {
    MadeFace piece{ {}, { keys[face.below], None }, NoBoundary };
    for (const std::uint32_t corner : cut.cornersOf(face))
    {
      piece.nodes.push_back(nodes[corner]);
    }
    if (face.source == CellCut::NoSource)
    {
      piece.cells[1] = keys[face.above];
      addCutFace(std::move(piece));
      continue;
    }
    FaceUse use(renamed(view.faces[face.source].face), view.faces[face.source].turned != 0);
    if (pieces[face.source] > 1)
    {
      touched.push_back(view.across[face.source]);
      if (use.turned)
      {
        std::reverse(piece.nodes.begin(), piece.nodes.end());
      }
      use = addPiece(use, std::move(piece), owned[face.source]);
    }
    setCell(use, keys[face.below]);
    opened(keys[face.below])->faces.push_back(use);
  }
  for (const CellKey k : keys)
  {
    opened(k)->change(now_);
  }
  parts.insert(parts.end(), keys.begin(), keys.end());
  touched.insert(touched.end(), keys.begin(), keys.end());
  remeasure(touched);
}

// Changing a face that is not flat moves volume from one of its cells to the other.
void CellComplex::remeasure(std::vector<CellKey>& keys)
{
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  for (const CellKey key : keys)
  {
    if (OpenCell* cell = key == None ? nullptr : opened(key))
    {
      cell->place = measuredPlace(key);
    }
  }
}

FaceUse CellComplex::addFace(MadeFace face)
{
  madeFaces_.all.push_back(std::move(face));
  return { firstMade() + madeFaces_.all.size() - 1, false };
}

// A piece of a divided face: the first takes its place, the others are added to the cell beyond.
FaceUse CellComplex::addPiece(FaceUse use, MadeFace piece, std::uint32_t& owned)
{
  if (owned == None)
  {
    owned = own(use.face);
    made(owned).nodes = std::move(piece.nodes);
    use.face = owned & FaceUse::Most;
    return use;
  }
  piece.cells = made(owned).cells;
  piece.boundary = made(owned).boundary;
  const CellKey other = piece.cells[use.turned ? 0 : 1];
  const bool turned = use.turned;
  use = addFace(std::move(piece));
  if (other != None)
  {
    use.turned = turned ? 0 : 1;
    opened(other)->faces.push_back(use);
    opened(other)->change(now_);
  }
  use.turned = turned ? 1 : 0;
  return use;
}

// --- joining

// Boundary faces of two cells that lie back to back enclose nothing once the cells are one. `ofSmall`: from
// there on, faces are the second cell's.
void CellComplex::dropTwins(std::vector<FaceUse>& faces, std::size_t ofSmall)
{
  const auto nodesOf = [&](const FaceUse& use) {
    std::vector<std::uint32_t> nodes;
    forEachNodeOf(use, [&](std::uint32_t node) { nodes.push_back(node); });
    std::sort(nodes.begin(), nodes.end());
    return nodes;
  };
  std::map<std::vector<std::uint32_t>, std::size_t> mine;
  std::vector<std::uint8_t> isTwin(faces.size());
  for (std::size_t f = ofSmall; f < faces.size(); ++f)
  {
    if (across(faces[f]) == None)
    {
      mine.emplace(nodesOf(faces[f]), f);
    }
  }
  for (std::size_t f = 0; f < ofSmall && !mine.empty(); ++f)
  {
    if (across(faces[f]) == None)
    {
      const auto twin = mine.find(nodesOf(faces[f]));
      isTwin[f] = twin != mine.end() ? 1 : 0;
      isTwin[twin != mine.end() ? twin->second : f] = isTwin[f];
    }
  }
  std::size_t kept = 0;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    if (isTwin[f] == 0)
    {
      faces[kept++] = faces[f];
    }
  }
  faces.resize(kept);
}

void CellComplex::merge(CellKey small, CellKey into)
{
  changed_ = true;
  open(small);
  open(into);
  reachAsFarAs(small, into);
  OpenCell& from = *opened(small);
  OpenCell& to = *opened(into);
  const auto between = [&](const FaceUse& use, CellKey other) { return across(use) == other; };
  std::vector<FaceUse> faces;
  for (const FaceUse& use : to.faces)
  {
    if (!between(use, small))
    {
      faces.push_back(use);
    }
  }
  const std::size_t ofSmall = faces.size();
  for (const FaceUse& use : from.faces)
  {
    if (!between(use, into))
    {
      faces.push_back(use);
    }
  }
  for (const FaceUse& use : from.faces)
  {
    setCell(use, into);
  }
  dropTwins(faces, ofSmall);
  to.faces = std::move(faces);
  to.change(now_);
  from.faces.clear();
  from.alive = false;
  from.change(now_);
  to.place = measuredPlace(into);
}

void CellComplex::reform(std::uint32_t face, const std::vector<std::uint32_t>& ring)
{
  changed_ = true;
  std::vector<CellKey> cells;
  for (const CellKey key : cellsOf(face))
  {
    if (key != None)
    {
      open(key);
      opened(key)->change(now_);
      cells.push_back(key);
    }
  }
  if (ring.empty())
  {
    for (const CellKey key : cells)
    {
      removeFace(key, face);
    }
  }
  else
  {
    made(own(face)).nodes = ring;
  }
  remeasure(cells);
}

std::optional<std::int32_t> CellComplex::onlyWallOf(CellKey key) const
{
  std::optional<std::int32_t> wall;
  bool isOnly = hasFaces(key) && isFree(key);
  forEachFace(key, [&](const FaceUse& use) {
    const CellKey other = across(use);
    isOnly = isOnly && other != None && isAlive(other) && isFree(other);
    if (isOnly && isInterface(use))
    {
      isOnly = !wall || *wall == boundaryOf(use.face);
      wall = boundaryOf(use.face);
    }
  });
  return isOnly ? wall : std::nullopt;
}

void CellComplex::changeRegion(CellKey key, std::int32_t wall)
{
  changed_ = true;
  open(key);
  const std::size_t count = opened(key)->faces.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const CellKey other = across(opened(key)->faces[i]);
    open(other);
    opened(other)->change(now_);
    own(opened(key)->faces[i].face);
  }
  OpenCell& cell = *opened(key);
  cell.region = cell.region == whole_.patches.walls.behind(wall)
    ? whole_.patches.walls.front(wall)
    : whole_.patches.walls.behind(wall);
  cell.change(now_);
  for (std::size_t i = 0; i < count; ++i)
  {
    const FaceUse use = cell.faces[i];
    makeWall(use.face, regionOf(across(use)) == cell.region ? NoBoundary : wall);
  }
}

// Of a shaped face; below it comes the region behind the wall.
void CellComplex::makeWall(std::uint32_t face, std::int32_t wall)
{
  MadeFace& of = made(face);
  of.boundary = wall;
  if (wall == NoBoundary || regionOf(of.cells[0]) == whole_.patches.walls.behind(wall))
  {
    return;
  }
  std::reverse(of.nodes.begin(), of.nodes.end());
  std::swap(of.cells[0], of.cells[1]);
  for (const CellKey key : of.cells)
  {
    for (FaceUse& use : opened(key)->faces)
    {
      use.turned = use.face == face ? !use.turned : use.turned;
    }
  }
}

void CellComplex::reachAsFarAs(CellKey small, CellKey into)
{
  const Layers mine = layersOf(into);
  const Layers other = layersOf(small);
  std::array<std::uint8_t, 2>& reach = opened(into)->reach;
  const std::uint32_t layer = mine.begin + reach[0];
  reach[0] = static_cast<std::uint8_t>(layer - std::min(mine.begin, other.begin));
  reach[1] = static_cast<std::uint8_t>(std::max(mine.end, other.end) - layer - 1);
}

bool CellComplex::hasFaceNear(CellKey key, std::vector<std::uint32_t> nodes) const
{
  std::sort(nodes.begin(), nodes.end());
  std::vector<CellKey> near{ key };
  const auto touches = [&](const FaceUse& use) {
    bool any = false;
    forEachNodeOf(use, [&](std::uint32_t node) {
      any = any || std::binary_search(nodes.begin(), nodes.end(), node);
    });
    return any;
  };
  for (std::size_t ring = 0, begin = 0; ring < 2; ++ring)
  {
    const std::size_t end = near.size();
    for (; begin < end; ++begin)
    {
      const bool free = isFree(near[begin]);
      forEachFace(near[begin], [&](const FaceUse& use) {
        const CellKey other = free || touches(use) ? across(use) : None;
        if (other != None && hasFaces(other) &&
          std::find(near.begin(), near.end(), other) == near.end())
        {
          near.push_back(other);
        }
      });
    }
  }
  std::vector<std::uint32_t> face;
  bool found = false;
  for (std::size_t i = 1; i < near.size() && !found; ++i)
  {
    forEachFace(near[i], [&](const FaceUse& use) {
      const FaceNodes of = nodesOf(use.face);
      if (found || of.size != nodes.size() ||
        !std::binary_search(nodes.begin(), nodes.end(), *of.first))
      {
        return;
      }
      face.assign(of.first, of.first + of.size);
      std::sort(face.begin(), face.end());
      found = face == nodes;
    });
  }
  return found;
}

bool CellComplex::hasFacesNear(CellKey key, const CellView& view, const JoinedFaces& joined) const
{
  return std::any_of(
    joined.groups.begin(), joined.groups.end(), [&](const JoinedFaces::Group& group) {
      std::vector<std::uint32_t> nodes;
      for (const std::uint32_t node : group.ring)
      {
        nodes.push_back(view.nodes[node]);
      }
      return hasFaceNear(key, std::move(nodes));
    });
}

// A hexahedron next to it gets a boundary face, which only polyhedra have.
void CellComplex::remove(CellKey key)
{
  changed_ = true;
  const std::int32_t boundary = mainBoundary(key);
  open(key);
  const std::vector<FaceUse> faces = opened(key)->faces;
  for (const FaceUse& use : faces)
  {
    const CellKey other = across(use);
    if (other != None && !isOfWall(other) &&
      (use.face >= whole_.mesh.faces.firstShaped || isFree(other)))
    {
      open(other);
      opened(other)->change(now_);
    }
    else if (OpenCell* neighbour = other == None ? nullptr : opened(other))
    {
      neighbour->known.fault = IsAtFault::Unknown;
    }
  }
  opened(key)->boundary = boundary;
  opened(key)->removed = true;
  opened(key)->change(now_);
}

std::int32_t CellComplex::boundaryOf(std::uint32_t face) const
{
  return isMadeHere(face) ? made(face).boundary : whole_.mesh.faces.boundary[face];
}

std::int32_t CellComplex::boundaryOfCell(CellKey key) const
{
  const OpenCell* cell = opened(key);
  return cell ? cell->boundary : whole_.mesh.cells[key].boundary;
}

bool CellComplex::isAtBoundary(CellKey key) const
{
  bool any = false;
  bool border = false;
  forEachFace(key, [&](const FaceUse& use) {
    const CellKey other = across(use);
    any = any || other == None || !isAlive(other);
    border = border || isInterface(use);
  });
  return any && !border;
}

std::map<std::int32_t, double> CellComplex::wallAreas(CellKey key) const
{
  MeasuredCell cell;
  lookAround(key, cell);
  std::map<std::int32_t, double> areas;
  std::size_t face = 0;
  forEachFace(key, [&](const FaceUse& use) {
    if (cell.across[face] == None)
    {
      const CellKey other = across(use);
      areas[other == None ? boundaryOf(use.face) : boundaryOfCell(other)] +=
        norm(cell.measures.faces[face].area);
    }
    ++face;
  });
  return areas;
}

std::int32_t CellComplex::mainBoundary(CellKey key) const
{
  std::map<std::int32_t, double> areas = wallAreas(key);
  areas.erase(NoBoundary);
  const auto most = std::max_element(
    areas.begin(), areas.end(), [](const auto& x, const auto& y) { return x.second < y.second; });
  return most == areas.end() ? boundaryOfCell(key) : most->first;
}

void CellComplex::removeFace(CellKey key, std::uint32_t face)
{
  std::vector<FaceUse>& faces = opened(key)->faces;
  faces.erase(std::remove_if(
                faces.begin(), faces.end(), [&](const FaceUse& use) { return use.face == face; }),
    faces.end());
  opened(key)->change(now_);
}

// A hexahedron one of whose sides is not whole any more has to have faces of its own.
void CellComplex::setNodes(std::uint32_t face, std::vector<std::uint32_t> nodes)
{
  const std::vector<std::uint32_t>& before = made(face).nodes;
  if (nodes.size() != before.size() ||
    !std::is_permutation(nodes.begin(), nodes.end(), before.begin()))
  {
    const auto cells = made(face).cells; // opening one may make faces
    for (const CellKey key : cells)
    {
      if (key != None)
      {
        open(key);
        opened(key)->change(now_);
      }
    }
  }
  made(face).nodes = std::move(nodes);
}

void CellComplex::join(CellKey key, const CellView& view, const JoinedFaces& joined)
{
  std::vector<CellKey> touched;
  for (const JoinedFaces::Group& group : joined.groups)
  {
    changed_ = true;
    // Faces exposed by removed cells take the boundary of the adjacent wall.
    const auto isWall = [&](std::uint32_t f) {
      return view.across[f] == None && across(view.faces[f]) == None;
    };
    const auto wall = std::find_if(group.members.begin(), group.members.end(), isWall);
    const std::uint32_t first = wall == group.members.end() ? group.members.front() : *wall;
    touched.push_back(view.across[first]);
    const FaceUse use = view.faces[first];
    std::vector<std::uint32_t> nodes;
    for (const std::uint32_t node : group.ring)
    {
      nodes.push_back(view.nodes[node]);
    }
    if (use.turned)
    {
      std::reverse(nodes.begin(), nodes.end());
    }
    setNodes(own(renamed(use.face)), std::move(nodes));
    opened(key)->change(now_);
    for (const std::uint32_t member : group.members)
    {
      if (member == first)
      {
        continue;
      }
      const std::uint32_t gone = renamed(view.faces[member].face);
      removeFace(key, gone);
      if (view.across[first] != None)
      {
        open(view.across[first]);
        removeFace(view.across[first], gone);
      }
    }
  }
  touched.push_back(key);
  remeasure(touched);
}

}
