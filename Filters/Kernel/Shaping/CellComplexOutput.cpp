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
  ShapedCells(
    ShapedWall& whole, const std::vector<std::unique_ptr<CellComplex>>& slabs, Execution& execution)
    : whole_(whole)
    , slabs_(slabs)
    , execution_(execution)
    , mesh_(whole.mesh)
    , firstMade_(static_cast<std::uint32_t>(whole.mesh.faces.size()))
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
    mesh_.cells = std::move(result_.cells);
    mesh_.uses = std::move(result_.uses);
    mesh_.boxStart = std::move(result_.boxStart);
    mesh_.flawed = std::move(result_.flawed);
    whole_.known = std::move(known_);
    findCellsOfFaces();
    listSidesOfHexahedra();
  }

private:
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
    return slabs_[changed.slab]->open_.all()[changed.open];
  }

  // --- what changed, seen by the slabs

  void listChanged()
  {
    for (std::uint32_t s = 0; s < slabs_.size(); ++s)
    {
      execution_.poll();
      const CellComplex& slab = *slabs_[s];
      const std::vector<OpenCell>& open = slab.open_.all();
      newFaces_[s].assign(slab.madeFaces_.all.size(), None);
      newNodes_[s].assign(slab.madeNodes_.at.size(), None);
      for (std::uint32_t i = 0; i < open.size(); ++i)
      {
        const OpenCell& cell = open[i];
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
      if (use.face >= firstMade_)
      {
        newFaces_[s][use.face - firstMade_] = 0;
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
        if (other < FirstHexahedron)
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
      const MadeNodes& made = slabs_[s]->madeNodes_;
      for (std::size_t i = 0; i < made.at.size(); ++i)
      {
        if (newNodes_[s][i] != None)
        {
          newNodes_[s][i] = static_cast<std::uint32_t>(nodes.at.size());
          nodes.at.push_back(made.at[i]);
        }
      }
      for (VertexNode vertex : made.vertices)
      {
        vertex.node = newNode(s, vertex.node);
        if (vertex.node != None)
        {
          nodes.moreVertices.push_back(vertex);
        }
      }
      for (const auto& [place, node] : made.ofCuts)
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
    WallFaces& faces = mesh_.faces;
    for (std::size_t s = 0; s < slabs_.size(); ++s)
    {
      for (std::size_t f = 0; f < newFaces_[s].size(); ++f)
      {
        if (newFaces_[s][f] == None)
        {
          continue;
        }
        newFaces_[s][f] = static_cast<std::uint32_t>(faces.size());
        const MadeFace& face = slabs_[s]->madeFaces_.all[f];
        for (const std::uint32_t node : face.nodes)
        {
          faces.corners.push_back(newNode(s, node));
        }
        faces.add(face.cells, face.boundary);
      }
    }
  }

  // The number of a face; None: no cell has it.
  std::uint32_t newFace(std::size_t s, std::uint32_t face) const
  {
    return face < firstMade_ ? face : newFaces_[s][face - firstMade_];
  }

  // --- cells

  // Lists changed hexahedra among the polyhedral boxes; returns where each of the old list went.
  std::vector<std::uint32_t> promote()
  {
    Sides& sides = whole_.sides;
    std::vector<std::uint32_t> added;
    for (const Changed& changed : changed_)
    {
      if (changed.origin >= FirstHexahedron && sides.polyhedralOrdinal(cellOf(changed).box) == None)
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
    const std::vector<std::uint32_t>& polyhedral = whole_.sides.polyhedral;
    result_.flawed.assign(polyhedral.size(), 0);
    std::vector<std::uint32_t> oldOf(polyhedral.size(), None);
    for (std::size_t n = 0; n < place.size(); ++n)
    {
      oldOf[place[n]] = static_cast<std::uint32_t>(n);
      result_.flawed[place[n]] = mesh_.flawed[n];
    }
    const std::size_t most = mesh_.cells.size() + changed_.size();
    result_.cells.reserve(most);
    known_.reserve(most);
    result_.uses.reserve(mesh_.uses.size());
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
        result_.boxStart.push_back(result_.cells.size());
        writeChanged(nextOfHexahedron, keyOfHexahedron(polyhedral[n]));
        continue;
      }
      result_.boxStart.push_back(result_.cells.size() + (c - copied));
      for (; c < mesh_.boxStart[oldOf[n] + 1]; ++c)
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
    result_.boxStart.push_back(result_.cells.size());
    Cell end{};
    end.firstUse = result_.uses.size();
    result_.cells.push_back(end);
  }

  void copyCells(std::size_t begin, std::size_t end)
  {
    const std::size_t firstUse = mesh_.cells[begin].firstUse;
    known_.append(whole_.known, begin, end);
    for (std::size_t c = begin; c < end; ++c)
    {
      result_.cells.push_back(mesh_.cells[c]);
      result_.cells.back().firstUse += result_.uses.size() - firstUse;
    }
    result_.uses.insert(result_.uses.end(),
      mesh_.uses.begin() + static_cast<std::ptrdiff_t>(firstUse),
      mesh_.uses.begin() + static_cast<std::ptrdiff_t>(mesh_.cells[end].firstUse));
  }

  void writeCell(const Changed& changed)
  {
    const OpenCell& open = cellOf(changed);
    if (!open.alive)
    {
      return;
    }
    const Box box = whole_.boxes.box(open.box);
    const Vector size = minus(box.high, box.low);
    Cell cell;
    cell.box = open.box;
    cell.boundary = open.boundary;
    cell.region = open.region;
    cell.volumeFraction = changed.volume / (size[0] * size[1] * size[2]);
    cell.firstUse = result_.uses.size();
    cell.removed = open.removed;
    cell.sliver = open.removed && open.origin < FirstHexahedron && mesh_.cells[open.origin].sliver;
    cell.reach = open.reach;
    result_.cells.push_back(cell);
    known_.resize(result_.cells.size());
    for (const FaceUse& use : open.faces)
    {
      result_.uses.emplace_back(newFace(changed.slab, use.face), use.turned != 0);
    }
  }

  // --- what lies on both sides of faces

  bool isStillHexahedron(CellKey key) const
  {
    return isHexahedron(key) && whole_.sides.polyhedralOrdinal(boxOfHexahedron(key)) == None;
  }

  void findCellsOfFaces()
  {
    WallFaces& faces = mesh_.faces;
    execution_.forEach(faces.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f)
      {
        for (CellKey& key : faces.cells[f])
        {
          key = isStillHexahedron(key) ? key : CellKey(None);
        }
      }
    });
    execution_.forEach(mesh_.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c)
      {
        mesh_.forEachUse(c,
          [&](const FaceUse& use) { faces.cells[use.face][use.turned] = static_cast<CellKey>(c); });
      }
    });
  }

  void listSidesOfHexahedra()
  {
    std::vector<HexahedronSide> sides = std::move(mesh_.hexahedronSides);
    for (std::size_t s = 0; s < slabs_.size(); ++s)
    {
      for (const auto& [side, face] : slabs_[s]->madeFaces_.ofHexahedra)
      {
        sides.push_back({ static_cast<std::uint32_t>(side / 6),
          static_cast<std::uint32_t>(side % 6), newFace(s, face) });
      }
    }
    std::sort(sides.begin(), sides.end(), [](const HexahedronSide& x, const HexahedronSide& y) {
      return std::make_tuple(x.box, x.side, x.face) < std::make_tuple(y.box, y.side, y.face);
    });
    sides.erase(std::remove_if(sides.begin(), sides.end(),
                  [&](const HexahedronSide& side) {
                    return side.face == None || !isStillHexahedron(keyOfHexahedron(side.box));
                  }),
      sides.end());
    mesh_.hexahedronSides = std::move(sides);
  }

  ShapedWall& whole_;
  const std::vector<std::unique_ptr<CellComplex>>& slabs_;
  Execution& execution_;
  WallMesh& mesh_;
  std::uint32_t firstMade_; // faces and nodes of the slabs, as in CellComplex
  std::uint32_t firstAdded_;
  std::vector<Changed> changed_;
  std::vector<std::vector<std::uint32_t>> newNodes_; // of each slab's, or None: not used
  std::vector<std::vector<std::uint32_t>> newFaces_;
  WallMesh result_; // without faces
  KnownCells known_;
};

void writeBack(
  ShapedWall& whole, const std::vector<std::unique_ptr<CellComplex>>& slabs, Execution& execution)
{
  ShapedCells(whole, slabs, execution).write();
}

}
