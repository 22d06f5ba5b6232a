// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/InterfaceMending.h"

#include "Acceptance/CellCost.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr double LeastGain = 0.3;

constexpr double LeastVolumeKept = 0.8;

// One move may make another possible.
constexpr int MostMoves = 8;

// A cell, and what some of its faces would become.
struct Trial
{
  CellKey key;
  CellView view;
  CellShape shape;
  FaceCosts before;
  JoinedFaces faces;
  FaceCosts after;

  Ring ringOf(std::uint32_t face) const { return cartesian::ringOf(view.shape, face); }

  // The place of a face of another cell.
  std::uint32_t find(const FaceUse& face) const
  {
    const auto at = std::find_if(view.faces.begin(), view.faces.end(),
      [&](const FaceUse& use) { return use.face == face.face; });
    return static_cast<std::uint32_t>(at - view.faces.begin());
  }

  // A ring of another cell, at `way` from here, from this side; gets the nodes that it lacks.
  std::vector<std::uint32_t> seen(
    const std::vector<std::uint32_t>& ring, const Trial& from, const Vector& way)
  {
    std::vector<std::uint32_t> turned;
    for (auto node = ring.rbegin(); node != ring.rend(); ++node)
    {
      const auto at = std::find(view.nodes.begin(), view.nodes.end(), from.view.nodes[*node]);
      turned.push_back(static_cast<std::uint32_t>(at - view.nodes.begin()));
      if (turned.back() == view.nodes.size())
      {
        view.nodes.push_back(from.view.nodes[*node]);
        view.shape.nodes.push_back(plus(from.view.shape.nodes[*node], way));
      }
    }
    return turned;
  }
};

bool hasEdge(const Ring& ring, std::uint32_t u, std::uint32_t v)
{
  for (std::size_t i = 0; i < ring.size; ++i)
  {
    if (ring.corners[i] == u && ring.corners[i + 1 < ring.size ? i + 1 : 0] == v)
    {
      return true;
    }
  }
  return false;
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
    , joiner_(cells.featureCosine())
  {
  }

  // Moves the edge beside one of its faces between regions; false: none helps.
  bool mend(CellKey key)
  {
    look(key, own_);
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
        look(beyond, own_);
        if (moveEdgeOf(own_.find(face)))
        {
          return true;
        }
        look(key, own_);
      }
    }
    return false;
  }

private:
  void look(CellKey key, Trial& cell)
  {
    cell.key = key;
    cells_.view({ key }, cell.view);
    cells_.lookBeyond(key, cell.view);
    measure(cell.view.shape, cell.shape);
    cell.before = costsOf(cell.view.shape, cell.shape, cell.view.beyond);
    cell.faces.groups.clear();
  }

  static bool isWall(const Trial& cell, std::uint32_t f)
  {
    return cell.view.across[f] != None && cell.view.shape.isBoundary[f] && !cell.view.fixed[f];
  }

  // The face joins one beside it: what is beyond goes from the one cell there to the other.
  bool moveEdgeOf(std::uint32_t f)
  {
    const CellView& view = own_.view;
    for (std::uint32_t g = 0; g < view.faces.size(); ++g)
    {
      std::vector<std::uint32_t> ring;
      if (g != f && isWall(own_, g) && view.boundary[g] == view.boundary[f] &&
        view.across[g] != view.across[f] && joinRings(own_.ringOf(g), own_.ringOf(f), ring) &&
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
    for (const CellKey key : { own_.key, view.across[f], view.across[g] })
    {
      if (!cells_.isFree(key))
      {
        return false;
      }
    }
    look(view.across[f], loser_);
    look(view.across[g], gainer_);
    const std::uint32_t lost = loser_.find(view.faces[f]);
    std::vector<std::uint32_t> end; // of the loser
    const std::uint32_t between =
      faceBetween(lost, edgesInCommon(own_.ringOf(f), own_.ringOf(g), ring), end);
    if (between == None)
    {
      return false;
    }
    own_.faces.groups.assign(1, { { g, f }, ring });
    loser_.faces.groups.assign(1, { { between, lost }, end });
    gainer_.faces.groups.assign(
      1, { { gainer_.find(view.faces[g]) }, gainer_.seen(ring, own_, wayTo(own_)), true });
    gainer_.faces.groups.push_back({ { gainer_.find(loser_.view.faces[between]) },
      gainer_.seen(end, loser_, wayTo(loser_)), true });
    return isBetter();
  }

  // The loser's face towards the gainer that has all the edges beside which the lost one gives way; what both
  // become.
  std::uint32_t faceBetween(
    std::uint32_t lost, std::size_t edges, std::vector<std::uint32_t>& end) const
  {
    const Ring ring = loser_.ringOf(lost);
    for (std::uint32_t f = 0; f < loser_.view.faces.size(); ++f)
    {
      if (loser_.view.across[f] == gainer_.key && !loser_.view.fixed[f] &&
        joinRings(loser_.ringOf(f), ring, end) &&
        edgesInCommon(loser_.ringOf(f), ring, end) == edges && isAtGainersWall(f, ring))
      {
        return f;
      }
    }
    return None;
  }

  // Whether the edges that a face has in common with the lost one are those of the own face that grows.
  bool isAtGainersWall(std::uint32_t f, const Ring& lost) const
  {
    const Ring ring = loser_.ringOf(f);
    for (std::size_t i = 0; i < lost.size; ++i)
    {
      const std::uint32_t u = lost.corners[i];
      const std::uint32_t v = lost.corners[i + 1 < lost.size ? i + 1 : 0];
      if (hasEdge(ring, v, u) && !gainerHasWallAt(loser_.view.nodes[u], loser_.view.nodes[v]))
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
        (hasEdge(gainer_.ringOf(f), local(u), local(v)) ||
          hasEdge(gainer_.ringOf(f), local(v), local(u))))
      {
        return true;
      }
    }
    return false;
  }

  Vector wayTo(const Trial& cell) const { return cells_.between(gainer_.key, cell.key); }

  bool isBetter()
  {
    FaceCosts before;
    FaceCosts after;
    for (Trial* cell : { &own_, &loser_, &gainer_ })
    {
      joiner_.look(cell->view, cell->shape);
      const JoinedShape& result = joiner_.shapeOf(cell->faces);
      const double volume = result.measures.volume;
      if (result.polyhedron.faces() < LeastFaces || volume < LeastVolumeKept * cell->shape.volume ||
        cell->shape.volume < LeastVolumeKept * volume || !areStars(result, cell->faces) ||
        cells_.hasFacesNear(cell->key, cell->view, cell->faces))
      {
        return false;
      }
      before += cell->before;
      after += costsOf(result.polyhedron, result.measures, result.beyond);
    }
    return after.refused <= before.refused && after.sum < before.sum - LeastGain;
  }

  static bool areStars(const JoinedShape& shape, const JoinedFaces& faces)
  {
    for (std::size_t f = shape.kept(faces); f < shape.polyhedron.faces(); ++f)
    {
      const Ring ring = cartesian::ringOf(shape.polyhedron, f);
      if (!isStar(ring, unit(shape.measures.faces[f].area)))
      {
        return false;
      }
    }
    return true;
  }

  CellComplex& cells_;
  Trial own_;
  Trial loser_;  // of the face
  Trial gainer_; // of what is beyond it
  FaceJoiner joiner_;
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
