// SPDX-License-Identifier: BSD-3-Clause
#include "Sections/PlaneGraph.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace cartesian
{

namespace
{

// An edge in one direction; its twin, in the other, is the next or the one before.
struct HalfEdge
{
  std::uint32_t from;
  std::uint32_t to;
  std::size_t next = 0; // around the face to its left
  std::size_t face = 0;
  std::array<bool, 2> isOf{}; // an edge of the division, with this to its left:
  std::array<std::uint32_t, 2> polygon{ NoPolygon, NoPolygon };
};

class PlaneGraph
{
public:
  PlaneGraph(const std::array<std::vector<SidedEdge>, 2>& sides, PlaneOverlay& result)
    : result_(result)
  {
    listEdges(sides);
    link();
    trace();
    labelInner();
  }

  void write()
  {
    double largest = 0;
    for (const Face& face : faces_)
    {
      if (face.area <= 0 || (face.of[0] == NoPolygon && face.of[1] == NoPolygon))
      {
        continue;
      }
      if (face.of[0] != NoPolygon && face.of[1] != NoPolygon)
      {
        result_.polygons.push_back({ result_.corners.size(), face.of });
        forEachEdge(face, [&](std::size_t e) { result_.corners.push_back(edges_[e].from); });
        continue;
      }
      result_.unmatched += face.area;
      if (face.area > largest)
      {
        largest = face.area;
        result_.unmatchedAt = middleOf(face);
      }
    }
  }

private:
  struct Face
  {
    std::size_t first; // half edge
    double area = 0;
    std::array<std::uint32_t, 2> of{ NoPolygon, NoPolygon };
    std::array<bool, 2> isKnown{};
  };

  const PlanePlace& at(std::uint32_t vertex) const { return result_.vertices[vertex].at; }

  template <class Visitor>
  void forEachEdge(const Face& face, Visitor&& visit) const
  {
    std::size_t e = face.first;
    do
    {
      visit(e);
      e = edges_[e].next;
    } while (e != face.first);
  }

  std::size_t find(std::uint32_t from, std::uint32_t to) const
  {
    const std::array<std::uint32_t, 2> ends{ std::min(from, to), std::max(from, to) };
    const auto at = std::lower_bound(ends_.begin(), ends_.end(), ends);
    return 2 * static_cast<std::size_t>(at - ends_.begin()) + (from < to ? 0 : 1);
  }

  void listEdges(const std::array<std::vector<SidedEdge>, 2>& sides)
  {
    for (const auto& ofDivision : sides)
    {
      for (const SidedEdge& side : ofDivision)
      {
        ends_.push_back({ std::min(side.from, side.to), std::max(side.from, side.to) });
      }
    }
    std::sort(ends_.begin(), ends_.end());
    ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
    edges_.reserve(2 * ends_.size());
    for (const auto& ends : ends_)
    {
      edges_.push_back({ ends[0], ends[1] });
      edges_.push_back({ ends[1], ends[0] });
    }
    for (std::size_t k = 0; k < 2; ++k)
    {
      labelEdges(sides[k], k);
    }
  }

  // Where several edges of a division have become one, what was between them is there on both sides, and is left out.
  void labelEdges(const std::vector<SidedEdge>& sides, std::size_t k)
  {
    std::vector<std::pair<std::size_t, std::uint32_t>> lefts; // half edges and polygons
    lefts.reserve(sides.size());
    for (const SidedEdge& side : sides)
    {
      lefts.emplace_back(find(side.from, side.to), side.polygon);
    }
    std::sort(lefts.begin(), lefts.end());
    std::array<std::vector<std::uint32_t>, 2> beside;
    std::vector<std::uint32_t> own;
    for (auto at = lefts.begin(); at != lefts.end();)
    {
      const std::size_t edge = at->first & ~std::size_t(1);
      for (std::size_t way = 0; way < 2; ++way)
      {
        beside[way].clear();
        for (; at != lefts.end() && at->first == edge + way; ++at)
        {
          beside[way].push_back(at->second);
        }
      }
      for (std::size_t way = 0; way < 2; ++way)
      {
        own.clear();
        std::set_difference(beside[way].begin(), beside[way].end(), beside[1 - way].begin(),
          beside[1 - way].end(), std::back_inserter(own));
        if (!own.empty())
        {
          edges_[edge + way].isOf[k] = true;
          edges_[edge + way].polygon[k] = own.front();
        }
      }
    }
  }

  // Around each vertex, counter-clockwise.
  void link()
  {
    std::vector<std::size_t> order(edges_.size());
    std::iota(order.begin(), order.end(), 0);
    std::vector<double> angle(edges_.size());
    for (std::size_t e = 0; e < edges_.size(); ++e)
    {
      const PlanePlace& a = at(edges_[e].from);
      const PlanePlace& b = at(edges_[e].to);
      angle[e] = std::atan2(b[1] - a[1], b[0] - a[0]);
    }
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return edges_[a].from != edges_[b].from ? edges_[a].from < edges_[b].from
        : angle[a] != angle[b]                ? angle[a] < angle[b]
                                              : a < b;
    });
    for (std::size_t begin = 0; begin < order.size();)
    {
      std::size_t end = begin;
      while (end < order.size() && edges_[order[end]].from == edges_[order[begin]].from)
      {
        ++end;
      }
      for (std::size_t i = begin; i < end; ++i)
      {
        // What comes in by the twin of one goes out by that before it.
        edges_[order[i] ^ 1].next = order[i == begin ? end - 1 : i - 1];
      }
      begin = end;
    }
  }

  void trace()
  {
    std::vector<bool> isSeen(edges_.size());
    for (std::size_t first = 0; first < edges_.size(); ++first)
    {
      if (isSeen[first])
      {
        continue;
      }
      Face face{ first };
      const PlanePlace& origin = at(edges_[first].from);
      forEachEdge(face, [&](std::size_t e) {
        isSeen[e] = true;
        edges_[e].face = faces_.size();
        face.area += turnOf(origin, at(edges_[e].from), at(edges_[e].to)) / 2;
        for (std::size_t k = 0; k < 2; ++k)
        {
          if (edges_[e].isOf[k])
          {
            face.of[k] = edges_[e].polygon[k];
            face.isKnown[k] = true;
          }
        }
      });
      faces_.push_back(face);
    }
  }

  // Faces without an edge of a division lie in the polygon that their neighbours lie in.
  void labelInner()
  {
    std::vector<std::size_t> open;
    for (std::size_t k = 0; k < 2; ++k)
    {
      for (std::size_t f = 0; f < faces_.size(); ++f)
      {
        open.push_back(f);
        while (!open.empty())
        {
          const Face face = faces_[open.back()];
          open.pop_back();
          if (!face.isKnown[k])
          {
            continue;
          }
          forEachEdge(face, [&](std::size_t e) {
            Face& beyond = faces_[edges_[e ^ 1].face];
            if (!edges_[e].isOf[k] && !edges_[e ^ 1].isOf[k] && !beyond.isKnown[k])
            {
              beyond.of[k] = face.of[k];
              beyond.isKnown[k] = true;
              open.push_back(edges_[e ^ 1].face);
            }
          });
        }
      }
    }
  }

  PlanePlace middleOf(const Face& face) const
  {
    PlanePlace sum{};
    double count = 0;
    forEachEdge(face, [&](std::size_t e) {
      sum = { sum[0] + at(edges_[e].from)[0], sum[1] + at(edges_[e].from)[1] };
      ++count;
    });
    return { sum[0] / count, sum[1] / count };
  }

  PlaneOverlay& result_;
  std::vector<std::array<std::uint32_t, 2>> ends_; // of each edge, ascending
  std::vector<HalfEdge> edges_;                    // two of each
  std::vector<Face> faces_;
};

}

void traceFaces(const std::array<std::vector<SidedEdge>, 2>& sides, PlaneOverlay& overlay)
{
  PlaneGraph(sides, overlay).write();
}

}
