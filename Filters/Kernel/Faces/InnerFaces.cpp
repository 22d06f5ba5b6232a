// SPDX-License-Identifier: BSD-3-Clause
#include "Faces/InnerFaces.h"

#include "Base/Loops.h"
#include "Base/ObjectPool.h"
#include "Faces/SideChords.h"
#include "Lattice/StarPolygons.h"

#include <cmath>

namespace cartesian
{

namespace
{

constexpr std::size_t BoxesAChunk = 128;

struct FaceChunk
{
  std::vector<std::uint32_t> nodes;
  std::vector<std::uint32_t> faceSizes;
  std::vector<std::uint32_t> facesOfSide;
  std::vector<std::uint8_t> flawed;
  std::vector<std::int32_t> regions; // of faces
};

Wide area(const std::vector<PlanePoint>& at)
{
  Wide twice = 0;
  for (std::size_t i = 1; i + 1 < at.size(); ++i)
  {
    twice += turn(at[0], at[i], at[i + 1]);
  }
  return twice;
}

// Whether x lies inside a polygon, by the crossings of a ray to the right. On the border, either.
bool contains(const std::vector<PlanePoint>& at, const PlanePoint& x)
{
  bool in = false;
  for (std::size_t i = 0; i < at.size(); ++i)
  {
    const PlanePoint& p = at[i];
    const PlanePoint& q = at[i + 1 < at.size() ? i + 1 : 0];
    if ((p.b > x.b) != (q.b > x.b) && (turn(p, q, x) > 0) == (q.b > p.b))
    {
      in = !in;
    }
  }
  return in;
}

// The faces of one side. Keeps its storage from side to side.
class SideTracer
{
public:
  explicit SideTracer(const std::vector<Point>& nodes)
    : nodes_(nodes)
  {
  }

  std::vector<SideEdge>& chords() { return chords_; }

  // Appends the faces of the region that the chords bound. Returns false where they do not close.
  bool trace(const Rectangle& r, FaceChunk& chunk)
  {
    rectangle_ = &r;
    if (chords_.empty())
    {
      return tracePlain(chunk);
    }
    edges_ = chords_;
    if (!addBorder())
    {
      return false;
    }
    dropOpposite(edges_, used_);
    if (!balanced() || anyTwice())
    {
      return false;
    }
    traceLoops();
    if (!joinHolesToLoops())
    {
      return false;
    }
    emit(chunk);
    return true;
  }

private:
  PlanePoint at(std::uint32_t node) const { return flatten(nodes_[node], rectangle_->axis); }

  // A side that no surface crosses is inside or outside as a whole.
  bool tracePlain(FaceChunk& chunk) const
  {
    const auto& corner = rectangle_->corner;
    const bool anyInside = std::count(corner.begin(), corner.end(), KnownStatus::Inside) > 0;
    const bool anyOutside = std::count(corner.begin(), corner.end(), KnownStatus::Outside) > 0;
    if (anyInside && !anyOutside)
    {
      chunk.nodes.insert(
        chunk.nodes.end(), rectangle_->border, rectangle_->border + rectangle_->borderSize);
      chunk.faceSizes.push_back(static_cast<std::uint32_t>(rectangle_->borderSize));
    }
    return anyInside != anyOutside;
  }

  // Lists the pieces of the border that are inside. The status changes where chords end: past the end of
  // a chord that arrives it is inside, past the start of one that leaves it is outside.
  bool addBorder()
  {
    listBorder(nodes_, *rectangle_, chords_, border_);
    const auto known = std::find_if(border_.cbegin(), border_.cend(),
      [](const BorderNode& node) { return node.known != KnownStatus::Unknown; });
    if (known == border_.cend())
    {
      return false;
    }
    const auto first = static_cast<std::size_t>(known - border_.cbegin());
    int status = static_cast<int>(known->known);
    std::uint32_t from = known->node;
    for (std::size_t i = 1; i <= border_.size(); ++i)
    {
      const BorderNode& node = border_[(first + i) % border_.size()];
      if (node.node != from)
      {
        if (status < 0 || status > 1)
        {
          return false;
        }
        if (status == 1)
        {
          edges_.push_back({ from, node.node });
        }
        from = node.node;
      }
      status += node.change;
      if (node.known != KnownStatus::Unknown && status != static_cast<int>(node.known))
      {
        return false;
      }
    }
    return true;
  }

  // Whether as many edges arrive at each node as leave it, so that they form closed walks.
  bool balanced()
  {
    heads_.clear();
    for (const SideEdge& e : edges_)
    {
      heads_.push_back(e.to);
    }
    std::sort(heads_.begin(), heads_.end());
    return std::equal(edges_.begin(), edges_.end(), heads_.begin(),
      [](const SideEdge& e, std::uint32_t head) { return e.from == head; });
  }

  // Whether ofChunk of the surface overlap: they share an edge in the same direction.
  bool anyTwice() const
  {
    return std::adjacent_find(edges_.begin(), edges_.end(),
             [](const SideEdge& e, const SideEdge& next) { return !(e < next); }) != edges_.end();
  }

  // The unused edge from the head of `e` that turns left most sharply, so that regions that only touch at
  // a node stay separate.
  std::size_t follow(const SideEdge& e) const
  {
    std::size_t best = edges_.size();
    auto i = static_cast<std::size_t>(
      std::lower_bound(edges_.begin(), edges_.end(), SideEdge{ e.to, 0 }) - edges_.begin());
    for (; i < edges_.size() && edges_[i].from == e.to; ++i)
    {
      if (!used_[i] && (best == edges_.size() || turnsLeftOf(e, edges_[i], edges_[best])))
      {
        best = i;
      }
    }
    return best;
  }

  // Whether x leaves the head of e further to the left than y.
  bool turnsLeftOf(const SideEdge& e, const SideEdge& x, const SideEdge& y) const
  {
    const PlanePoint from = at(e.from);
    const PlanePoint here = at(e.to);
    const bool xLeft = turn(from, here, at(x.to)) > 0;
    const bool yLeft = turn(from, here, at(y.to)) > 0;
    return xLeft != yLeft ? xLeft : turn(here, at(y.to), at(x.to)) > 0;
  }

  void traceLoops()
  {
    pool_.release(outer_);
    pool_.release(holes_);
    used_.assign(edges_.size(), 0);
    for (std::size_t first = 0; first < edges_.size(); ++first)
    {
      if (used_[first])
      {
        continue;
      }
      walk_.clear();
      std::size_t i = first;
      do
      {
        used_[i] = 1;
        walk_.push_back(edges_[i].from);
        i = edges_[i].to == edges_[first].from ? first : follow(edges_[i]);
      } while (i != first);
      forEachSimpleLoop(walk_, [&](const std::uint32_t* begin, const std::uint32_t* end) {
        FlatPolygon loop = pool_.acquire();
        loop.nodes.assign(begin, end);
        loop.at.clear();
        for (const std::uint32_t* node = begin; node != end; ++node)
        {
          loop.at.push_back(at(*node));
        }
        (area(loop.at) < 0 ? holes_ : outer_).push_back(std::move(loop));
      });
    }
  }

  // Whether a loop is so thin that moving its nodes by one level may turn it over.
  static bool isThin(const std::vector<PlanePoint>& at)
  {
    Wide length = 0;
    for (std::size_t i = 0; i < at.size(); ++i)
    {
      const PlanePoint& p = at[i];
      const PlanePoint& q = at[i + 1 < at.size() ? i + 1 : 0];
      length += std::abs(q.a - p.a) + std::abs(q.b - p.b);
    }
    const Wide twice = area(at);
    return twice <= 2 * length && -twice <= 2 * length;
  }

  // Joins each hole to the smallest loop around it. A thin loop that rounding inverted has none around it, and is a
  // separate face. Returns false for thicker ones, which the surface inverts.
  bool joinHolesToLoops()
  {
    if (holes_.empty())
    {
      return true;
    }
    std::vector<std::vector<FlatPolygon>> holesOf(outer_.size());
    for (FlatPolygon& hole : holes_)
    {
      std::size_t around = holesOf.size();
      for (std::size_t i = 0; i < holesOf.size(); ++i)
      {
        if (encloses(outer_[i], hole) &&
          (around == holesOf.size() || area(outer_[i].at) < area(outer_[around].at)))
        {
          around = i;
        }
      }
      if (around < holesOf.size())
      {
        holesOf[around].push_back(std::move(hole));
      }
      else if (isThin(hole.at))
      {
        outer_.push_back(std::move(hole));
      }
      else
      {
        return false;
      }
    }
    for (std::size_t i = 0; i < holesOf.size(); ++i)
    {
      joinHoles(outer_[i], std::move(holesOf[i]));
    }
    return true;
  }

  static bool encloses(const FlatPolygon& loop, const FlatPolygon& hole)
  {
    for (std::size_t i = 0; i < hole.nodes.size(); ++i)
    {
      if (std::find(loop.nodes.begin(), loop.nodes.end(), hole.nodes[i]) == loop.nodes.end())
      {
        return contains(loop.at, hole.at[i]);
      }
    }
    return true;
  }

  void emit(FaceChunk& chunk)
  {
    for (const FlatPolygon& loop : outer_)
    {
      if (isWhole(loop))
      {
        emit(loop, chunk);
        continue;
      }
      stars_.clear();
      splitIntoStars(loop, stars_);
      for (const FlatPolygon& star : stars_)
      {
        emit(star, chunk);
      }
    }
  }

  // As a last resort, splitting may leave a node in a face twice.
  void emit(const FlatPolygon& face, FaceChunk& chunk)
  {
    walk_ = face.nodes;
    forEachSimpleLoop(walk_, [&](const std::uint32_t* begin, const std::uint32_t* end) {
      chunk.nodes.insert(chunk.nodes.end(), begin, end);
      chunk.faceSizes.push_back(static_cast<std::uint32_t>(end - begin));
    });
  }

  const std::vector<Point>& nodes_;
  const Rectangle* rectangle_ = nullptr;
  std::vector<SideEdge> chords_;
  std::vector<SideEdge> edges_;
  std::vector<BorderNode> border_;
  std::vector<std::uint32_t> heads_;
  std::vector<std::uint8_t> used_;
  std::vector<std::uint32_t> walk_;
  std::vector<FlatPolygon> outer_;
  std::vector<FlatPolygon> holes_;
  std::vector<FlatPolygon> stars_;
  ObjectPool<FlatPolygon> pool_;
};

class SideBuilder
{
public:
  SideBuilder(const Boxes& boxes, const Patches& patches, const Sides& sides, const Nodes& nodes)
    : sides_(sides)
    , sideChords_(boxes, patches, sides, nodes)
    , tracer_(nodes.at)
  {
  }

  void addSidesOf(std::size_t n, FaceChunk& chunk)
  {
    for (std::size_t s = sides_.ownStart[n]; s < sides_.ownStart[n + 1]; ++s)
    {
      const std::size_t facesBefore = chunk.faceSizes.size();
      const std::size_t nodesBefore = chunk.nodes.size();
      sideChords_.listRegions(s, regions_);
      const bool closed = std::all_of(regions_.begin(), regions_.end(), [&](std::int32_t region) {
        rectangle_ = sideChords_.rectangle(s, region);
        sideChords_.find(s, rectangle_, tracer_.chords(), region);
        const bool traced = tracer_.trace(rectangle_, chunk);
        chunk.regions.resize(chunk.faceSizes.size(), region);
        return traced;
      });
      if (!closed)
      {
        chunk.faceSizes.resize(facesBefore);
        chunk.nodes.resize(nodesBefore);
        chunk.regions.resize(facesBefore);
      }
      chunk.flawed.push_back(closed ? 0 : 1);
      chunk.facesOfSide.push_back(static_cast<std::uint32_t>(chunk.faceSizes.size() - facesBefore));
    }
  }

private:
  const Sides& sides_;
  SideChords sideChords_;
  SideTracer tracer_;
  std::vector<std::int32_t> regions_; // of a side
  Rectangle rectangle_{};             // as one of them sees it
};

InnerFaces join(const std::vector<FaceChunk>& ofChunk, bool hasRegions, Execution& execution)
{
  std::vector<std::size_t> side;
  std::vector<std::size_t> face;
  std::vector<std::size_t> node;
  for (const FaceChunk& chunk : ofChunk)
  {
    side.push_back(chunk.facesOfSide.size());
    face.push_back(chunk.faceSizes.size());
    node.push_back(chunk.nodes.size());
  }
  InnerFaces result;
  const std::size_t sides = scan(side);
  const std::size_t faces = scan(face);
  result.nodes.resize(scan(node));
  result.start.resize(faces + 1);
  result.start.back() = result.nodes.size();
  result.sideStart.resize(sides + 1);
  result.sideStart.back() = faces;
  result.flawed.resize(sides);
  result.region.resize(hasRegions ? faces : 0);
  execution.forEach(ofChunk.size(), 1, [&](std::size_t i, std::size_t) {
    const FaceChunk& chunk = ofChunk[i];
    std::copy(
      chunk.nodes.begin(), chunk.nodes.end(), result.nodes.begin() + std::ptrdiff_t(node[i]));
    std::size_t next = node[i];
    for (std::size_t f = 0; f < chunk.faceSizes.size(); ++f)
    {
      result.start[face[i] + f] = next;
      next += chunk.faceSizes[f];
    }
    if (hasRegions)
    {
      std::copy(chunk.regions.begin(), chunk.regions.end(),
        result.region.begin() + std::ptrdiff_t(face[i]));
    }
    next = face[i];
    for (std::size_t s = 0; s < chunk.facesOfSide.size(); ++s)
    {
      result.sideStart[side[i] + s] = next;
      result.flawed[side[i] + s] = chunk.flawed[s];
      next += chunk.facesOfSide[s];
    }
  });
  return result;
}

}

InnerFaces generateInnerFaces(const Boxes& boxes, const Patches& patches, const Sides& sides,
  const Nodes& nodes, Execution& execution)
{
  const std::size_t count = sides.polyhedral.size();
  std::vector<FaceChunk> ofChunk(chunks(count, BoxesAChunk));
  execution.nextLoop(0.95);
  execution.forEach(count, BoxesAChunk, [&](std::size_t begin, std::size_t end) {
    SideBuilder builder(boxes, patches, sides, nodes);
    for (std::size_t n = begin; n < end; ++n)
    {
      execution.poll();
      builder.addSidesOf(n, ofChunk[begin / BoxesAChunk]);
    }
  });
  return join(ofChunk, patches.walls.any(), execution);
}

}
