// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/WallJoining.h"

#include "Acceptance/Skewness.h"
#include "Shaping/CellTrial.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cartesian
{

namespace
{

// Between prisms on two faces: as the limits of solvers, with some room for what moving the nodes adds.
constexpr double SteepestLine =
  2; // tangent of the angle between the centres' line and the normal of the side
constexpr double MostSkew = 2.5; // skewness of that edge

// Between a cell and the prism on one of its faces, which is flat: tangent of the same angle.
constexpr double SteepestFloor = 1.5;

// Faces are joined up to this angle; those with a smaller share of the other's area at any.
const double CosineOfBend = std::cos(radians(30));
constexpr double NegligibleShare = 0.05;
constexpr double SmallShare = 0.2; // smaller ones are joined even where prisms could stand on both

// The ends of the chain of edges that two faces share, in the first one's direction.
struct Chain
{
  Vector from;
  Vector to;
};

bool findChain(const Ring& first, const Ring& joined, Chain& chain)
{
  // What follows the chain in the first begins the joined ring (joinRings).
  const auto* const at = std::find(first.corners, first.corners + first.size, joined.corners[0]);
  const auto end = static_cast<std::size_t>(at - first.corners);
  if (end == first.size)
  {
    return false;
  }
  chain.to = first[end];
  std::size_t i = end;
  do
  {
    i = i > 0 ? i - 1 : first.size - 1;
    chain.from = first[i];
  } while (i != end &&
    std::find(joined.corners, joined.corners + joined.size, first.corners[i]) ==
      joined.corners + joined.size);
  return i != end;
}

class Joiner
{
public:
  Joiner(CellComplex& cells, const WallLayerSpec& layers)
    : cells_(cells)
    , layers_(layers)
    , trial_(cells)
    , view_(trial_.view)
    , shape_(trial_.shape)
  {
  }

  // Makes two faces of a cell one; false: there are none.
  bool joinTwo(CellKey key)
  {
    cells_.view({ key }, view_);
    faces_.clear();
    for (std::uint32_t f = 0; f < view_.faces.size(); ++f)
    {
      if (view_.across[f] == None && !view_.fixed[f] && layers_.hasLayers(view_.boundary[f]))
      {
        faces_.push_back(f);
      }
    }
    if (faces_.size() < 2)
    {
      return false;
    }
    trial_.look(cells_, key);
    for (std::size_t i = 0; i < faces_.size(); ++i)
    {
      for (std::size_t k = i + 1; k < faces_.size(); ++k)
      {
        if (tryOut(faces_[i], faces_[k]))
        {
          return true;
        }
      }
    }
    return false;
  }

private:
  bool tryOut(std::uint32_t f, std::uint32_t g)
  {
    std::vector<std::uint32_t> ring;
    const Ring first = ringOf(view_.shape, f);
    if (view_.boundary[f] != view_.boundary[g] || !mayBend(f, g) ||
      !joinRings(first, ringOf(view_.shape, g), ring))
    {
      return false;
    }
    Chain chain;
    if (!findChain(first, { view_.shape.nodes.data(), ring.data(), ring.size() }, chain) ||
      !(isAtFault(f, g, chain) || isSteep(f) || isSteep(g) || areUnequal(f, g)))
    {
      return false;
    }
    trial_.faces.groups.clear();
    trial_.join({ f, g }, std::move(ring), false);
    if (!accepts(Accepted::Wall, trial_.now, trial_.joined()) || !trial_.isSound(cells_))
    {
      return false;
    }
    cells_.join(trial_.key, view_, trial_.faces);
    return true;
  }

  bool mayBend(std::uint32_t f, std::uint32_t g) const
  {
    const Vector& p = shape_.faces[f].area;
    const Vector& q = shape_.faces[g].area;
    const double least = std::min(norm(p), norm(q));
    return least < NegligibleShare * std::max(norm(p), norm(q)) ||
      dot(p, q) > CosineOfBend * norm(p) * norm(q);
  }

  // Prisms on the smaller one would be thin slices beside the other's.
  bool areUnequal(std::uint32_t f, std::uint32_t g) const
  {
    const double p = norm(shape_.faces[f].area);
    const double q = norm(shape_.faces[g].area);
    return std::min(p, q) < SmallShare * std::max(p, q);
  }

  // Of the side between two prisms, as seen along the wall's normal.
  bool isAtFault(std::uint32_t f, std::uint32_t g, const Chain& chain) const
  {
    const Vector edge = minus(chain.to, chain.from);
    const Vector u = unit(edge);
    const Vector normal = unit(plus(shape_.faces[f].area, shape_.faces[g].area));
    const Vector across =
      cross(u, normal); // from the first, which is to the left of its edges, to the second
    const Vector middle = scaled(plus(chain.from, chain.to), 0.5);
    const Vector toMiddle = minus(middle, shape_.faces[f].centre);
    const Vector line = minus(shape_.faces[g].centre, shape_.faces[f].centre);
    const double before = dot(toMiddle, across);
    const double way = dot(line, across);
    if (!(before > 0 && way > before) || std::abs(dot(line, u)) > SteepestLine * way)
    {
      return true;
    }
    const Vector aside = scaled(u, dot(toMiddle, u) - dot(line, u) * before / way);
    const std::array<Vector, 2> ends{ chain.from, chain.to };
    const std::array<std::uint32_t, 2> both{ 0, 1 };
    return isSkewed({ ends.data(), both.data(), 2 }, middle, aside, 0, MostSkew);
  }

  bool isSteep(std::uint32_t f) const
  {
    const Vector line = minus(shape_.faces[f].centre, shape_.centre);
    const Vector normal = unit(shape_.faces[f].area);
    const double height = dot(line, normal);
    return norm(minus(line, scaled(normal, height))) > SteepestFloor * height;
  }

  CellComplex& cells_;
  const WallLayerSpec& layers_;
  CellTrial trial_;
  CellView& view_;
  const CellShape& shape_;
  std::vector<std::uint32_t> faces_;
};

}

void joinWalls(CellComplex& cells, const std::vector<CellKey>& keys, const WallLayerSpec& layers,
  Execution& execution)
{
  Joiner joiner(cells, layers);
  for (const CellKey key : keys)
  {
    execution.poll();
    while (cells.isAlive(key) && joiner.joinTwo(key))
    {
    }
  }
}

}
