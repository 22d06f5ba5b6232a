// SPDX-License-Identifier: BSD-3-Clause
#include "Sections/CellDivision.h"

#include "Base/Sorting.h"
#include "Polyhedra/CellGeometry.h"
#include "Sections/StarPoint.h"

#include <algorithm>
#include <numeric>

namespace cartesian
{

namespace
{

constexpr std::size_t CellsAChunk = 512;
constexpr std::size_t FacesAChunk = 2048;

// A face with a fan, by its three lowest points: faces of the same corners have these in common.
struct NamedFan
{
  std::array<std::uint32_t, 3> lowest;
  std::uint32_t face;

  bool operator<(const NamedFan& other) const
  {
    return lowest != other.lowest ? lowest < other.lowest : face < other.face;
  }
};

class Faces
{
public:
  Faces(const CellFaces& cells, const double* points)
    : cells_(cells)
    , points_(points)
  {
  }

  std::size_t size(std::size_t face) const
  {
    return cells_.firstCorner[face + 1] - cells_.firstCorner[face];
  }
  std::uint32_t id(std::size_t face, std::size_t i) const
  {
    return cells_.corners[cells_.firstCorner[face] + i];
  }
  Vector corner(std::size_t face, std::size_t i) const { return at(id(face, i)); }
  Vector at(std::uint32_t point) const
  {
    const double* p = points_ + 3 * std::size_t(point);
    return { p[0], p[1], p[2] };
  }

  bool hasFan(std::size_t face) const
  {
    if (size(face) != 4)
    {
      return size(face) > 4;
    }
    return !staysWhole({ corner(face, 0), corner(face, 1), corner(face, 2), corner(face, 3) },
      { id(face, 0), id(face, 1), id(face, 2), id(face, 3) });
  }

  NamedFan named(std::size_t face) const
  {
    NamedFan result{ { NoPoint, NoPoint, NoPoint }, static_cast<std::uint32_t>(face) };
    for (std::size_t i = 0; i < size(face); ++i)
    {
      std::uint32_t point = id(face, i);
      for (std::uint32_t& lowest : result.lowest)
      {
        if (point < lowest)
        {
          std::swap(point, lowest);
        }
      }
    }
    return result;
  }

  // Whether two faces have the same corners, in the same or the opposite order.
  bool areSame(std::size_t a, std::size_t b) const
  {
    const std::size_t count = size(a);
    if (size(b) != count)
    {
      return false;
    }
    for (std::size_t shift = 0; shift < count; ++shift)
    {
      bool same = true;
      bool opposite = true;
      for (std::size_t i = 0; i < count && (same || opposite); ++i)
      {
        same = same && id(a, i) == id(b, (shift + i) % count);
        opposite = opposite && id(a, i) == id(b, (shift + count - i) % count);
      }
      if (same || opposite)
      {
        return true;
      }
    }
    return false;
  }

  FaceGeometry geometry(std::size_t face) const
  {
    return measureFace(size(face), [&](std::size_t i) { return corner(face, i); });
  }

private:
  const CellFaces& cells_;
  const double* points_;
};

class Divider
{
public:
  Divider(const CellFaces& cells, const double* points, Execution& execution)
    : cells_(cells)
    , faces_(cells, points)
    , execution_(execution)
  {
  }

  CellDivision divide()
  {
    result_.fanOf.assign(cells_.faceCount(), NoPoint);
    findFans();
    findFacePlaces();
    findCentres();
    return std::move(result_);
  }

private:
  void findFans()
  {
    std::vector<std::vector<NamedFan>> found(chunks(cells_.faceCount(), FacesAChunk));
    execution_.nextLoop(0.2);
    execution_.forEach(cells_.faceCount(), FacesAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t face = begin; face < end; ++face)
      {
        if (faces_.hasFan(face))
        {
          found[begin / FacesAChunk].push_back(faces_.named(face));
        }
      }
    });
    std::vector<NamedFan> fans = concatenated(found);
    SampleSort<NamedFan>(fans.data(), fans.size(), execution_).run();
    for (auto begin = fans.begin(); begin != fans.end();)
    {
      const auto end = std::find_if(
        begin, fans.end(), [&](const NamedFan& fan) { return fan.lowest != begin->lowest; });
      unite(begin, end);
      begin = end;
    }
  }

  // Each fan has the place of the first that is the same face.
  void unite(std::vector<NamedFan>::iterator begin, std::vector<NamedFan>::iterator end)
  {
    for (auto a = begin; a != end; ++a)
    {
      std::uint32_t& place = result_.fanOf[a->face];
      const auto same = std::find_if(
        begin, a, [&](const NamedFan& before) { return faces_.areSame(before.face, a->face); });
      if (same != a)
      {
        place = result_.fanOf[same->face];
        continue;
      }
      place = static_cast<std::uint32_t>(result_.facePlaces.size());
      result_.facePlaces.push_back(a->face);
    }
  }

  void findFacePlaces()
  {
    const std::size_t count = result_.facePlaces.size();
    result_.places.resize(count + cells_.cellCount());
    execution_.forEach(count, FacesAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        result_.places[i] = faces_.geometry(result_.facePlaces[i]).centre;
      }
    });
  }

  void findCentres()
  {
    const std::size_t cells = cells_.cellCount();
    const std::size_t before = result_.facePlaces.size();
    result_.centre.resize(cells);
    std::iota(result_.centre.begin(), result_.centre.end(), static_cast<std::uint32_t>(before));
    result_.inverts.resize(cells);
    std::vector<std::size_t> moved(chunks(cells, CellsAChunk));
    execution_.nextLoop(0.5);
    execution_.forEach(cells, CellsAChunk, [&](std::size_t begin, std::size_t end) {
      std::vector<FaceGeometry> measured;
      for (std::size_t cell = begin; cell < end; ++cell)
      {
        const std::size_t first = cells_.firstFace[cell];
        measured.clear();
        for (std::size_t face = first; face < cells_.firstFace[cell + 1]; ++face)
        {
          measured.push_back(faces_.geometry(face));
        }
        Vector& centre = result_.places[before + cell];
        centre = measureCell(measured.size(), [&](std::size_t i) -> const FaceGeometry& {
          return measured[i];
        }).centre;
        if (!seesAll(cell, centre))
        {
          const bool isMoved = move(cell, centre);
          moved[begin / CellsAChunk] += isMoved ? 1 : 0;
          result_.inverts[cell] = isMoved ? 0 : 1;
        }
      }
    });
    result_.moved = std::accumulate(moved.begin(), moved.end(), std::size_t(0));
  }

  // Calls visit(p, q, r) for the triangles of a cell's sides, counter-clockwise from outside; of a whole quadrilateral one.
  template <class Visitor>
  void forEachTriangle(std::size_t cell, Visitor&& visit) const
  {
    for (std::size_t face = cells_.firstFace[cell]; face < cells_.firstFace[cell + 1]; ++face)
    {
      const std::uint32_t fan = result_.fanOf[face];
      if (fan == NoPoint)
      {
        visit(faces_.corner(face, 0), faces_.corner(face, 1), faces_.corner(face, 2));
        continue;
      }
      const std::size_t size = faces_.size(face);
      for (std::size_t i = 0; i < size; ++i)
      {
        visit(faces_.corner(face, i), faces_.corner(face, (i + 1) % size), result_.places[fan]);
      }
    }
  }

  bool seesAll(std::size_t cell, const Vector& from) const
  {
    bool sees = true;
    forEachTriangle(cell, [&](const Vector& p, const Vector& q, const Vector& r) {
      sees = sees && dot(cross(minus(q, p), minus(r, p)), minus(p, from)) > 0;
    });
    return sees;
  }

  // To the point that sees all triangles best, if there is one.
  bool move(std::size_t cell, Vector& centre) const
  {
    std::vector<HalfSpace> spaces;
    double size = 0;
    forEachTriangle(cell, [&](const Vector& p, const Vector& q, const Vector& r) {
      const Vector outward = unit(cross(minus(q, p), minus(r, p)));
      spaces.push_back({ outward, dot(outward, p) });
      for (const Vector& corner : { p, q, r })
      {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          size = std::max(size, std::abs(corner[axis] - centre[axis]));
        }
      }
    });
    const std::optional<Vector> better = size > 0 ? starPoint(spaces, centre, size) : std::nullopt;
    if (!better || !seesAll(cell, *better))
    {
      return false;
    }
    centre = *better;
    return true;
  }

  const CellFaces& cells_;
  Faces faces_;
  Execution& execution_;
  CellDivision result_;
};

struct Term
{
  std::uint32_t point;
  double weight;

  bool operator<(const Term& other) const { return point < other.point; }
};

// Terms of one point are added.
void merge(std::vector<Term>& terms)
{
  std::stable_sort(terms.begin(), terms.end());
  auto last = terms.begin();
  for (auto term = terms.begin(); term != terms.end(); ++term)
  {
    if (term == terms.begin())
    {
      continue;
    }
    if (term->point == last->point)
    {
      last->weight += term->weight;
    }
    else
    {
      *++last = *term;
    }
  }
  terms.erase(terms.empty() ? terms.end() : last + 1, terms.end());
}

class Summing
{
public:
  Summing(const CellDivision& division, const CellFaces& cells, const double* points)
    : division_(division)
    , cells_(cells)
    , faces_(cells, points)
  {
  }

  void find(std::size_t place, std::vector<Term>& terms)
  {
    terms.clear();
    if (place < division_.facePlaces.size())
    {
      addFace(division_.facePlaces[place], 1, terms);
      merge(terms);
      return;
    }
    addCell(place - division_.facePlaces.size(), terms);
    merge(terms);
    correct(division_.places[place], terms);
  }

private:
  // That of measureFace: a third of the corners' mean, and of each star triangle its two corners by its area.
  void addFace(std::size_t face, double factor, std::vector<Term>& terms)
  {
    const std::size_t size = faces_.size(face);
    if (size == 3)
    {
      for (std::size_t i = 0; i < size; ++i)
      {
        terms.push_back({ faces_.id(face, i), factor / 3 });
      }
      return;
    }
    areas_.clear();
    double sum = 0;
    forEachStarTriangle(
      size, [&](std::size_t i) { return faces_.corner(face, i); },
      [&](const Vector&, const Vector&, const Vector& triangle) {
        areas_.push_back(norm(triangle));
        sum += areas_.back();
      });
    const auto count = static_cast<double>(size);
    for (std::size_t i = 0; i < size; ++i)
    {
      const double weight =
        sum < Tiny ? 1 / count : 1 / (3 * count) + (areas_[i] + areas_[(i + 1) % size]) / (3 * sum);
      terms.push_back({ faces_.id(face, i), factor * weight });
    }
  }

  // That of measureCell: a quarter of the faces' mean, and of each face's pyramid its face's centre by its volume.
  void addCell(std::size_t cell, std::vector<Term>& terms)
  {
    const std::size_t first = cells_.firstFace[cell];
    measured_.clear();
    for (std::size_t face = first; face < cells_.firstFace[cell + 1]; ++face)
    {
      measured_.push_back(faces_.geometry(face));
    }
    const auto count = static_cast<double>(measured_.size());
    Vector mean{};
    for (const FaceGeometry& face : measured_)
    {
      mean = plus(mean, scaled(face.centre, 1 / count));
    }
    double volume = 0;
    for (const FaceGeometry& face : measured_)
    {
      volume += dot(face.area, minus(face.centre, mean)) / 3;
    }
    for (std::size_t i = 0; i < measured_.size(); ++i)
    {
      const double part = dot(measured_[i].area, minus(measured_[i].centre, mean)) / 4;
      addFace(
        first + i, std::abs(volume) < Tiny ? 1 / count : 1 / (4 * count) + part / volume, terms);
    }
  }

  // By the least change of the weights that puts the sum in its place: of a cell whose centre has moved.
  void correct(const Vector& place, std::vector<Term>& terms) const
  {
    Vector sum{};
    Vector mean{};
    for (const Term& term : terms)
    {
      const Vector at = faces_.at(term.point);
      sum = plus(sum, scaled(at, term.weight));
      mean = plus(mean, scaled(at, 1 / static_cast<double>(terms.size())));
    }
    std::array<Vector, 3> spread{};
    for (const Term& term : terms)
    {
      const Vector from = minus(faces_.at(term.point), mean);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        spread[axis] = plus(spread[axis], scaled(from, from[axis]));
      }
    }
    const Vector gap = minus(place, sum);
    const double determinant = dot(spread[0], cross(spread[1], spread[2]));
    if (!(std::abs(determinant) > Tiny))
    {
      return;
    }
    // The spread is symmetric: its rows are its columns.
    const Vector way =
      scaled(Vector{ dot(gap, cross(spread[1], spread[2])), dot(gap, cross(spread[2], spread[0])),
               dot(gap, cross(spread[0], spread[1])) },
        1 / determinant);
    for (Term& term : terms)
    {
      term.weight += dot(way, minus(faces_.at(term.point), mean));
    }
  }

  const CellDivision& division_;
  const CellFaces& cells_;
  Faces faces_;
  std::vector<double> areas_;
  std::vector<FaceGeometry> measured_;
};

}

bool staysWhole(const std::array<Vector, 4>& corners, const std::array<std::uint32_t, 4>& ids)
{
  // From the lowest corner towards its lower neighbour: then rounding is the same from both cells.
  const auto first =
    static_cast<std::size_t>(std::min_element(ids.begin(), ids.end()) - ids.begin());
  const std::size_t step = ids[(first + 1) % 4] < ids[(first + 3) % 4] ? 1 : 3;
  const Vector& a = corners[first];
  const Vector b = minus(corners[(first + step) % 4], a);
  const Vector c = minus(corners[(first + 2) % 4], a);
  const Vector d = minus(corners[(first + 3 * step) % 4], a);
  const Vector across = minus(d, b);
  const double size = std::sqrt(std::max(dot(c, c), dot(across, across)));
  const Vector normal = cross(c, across);
  if (!(std::abs(dot(d, cross(b, c))) <= FlatQuadrilateral * size * size * size))
  {
    return false;
  }
  const auto turnsWith = [&](const Vector& u, const Vector& v) {
    return dot(cross(u, v), normal) > 0;
  };
  return turnsWith(b, minus(c, b)) && turnsWith(minus(c, b), minus(d, c)) &&
    turnsWith(minus(d, c), scaled(d, -1)) && turnsWith(scaled(d, -1), b);
}

CellDivision divideCells(const CellFaces& cells, const double* points, Execution& execution)
{
  return Divider(cells, points, execution).divide();
}

PointSums sumsOf(
  const CellDivision& division, const CellFaces& cells, const double* points, Execution& execution)
{
  constexpr std::size_t PlacesAChunk = 1024;
  const std::size_t count = division.places.size();
  std::vector<std::vector<Term>> terms(chunks(count, PlacesAChunk));
  PointSums sums;
  sums.first.assign(count + 1, 0);
  execution.forEach(count, PlacesAChunk, [&](std::size_t begin, std::size_t end) {
    Summing summing(division, cells, points);
    std::vector<Term> found;
    for (std::size_t place = begin; place < end; ++place)
    {
      summing.find(place, found);
      sums.first[place] = found.size();
      std::vector<Term>& all = terms[begin / PlacesAChunk];
      all.insert(all.end(), found.begin(), found.end());
    }
  });
  const std::size_t total = scan(sums.first);
  sums.point.reserve(total);
  sums.weight.reserve(total);
  for (const std::vector<Term>& part : terms)
  {
    for (const Term& term : part)
    {
      sums.point.push_back(term.point);
      sums.weight.push_back(term.weight);
    }
  }
  return sums;
}

}
