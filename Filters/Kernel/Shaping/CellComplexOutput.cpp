// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/CellComplex.h"

#include <algorithm>
#include <tuple>

namespace cartesian
{

namespace
{

constexpr std::size_t CellsAChunk = 1024;

}

class ShapedCells
{
public:
  ShapedCells(CellsToShape& whole, const std::vector<std::unique_ptr<CellComplex>>& slabs,
    Execution& execution)
    : whole_(whole)
    , slabs_(slabs)
    , execution_(execution)
    , firstInner_(static_cast<std::uint32_t>(whole.patches.size()))
    , firstGiven_(firstInner_ + static_cast<std::uint32_t>(whole.inner.size()))
    , firstShaped_(firstGiven_ + static_cast<std::uint32_t>(whole.cells.shaped.size()))
    , firstAdded_(static_cast<std::uint32_t>(whole.nodes.at.size()))
    , newNodes_(slabs.size())
    , newFaces_(slabs.size())
  {
  }

  void write()
  {
    listChanged();
    forgetNextToRemoved();
    measure();
    const std::vector<std::uint32_t> place = promote();
    appendNodes();
    appendFaces();
    writeCells(place);
    findCellsOfShapedFaces();
    listSidesOfHexahedra();
    findCellsOfInnerFaces(whole_.inner, result_, execution_);
    whole_.cells = std::move(result_);
    whole_.known = std::move(known_);
  }

private:
  using OpenCell = CellComplex::OpenCell;
  using Shaped = CellComplex::Shaped;
  using HexahedronSide = ShapedFaces::HexahedronSide;

  // What a cell became: itself, then what it was cut into, in the order of cuts.
  struct Changed
  {
    CellKey origin;
    std::uint32_t slab;
    std::uint32_t open;
    double volume;

    bool operator<(const Changed& other) const
    {
      return origin != other.origin ? origin < other.origin : open < other.open;
    }
  };

  const OpenCell& cellOf(const Changed& changed) const
  {
    return slabs_[changed.slab]->open_[changed.open];
  }

  CellKey keyOfHexahedron(std::uint32_t box) const
  {
    return static_cast<CellKey>(whole_.cells.size() + box);
  }

  // --- what changed, seen by the slabs

  void listChanged()
  {
    for (std::uint32_t s = 0; s < slabs_.size(); ++s)
    {
      execution_.poll();
      const CellComplex& slab = *slabs_[s];
      newFaces_[s].assign(slab.shaped_.size(), None);
      newNodes_[s].assign(slab.added_.size(), None);
      for (std::uint32_t i = 0; i < slab.open_.size(); ++i)
      {
        const OpenCell& cell = slab.open_[i];
        if (cell.changed)
        {
          changed_.push_back({ cell.origin, s, i, 0 });
          markUsed(slab, s, cell);
        }
      }
    }
    std::sort(changed_.begin(), changed_.end());
  }

  void markUsed(const CellComplex& slab, std::size_t s, const OpenCell& cell)
  {
    for (const FaceUse& use : cell.faces)
    {
      if (use.face >= firstShaped_)
      {
        newFaces_[s][use.face - firstShaped_] = 0;
      }
      slab.forEachNodeOf(use, [&](std::uint32_t node) {
        if (node >= firstAdded_)
        {
          newNodes_[s][node - firstAdded_] = 0;
        }
      });
    }
  }

  // The cells next to those that were removed have boundary faces now.
  void forgetNextToRemoved()
  {
    for (const Changed& changed : changed_)
    {
      if (!cellOf(changed).removed)
      {
        continue;
      }
      for (const FaceUse& use : cellOf(changed).faces)
      {
        const CellKey other = slabs_[changed.slab]->across(use);
        if (other < whole_.cells.size())
        {
          whole_.known.atFault[other] = IsAtFault::Unknown;
        }
      }
    }
  }

  void measure()
  {
    execution_.forEach(changed_.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
      Polyhedron polyhedron;
      CellShape measures;
      for (std::size_t i = begin; i < end; ++i)
      {
        const CellComplex& slab = *slabs_[changed_[i].slab];
        const OpenCell& cell = cellOf(changed_[i]);
        if (!cell.alive)
        {
          continue;
        }
        polyhedron.clear();
        for (const FaceUse& use : cell.faces)
        {
          slab.addFaceTo(polyhedron, use, whole_.boxes.lowOf(cell.box));
        }
        cartesian::measure(polyhedron, measures);
        changed_[i].volume = measures.volume;
      }
    });
  }

  // --- nodes and faces

  void appendNodes()
  {
    Nodes& nodes = whole_.nodes;
    for (std::size_t s = 0; s < slabs_.size(); ++s)
    {
      const CellComplex& slab = *slabs_[s];
      for (std::size_t i = 0; i < slab.added_.size(); ++i)
      {
        if (newNodes_[s][i] != None)
        {
          newNodes_[s][i] = static_cast<std::uint32_t>(nodes.at.size());
          nodes.at.push_back(slab.added_[i]);
        }
      }
      for (VertexNode vertex : slab.vertices_)
      {
        vertex.node = newNode(s, vertex.node);
        if (vertex.node != None)
        {
          nodes.moreVertices.push_back(vertex);
        }
      }
      for (const auto& [place, node] : slab.cutNodes_)
      {
        if (newNode(s, node) != None)
        {
          nodes.ofCuts.push_back(newNode(s, node));
        }
      }
    }
    std::sort(nodes.moreVertices.begin(), nodes.moreVertices.end());
    std::sort(nodes.ofCuts.begin(), nodes.ofCuts.end(),
      [&](std::uint32_t a, std::uint32_t b) { return nodes.at[a] < nodes.at[b]; });
  }

  std::uint32_t newNode(std::size_t s, std::uint32_t node) const
  {
    return node < firstAdded_ ? node : newNodes_[s][node - firstAdded_];
  }

  void appendFaces()
  {
    ShapedFaces& faces = result_.shaped;
    faces = std::move(whole_.cells.shaped);
    for (std::size_t s = 0; s < slabs_.size(); ++s)
    {
      for (std::size_t f = 0; f < newFaces_[s].size(); ++f)
      {
        if (newFaces_[s][f] == None)
        {
          continue;
        }
        newFaces_[s][f] = static_cast<std::uint32_t>(faces.size());
        const Shaped& face = slabs_[s]->shaped_[f];
        for (const std::uint32_t node : face.nodes)
        {
          faces.nodes.push_back(newNode(s, node));
        }
        faces.start.push_back(faces.nodes.size());
        faces.cells.push_back({ None, None });
        faces.boundary.push_back(face.boundary);
      }
    }
  }

  // The number of a shaped face, of now or before; or None: no cell has it.
  std::uint32_t newFace(std::size_t s, std::uint32_t face) const
  {
    return face < firstShaped_ ? face - firstGiven_ : newFaces_[s][face - firstShaped_];
  }

  FaceOfCell refOf(std::size_t s, const FaceUse& use) const
  {
    using Kind = FaceOfCell::Kind;
    if (use.face < firstInner_)
    {
      return { use.face, Kind::Patch };
    }
    if (use.face < firstGiven_)
    {
      return { use.face - firstInner_, use.turned ? Kind::TurnedInner : Kind::Inner };
    }
    return { newFace(s, use.face), use.turned ? Kind::TurnedShaped : Kind::Shaped };
  }

  // --- cells

  // Lists changed hexahedra among the polyhedral boxes; returns where each of the old list went.
  std::vector<std::uint32_t> promote()
  {
    Sides& sides = whole_.sides;
    std::vector<std::uint32_t> added;
    for (const Changed& changed : changed_)
    {
      if (changed.origin >= whole_.cells.size() &&
        sides.polyhedralOrdinal(cellOf(changed).box) == None)
      {
        added.push_back(cellOf(changed).box);
      }
    }
    std::sort(added.begin(), added.end());
    added.erase(std::unique(added.begin(), added.end()), added.end());
    const std::vector<std::uint32_t> polyhedral = std::move(sides.polyhedral);
    const std::vector<std::uint32_t> patchBox = std::move(sides.patchBox);
    const std::vector<std::size_t> ownStart = std::move(sides.ownStart);
    const std::vector<std::size_t> boxStart = std::move(sides.boxStart);
    const std::size_t count = polyhedral.size() + added.size();
    sides.polyhedral.resize(count);
    sides.patchBox.resize(count);
    sides.ownStart.resize(count);
    sides.boxStart.resize(count);
    // Those with sides from the n-th of the old ones on.
    const auto put = [&](std::size_t at, std::size_t n, std::uint32_t box, std::uint32_t patches) {
      sides.ordinal[box] = static_cast<std::uint32_t>(at);
      sides.polyhedral[at] = box;
      sides.patchBox[at] = patches;
      sides.ownStart[at] = ownStart[n];
      sides.boxStart[at] = boxStart[n];
    };
    const auto countBefore = [](const std::vector<std::uint32_t>& list, std::uint32_t box) {
      return static_cast<std::size_t>(
        std::lower_bound(list.begin(), list.end(), box) - list.begin());
    };
    std::vector<std::uint32_t> place(polyhedral.size());
    execution_.forEach(polyhedral.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
      {
        place[n] = static_cast<std::uint32_t>(n + countBefore(added, polyhedral[n]));
        put(place[n], n, polyhedral[n], patchBox[n]);
      }
    });
    for (std::size_t i = 0; i < added.size(); ++i)
    {
      const std::size_t n = countBefore(polyhedral, added[i]);
      put(i + n, n, added[i], None);
    }
    sides.ownStart.push_back(ownStart.back());
    sides.boxStart.push_back(boxStart.back());
    return place;
  }

  void writeCells(const std::vector<std::uint32_t>& place)
  {
    const Cells& old = whole_.cells;
    const std::vector<std::uint32_t>& polyhedral = whole_.sides.polyhedral;
    result_.folds = old.folds;
    result_.voids = old.voids;
    result_.flawed.assign(polyhedral.size(), 0);
    std::vector<std::uint32_t> oldOf(polyhedral.size(), None);
    for (std::size_t n = 0; n < place.size(); ++n)
    {
      oldOf[place[n]] = static_cast<std::uint32_t>(n);
      result_.flawed[place[n]] = old.flawed[n];
    }
    const std::size_t most = old.all.size() + changed_.size();
    result_.all.reserve(most);
    known_.reserve(most);
    result_.faces.reserve(old.faces.size());
    auto next = changed_.begin();
    auto nextOfHexahedron =
      std::lower_bound(changed_.begin(), changed_.end(), Changed{ keyOfHexahedron(0), 0, 0, 0 });
    const auto writeChanged = [&](auto& at, CellKey key) {
      for (; at != changed_.end() && at->origin == key; ++at)
      {
        writeCell(*at);
      }
    };
    std::size_t c = 0; // old cells, of which these are copied
    std::size_t copied = 0;
    for (std::size_t n = 0; n < polyhedral.size(); ++n)
    {
      execution_.poll();
      if (oldOf[n] == None)
      {
        copyCells(copied, c);
        copied = c;
        result_.boxStart.push_back(result_.all.size());
        writeChanged(nextOfHexahedron, keyOfHexahedron(polyhedral[n]));
        continue;
      }
      result_.boxStart.push_back(result_.all.size() + (c - copied));
      for (; c < old.boxStart[oldOf[n] + 1]; ++c)
      {
        if (next != changed_.end() && next->origin == c)
        {
          copyCells(copied, c);
          copied = c + 1;
          writeChanged(next, static_cast<CellKey>(c));
        }
      }
    }
    copyCells(copied, c);
    result_.boxStart.push_back(result_.all.size());
    Cell end{};
    end.firstFace = result_.faces.size();
    result_.all.push_back(end);
  }

  void copyCells(std::size_t begin, std::size_t end)
  {
    const Cells& old = whole_.cells;
    const std::size_t firstFace = old.all[begin].firstFace;
    known_.append(whole_.known, begin, end);
    for (std::size_t c = begin; c < end; ++c)
    {
      result_.all.push_back(old.all[c]);
      result_.all.back().firstFace += result_.faces.size() - firstFace;
    }
    result_.faces.insert(result_.faces.end(),
      old.faces.begin() + static_cast<std::ptrdiff_t>(firstFace),
      old.faces.begin() + static_cast<std::ptrdiff_t>(old.all[end].firstFace));
  }

  void writeCell(const Changed& changed)
  {
    const OpenCell& open = cellOf(changed);
    if (!open.alive)
    {
      return;
    }
    const Cells& old = whole_.cells;
    const Box box = whole_.boxes.box(open.box);
    const Vector size = minus(box.high, box.low);
    Cell cell;
    cell.box = open.box;
    cell.boundary = open.boundary;
    cell.region = open.region;
    cell.volumeFraction = changed.volume / (size[0] * size[1] * size[2]);
    cell.firstFace = result_.faces.size();
    cell.removed = open.removed;
    cell.sliver = open.removed && open.origin < old.size() && old.all[open.origin].sliver;
    cell.reach = open.reach;
    result_.all.push_back(cell);
    known_.resize(result_.all.size());
    for (const FaceUse& use : open.faces)
    {
      result_.faces.push_back(refOf(changed.slab, use));
    }
  }

  // --- what lies on both sides of shaped faces

  void findCellsOfShapedFaces()
  {
    ShapedFaces& faces = result_.shaped;
    faces.cells.assign(faces.size(), { None, None });
    execution_.forEach(result_.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c)
      {
        for (std::size_t f = result_.all[c].firstFace; f < result_.all[c + 1].firstFace; ++f)
        {
          const FaceOfCell& face = result_.faces[f];
          if (face.kind() == FaceOfCell::Kind::Shaped ||
            face.kind() == FaceOfCell::Kind::TurnedShaped)
          {
            faces.cells[face.index][face.turned() ? 1 : 0] = static_cast<std::uint32_t>(c);
          }
        }
      }
    });
  }

  // Of those that stay hexahedra.
  void listSidesOfHexahedra()
  {
    ShapedFaces& faces = result_.shaped;
    std::vector<HexahedronSide> sides = std::move(faces.ofHexahedra);
    for (std::size_t s = 0; s < slabs_.size(); ++s)
    {
      for (const auto& [side, face] : slabs_[s]->faceOfHexahedron_)
      {
        sides.push_back({ static_cast<std::uint32_t>(side / 6),
          static_cast<std::uint32_t>(side % 6), newFace(s, face) });
      }
    }
    std::sort(sides.begin(), sides.end(), [](const HexahedronSide& x, const HexahedronSide& y) {
      return std::make_tuple(x.box, x.side, x.face) < std::make_tuple(y.box, y.side, y.face);
    });
    faces.ofHexahedra.clear();
    for (const HexahedronSide& side : sides)
    {
      if (side.face == None || whole_.sides.polyhedralOrdinal(side.box) != None)
      {
        continue;
      }
      std::array<std::uint32_t, 2>& cells = faces.cells[side.face];
      if ((cells[0] == None) != (cells[1] == None))
      {
        (cells[0] == None ? cells[0] : cells[1]) = ShapedFaces::SomeHexahedron;
        faces.ofHexahedra.push_back(side);
      }
    }
  }

  CellsToShape& whole_;
  const std::vector<std::unique_ptr<CellComplex>>& slabs_;
  Execution& execution_;
  std::uint32_t firstInner_; // faces and nodes of the slabs, as in CellComplex
  std::uint32_t firstGiven_;
  std::uint32_t firstShaped_;
  std::uint32_t firstAdded_;
  std::vector<Changed> changed_;
  std::vector<std::vector<std::uint32_t>> newNodes_; // of each slab's, or None: not used
  std::vector<std::vector<std::uint32_t>> newFaces_;
  Cells result_;
  KnownCells known_; // of its cells
};

void writeBack(
  CellsToShape& whole, const std::vector<std::unique_ptr<CellComplex>>& slabs, Execution& execution)
{
  ShapedCells(whole, slabs, execution).write();
}

}
