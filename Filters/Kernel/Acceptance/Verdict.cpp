// SPDX-License-Identifier: BSD-3-Clause
#include "Acceptance/Verdict.h"

#include "Acceptance/CellCost.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// Below this cost no face fails.
constexpr double AcceptedCost = 0.4;

}

Verdict& Verdict::operator+=(const Verdict& other)
{
  cost += other.cost;
  worst = std::max(worst, other.worst);
  refused += other.refused;
  invalid += other.invalid;
  faces = std::min(faces, other.faces);
  volume += other.volume;
  costBeyond += other.costBeyond;
  return *this;
}

Verdict evaluate(const Polyhedron& cell, const CellShape& shape,
  const std::vector<NeighbourCell>& beyond, const std::vector<std::uint8_t>& counts, double most)
{
  Verdict verdict;
  verdict.faces = cell.faces();
  verdict.volume = shape.volume;
  double worstRefused = -1;
  Refusal refusal{ cell, shape, beyond };
  const double negligible = negligibleArea(shape);
  for (std::uint32_t f = 0; f < cell.faces() && verdict.cost <= most; ++f)
  {
    if (!counts.empty() && !counts[f])
    {
      continue;
    }
    const double cost = costOfFace(cell, shape, f, beyond[f]) +
      (norm(shape.faces[f].area) < negligible ? CostOfNegligible : 0);
    verdict.cost += cost;
    verdict.toMend = cost > verdict.worst && verdict.refused == 0 ? f : verdict.toMend;
    verdict.worst = std::max(verdict.worst, cost);
    if (cost >= AcceptedCost && refusal.isRefused(f))
    {
      ++verdict.refused;
      verdict.invalid += isTurnedOver(shape, f, beyond[f]) ? 1 : 0;
      verdict.toMend = cost > worstRefused ? f : verdict.toMend;
      worstRefused = std::max(worstRefused, cost);
    }
  }
  return verdict;
}

Verdict evaluateCell(const Polyhedron& cell, const CellShape& shape,
  const std::vector<NeighbourCell>& beyond, double share, const std::vector<std::uint8_t>& counts)
{
  Verdict verdict = evaluate(cell, shape, beyond, counts);
  const double ofShare = costOfShare(share);
  const double ofDeterminant = costOfDeterminant(cell, shape);
  verdict.cost += ofShare + ofDeterminant;
  verdict.worst = std::max({ verdict.worst, ofShare, ofDeterminant });
  verdict.refused += cell.faces() < LeastFaces ? 1 : 0;
  return verdict;
}

}
