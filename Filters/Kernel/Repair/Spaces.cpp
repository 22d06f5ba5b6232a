// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/Spaces.h"

#include <map>
#include <utility>

namespace cartesian
{

namespace
{

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
    JoinedSides sides(surface_, pieces_, execution);
    windFrom(numberSpaces(sides));
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
  // Returns the one around everything.
  std::uint32_t numberSpaces(JoinedSides& sides)
  {
    std::map<std::uint32_t, std::uint32_t> number;
    const auto numberOf = [&](std::uint32_t space) {
      return number.emplace(space, static_cast<std::uint32_t>(number.size())).first->second;
    };
    for (std::uint32_t p = 0; p < pieces_.size(); ++p)
    {
      const std::uint32_t behind = numberOf(sides.beside(p, false));
      spaces_.beside.push_back({ behind, numberOf(sides.beside(p, true)) });
    }
    const std::uint32_t farAway = numberOf(sides.farAway());
    spaces_.turns.resize(number.size());
    piecesAt_.resize(number.size());
    for (std::uint32_t p = 0; p < pieces_.size(); ++p)
    {
      piecesAt_[spaces_.beside[p][0]].push_back(p);
      piecesAt_[spaces_.beside[p][1]].push_back(p);
    }
    return farAway;
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

  // How bodies wind around each space, from one on.
  void windFrom(std::uint32_t first)
  {
    spaces_.turns[first].assign(bodies_ + 1, 0);
    std::vector<std::uint32_t> reached{ first };
    while (!reached.empty())
    {
      const std::uint32_t space = reached.back();
      reached.pop_back();
      for (const std::uint32_t p : piecesAt_[space])
      {
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

  const Surface& surface_;
  const std::vector<Piece>& pieces_;
  std::size_t bodies_;
  std::vector<std::vector<std::uint32_t>> piecesAt_; // of each space
  Spaces spaces_;
};

}

Spaces findSpaces(const Surface& surface, const std::vector<Piece>& pieces, std::int32_t bodies,
  Execution& execution)
{
  return SpaceFinder(surface, pieces, bodies).run(execution);
}

}
