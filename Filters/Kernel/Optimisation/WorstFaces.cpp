// SPDX-License-Identifier: BSD-3-Clause
#include "Optimisation/WorstFaces.h"

#include "Acceptance/Acceptance.h"
#include "Base/Sorting.h"
#include "Optimisation/EditTrials.h"
#include "Optimisation/NodeMoves.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// Changed faces are examined again, at most this often.
constexpr int MostSweeps = 3;

class Mender
{
public:
  Mender(const MendingTask& task, MeshEnergy& energy, Execution& execution)
    : m_(task, energy)
    , moves_(m_)
    , edits_(m_)
    , execution_(execution)
    , lookedAt_(m_.mesh.faces.size())
  {
  }

  std::vector<FaceEdit> run()
  {
    bool gains = true;
    for (int sweep = 0; gains && sweep < MostSweeps; ++sweep)
    {
      gains = false;
      for (const auto& [rank, f] : poorFaces())
      {
        execution_.poll();
        if (!m_.faces.isGone(f) && m_.changes.isAnySince(m_.mesh.faces.cells[f], lookedAt_[f]))
        {
          const std::uint32_t begin = m_.changes.next();
          gains = mend(f) || gains;
          lookedAt_[f] = begin;
        }
      }
    }
    return m_.faces.edits();
  }

private:
  bool isPoor(std::uint32_t f) const
  {
    return m_.energy.ofFaces()[f].limits > PoorFace::Limits || m_.energy.isFolded(f);
  }

  bool isFailing(std::uint32_t f) const
  {
    return m_.energy.ofFaces()[f].limits > PoorFace::LimitsOfFailing;
  }

  std::vector<std::pair<float, std::uint32_t>> poorFaces() const
  {
    std::vector<std::pair<float, std::uint32_t>> worst;
    for (std::uint32_t f = 0; f < m_.mesh.faces.size(); ++f)
    {
      if (!m_.faces.isGone(f) && isPoor(f))
      {
        worst.emplace_back(-static_cast<float>(m_.energy.ofFaces()[f].limits), f);
      }
    }
    std::sort(worst.begin(), worst.end());
    return worst;
  }

  bool mend(std::uint32_t f)
  {
    lookAround(f);
    if (around_.facesOfCells.size() > Mending::MostFacesAround || isFailingBetweenRegions())
    {
      return false;
    }
    nodes_.clear();
    m_.mesh.forEachCorner(f, [&](std::uint32_t node) { nodes_.push_back(node); });
    bool gains = moveAll();
    gains = (isPoor(f) && edits_.editBest(f)) || gains;
    gains = (!m_.faces.isGone(f) && isFailing(f) && moveCellsOf(f)) || gains;
    return gains;
  }

  void lookAround(std::uint32_t f)
  {
    around_.faces = { f };
    m_.faces.lookAround(around_);
  }

  // Such a cell cannot be left out: a cut has to make it valid, and would fail once its nodes have moved.
  bool isFailingBetweenRegions() const
  {
    const std::vector<std::uint32_t>& faces = around_.facesOfCells;
    return std::any_of(
             faces.begin(), faces.end(), [&](std::uint32_t f) { return m_.mesh.isInterface(f); }) &&
      std::any_of(faces.begin(), faces.end(), [&](std::uint32_t f) { return isFailing(f); });
  }

  // All nodes of its cells.
  bool moveCellsOf(std::uint32_t f)
  {
    nodes_.clear();
    lookAround(f);
    for (const std::uint32_t other : around_.facesOfCells)
    {
      m_.mesh.forEachCorner(other, [&](std::uint32_t node) { nodes_.push_back(node); });
    }
    nodes_ = sortedUnique(std::move(nodes_));
    return moveAll();
  }

  bool moveAll()
  {
    bool gains = false;
    for (const std::uint32_t node : nodes_)
    {
      gains = moves_.move(node) || gains;
    }
    return gains;
  }

  Mending m_;
  NodeMoves moves_;
  EditTrials edits_;
  Execution& execution_;
  std::vector<std::uint32_t> lookedAt_; // of faces
  std::vector<std::uint32_t> nodes_;    // to be moved
  Surroundings around_;
};

}

std::vector<FaceEdit> mendWorstFaces(
  const MendingTask& task, MeshEnergy& energy, Execution& execution)
{
  return Mender(task, energy, execution).run();
}

}
