#include "Support/EditMeshes.h"

#include "Editing/EditMeasures.h"
#include "Editing/WallEdges.h"
#include "Editing/WallImprovement.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <set>

namespace cartesian
{

namespace
{

using Place = std::array<int, 3>;

// A rectangle across an axis, at one height of it.
struct Rectangle
{
  std::size_t axis;
  Place low;
  Place high;
  std::uint32_t below;
  std::uint32_t above;
  std::int32_t wall;

  Place corner(bool first, bool second) const
  {
    Place place = low;
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    place[u] = first ? high[u] : low[u];
    place[v] = second ? high[v] : low[v];
    return place;
  }

  // Counter-clockwise from the upper side.
  std::array<Place, 4> corners() const
  {
    return { corner(false, false), corner(true, false), corner(true, true), corner(false, true) };
  }
};

class MeshOfBoxes
{
public:
  MeshOfBoxes(const std::vector<TestBox>& boxes, const TestMeshSpec& spec)
    : boxes_(boxes)
    , spec_(spec)
  {
  }

  MeshEditor make() &&
  {
    for (std::uint32_t i = 0; i < boxes_.size(); ++i)
    {
      addCell(boxes_[i]);
      addSides(i);
    }
    addNodes();
    addFaces();
    mesh_.mesh().level = std::ldexp(1.0, -46);
    mesh_.connect();
    settleWalls(mesh_);
    return std::move(mesh_);
  }

private:
  void addCell(const TestBox& box)
  {
    EditCell cell;
    cell.region = box.region;
    cell.edge = box.high[0] - box.low[0];
    cell.boxVolume = cell.edge * cell.edge * cell.edge;
    cell.number = static_cast<std::uint32_t>(mesh_.cellCount());
    mesh_.addCell(cell);
  }

  void addSides(std::uint32_t i)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (const bool isUpper : { false, true })
      {
        addSide(i, axis, isUpper);
      }
    }
  }

  // Faces between two boxes are those of the lower one's upper side.
  void addSide(std::uint32_t i, std::size_t axis, bool isUpper)
  {
    const TestBox& box = boxes_[i];
    bool isCovered = false;
    for (std::uint32_t j = 0; j < boxes_.size(); ++j)
    {
      Rectangle shared{ axis, box.low, box.high, i, j, box.region != boxes_[j].region ? 6 : -1 };
      if (j == i || !clip(shared, box, boxes_[j], isUpper))
      {
        continue;
      }
      isCovered = true;
      if (isUpper)
      {
        rectangles_.push_back(shared);
      }
    }
    if (!isCovered)
    {
      Rectangle side{ axis, box.low, box.high, i, None,
        static_cast<std::int32_t>(2 * axis) + (isUpper ? 1 : 0) };
      (isUpper ? side.low : side.high)[axis] = (isUpper ? side.high : side.low)[axis];
      rectangles_.push_back(side);
    }
  }

  static bool clip(Rectangle& shared, const TestBox& box, const TestBox& other, bool isUpper)
  {
    const int height = isUpper ? box.high[shared.axis] : box.low[shared.axis];
    if ((isUpper ? other.low : other.high)[shared.axis] != height)
    {
      return false;
    }
    bool overlaps = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      shared.low[axis] = std::max(box.low[axis], other.low[axis]);
      shared.high[axis] = std::min(box.high[axis], other.high[axis]);
      overlaps = overlaps && (axis == shared.axis || shared.low[axis] < shared.high[axis]);
    }
    return overlaps;
  }

  void addNodes()
  {
    std::array<int, 3> low = boxes_[0].low;
    std::array<int, 3> high = boxes_[0].high;
    for (const TestBox& box : boxes_)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        low[axis] = std::min(low[axis], box.low[axis]);
        high[axis] = std::max(high[axis], box.high[axis]);
      }
    }
    for (const Rectangle& rectangle : rectangles_)
    {
      for (const Place& place : rectangle.corners())
      {
        nodes_[place] = None;
      }
    }
    for (auto& [place, number] : nodes_)
    {
      EditNode node;
      const Vector at{ double(place[0]), double(place[1]), double(place[2]) };
      node.at = spec_.place ? spec_.place(at) : at;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        if ((spec_.constrainedAxes >> axis & 1) != 0 &&
          (place[axis] == low[axis] || place[axis] == high[axis]))
        {
          node.constrainedAxes = static_cast<std::uint8_t>(node.constrainedAxes | 1U << axis);
          node.at[axis] = place[axis];
        }
      }
      node.number = static_cast<std::uint32_t>(mesh_.nodeCount());
      number = mesh_.addNode(node);
    }
  }

  void addFaces()
  {
    for (const Rectangle& rectangle : rectangles_)
    {
      std::vector<std::uint32_t> ring;
      const std::array<Place, 4> corners = rectangle.corners();
      for (std::size_t i = 0; i < 4; ++i)
      {
        addEdge(corners[i], corners[(i + 1) % 4], ring);
      }
      if (rectangle.wall >= 0 && rectangle.wall < 6 && rectangle.wall % 2 == 0)
      {
        std::reverse(ring.begin(), ring.end());
      }
      EditFace face;
      face.below = rectangle.below;
      face.above = rectangle.above;
      face.wall = rectangle.wall;
      mesh_.addFace(face, ring.data(), ring.size());
    }
  }

  // All nodes on it but the last.
  void addEdge(const Place& from, const Place& to, std::vector<std::uint32_t>& ring) const
  {
    for (Place place = from; place != to;)
    {
      if (const auto known = nodes_.find(place); known != nodes_.end())
      {
        ring.push_back(known->second);
      }
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        place[axis] += (place[axis] < to[axis] ? 1 : 0) - (place[axis] > to[axis] ? 1 : 0);
      }
    }
  }

  const std::vector<TestBox>& boxes_;
  const TestMeshSpec& spec_;
  std::vector<Rectangle> rectangles_;
  std::map<Place, std::uint32_t> nodes_;
  MeshEditor mesh_;
};

Vector meanOfCorners(const MeshView& mesh, std::uint32_t f)
{
  Vector mean{};
  for (const std::uint32_t n : mesh.cornersOf(f))
  {
    mean = plus(mean, mesh.node(n).at);
  }
  return scaled(mean, 1.0 / double(mesh.face(f).corners.size));
}

double volumeUnder(const MeshView& mesh, std::uint32_t f)
{
  const Vector mean = meanOfCorners(mesh, f);
  const std::size_t size = mesh.face(f).corners.size;
  double volume = 0;
  for (std::size_t i = 0; i < size; ++i)
  {
    volume += dot(mean, cross(mesh.corner(f, i), mesh.corner(f, (i + 1) % size)));
  }
  return volume / 6;
}

void classify(MeshEditor& mesh, std::uint32_t n)
{
  EditNode& node = mesh.rawNode(n);
  Vector normal{};
  for (const std::uint32_t f : mesh.facesAround(n))
  {
    normal = mesh.isWall(f) ? plus(normal, mesh.face(f).area) : normal;
  }
  const SharpEnds ends = sharpEndsAt(mesh, n);
  node.kind = NodeKind::Free;
  node.referencePosition = node.at;
  node.maxDisplacement = 0.2F;
  if (!node.atWall)
  {
    return;
  }
  node.kind = ends.empty() ? NodeKind::OnSurface
    : ends.size() == 2     ? NodeKind::OnEdge
                           : NodeKind::Corner;
  node.along =
    unit(ends.size() == 2 ? minus(mesh.node(ends[1]).at, mesh.node(ends[0]).at) : normal);
}

std::string at(const char* what, std::uint32_t i)
{
  return std::string(what) + " " + std::to_string(i);
}

bool areConnected(const MeshView& mesh, std::uint32_t c)
{
  std::map<std::set<std::uint32_t>, std::vector<std::uint32_t>> edges;
  for (const std::uint32_t f : mesh.facesOf(c))
  {
    const Items ring = mesh.cornersOf(f);
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      edges[{ ring[i], ring[(i + 1) % ring.size()] }].push_back(f);
    }
  }
  std::set<std::uint32_t> seen{ mesh.facesOf(c)[0] };
  for (std::size_t before = 0; before != seen.size();)
  {
    before = seen.size();
    for (const auto& [edge, faces] : edges)
    {
      if (std::any_of(
            faces.begin(), faces.end(), [&](std::uint32_t f) { return seen.count(f) != 0; }))
      {
        seen.insert(faces.begin(), faces.end());
      }
    }
  }
  return seen.size() == mesh.facesOf(c).size();
}

std::string faultOfCell(const MeshView& mesh, std::uint32_t c)
{
  const Items faces = mesh.facesOf(c);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const std::uint32_t f : faces)
  {
    if (mesh.face(f).gone || (mesh.face(f).below != c && mesh.face(f).above != c))
    {
      return at("a strange face in cell", c);
    }
    const Items ring = mesh.cornersOf(f);
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const std::uint32_t p = ring[i];
      const std::uint32_t q = ring[(i + 1) % ring.size()];
      edges.push_back(mesh.face(f).below == c ? std::make_pair(p, q) : std::make_pair(q, p));
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    const auto [p, q] = edges[i];
    if (p == q || (i > 0 && edges[i - 1] == edges[i]) ||
      !std::binary_search(edges.begin(), edges.end(), std::make_pair(q, p)))
    {
      return at("cell not closed:", c);
    }
  }
  return !areConnected(mesh, c)  ? at("cell of several shells:", c)
    : !(mesh.cell(c).volume > 0) ? at("no volume: cell", c)
                                 : "";
}

std::string faultOfFace(const MeshView& mesh, std::uint32_t f)
{
  const EditFace& face = mesh.face(f);
  for (const std::uint32_t c : { face.below, face.above })
  {
    if (c != None &&
      (mesh.cell(c).gone || std::count(mesh.facesOf(c).begin(), mesh.facesOf(c).end(), f) != 1))
    {
      return at("a cell does not know face", f);
    }
  }
  for (const std::uint32_t n : mesh.cornersOf(f))
  {
    if (mesh.node(n).gone ||
      std::count(mesh.facesAround(n).begin(), mesh.facesAround(n).end(), f) != 1)
    {
      return at("a node does not know face", f);
    }
    if (mesh.isWall(f) && !mesh.node(n).atWall)
    {
      return at("a node off the wall in face", f);
    }
  }
  const bool isBorder =
    face.above != None && mesh.cell(face.below).region != mesh.cell(face.above).region;
  if (face.below == face.above || (face.wall >= 0) != (mesh.isWall(f) || isBorder))
  {
    return at("no wall where it should be, or one inside: face", f);
  }
  return "";
}

std::string faultOfNode(const MeshView& mesh, std::uint32_t n)
{
  const Items faces = mesh.facesAround(n);
  for (const std::uint32_t f : faces)
  {
    const Items ring = mesh.cornersOf(f);
    if (mesh.face(f).gone || std::count(ring.begin(), ring.end(), n) != 1)
    {
      return at("a strange face at node", n);
    }
  }
  return mesh.node(n).gone != (faces.size() == 0) ? at("gone or not: node", n) : "";
}

std::string twinIn(const MeshView& mesh)
{
  std::set<std::vector<std::uint32_t>> known;
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
  {
    const Items ring = mesh.cornersOf(f);
    std::vector<std::uint32_t> corners(ring.begin(), ring.end());
    std::sort(corners.begin(), corners.end());
    if (!mesh.face(f).gone && !known.insert(corners).second)
    {
      return at("a twin of face", f);
    }
  }
  return "";
}

// --- comparison

// To the bit: zeroes have signs.
template <class T>
bool isSame(const T& a, const T& b)
{
  return std::memcmp(&a, &b, sizeof(T)) == 0; // NOLINT(bugprone-suspicious-memory-comparison)
}

template <class... Pairs>
bool areSame(const Pairs&... pairs)
{
  return (isSame(pairs.first, pairs.second) && ...);
}

template <class T>
std::pair<T, T> both(const T& a, const T& b)
{
  return { a, b };
}

bool isSameRecord(const EditNode& a, const EditNode& b)
{
  return areSame(both(a.at, b.at), both(a.along, b.along),
    both(a.referencePosition, b.referencePosition), both(a.maxDisplacement, b.maxDisplacement),
    both(a.accumulatedDeviation, b.accumulatedDeviation), both(a.number, b.number),
    both(a.kind, b.kind), both(a.constrainedAxes, b.constrainedAxes), both(a.atWall, b.atWall),
    both(a.gone, b.gone));
}

bool isSameRecord(const EditFace& a, const EditFace& b)
{
  return areSame(both(a.centre, b.centre), both(a.area, b.area), both(a.original, b.original),
    both(a.cost, b.cost), both(a.behind, b.behind), both(a.volumeDeficit, b.volumeDeficit),
    both(a.star, b.star), both(a.warp, b.warp),
    both(a.accumulatedDeviation, b.accumulatedDeviation), both(a.below, b.below),
    both(a.above, b.above), both(a.wall, b.wall), both(a.shaped, b.shaped), both(a.gone, b.gone),
    both(a.fails, b.fails), both(a.strains, b.strains));
}

bool isSameRecord(const EditCell& a, const EditCell& b)
{
  return areSame(both(a.centre, b.centre), both(a.volume, b.volume), both(a.boxVolume, b.boxVolume),
    both(a.edge, b.edge), both(a.cost, b.cost), both(a.number, b.number),
    both(a.boxIndex, b.boxIndex), both(a.wall, b.wall), both(a.region, b.region),
    both(a.state, b.state), both(a.gone, b.gone), both(a.strains, b.strains));
}

bool isSameList(const MeshView& mesh, const ItemList& a, const MeshView& other, const ItemList& b)
{
  const Items items = mesh.itemsOf(a);
  const Items others = other.itemsOf(b);
  return a.first == b.first && items.size() == others.size() &&
    std::equal(items.begin(), items.end(), others.begin());
}

// A record that only one of them has is of what was made, and is gone again.
template <class Record, class List>
std::string differenceIn(const MeshView& mesh, const RecordVector<Record>& all,
  const MeshView& other, const RecordVector<Record>& others, const char* what, List&& list)
{
  for (std::uint32_t i = 0; i < std::max(all.size(), others.size()); ++i)
  {
    if (i >= std::min(all.size(), others.size()))
    {
      if (!(i < all.size() ? all : others)[i].gone)
      {
        return at(what, i);
      }
    }
    else if (!isSameRecord(all[i], others[i]) ||
      !isSameList(mesh, list(all[i]), other, list(others[i])))
    {
      return at(what, i);
    }
  }
  return "";
}

}

std::vector<TestBox> blockOfBoxes(int x, int y, int z, int size)
{
  std::vector<TestBox> boxes;
  for (int i = 0; i < x; ++i)
  {
    for (int j = 0; j < y; ++j)
    {
      for (int k = 0; k < z; ++k)
      {
        boxes.push_back(
          { { size * i, size * j, size * k }, { size * (i + 1), size * (j + 1), size * (k + 1) } });
      }
    }
  }
  return boxes;
}

std::vector<TestBox> hangingBoxes()
{
  std::vector<TestBox> boxes{ { { 0, 0, 0 }, { 2, 2, 2 } } };
  for (const int y : { 0, 1 })
  {
    for (const int z : { 0, 1 })
    {
      boxes.push_back({ { 2, y, z }, { 3, y + 1, z + 1 } });
    }
  }
  return boxes;
}

std::vector<TestBox> ringOfBoxes()
{
  std::vector<TestBox> boxes;
  for (const auto& [x, y] : { std::pair{ 0, 0 }, { 0, 1 }, { 0, 2 }, { 1, 2 }, { 2, 2 }, { 3, 2 },
         { 3, 1 }, { 3, 0 }, { 2, 0 }, { 1, 0 } })
  {
    boxes.push_back({ { x, y, 0 }, { x + 1, y + 1, 1 } });
  }
  return boxes;
}

MeshEditor meshOfBoxes(const std::vector<TestBox>& boxes, const TestMeshSpec& spec)
{
  return MeshOfBoxes(boxes, spec).make();
}

MeshEditor copyOf(const MeshEditor& mesh)
{
  MeshEditor copy;
  copy.mesh() = mesh.mesh();
  copy.delta = mesh.delta;
  return copy;
}

void measureAgain(MeshEditor& mesh, const ObjectiveSpec& spec)
{
  Execution execution;
  measureAll(mesh.mesh(), execution);
  costAgain(mesh, spec);
}

void costAgain(MeshEditor& mesh, const ObjectiveSpec& spec)
{
  Execution execution;
  costAll(mesh.mesh(), spec, execution);
  mesh.delta = EditDelta();
}

WholeTask::WholeTask(MeshEditor& mesh)
  : WholeTask(mesh, {})
{
  cells_ = all_;
}

WholeTask::WholeTask(MeshEditor& mesh, std::vector<std::uint32_t> cells)
  : mesh_(mesh)
  , cells_(std::move(cells))
  , turns_(mesh.cellCount(), 0)
{
  for (std::uint32_t c = 0; c < mesh.cellCount(); ++c)
  {
    mesh.cell(c).gone ? void() : all_.push_back(c);
  }
}

void runLoop(MeshEditor& mesh, const LoopSpec& spec)
{
  improve(WholeTask(mesh).task(), spec, [] {});
}

void improveWhole(MeshEditor& mesh)
{
  Execution execution;
  improveWall(mesh, {}, execution);
}

void scaleBy(MeshEditor& mesh, double factor)
{
  mesh.mesh().level *= factor;
  for (std::uint32_t n = 0; n < mesh.nodeCount(); ++n)
  {
    mesh.rawNode(n).at = scaled(mesh.node(n).at, factor);
  }
  for (std::uint32_t c = 0; c < mesh.cellCount(); ++c)
  {
    mesh.rawCell(c).edge *= factor;
    mesh.rawCell(c).boxVolume *= factor * factor * factor;
  }
  settleWalls(mesh);
  for (std::uint32_t n = 0; n < mesh.nodeCount(); ++n)
  {
    mesh.rawNode(n).maxDisplacement *= static_cast<float>(factor);
  }
}

void settleWalls(MeshEditor& mesh)
{
  measureAgain(mesh);
  for (std::uint32_t n = 0; n < mesh.nodeCount(); ++n)
  {
    if (!mesh.node(n).gone)
    {
      classify(mesh, n);
    }
  }
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
  {
    EditFace& face = mesh.rawFace(f);
    face.original = mesh.isWall(f) ? face.area : Vector{};
  }
  costAgain(mesh, ObjectiveSpec());
}

MeshEditor wedge()
{
  MeshEditor mesh = meshOfBoxes(blockOfBoxes(1, 1, 1));
  for (const double y : { 0.0, 1.0 })
  {
    const Vector to{ 0, y, 0 };
    collapseEdge(mesh, nodeAt(mesh, { 0, y, 1 }), nodeAt(mesh, to), to);
  }
  mesh.commit();
  settleWalls(mesh);
  return mesh;
}

MeshEditor dentedCell(double depth)
{
  MeshEditor mesh = meshOfBoxes(blockOfBoxes(2, 1, 1), { [&](const Vector& p) {
    return Vector{ p[0], p[1], p[0] == 1 && p[2] == 1 ? 1 - depth : p[2] };
  } });
  mergeCells(mesh, 0, 1);
  mesh.commit();
  settleWalls(mesh);
  return mesh;
}

MeshEditor cellOfBoxes(const std::vector<TestBox>& boxes)
{
  MeshEditor mesh = meshOfBoxes(boxes);
  for (bool isAny = true; isAny;)
  {
    isAny = false;
    for (std::uint32_t c = 1; c < mesh.cellCount(); ++c)
    {
      isAny =
        (!mesh.cell(c).gone && faceBetween(mesh, 0, c) != None && mergeCells(mesh, 0, c)) || isAny;
    }
  }
  mesh.commit();
  settleWalls(mesh);
  return mesh;
}

MeshEditor randomMesh(std::mt19937& random, double moved)
{
  const auto lessThan = [&](
                          int most) { return std::uniform_int_distribution<int>(0, most)(random); };
  const std::vector<TestBox> whole =
    blockOfBoxes(1 + lessThan(2), 1 + lessThan(2), 1 + lessThan(2), 2);
  const bool hasRegions = lessThan(3) == 0;
  std::vector<TestBox> boxes;
  for (TestBox box : whole)
  {
    box.region = hasRegions && box.low[0] >= 2 ? 1 : 0;
    if (lessThan(5) != 0)
    {
      boxes.push_back(box);
      continue;
    }
    for (const TestBox& part : blockOfBoxes(2, 2, 2))
    {
      TestBox moving = part;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        moving.low[axis] += box.low[axis];
        moving.high[axis] += box.low[axis];
      }
      moving.region = box.region;
      boxes.push_back(moving);
    }
  }
  TestMeshSpec spec;
  spec.constrainedAxes = static_cast<std::uint8_t>(lessThan(3) == 0 ? 1 << lessThan(2) : 0);
  std::uniform_real_distribution<double> by(-moved, moved);
  spec.place = [&](const Vector& p) {
    Vector at = p;
    for (double& x : at)
    {
      x += std::round(by(random) * 1024) / 1024;
    }
    return at;
  };
  return meshOfBoxes(boxes, spec);
}

std::uint32_t nodeAt(const MeshView& mesh, const Vector& place)
{
  for (std::uint32_t n = 0; n < mesh.nodeCount(); ++n)
  {
    if (!mesh.node(n).gone && mesh.node(n).at == place)
    {
      return n;
    }
  }
  return None;
}

std::uint32_t wallOf(const MeshView& mesh, std::uint32_t cell, std::int32_t wall)
{
  const Items faces = mesh.facesOf(cell);
  const std::uint32_t* found = std::find_if(faces.begin(), faces.end(),
    [&](std::uint32_t f) { return mesh.isWall(f) && mesh.face(f).wall == wall; });
  return found == faces.end() ? None : *found;
}

std::uint32_t faceBetween(const MeshView& mesh, std::uint32_t a, std::uint32_t b)
{
  const Items faces = mesh.facesOf(a);
  const std::uint32_t* found = std::find_if(
    faces.begin(), faces.end(), [&](std::uint32_t f) { return mesh.beyond(f, a) == b; });
  return found == faces.end() ? None : *found;
}

std::size_t countCells(const MeshView& mesh)
{
  std::size_t count = 0;
  for (std::uint32_t c = 0; c < mesh.cellCount(); ++c)
  {
    count += mesh.cell(c).gone ? 0 : 1;
  }
  return count;
}

std::size_t countFaces(const MeshView& mesh)
{
  std::size_t count = 0;
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
  {
    count += mesh.face(f).gone ? 0 : 1;
  }
  return count;
}

double volumeOf(const MeshView& mesh, std::uint32_t cell)
{
  double volume = 0;
  for (const std::uint32_t f : mesh.facesOf(cell))
  {
    volume += volumeUnder(mesh, f) * (mesh.face(f).below == cell ? 1 : -1);
  }
  return volume;
}

double volumeOf(const MeshView& mesh)
{
  double volume = 0;
  for (std::uint32_t c = 0; c < mesh.cellCount(); ++c)
  {
    volume += mesh.cell(c).gone ? 0 : volumeOf(mesh, c);
  }
  return volume;
}

double volumeBehindWalls(const MeshView& mesh)
{
  double volume = 0;
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
  {
    volume += !mesh.face(f).gone && mesh.isWall(f) ? mesh.face(f).behind : 0;
  }
  return volume;
}

double sumOfDeficits(const MeshView& mesh)
{
  double sum = 0;
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
  {
    sum += !mesh.face(f).gone && mesh.isWall(f) ? mesh.signOf(f) * mesh.face(f).volumeDeficit : 0;
  }
  return sum;
}

double sumOfCosts(const MeshView& mesh)
{
  double sum = 0;
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
  {
    sum += mesh.face(f).gone ? 0 : mesh.face(f).cost;
  }
  for (std::uint32_t c = 0; c < mesh.cellCount(); ++c)
  {
    sum += mesh.cell(c).gone ? 0 : mesh.cell(c).cost;
  }
  return sum;
}

std::string faultOf(const MeshEditor& mesh)
{
  std::string fault;
  for (std::uint32_t f = 0; f < mesh.faceCount() && fault.empty(); ++f)
  {
    fault = mesh.face(f).gone ? "" : faultOfFace(mesh, f);
  }
  for (std::uint32_t n = 0; n < mesh.nodeCount() && fault.empty(); ++n)
  {
    fault = faultOfNode(mesh, n);
  }
  for (std::uint32_t c = 0; c < mesh.cellCount() && fault.empty(); ++c)
  {
    fault = mesh.cell(c).gone ? "" : faultOfCell(mesh, c);
  }
  return fault.empty() ? twinIn(mesh) : fault;
}

std::string differenceOf(const MeshEditor& mesh, const MeshEditor& other)
{
  const EditMesh& one = mesh.mesh();
  const EditMesh& two = other.mesh();
  const auto facesOf = [](const auto& record) { return record.faces; };
  const auto cornersOf = [](const EditFace& face) { return face.corners; };
  for (const std::string& difference :
    { differenceIn(mesh, one.nodes, other, two.nodes, "node", facesOf),
      differenceIn(mesh, one.faces, other, two.faces, "face", cornersOf),
      differenceIn(mesh, one.cells, other, two.cells, "cell", facesOf) })
  {
    if (!difference.empty())
    {
      return difference;
    }
  }
  const EditDelta& a = mesh.delta;
  const EditDelta& b = other.delta;
  return areSame(both(a.cost, b.cost), both(a.volume, b.volume), both(a.fidelity, b.fidelity),
           both(a.failures, b.failures), both(a.strains, b.strains))
    ? ""
    : "delta";
}

}
