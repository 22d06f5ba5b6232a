// SPDX-License-Identifier: BSD-3-Clause
#include "Lifting/LayeredWall.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t NodesAChunk = 256;

class WallFinder
{
public:
  WallFinder(const OutputMesh& mesh, const std::vector<double>& points, const Lattice& lattice,
    const WallLift& lift, Execution& execution)
    : mesh_(mesh)
    , lattice_(lattice)
    , lift_(lift)
    , execution_(execution)
  {
    wall_.faces = mesh.boundaryMesh(execution);
    for (const Id point : wall_.faces.meshPoint)
    {
      const double* const at = &points[3 * static_cast<std::size_t>(point)];
      wall_.displaced.push_back({ at[0], at[1], at[2] });
    }
  }

  LayeredWall run()
  {
    const std::size_t nodes = wall_.displaced.size();
    findLayered();
    wall_.onWall = wall_.displaced;
    wall_.parts.assign(nodes, 0);
    execution_.forEach(nodes, NodesAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
      {
        if (wall_.isOnWall[n])
        {
          lift(n);
        }
      }
    });
    return std::move(wall_);
  }

private:
  void findLayered()
  {
    wall_.layered.resize(mesh_.boundary().size());
    wall_.isOnWall.assign(wall_.faces.meshPoint.size(), 0);
    for (std::size_t f = 0; f < wall_.layered.size(); ++f)
    {
      wall_.layered[f] = lift_.displacement().hasLayers(mesh_.boundary()[f].boundary);
      for (std::size_t i = 0; wall_.layered[f] && i < wall_.corners(f); ++i)
      {
        wall_.isOnWall[wall_.node(f, i)] = 1;
      }
    }
  }

  void lift(std::size_t n)
  {
    const Vector at = scaled(minus(wall_.displaced[n], lattice_.origin()), 1 / lattice_.step());
    const Vector to = lift_(at);
    if (to == at)
    {
      return;
    }
    wall_.parts[n] = lift_.hasRoom(at, to) ? 1 : 0;
    wall_.onWall[n] = plus(lattice_.origin(), scaled(to, lattice_.step()));
  }

  const OutputMesh& mesh_;
  const Lattice& lattice_;
  const WallLift& lift_;
  Execution& execution_;
  LayeredWall wall_;
};

}

bool LayeredWall::hasStack(std::size_t face) const
{
  bool any = false;
  for (std::size_t i = 0; i < corners(face); ++i)
  {
    any = any || parts[node(face, i)] > 0;
  }
  return layered[face] && any;
}

LayeredWall findLayeredWall(const OutputMesh& mesh, const std::vector<double>& points,
  const Lattice& lattice, const WallLift& lift, Execution& execution)
{
  return WallFinder(mesh, points, lattice, lift, execution).run();
}

}
