// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/EditMeasures.h"

#include "Editing/FixedList.h"

namespace cartesian
{

namespace
{

// Calls visit(mesh, i) for i < count; chunks have an editor each.
template <class Visitor>
void forEachRecord(EditMesh& whole, std::size_t count, Execution& execution, Visitor&& visit)
{
  constexpr std::size_t RecordsAChunk = 1024;
  execution.forEach(count, RecordsAChunk, [&](std::size_t begin, std::size_t end) {
    MeshEditor mesh(whole, 0, 0, {});
    for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i)
    {
      visit(mesh, i);
    }
  });
}

// A wall costs what it costs its cell; between two regions, both: each side is a wall.
template <class Number, class CellOf, class Corner>
Cost<Number> costBetween(const MeshView& mesh, std::uint32_t f, const ObjectiveSpec& spec,
  const FaceMeasures<Number>& measures, CellOf&& cellOf, Corner&& corner)
{
  const EditFace& face = mesh.face(f);
  const std::size_t size = face.corners.size;
  FaceCost<Number> cost(measures, spec);
  if (!mesh.isSurface(f))
  {
    cost.addInner(cellOf(face.below), cellOf(face.above), size, corner);
    return cost.cost();
  }
  cost.addWall(cellOf(face.below), mesh.cell(face.below).edge, face.original, size, corner);
  if (mesh.hasLayers(face.wall))
  {
    cost.addLayers(mesh.cell(face.below).edge, size, corner);
  }
  if (mesh.isWall(f))
  {
    return cost.cost();
  }
  FaceMeasures<Number> reversed = measures;
  reversed.area = scaled(measures.area, -1.0);
  FaceCost<Number> back(reversed, spec);
  back.addWall(
    cellOf(face.above), mesh.cell(face.above).edge, scaled(face.original, -1), size, corner);
  const Cost<Number> one = cost.cost();
  const Cost<Number> other = back.cost();
  return { one.value + other.value, std::max(one.fails, other.fails), one.strains || other.strains,
    one.inverted + other.inverted, one.skew || other.skew };
}

// The faces of a cell that do not change: what they add to its sums, and how that changes with the mean.
class HeldFaces
{
public:
  explicit HeldFaces(const Vector& mean)
    : mean_(mean)
  {
  }

  void add(const Vector& centre, const Vector& area)
  {
    const Vector height = minus(centre, mean_);
    const double product = dot(area, height);
    sum_ += product;
    area_ = plus(area_, area);
    for (std::size_t k = 0; k < 3; ++k)
    {
      moment_[k] += height[k] * product;
      tensor_[k] = plus(tensor_[k], scaled(area, height[k]));
    }
  }

  void addTo(const GradientVector& mean, WithGradient& sum, GradientVector& moment) const
  {
    sum.value += sum_;
    for (std::size_t k = 0; k < 3; ++k)
    {
      sum.slope = minus(sum.slope, scaled(mean[k].slope, area_[k]));
      moment[k].value += moment_[k];
      moment[k].slope = minus(moment[k].slope, scaled(mean[k].slope, sum_));
      for (std::size_t l = 0; l < 3; ++l)
      {
        moment[k].slope = minus(moment[k].slope, scaled(mean[l].slope, tensor_[k][l]));
      }
    }
  }

private:
  Vector mean_;
  double sum_ = 0;
  Vector area_{};
  Vector moment_{};
  std::array<Vector, 3> tensor_{}; // heights by areas
};

// Of the measures around one node, with their gradients by its place.
class GradientOfNode
{
public:
  GradientOfNode(const MeshView& mesh, std::uint32_t node, const ObjectiveSpec& spec)
    : mesh_(mesh)
    , node_(node)
    , spec_(spec)
  {
  }

  // The sum of what costs of the faces of all cells that have the node, and of these cells; of those that cost `least`.
  Vector sum(double least)
  {
    if (!listCells() || !collect(least))
    {
      return {};
    }
    for (const std::uint32_t f : mesh_.facesAround(node_))
    {
      if (!faces_.add({ f, measuresOf(f) }))
      {
        return {};
      }
    }
    for (auto& [c, measures] : cells_)
    {
      measures = measuresOfCell(c);
      if (mesh_.cell(c).cost > least)
      {
        addCostOfCell(c, measures);
      }
    }
    for (const std::uint32_t f : costly_)
    {
      addCostOfFace(f);
    }
    return sum_;
  }

private:
  using Face = FaceMeasures<WithGradient>;
  using Cell = CellGeometryOf<WithGradient>;

  template <class List>
  static auto find(const List& list, std::uint32_t i) -> const decltype(list[0].second)*
  {
    for (const auto& entry : list)
    {
      if (entry.first == i)
      {
        return &entry.second;
      }
    }
    return nullptr;
  }

  // False: there are too many.
  bool listCells()
  {
    const Items faces = mesh_.facesAround(node_);
    for (const std::uint32_t f : faces)
    {
      for (const std::uint32_t c : { mesh_.face(f).below, mesh_.face(f).above })
      {
        if (c != None && !find(cells_, c) && !cells_.add({ c, {} }))
        {
          return false;
        }
      }
    }
    return faces.size() <= MostFaces;
  }

  // False: there is nothing that costs so much.
  bool collect(double least)
  {
    bool isAny = false;
    for (const auto& [c, measures] : cells_)
    {
      isAny = isAny || mesh_.cell(c).cost > least;
      for (const std::uint32_t f : mesh_.facesOf(c))
      {
        const std::uint32_t other = mesh_.beyond(f, c);
        const bool isCounted = other != None && other < c && find(cells_, other);
        if (!isCounted && mesh_.face(f).cost > least)
        {
          isAny = costly_.add(f) || isAny;
        }
      }
    }
    return isAny;
  }

  static GradientVector constant(const Vector& v) { return { v[0], v[1], v[2] }; }

  GradientVector corner(std::uint32_t f, std::size_t i) const
  {
    const std::uint32_t n = mesh_.cornersOf(f)[i];
    GradientVector at = constant(mesh_.node(n).at);
    for (std::size_t axis = 0; n == node_ && axis < 3; ++axis)
    {
      at[axis].slope[axis] = 1;
    }
    return at;
  }

  Face measuresOf(std::uint32_t f) const
  {
    return measuresOfFace(mesh_.face(f).corners.size, [&](std::size_t i) { return corner(f, i); });
  }

  Face measuresHeld(std::uint32_t f) const
  {
    const Face* known = find(faces_, f);
    const EditFace& face = mesh_.face(f);
    return known ? *known
                 : Face{ constant(face.centre), constant(face.area), WithGradient(face.star),
                     WithGradient(face.warp) };
  }

  Cell measuresOfCell(std::uint32_t c) const
  {
    if (mesh_.isGhost(c))
    {
      return { constant(mesh_.cell(c).centre), WithGradient(mesh_.cell(c).volume) };
    }
    return measuresOf(c, mesh_.facesOf(c));
  }

  // As measureCell of CellGeometry.h. Faces that do not change are summed as numbers: of them only the mean moves.
  Cell measuresOf(std::uint32_t c, Items faces) const
  {
    GradientVector mean{};
    for (const std::uint32_t f : faces)
    {
      const Face* face = find(faces_, f);
      mean = face ? plus(mean, face->centre) : plus(mean, constant(mesh_.face(f).centre));
    }
    mean = scaled(mean, 1.0 / double(faces.size()));
    WithGradient sum; // of products
    GradientVector moment{};
    HeldFaces held(valuesOf(mean));
    for (const std::uint32_t f : faces)
    {
      const double sign = mesh_.face(f).below == c ? 1 : -1;
      if (const Face* face = find(faces_, f))
      {
        const GradientVector height = minus(face->centre, mean);
        const WithGradient product = dot(face->area, height) * sign;
        sum += product;
        moment = plus(moment, scaled(height, product));
      }
      else
      {
        held.add(mesh_.face(f).centre, scaled(mesh_.face(f).area, sign));
      }
    }
    held.addTo(mean, sum, moment);
    const WithGradient volume = sum * (1.0 / 3);
    return { plus(mean, scaled(moment, WithGradient(0.25) / volume)), volume };
  }

  void addCostOfCell(std::uint32_t c, const Cell& measures)
  {
    if (mesh_.isGhost(c))
    {
      return;
    }
    DeterminantOfCell<WithGradient> determinant;
    for (const std::uint32_t f : mesh_.facesOf(c))
    {
      if (!mesh_.isSurface(f))
      {
        determinant.add(measuresHeld(f).area);
      }
    }
    sum_ = plus(sum_,
      cartesian::costOfCell(
        measures.volume * (1 / mesh_.cell(c).boxVolume), mesh_.wantedShare(), determinant.value())
        .value.slope);
  }

  void addCostOfFace(std::uint32_t f)
  {
    const Face measures = measuresHeld(f);
    const Cost<WithGradient> cost = costBetween(
      mesh_, f, spec_, measures, [&](std::uint32_t c) { return cellHeld(c); },
      [&](std::size_t i) { return corner(f, i); });
    sum_ = plus(sum_, cost.value.slope);
  }

  Cell cellHeld(std::uint32_t c) const
  {
    const Cell* known = find(cells_, c);
    const EditCell& cell = mesh_.cell(c);
    return known ? *known : Cell{ constant(cell.centre), WithGradient(cell.volume) };
  }

  static constexpr std::size_t MostFaces = 96;
  static constexpr std::size_t MostCells = 64;

  const MeshView& mesh_;
  std::uint32_t node_;
  const ObjectiveSpec& spec_;
  FixedList<std::pair<std::uint32_t, Face>, MostFaces> faces_;
  FixedList<std::pair<std::uint32_t, Cell>, MostCells> cells_;
  FixedList<std::uint32_t, 512> costly_; // faces
  Vector sum_{};
};

}

void measureFace(MeshEditor& mesh, std::uint32_t f)
{
  EditFace& face = mesh.rawFace(f);
  const auto corner = [&](std::size_t i) -> const Vector& { return mesh.corner(f, i); };
  const FaceMeasures<double> measures = measuresOfFace(face.corners.size, corner);
  face.centre = measures.centre;
  face.area = measures.area;
  face.star = static_cast<float>(measures.star);
  face.warp = static_cast<float>(measures.warp);
  if (mesh.isSurface(f))
  {
    const double behind = measureCone(face.corners.size, corner).volume;
    (mesh.isWall(f) ? mesh.delta.volume : mesh.delta.interRegionVolume) +=
      mesh.signOf(f) * (behind - face.behind);
    face.behind = behind;
  }
}

void measureCell(MeshEditor& mesh, std::uint32_t c)
{
  const Items faces = mesh.facesOf(c);
  const CellGeometry measures = measureCell(faces.size(), [&](std::size_t i) -> FaceGeometry {
    const EditFace& face = mesh.face(faces[i]);
    return { face.centre, face.below == c ? face.area : scaled(face.area, -1) };
  });
  EditCell& cell = mesh.rawCell(c);
  cell.centre = measures.centre;
  cell.volume = measures.volume;
}

Cost<double> costOfFace(const MeshView& mesh, std::uint32_t f, const ObjectiveSpec& spec)
{
  const EditFace& face = mesh.face(f);
  const FaceMeasures<double> measures{ face.centre, face.area, face.star, face.warp };
  return costBetween(
    mesh, f, spec, measures,
    [&](std::uint32_t c) {
      return CellGeometry{ mesh.cell(c).centre, mesh.cell(c).volume };
    },
    [&](std::size_t i) -> const Vector& { return mesh.corner(f, i); });
}

double costBy(
  const MeshView& mesh, std::uint32_t f, const ObjectiveSpec& to, const ObjectiveSpec& from)
{
  const EditFace& face = mesh.face(f);
  return mesh.isSurface(f) && !mesh.isWall(f) ? costOfFace(mesh, f, to).value
                                              : costBy(to, from, face.cost, face.fails);
}

Cost<double> costOfCell(const MeshView& mesh, std::uint32_t c)
{
  DeterminantOfCell<double> determinant;
  for (const std::uint32_t f : mesh.facesOf(c))
  {
    if (!mesh.isSurface(f))
    {
      determinant.add(mesh.face(f).area);
    }
  }
  return costOfCell(shareOf(mesh, c), mesh.wantedShare(), determinant.value());
}

double shareOf(const MeshView& mesh, std::uint32_t c)
{
  return mesh.cell(c).volume / mesh.cell(c).boxVolume;
}

void setCostOfCell(MeshEditor& mesh, std::uint32_t c)
{
  const Cost<double> cost = costOfCell(mesh, c);
  EditCell& cell = mesh.rawCell(c);
  cell.cost = cost.value;
  cell.strains = cost.strains;
}

void setCostOfFace(MeshEditor& mesh, std::uint32_t f, const ObjectiveSpec& spec)
{
  setCost(mesh.rawFace(f), costOfFace(mesh, f, spec));
}

void setCost(EditFace& face, const Cost<double>& cost)
{
  face.cost = cost.value;
  face.fails = static_cast<std::uint8_t>(cost.fails);
  face.strains = cost.strains;
  face.inverted = static_cast<std::uint8_t>(cost.inverted);
  face.skew = cost.skew;
}

void measureAll(EditMesh& whole, Execution& execution)
{
  forEachRecord(whole, whole.faces.size(), execution, [](MeshEditor& mesh, std::uint32_t f) {
    if (!mesh.face(f).gone)
    {
      measureFace(mesh, f);
    }
  });
  forEachRecord(whole, whole.cells.size(), execution, [](MeshEditor& mesh, std::uint32_t c) {
    if (!mesh.cell(c).gone && !mesh.isGhost(c))
    {
      measureCell(mesh, c);
    }
  });
}

void costAll(EditMesh& whole, const ObjectiveSpec& spec, Execution& execution)
{
  forEachRecord(whole, whole.cells.size(), execution, [](MeshEditor& mesh, std::uint32_t c) {
    if (mesh.isFree(c))
    {
      setCostOfCell(mesh, c);
    }
  });
  forEachRecord(whole, whole.faces.size(), execution, [&](MeshEditor& mesh, std::uint32_t f) {
    if (!mesh.face(f).gone)
    {
      setCostOfFace(mesh, f, spec);
    }
  });
}

bool isThinThere(const MeshView& mesh, std::uint32_t c)
{
  constexpr double LeastOfHost = 0.15; // of its box
  constexpr double MostToHosts = 0.6;  // of its area inside: more is a layer on larger cells
  double area = 0;
  double toHosts = 0;
  for (const std::uint32_t f : mesh.facesOf(c))
  {
    if (!mesh.isSurface(f))
    {
      const EditCell& other = mesh.cell(mesh.beyond(f, c));
      const double part = norm(mesh.face(f).area);
      area += part;
      toHosts += other.volume >= LeastOfHost * other.boxVolume ? part : 0;
    }
  }
  return toHosts <= MostToHosts * area;
}

bool isBridge(const MeshView& mesh, std::uint32_t c)
{
  using Cells = FixedList<std::uint32_t, 256>;
  Cells beside;
  bool fits = true;
  const auto addNeighbours = [&](std::uint32_t of, Cells& to) {
    for (const std::uint32_t f : mesh.facesOf(of))
    {
      const std::uint32_t other = mesh.beyond(f, of);
      if (other != None && other != c && !mesh.isSurface(f) && !to.contains(other))
      {
        fits = to.add(other) && fits;
      }
    }
  };
  addNeighbours(c, beside);
  if (beside.size() < 2)
  {
    return false;
  }
  Cells reached; // from the first
  reached.push(beside[0]);
  for (std::size_t i = 0; i < reached.size() && fits; ++i)
  {
    Cells next;
    addNeighbours(reached[i], next);
    for (const std::uint32_t other : next)
    {
      Cells around; // only through what has a face of them
      addNeighbours(other, around);
      const bool isNear = beside.contains(other) ||
        std::any_of(
          around.begin(), around.end(), [&](std::uint32_t cell) { return beside.contains(cell); });
      if (isNear && !reached.contains(other))
      {
        fits = reached.add(other) && fits;
      }
    }
  }
  return !fits || !std::all_of(beside.begin(), beside.end(), [&](std::uint32_t cell) {
    return reached.contains(cell);
  });
}

void listChanged(const MeshEditor& mesh, std::vector<std::uint32_t>& cells)
{
  for (const auto& record : mesh.faceRecords())
  {
    for (const std::uint32_t c : { mesh.face(record.first).below, mesh.face(record.first).above })
    {
      if (c != None)
      {
        cells.push_back(c);
      }
    }
  }
}

bool measureDirty(MeshEditor& mesh)
{
  for (const std::uint32_t f : mesh.dirty.faces)
  {
    if (!mesh.face(f).gone)
    {
      mesh.changeFace(f);
      measureFace(mesh, f);
    }
    for (const std::uint32_t c : { mesh.face(f).below, mesh.face(f).above })
    {
      c != None ? mesh.dirty.cells.add(c) : void();
    }
  }
  for (const std::uint32_t c : mesh.dirty.cells)
  {
    if (!mesh.cell(c).gone && !mesh.isGhost(c))
    {
      const double before = mesh.changeCell(c).volume;
      measureCell(mesh, c);
      if (!(mesh.cell(c).volume > 0 || mesh.cell(c).volume >= before))
      {
        return false;
      }
    }
  }
  return true;
}

void costCells(MeshEditor& mesh, Items cells, const ObjectiveSpec& spec)
{
  for (const std::uint32_t c : cells)
  {
    if (!mesh.isFree(c))
    {
      continue;
    }
    setCostOfCell(mesh, c);
    for (const std::uint32_t f : mesh.facesOf(c))
    {
      setCostOfFace(mesh, f, spec);
    }
  }
}

Vector gradientAt(const MeshView& mesh, std::uint32_t node, const ObjectiveSpec& spec, double least)
{
  return GradientOfNode(mesh, node, spec).sum(least);
}

}
