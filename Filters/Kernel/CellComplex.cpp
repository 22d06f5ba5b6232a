#include "CellComplex.h"

#include <algorithm>
#include <tuple>

namespace cartesian
{

namespace
{

constexpr std::size_t CellsAChunk = 512;

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
  , nextKey_(static_cast<CellKey>(whole.cells.size() + whole.boxes.boxes.size()))
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

std::array<CellKey, 2> CellsToShape::cellsIn(Layers layers) const
{
  const auto firstOf = [&](std::uint32_t layer) {
    const auto& polyhedral = sides.polyhedral;
    const auto at = std::lower_bound(polyhedral.begin(), polyhedral.end(), boxes.firstBoxOf(layer));
    return static_cast<CellKey>(cells.boxStart[static_cast<std::size_t>(at - polyhedral.begin())]);
  };
  return { firstOf(layers.begin), firstOf(layers.end) };
}

void CellsToShape::measure(Layers layers, Execution& execution)
{
  for (const ShapedFaces::HexahedronSide& side : cells.shaped.ofHexahedra)
  {
    for (std::uint32_t& cell : cells.shaped.cells[side.face])
    {
      cell =
        cell == ShapedFaces::SomeHexahedron ? static_cast<CellKey>(cells.size() + side.box) : cell;
    }
  }
  places.assign(cells.size(), {});
  atFault.assign(cells.size(), 0);
  const CellComplex complex(*this, {});
  const std::array<CellKey, 2> range = cellsIn(layers);
  const CellKey first = range[0]; // clang takes no structured bindings into lambdas
  execution.forEach(range[1] - first, CellsAChunk, [&](std::size_t begin, std::size_t end) {
    Polyhedron polyhedron;
    CellShape measures;
    for (std::size_t c = first + begin; c < first + end; ++c)
    {
      complex.shape(static_cast<CellKey>(c), polyhedron);
      cartesian::measure(polyhedron, measures);
      places[c] = { measures.centre, measures.volume };
      atFault[c] = isAnyAtFault(polyhedron, measures) ? 1 : 0;
    }
  });
}

// --- reading

FaceUse CellComplex::useOf(const FaceRef& ref) const
{
  FaceUse use;
  const FaceRef::Kind kind = ref.kind();
  const bool inner = kind == FaceRef::Kind::Inner || kind == FaceRef::Kind::TurnedInner;
  const std::uint32_t first =
    kind == FaceRef::Kind::Patch ? 0 : (inner ? firstInner() : firstGiven());
  use.face = (ref.index + first) & MostFaces;
  use.turned = ref.turned() ? 1 : 0;
  return use;
}

FaceRef CellComplex::refOf(const FaceUse& use) const
{
  if (isPatch(use.face))
  {
    return FaceRef(use.face, FaceRef::Kind::Patch);
  }
  if (!isInner(use.face))
  {
    return FaceRef(
      use.face - firstGiven(), use.turned ? FaceRef::Kind::TurnedShaped : FaceRef::Kind::Shaped);
  }
  return FaceRef(
    use.face - firstInner(), use.turned ? FaceRef::Kind::TurnedInner : FaceRef::Kind::Inner);
}

const CellComplex::OpenCell* CellComplex::opened(CellKey key) const
{
  if (const std::size_t i = std::size_t(key) - firstOfSlab_; i < openOf_.size())
  {
    return openOf_[i] == None ? nullptr : &open_[openOf_[i]];
  }
  const auto found = openOfOther_.find(key);
  return found == openOfOther_.end() ? nullptr : &open_[found->second];
}

CellComplex::OpenCell* CellComplex::opened(CellKey key)
{
  return const_cast<OpenCell*>(static_cast<const CellComplex*>(this)->opened(key));
}

std::size_t CellComplex::sideOf(std::uint32_t innerFace) const
{
  const auto& start = inner_.sideStart;
  return static_cast<std::size_t>(
    std::upper_bound(start.begin(), start.end(), innerFace) - start.begin() - 1);
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
    const Side& side = sides_.sides[sideOf(face - firstInner())];
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
  const Box& box = boxes_.boxes[boxOf(key)];
  const Vector size = minus(box.high, box.low);
  return size[0] * size[1] * size[2];
}

bool CellComplex::isAlive(CellKey key) const
{
  if (const OpenCell* cell = opened(key))
  {
    return cell->alive && !cell->removed;
  }
  return key >= cells_.size() || !cells_.cells[key].removed;
}

std::uint32_t CellComplex::boxOf(CellKey key) const
{
  if (const OpenCell* cell = opened(key))
  {
    return cell->box;
  }
  return key < cells_.size() ? cells_.cells[key].box
                             : static_cast<std::uint32_t>(key - cells_.size());
}

void CellComplex::addFaceTo(Polyhedron& shape, const FaceUse& use, const Point& origin) const
{
  forEachNodeOf(use, [&](std::uint32_t node) {
    shape.addCorner(static_cast<std::uint32_t>(shape.nodes.size()));
    shape.nodes.push_back(minus(placeOf(node), origin));
  });
  const CellKey other = across(use);
  shape.closeFace(other == None || !isAlive(other));
}

void CellComplex::shape(CellKey key, Polyhedron& shape) const
{
  shape.clear();
  const Point& origin = boxes_.boxes[boxOf(key)].low;
  forEachFace(key, [&](const FaceUse& use) { addFaceTo(shape, use, origin); });
}

void CellComplex::lookAround(CellKey key, MeasuredCell& cell) const
{
  shape(key, cell.shape);
  measure(cell.shape, cell.measures);
  const Point& origin = boxes_.boxes[boxOf(key)].low;
  cell.across.clear();
  cell.beyond.clear();
  forEachFace(key, [&](const FaceUse& use) {
    const bool boundary = cell.shape.isBoundary[cell.across.size()] != 0;
    cell.across.push_back(boundary ? CellKey(None) : across(use));
    cell.beyond.push_back(boundary ? Beyond{} : placeAndVolume(cell.across.back(), origin));
  });
}

Beyond CellComplex::placeAndVolume(CellKey key, const Point& origin) const
{
  const Box& box = boxes_.boxes[boxOf(key)];
  const Vector from = minus(box.low, origin);
  Beyond place;
  if (const OpenCell* cell = opened(key))
  {
    place = cell->place;
  }
  else
  {
    place = key < cells_.size() ? whole_.places[key]
                                : Beyond{ scaled(minus(box.high, box.low), 0.5), volumeOfBox(key) };
  }
  return { plus(from, place.centre), place.volume };
}

Beyond CellComplex::measuredPlace(CellKey key) const
{
  Polyhedron polyhedron;
  CellShape measures;
  shape(key, polyhedron);
  measure(polyhedron, measures);
  return { measures.centre, measures.volume };
}

double CellComplex::volume(CellKey key) const
{
  return placeAndVolume(key, boxes_.boxes[boxOf(key)].low).volume;
}

bool CellComplex::isAtFault(CellKey key) const
{
  const OpenCell* cell = opened(key);
  if (key < cells_.size() && !(cell && cell->changed))
  {
    return whole_.atFault[key] != 0;
  }
  if (cell && cell->fault != OpenCell::Fault::Unknown)
  {
    return cell->fault == OpenCell::Fault::Yes;
  }
  Polyhedron polyhedron;
  CellShape measures;
  shape(key, polyhedron);
  measure(polyhedron, measures);
  const bool any = isAnyAtFault(polyhedron, measures);
  if (cell)
  {
    cell->fault = any ? OpenCell::Fault::Yes : OpenCell::Fault::No;
  }
  return any;
}

void CellComplex::lookBeyond(CellKey key, CellView& view) const
{
  const Point& origin = boxes_.boxes[boxOf(key)].low;
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
  Polyhedron polyhedron;
  CellShape measures;
  shape(key, polyhedron);
  measure(polyhedron, measures);
  std::vector<std::pair<CellKey, double>> result;
  std::size_t face = 0;
  forEachFace(key, [&](const FaceUse& use) {
    const double area = norm(measures.faces[face].area);
    const CellKey other = polyhedron.isBoundary[face] ? None : across(use);
    ++face;
    if (other == None)
    {
      return;
    }
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
  });
  std::sort(result.begin(), result.end(), [](const auto& x, const auto& y) {
    const auto a = static_cast<float>(x.second); // equal but for rounding is equal
    const auto b = static_cast<float>(y.second);
    return a != b ? a > b : x.first < y.first;
  });
  return result;
}

Layers CellComplex::layersOf(CellKey key) const
{
  const std::uint32_t layer = boxes_.globalOf(boxes_.boxes[boxOf(key)]).index[2];
  std::array<std::uint8_t, 2> reach{ 0, 0 };
  if (const OpenCell* cell = opened(key))
  {
    reach = cell->reach;
  }
  else if (key < cells_.size())
  {
    reach = cells_.cells[key].reach;
  }
  return { layer - reach[0], layer + reach[1] + 1 };
}

bool CellComplex::isFree(CellKey key) const
{
  const Layers layers = layersOf(key);
  return layers.begin >= slab_.free.begin && layers.end <= slab_.free.end;
}

bool CellComplex::mayMerge(const std::vector<CellKey>& keys) const
{
  Layers all = layersOf(keys.front());
  for (const CellKey key : keys)
  {
    const Layers layers = layersOf(key);
    all = { std::min(all.begin, layers.begin), std::max(all.end, layers.end) };
  }
  return all.begin >= slab_.free.begin && all.end <= slab_.free.end &&
    all.end - all.begin <= MostLayersOfACell;
}

std::vector<CellKey> CellComplex::polyhedra() const
{
  std::vector<CellKey> keys;
  for (const CellKey key : acting_)
  {
    if (!isOpen(key) || (isAlive(key) && isFree(key)))
    {
      keys.push_back(key);
    }
  }
  const auto others = static_cast<std::ptrdiff_t>(keys.size());
  for (const auto& [key, open] : openOfOther_)
  {
    const Box& box = boxes_.boxes[open_[open].box];
    if (isAlive(key) && open_[open].changed && key >= cells_.size() && isFree(key) &&
      slab_.acting.contains(boxes_.globalOf(box).index[2]))
    {
      keys.push_back(key);
    }
  }
  std::sort(keys.begin() + others, keys.end());
  return keys;
}

std::vector<CellKey> CellComplex::polyhedraChangedSince(std::uint32_t mark) const
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
  std::vector<CellKey> keys = polyhedra();
  keys.erase(
    std::remove_if(keys.begin(), keys.end(),
      [&](CellKey key) { return !std::binary_search(changed.begin(), changed.end(), key); }),
    keys.end());
  return keys;
}

// Nodes by place and faces by nodes: sums of the same numbers in the same order, whatever numbers
// nodes and faces have got.
void CellComplex::view(const std::vector<CellKey>& keys, CellView& view) const
{
  struct Outer
  {
    FaceUse use;
    CellKey other;
    std::size_t begin; // of its corners
    std::size_t end;
  };
  constexpr std::size_t UsualFaces = 24; // saves time only
  std::vector<Outer> faces;
  std::vector<std::uint32_t> corners;
  faces.reserve(UsualFaces);
  corners.reserve(4 * UsualFaces);
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
  numberNodes(boxes_.boxes[boxOf(keys.front())].low, corners, view);
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
    view.fixed.push_back(face.other == None || isFree(face.other) ? 0 : 1);
    view.shape.corners.insert(view.shape.corners.end(), corner(face.begin), corner(face.end));
    view.shape.closeFace(view.across.back() == None);
  }
}

// Fills in the nodes, by place, and gives the corners their numbers there.
void CellComplex::numberNodes(
  const Point& origin, std::vector<std::uint32_t>& corners, CellView& view) const
{
  std::vector<std::uint32_t> nodes = corners;
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  struct Placed
  {
    Point at;
    std::uint32_t which; // of the nodes
  };
  std::vector<Placed> places;
  places.reserve(nodes.size());
  for (std::uint32_t i = 0; i < nodes.size(); ++i)
  {
    places.push_back({ placeOf(nodes[i]), i });
  }
  std::sort(places.begin(), places.end(), [](const Placed& x, const Placed& y) {
    return std::tie(x.at, x.which) < std::tie(y.at, y.which);
  });
  std::vector<std::uint32_t> numbers(nodes.size());
  for (std::uint32_t i = 0; i < places.size(); ++i)
  {
    numbers[places[i].which] = i;
    view.nodes.push_back(nodes[places[i].which]);
    view.shape.nodes.push_back(minus(places[i].at, origin));
  }
  for (std::uint32_t& corner : corners)
  {
    const auto at = std::lower_bound(nodes.begin(), nodes.end(), corner);
    corner = numbers[static_cast<std::size_t>(at - nodes.begin())];
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
  if (key < cells_.size())
  {
    forEachFace(key, [&](const FaceUse& use) { cell.faces.push_back(use); });
    cell.box = cells_.cells[key].box;
    cell.origin = key;
    cell.boundary = cells_.cells[key].boundary;
    cell.removed = cells_.cells[key].removed;
    cell.reach = cells_.cells[key].reach;
    cell.place = whole_.places[key];
  }
  else
  {
    cell.box = static_cast<std::uint32_t>(key - cells_.size());
    cell.origin = key;
    cell.boundary = NoBoundary;
    cell.place = placeAndVolume(key, boxes_.boxes[cell.box].low);
    openHexahedron(cell.box, cell);
  }
  const std::size_t ofSlab = std::size_t(key) - firstOfSlab_;
  (ofSlab < openOf_.size() ? openOf_[ofSlab] : openOfOther_[key]) =
    static_cast<std::uint32_t>(open_.size());
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
    facing(boxes_, boxes_.boxes[box], static_cast<int>(side / 2), upper)[0];
  const std::uint32_t n = sides_.polyhedralOrdinal(other);
  for (std::size_t i = n == None ? 0 : sides_.boxStart[n]; n != None && i < sides_.boxStart[n + 1];
       ++i)
  {
    const std::size_t s = sides_.ofBox[i].side;
    const Side& shared = sides_.sides[s];
    const bool between = upper ? shared.low == box : shared.high == box;
    if (between && shared.axis == side / 2 && inner_.sideStart[s] < inner_.sideStart[s + 1])
    {
      for (std::size_t f = inner_.sideStart[s]; f < inner_.sideStart[s + 1]; ++f)
      {
        FaceUse use = useOf(FaceRef(f, FaceRef::Kind::Inner));
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
    face.nodes.push_back(nodeOfCorner(boxes_.boxes[box], corner));
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

std::uint32_t CellComplex::nodeOfCorner(const Box& box, unsigned corner)
{
  const auto b = static_cast<std::size_t>(&box - boxes_.boxes.data());
  if (const std::uint32_t ordinal = sides_.ordinal[b]; ordinal != None)
  {
    return nodes_.ofDivided[ordinal & ~Sides::HexahedronBit][corner];
  }
  const auto& low = boxes_.globalOf(box).index;
  const VertexNode at{ low[2] + (corner >> 2 & 1), low[1] + (corner >> 1 & 1),
    low[0] + (corner & 1), nextNode() };
  const std::size_t row = at.j + at.k * boxes_.planes[1].size();
  const Point p = cornerOf(box, corner);
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
