#include "CellComplex.h"

#include <algorithm>

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

CellComplex::CellComplex(const Boxes& boxes, const Patches& patches, Sides& sides, Nodes& nodes,
  const InnerFaces& inner, Cells& cells, Execution& execution)
  : boxes_(boxes)
  , patches_(patches)
  , sides_(sides)
  , nodes_(nodes)
  , inner_(inner)
  , cells_(cells)
  , openOf_(cells.size(), None)
  , nextKey_(static_cast<CellKey>(cells.size() + boxes.boxes.size()))
{
  places_.resize(cells.size());
  atFault_.resize(cells.size());
  execution.forEach(cells.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    Polyhedron polyhedron;
    CellShape measures;
    for (std::size_t c = begin; c < end; ++c)
    {
      shape(static_cast<CellKey>(c), polyhedron);
      measure(polyhedron, measures);
      places_[c] = { measures.centre, measures.volume };
      atFault_[c] = isAnyAtFault(polyhedron, measures) ? 1 : 0;
    }
  });
}

// --- reading

FaceUse CellComplex::useOf(const FaceRef& ref) const
{
  FaceUse use;
  use.face = (ref.index + (ref.kind() == FaceRef::Kind::Patch ? 0 : firstInner())) & MostFaces;
  use.turned = ref.turned() ? 1 : 0;
  return use;
}

FaceRef CellComplex::refOf(const FaceUse& use) const
{
  if (isPatch(use.face))
  {
    return FaceRef(use.face, FaceRef::Kind::Patch);
  }
  if (isShaped(use.face))
  {
    return FaceRef(
      use.face - firstShaped(), use.turned ? FaceRef::Kind::TurnedShaped : FaceRef::Kind::Shaped);
  }
  return FaceRef(
    use.face - firstInner(), use.turned ? FaceRef::Kind::TurnedInner : FaceRef::Kind::Inner);
}

const CellComplex::OpenCell* CellComplex::opened(CellKey key) const
{
  if (key < openOf_.size())
  {
    return openOf_[key] == None ? nullptr : &open_[openOf_[key]];
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
    shape.nodes.push_back(minus(nodes_.at[node], origin));
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
    place = key < cells_.size() ? places_[key]
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
    return atFault_[key] != 0;
  }
  Polyhedron polyhedron;
  CellShape measures;
  shape(key, polyhedron);
  measure(polyhedron, measures);
  return isAnyAtFault(polyhedron, measures);
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

std::vector<CellKey> CellComplex::polyhedra() const
{
  std::vector<CellKey> keys;
  for (CellKey key = 0; key < openOf_.size(); ++key)
  {
    if (isAlive(key))
    {
      keys.push_back(key);
    }
  }
  const auto others = static_cast<std::ptrdiff_t>(keys.size());
  for (const auto& [key, open] : openOfOther_)
  {
    if (isAlive(key) && open_[open].changed)
    {
      keys.push_back(key);
    }
  }
  std::sort(keys.begin() + others, keys.end());
  return keys;
}

// Nodes by place and faces by nodes: sums of the same numbers in the same order, whatever numbers
// nodes and faces have got.
void CellComplex::view(const std::vector<CellKey>& keys, CellView& view) const
{
  view = {};
  const Point& origin = boxes_.boxes[boxOf(keys.front())].low;
  const auto forEachOuter = [&](const auto& visit) {
    for (const CellKey key : keys)
    {
      forEachFace(key, [&](const FaceUse& use) {
        const CellKey other = across(use);
        if (other == None || std::find(keys.begin(), keys.end(), other) == keys.end())
        {
          visit(use);
        }
      });
    }
  };
  std::vector<std::pair<Vector, std::uint32_t>> places;
  forEachOuter([&](const FaceUse& use) {
    forEachNodeOf(
      use, [&](std::uint32_t node) { places.emplace_back(minus(nodes_.at[node], origin), node); });
  });
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  for (const auto& [place, node] : places)
  {
    view.shape.nodes.push_back(place);
    view.nodes.push_back(node);
  }
  std::vector<std::pair<std::vector<std::uint32_t>, FaceUse>> faces;
  forEachOuter([&](const FaceUse& use) {
    std::vector<std::uint32_t> ring;
    forEachNodeOf(use, [&](std::uint32_t node) {
      const auto at = std::make_pair(minus(nodes_.at[node], origin), node);
      ring.push_back(static_cast<std::uint32_t>(
        std::lower_bound(places.begin(), places.end(), at) - places.begin()));
    });
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    faces.emplace_back(std::move(ring), use);
  });
  std::sort(
    faces.begin(), faces.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
  for (const auto& [ring, use] : faces)
  {
    // A removed cell's faces are boundary (4.10).
    const CellKey other = across(use);
    const bool exposed = other != None && !isAlive(other);
    view.faces.push_back(use);
    view.across.push_back(exposed ? CellKey(None) : other);
    view.boundary.push_back(exposed ? boundaryOfCell(other) : boundaryOf(use.face));
    view.shape.corners.insert(view.shape.corners.end(), ring.begin(), ring.end());
    view.shape.closeFace(view.across.back() == None);
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
    cell.place = places_[key];
    openOf_[key] = static_cast<std::uint32_t>(open_.size());
  }
  else
  {
    cell.box = static_cast<std::uint32_t>(key - cells_.size());
    cell.origin = key;
    cell.boundary = NoBoundary;
    cell.place = placeAndVolume(key, boxes_.boxes[cell.box].low);
    openHexahedron(cell.box, cell);
    openOfOther_[key] = static_cast<std::uint32_t>(open_.size());
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
  const auto known = faceOfHexahedron_.find(mine);
  FaceUse use;
  use.turned = 0;
  if (known != faceOfHexahedron_.end())
  {
    use.face = known->second & MostFaces;
    use.turned = 1;
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
  if (other != None && n == None)
  {
    faceOfHexahedron_[6 * std::uint64_t(other) + (side ^ 1u)] = use.face;
  }
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
    low[0] + (corner & 1), static_cast<std::uint32_t>(nodes_.at.size()) };
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
  const auto [known, isNew] =
    nodeOfVertex_.emplace(at.i + row * std::uint64_t(boxes_.planes[0].size()), at.node);
  if (isNew)
  {
    nodes_.at.push_back(p);
    vertices_.push_back(at);
  }
  return known->second;
}

}
