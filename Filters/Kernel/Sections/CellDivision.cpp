// SPDX-License-Identifier: BSD-3-Clause
#include "Sections/CellDivision.h"

#include "Sections/StarPoint.h"

#include <algorithm>
#include <numeric>

namespace cartesian
{

namespace
{

constexpr std::size_t CellsAChunk = 512;

// What programs cannot cut whole.
bool needsFan(const FaceCorners& corners, std::size_t face)
{
  if (corners.size(face) != 4)
  {
    return corners.size(face) > 4;
  }
  return !staysWhole({ corners.corner(face, 0), corners.corner(face, 1), corners.corner(face, 2),
                       corners.corner(face, 3) },
    { corners.id(face, 0), corners.id(face, 1), corners.id(face, 2), corners.id(face, 3) });
}

class Divider
{
public:
  Divider(const CellFaces& cells, const double* points, Execution& execution)
    : cells_(cells)
    , points_(points)
    , faces_(cells, points)
    , execution_(execution)
  {
  }

  CellDivision divide()
  {
    result_.fans = findFans(cells_, points_, needsFan, execution_);
    findCentres();
    return std::move(result_);
  }

private:
  void findCentres()
  {
    const std::size_t cells = cells_.cellCount();
    result_.centres.resize(cells);
    result_.inverts.resize(cells);
    std::vector<std::size_t> moved(chunks(cells, CellsAChunk));
    execution_.nextLoop(0.5);
    execution_.forEach(cells, CellsAChunk, [&](std::size_t begin, std::size_t end) {
      std::vector<FaceGeometry> measured;
      for (std::size_t cell = begin; cell < end; ++cell)
      {
        Vector& centre = result_.centres[cell];
        centre = faces_.geometryOfCell(cell, measured).centre;
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
      const std::uint32_t fan = result_.fans.fanOf[face];
      if (fan == NoPoint)
      {
        visit(faces_.corner(face, 0), faces_.corner(face, 1), faces_.corner(face, 2));
        continue;
      }
      const std::size_t size = faces_.size(face);
      for (std::size_t i = 0; i < size; ++i)
      {
        visit(
          faces_.corner(face, i), faces_.corner(face, (i + 1) % size), result_.fans.centres[fan]);
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
  const double* points_;
  FaceCorners faces_;
  Execution& execution_;
  CellDivision result_;
};

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
    if (place < division_.fans.count())
    {
      addFace(faces_, division_.fans.faces[place], 1, terms);
      merge(terms);
      return;
    }
    addCell(place - division_.fans.count(), terms);
    merge(terms);
    correct(division_.centres[place - division_.fans.count()], terms);
  }

private:
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
      addFace(faces_, first + i,
        std::abs(volume) < Tiny ? 1 / count : 1 / (4 * count) + part / volume, terms);
    }
  }

  // By the least change of the weights that puts the sum in its place: of a cell whose centre has moved.
  void correct(const Vector& place, std::vector<Term>& terms) const
  {
    Vector gap{};
    Vector mean{}; // relative to the place, for accuracy
    for (const Term& term : terms)
    {
      const Vector from = minus(faces_.at(term.point), place);
      gap = minus(gap, scaled(from, term.weight));
      mean = plus(mean, scaled(from, 1 / static_cast<double>(terms.size())));
    }
    std::array<Vector, 3> spread{};
    for (const Term& term : terms)
    {
      const Vector from = minus(minus(faces_.at(term.point), place), mean);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        spread[axis] = plus(spread[axis], scaled(from, from[axis]));
      }
    }
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
      term.weight += dot(way, minus(minus(faces_.at(term.point), place), mean));
    }
  }

  const CellDivision& division_;
  const CellFaces& cells_;
  FaceCorners faces_;
  std::vector<FaceGeometry> measured_;
};

}

CellDivision divideCells(const CellFaces& cells, const double* points, Execution& execution)
{
  return Divider(cells, points, execution).divide();
}

PointSums sumsOf(
  const CellDivision& division, const CellFaces& cells, const double* points, Execution& execution)
{
  return pointSums(division.fans.count() + division.centres.size(), execution, [&] {
    return [summing = Summing(division, cells, points)](
             std::size_t place, std::vector<Term>& terms) mutable { summing.find(place, terms); };
  });
}

}
