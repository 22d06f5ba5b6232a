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
  execution.forEach(cells.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    Polyhedron polyhedron;
    CellShape measures;
    for (std::size_t c = begin; c < end; ++c)
    {
      shape(static_cast<CellKey>(c), polyhedron);
      measure(polyhedron, measures);
      places_[c] = { measures.centre, measures.volume };
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

template <class Visitor>
void CellComplex::forEachFace(CellKey key, Visitor&& visit) const
{
  if (const OpenCell* cell = opened(key))
  {
    std::for_each(cell->faces.begin(), cell->faces.end(), visit);
    return;
  }
  for (std::size_t f = cells_.cells[key].firstFace; f < cells_.cells[key + 1].firstFace; ++f)
  {
    visit(useOf(cells_.faces[f]));
  }
}

// Counter-clockwise from outside the cell that uses the face.
template <class Visitor>
void CellComplex::forEachNodeOf(const FaceUse& use, Visitor&& visit) const
{
  if (!isShaped(use.face))
  {
    forEachNode(refOf(use), patches_, inner_, cells_.shaped, visit);
    return;
  }
  const std::vector<std::uint32_t>& nodes = shaped(use.face).nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    visit(nodes[use.turned ? nodes.size() - 1 - i : i]);
  }
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
    if (open_[open].alive && open_[open].changed)
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
      const CellKey other = across(use);
      if (other != None && std::find(found.begin(), found.end(), other) == found.end() &&
        hasEdge(use, u, v))
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
  for (const CellCut::Point& point : cut.points)
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
std::uint32_t CellComplex::own(std::uint32_t face, CellKey cell)
{
  if (isShaped(face))
  {
    return face;
  }
  FaceUse use;
  use.face = face & MostFaces;
  use.turned = 0;
  Shaped copy;
  forEachNodeOf(use, [&](std::uint32_t node) { copy.nodes.push_back(node); });
  copy.cells = { cell, None };
  copy.boundary = NoBoundary;
  if (isPatch(face))
  {
    copy.boundary = patches_.boundary[face];
  }
  else
  {
    copy.cells = cellsOf(face);
    const Side& side = sides_.sides[sideOf(face - firstInner())];
    for (std::size_t k = 0; k < 2; ++k)
    {
      if (copy.cells[k] == None)
      {
        copy.boundary = boundaryBeyond(patches_, sides_, k == 0 ? side.low : side.high);
      }
    }
  }
  const std::uint32_t number = firstShaped() + static_cast<std::uint32_t>(shaped_.size());
  for (const CellKey key : copy.cells)
  {
    if (key == None)
    {
      continue;
    }
    open(key);
    for (FaceUse& other : opened(key)->faces)
    {
      other.face = (other.face == face ? number : other.face) & MostFaces;
    }
  }
  shaped_.push_back(std::move(copy));
  shapedAs_[face] = number;
  return number;
}

// The number that a face has got since a view was taken.
std::uint32_t CellComplex::renamed(std::uint32_t face) const
{
  const auto found = shapedAs_.find(face);
  return found == shapedAs_.end() ? face : found->second;
}

void CellComplex::insertNode(CellKey cell, std::uint32_t u, std::uint32_t v, std::uint32_t node)
{
  opened(cell)->changed = true;
  const std::size_t count = opened(cell)->faces.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const FaceUse use = opened(cell)->faces[i];
    if (!hasEdge(use, u, v))
    {
      continue;
    }
    std::vector<std::uint32_t>& nodes = shaped(own(use.face, cell)).nodes;
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
  if (isShaped(use.face))
  {
    shaped(use.face).cells[use.turned] = key;
  }
  else if (!isPatch(use.face))
  {
    cells_.ofInnerFace[use.face - firstInner()][use.turned] = key;
  }
}

Point CellComplex::placeOf(CellKey key, const CellCut::Point& point) const
{
  const Point& origin = boxes_.boxes[boxOf(key)].low;
  Point place;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    place[axis] = static_cast<Level>(
      static_cast<std::int64_t>(origin[axis]) + static_cast<std::int64_t>(point.at[axis]));
  }
  return place;
}

bool CellComplex::meetsNode(
  const std::vector<CellKey>& touched, const CellView& view, const CellCut& cut) const
{
  std::vector<Point> places;
  for (const CellCut::Point& point : cut.points)
  {
    places.push_back(placeOf(touched.front(), point));
  }
  std::sort(places.begin(), places.end());
  bool found =
    std::adjacent_find(places.begin(), places.end()) != places.end() || meetsFace(view, cut);
  for (const CellKey key : touched)
  {
    forEachFace(key, [&](const FaceUse& use) {
      forEachNodeOf(use, [&](std::uint32_t node) {
        found = found || std::binary_search(places.begin(), places.end(), nodes_.at[node]);
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
    if (whole ||
      std::any_of(face.corners.begin(), face.corners.end(),
        [&](std::uint32_t corner) { return corner >= view.nodes.size(); }))
    {
      return false;
    }
    piece.clear();
    for (const std::uint32_t corner : face.corners)
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
  std::vector<std::uint32_t> ring;
  forEachNodeOf(use, [&](std::uint32_t node) { ring.push_back(node); });
  const Point& origin = boxes_.boxes[boxOf(key)].low;
  Polyhedron face;
  bool divided = false;
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const std::uint32_t next = ring[i + 1 < ring.size() ? i + 1 : 0];
    face.addCorner(static_cast<std::uint32_t>(face.nodes.size()));
    face.nodes.push_back(minus(nodes_.at[ring[i]], origin));
    for (const CellCut::Point& point : cut.points)
    {
      const std::uint32_t low = view.nodes[point.low];
      const std::uint32_t high = view.nodes[point.high];
      if ((low == ring[i] && high == next) || (high == ring[i] && low == next))
      {
        divided = true;
        face.addCorner(static_cast<std::uint32_t>(face.nodes.size()));
        face.nodes.push_back(point.at);
      }
    }
  }
  if (!divided)
  {
    return false;
  }
  face.closeFace(false);
  CellShape shape;
  measure(face, shape);
  return !isStar(face, 0, unit(shape.faces[0].area));
}

// Cells that touch in an edge only have the same points on it.
std::uint32_t CellComplex::addNode(const Point& place)
{
  const auto [at, isNew] = cutNodes_.emplace(place, static_cast<std::uint32_t>(nodes_.at.size()));
  if (isNew)
  {
    nodes_.at.push_back(place);
  }
  return at->second;
}

void CellComplex::cut(
  CellKey key, const CellView& view, const CellCut& cut, std::vector<CellKey>& parts)
{
  changed_ = true;
  std::vector<std::uint32_t> nodes = view.nodes;
  for (const CellCut::Point& point : cut.points)
  {
    nodes.push_back(addNode(placeOf(key, point)));
    const std::uint32_t u = view.nodes[point.low];
    const std::uint32_t v = view.nodes[point.high];
    for (const CellKey around : cellsAround(key, u, v))
    {
      insertNode(around, u, v, nodes.back());
    }
  }
  std::vector<FaceUse> faces = view.faces;
  for (FaceUse& use : faces)
  {
    use.face = renamed(use.face) & MostFaces;
  }
  std::vector<CellKey> keys{ key };
  for (std::uint32_t part = 1; part < cut.parts; ++part)
  {
    OpenCell cell;
    cell.box = opened(key)->box;
    cell.origin = opened(key)->origin;
    cell.boundary = opened(key)->boundary;
    openOfOther_[nextKey_] = static_cast<std::uint32_t>(open_.size());
    keys.push_back(nextKey_++);
    open_.push_back(std::move(cell));
  }
  std::vector<std::uint32_t> pieces(faces.size());
  for (const CellCut::Face& face : cut.faces)
  {
    if (face.source != CellCut::NoSource)
    {
      ++pieces[face.source];
    }
  }
  std::vector<std::uint32_t> owned(
    faces.size(), None); // of divided faces that have a piece already
  opened(key)->faces.clear();
  for (const CellCut::Face& face : cut.faces)
  {
    Shaped piece;
    for (const std::uint32_t corner : face.corners)
    {
      piece.nodes.push_back(nodes[corner]);
    }
    if (face.source == CellCut::NoSource)
    {
      piece.cells = { keys[face.below], keys[face.above] };
      piece.boundary = NoBoundary;
      FaceUse use = addShaped(std::move(piece));
      opened(keys[face.below])->faces.push_back(use);
      use.turned = 1;
      opened(keys[face.above])->faces.push_back(use);
      continue;
    }
    FaceUse use = faces[face.source];
    if (pieces[face.source] > 1)
    {
      if (use.turned)
      {
        std::reverse(piece.nodes.begin(), piece.nodes.end());
      }
      use = addPiece(use, key, std::move(piece), owned[face.source]);
    }
    setCell(use, keys[face.below]);
    opened(keys[face.below])->faces.push_back(use);
  }
  for (const CellKey k : keys)
  {
    opened(k)->changed = true;
    opened(k)->place = measuredPlace(k);
  }
  parts.insert(parts.end(), keys.begin(), keys.end());
}

FaceUse CellComplex::addShaped(Shaped face)
{
  FaceUse use;
  use.face = (firstShaped() + static_cast<std::uint32_t>(shaped_.size())) & MostFaces;
  use.turned = 0;
  shaped_.push_back(std::move(face));
  return use;
}

// A piece of a divided face: the first takes its place, the others are added to the cell beyond.
FaceUse CellComplex::addPiece(FaceUse use, CellKey cell, Shaped piece, std::uint32_t& owned)
{
  if (owned == None)
  {
    owned = own(use.face, cell);
    shaped(owned).nodes = std::move(piece.nodes);
    use.face = owned & MostFaces;
    return use;
  }
  piece.cells = shaped(owned).cells;
  piece.boundary = shaped(owned).boundary;
  const CellKey other = piece.cells[use.turned ? 0 : 1];
  const bool turned = use.turned;
  use = addShaped(std::move(piece));
  if (other != None)
  {
    use.turned = turned ? 0 : 1;
    opened(other)->faces.push_back(use);
    opened(other)->changed = true;
  }
  use.turned = turned ? 1 : 0;
  return use;
}

// --- joining

void CellComplex::merge(CellKey small, CellKey into)
{
  changed_ = true;
  open(small);
  open(into);
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
  for (const FaceUse& use : from.faces)
  {
    if (!between(use, into))
    {
      faces.push_back(use);
    }
    else if (isShaped(use.face))
    {
      shaped(use.face).used = false;
    }
  }
  for (const FaceUse& use : from.faces)
  {
    setCell(use, into);
  }
  to.faces = std::move(faces);
  to.changed = true;
  from.faces.clear();
  from.alive = false;
  from.changed = true;
  to.place = measuredPlace(into);
}

bool CellComplex::hasFaceNear(CellKey key, std::vector<std::uint32_t> nodes) const
{
  std::sort(nodes.begin(), nodes.end());
  std::vector<CellKey> near{ key };
  const auto isListed = [&](CellKey k) { return k < cells_.size() || opened(k); };
  for (std::size_t ring = 0, begin = 0; ring < 2; ++ring)
  {
    const std::size_t end = near.size();
    for (; begin < end; ++begin)
    {
      forEachFace(near[begin], [&](const FaceUse& use) {
        const CellKey other = across(use);
        if (other != None && isListed(other) &&
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
      face.clear();
      forEachNodeOf(use, [&](std::uint32_t node) { face.push_back(node); });
      std::sort(face.begin(), face.end());
      found = found || face == nodes;
    });
  }
  return found;
}

void CellComplex::remove(CellKey key)
{
  changed_ = true;
  open(key);
  opened(key)->removed = true;
  opened(key)->changed = true;
}

std::int32_t CellComplex::boundaryOf(std::uint32_t face) const
{
  return isPatch(face) ? patches_.boundary[face]
                       : (isShaped(face) ? shaped(face).boundary : NoBoundary);
}

std::int32_t CellComplex::boundaryOfCell(CellKey key) const
{
  const OpenCell* cell = opened(key);
  return cell ? cell->boundary : cells_.cells[key].boundary;
}

void CellComplex::removeFace(CellKey key, std::uint32_t face)
{
  std::vector<FaceUse>& faces = opened(key)->faces;
  faces.erase(std::remove_if(
                faces.begin(), faces.end(), [&](const FaceUse& use) { return use.face == face; }),
    faces.end());
  opened(key)->changed = true;
}

void CellComplex::join(CellKey key, const CellView& view, const JoinedFaces& joined)
{
  for (const JoinedFaces::Group& group : joined.groups)
  {
    if (group.members.size() < 2)
    {
      continue;
    }
    changed_ = true;
    const std::uint32_t first = group.members.front();
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
    shaped(own(renamed(use.face), key)).nodes = std::move(nodes);
    opened(key)->changed = true;
    for (std::size_t i = 1; i < group.members.size(); ++i)
    {
      const std::uint32_t gone = renamed(view.faces[group.members[i]].face);
      removeFace(key, gone);
      if (view.across[first] != None)
      {
        open(view.across[first]);
        removeFace(view.across[first], gone);
      }
    }
  }
  if (opened(key))
  {
    opened(key)->place = measuredPlace(key);
  }
}

// --- writing back

void CellComplex::finish(Execution& execution)
{
  writeNodes();
  writeCells(promote(), execution);
}

void CellComplex::writeNodes()
{
  std::sort(vertices_.begin(), vertices_.end());
  nodes_.moreVertices = vertices_;
}

// Lists changed hexahedra among the polyhedral boxes; returns where each of the old list went.
std::vector<std::uint32_t> CellComplex::promote()
{
  std::vector<std::uint32_t> added;
  for (const OpenCell& cell : open_)
  {
    if (cell.origin >= cells_.size() && cell.changed && sides_.polyhedralOrdinal(cell.box) == None)
    {
      added.push_back(cell.box);
    }
  }
  std::sort(added.begin(), added.end());
  added.erase(std::unique(added.begin(), added.end()), added.end());
  const Sides old = sides_;
  std::vector<std::uint32_t> place(old.polyhedral.size());
  sides_.polyhedral.clear();
  sides_.patchBox.clear();
  sides_.ownStart.clear();
  sides_.boxStart.clear();
  std::size_t next = 0;
  const auto add = [&](std::size_t n, std::uint32_t box, std::uint32_t patchBox) {
    sides_.ordinal[box] = static_cast<std::uint32_t>(sides_.polyhedral.size());
    sides_.polyhedral.push_back(box);
    sides_.patchBox.push_back(patchBox);
    sides_.ownStart.push_back(old.ownStart[n]);
    sides_.boxStart.push_back(old.boxStart[n]);
  };
  for (std::size_t n = 0; n <= old.polyhedral.size(); ++n)
  {
    for (; next < added.size() && (n == old.polyhedral.size() || added[next] < old.polyhedral[n]);
         ++next)
    {
      add(n, added[next], None);
    }
    if (n < old.polyhedral.size())
    {
      place[n] = static_cast<std::uint32_t>(sides_.polyhedral.size());
      add(n, old.polyhedral[n], old.patchBox[n]);
    }
  }
  sides_.ownStart.push_back(old.ownStart.back());
  sides_.boxStart.push_back(old.boxStart.back());
  return place;
}

void CellComplex::writeCells(const std::vector<std::uint32_t>& place, Execution& execution)
{
  // What becomes of each cell: itself, then what it was cut into, in the order of cuts.
  std::unordered_map<CellKey, std::vector<std::uint32_t>> opensOf;
  for (std::uint32_t i = 0; i < open_.size(); ++i)
  {
    opensOf[open_[i].origin].push_back(i);
  }
  Cells result;
  result.folds = cells_.folds;
  result.voids = cells_.voids;
  result.flawed.assign(sides_.polyhedral.size(), 0);
  std::vector<std::uint32_t> oldOf(sides_.polyhedral.size(), None);
  for (std::size_t n = 0; n < place.size(); ++n)
  {
    oldOf[place[n]] = static_cast<std::uint32_t>(n);
    result.flawed[place[n]] = cells_.flawed[n];
  }
  Polyhedron polyhedron;
  CellShape measures;
  std::vector<std::uint32_t> newOf(open_.size(), None);
  const auto emitOpen = [&](std::uint32_t i) {
    const OpenCell& open = open_[i];
    if (!open.alive)
    {
      return;
    }
    newOf[i] = static_cast<std::uint32_t>(result.cells.size());
    Cell cell;
    cell.box = open.box;
    cell.boundary = open.boundary;
    cell.removed = open.removed;
    cell.sliver = open.removed && open.origin < cells_.size() && cells_.cells[open.origin].sliver;
    cell.firstFace = result.faces.size();
    polyhedron.clear();
    const Box& box = boxes_.boxes[open.box];
    for (const FaceUse& use : open.faces)
    {
      result.faces.push_back(refOf(use));
      forEachNodeOf(use, [&](std::uint32_t node) {
        polyhedron.addCorner(static_cast<std::uint32_t>(polyhedron.nodes.size()));
        polyhedron.nodes.push_back(minus(nodes_.at[node], box.low));
      });
      polyhedron.closeFace(false);
    }
    measure(polyhedron, measures);
    const Vector size = minus(box.high, box.low);
    cell.volumeFraction = measures.volume / (size[0] * size[1] * size[2]);
    result.cells.push_back(cell);
  };
  const auto emitOpens = [&](CellKey key) {
    const auto found = opensOf.find(key);
    if (found == opensOf.end())
    {
      return false;
    }
    std::for_each(found->second.begin(), found->second.end(), emitOpen);
    return true;
  };
  for (std::size_t n = 0; n < sides_.polyhedral.size(); ++n)
  {
    execution.poll();
    result.boxStart.push_back(result.cells.size());
    if (oldOf[n] == None)
    {
      emitOpens(keyOfHexahedron(sides_.polyhedral[n]));
      continue;
    }
    for (std::size_t c = cells_.boxStart[oldOf[n]]; c < cells_.boxStart[oldOf[n] + 1]; ++c)
    {
      const auto key = static_cast<CellKey>(c);
      if (openOf_[key] != None && emitOpens(key))
      {
        continue;
      }
      Cell cell = cells_.cells[c];
      cell.firstFace = result.faces.size();
      result.faces.insert(result.faces.end(),
        cells_.faces.begin() + static_cast<std::ptrdiff_t>(cells_.cells[c].firstFace),
        cells_.faces.begin() + static_cast<std::ptrdiff_t>(cells_.cells[c + 1].firstFace));
      result.cells.push_back(cell);
    }
  }
  result.boxStart.push_back(result.cells.size());
  Cell end{};
  end.firstFace = result.faces.size();
  result.cells.push_back(end);

  result.shaped.start.clear();
  for (const Shaped& face : shaped_)
  {
    result.shaped.start.push_back(result.shaped.nodes.size());
    result.shaped.nodes.insert(result.shaped.nodes.end(), face.nodes.begin(), face.nodes.end());
    result.shaped.cells.push_back({ None, None });
    result.shaped.boundary.push_back(face.boundary);
  }
  result.shaped.start.push_back(result.shaped.nodes.size());
  for (std::size_t c = 0; c < result.size(); ++c)
  {
    execution.poll();
    for (std::size_t f = result.cells[c].firstFace; f < result.cells[c + 1].firstFace; ++f)
    {
      const FaceRef& face = result.faces[f];
      if (face.kind() == FaceRef::Kind::Shaped || face.kind() == FaceRef::Kind::TurnedShaped)
      {
        result.shaped.cells[face.index][face.turned() ? 1 : 0] = static_cast<std::uint32_t>(c);
      }
    }
  }
  for (std::size_t f = 0; f < shaped_.size(); ++f)
  {
    for (std::size_t k = 0; k < 2; ++k)
    {
      const CellKey key = shaped_[f].cells[k];
      const bool hexahedron = key != None && key >= cells_.size() &&
        key < cells_.size() + boxes_.boxes.size() &&
        sides_.polyhedralOrdinal(static_cast<std::uint32_t>(key - cells_.size())) == None;
      if (hexahedron && result.shaped.cells[f][1 - k] != None)
      {
        result.shaped.cells[f][k] = ShapedFaces::SomeHexahedron;
      }
    }
  }
  findCellsOfInnerFaces(inner_, result, execution);
  cells_ = std::move(result);
}

}
