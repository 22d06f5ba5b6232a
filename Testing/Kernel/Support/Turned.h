// The same boxes elsewhere, and along other axes: what is asked of them must not change.
#pragma once

#include "Support/EditMeshes.h"

#include <algorithm>

namespace cartesian
{

struct Turn
{
  std::size_t axes = 0; // so often x becomes y, y z, z x
  Vector by{};          // then all moves

  Vector operator()(const Vector& p) const
  {
    Vector turned{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      turned[(axis + axes) % 3] = p[axis];
    }
    return plus(turned, by);
  }
};

inline std::vector<Turn> turns()
{
  return { {}, { 1 }, { 2 }, { 0, { 8, -16, 4 } }, { 1, { -4, 32, 8 } } };
}

// `place`: of the boxes before they are turned.
inline MeshEditor turnedMesh(const Turn& turn, const std::vector<TestBox>& boxes,
  const std::function<Vector(const Vector&)>& place)
{
  std::vector<TestBox> turned = boxes;
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      turned[i].low[(axis + turn.axes) % 3] = boxes[i].low[axis];
      turned[i].high[(axis + turn.axes) % 3] = boxes[i].high[axis];
    }
  }
  return meshOfBoxes(
    turned, { [&](const Vector& p) { return turn(place(Turn{ (3 - turn.axes) % 3 }(p))); } });
}

// The cell whose centre is nearest to a place.
inline std::uint32_t cellAt(const MeshView& mesh, const Vector& place)
{
  std::uint32_t nearest = None;
  for (std::uint32_t c = 0; c < mesh.cellCount(); ++c)
  {
    const auto distance = [&](std::uint32_t i) { return norm(minus(mesh.cell(i).centre, place)); };
    nearest =
      !mesh.cell(c).gone && (nearest == None || distance(c) < distance(nearest)) ? c : nearest;
  }
  return nearest;
}

}
