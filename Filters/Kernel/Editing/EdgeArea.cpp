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
std::uint32_t nextOnEdge(const MeshView& mesh, std::uint32_t node, std::uint32_t except)
{
  const SharpEnds ends = sharpEndsAt(mesh, node);
  if (ends.size() != 2 || !ends.contains(except))
  {
    return None;
  }
  return ends[0] == except ? ends[1] : ends[0];
}

// What an edge goes through: from `from` to v, u, and along the chord back.
struct Stretch
{
  Vector from{};
  Vector chord{};
  bool isKnown = false;
};

Stretch stretchAt(const MeshView& mesh, std::uint32_t u, std::uint32_t v)
{
  const std::uint32_t before = nextOnEdge(mesh, v, u);
  const std::uint32_t behind = nextOnEdge(mesh, u, v);
  if (before == None || behind == None || before == behind)
  {
    return {};
  }
  const Vector& from = mesh.node(before).at;
  return { from, minus(mesh.node(behind).at, from), true };
}

// Twice the area.
Vector lostBy(
  const MeshView& mesh, const Stretch& stretch, std::uint32_t u, std::uint32_t v, const Vector& at)
{
  const Vector toU = minus(mesh.node(u).at, stretch.from);
  const Vector was =
    plus(cross(minus(mesh.node(v).at, stretch.from), toU), cross(toU, stretch.chord));
  return minus(was, cross(minus(at, stretch.from), stretch.chord));
}

}

Vector placeKeepingArea(const MeshView& mesh, std::uint32_t u, std::uint32_t v, const Vector& at)
{
  const EditNode& to = mesh.node(v);
  if (mesh.node(u).kind != NodeKind::OnEdge || to.kind != NodeKind::OnEdge ||
    to.constrainedAxes == AllAxes)
  {
    return at;
  }
  const Stretch stretch = stretchAt(mesh, u, v);
  const double edge = mesh.edgeAt(v);
  const double square = dot(stretch.chord, stretch.chord);
  if (!stretch.isKnown || square < ShortChord * ShortChord * edge * edge)
  {
    return at;
  }
  const Vector aside = scaled(cross(stretch.chord, lostBy(mesh, stretch, u, v, at)), 1 / square);
  return norm(aside) > MostAside * edge ? at : onLattice(mesh, plus(at, aside), to.constrainedAxes);
}

double areaLost(const MeshView& mesh, std::uint32_t u, std::uint32_t v, const Vector& at)
{
  const Stretch stretch = stretchAt(mesh, u, v);
  return stretch.isKnown ? norm(lostBy(mesh, stretch, u, v, at)) / 2 : 0;
}

}
