#include "CellComplex.h"

#include <algorithm>

namespace cartesian
{

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
