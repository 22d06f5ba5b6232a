// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/CellComplex.h"

#include <algorithm>
#include <tuple>

namespace cartesian
{

namespace
{

// Nodes of a hexahedron's side i (low x, high x, low y, ...), counter-clockwise from outside.
std::array<unsigned, 4> cornersFromOutside(unsigned side)
{
  std::array<unsigned, 4> corners = sideCorners(static_cast<int>(side / 2), side % 2);
  if (side % 2 == 0)
  {
    std::reverse(corners.begin(), corners.end());
  }
  return corners;
}

}

CellComplex::CellComplex(ShapedWall& whole, const Slab& slab)
  : whole_(whole)
  , slab_(slab)
  , open_(whole.cellsIn(slab.layers),
      { whole.boxes.firstBoxOf(slab.layers.begin), whole.boxes.firstBoxOf(slab.layers.end) })
  , freeBoxes_{ whole.boxes.firstBoxOf(slab.free.begin), whole.boxes.firstBoxOf(slab.free.end) }
{
  const auto [first, last] = whole.cellsIn(slab.acting);
  for (CellKey key = first; key < last; ++key)
  {
    if (isAlive(key) && isFree(key))
    {
      acting_.push_back(key);
    }
  }
}

// --- reading

std::array<CellKey, 2> CellComplex::cellsOf(std::uint32_t face) const
{
  return isMadeHere(face) ? made(face).cells : whole_.mesh.faces.cells[face];
}

CellKey CellComplex::across(const FaceUse& use) const
{
  return cellsOf(use.face)[use.turned ? 0 : 1];
}

double CellComplex::volumeOfBox(CellKey key) const
{
  const Box box = whole_.boxes.box(boxOf(key));
  const Vector size = minus(box.high, box.low);
  return size[0] * size[1] * size[2];
}

bool CellComplex::isAlive(CellKey key) const
{
  if (const OpenCell* cell = opened(key))
  {
    return cell->alive && !cell->removed;
  }
  return !whole_.mesh.isRemoved(key);
}

std::int32_t CellComplex::regionOf(CellKey key) const
{
  const OpenCell* cell = opened(key);
  return cell       ? cell->region
    : isOfWall(key) ? whole_.mesh.cells[key].region
                    : whole_.boxes.regionOf(boxOfHexahedron(key));
}

bool CellComplex::isInterface(const FaceUse& use) const
{
  if (whole_.boxes.regions.empty())
  {
    return false;
  }
  const auto& [below, above] = cellsOf(use.face);
  return below != None && above != None && regionOf(below) != regionOf(above);
}

std::uint32_t CellComplex::boxOf(CellKey key) const
{
  if (const OpenCell* cell = opened(key))
  {
    return cell->box;
  }
  return isOfWall(key) ? whole_.mesh.cells[key].box : boxOfHexahedron(key);
}

void CellComplex::addFaceTo(Polyhedron& shape, const FaceUse& use, const Point& origin) const
{
  const FaceNodes nodes = nodesOf(use.face);
  const std::size_t first = shape.nodes.size();
  shape.nodes.resize(first + nodes.size);
  shape.corners.resize(first + nodes.size);
  for (std::size_t i = 0; i < nodes.size; ++i)
  {
    const std::uint32_t node = nodes.first[use.turned ? nodes.size - 1 - i : i];
    shape.nodes[first + i] = minus(placeOf(node), origin);
    shape.corners[first + i] = static_cast<std::uint32_t>(first + i);
  }
  const CellKey other = across(use);
  shape.closeFace(other == None || !isAlive(other) || isInterface(use));
}

void CellComplex::shape(CellKey key, Polyhedron& shape) const
{
  shape.clear();
  const Point origin = whole_.boxes.lowOf(boxOf(key));
  forEachFace(key, [&](const FaceUse& use) { addFaceTo(shape, use, origin); });
}

void CellComplex::lookAround(CellKey key, MeasuredCell& cell) const
{
  shape(key, cell.shape);
  measure(cell.shape, cell.measures);
  const Point origin = whole_.boxes.lowOf(boxOf(key));
  cell.across.clear();
  cell.beyond.clear();
  forEachFace(key, [&](const FaceUse& use) {
    const bool boundary = cell.shape.isBoundary[cell.across.size()] != 0;
    cell.across.push_back(boundary ? CellKey(None) : across(use));
    cell.beyond.push_back(boundary ? NeighbourCell{} : placeAndVolume(cell.across.back(), origin));
  });
}

Vector CellComplex::between(CellKey from, CellKey to) const
{
  return minus(whole_.boxes.lowOf(boxOf(to)), whole_.boxes.lowOf(boxOf(from)));
}

NeighbourCell CellComplex::placeAndVolume(CellKey key, const Point& origin) const
{
  const OpenCell* open = opened(key);
  if (open || isOfWall(key))
  {
    const Point low = whole_.boxes.lowOf(open ? open->box : whole_.mesh.cells[key].box);
    const NeighbourCell& place = open ? open->place : whole_.known.places[key];
    return { plus(minus(low, origin), place.centre), place.volume };
  }
  const Box box = whole_.boxes.box(boxOfHexahedron(key));
  const auto moved = whole_.movedHexahedra.find(boxOfHexahedron(key));
  if (moved != whole_.movedHexahedra.end())
  {
    return { plus(minus(box.low, origin), moved->second.centre), moved->second.volume };
  }
  return { plus(minus(box.low, origin), scaled(minus(box.high, box.low), 0.5)), volumeOfBox(key) };
}

const CellShape& CellComplex::measured(CellKey key) const
{
  shape(key, scratch_.polyhedron);
  measure(scratch_.polyhedron, scratch_.measures);
  return scratch_.measures;
}

NeighbourCell CellComplex::measuredPlace(CellKey key) const
{
  const CellShape& measures = measured(key);
  return { measures.centre, measures.volume };
}

double CellComplex::volume(CellKey key) const
{
  if (const OpenCell* open = opened(key))
  {
    return open->place.volume;
  }
  return isOfWall(key) ? whole_.known.places[key].volume : volumeOfBox(key);
}

double CellComplex::share(CellKey key) const
{
  return isOfWall(key) && !hasChanged(key) ? whole_.known.shares[key]
                                           : volume(key) / volumeOfBox(key);
}

bool CellComplex::isAtFault(CellKey key) const
{
  const OpenCell* cell = opened(key);
  if (isOfWall(key) && !(cell && cell->changed))
  {
    return whole_.known.atFault[key] == IsAtFault::Yes;
  }
  if (cell && cell->known.fault != IsAtFault::Unknown)
  {
    return cell->known.fault == IsAtFault::Yes;
  }
  const CellShape& measures = measured(key);
  const bool any = isAnyAtFault(scratch_.polyhedron, measures);
  if (cell)
  {
    cell->known.fault = any ? IsAtFault::Yes : IsAtFault::No;
  }
  return any;
}

bool CellComplex::hasChanged(CellKey key) const
{
  const OpenCell* cell = opened(key);
  return cell && cell->changed;
}

void CellComplex::lookBeyond(CellKey key, CellView& view) const
{
  const Point origin = whole_.boxes.lowOf(boxOf(key));
  view.beyond.assign(view.faces.size(), {});
  for (std::size_t f = 0; f < view.faces.size(); ++f)
  {
    const auto before =
      std::find(view.across.begin(), view.across.begin() + std::ptrdiff_t(f), view.across[f]);
    const auto known = static_cast<std::size_t>(before - view.across.begin());
    if (!view.shape.isBoundary[f])
    {
      view.beyond[f] = known < f ? view.beyond[known] : placeAndVolume(view.across[f], origin);
    }
  }
}

std::vector<std::pair<CellKey, double>> CellComplex::neighbours(CellKey key) const
{
  lookAround(key, scratch_.cell);
  return neighboursOf(scratch_.cell);
}

std::vector<std::pair<CellKey, double>> neighboursOf(const MeasuredCell& cell)
{
  std::vector<std::pair<CellKey, double>> result;
  for (std::size_t f = 0; f < cell.across.size(); ++f)
  {
    const CellKey other = cell.across[f];
    if (other == None)
    {
      continue;
    }
    const double area = norm(cell.measures.faces[f].area);
    const auto known = std::find_if(
      result.begin(), result.end(), [&](const auto& entry) { return entry.first == other; });
    if (known == result.end())
    {
      result.emplace_back(other, area);
    }
    else
    {
      known->second += area;
    }
  }
  std::sort(result.begin(), result.end(), [](const auto& x, const auto& y) {
    const auto a = static_cast<float>(x.second); // equal up to rounding counts as equal
    const auto b = static_cast<float>(y.second);
    return a != b ? a > b : x.first < y.first;
  });
  return result;
}

Layers CellComplex::layersOf(CellKey key) const
{
  const std::uint32_t layer = whole_.boxes.globalOf(whole_.boxes.packed[boxOf(key)]).index[2];
  std::array<std::uint8_t, 2> reach{ 0, 0 };
  if (const OpenCell* cell = opened(key))
  {
    reach = cell->reach;
  }
  else if (isOfWall(key))
  {
    reach = whole_.mesh.cells[key].reach;
  }
  return { layer - reach[0], layer + reach[1] + 1 };
}

bool CellComplex::isFree(CellKey key) const
{
  const OpenCell* open = opened(key);
  const bool known = open || isOfWall(key);
  if (known && (open ? open->reach : whole_.mesh.cells[key].reach) != OpenCell::NoReach)
  {
    const Layers layers = layersOf(key);
    return layers.begin >= slab_.free.begin && layers.end <= slab_.free.end;
  }
  const std::uint32_t box = open ? open->box : boxOf(key);
  return box >= freeBoxes_[0] && box < freeBoxes_[1];
}

bool CellComplex::isActing(CellKey key) const
{
  return isFree(key) &&
    slab_.acting.contains(whole_.boxes.globalOf(whole_.boxes.packed[boxOf(key)]).index[2]);
}

bool CellComplex::hasChangedNear(CellKey key, std::uint32_t mark) const
{
  const auto hasChangedSince = [&](CellKey other) {
    const OpenCell* cell = opened(other);
    return cell && cell->hasChangedSince(mark);
  };
  bool found = hasChangedSince(key);
  forEachFace(key, [&](const FaceUse& use) {
    const CellKey other = found ? None : across(use);
    if (other == None)
    {
      return;
    }
    found = !hasFaces(other) || hasChangedSince(other);
    if (!found)
    {
      forEachFace(other, [&](const FaceUse& far) {
        const CellKey beyond = found ? None : across(far);
        found = found || (beyond != None && hasChangedSince(beyond));
      });
    }
  });
  return found;
}

bool CellComplex::mayMerge(const std::vector<CellKey>& keys) const
{
  const Layers all = layersOf(keys);
  return all.begin >= slab_.free.begin && all.end <= slab_.free.end &&
    all.end - all.begin <= MostLayersOfACell &&
    std::all_of(keys.begin(), keys.end(),
      [&](CellKey key) { return regionOf(key) == regionOf(keys.front()); });
}

bool CellComplex::wouldStraddleStages(const std::vector<CellKey>& keys) const
{
  return straddlesStages(layersOf(keys), whole_.boxes.allLayers().end);
}

Layers CellComplex::layersOf(const std::vector<CellKey>& keys) const
{
  Layers all = layersOf(keys.front());
  for (const CellKey key : keys)
  {
    const Layers layers = layersOf(key);
    all = { std::min(all.begin, layers.begin), std::max(all.end, layers.end) };
  }
  return all;
}

// isKept(key, whether it is open): of acting cells as they were, then of those made since.
template <class Kept>
std::vector<CellKey> CellComplex::select(Kept&& isKept) const
{
  std::vector<CellKey> keys;
  for (const CellKey key : acting_)
  {
    const bool open = opened(key) != nullptr;
    if ((!open || (isAlive(key) && isFree(key))) && isKept(key, open))
    {
      keys.push_back(key);
    }
  }
  const auto others = static_cast<std::ptrdiff_t>(keys.size());
  open_.forEachOther([&](CellKey key, const OpenCell& cell) {
    if (cell.changed && !isOfWall(key) && isAlive(key) && isActing(key) && isKept(key, true))
    {
      keys.push_back(key);
    }
  });
  std::sort(keys.begin() + others, keys.end());
  return keys;
}

std::vector<CellKey> CellComplex::polyhedra() const
{
  return select([](CellKey, bool) { return true; });
}

std::vector<CellKey> CellComplex::polyhedraAtFault() const
{
  return select([&](CellKey key, bool open) {
    return open ? isAtFault(key) : whole_.known.atFault[key] == IsAtFault::Yes;
  });
}

std::vector<CellKey> CellComplex::allChangedSince(std::uint32_t mark) const
{
  std::vector<CellKey> changed;
  open_.forEach([&](CellKey key, const OpenCell& cell) {
    if (cell.hasChangedSince(mark))
    {
      changed.push_back(key);
      for (const FaceUse& use : cell.faces)
      {
        changed.push_back(across(use));
      }
    }
  });
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  return changed;
}

std::vector<CellKey> CellComplex::polyhedraChangedSince(std::uint32_t mark) const
{
  const std::vector<CellKey> changed = allChangedSince(mark);
  std::vector<CellKey> keys = polyhedra();
  keys.erase(
    std::remove_if(keys.begin(), keys.end(),
      [&](CellKey key) { return !std::binary_search(changed.begin(), changed.end(), key); }),
    keys.end());
  return keys;
}

std::vector<CellKey> CellComplex::othersTouched() const
{
  std::vector<CellKey> keys = allChangedSince(0);
  keys.erase(std::remove_if(keys.begin(), keys.end(),
               [&](CellKey key) {
                 return key == None || !isAlive(key) || !hasFaces(key) || !isFree(key) ||
                   isActing(key);
               }),
    keys.end());
  return keys;
}

// Nodes by place and faces by nodes: sums of the same numbers in the same order, whatever numbers
// nodes and faces have got.
void CellComplex::view(const std::vector<CellKey>& keys, CellView& view) const
{
  using Outer = Scratch::Outer;
  std::vector<Outer>& faces = scratch_.faces;
  std::vector<std::uint32_t>& corners = scratch_.corners;
  faces.clear();
  corners.clear();
  for (const CellKey key : keys)
  {
    forEachFace(key, [&](const FaceUse& use) {
      const CellKey other = across(use);
      if (other == None || std::find(keys.begin(), keys.end(), other) == keys.end())
      {
        const std::size_t begin = corners.size();
        forEachNodeOf(use, [&](std::uint32_t node) { corners.push_back(node); });
        faces.push_back({ use, other, begin, corners.size() });
      }
    });
  }
  view.clear();
  view.reserve(faces.size(), corners.size());
  numberNodes(whole_.boxes.lowOf(boxOf(keys.front())), view);
  const auto corner = [&](
                        std::size_t i) { return corners.begin() + static_cast<std::ptrdiff_t>(i); };
  for (const Outer& face : faces)
  {
    const auto first = std::min_element(corner(face.begin), corner(face.end));
    std::rotate(corner(face.begin), first, corner(face.end));
  }
  std::sort(faces.begin(), faces.end(), [&](const Outer& x, const Outer& y) {
    return std::lexicographical_compare(
      corner(x.begin), corner(x.end), corner(y.begin), corner(y.end));
  });
  for (const Outer& face : faces)
  {
    // A removed cell's faces are boundary (4.10).
    const bool exposed = face.other != None && !isAlive(face.other);
    view.faces.push_back(face.use);
    view.across.push_back(exposed ? CellKey(None) : face.other);
    view.boundary.push_back(exposed ? boundaryOfCell(face.other) : boundaryOf(face.use.face));
    const bool isBetween = isInterface(face.use);
    view.fixed.push_back(face.other == None || isActing(face.other) ? 0 : 1);
    view.shape.corners.insert(view.shape.corners.end(), corner(face.begin), corner(face.end));
    view.shape.closeFace(view.across.back() == None || isBetween);
  }
}

// Fills in the nodes, by place, and gives the corners their numbers there.
void CellComplex::numberNodes(const Point& origin, CellView& view) const
{
  std::vector<PointSortKey>& places = scratch_.places;
  EdgeTable& numberOf = scratch_.numberOf;
  places.clear();
  numberOf.reset(scratch_.corners.size());
  for (const std::uint32_t node : scratch_.corners)
  {
    std::uint32_t& number = numberOf.at(node, node);
    if (number == EdgeTable::Fresh)
    {
      number = 0;
      places.emplace_back(placeOf(node), node);
    }
  }
  std::sort(places.begin(), places.end());
  view.nodes.reserve(places.size());
  view.shape.nodes.reserve(places.size());
  for (std::uint32_t i = 0; i < places.size(); ++i)
  {
    const std::uint32_t node = places[i].number();
    numberOf.at(node, node) = i;
    view.nodes.push_back(node);
    view.shape.nodes.push_back(minus(places[i].point(), origin));
  }
  for (std::uint32_t& corner : scratch_.corners)
  {
    corner = numberOf.at(corner, corner);
  }
}

// --- opening

void CellComplex::open(CellKey key)
{
  if (opened(key))
  {
    return;
  }
  OpenCell cell;
  cell.region = regionOf(key);
  if (isOfWall(key))
  {
    cell.faces.reserve(whole_.mesh.cells[key + 1].firstUse - whole_.mesh.cells[key].firstUse);
    forEachFace(key, [&](const FaceUse& use) { cell.faces.push_back(use); });
    cell.box = whole_.mesh.cells[key].box;
    cell.origin = key;
    cell.boundary = whole_.mesh.cells[key].boundary;
    cell.removed = whole_.mesh.cells[key].removed;
    cell.reach = whole_.mesh.cells[key].reach;
    cell.place = whole_.known.places[key];
  }
  else
  {
    cell.box = boxOfHexahedron(key);
    cell.origin = key;
    cell.boundary = NoBoundary;
    cell.place = placeAndVolume(key, whole_.boxes.lowOf(cell.box));
    openHexahedron(cell.box, cell);
  }
  open_.add(key, std::move(cell));
}

void CellComplex::openHexahedron(std::uint32_t box, OpenCell& cell)
{
  for (unsigned side = 0; side < 6; ++side)
  {
    addSideOfHexahedron(box, side, cell);
  }
}

// Where the neighbour is a polyhedral box the side has its faces already; else it gets one.
void CellComplex::addSideOfHexahedron(std::uint32_t box, unsigned side, OpenCell& cell)
{
  BesideHexahedron& beside = scratch_.beside;
  lookBeside(whole_.boxes, whole_.sides, whole_.mesh, box, side, beside);
  const std::uint64_t mine = 6 * std::uint64_t(box) + side;
  const CellKey key = keyOfHexahedron(box);
  const auto known = madeFaces_.ofHexahedra.find(mine);
  if (!beside.faces.empty())
  {
    cell.faces.insert(cell.faces.end(), beside.faces.begin(), beside.faces.end());
    return;
  }
  if (known != madeFaces_.ofHexahedra.end())
  {
    cell.faces.emplace_back(known->second, cellsOf(known->second)[0] != key);
    return;
  }
  MadeFace face;
  for (const unsigned corner : cornersFromOutside(side))
  {
    face.nodes.push_back(nodeOfCorner(box, corner));
  }
  const bool isBetween = beside.box != None && !beside.isPolyhedral;
  face.cells = { key, isBetween ? keyOfHexahedron(beside.box) : CellKey(None) };
  face.boundary = NoBoundary;
  const FaceUse use = addFace(std::move(face));
  cell.faces.push_back(use);
  madeFaces_.ofHexahedra[mine] = use.face;
  if (isBetween)
  {
    madeFaces_.ofHexahedra[6 * std::uint64_t(beside.box) + (side ^ 1u)] = use.face;
  }
}

std::uint32_t CellComplex::nodeOfCorner(std::uint32_t box, unsigned corner)
{
  const Nodes& nodes = whole_.nodes;
  if (const std::uint32_t node =
        cartesian::nodeOfCorner(whole_.boxes, whole_.sides, nodes, box, corner);
      node != None)
  {
    return node;
  }
  VertexNode at = vertexAt(whole_.boxes, box, corner);
  const auto given = std::lower_bound(nodes.moreVertices.begin(), nodes.moreVertices.end(), at);
  if (given != nodes.moreVertices.end() && !(at < *given))
  {
    return given->node;
  }
  const std::size_t row = at.j + at.k * whole_.boxes.planes[1].size();
  at.node = nextNode();
  const auto [known, isNew] =
    madeNodes_.ofVertex.emplace(at.i + row * std::uint64_t(whole_.boxes.planes[0].size()), at.node);
  if (isNew)
  {
    madeNodes_.at.push_back(cornerOf(whole_.boxes.box(box), corner));
    madeNodes_.vertices.push_back(at);
  }
  return known->second;
}

}
