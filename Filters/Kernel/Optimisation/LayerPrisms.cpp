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
constexpr double SinOfOnePlane = 0.1; // normals that differ by less tell the same

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
  PrismBuilder(WallMesh& mesh, const WallLayerSpec& layers)
    : m_(mesh)
    , layers_(layers)
    , topOf_(mesh.at.size(), None)
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
    for (std::uint32_t i = m_.start[f]; i < m_.start[f + 1]; ++i)
    {
      visit(m_.corners[i]);
    }
  }

  // Outwards, to where the planes of the faces around a node meet; faces all of whose nodes have one get a prism.
  void findOffsets()
  {
    std::vector<std::vector<Facet>> facets(m_.at.size());
    std::vector<std::vector<Facet>> others(m_.at.size());
    std::vector<double> edges(m_.at.size());
    std::vector<std::uint32_t> faces;
    for (std::uint32_t f = 0; f < m_.faces(); ++f)
    {
      if (m_.cells[f][1] != None || m_.cells[f][0] >= m_.volumeOfBox.size())
      {
        continue;
      }
      const bool layered = layers_.hasLayers(m_.boundary[f]);
      addFacets(f, layered ? facets : others);
      if (layered && m_.cells[f][0] < m_.changing)
      {
        faces.push_back(f);
        const double edge = std::cbrt(m_.volumeOfBox[m_.cells[f][0]]);
        forEachCorner(
          f, [&](std::uint32_t n) { edges[n] = edges[n] > 0 ? std::min(edges[n], edge) : edge; });
      }
    }
    offsets_.assign(m_.at.size(), Vector{});
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
    const std::uint32_t* const corners = m_.corners.data() + m_.start[f];
    const std::size_t size = m_.start[f + 1] - m_.start[f];
    const auto at = [&](std::size_t i) -> const Vector& { return m_.at[corners[i % size]]; };
    const Vector normal = unit(measureFace(size, at).area);
    for (std::size_t i = 0; norm(normal) > 0 && i < size; ++i)
    {
      const Vector back = minus(at(i + size - 1), at(i));
      addFacet(ofNodes[corners[i]], { normal, radians(angle(back, minus(at(i + 1), at(i)))), 1 });
    }
  }

  void addTops()
  {
    result_.firstNode = static_cast<std::uint32_t>(m_.at.size());
    for (const std::uint32_t f : bases_)
    {
      forEachCorner(f, [&](std::uint32_t n) {
        if (topOf_[n] == None)
        {
          topOf_[n] = static_cast<std::uint32_t>(m_.at.size());
          result_.below.push_back(n);
          result_.offset.push_back(offsets_[n]);
          m_.at.push_back(plus(m_.at[n], offsets_[n]));
          m_.number.push_back(None);
          m_.mayMove.push_back(0);
        }
      });
    }
  }

  // Between the cells that change and their neighbours.
  void insertCells()
  {
    const auto first = static_cast<std::uint32_t>(m_.changing);
    const auto count = static_cast<std::uint32_t>(bases_.size());
    result_.firstCell = first;
    for (auto& cells : m_.cells)
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
      volumes.push_back(m_.volumeOfBox[m_.cells[f][0]]);
      regions.push_back(m_.region[m_.cells[f][0]]);
    }
    m_.region.insert(m_.region.begin() + first, regions.begin(), regions.end());
    m_.volumeOfBox.insert(m_.volumeOfBox.begin() + first, volumes.begin(), volumes.end());
    m_.measures.insert(m_.measures.begin() + first, count, CellGeometry{});
    m_.cell.insert(m_.cell.begin() + first, count, std::uint32_t(None));
    m_.changing += count;
  }

  void addFaces()
  {
    result_.counts.assign(m_.faces(), 1);
    prismOf_.assign(m_.faces(), None);
    for (std::uint32_t i = 0; i < bases_.size(); ++i)
    {
      prismOf_[bases_[i]] = result_.firstCell + i;
      m_.cells[bases_[i]][1] = result_.firstCell + i;
    }
    for (const std::uint32_t f : bases_)
    {
      const std::vector<std::uint32_t> ring(
        m_.corners.begin() + m_.start[f], m_.corners.begin() + m_.start[f + 1]);
      for (const std::uint32_t n : ring)
      {
        m_.corners.push_back(topOf_[n]);
      }
      closeFace(prismOf_[f], None, m_.boundary[f]);
    }
    addSides();
  }

  void closeFace(std::uint32_t below, std::uint32_t above, std::int32_t boundary)
  {
    m_.start.push_back(static_cast<std::uint32_t>(m_.corners.size()));
    m_.cells.push_back({ below, above });
    m_.boundary.push_back(boundary);
    result_.counts.push_back(above == None ? 0 : 1);
  }

  void addSides()
  {
    std::vector<EdgeOfFace> edges;
    for (const std::uint32_t f : bases_)
    {
      std::uint32_t from = m_.corners[m_.start[f + 1] - 1];
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
    m_.corners.insert(m_.corners.end(), { from, to, topOf_[to], topOf_[from] });
    closeFace(prismOf_[edge.face], other, NoBoundary);
  }

  void listFacesOfPrisms()
  {
    std::vector<std::vector<std::uint32_t>> faces(bases_.size());
    for (std::uint32_t f = 0; f < m_.faces(); ++f)
    {
      for (const std::uint32_t c : m_.cells[f])
      {
        if (c >= result_.firstCell && c < m_.changing)
        {
          faces[c - result_.firstCell].push_back(f);
        }
      }
    }
    for (const std::vector<std::uint32_t>& ofPrism : faces)
    {
      m_.cellFaces.insert(m_.cellFaces.end(), ofPrism.begin(), ofPrism.end());
      m_.cellStart.push_back(static_cast<std::uint32_t>(m_.cellFaces.size()));
    }
  }

  WallMesh& m_;
  const WallLayerSpec& layers_;
  std::vector<Vector> offsets_;        // of nodes; 0: none
  std::vector<std::uint32_t> bases_;   // faces with a prism
  std::vector<std::uint32_t> topOf_;   // of nodes, or None
  std::vector<std::uint32_t> prismOf_; // of faces, or None
  LayerPrisms result_;
};

}

LayerPrisms addPrisms(WallMesh& mesh, const WallLayerSpec* layers)
{
  if (!layers)
  {
    LayerPrisms none;
    none.firstNode = static_cast<std::uint32_t>(mesh.at.size());
    none.firstCell = static_cast<std::uint32_t>(mesh.changing);
    none.counts.assign(mesh.faces(), 1);
    return none;
  }
  return PrismBuilder(mesh, *layers).run();
}

}
