// Primitive edits at random, for the tests, of a mesh that has any cells.
#pragma once

#include "Editing/CellCut.h"
#include "Editing/PrimitiveEdits.h"

#include <random>

namespace cartesian
{

class RandomEdits
{
public:
  RandomEdits(MeshEditor& mesh, std::mt19937& random)
    : mesh_(mesh)
    , random_(random)
  {
  }

  static constexpr int Kinds = 7;

  // As the primitive edits, one of them: whether the mesh had a place for it.
  bool make(int kind)
  {
    const std::uint32_t f = face();
    const Items ring = mesh_.cornersOf(f);
    const std::uint32_t i = lessThan(ring.size());
    const std::uint32_t u = ring[i];
    const std::uint32_t v = ring[(i + 1) % ring.size()];
    switch (kind)
    {
      case 0:
        return collapseEdge(mesh_, u, v, lessThan(2) == 0 ? mesh_.node(v).at : near(v));
      case 1:
      {
        const Items faces = mesh_.facesOf(mesh_.face(f).below);
        return joinFaces(mesh_, f, faces[lessThan(faces.size())]);
      }
      case 2:
        return splitFace(mesh_, f, i, lessThan(ring.size())) != None;
      case 3:
        return !mesh_.isWall(f) && mergeCells(mesh_, mesh_.face(f).below, mesh_.face(f).above);
      case 4:
        return removeCell(mesh_, mesh_.face(f).below);
      case 5:
        return cut(mesh_.face(f).below);
      default:
        mesh_.moveNode(u, near(u));
        return true;
    }
  }

private:
  std::uint32_t lessThan(std::size_t size) { return static_cast<std::uint32_t>(random_() % size); }

  double part() { return double(random_() % 2048) / 1024 - 1; }

  std::uint32_t face()
  {
    for (;;)
    {
      if (const std::uint32_t f = lessThan(mesh_.faceCount()); !mesh_.face(f).gone)
      {
        return f;
      }
    }
  }

  Vector near(std::uint32_t n)
  {
    const EditNode& node = mesh_.node(n);
    return onLattice(
      mesh_, plus(node.at, scaled({ part(), part(), part() }, 0.2)), node.constrainedAxes);
  }

  bool cut(std::uint32_t c)
  {
    CutParts parts;
    const Vector normal = unit({ part(), part(), part() + 2 });
    const Vector through = plus(mesh_.cell(c).centre, scaled({ part(), part(), part() }, 0.3));
    return cutCell(mesh_, c, { through, normal, 0.03 * mesh_.cell(c).edge }, parts);
  }

  MeshEditor& mesh_;
  std::mt19937& random_;
};

}
