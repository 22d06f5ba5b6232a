#include "InnerFaces.h"

#include "Loops.h"
#include "Numbering.h"
#include "StarPolygons.h"

#include <cmath>

namespace cartesian
{

namespace
{

constexpr std::size_t BoxesAChunk = 512;

// A directed piece of the boundary of a side's inside region, which lies to its left.
struct Edge
{
  std::uint32_t from;
  std::uint32_t to;

  bool operator<(const Edge& other) const
  {
    return from != other.from ? from < other.from : to < other.to;
  }
};

// The side of a box as its faces see it.
struct Rectangle
{
  int axis;
  std::array<Flat, 4> corner; // counter-clockwise from the lower corner
  std::array<std::uint32_t, 4> node;
  std::array<bool, 4> inside;
};

struct Part
{
  std::vector<std::uint32_t> nodes;
  std::vector<std::uint32_t> faceSizes;
  std::vector<std::uint32_t> facesOfSide;
  std::vector<std::uint8_t> flawed;
};

Wide area(const std::vector<Flat>& at)
{
  Wide twice = 0;
  for (std::size_t i = 1; i + 1 < at.size(); ++i)
  {
    twice += turn(at[0], at[i], at[i + 1]);
  }
  return twice;
}

// Whether x lies inside the polygon (crossings of a ray to the right; on its border, either).
bool contains(const std::vector<Flat>& at, const Flat& x)
{
  bool in = false;
  for (std::size_t i = 0; i < at.size(); ++i)
  {
    const Flat& p = at[i];
    const Flat& q = at[i + 1 < at.size() ? i + 1 : 0];
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

  std::vector<Edge>& chords() { return chords_; }

  // Appends the faces of the region that the chords bound; false where they do not close.
  bool trace(const Rectangle& r, Part& part)
  {
    if (chords_.empty())
    {
      return tracePlain(r, part);
    }
    rectangle_ = &r;
    edges_ = chords_;
    if (!addBorder())
    {
      return false;
    }
    dropOpposite();
    if (!balanced())
    {
      return false;
    }
    traceLoops();
    joinHoles();
    emit(part);
    return true;
  }

private:
  struct BorderNode
  {
    int border;
    std::int64_t along;
    std::uint32_t node;
    int change; // of the status past this node
  };

  Flat at(std::uint32_t node) const { return flatten(nodes_[node], rectangle_->axis); }

  static bool tracePlain(const Rectangle& r, Part& part)
  {
    const int in = r.inside[0] + r.inside[1] + r.inside[2] + r.inside[3];
    if (in == 4)
    {
      part.nodes.insert(part.nodes.end(), r.node.begin(), r.node.end());
      part.faceSizes.push_back(4);
    }
    return in == 0 || in == 4;
  }

  void addBorderNode(std::uint32_t node, int change)
  {
    const Flat p = at(node);
    const Flat low = rectangle_->corner[0];
    const Flat high = rectangle_->corner[2];
    if (p.b == low.b)
    {
      border_.push_back({ 0, p.a, node, change });
    }
    else if (p.a == high.a)
    {
      border_.push_back({ 1, p.b, node, change });
    }
    else if (p.b == high.b)
    {
      border_.push_back({ 2, -p.a, node, change });
    }
    else if (p.a == low.a)
    {
      border_.push_back({ 3, -p.b, node, change });
    }
  }

  // The pieces of the border that are inside. The status changes where chords end: past the end
  // of one that arrives it is inside, past the start of one that leaves outside.
  bool addBorder()
  {
    border_.clear();
    for (const Edge& chord : chords_)
    {
      addBorderNode(chord.from, -1);
      addBorderNode(chord.to, +1);
    }
    std::sort(border_.begin(), border_.end(), [](const BorderNode& x, const BorderNode& y) {
      return x.border != y.border ? x.border < y.border : x.along < y.along;
    });
    int status = rectangle_->inside[0];
    auto next = border_.cbegin();
    for (int border = 0; border < 4; ++border)
    {
      const int end = (border + 1) % 4;
      std::uint32_t from = rectangle_->node[border];
      while (next != border_.cend() && next->border == border)
      {
        const std::uint32_t node = next->node;
        addIfInside(status, from, node);
        for (; next != border_.cend() && next->node == node; ++next)
        {
          status += next->change;
        }
        if (status < 0 || status > 1)
        {
          return false;
        }
        from = node;
      }
      addIfInside(status, from, rectangle_->node[end]);
      if (status != int(rectangle_->inside[end]))
      {
        return false;
      }
    }
    return true;
  }

  void addIfInside(int status, std::uint32_t from, std::uint32_t to)
  {
    if (status == 1)
    {
      edges_.push_back({ from, to });
    }
  }

  // Edges that run to and fro between the same nodes bound nothing. Leaves edges sorted.
  void dropOpposite()
  {
    std::sort(edges_.begin(), edges_.end());
    used_.assign(edges_.size(), 0);
    for (std::size_t i = 0; i < edges_.size(); ++i)
    {
      const Edge opposite{ edges_[i].to, edges_[i].from };
      if (used_[i] || opposite < edges_[i])
      {
        continue;
      }
      auto j = static_cast<std::size_t>(
        std::lower_bound(edges_.begin(), edges_.end(), opposite) - edges_.begin());
      for (; j < edges_.size() && !(opposite < edges_[j]); ++j)
      {
        if (!used_[j])
        {
          used_[i] = used_[j] = 1;
          break;
        }
      }
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < edges_.size(); ++i)
    {
      if (!used_[i])
      {
        edges_[kept++] = edges_[i];
      }
    }
    edges_.resize(kept);
  }

  // As many edges arrive at every node as leave it: then they fall into closed walks.
  bool balanced()
  {
    heads_.clear();
    for (const Edge& e : edges_)
    {
      heads_.push_back(e.to);
    }
    std::sort(heads_.begin(), heads_.end());
    return std::equal(edges_.begin(), edges_.end(), heads_.begin(),
      [](const Edge& e, std::uint32_t head) { return e.from == head; });
  }

  // The unused edge out of `e`'s head that turns left most sharply: regions that only touch in a
  // node stay apart.
  std::size_t follow(const Edge& e) const
  {
    std::size_t best = edges_.size();
    auto i = static_cast<std::size_t>(
      std::lower_bound(edges_.begin(), edges_.end(), Edge{ e.to, 0 }) - edges_.begin());
    for (; i < edges_.size() && edges_[i].from == e.to; ++i)
    {
      if (!used_[i] && (best == edges_.size() || turnsLeftOf(e, edges_[i], edges_[best])))
      {
        best = i;
      }
    }
    return best;
  }

  // Whether x leaves e's head further to the left than y.
  bool turnsLeftOf(const Edge& e, const Edge& x, const Edge& y) const
  {
    const Flat from = at(e.from);
    const Flat here = at(e.to);
    const bool xLeft = turn(from, here, at(x.to)) > 0;
    const bool yLeft = turn(from, here, at(y.to)) > 0;
    return xLeft != yLeft ? xLeft : turn(here, at(y.to), at(x.to)) > 0;
  }

  void traceLoops()
  {
    outer_.clear();
    holes_.clear();
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
        FlatPolygon loop;
        loop.nodes.assign(begin, end);
        for (const std::uint32_t* node = begin; node != end; ++node)
        {
          loop.at.push_back(at(*node));
        }
        (area(loop.at) < 0 ? holes_ : outer_).push_back(std::move(loop));
      });
    }
  }

  // A hole belongs to the smallest loop around it. A loop that rounding has turned over has none
  // around it and is a face by itself.
  void joinHoles()
  {
    for (const FlatPolygon& hole : holes_)
    {
      FlatPolygon* around = nullptr;
      for (FlatPolygon& loop : outer_)
      {
        if (encloses(loop, hole) && (!around || area(loop.at) < area(around->at)))
        {
          around = &loop;
        }
      }
      if (around)
      {
        joinHole(*around, hole);
      }
      else
      {
        outer_.push_back(hole);
      }
    }
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

  void emit(Part& part)
  {
    stars_.clear();
    for (const FlatPolygon& loop : outer_)
    {
      splitIntoStars(loop, stars_);
    }
    for (const FlatPolygon& star : stars_)
    {
      part.nodes.insert(part.nodes.end(), star.nodes.begin(), star.nodes.end());
      part.faceSizes.push_back(static_cast<std::uint32_t>(star.nodes.size()));
    }
  }

  const std::vector<Point>& nodes_;
  const Rectangle* rectangle_ = nullptr;
  std::vector<Edge> chords_;
  std::vector<Edge> edges_;
  std::vector<BorderNode> border_;
  std::vector<std::uint32_t> heads_;
  std::vector<std::uint8_t> used_;
  std::vector<std::uint32_t> walk_;
  std::vector<FlatPolygon> outer_;
  std::vector<FlatPolygon> holes_;
  std::vector<FlatPolygon> stars_;
};

class SideBuilder
{
public:
  SideBuilder(const Boxes& boxes, const Patches& patches, const Sides& sides, const Nodes& nodes)
    : boxes_(boxes)
    , patches_(patches)
    , sides_(sides)
    , nodes_(nodes)
    , tracer_(nodes.at)
  {
  }

  void addSidesOf(std::size_t n, Part& part)
  {
    for (std::size_t s = sides_.ownStart[n]; s < sides_.ownStart[n + 1]; ++s)
    {
      const std::size_t facesBefore = part.faceSizes.size();
      const std::size_t nodesBefore = part.nodes.size();
      const bool upper = sides_.sides[s].low == sides_.intersected[n];
      const Rectangle r = rectangle(n, sides_.sides[s].axis, upper);
      findChords(n, sides_.sides[s].axis, upper);
      const bool closed = tracer_.trace(r, part);
      if (!closed)
      {
        part.faceSizes.resize(facesBefore);
        part.nodes.resize(nodesBefore);
      }
      part.flawed.push_back(closed ? 0 : 1);
      part.facesOfSide.push_back(static_cast<std::uint32_t>(part.faceSizes.size() - facesBefore));
    }
  }

private:
  Rectangle rectangle(std::size_t n, int axis, bool upper) const
  {
    const Box& box = boxes_.boxes[sides_.intersected[n]];
    Rectangle r;
    r.axis = axis;
    const std::array<unsigned, 4> corners = sideCorners(axis, upper ? 1 : 0);
    for (int i = 0; i < 4; ++i)
    {
      r.node[i] = nodes_.ofBox[n][corners[i]];
      r.corner[i] = flatten(nodes_.at[r.node[i]], axis);
      r.inside[i] = (box.corners >> corners[i] & 1) != 0;
    }
    return r;
  }

  // Edges of the box's patches on a side. A face of the side runs along them the other way than
  // the patch; on a lower side it is seen from within.
  void findChords(std::size_t n, int axis, bool upper)
  {
    const Box& box = boxes_.boxes[sides_.intersected[n]];
    const Level plane = upper ? box.high[axis] : box.low[axis];
    std::vector<Edge>& chords = tracer_.chords();
    chords.clear();
    for (std::size_t p = patches_.boxStart[n]; p < patches_.boxStart[n + 1]; ++p)
    {
      std::uint32_t from = patches_.corners[patches_.start[p + 1] - 1];
      for (std::size_t c = patches_.start[p]; c < patches_.start[p + 1]; ++c)
      {
        const std::uint32_t to = patches_.corners[c];
        if (patches_.points[from][axis] == plane && patches_.points[to][axis] == plane)
        {
          chords.push_back(upper ? Edge{ to, from } : Edge{ from, to });
        }
        from = to;
      }
    }
  }

  const Boxes& boxes_;
  const Patches& patches_;
  const Sides& sides_;
  const Nodes& nodes_;
  SideTracer tracer_;
};

InnerFaces join(const std::vector<Part>& parts, Execution& execution)
{
  std::vector<std::size_t> side;
  std::vector<std::size_t> face;
  std::vector<std::size_t> node;
  for (const Part& part : parts)
  {
    side.push_back(part.facesOfSide.size());
    face.push_back(part.faceSizes.size());
    node.push_back(part.nodes.size());
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
  execution.forEach(parts.size(), 1, [&](std::size_t i, std::size_t) {
    const Part& part = parts[i];
    std::copy(part.nodes.begin(), part.nodes.end(), result.nodes.begin() + std::ptrdiff_t(node[i]));
    std::size_t next = node[i];
    for (std::size_t f = 0; f < part.faceSizes.size(); ++f)
    {
      result.start[face[i] + f] = next;
      next += part.faceSizes[f];
    }
    next = face[i];
    for (std::size_t s = 0; s < part.facesOfSide.size(); ++s)
    {
      result.sideStart[side[i] + s] = next;
      result.flawed[side[i] + s] = part.flawed[s];
      next += part.facesOfSide[s];
    }
  });
  return result;
}

}

Nodes findNodes(const Boxes& boxes, const Patches& patches, const Sides& sides, Execution& execution)
{
  const std::size_t count = sides.intersected.size();
  std::vector<std::vector<PointUse>> uses(chunks(count, BoxesAChunk));
  execution.forEach(count, BoxesAChunk, [&](std::size_t begin, std::size_t end) {
    auto& use = uses[begin / BoxesAChunk];
    for (std::size_t n = begin; n < end; ++n)
    {
      const Box& box = boxes.boxes[sides.intersected[n]];
      for (unsigned corner = 0; corner < 8; ++corner)
      {
        const Point p = cornerOf(box, corner);
        use.push_back({ p, rowOfPoint(p, boxes.planes, box.global[1], box.global[2]),
          static_cast<std::uint32_t>(8 * n + corner) });
      }
    }
  });
  Numbering numbering = numberPoints(uses, pointRows(boxes.planes), execution);
  Nodes nodes;
  nodes.patchPoints = patches.points.size();
  nodes.at = patches.points;
  nodes.at.insert(nodes.at.end(), numbering.points.begin(), numbering.points.end());
  nodes.rowStart.swap(numbering.rowStart);
  nodes.ofBox.resize(count);
  for (std::size_t n = 0; n < count; ++n)
  {
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      nodes.ofBox[n][corner] =
        static_cast<std::uint32_t>(nodes.patchPoints + numbering.ofSlot[8 * n + corner]);
    }
  }
  return nodes;
}

InnerFaces generateInnerFaces(const Boxes& boxes, const Patches& patches, const Sides& sides,
  const Nodes& nodes, Execution& execution)
{
  const std::size_t count = sides.intersected.size();
  std::vector<Part> parts(chunks(count, BoxesAChunk));
  execution.forEach(count, BoxesAChunk, [&](std::size_t begin, std::size_t end) {
    SideBuilder builder(boxes, patches, sides, nodes);
    for (std::size_t n = begin; n < end; ++n)
    {
      builder.addSidesOf(n, parts[begin / BoxesAChunk]);
    }
  });
  return join(parts, execution);
}

}
