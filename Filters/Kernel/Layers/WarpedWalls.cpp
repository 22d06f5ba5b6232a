// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/WarpedWalls.h"

#include "Base/Rings.h"
#include "Layers/BoxSides.h"
#include "Layers/FaceDivision.h"
#include "Polyhedra/CellGeometry.h"

#include <algorithm>
#include <unordered_set>

namespace cartesian
{

namespace
{

// How far a face's centre may lie off the mean of its corners, by the height of the first layer.
constexpr double MostOff = 0.1;

// How far its corners may lie off its plane, by the height of all layers.
constexpr double MostWarp = 0.3;

class WallDivider
{
public:
  WallDivider(const Boxes& boxes, const Nodes& nodes, const Walls& walls,
    const WallLayerSpec& layers, WallMesh& mesh)
    : boxes_(boxes)
    , nodes_(nodes)
    , walls_(walls)
    , layers_(layers)
    , sides_(boxes)
    , firstPart_(heightsOfLayers(layers)[1])
    , mesh_(mesh)
    , parts_(mesh.faces.size(), { 0, 0 })
  {
  }

  void run()
  {
    const auto count = static_cast<std::uint32_t>(mesh_.faces.size());
    listEdges();
    bool any = false;
    for (std::uint32_t f = 0; f < count; ++f)
    {
      any = divide(f) || any;
    }
    if (any)
    {
      listUses();
    }
  }

private:
  // Whether a cell of the wall mesh has the face on that side.
  bool isSeenFrom(std::uint32_t f, std::size_t side) const
  {
    const CellKey cell = mesh_.faces.cells[f][side];
    return cell < FirstHexahedron && !mesh_.cells[cell].removed;
  }

  // That of the face; or, where a removed cell exposes it, of that cell. Others have none.
  std::int32_t wallOf(std::uint32_t f, std::size_t side) const
  {
    const CellKey other = mesh_.faces.cells[f][1 - side];
    return mesh_.isRemoved(other) ? mesh_.cells[other].boundary : mesh_.faces.boundary[f];
  }

  // The height of all layers on a face of a cell, in levels: the lower one of both sides; 0: none.
  double heightOn(std::int32_t wall, CellKey cell) const
  {
    const double step = boxes_.lattice.step();
    const double usual =
      totalThickness(layers_, sides_.shortestSide(boxes_.box(mesh_.cells[cell].box)) * step);
    const double behind =
      layers_.isIn(walls_.behind(wall)) ? layers_.thicknessAt(walls_.boundary(wall), usual) : 0;
    const double front = walls_.isInterface(wall) && layers_.isIn(walls_.front(wall))
      ? layers_.thicknessAt(walls_.boundaryInFront(wall), usual)
      : 0;
    return (behind > 0 && front > 0 ? std::min(behind, front) : std::max(behind, front)) / step;
  }

  bool divide(std::uint32_t f)
  {
    WallFaces& faces = mesh_.faces;
    const std::size_t side = isSeenFrom(f, 0) ? 0 : 1;
    if (faces.start[f + 1] - faces.start[f] <= 3 || !isSeenFrom(f, side) ||
      wallOf(f, side) == NoBoundary)
    {
      return false;
    }
    const CellKey cell = faces.cells[f][side];
    const double height = heightOn(wallOf(f, side), cell);
    if (height <= 0)
    {
      return false;
    }
    const FaceUse use(f, side == 1); // as the cell has it
    findCorners(use);
    barEdges();
    const std::vector<FaceDivision::Part>& parts = division_.divide(
      corners_, centreOf(cell), { MostOff * firstPart_ * height, MostWarp * height }, barred_);
    if (parts.size() == 1)
    {
      return false;
    }
    forEachDiagonal(parts, [&](std::uint64_t key) { diagonals_.insert(key); });
    replace(use, parts);
    return true;
  }

  static std::uint64_t keyOf(std::uint32_t p, std::uint32_t q)
  {
    return (static_cast<std::uint64_t>(std::min(p, q)) << 32) | std::max(p, q);
  }

  // Of all faces that cells have.
  void listEdges()
  {
    const WallFaces& faces = mesh_.faces;
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      const bool isThere = faces.cells[f][0] != None || faces.cells[f][1] != None;
      const std::size_t end = faces.start[f + 1];
      for (std::size_t i = faces.start[f]; isThere && i < end; ++i)
      {
        edges_.push_back(
          keyOf(faces.corners[i], faces.corners[i + 1 < end ? i + 1 : faces.start[f]]));
      }
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  }

  // No diagonal may be an edge of other faces: more than two would meet there, or two be the same.
  void barEdges()
  {
    barred_.clear();
    for (std::uint32_t i = 0; i < ring_.size(); ++i)
    {
      for (std::uint32_t k = i + 2; k < ring_.size(); ++k)
      {
        const std::uint64_t key = keyOf(ring_[i], ring_[k]);
        const bool isSide = i == 0 && k + 1 == ring_.size();
        if (!isSide &&
          (std::binary_search(edges_.begin(), edges_.end(), key) || diagonals_.count(key) != 0))
        {
          barred_.push_back({ i, k });
        }
      }
    }
  }

  template <class Visitor>
  void forEachDiagonal(const std::vector<FaceDivision::Part>& parts, Visitor&& visit) const
  {
    for (const FaceDivision::Part& part : parts)
    {
      for (std::size_t i = 0; i < part.size(); ++i)
      {
        const std::uint32_t from = part[i];
        const std::uint32_t to = following(part, i);
        if (to != (from + 1) % ring_.size())
        {
          visit(keyOf(ring_[from], ring_[to]));
        }
      }
    }
  }

  // From the first of its nodes.
  void findCorners(const FaceUse& use)
  {
    ring_.clear();
    mesh_.faces.forEachNode(use, [&](std::uint32_t node) { ring_.push_back(node); });
    base_ = nodes_.at[ring_[0]];
    corners_.clear();
    for (const std::uint32_t node : ring_)
    {
      corners_.push_back(minus(nodes_.at[node], base_));
    }
  }

  // From there, too.
  Vector centreOf(CellKey cell)
  {
    ofCell_.clear();
    std::vector<Vector> places;
    mesh_.forEachUse(cell, [&](const FaceUse& use) {
      places.clear();
      mesh_.faces.forEachNode(
        use, [&](std::uint32_t node) { places.push_back(minus(nodes_.at[node], base_)); });
      ofCell_.push_back(
        measureFace(places.size(), [&](std::size_t i) -> const Vector& { return places[i]; }));
    });
    return measureCell(ofCell_.size(), [&](std::size_t i) -> const FaceGeometry& {
      return ofCell_[i];
    }).centre;
  }

  // The face stays in the list, without cells.
  void replace(const FaceUse& use, const std::vector<FaceDivision::Part>& parts)
  {
    WallFaces& faces = mesh_.faces;
    const std::array<CellKey, 2> cells = faces.cells[use.face];
    parts_[use.face][0] = static_cast<std::uint32_t>(faces.size());
    for (const FaceDivision::Part& part : parts)
    {
      const auto first = static_cast<std::ptrdiff_t>(faces.corners.size());
      for (const std::uint32_t corner : part)
      {
        faces.corners.push_back(ring_[corner]);
      }
      if (use.turned)
      {
        std::reverse(faces.corners.begin() + first, faces.corners.end());
      }
      faces.add(cells, faces.boundary[use.face]);
    }
    parts_[use.face][1] = static_cast<std::uint32_t>(faces.size());
    faces.cells[use.face] = { None, None };
  }

  // Of the cells, with the parts of divided faces.
  void listUses()
  {
    std::vector<FaceUse> uses;
    uses.reserve(mesh_.uses.size());
    for (std::size_t c = 0; c < mesh_.cells.size(); ++c)
    {
      const std::size_t first = mesh_.cells[c].firstUse;
      const std::size_t end = c + 1 < mesh_.cells.size() ? mesh_.cells[c + 1].firstUse : first;
      mesh_.cells[c].firstUse = uses.size();
      for (std::size_t u = first; u < end; ++u)
      {
        const FaceUse use = mesh_.uses[u];
        const auto [part, last] = parts_[use.face];
        if (part == last)
        {
          uses.push_back(use);
        }
        for (std::uint32_t p = part; p < last; ++p)
        {
          uses.emplace_back(p, use.turned != 0);
        }
      }
    }
    mesh_.uses.swap(uses);
  }

  const Boxes& boxes_;
  const Nodes& nodes_;
  const Walls& walls_;
  const WallLayerSpec& layers_;
  const BoxSides sides_;
  const double firstPart_; // of all layers, the first one's height
  WallMesh& mesh_;
  std::vector<std::array<std::uint32_t, 2>> parts_; // of each face that there was, begin and end
  FaceDivision division_;
  std::vector<std::uint64_t> edges_; // sorted
  std::unordered_set<std::uint64_t> diagonals_;
  std::vector<std::uint32_t> ring_; // of the face that is looked at
  Point base_{};
  std::vector<Vector> corners_;
  std::vector<FaceDivision::Diagonal> barred_;
  std::vector<FaceGeometry> ofCell_;
};

}

void divideWarpedWalls(const Boxes& boxes, const Nodes& nodes, const Walls& walls,
  const WallLayerSpec& layers, WallMesh& mesh)
{
  if (layers.count > 0)
  {
    WallDivider(boxes, nodes, walls, layers, mesh).run();
  }
}

}
