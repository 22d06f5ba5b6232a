// SPDX-License-Identifier: BSD-3-Clause
#include "Optimisation/LayerPrisms.h"

#include "Polyhedra/OffsetPlanes.h"

#include <algorithm>
#include <tuple>

namespace cartesian
{

namespace
{

constexpr double Height = 0.4;        // of the box's edge
constexpr double SinOfOnePlane = 0.1; // normals that differ by less count as equal

struct EdgeOfFace
{
  std::uint32_t lower;
  std::uint32_t upper;
  std::uint32_t face;
  bool isDown; // the face runs from upper to lower

  bool operator<(const EdgeOfFace& other) const
  {
    return std::tie(lower, upper, face) < std::tie(other.lower, other.upper, other.face);
  }
};

class PrismBuilder
{
public:
  PrismBuilder(NodeMesh& mesh, const WallLayerSpec& layers)
    : m_(mesh)
    , layers_(layers)
    , topOf_(mesh.nodes.at.size(), None)
  {
  }

  LayerPrisms run()
  {
    findOffsets();
    addTops();
    insertCells();
    addFaces();
    listFacesOfPrisms();
    return std::move(result_);
  }

private:
  template <class Visitor>
  void forEachCorner(std::uint32_t f, Visitor&& visit) const
  {
    for (std::uint32_t i = m_.faces.start[f]; i < m_.faces.stop[f]; ++i)
    {
      visit(m_.faces.corners[i]);
    }
  }

  // Outwards, to where the planes of the faces around a node meet; faces all of whose nodes have one get a prism.
  void findOffsets()
  {
    std::vector<std::vector<Facet>> facets(m_.nodes.at.size());
    std::vector<std::vector<Facet>> others(m_.nodes.at.size());
    std::vector<double> edges(m_.nodes.at.size());
    std::vector<std::uint32_t> faces;
    for (std::uint32_t f = 0; f < m_.faces.size(); ++f)
    {
      if (m_.faces.cells[f][1] != None || m_.faces.cells[f][0] >= m_.cells.volumeOfBox.size())
      {
        continue;
      }
      const bool layered = layers_.hasLayers(m_.faces.boundary[f]);
      addFacets(f, layered ? facets : others);
      if (layered && m_.faces.cells[f][0] < m_.cells.changing)
      {
        faces.push_back(f);
        const double edge = std::cbrt(m_.cells.volumeOfBox[m_.faces.cells[f][0]]);
        forEachCorner(
          f, [&](std::uint32_t n) { edges[n] = edges[n] > 0 ? std::min(edges[n], edge) : edge; });
      }
    }
    offsets_.assign(m_.nodes.at.size(), Vector{});
    for (const std::uint32_t f : faces)
    {
      bool all = true;
      forEachCorner(f, [&](std::uint32_t n) {
        if (offsets_[n] == Vector{})
        {
          offsets_[n] =
            scaled(meetingPoint(facets[n], independentNormals(others[n], SinOfOnePlane)),
              Height * edges[n]);
        }
        all = all && norm(offsets_[n]) > 0;
      });
      if (all)
      {
        bases_.push_back(f);
      }
    }
  }

  void addFacets(std::uint32_t f, std::vector<std::vector<Facet>>& ofNodes) const
  {
    const std::uint32_t* const corners = m_.faces.corners.data() + m_.faces.start[f];
    const std::size_t size = m_.faces.stop[f] - m_.faces.start[f];
    const auto at = [&](std::size_t i) -> const Vector& { return m_.nodes.at[corners[i % size]]; };
    const Vector normal = unit(measureFace(size, at).area);
    for (std::size_t i = 0; norm(normal) > 0 && i < size; ++i)
    {
      const Vector back = minus(at(i + size - 1), at(i));
      addFacet(ofNodes[corners[i]], { normal, radians(angle(back, minus(at(i + 1), at(i)))), 1 });
    }
  }

  void addTops()
  {
    result_.firstNode = static_cast<std::uint32_t>(m_.nodes.at.size());
    for (const std::uint32_t f : bases_)
    {
      forEachCorner(f, [&](std::uint32_t n) {
        if (topOf_[n] == None)
        {
          topOf_[n] = static_cast<std::uint32_t>(m_.nodes.at.size());
          result_.below.push_back(n);
          result_.offset.push_back(offsets_[n]);
          m_.nodes.at.push_back(plus(m_.nodes.at[n], offsets_[n]));
          m_.nodes.number.push_back(None);
          m_.nodes.mayMove.push_back(0);
        }
      });
    }
  }

  // Between the cells that change and their neighbours.
  void insertCells()
  {
    const auto first = static_cast<std::uint32_t>(m_.cells.changing);
    const auto count = static_cast<std::uint32_t>(bases_.size());
    result_.firstCell = first;
    for (auto& cells : m_.faces.cells)
    {
      for (std::uint32_t& c : cells)
      {
        c += c != None && c >= first ? count : 0;
      }
    }
    std::vector<double> volumes;
    std::vector<std::int32_t> regions;
    for (const std::uint32_t f : bases_)
    {
      volumes.push_back(m_.cells.volumeOfBox[m_.faces.cells[f][0]]);
      regions.push_back(m_.cells.region[m_.faces.cells[f][0]]);
    }
    m_.cells.region.insert(m_.cells.region.begin() + first, regions.begin(), regions.end());
    m_.cells.volumeOfBox.insert(
      m_.cells.volumeOfBox.begin() + first, volumes.begin(), volumes.end());
    m_.cells.measures.insert(m_.cells.measures.begin() + first, count, CellGeometry{});
    m_.cells.number.insert(m_.cells.number.begin() + first, count, std::uint32_t(None));
    m_.cells.box.insert(m_.cells.box.begin() + first, count, std::uint32_t(None));
    m_.cells.changing += count;
  }

  void addFaces()
  {
    result_.counts.assign(m_.faces.size(), 1);
    prismOf_.assign(m_.faces.size(), None);
    for (std::uint32_t i = 0; i < bases_.size(); ++i)
    {
      prismOf_[bases_[i]] = result_.firstCell + i;
      m_.faces.cells[bases_[i]][1] = result_.firstCell + i;
    }
    for (const std::uint32_t f : bases_)
    {
      const std::vector<std::uint32_t> ring(
        m_.faces.corners.begin() + m_.faces.start[f], m_.faces.corners.begin() + m_.faces.stop[f]);
      for (const std::uint32_t n : ring)
      {
        m_.faces.corners.push_back(topOf_[n]);
      }
      closeFace(prismOf_[f], None, m_.faces.boundary[f]);
    }
    addSides();
  }

  void closeFace(std::uint32_t below, std::uint32_t above, std::int32_t boundary)
  {
    m_.faces.close({ below, above }, boundary, None);
    result_.counts.push_back(above == None ? 0 : 1);
  }

  void addSides()
  {
    std::vector<EdgeOfFace> edges;
    for (const std::uint32_t f : bases_)
    {
      std::uint32_t from = m_.faces.corners[m_.faces.stop[f] - 1];
      forEachCorner(f, [&](std::uint32_t to) {
        edges.push_back({ std::min(from, to), std::max(from, to), f, from > to });
        from = to;
      });
    }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0; i < edges.size();)
    {
      std::size_t end = i + 1;
      while (end < edges.size() && edges[end].lower == edges[i].lower &&
        edges[end].upper == edges[i].upper)
      {
        ++end;
      }
      if (end - i == 2 && edges[i].isDown != edges[i + 1].isDown)
      {
        addSide(edges[i], prismOf_[edges[i + 1].face]);
      }
      else
      {
        std::for_each(edges.begin() + std::ptrdiff_t(i), edges.begin() + std::ptrdiff_t(end),
          [&](const EdgeOfFace& edge) { addSide(edge, None); });
      }
      i = end;
    }
  }

  void addSide(const EdgeOfFace& edge, std::uint32_t other)
  {
    const std::uint32_t from = edge.isDown ? edge.upper : edge.lower;
    const std::uint32_t to = edge.isDown ? edge.lower : edge.upper;
    m_.faces.corners.insert(m_.faces.corners.end(), { from, to, topOf_[to], topOf_[from] });
    closeFace(prismOf_[edge.face], other, NoBoundary);
  }

  void listFacesOfPrisms()
  {
    std::vector<std::vector<std::uint32_t>> faces(bases_.size());
    for (std::uint32_t f = 0; f < m_.faces.size(); ++f)
    {
      for (const std::uint32_t c : m_.faces.cells[f])
      {
        if (c >= result_.firstCell && c < m_.cells.changing)
        {
          faces[c - result_.firstCell].push_back(f);
        }
      }
    }
    for (const std::vector<std::uint32_t>& ofPrism : faces)
    {
      m_.cells.firstUse.push_back(static_cast<std::uint32_t>(m_.cells.uses.size()));
      m_.cells.uses.insert(m_.cells.uses.end(), ofPrism.begin(), ofPrism.end());
      m_.cells.endUse.push_back(static_cast<std::uint32_t>(m_.cells.uses.size()));
    }
  }

  NodeMesh& m_;
  const WallLayerSpec& layers_;
  std::vector<Vector> offsets_;        // of nodes; 0: none
  std::vector<std::uint32_t> bases_;   // faces with a prism
  std::vector<std::uint32_t> topOf_;   // of nodes, or None
  std::vector<std::uint32_t> prismOf_; // of faces, or None
  LayerPrisms result_;
};

}

LayerPrisms addPrisms(NodeMesh& mesh, const WallLayerSpec* layers)
{
  if (!layers)
  {
    LayerPrisms none;
    none.firstNode = static_cast<std::uint32_t>(mesh.nodes.at.size());
    none.firstCell = static_cast<std::uint32_t>(mesh.cells.changing);
    none.counts.assign(mesh.faces.size(), 1);
    return none;
  }
  return PrismBuilder(mesh, *layers).run();
}

}
