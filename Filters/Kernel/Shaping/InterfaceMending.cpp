// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/InterfaceMending.h"

#include "Acceptance/CellCost.h"
#include "Shaping/CellTrial.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// One move may make another possible.
constexpr int MostMoves = 8;

Ring ringOf(const CellTrial& cell, std::uint32_t face)
{
  return ringOf(cell.view.shape, face);
}

std::size_t edgesInCommon(const Ring& a, const Ring& b, const std::vector<std::uint32_t>& joined)
{
  return (a.size + b.size - joined.size()) / 2;
}

class Mender
{
public:
  explicit Mender(CellComplex& cells)
    : cells_(cells)
    , own_(cells)
    , loser_(cells)
    , gainer_(cells)
  {
  }

  // Moves the edge beside one of its faces between regions; false: none helps.
  bool mend(CellKey key)
  {
    own_.look(cells_, key);
    for (std::uint32_t f = 0; f < own_.view.faces.size(); ++f)
    {
      if (isWall(own_, f) &&
        costOfFace(own_.view.shape, own_.shape, f, own_.view.beyond[f]) > PoorCost)
      {
        const CellKey beyond = own_.view.across[f];
        const FaceUse face = own_.view.faces[f];
        if (moveEdgeOf(f))
        {
          return true;
        }
        own_.look(cells_, beyond);
        if (moveEdgeOf(own_.find(face)))
        {
          return true;
        }
        own_.look(cells_, key);
      }
    }
    return false;
  }

private:
  static bool isWall(const CellTrial& cell, std::uint32_t f)
  {
    return cell.view.across[f] != None && cell.view.shape.isBoundary[f] && !cell.view.fixed[f];
  }

  // The face joins an adjacent one: the cell beyond loses it to its neighbour.
  bool moveEdgeOf(std::uint32_t f)
  {
    const CellView& view = own_.view;
    for (std::uint32_t g = 0; g < view.faces.size(); ++g)
    {
      std::vector<std::uint32_t> ring;
      if (g != f && isWall(own_, g) && view.boundary[g] == view.boundary[f] &&
        view.across[g] != view.across[f] && joinRings(ringOf(own_, g), ringOf(own_, f), ring) &&
        tryOut(f, g, ring))
      {
        cells_.join(own_.key, own_.view, own_.faces);
        cells_.join(loser_.key, loser_.view, loser_.faces);
        return true;
      }
    }
    return false;
  }

  bool tryOut(std::uint32_t f, std::uint32_t g, const std::vector<std::uint32_t>& ring)
  {
    const CellView& view = own_.view;
    if (!cells_.isFree(own_.key) || !cells_.isFree(view.across[f]) ||
      !cells_.isFree(view.across[g]))
    {
      return false;
    }
    loser_.look(cells_, view.across[f]);
    gainer_.look(cells_, view.across[g]);
    const std::uint32_t lost = loser_.find(view.faces[f]);
    std::vector<std::uint32_t> end; // of the loser
    const std::uint32_t between =
      faceBetween(lost, edgesInCommon(ringOf(own_, f), ringOf(own_, g), ring), end);
    if (between == None)
    {
      return false;
    }
    own_.faces.groups.clear();
    own_.join({ g, f }, ring, false);
    loser_.join({ between, lost }, end, false);
    gainer_.join({ gainer_.find(view.faces[g]) }, gainer_.seen(ring, own_.view, wayTo(own_)), true);
    gainer_.join({ gainer_.find(loser_.view.faces[between]) },
      gainer_.seen(end, loser_.view, wayTo(loser_)), true);
    return isBetter();
  }

  // The loser's face towards the gainer that has all the edges beside which the lost one gives way; what both
  // become.
  std::uint32_t faceBetween(
    std::uint32_t lost, std::size_t edges, std::vector<std::uint32_t>& end) const
  {
    const Ring ring = ringOf(loser_, lost);
    for (std::uint32_t f = 0; f < loser_.view.faces.size(); ++f)
    {
      if (loser_.view.across[f] == gainer_.key && !loser_.view.fixed[f] &&
        joinRings(ringOf(loser_, f), ring, end) &&
        edgesInCommon(ringOf(loser_, f), ring, end) == edges && isAtGainersWall(f, ring))
      {
        return f;
      }
    }
    return None;
  }

  // Whether the edges that a face has in common with the lost one are those of the own face that grows.
  bool isAtGainersWall(std::uint32_t f, const Ring& lost) const
  {
    const Ring ring = ringOf(loser_, f);
    for (std::size_t i = 0; i < lost.size; ++i)
    {
      const std::uint32_t u = lost.corners[i];
      const std::uint32_t v = lost.corners[i + 1 < lost.size ? i + 1 : 0];
      if (hasEdgeFrom(ring, v, u) && !gainerHasWallAt(loser_.view.nodes[u], loser_.view.nodes[v]))
      {
        return false;
      }
    }
    return true;
  }

  bool gainerHasWallAt(std::uint32_t u, std::uint32_t v) const
  {
    const CellView& view = gainer_.view;
    const auto local = [&](std::uint32_t node) {
      return static_cast<std::uint32_t>(
        std::find(view.nodes.begin(), view.nodes.end(), node) - view.nodes.begin());
    };
    for (std::uint32_t f = 0; f < view.faces.size(); ++f)
    {
      if (view.across[f] == own_.key &&
        (hasEdgeFrom(ringOf(gainer_, f), local(u), local(v)) ||
          hasEdgeFrom(ringOf(gainer_, f), local(v), local(u))))
      {
        return true;
      }
    }
    return false;
  }

  Vector wayTo(const CellTrial& cell) const { return cells_.between(gainer_.key, cell.key); }

  bool isBetter()
  {
    Verdict before;
    Verdict after;
    for (CellTrial* cell : { &own_, &loser_, &gainer_ })
    {
      const Verdict joined = cell->joined();
      if (!keepsShape(Accepted::Mend, cell->now, joined) || !cell->isSound(cells_))
      {
        return false;
      }
      before += cell->now;
      after += joined;
    }
    return accepts(Accepted::Mend, before, after);
  }

  CellComplex& cells_;
  CellTrial own_;
  CellTrial loser_;  // of the face
  CellTrial gainer_; // of what is beyond it
};

}

void mendInterfaces(CellComplex& cells, const std::vector<CellKey>& keys, Execution& execution)
{
  Mender mender(cells);
  for (const CellKey key : keys)
  {
    execution.poll();
    for (int move = 0; move < MostMoves && cells.isAlive(key) && mender.mend(key); ++move)
    {
    }
  }
}

}
