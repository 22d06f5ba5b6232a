// SPDX-License-Identifier: BSD-3-Clause
#include "Sections/PeriodicFaces.h"

#include "Base/Error.h"
#include "Sections/FoldedPolygons.h"
#include "Sections/OutlineFitting.h"
#include "Sections/PlaneOverlay.h"
#include "Sections/SidePlane.h"

#include <algorithm>
#include <map>

namespace cartesian
{

namespace
{

// The polygons of a side, and the mesh's points of theirs.
struct PlaneSide
{
  PlanePolygons polygons;
  std::vector<std::uint32_t> pointOf;
};

// In the order of `faces`; turned: seen from inside.
template <class PlaceOf>
PlaneSide planeSide(const CellFaces& cells, const std::vector<std::size_t>& faces, bool isTurned,
  const PlaceOf& placeOf)
{
  PlaneSide side;
  for (const std::size_t face : faces)
  {
    for (std::size_t i = cells.firstCorner[face]; i < cells.firstCorner[face + 1]; ++i)
    {
      side.pointOf.push_back(cells.corners[i]);
    }
  }
  std::sort(side.pointOf.begin(), side.pointOf.end());
  side.pointOf.erase(std::unique(side.pointOf.begin(), side.pointOf.end()), side.pointOf.end());
  for (const std::uint32_t point : side.pointOf)
  {
    side.polygons.points.push_back(placeOf(point));
  }
  for (const std::size_t face : faces)
  {
    auto& corners = side.polygons.corners;
    const auto first = static_cast<std::ptrdiff_t>(corners.size());
    for (std::size_t i = cells.firstCorner[face]; i < cells.firstCorner[face + 1]; ++i)
    {
      corners.push_back(static_cast<std::uint32_t>(
        std::lower_bound(side.pointOf.begin(), side.pointOf.end(), cells.corners[i]) -
        side.pointOf.begin()));
    }
    if (isTurned)
    {
      std::reverse(corners.begin() + first, corners.end());
    }
    side.polygons.firstCorner.push_back(corners.size());
  }
  return side;
}

class SideMatching
{
public:
  SideMatching(const CellFaces& cells, const std::vector<double>& points,
    const std::array<std::vector<std::size_t>, 2>& sides, const SideMotion& motion)
    : cells_(cells)
    , sides_(sides)
    , motion_(motion)
    , plane_(cells, sides[0], points)
  {
    result_.points = points;
    isOnSide_.resize(points.size() / 3);
  }

  PeriodicFaces run(FacesOfPair which)
  {
    ofSide_[0] = planeSide(
      cells_, sides_[0], false, [&](std::uint32_t p) { return plane_.placeOf(point(p)); });
    ofSide_[1] = planeSide(cells_, sides_[1], true,
      [&](std::uint32_t p) { return plane_.placeOf(motion_.before(point(p))); });
    if (which == FacesOfPair::Own)
    {
      plane_.pointBeside() ? void() : fit();
    }
    else
    {
      requireFlat();
      unfoldSides();
      overlay_ = overlay(ofSide_[0].polygons, ofSide_[1].polygons);
      requireMatch();
      placeVertices();
      listChains();
      listParts();
    }
    writeCells();
    return std::move(result_);
  }

private:
  Vector point(std::size_t p) const
  {
    return { result_.points[3 * p], result_.points[3 * p + 1], result_.points[3 * p + 2] };
  }

  void place(std::size_t p, const Vector& at)
  {
    std::copy(at.begin(), at.end(), result_.points.begin() + 3 * static_cast<std::ptrdiff_t>(p));
  }

  std::uint32_t addPoint(const Vector& at)
  {
    result_.points.insert(result_.points.end(), at.begin(), at.end());
    return static_cast<std::uint32_t>(result_.points.size() / 3 - 1);
  }

  // Layers at a corner may have made faces that cross themselves, which no overlay can divide.
  void unfoldSides()
  {
    unfold(ofSide_[1].polygons);
    for (const std::uint32_t p : unfold(ofSide_[0].polygons))
    {
      place(ofSide_[0].pointOf[p], plane_.pointAt(ofSide_[0].polygons.points[p]));
    }
  }

  void requireFlat() const
  {
    if (const std::optional<Vector>& at = plane_.pointBeside())
    {
      throw Error(Fault::BadMesh,
        "the first is not flat at (" + number((*at)[0]) + ", " + number((*at)[1]) + ", " +
          number((*at)[2]) + "), as both must be to have the same faces. Choose Faces Own.");
    }
  }

  void requireMatch() const
  {
    double area = 0;
    for (const std::size_t face : sides_[0])
    {
      area += norm(doubledArea(cells_, face, result_.points)) / 2;
    }
    if (overlay_.unmatched > PeriodicSpec::Unmatched * area)
    {
      const Vector at = plane_.pointAt(overlay_.unmatchedAt);
      throw Error(Fault::BadMesh,
        "they differ by an area of " + number(overlay_.unmatched) + ", most of it at (" +
          number(at[0]) + ", " + number(at[1]) + ", " + number(at[2]) +
          ") on the first. What goes through one must go through the other at the same place, in "
          "boxes of the same size (Periodic Sides of Cartesian Mesher).");
    }
  }

  // The mesh's points at each vertex of the overlay, on both sides.
  void placeVertices()
  {
    for (const PlaneOverlay::Vertex& vertex : overlay_.vertices)
    {
      std::array<std::uint32_t, 2> points{};
      points[0] = vertex.point[0] == PlaneOverlay::NoPoint ? addPoint(plane_.pointAt(vertex.at))
                                                           : ofSide_[0].pointOf[vertex.point[0]];
      const Vector beyond = motion_.of(point(points[0]));
      const double aside = norm(minus(beyond, point(points[0])));
      if (vertex.point[1] != PlaneOverlay::NoPoint)
      {
        points[1] = ofSide_[1].pointOf[vertex.point[1]];
        if (points[1] != points[0])
        {
          moveTo(points[1], beyond);
        }
      }
      else
      {
        // On the axis both sides have the same points.
        points[1] = aside > PeriodicSpec::Same * plane_.size() ? addPoint(beyond) : points[0];
      }
      pointsAt_.push_back(points);
    }
  }

  void moveTo(std::uint32_t p, const Vector& to)
  {
    result_.farthest = std::max(result_.farthest, norm(minus(to, point(p))));
    place(p, to);
  }

  // The second side's outline onto the first's.
  void fit()
  {
    const FittedOutline fitted = fitOutline(ofSide_[0].polygons, ofSide_[1].polygons);
    const std::vector<PlanePlace>& before = ofSide_[1].polygons.points;
    const std::vector<PlanePlace>& after = fitted.polygons.points;
    std::vector<std::uint32_t>& pointOf = ofSide_[1].pointOf;
    for (std::size_t p = 0; p < after.size(); ++p)
    {
      const Vector to = motion_.of(plane_.pointAt(after[p]));
      if (p >= before.size())
      {
        pointOf.push_back(addPoint(to));
      }
      else if (after[p] != before[p])
      {
        moveTo(pointOf[p], to);
      }
    }
    for (const auto& [ends, inserted] : fitted.inserted)
    {
      std::vector<std::uint32_t>& points = chains_[{ pointOf[ends[0]], pointOf[ends[1]] }];
      for (const std::uint32_t p : inserted)
      {
        points.push_back(pointOf[p]);
      }
      isOnSide_[pointOf[ends[0]]] = isOnSide_[pointOf[ends[1]]] = true;
    }
  }

  void listChains()
  {
    for (std::size_t k = 0; k < 2; ++k)
    {
      for (const std::uint32_t p : ofSide_[k].pointOf)
      {
        isOnSide_[p] = true;
      }
      for (const PlaneOverlay::Chain& chain : overlay_.chains[k])
      {
        if (chain.vertices.empty())
        {
          continue;
        }
        std::vector<std::uint32_t> points;
        for (const std::uint32_t vertex : chain.vertices)
        {
          points.push_back(pointsAt_[vertex][k]);
        }
        const std::uint32_t a = ofSide_[k].pointOf[chain.ends[0]];
        const std::uint32_t b = ofSide_[k].pointOf[chain.ends[1]];
        chains_.emplace(std::array{ a, b }, points); // a is less than b, as on the side
      }
    }
  }

  // The polygons of the overlay that each face of a side becomes.
  void listParts()
  {
    for (std::size_t k = 0; k < 2; ++k)
    {
      for (std::uint32_t i = 0; i < sides_[k].size(); ++i)
      {
        parts_[sides_[k][i]] = { k, {} };
      }
      for (std::size_t polygon = 0; polygon < overlay_.polygons.size(); ++polygon)
      {
        const std::uint32_t of = overlay_.polygons[polygon].of[k];
        parts_[sides_[k][of]].polygons.push_back(polygon);
      }
    }
    result_.pairs.resize(overlay_.polygons.size());
  }

  void writeCells()
  {
    CellFaces& all = result_.cells;
    for (std::size_t cell = 0; cell < cells_.cellCount(); ++cell)
    {
      all.firstFace.push_back(all.firstCorner.size());
      for (std::size_t f = cells_.firstFace[cell]; f < cells_.firstFace[cell + 1]; ++f)
      {
        const auto parts = parts_.find(f);
        if (parts == parts_.end())
        {
          writeFace(f);
          continue;
        }
        for (const std::size_t polygon : parts->second.polygons)
        {
          writePart(f, parts->second.side, polygon);
        }
      }
    }
    all.firstFace.push_back(all.firstCorner.size());
    all.firstCorner.push_back(all.corners.size());
  }

  void writeFace(std::size_t face)
  {
    startFace(face);
    const std::size_t begin = cells_.firstCorner[face];
    const std::size_t end = cells_.firstCorner[face + 1];
    for (std::size_t i = begin; i < end; ++i)
    {
      const std::uint32_t a = cells_.corners[i];
      const std::uint32_t b = cells_.corners[i + 1 < end ? i + 1 : begin];
      result_.cells.corners.push_back(a);
      if (!isOnSide_[a] || !isOnSide_[b])
      {
        continue;
      }
      const auto chain = chains_.find({ std::min(a, b), std::max(a, b) });
      if (chain != chains_.end())
      {
        std::vector<std::uint32_t> points = chain->second;
        if (a > b)
        {
          std::reverse(points.begin(), points.end());
        }
        for (const std::uint32_t p : points)
        {
          result_.cells.corners.push_back(p);
        }
      }
    }
  }

  void startFace(std::size_t source)
  {
    result_.cells.firstCorner.push_back(result_.cells.corners.size());
    result_.source.push_back(source);
  }

  void writePart(std::size_t face, std::size_t side, std::size_t polygon)
  {
    result_.pairs[polygon][side] = result_.source.size();
    startFace(face);
    const std::size_t begin = overlay_.polygons[polygon].firstCorner;
    const std::size_t end = polygon + 1 < overlay_.polygons.size()
      ? overlay_.polygons[polygon + 1].firstCorner
      : overlay_.corners.size();
    for (std::size_t i = 0; i < end - begin; ++i)
    {
      const std::size_t corner = side == 0 || i == 0 ? begin + i : end - i;
      result_.cells.corners.push_back(pointsAt_[overlay_.corners[corner]][side]);
    }
  }

  struct Parts
  {
    std::size_t side;
    std::vector<std::size_t> polygons;
  };

  const CellFaces& cells_;
  const std::array<std::vector<std::size_t>, 2>& sides_;
  const SideMotion& motion_;
  const SidePlane plane_; // of the first
  std::array<PlaneSide, 2> ofSide_;
  PlaneOverlay overlay_;
  std::vector<std::array<std::uint32_t, 2>> pointsAt_;
  std::vector<bool> isOnSide_; // of the mesh's points: other edges get none
  std::map<std::array<std::uint32_t, 2>, std::vector<std::uint32_t>>
    chains_;                           // points that edges get, by their ends
  std::map<std::size_t, Parts> parts_; // by faces of the sides
  PeriodicFaces result_;
};

}

PeriodicFaces matchSides(const CellFaces& cells, const std::vector<double>& points,
  const std::array<std::vector<std::size_t>, 2>& sides, const SideMotion& motion, FacesOfPair which)
{
  return SideMatching(cells, points, sides, motion).run(which);
}

}
