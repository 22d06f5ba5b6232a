#include "FaceList.h"

#include "Sorting.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t FacesAChunk = 4096;
constexpr std::size_t PointsAChunk = 1024;
constexpr Id NoFace = -1;

std::size_t at(Id id)
{
  return static_cast<std::size_t>(id);
}

struct Candidate
{
  Id leastPoint;
  Id face;

  bool operator<(const Candidate& other) const { return face < other.face; }
};

class Matcher
{
public:
  explicit Matcher(const CellFaces& faces)
    : faces_(faces)
  {
  }

  // The face on the other side of each, or NoFace.
  std::vector<Id> match(Id points, Execution& execution) const
  {
    std::vector<Id> partner(at(faces_.size()), NoFace);
    const Buckets<Candidate> byPoint = byLeastPoint(points, execution);
    execution.forEach(at(points), PointsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t point = begin; point < end; ++point)
      {
        matchAll(byPoint.begin(point), byPoint.end(point), partner);
      }
    });
    return partner;
  }

private:
  const Id* begin(Id face) const { return faces_.nodes.data() + faces_.start[at(face)]; }
  const Id* end(Id face) const { return faces_.nodes.data() + faces_.start[at(face) + 1]; }

  Buckets<Candidate> byLeastPoint(Id points, Execution& execution) const
  {
    std::vector<std::vector<Candidate>> candidates(chunks(at(faces_.size()), FacesAChunk));
    execution.forEach(at(faces_.size()), FacesAChunk, [&](std::size_t first, std::size_t last) {
      std::vector<Candidate>& mine = candidates[first / FacesAChunk];
      for (auto face = static_cast<Id>(first); face < static_cast<Id>(last); ++face)
      {
        if (begin(face) != end(face))
        {
          mine.push_back({ *std::min_element(begin(face), end(face)), face });
        }
      }
    });
    return sortIntoBuckets(
      candidates, at(points), [](const Candidate& c) { return at(c.leastPoint); }, execution);
  }

  void matchAll(const Candidate* first, const Candidate* last, std::vector<Id>& partner) const
  {
    for (; first != last; ++first)
    {
      for (const Candidate* other = first + 1; other != last && partner[at(first->face)] == NoFace;
           ++other)
      {
        if (partner[at(other->face)] == NoFace && opposite(first->face, other->face))
        {
          partner[at(first->face)] = other->face;
          partner[at(other->face)] = first->face;
        }
      }
    }
  }

  bool opposite(Id face, Id other) const
  {
    const auto size = end(face) - begin(face);
    if (end(other) - begin(other) != size || faces_.cell[at(face)] == faces_.cell[at(other)])
    {
      return false;
    }
    // A polygon may visit a point twice: every corner can be the one that they start from.
    for (auto shift = size; shift-- > 0;)
    {
      std::ptrdiff_t i = 0;
      while (i < size && begin(face)[i] == begin(other)[(2 * size - 1 - shift - i) % size])
      {
        ++i;
      }
      if (i == size)
      {
        return true;
      }
    }
    return false;
  }

  const CellFaces& faces_;
};

// Inner faces that cells own, in upper-triangular order, then all others.
std::vector<Id> orderOf(const CellFaces& faces, const std::vector<Id>& partner, Id& inner)
{
  std::vector<Id> order;
  const auto neighbour = [&](Id face) { return faces.cell[at(partner[at(face)])]; };
  Id last = 0;
  for (Id first = 0; first < faces.size(); first = last)
  {
    const auto owned = static_cast<std::ptrdiff_t>(order.size());
    for (; last < faces.size() && faces.cell[at(last)] == faces.cell[at(first)]; ++last)
    {
      if (partner[at(last)] != NoFace && faces.cell[at(last)] < neighbour(last))
      {
        order.push_back(last);
      }
    }
    std::stable_sort(order.begin() + owned, order.end(),
      [&](Id left, Id right) { return neighbour(left) < neighbour(right); });
  }
  inner = static_cast<Id>(order.size());
  for (Id face = 0; face < faces.size(); ++face)
  {
    if (partner[at(face)] == NoFace)
    {
      order.push_back(face);
    }
  }
  return order;
}

}

FaceList shareFaces(const CellFaces& faces, Id points, Execution& execution)
{
  const std::vector<Id> partner = Matcher(faces).match(points, execution);
  Id inner = 0;
  const std::vector<Id> order = orderOf(faces, partner, inner);
  FaceList list;
  list.owner.resize(order.size());
  list.neighbour.resize(at(inner));
  list.start.assign(order.size() + 1, 0);
  for (std::size_t f = 0; f < order.size(); ++f)
  {
    list.start[f + 1] = list.start[f] + faces.start[at(order[f]) + 1] - faces.start[at(order[f])];
  }
  list.nodes.resize(at(list.start.back()));
  execution.forEach(order.size(), FacesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f)
    {
      const Id* nodes = faces.nodes.data() + faces.start[at(order[f])];
      std::copy_n(nodes, list.start[f + 1] - list.start[f], list.nodes.begin() + list.start[f]);
      list.owner[f] = faces.cell[at(order[f])];
      if (f < list.neighbour.size())
      {
        list.neighbour[f] = faces.cell[at(partner[at(order[f])])];
      }
    }
  });
  return list;
}

}
