// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/CellClosure.h"

#include "Base/DisjointSets.h"
#include "Quality/Limits.h"

#include <algorithm>
#include <numeric>

namespace cartesian
{

namespace
{

// Of cells that are tested without allocating anything.
constexpr std::size_t UsualFaces = 256;
constexpr std::size_t UsualCorners = 2048;

// The edges of a cell, and which of its faces are connected over them.
class Shell
{
public:
  // `mayTouch`: edges may have several faces in a direction.
  Shell(std::size_t faces, std::size_t corners, bool mayTouch)
    : mayTouch_(mayTouch)
    , pieces_(faces)
  {
    while (std::size_t(1) << bits_ < corners) // twice the number of edges
    {
      ++bits_;
    }
    const std::size_t edges = std::size_t(1) << bits_;
    if (faces > UsualFaces || edges > UsualCorners)
    {
      more_ = { std::vector<Edge>(edges), std::vector<std::uint32_t>(faces) };
      edges_ = more_.first.data();
      group_ = more_.second.data();
    }
    std::fill_n(edges_, edges, Edge{ 0, 0, { 0, 0 } });
    std::iota(group_, group_ + faces, 0U);
  }

  // False: another face has it in this direction.
  bool add(std::uint32_t from, std::uint32_t to, std::uint32_t face)
  {
    const std::uint64_t key = std::uint64_t(std::min(from, to)) << 32U | std::max(from, to);
    Edge& edge = find(key);
    std::uint16_t& same = edge.ways[from < to ? 0 : 1];
    const std::uint16_t opposite = edge.ways[from < to ? 1 : 0];
    touches_ = touches_ || same > 0;
    if ((same > 0 && !mayTouch_) || from == to)
    {
      return false;
    }
    if (same + opposite == 0)
    {
      edge.key = key;
      edge.face = face;
    }
    pieces_ -= uniteIn(group_, edge.face, face) ? 1 : 0;
    same < opposite ? --open_ : ++open_;
    ++same;
    return true;
  }

  bool isWhole() const { return open_ == 0 && pieces_ == 1; }
  bool touches() const { return touches_; }

private:
  struct Edge
  {
    std::uint64_t key;
    std::uint32_t face;                // the first
    std::array<std::uint16_t, 2> ways; // faces that have it from the lower node to the higher, back
  };

  Edge& find(std::uint64_t key)
  {
    constexpr std::uint64_t Odd = 0x9E3779B97F4A7C15U;
    const std::size_t mask = (std::size_t(1) << bits_) - 1;
    std::size_t i = key * Odd >> (64 - bits_);
    while (edges_[i].ways[0] + edges_[i].ways[1] != 0 && edges_[i].key != key)
    {
      i = (i + 1) & mask;
    }
    return edges_[i];
  }

  bool mayTouch_;
  bool touches_ = false;
  std::array<Edge, UsualCorners> usualEdges_;
  std::array<std::uint32_t, UsualFaces> usualGroup_;
  std::pair<std::vector<Edge>, std::vector<std::uint32_t>> more_;
  Edge* edges_ = usualEdges_.data();
  std::uint32_t* group_ = usualGroup_.data();
  std::size_t pieces_;
  std::size_t open_ = 0; // edges without the face on the other side, so far
  unsigned bits_ = 4;
};

// By which a cell with these faces and so many nodes eulerDefect Euler's formula.
int missesOf(const MeshView& mesh, std::uint32_t c, std::size_t corners, std::size_t nodes)
{
  const std::size_t faces = mesh.facesOf(c).size();
  const bool isPossible = faces >= SolverLimits::Faces && corners % 2 == 0;
  return isPossible ? int(corners / 2) + 2 - int(nodes + faces) : -1;
}

int missesOf(MeshEditor& mesh, std::uint32_t c)
{
  std::size_t corners = 0;
  std::size_t nodes = 0;
  const std::uint32_t stamp = mesh.newStamp();
  for (const std::uint32_t f : mesh.facesOf(c))
  {
    const Items ring = mesh.cornersOf(f);
    corners += ring.size();
    for (const std::uint32_t n : ring)
    {
      nodes += mesh.stampNode(n, stamp) ? 1 : 0;
    }
  }
  return missesOf(mesh, c, corners, nodes);
}

std::size_t cornersOfFaces(const MeshView& mesh, std::uint32_t c)
{
  std::size_t corners = 0;
  for (const std::uint32_t f : mesh.facesOf(c))
  {
    corners += mesh.face(f).corners.size;
  }
  return corners;
}

// False: a face has an edge that another has in the same direction.
bool addAll(const MeshView& mesh, std::uint32_t c, Shell& shell)
{
  const Items faces = mesh.facesOf(c);
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
      last = n;
    }
  }
  return true;
}

}

void noteEulerDefects(EditMesh& whole, Execution& execution)
{
  constexpr std::size_t CellsAChunk = 1024;
  execution.forEach(whole.cells.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    MeshEditor mesh(whole, 0, 0, {});
    std::vector<std::uint32_t> corners;
    for (auto c = static_cast<std::uint32_t>(begin); c < end; ++c)
    {
      corners.clear();
      for (std::size_t i = 0; !mesh.isGhost(c) && i < mesh.cell(c).faces.size; ++i)
      {
        const Items ring = mesh.cornersOf(mesh.facesOf(c)[i]);
        corners.insert(corners.end(), ring.begin(), ring.end());
      }
      const std::size_t count = corners.size();
      if (mesh.cell(c).faces.size > 6 || count > 24) // more than a hexahedron has
      {
        std::sort(corners.begin(), corners.end());
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
        mesh.rawCell(c).eulerDefect =
          static_cast<std::int16_t>(std::max(0, missesOf(mesh, c, count, corners.size())));
      }
    }
  });
}

void lowerMisses(MeshEditor& mesh, std::uint32_t c)
{
  if (mesh.cell(c).eulerDefect > 0)
  {
    mesh.changeCell(c).eulerDefect = static_cast<std::int16_t>(missesOf(mesh, c));
  }
  if (mesh.cell(c).touches)
  {
    mesh.changeCell(c).touches = touchesItself(mesh, c);
  }
}

bool isClosedByCount(MeshEditor& mesh, std::uint32_t c)
{
  const int eulerDefect = missesOf(mesh, c);
  return eulerDefect >= 0 && eulerDefect <= mesh.cell(c).eulerDefect;
}

bool isClosed(MeshEditor& mesh, std::uint32_t c)
{
  if (!isClosedByCount(mesh, c))
  {
    return false;
  }
  Shell shell(mesh.facesOf(c).size(), cornersOfFaces(mesh, c), mesh.cell(c).touches);
  return addAll(mesh, c, shell) && shell.isWhole();
}

bool touchesItself(const MeshView& mesh, std::uint32_t c)
{
  Shell shell(mesh.facesOf(c).size(), cornersOfFaces(mesh, c), true);
  addAll(mesh, c, shell);
  return shell.touches();
}

}
