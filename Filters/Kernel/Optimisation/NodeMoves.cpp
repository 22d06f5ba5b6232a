// SPDX-License-Identifier: BSD-3-Clause
#include "Optimisation/NodeMoves.h"

#include "Acceptance/Acceptance.h"

namespace cartesian
{

namespace
{

// The longest step, as a part of the box's edge.
constexpr double LongestStep = 0.1;
constexpr double Shorter = 0.4;
constexpr int MostSteps = 6;

}

NodeMoves::NodeMoves(Mending& mending)
  : m_(mending)
  , lookedAt_(mending.mesh.nodes.at.size())
{
}

bool NodeMoves::move(std::uint32_t node)
{
  if (!m_.isMovable(node))
  {
    return false;
  }
  lookAround(node);
  if (around_.facesOfCells.size() > Mending::MostFacesAround ||
    !m_.changes.isAnySince(around_.cells, lookedAt_[node]))
  {
    return false;
  }
  lookedAt_[node] = m_.changes.next();
  double now = m_.energy.known(around_);
  double step = LongestStep * m_.edgeOf[node];
  bool gains = false;
  for (int i = 0; i < MostSteps && stepDown(node, step, now); ++i)
  {
    gains = true;
  }
  return gains;
}

void NodeMoves::lookAround(std::uint32_t node)
{
  const NumberLists::List faces = m_.faces.facesOf(node);
  around_.faces.assign(faces.begin(), faces.end());
  m_.faces.lookAround(around_);
}

// One step along the node's path, as long as `step` or shorter; whether the objective, `now`, falls.
bool NodeMoves::stepDown(std::uint32_t node, double& step, double& now)
{
  const Vector down = m_.task.paths[node].along(scaled(m_.energy.derivative(around_, node), -1));
  const double length = norm(down);
  const Vector from = m_.mesh.nodes.at[node];
  m_.energy.keep(around_, kept_);
  for (; length * step > AcceptedEdit::LeastGain * now; step *= Shorter)
  {
    const Vector to = rounded(plus(from, scaled(down, step / length)));
    if (!m_.mayBeAt(node, to))
    {
      continue;
    }
    put(node, to);
    const double there = m_.energy.evaluate(around_, acceptedBelow(now));
    if (there < acceptedBelow(now))
    {
      now = there;
      m_.changes.mark(around_.cells);
      return true;
    }
  }
  put(node, from);
  m_.energy.putBack(around_, kept_);
  return false;
}

void NodeMoves::put(std::uint32_t node, const Vector& at)
{
  m_.mesh.nodes.at[node] = at;
}

}
