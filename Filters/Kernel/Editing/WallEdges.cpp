// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/WallEdges.h"

#include "Base/Rings.h"
#include "Editing/EditDecision.h"
#include "Editing/PrimitiveEdits.h"
#include "Lattice/NearestPlace.h"

#include <cmath>
#include <limits>

namespace cartesian
{

namespace
{

bool areOnEdges(const MeshView& mesh, std::uint32_t u, std::uint32_t v)
{
  return mesh.node(u).kind >= NodeKind::OnEdge && mesh.node(v).kind >= NodeKind::OnEdge;
}

// Calls visit(p, q) for edges of the one that the other has in reverse.
template <class Visitor>
void forEachShared(const MeshView& mesh, std::uint32_t f, std::uint32_t g, Visitor&& visit)
{
  const Items a = mesh.cornersOf(f);
  const Items b = mesh.cornersOf(g);
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    const std::uint32_t p = a[i];
    const std::uint32_t q = following(a, i);
    const std::size_t j = placeOf(b, q);
    if (j < b.size() && following(b, j) == p)
    {
      visit(p, q);
    }
  }
}

bool isEdgeAt(Items ring, std::size_t i, std::uint32_t v)
{
  return following(ring, i) == v || preceding(ring, i) == v;
}

double squareToTriangle(const Vector& p, const Vector& a, const Vector& b, const Vector& c)
{
  const Vector away = minus(p, nearestPlace(a, b, c, p));
  return dot(away, away);
}

// The square of the distance to the triangles around a face's centre, up to `enough`.
template <class Corner>
double squareToStar(
  const Vector& p, const Vector& centre, std::size_t size, Corner&& corner, double enough)
{
  if (size == 3)
  {
    return squareToTriangle(p, corner(0), corner(1), corner(2));
  }
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < size && least > enough; ++i)
  {
    least = std::min(least, squareToTriangle(p, centre, corner(i), corner((i + 1) % size)));
  }
  return least;
}

// What changed of the wall since a mark.
class ChangedWalls
{
public:
  ChangedWalls(const MeshEditor& mesh, const MeshEditor::Mark& mark)
    : mesh_(mesh)
  {
    collectFaces(mark);
    if (hasChanged_)
    {
      collectBeside();
      collectNodes(mark);
    }
  }

  double distance() const
  {
    if (!hasChanged_)
    {
      return 0;
    }
    if (isShort_)
    {
      return std::numeric_limits<double>::infinity();
    }
    if (now_.empty() && beside_.empty())
    {
      return extent();
    }
    double worst = 0;
    for (const Vector& p : points_)
    {
      worst = std::max(worst, squareTo(p, worst));
    }
    for (std::size_t i = 0; i < now_.size() && !before_.empty(); ++i)
    {
      worst = std::max(worst, squareToBefore(mesh_.face(now_[i]).centre, worst));
    }
    for (std::size_t i = 0; i < fresh_.size() && !before_.empty(); ++i)
    {
      worst = std::max(worst, squareToBefore(mesh_.node(fresh_[i]).at, worst));
    }
    return std::sqrt(worst);
  }

private:
  template <class List, class Value>
  void keep(List& list, const Value& value)
  {
    isShort_ = !list.add(value) || isShort_;
  }

  static bool isWall(const EditFace& face) { return !face.gone && isSurface(face); }

  void collectFaces(const MeshEditor::Mark& mark)
  {
    const auto& records = mesh_.faceRecords();
    for (std::size_t i = mark.faceRecords; i < records.size(); ++i)
    {
      const auto& [f, was] = records[i];
      const EditFace& is = mesh_.face(f);
      const bool hasMoved = isWall(was) != isWall(is) || was.corners.first != is.corners.first ||
        was.centre != is.centre;
      if ((!isWall(was) && !isWall(is)) || !hasMoved || !MeshEditor::isOldest(was, mark.epochs))
      {
        continue;
      }
      hasChanged_ = true;
      if (isWall(is))
      {
        keep(now_, f);
      }
      if (isWall(was))
      {
        keep(points_, was.centre);
        keep(before_, i);
      }
    }
  }

  // Of walls by themselves, around next to nothing.
  double extent() const
  {
    double square = 0;
    for (const Vector& p : points_)
    {
      const Vector across = minus(p, points_[0]);
      square = std::max(square, dot(across, across));
    }
    return std::sqrt(square);
  }

  // Walls that are gone may lie on others that did not change: folds, when they close.
  void collectBeside()
  {
    for (const std::size_t record : before_)
    {
      const auto& [f, was] = mesh_.faceRecords()[record];
      if (isWall(mesh_.face(f)))
      {
        continue;
      }
      for (const std::uint32_t n : mesh_.itemsOf(was.corners))
      {
        for (const std::uint32_t g : mesh_.facesAround(n))
        {
          if (mesh_.isSurface(g) && !now_.contains(g) && !beside_.contains(g))
          {
            keep(beside_, g);
          }
        }
      }
    }
  }

  void collectNodes(const MeshEditor::Mark& mark)
  {
    const auto& records = mesh_.nodeRecords();
    for (std::size_t i = mark.nodeRecords; i < records.size(); ++i)
    {
      const auto& [n, was] = records[i];
      const EditNode& is = mesh_.node(n);
      if (was.atWall && !was.gone && (is.gone || is.at != was.at))
      {
        keep(points_, was.at);
      }
      if (is.atWall && !is.gone && (!was.atWall || was.gone) && !fresh_.contains(n))
      {
        keep(fresh_, n);
      }
    }
  }

  double squareTo(const Vector& p, double enough) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const auto* faces : { &now_, &beside_ })
    {
      for (std::size_t k = 0; k < faces->size() && least > enough; ++k)
      {
        const std::uint32_t f = (*faces)[k];
        least = std::min(least,
          squareToStar(
            p, mesh_.face(f).centre, mesh_.face(f).corners.size,
            [&](std::size_t i) -> const Vector& { return mesh_.corner(f, i); }, enough));
      }
    }
    return least;
  }

  // Corners are where they are now: those that moved are among `points_`.
  double squareToBefore(const Vector& p, double enough) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < before_.size() && least > enough; ++k)
    {
      const EditFace& was = mesh_.faceRecords()[before_[k]].second;
      const Items corners = mesh_.itemsOf(was.corners);
      least = std::min(least,
        squareToStar(
          p, was.centre, corners.size(),
          [&](std::size_t i) -> const Vector& { return mesh_.node(corners[i]).at; }, enough));
    }
    return least;
  }

  static constexpr std::size_t Most = 2 * MostFacesChanged; // and nodes

  const MeshEditor& mesh_;
  FixedList<std::uint32_t, Most> now_;
  FixedList<std::uint32_t, Most> beside_; // walls that did not change
  FixedList<std::size_t, Most> before_;   // records
  FixedList<Vector, Most> points_;
  FixedList<std::uint32_t, Most> fresh_; // nodes that were not at the wall
  bool hasChanged_ = false;
  bool isShort_ = false; // a list was full
};

}

WallEdge wallEdgeOf(const MeshView& mesh, std::uint32_t u, std::uint32_t v)
{
  std::array<const EditFace*, 2> sides{};
  std::array<bool, 2> isForward{}; // from u to v
  std::size_t count = 0;
  for (const std::uint32_t f : mesh.facesAround(u))
  {
    if (!mesh.isSurface(f))
    {
      continue;
    }
    const Items ring = mesh.cornersOf(f);
    const std::size_t i = placeOf(ring, u);
    if (isEdgeAt(ring, i, v))
    {
      const std::size_t side = std::min<std::size_t>(count, 1);
      sides[side] = &mesh.face(f);
      isForward[side] = following(ring, i) == v;
      ++count;
    }
  }
  // Of a wall between regions one face may look the other way.
  const auto cosine = [&] {
    return dot(unit(sides[0]->area), unit(sides[1]->area)) *
      (isForward[0] != isForward[1] ? 1 : -1);
  };
  const bool isSmooth = count == 2 && sides[0]->wall == sides[1]->wall &&
    !mesh.sharp().isSharp(cosine(), areOnEdges(mesh, u, v));
  return { count > 0, !isSmooth };
}

SharpEnds sharpEndsAt(const MeshView& mesh, std::uint32_t u)
{
  SharpEnds ends;
  for (const std::uint32_t f : mesh.facesAround(u))
  {
    const Items ring = mesh.cornersOf(f);
    const std::size_t i = placeOf(ring, u);
    for (const std::size_t beside : { (i + 1) % ring.size(), (i + ring.size() - 1) % ring.size() })
    {
      const std::uint32_t v = ring[beside];
      if (mesh.isSurface(f) && !ends.contains(v) && wallEdgeOf(mesh, u, v).isSharp)
      {
        ends.offer(v);
      }
    }
  }
  return ends;
}

double sharedLength(const MeshView& mesh, std::uint32_t f, std::uint32_t g)
{
  double length = 0;
  forEachShared(mesh, f, g, [&](std::uint32_t p, std::uint32_t q) {
    length += norm(minus(mesh.node(p).at, mesh.node(q).at));
  });
  return length;
}

double cosineBetween(const MeshView& mesh, std::uint32_t f, std::uint32_t g)
{
  const EditFace& one = mesh.face(f);
  const EditFace& other = mesh.face(g);
  const bool areAlike = one.below == other.below || (one.above != None && one.above == other.above);
  return dot(unit(one.area), unit(other.area)) * (areAlike ? 1 : -1);
}

double sharpnessBetween(const MeshView& mesh, std::uint32_t f, std::uint32_t g)
{
  if (!mesh.isSurface(f))
  {
    return 0;
  }
  bool isOnKnown = false;
  forEachShared(mesh, f, g,
    [&](std::uint32_t p, std::uint32_t q) { isOnKnown = isOnKnown || areOnEdges(mesh, p, q); });
  return mesh.sharp().sharpness(cosineBetween(mesh, f, g), isOnKnown);
}

bool areAdjacent(const MeshView& mesh, std::uint32_t f, std::uint32_t g)
{
  const Items b = mesh.cornersOf(g);
  int shared = 0;
  for (const std::uint32_t n : mesh.cornersOf(f))
  {
    shared += placeOf(b, n) < b.size() ? 1 : 0;
  }
  return shared >= 2;
}

double distanceToSegment(const Vector& p, const Vector& a, const Vector& b)
{
  const Vector ab = minus(b, a);
  const double square = dot(ab, ab);
  const double t = square > 0 ? std::clamp(dot(minus(p, a), ab) / square, 0.0, 1.0) : 0;
  return norm(minus(p, plus(a, scaled(ab, t))));
}

double distanceToFace(const MeshView& mesh, const Vector& p, std::uint32_t f)
{
  return std::sqrt(squareToStar(
    p, mesh.face(f).centre, mesh.face(f).corners.size,
    [&](std::size_t i) -> const Vector& { return mesh.corner(f, i); }, 0));
}

double distanceOfWalls(const MeshEditor& mesh, const MeshEditor::Mark& mark)
{
  return ChangedWalls(mesh, mark).distance();
}

}
