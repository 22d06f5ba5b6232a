// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/Spaces.h"

#include "Repair/RadialEdgeSort.h"
#include "Repair/TriangleTree.h"
#include "Surface/LineCrossings.h"
#include "Surface/Places.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace cartesian
{

namespace
{

using Triple = std::array<std::uint32_t, 3>;

Triple sorted(Triple v)
{
  std::sort(v.begin(), v.end());
  return v;
}

class SpaceFinder
{
public:
  SpaceFinder(const Surface& surface, const std::vector<Piece>& pieces, std::int32_t bodies)
    : surface_(surface)
    , pieces_(pieces)
    , bodies_(static_cast<std::size_t>(bodies))
  {
  }

  Spaces run(Execution& execution)
  {
    sides_ = joinedSides(flatOf(surface_, pieces_), execution);
    numberSpaces();
    listPieces();
    const TriangleTree tree(surface_, execution);
    for (const std::uint32_t first : partsBySize())
    {
      startFrom(first, tree);
    }
    for (std::vector<std::int32_t>& turns : spaces_.turns)
    {
      turns.resize(bodies_ + 1); // of parts of a few levels, which no line meets: they are nowhere
    }
    for (std::uint32_t p = 0; p < pieces_.size(); ++p)
    {
      if (contradicts(p))
      {
        spaces_.contradictions.push_back(p);
      }
    }
    return std::move(spaces_);
  }

private:
  void numberSpaces()
  {
    std::vector<std::uint32_t> number(2 * pieces_.size());
    std::uint32_t count = 0;
    spaces_.beside.resize(pieces_.size());
    for (std::uint32_t side = 0; side < number.size(); ++side)
    {
      const std::uint32_t root = sides_.find(side);
      number[side] = root == side ? count++ : number[root];
      spaces_.beside[side / 2][side % 2] = number[side];
    }
    spaces_.turns.resize(count);
  }

  // Those of each space.
  void listPieces()
  {
    start_.assign(spaces_.turns.size() + 1, 0);
    for (const auto& beside : spaces_.beside)
    {
      ++start_[beside[0]];
      ++start_[beside[1]];
    }
    std::size_t sum = 0;
    for (std::size_t& s : start_)
    {
      sum += std::exchange(s, sum);
    }
    atSpace_.resize(2 * pieces_.size());
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for (std::uint32_t p = 0; p < pieces_.size(); ++p)
    {
      for (const std::uint32_t space : spaces_.beside[p])
      {
        atSpace_[next[space]++] = p;
      }
    }
  }

  double areaOf(std::uint32_t piece) const
  {
    const Corners c = surface_.corners(pieces_[piece].triangles[0]);
    return norm(cross(minus(c[1], c[0]), minus(c[2], c[0])));
  }

  // All pieces, the largest first.
  std::vector<std::uint32_t> partsBySize() const
  {
    std::vector<double> area(pieces_.size());
    for (std::uint32_t p = 0; p < pieces_.size(); ++p)
    {
      area[p] = areaOf(p);
    }
    std::vector<std::uint32_t> order(pieces_.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return area[a] != area[b] ? area[a] > area[b] : a < b;
    });
    return order;
  }

  // How often a body's triangles of a piece point as it does, less those that point back.
  std::int32_t netOf(std::uint32_t piece, std::size_t body) const
  {
    std::int32_t net = 0;
    for (const std::uint32_t t : pieces_[piece].triangles)
    {
      if (static_cast<std::size_t>(surface_.region[t]) == body)
      {
        net += faceAlike(surface_.triangles[t], pieces_[piece].vertices) ? 1 : -1;
      }
    }
    return net;
  }

  bool contradicts(std::uint32_t piece) const
  {
    const auto& [behind, front] = spaces_.beside[piece];
    bool any = false;
    for (std::size_t body = 1; body <= bodies_; ++body)
    {
      any = any || spaces_.turns[behind][body] != spaces_.turns[front][body] + netOf(piece, body);
    }
    return any;
  }

  // Unless the spaces beside a piece are known, finds how bodies wind around one of them, and continues from there.
  void startFrom(std::uint32_t piece, const TriangleTree& tree)
  {
    const std::uint32_t first = spaces_.beside[piece][0];
    std::vector<std::int32_t> turns;
    if (!spaces_.turns[first].empty() || !lookAlongLine(piece, tree, turns))
    {
      return;
    }
    std::vector<std::uint32_t> reached{ first };
    spaces_.turns[first] = std::move(turns);
    while (!reached.empty())
    {
      const std::uint32_t space = reached.back();
      reached.pop_back();
      for (std::size_t i = start_[space]; i < start_[space + 1]; ++i)
      {
        const std::uint32_t p = atSpace_[i];
        const auto& [behind, front] = spaces_.beside[p];
        const std::uint32_t beyond = behind == space ? front : behind;
        if (spaces_.turns[beyond].empty())
        {
          spaces_.turns[beyond] = spaces_.turns[space];
          for (std::size_t body = 1; body <= bodies_; ++body)
          {
            spaces_.turns[beyond][body] += (behind == space ? -1 : 1) * netOf(p, body);
          }
          reached.push_back(beyond);
        }
      }
    }
  }

  // How bodies wind around the space behind a piece, by the line through its middle; false where that misses the
  // piece, or others are at the same level.
  bool lookAlongLine(
    std::uint32_t piece, const TriangleTree& tree, std::vector<std::int32_t>& turns) const
  {
    const std::uint32_t own = pieces_[piece].triangles[0];
    const Corners corners = surface_.corners(own);
    const std::array<Wide, 3> normal = exactNormal(corners);
    std::size_t along = 0;
    for (std::size_t axis = 1; axis < 3; ++axis)
    {
      const auto size = [&](std::size_t a) { return normal[a] < 0 ? -normal[a] : normal[a]; };
      along = size(axis) > size(along) ? axis : along;
    }
    const RowAxes& axes = RowsAlong[along];
    Vector low = middleOf(surface_, own);
    const auto even = [&](int axis) {
      return static_cast<Level>(low[static_cast<std::size_t>(axis)] / 2) * 2;
    };
    const std::vector<Level> middles{ even(axes.middle) };
    const std::vector<Level> outers{ even(axes.outer) };
    Level level = 0;
    bool isHit = false;
    forEachLineCrossing(
      corners, axes, middles, outers, [&](std::size_t, std::size_t, const Point& p, bool) {
        level = p[along];
        isHit = true;
      });
    if (!isHit)
    {
      return false;
    }
    low[static_cast<std::size_t>(axes.middle)] = middles[0];
    low[static_cast<std::size_t>(axes.outer)] = outers[0];
    Vector high = low;
    low[along] = 0;
    high[along] = level;
    turns.assign(bodies_ + 1, 0);
    bool isClear = true;
    tree.forEachWithin(low, high, [&](std::uint32_t t) {
      forEachLineCrossing(surface_.corners(t), axes, middles, outers,
        [&](std::size_t, std::size_t, const Point& p, bool up) {
          isClear = isClear &&
            (p[along] != level || sorted(surface_.triangles[t]) == sorted(surface_.triangles[own]));
          turns[static_cast<std::size_t>(surface_.region[t])] +=
            p[along] < level ? (up ? -1 : 1) : 0;
        });
    });
    // Below the piece: in front of it, if its normal points down.
    for (std::size_t body = 1; body <= bodies_ && normal[along] < 0; ++body)
    {
      turns[body] += netOf(piece, body);
    }
    return isClear;
  }

  const Surface& surface_;
  const std::vector<Piece>& pieces_;
  std::size_t bodies_;
  DisjointSets sides_;
  std::vector<std::size_t> start_; // of each space in atSpace_, and the end
  std::vector<std::uint32_t> atSpace_;
  Spaces spaces_;
};

}

bool faceAlike(const std::array<std::uint32_t, 3>& a, const std::array<std::uint32_t, 3>& b)
{
  const auto at = std::find(a.begin(), a.end(), b[0]) - a.begin();
  return a[static_cast<std::size_t>(at + 1) % 3] == b[1];
}

std::vector<Piece> piecesOf(const Surface& surface)
{
  struct Entry
  {
    Triple corners; // sorted
    std::int32_t region;
    std::uint32_t triangle;

    bool operator<(const Entry& other) const
    {
      return std::tie(corners, region, triangle) <
        std::tie(other.corners, other.region, other.triangle);
    }
  };
  std::vector<Entry> entries(surface.triangles.size());
  for (std::uint32_t t = 0; t < entries.size(); ++t)
  {
    entries[t] = { sorted(surface.triangles[t]), surface.region[t], t };
  }
  std::sort(entries.begin(), entries.end());
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    if (i == 0 || entries[i - 1].corners != entries[i].corners)
    {
      pieces.push_back({ surface.triangles[entries[i].triangle], {} });
    }
    pieces.back().triangles.push_back(entries[i].triangle);
  }
  return pieces;
}

Surface flatOf(const Surface& surface, const std::vector<Piece>& pieces)
{
  Surface flat;
  flat.lattice = surface.lattice;
  flat.vertices = surface.vertices;
  flat.triangles.reserve(pieces.size());
  for (const Piece& piece : pieces)
  {
    flat.triangles.push_back(piece.vertices);
  }
  return flat;
}

DisjointSets joinedSides(const Surface& flat, Execution& execution)
{
  DisjointSets sides(2 * flat.triangles.size());
  RadialEdgeSort fan(flat.vertices);
  SurfaceEdges(flat, execution)
    .forEach([&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
      fan.start(lower, begin->upper);
      for (const EdgeUse* use = begin; use != end; ++use)
      {
        fan.add(use->triangle(), flat.triangles[use->triangle()], use->down());
      }
      fan.forEachSpace([&](const RadialEdgeSort::IncidentTriangle& one,
                         const RadialEdgeSort::IncidentTriangle& next) {
        sides.unite(sideOf(one.triangle, !one.down), sideOf(next.triangle, next.down));
      });
    });
  return sides;
}

Spaces findSpaces(const Surface& surface, const std::vector<Piece>& pieces, std::int32_t bodies,
  Execution& execution)
{
  return SpaceFinder(surface, pieces, bodies).run(execution);
}

}
