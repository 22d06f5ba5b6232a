// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/CellClosure.h"

#include <numeric>

namespace cartesian
{

namespace
{

constexpr std::size_t MostFaces = 256;
constexpr std::size_t MostCorners = 2048;
constexpr std::size_t LeastFaces = 4;

// The edges of a cell, and which of its faces are connected over them.
class Shell
{
public:
  Shell(std::size_t faces, std::size_t corners)
    : pieces_(faces)
  {
    while (std::size_t(1) << bits_ < corners) // twice the number of edges
    {
      ++bits_;
    }
    std::fill_n(edges_.begin(), std::size_t(1) << bits_, Edge{ 0, 0, 0 });
    std::iota(group_.begin(), group_.begin() + static_cast<std::ptrdiff_t>(faces), 0U);
  }

  // False: another face has it in this direction.
  bool add(std::uint32_t from, std::uint32_t to, std::uint32_t face)
  {
    const std::uint64_t key = std::uint64_t(std::min(from, to)) << 32U | std::max(from, to);
    const unsigned way = from < to ? 1 : 2;
    Edge& edge = find(key);
    if ((edge.ways & way) != 0 || from == to)
    {
      return false;
    }
    if (edge.ways == 0)
    {
      edge = { key, face, way };
      ++open_;
      return true;
    }
    edge.ways |= way;
    --open_;
    if (pieces_ > 1)
    {
      connect(edge.face, face);
    }
    return true;
  }

  bool isWhole() const { return open_ == 0 && pieces_ == 1; }

private:
  struct Edge
  {
    std::uint64_t key;
    std::uint32_t face; // the first
    unsigned ways;      // bits: from the lower node to the higher, back; 0: no edge
  };

  Edge& find(std::uint64_t key)
  {
    constexpr std::uint64_t Odd = 0x9E3779B97F4A7C15U;
    const std::size_t mask = (std::size_t(1) << bits_) - 1;
    std::size_t i = key * Odd >> (64 - bits_);
    while (edges_[i].ways != 0 && edges_[i].key != key)
    {
      i = (i + 1) & mask;
    }
    return edges_[i];
  }

  std::uint32_t groupOf(std::uint32_t face)
  {
    while (group_[face] != face)
    {
      group_[face] = group_[group_[face]];
      face = group_[face];
    }
    return face;
  }

  void connect(std::uint32_t f, std::uint32_t g)
  {
    const std::uint32_t one = groupOf(f);
    const std::uint32_t other = groupOf(g);
    pieces_ -= one != other ? 1 : 0;
    group_[one] = other;
  }

  std::array<Edge, MostCorners> edges_;
  std::array<std::uint32_t, MostFaces> group_;
  std::size_t pieces_;
  std::size_t open_ = 0; // edges of one face so far
  unsigned bits_ = 4;
};

}

bool isClosed(EditMesh& mesh, std::uint32_t c)
{
  const Items faces = mesh.facesOf(c);
  std::size_t corners = 0;
  for (const std::uint32_t f : faces)
  {
    corners += mesh.face(f).corners.size;
  }
  if (faces.size() < LeastFaces || faces.size() > MostFaces || corners > MostCorners)
  {
    return false;
  }
  Shell shell(faces.size(), corners);
  std::size_t nodes = 0;
  const std::uint32_t stamp = mesh.newStamp();
  for (std::uint32_t i = 0; i < faces.size(); ++i)
  {
    const Items ring = mesh.cornersOf(faces[i]);
    const bool isOutward = mesh.face(faces[i]).below == c;
    std::uint32_t last = ring[ring.size() - 1];
    for (const std::uint32_t n : ring)
    {
      if (!(isOutward ? shell.add(last, n, i) : shell.add(n, last, i)))
      {
        return false;
      }
      nodes += mesh.stampNode(n, stamp) ? 1 : 0;
      last = n;
    }
  }
  return shell.isWhole() && nodes + faces.size() == corners / 2 + 2;
}

}
