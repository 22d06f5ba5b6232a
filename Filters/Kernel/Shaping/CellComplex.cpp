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

CellComplex::CellComplex(CellsToShape& whole, const Slab& slab)
  : whole_(whole)
  , boxes_(whole.boxes)
  , patches_(whole.patches)
  , sides_(whole.sides)
  , nodes_(whole.nodes)
  , inner_(whole.inner)
  , cells_(whole.cells)
  , slab_(slab)
  , boxesOfSlab_{ boxes_.firstBoxOf(slab.layers.begin), boxes_.firstBoxOf(slab.layers.end) }
  , freeBoxes_{ boxes_.firstBoxOf(slab.free.begin), boxes_.firstBoxOf(slab.free.end) }
  , isOpenHexahedron_(boxesOfSlab_[1] - boxesOfSlab_[0])
  , nextKey_(static_cast<CellKey>(whole.cells.size() + whole.boxes.packed.size()))
{
  const auto [begin, end] = whole.cellsIn(slab.layers);
  firstOfSlab_ = begin;
  openOf_.assign(end - begin, None);
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

FaceUse CellComplex::useOf(const FaceOfCell& ref) const
{
  FaceUse use;
  const FaceOfCell::Kind kind = ref.kind();
  const bool inner = kind == FaceOfCell::Kind::Inner || kind == FaceOfCell::Kind::TurnedInner;
  const std::uint32_t first =
    kind == FaceOfCell::Kind::Patch ? 0 : (inner ? firstInner() : firstGiven());
  use.face = (ref.index + first) & MostFaces;
  use.turned = ref.turned() ? 1 : 0;
  return use;
}

const CellComplex::OpenCell* CellComplex::opened(CellKey key) const
{
  if (const std::size_t i = std::size_t(key) - firstOfSlab_; i < openOf_.size())
  {
    return openOf_[i] == None ? nullptr : &open_[openOf_[i]];
  }
  const std::size_t hexahedron = std::size_t(key) - cells_.size() - boxesOfSlab_[0];
  if (hexahedron < isOpenHexahedron_.size() && !isOpenHexahedron_[hexahedron])
  {
    return nullptr;
  }
  const auto found = openOfOther_.find(key);
  return found == openOfOther_.end() ? nullptr : &open_[found->second];
}

CellComplex::OpenCell* CellComplex::opened(CellKey key)
{
  return const_cast<OpenCell*>(static_cast<const CellComplex*>(this)->opened(key));
}

std::array<CellKey, 2> CellComplex::cellsOf(std::uint32_t face) const
{
  if (isShaped(face))
  {
    return shaped(face).cells;
  }
  if (!isInner(face))
  {
    return cells_.shaped.cells[face - firstGiven()];
  }
  std::array<CellKey, 2> keys = cells_.ofInnerFace[face - firstInner()];
  if (keys[0] == None || keys[1] == None)
  {
    const Side& side = sides_.common[whole_.sideOf[face - firstInner()]];
    const std::array<std::uint32_t, 2> boxes{ side.low, side.high };
    for (std::size_t k = 0; k < 2; ++k)
    {
      if (keys[k] == None && boxes[k] != None && sides_.polyhedralOrdinal(boxes[k]) == None)
      {
        keys[k] = keyOfHexahedron(boxes[k]);
      }
    }
  }
  return keys;
}

CellKey CellComplex::across(const FaceUse& use) const
{
  return isPatch(use.face) ? None : cellsOf(use.face)[use.turned ? 0 : 1];
}

double CellComplex::volumeOfBox(CellKey key) const
{
  const Box box = boxes_.box(boxOf(key));
  const Vector size = minus(box.high, box.low);
  return size[0] * size[1] * size[2];
}

bool CellComplex::isAlive(CellKey key) const
{
  if (const OpenCell* cell = opened(key))
  {
    return cell->alive && !cell->removed;
  }
  return key >= cells_.size() || !cells_.all[key].removed;
}

std::int32_t CellComplex::regionOf(CellKey key) const
{
  const OpenCell* cell = opened(key);
  return cell             ? cell->region
    : key < cells_.size() ? cells_.all[key].region
                          : boxes_.regionOf(static_cast<std::size_t>(key - cells_.size()));
}

bool CellComplex::isInterface(const FaceUse& use) const
{
  if (boxes_.regions.empty() || isPatch(use.face))
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
  return key < cells_.size() ? cells_.all[key].box
                             : static_cast<std::uint32_t>(key - cells_.size());
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
  const Point origin = boxes_.lowOf(boxOf(key));
  forEachFace(key, [&](const FaceUse& use) { addFaceTo(shape, use, origin); });
}

void CellComplex::lookAround(CellKey key, MeasuredCell& cell) const
{
  shape(key, cell.shape);
  measure(cell.shape, cell.measures);
  const Point origin = boxes_.lowOf(boxOf(key));
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
  return minus(boxes_.lowOf(boxOf(to)), boxes_.lowOf(boxOf(from)));
}

NeighbourCell CellComplex::placeAndVolume(CellKey key, const Point& origin) const
{
  const OpenCell* open = opened(key);
  if (open || key < cells_.size())
  {
    const Point low = boxes_.lowOf(open ? open->box : cells_.all[key].box);
    const NeighbourCell& place = open ? open->place : whole_.known.places[key];
    return { plus(minus(low, origin), place.centre), place.volume };
  }
  const Box box = boxes_.box(key - cells_.size());
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
  return key < cells_.size() ? whole_.known.places[key].volume : volumeOfBox(key);
}

double CellComplex::share(CellKey key) const
{
  return key < cells_.size() && !hasChanged(key) ? whole_.known.shares[key]
                                                 : volume(key) / volumeOfBox(key);
}

bool CellComplex::isAtFault(CellKey key) const
{
  const OpenCell* cell = opened(key);
  if (key < cells_.size() && !(cell && cell->changed))
  {
    return whole_.known.atFault[key] == IsAtFault::Yes;
  }
  if (cell && cell->fault != IsAtFault::Unknown)
  {
    return cell->fault == IsAtFault::Yes;
  }
  const CellShape& measures = measured(key);
  const bool any = isAnyAtFault(scratch_.polyhedron, measures);
  if (cell)
  {
    cell->fault = any ? IsAtFault::Yes : IsAtFault::No;
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
  const Point origin = boxes_.lowOf(boxOf(key));
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
    const auto a = static_cast<float>(x.second); // equal but for rounding is equal
    const auto b = static_cast<float>(y.second);
    return a != b ? a > b : x.first < y.first;
  });
  return result;
}

Layers CellComplex::layersOf(CellKey key) const
{
  const std::uint32_t layer = boxes_.globalOf(boxes_.packed[boxOf(key)]).index[2];
  std::array<std::uint8_t, 2> reach{ 0, 0 };
  if (const OpenCell* cell = opened(key))
  {
    reach = cell->reach;
  }
  else if (key < cells_.size())
  {
    reach = cells_.all[key].reach;
  }
  return { layer - reach[0], layer + reach[1] + 1 };
}

bool CellComplex::isFree(CellKey key) const
{
  const OpenCell* open = opened(key);
  const bool known = open || key < cells_.size();
  if (known && (open ? open->reach : cells_.all[key].reach) != NoReach)
  {
    const Layers layers = layersOf(key);
    return layers.begin >= slab_.free.begin && layers.end <= slab_.free.end;
  }
  const std::uint32_t box = open ? open->box : boxOf(key);
  return box >= freeBoxes_[0] && box < freeBoxes_[1];
}

bool CellComplex::isActing(CellKey key) const
{
  return isFree(key) && slab_.acting.contains(boxes_.globalOf(boxes_.packed[boxOf(key)]).index[2]);
}

bool CellComplex::hasChangedNear(CellKey key, std::uint32_t mark) const
{
  const auto hasChangedSince = [&](CellKey other) {
    const OpenCell* cell = opened(other);
    return cell && cell->changed && cell->changedAt >= mark;
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
  return straddlesStages(layersOf(keys), boxes_.allLayers().end);
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
    const bool open = openOf_[key - firstOfSlab_] != None;
    if ((!open || (isAlive(key) && isFree(key))) && isKept(key, open))
    {
      keys.push_back(key);
    }
  }
  const auto others = static_cast<std::ptrdiff_t>(keys.size());
  for (const auto& [key, open] : openOfOther_)
  {
    const PackedBox& box = boxes_.packed[open_[open].box];
    if (isAlive(key) && open_[open].changed && key >= cells_.size() && isFree(key) &&
      slab_.acting.contains(boxes_.globalOf(box).index[2]) && isKept(key, true))
    {
      keys.push_back(key);
    }
  }
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
  const auto look = [&](CellKey key, const OpenCell& cell) {
    if (cell.changed && cell.changedAt >= mark)
    {
      changed.push_back(key);
      for (const FaceUse& use : cell.faces)
      {
        changed.push_back(across(use));
      }
    }
  };
  for (std::size_t i = 0; i < openOf_.size(); ++i)
  {
    if (openOf_[i] != None)
    {
      look(static_cast<CellKey>(firstOfSlab_ + i), open_[openOf_[i]]);
    }
  }
  for (const auto& [key, open] : openOfOther_)
  {
    look(key, open_[open]);
  }
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
  numberNodes(boxes_.lowOf(boxOf(keys.front())), view);
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
  if (key < cells_.size())
  {
    cell.faces.reserve(cells_.all[key + 1].firstFace - cells_.all[key].firstFace);
    forEachFace(key, [&](const FaceUse& use) { cell.faces.push_back(use); });
    cell.box = cells_.all[key].box;
    cell.origin = key;
    cell.boundary = cells_.all[key].boundary;
    cell.removed = cells_.all[key].removed;
    cell.reach = cells_.all[key].reach;
    cell.place = whole_.known.places[key];
  }
  else
  {
    cell.box = static_cast<std::uint32_t>(key - cells_.size());
    cell.origin = key;
    cell.boundary = NoBoundary;
    cell.place = placeAndVolume(key, boxes_.lowOf(cell.box));
    openHexahedron(cell.box, cell);
  }
  const std::size_t ofSlab = std::size_t(key) - firstOfSlab_;
  (ofSlab < openOf_.size() ? openOf_[ofSlab] : openOfOther_[key]) =
    static_cast<std::uint32_t>(open_.size());
  if (const std::size_t n = std::size_t(cell.box) - boxesOfSlab_[0];
      key >= cells_.size() && n < isOpenHexahedron_.size())
  {
    isOpenHexahedron_[n] = true;
  }
  open_.push_back(std::move(cell));
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
  const bool upper = side % 2 == 1;
  const std::uint32_t other =
    facing(boxes_, boxes_.packed[box], static_cast<int>(side / 2), upper)[0];
  const std::uint32_t n = sides_.polyhedralOrdinal(other);
  for (std::size_t i = n == None ? 0 : sides_.boxStart[n]; n != None && i < sides_.boxStart[n + 1];
       ++i)
  {
    const std::size_t s = sides_.ofBox[i].side;
    const Side& shared = sides_.common[s];
    const bool between = upper ? shared.low == box : shared.high == box;
    if (between && shared.axis == side / 2 && inner_.sideStart[s] < inner_.sideStart[s + 1])
    {
      for (std::size_t f = inner_.sideStart[s]; f < inner_.sideStart[s + 1]; ++f)
      {
        FaceUse use = useOf(FaceOfCell(f, FaceOfCell::Kind::Inner));
        use.turned = upper ? 0 : 1;
        cell.faces.push_back(use);
      }
      return;
    }
  }
  const std::uint64_t mine = 6 * std::uint64_t(box) + side;
  FaceUse use;
  if (const std::uint32_t known = knownFace(box, side); known != None)
  {
    use.face = known & MostFaces;
    use.turned = cellsOf(known)[0] == keyOfHexahedron(box) ? 0 : 1;
    cell.faces.push_back(use);
    return;
  }
  Shaped face;
  for (const unsigned corner : cornersFromOutside(side))
  {
    face.nodes.push_back(nodeOfCorner(box, corner));
  }
  face.cells = { keyOfHexahedron(box),
    other != None && n == None ? keyOfHexahedron(other) : CellKey(None) };
  face.boundary = NoBoundary;
  use = addShaped(std::move(face));
  cell.faces.push_back(use);
  faceOfHexahedron_[mine] = use.face;
  if (other != None && n == None)
  {
    faceOfHexahedron_[6 * std::uint64_t(other) + (side ^ 1u)] = use.face;
  }
}

// The shaped face on a side of a hexahedron, or None.
std::uint32_t CellComplex::knownFace(std::uint32_t box, std::uint32_t side) const
{
  const auto known = faceOfHexahedron_.find(6 * std::uint64_t(box) + side);
  if (known != faceOfHexahedron_.end())
  {
    return known->second;
  }
  const auto& given = cells_.shaped.ofHexahedra;
  const auto at = std::lower_bound(given.begin(), given.end(), std::make_pair(box, side),
    [](const ShapedFaces::HexahedronSide& x, const std::pair<std::uint32_t, std::uint32_t>& y) {
      return std::make_pair(x.box, x.side) < y;
    });
  return at != given.end() && at->box == box && at->side == side ? firstGiven() + at->face : None;
}

std::uint32_t CellComplex::nodeOfCorner(std::uint32_t box, unsigned corner)
{
  if (const std::uint32_t ordinal = sides_.ordinal[box]; ordinal != None)
  {
    return nodes_.ofDivided[ordinal & ~Sides::HexahedronBit][corner];
  }
  const auto& low = boxes_.globalOf(boxes_.packed[box]).index;
  const VertexNode at{ low[2] + (corner >> 2 & 1), low[1] + (corner >> 1 & 1),
    low[0] + (corner & 1), nextNode() };
  const std::size_t row = at.j + at.k * boxes_.planes[1].size();
  const Point p = cornerOf(boxes_.box(box), corner);
  const auto begin = nodes_.grid.begin();
  const auto end = begin + static_cast<std::ptrdiff_t>(nodes_.rowStart[row + 1]);
  const auto found =
    std::lower_bound(begin + static_cast<std::ptrdiff_t>(nodes_.rowStart[row]), end, p);
  if (found != end && *found == p)
  {
    return static_cast<std::uint32_t>(nodes_.patchPoints) +
      static_cast<std::uint32_t>(found - begin);
  }
  const auto given = std::lower_bound(nodes_.moreVertices.begin(), nodes_.moreVertices.end(), at);
  if (given != nodes_.moreVertices.end() && !(at < *given))
  {
    return given->node;
  }
  const auto [known, isNew] =
    nodeOfVertex_.emplace(at.i + row * std::uint64_t(boxes_.planes[0].size()), at.node);
  if (isNew)
  {
    added_.push_back(p);
    vertices_.push_back(at);
  }
  return known->second;
}

}
