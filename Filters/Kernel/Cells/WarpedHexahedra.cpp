// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/WarpedHexahedra.h"

#include "Faces/UsedVertices.h"
#include "Polyhedra/CellGeometry.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t ItemsAChunk = 512;

class WarpedList
{
public:
  WarpedList(const Boxes& boxes, const Sides& sides, const Nodes& nodes, Execution& execution)
    : boxes_(boxes)
    , sides_(sides)
    , nodes_(nodes)
    , execution_(execution)
  {
  }

  std::vector<WarpedHexahedron> run()
  {
    listVertices();
    const std::vector<std::uint32_t> undivided = boxesAround();
    std::vector<std::uint32_t> divided;
    for (std::uint32_t d = 0; d < sides_.divided.size(); ++d)
    {
      if (isWarped(d))
      {
        divided.push_back(d);
      }
    }
    std::vector<WarpedHexahedron> warped(undivided.size() + divided.size());
    execution_.forEach(warped.size(), ItemsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        warped[i] = i < undivided.size() ? measureUndivided(undivided[i])
                                         : measureDivided(divided[i - undivided.size()]);
      }
    });
    return warped;
  }

private:
  // A vertex of the global mesh.
  struct Vertex
  {
    std::array<std::uint32_t, 3> at; // K, J, I
    std::uint32_t node;

    bool operator<(const Vertex& other) const { return at < other.at; }
  };

  bool hasMoved(std::size_t node) const
  {
    return !areSame(nodes_.at[node], nodes_.grid[node - nodes_.patchPoints]);
  }

  // Nodes come row by row, hence in order.
  void listVertices()
  {
    const std::size_t rowLength = boxes_.planes[1].size();
    std::size_t row = 0;
    for (std::size_t c = 0; c < nodes_.grid.size(); ++c)
    {
      const std::size_t node = nodes_.patchPoints + c;
      if (!hasMoved(node))
      {
        continue;
      }
      for (; nodes_.rowStart[row + 1] <= c; ++row)
      {
      }
      const std::size_t j = row % rowLength;
      const std::size_t k = row / rowLength;
      std::uint32_t i = 0;
      if (UsedVertices::isVertex(boxes_.planes, nodes_.grid[c], j, k, i))
      {
        vertices_.push_back({ { static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(j), i },
          static_cast<std::uint32_t>(node) });
      }
    }
  }

  // Lists the undivided hexahedra at the vertices that moved, in order.
  std::vector<std::uint32_t> boxesAround() const
  {
    std::vector<std::vector<std::uint32_t>> parts(chunks(vertices_.size(), ItemsAChunk));
    execution_.forEach(vertices_.size(), ItemsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v)
      {
        const auto& at = vertices_[v].at;
        for (unsigned corner = 0; corner < 8; ++corner)
        {
          const std::uint32_t global = boxes_.globalAt(std::int64_t(at[2]) - (corner & 1),
            std::int64_t(at[1]) - (corner >> 1 & 1), std::int64_t(at[0]) - (corner >> 2));
          if (global != None && boxes_.globals[global].depth == 0 &&
            sides_.ordinal[boxes_.globals[global].firstBox] == None)
          {
            parts[begin / ItemsAChunk].push_back(boxes_.globals[global].firstBox);
          }
        }
      }
    });
    std::vector<std::uint32_t> around;
    for (const std::vector<std::uint32_t>& part : parts)
    {
      around.insert(around.end(), part.begin(), part.end());
    }
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    return around;
  }

  bool isWarped(std::uint32_t d) const
  {
    const auto& nodes = nodes_.ofDivided[d];
    return std::any_of(
      nodes.begin(), nodes.end(), [&](std::uint32_t node) { return hasMoved(node); });
  }

  WarpedHexahedron measureUndivided(std::uint32_t box) const
  {
    const auto& low = boxes_.globalOf(boxes_.packed[box]).index;
    return measured(box, [&](unsigned corner) {
      const Vertex vertex{
        { low[2] + (corner >> 2), low[1] + (corner >> 1 & 1), low[0] + (corner & 1) }, None
      };
      const auto found = std::lower_bound(vertices_.begin(), vertices_.end(), vertex);
      return found == vertices_.end() || found->at != vertex.at ? cornerOf(boxes_.box(box), corner)
                                                                : nodes_.at[found->node];
    });
  }

  WarpedHexahedron measureDivided(std::uint32_t d) const
  {
    return measured(
      sides_.divided[d], [&](unsigned corner) { return nodes_.at[nodes_.ofDivided[d][corner]]; });
  }

  template <class Corner>
  WarpedHexahedron measured(std::uint32_t box, Corner&& corner) const
  {
    const Box whole = boxes_.box(box);
    std::array<FaceGeometry, 6> faces;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const unsigned upper : { 0u, 1u })
      {
        const std::array<unsigned, 4> ring = sideCorners(axis, upper);
        faces[2 * std::size_t(axis) + upper] = measureFace(ring.size(), [&](std::size_t i) {
          return minus(corner(ring[upper != 0 ? i : ring.size() - 1 - i]), whole.low);
        });
      }
    }
    const CellGeometry geometry =
      measureCell(faces.size(), [&](std::size_t i) -> const FaceGeometry& { return faces[i]; });
    const Vector size = minus(whole.high, whole.low);
    return { box, geometry.volume / (size[0] * size[1] * size[2]) };
  }

  const Boxes& boxes_;
  const Sides& sides_;
  const Nodes& nodes_;
  Execution& execution_;
  std::vector<Vertex> vertices_; // that moved, in order
};

}

std::vector<WarpedHexahedron> warpedHexahedra(
  const Boxes& boxes, const Sides& sides, const Nodes& nodes, Execution& execution)
{
  return WarpedList(boxes, sides, nodes, execution).run();
}

}
