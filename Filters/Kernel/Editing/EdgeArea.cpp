// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/EdgeArea.h"

#include "Editing/PrimitiveEdits.h"
#include "Editing/WallEdges.h"

namespace cartesian
{

namespace
{

constexpr double MostAside = 0.1;   // in boxes
constexpr double ShortChord = 0.05; // in boxes: over shorter ones nothing is balanced

// The only sharp edge at a node but that to `except`: its other end, or None.
std::uint32_t nextOnEdge(const EditMesh& mesh, std::uint32_t node, std::uint32_t except)
{
  const SharpEnds ends = sharpEndsAt(mesh, node);
  if (ends.size() != 2 || !ends.contains(except))
  {
    return None;
  }
  return ends[0] == except ? ends[1] : ends[0];
}

}

Vector placeKeepingArea(const EditMesh& mesh, std::uint32_t u, std::uint32_t v, const Vector& at)
{
  const EditNode& to = mesh.node(v);
  if (mesh.node(u).kind != NodeKind::OnEdge || to.kind != NodeKind::OnEdge || to.held == HeldFast)
  {
    return at;
  }
  const std::uint32_t before = nextOnEdge(mesh, v, u);
  const std::uint32_t behind = nextOnEdge(mesh, u, v);
  if (before == None || behind == None || before == behind)
  {
    return at;
  }
  const Vector& from = mesh.node(before).at;
  const Vector chord = minus(mesh.node(behind).at, from);
  const Vector toU = minus(mesh.node(u).at, from);
  const double edge = mesh.cell(mesh.face(mesh.facesAround(v)[0]).below).edge;
  const double square = dot(chord, chord);
  if (square < ShortChord * ShortChord * edge * edge)
  {
    return at;
  }
  const Vector was = plus(cross(minus(to.at, from), toU), cross(toU, chord));
  const Vector lost = minus(was, cross(minus(at, from), chord)); // twice the area
  const Vector aside = scaled(cross(chord, lost), 1 / square);
  return norm(aside) > MostAside * edge ? at : onLattice(mesh, plus(at, aside), to.held);
}

}
