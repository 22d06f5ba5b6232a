// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/ShapedWall.h"

#include "Acceptance/CellCost.h"
#include "Shaping/CellComplex.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

constexpr std::size_t CellsAChunk = 512;

}

void KnownCells::reserve(std::size_t cells)
{
  atFault.reserve(cells);
  isPlain.reserve(cells);
  places.reserve(cells);
  shares.reserve(cells);
}

void KnownCells::resize(std::size_t cells)
{
  atFault.resize(cells, IsAtFault::Unknown);
  isPlain.resize(cells);
  places.resize(cells);
  shares.resize(cells);
}

void KnownCells::append(const KnownCells& others, std::size_t begin, std::size_t end)
{
  const auto add = [&](auto& mine, const auto& theirs) {
    mine.insert(mine.end(), theirs.begin() + static_cast<std::ptrdiff_t>(begin),
      theirs.begin() + static_cast<std::ptrdiff_t>(end));
  };
  add(atFault, others.atFault);
  add(isPlain, others.isPlain);
  add(places, others.places);
  add(shares, others.shares);
}

ShapedWall::ShapedWall(
  const Boxes& b, const Patches& p, Sides& s, Nodes& n, WallMesh& m, double featureAngle)
  : boxes(b)
  , patches(p)
  , sides(s)
  , nodes(n)
  , mesh(m)
  , featureCosine(std::cos(radians(featureAngle)))
{
}

void ShapedWall::measure(Layers layers, Execution& execution)
{
  known.resize(mesh.size());
  sights.resize(mesh.faces.size() - mesh.faces.firstOfSides());
  const CellComplex complex(*this, {});
  Sights none; // slabs make faces later
  const std::array<CellKey, 2> range = cellsIn(layers);
  const CellKey first = range[0]; // clang takes no structured bindings into lambdas
  execution.forEach(range[1] - first, CellsAChunk, [&](std::size_t begin, std::size_t end) {
    Polyhedron polyhedron;
    CellShape measures;
    for (std::size_t c = first + begin; c < first + end; ++c)
    {
      if (known.atFault[c] != IsAtFault::Unknown)
      {
        continue;
      }
      const auto key = static_cast<CellKey>(c);
      complex.shape(key, polyhedron);
      cartesian::measure(polyhedron, measures);
      known.places[c] = { measures.centre, measures.volume };
      known.shares[c] = measures.volume / complex.volumeOfBox(key);
      const bool atFault = isAnyAtFault(polyhedron, measures);
      known.atFault[c] = atFault ? IsAtFault::Yes : IsAtFault::No;
      known.isPlain[c] =
        !atFault && isPlain(polyhedron, measures) && isEasy(polyhedron, measures) ? 1 : 0;
      complex.noteSights(key, measures, sights, none);
    }
  });
}

}
