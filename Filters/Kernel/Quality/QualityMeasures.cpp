// SPDX-License-Identifier: BSD-3-Clause
#include "Quality/QualityMeasures.h"

#include "Base/Sorting.h"
#include "Polyhedra/CellEdges.h"
#include "Quality/CellMeasures.h"
#include "Quality/FaceCorners.h"
#include "Quality/FaceMeasures.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t ItemsAChunk = 512;

// The faces of each cell, beginning with those that it owns.
class FacesOfCells
{
public:
  FacesOfCells(const FaceList& list, std::size_t cells, Execution& execution)
  {
    const std::size_t owners = list.owner.size();
    faces_ = fillBuckets<std::size_t>(
      owners + list.neighbour.size(), ItemsAChunk, cells,
      [&](std::size_t begin, std::size_t end, auto&& add) {
        for (std::size_t i = begin; i < end; ++i)
        {
          if (i < owners)
          {
            add(list.owner[i], i);
          }
          else
          {
            add(list.neighbour[i - owners], (i - owners) | OfNeighbour);
          }
        }
      },
      execution);
  }

  std::size_t size(std::size_t cell) const { return faces_.start[cell + 1] - faces_.start[cell]; }
  std::size_t at(std::size_t cell, std::size_t i) const
  {
    return faces_.items[faces_.start[cell] + i] & ~OfNeighbour;
  }

private:
  static constexpr std::size_t OfNeighbour = std::size_t(1) << 63U;

  Buckets<std::size_t> faces_;
};

class Meter
{
public:
  Meter(const double* points, const CellFaces& cells, const FaceList& list, Execution& execution,
    const QualityLimits& limits, std::uint32_t leftOut)
    : faces_(cells, points)
    , list_(list)
    , of_(list, cells.cellCount(), execution)
    , execution_(execution)
    , limits_(limits)
    , leftOut_(leftOut)
  {
    quality_.cellGeometry.resize(cells.cellCount());
    quality_.faceGeometry.resize(list.owner.size());
    quality_.cellFailures.resize(cells.cellCount());
    quality_.faceFailures.resize(list.owner.size());
    for (std::size_t m = 0; m < MeasureCount; ++m)
    {
      quality_.cells[m].resize(cells.cellCount());
      quality_.faces[m].resize(MeasureSpecs[m].ofFaces ? list.owner.size() : 0);
    }
  }

  Quality run() &&
  {
    const std::size_t faces = list_.owner.size();
    const std::size_t cells = quality_.cellGeometry.size();
    execution_.nextLoop(0.2);
    execution_.forEach(faces, ItemsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f)
      {
        measureAlone(f);
      }
    });
    execution_.nextLoop(0.25);
    execution_.forEach(cells, ItemsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c)
      {
        quality_.cellGeometry[c] =
          measureCell(of_.size(c), [&](std::size_t i) { return outward(c, of_.at(c, i)); });
      }
    });
    execution_.nextLoop(0.4);
    execution_.forEach(faces, ItemsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f)
      {
        measureFaceBetween(f);
      }
    });
    execution_.nextLoop(1);
    execution_.forEach(cells, ItemsAChunk, [&](std::size_t begin, std::size_t end) {
      CellEdges edges;
      for (std::size_t c = begin; c < end; ++c)
      {
        measureCellOf(c, edges);
      }
    });
    return std::move(quality_);
  }

private:
  bool isWanted(Measure measure) const { return (leftOut_ >> measure & 1U) == 0; }
  bool isInner(std::size_t face) const { return face < list_.neighbour.size(); }
  std::size_t owner(std::size_t face) const { return list_.owner[face]; }
  std::size_t neighbour(std::size_t face) const { return list_.neighbour[face]; }
  std::size_t sizeOf(std::size_t face) const { return faces_.size(list_.face[face]); }
  std::uint32_t point(std::size_t face, std::size_t i) const
  {
    return faces_.id(list_.face[face], i);
  }
  Vector corner(std::size_t face, std::size_t i) const { return faces_.at(point(face, i)); }
  auto cornersOf(std::size_t face) const
  {
    return [this, face](std::size_t i) { return corner(face, i); };
  }

  FaceGeometry outward(std::size_t cell, std::size_t face) const
  {
    FaceGeometry geometry = quality_.faceGeometry[face];
    if (owner(face) != cell)
    {
      geometry.area = scaled(geometry.area, -1);
    }
    return geometry;
  }

  double angleIn(std::size_t cell, std::size_t face) const
  {
    return faceAngle(quality_.cellGeometry[cell], outward(cell, face));
  }

  // The worst of the tetrahedra between an edge of the face, the face centre and the cell centre.
  double tetQualityIn(std::size_t cell, std::size_t face) const
  {
    const FaceGeometry& geometry = quality_.faceGeometry[face];
    const double sign = owner(face) == cell ? 1 : -1;
    double worst = MeasureSpecs[TetQuality].best;
    for (std::size_t i = 0; isWanted(TetQuality) && i < sizeOf(face); ++i)
    {
      const Vector a = minus(corner(face, i), geometry.centre);
      const Vector b = minus(corner(face, i + 1 < sizeOf(face) ? i + 1 : 0), geometry.centre);
      const Vector c = minus(quality_.cellGeometry[cell].centre, geometry.centre);
      worst = std::min(worst, sign * tetQuality(a, b, c));
    }
    return worst;
  }

  // Quality of a tetrahedron with a corner at the origin; negative if abc run clockwise seen from there.
  static double tetQuality(const Vector& a, const Vector& b, const Vector& c)
  {
    const double sixfold = -dot(cross(a, b), c);
    if (std::abs(sixfold) < Tiny)
    {
      return 0;
    }
    const Vector towards = plus(scaled(cross(b, c), dot(a, a)),
      plus(scaled(cross(c, a), dot(b, b)), scaled(cross(a, b), dot(c, c))));
    const double radius = norm(towards) / (2 * std::abs(sixfold));
    const double regular = 8 / (9 * std::sqrt(3.0)) * radius * radius * radius;
    return sixfold / 6 / regular;
  }

  void measureAlone(std::size_t face)
  {
    if (!isWanted(StarTriangulation))
    {
      quality_.faceGeometry[face] = measureFace(sizeOf(face), cornersOf(face));
      setFace(face, StarTriangulation, MeasureSpecs[StarTriangulation].best);
      return;
    }
    const FaceMeasures<double> measures = measuresOfFace(sizeOf(face), cornersOf(face));
    quality_.faceGeometry[face] = { measures.centre, measures.area };
    setFace(face, StarTriangulation, measures.star);
  }

  // Of the line along `d` from the owner's centre.
  double skewnessOf(std::size_t face, const Vector& d, double partOfWay) const
  {
    const FaceGeometry& geometry = quality_.faceGeometry[face];
    const Vector way = minus(geometry.centre, quality_.cellGeometry[owner(face)].centre);
    const double along = dot(geometry.area, way) / (dot(geometry.area, d) + Tiny);
    return skewness(sizeOf(face), cornersOf(face), geometry.centre, minus(way, scaled(d, along)),
      partOfWay * norm(d));
  }

  void setFace(std::size_t face, Measure measure, double value)
  {
    quality_.faces[measure][face] = value;
    quality_.faceFailures[face] |= fails(measure, value, limits_) ? 1u << measure : 0u;
  }

  void measureFaceBetween(std::size_t face)
  {
    const FaceGeometry& geometry = quality_.faceGeometry[face];
    const double ownerAngle = angleIn(owner(face), face);
    const double ownerTet = tetQualityIn(owner(face), face);
    if (!isInner(face))
    {
      // The shortest line to the plane of the face; the other measures have their best values.
      const Vector normal = scaled(geometry.area, 1 / (norm(geometry.area) + Tiny));
      const Vector way = minus(geometry.centre, quality_.cellGeometry[owner(face)].centre);
      setFace(face, Skewness, skewnessOf(face, scaled(normal, dot(normal, way)), ShareOfHeight));
      setFace(face, BoundaryAngle, ownerAngle);
      setFace(face, TetQuality, ownerTet);
      for (const Measure m : { InnerAngle, NonOrthogonality, FaceWeight, VolumeRatio })
      {
        setFace(face, m, MeasureSpecs[m].best);
      }
      return;
    }
    const CellGeometry& low = quality_.cellGeometry[owner(face)];
    const CellGeometry& high = quality_.cellGeometry[neighbour(face)];
    const Vector d = minus(high.centre, low.centre);
    setFace(face, BoundaryAngle, MeasureSpecs[BoundaryAngle].best);
    setFace(face, InnerAngle, std::max(ownerAngle, angleIn(neighbour(face), face)));
    setFace(face, NonOrthogonality, angle(d, geometry.area));
    setFace(face, Skewness, skewnessOf(face, d, ShareOfDistance));
    const double toLow = std::abs(dot(geometry.area, minus(geometry.centre, low.centre)));
    const double toHigh = std::abs(dot(geometry.area, minus(geometry.centre, high.centre)));
    setFace(face, FaceWeight, std::min(toLow, toHigh) / (toLow + toHigh + Tiny));
    setFace(face, VolumeRatio,
      std::min(low.volume, high.volume) / (std::max(low.volume, high.volume) + Tiny));
    setFace(face, TetQuality, std::min(ownerTet, tetQualityIn(neighbour(face), face)));
  }

  void setCell(std::size_t cell, Measure measure, double value)
  {
    quality_.cells[measure][cell] = value;
    quality_.cellFailures[cell] |= fails(measure, value, limits_) ? 1u << measure : 0u;
  }

  void measureCellOf(std::size_t cell, CellEdges& edges)
  {
    if (of_.size(cell) == 0)
    {
      for (auto& values : quality_.cells)
      {
        values[cell] = std::numeric_limits<double>::quiet_NaN();
      }
      return;
    }
    setWorstOfFaces(cell);
    setSums(cell);
    setEdges(cell, edges);
  }

  template <class Visitor>
  void forEachFace(std::size_t cell, Visitor&& visit) const
  {
    for (std::size_t i = 0; i < of_.size(cell); ++i)
    {
      visit(of_.at(cell, i));
    }
  }

  void setWorstOfFaces(std::size_t cell)
  {
    for (const Measure m :
      { StarTriangulation, NonOrthogonality, Skewness, FaceWeight, VolumeRatio })
    {
      double worst = MeasureSpecs[m].best;
      forEachFace(cell, [&](std::size_t face) {
        const double value = quality_.faces[m][face];
        worst = MeasureSpecs[m].largeIsWorse ? std::max(worst, value) : std::min(worst, value);
      });
      setCell(cell, m, worst);
    }
    // Of these measures, only the cell's own side counts.
    std::array<double, 2> angles{ MeasureSpecs[BoundaryAngle].best, MeasureSpecs[InnerAngle].best };
    double tet = MeasureSpecs[TetQuality].best;
    forEachFace(cell, [&](std::size_t face) {
      double& worst = angles[isInner(face)];
      worst = std::max(worst, angleIn(cell, face));
      tet = std::min(tet, tetQualityIn(cell, face));
    });
    setCell(cell, BoundaryAngle, angles[0]);
    setCell(cell, InnerAngle, angles[1]);
    setCell(cell, TetQuality, tet);
  }

  // Measures that are sums over face vectors.
  void setSums(std::size_t cell)
  {
    AreaSums all;
    DeterminantOfCell<double> inner;
    forEachFace(cell, [&](std::size_t face) {
      const Vector area = outward(cell, face).area;
      all.add(area);
      if (isInner(face))
      {
        inner.add(area);
      }
    });
    const double volume = quality_.cellGeometry[cell].volume;
    setCell(cell, Volume, volume);
    setCell(cell, Openness, all.openness());
    setCell(cell, AspectRatio, all.aspectRatio(volume));
    setCell(cell, Determinant, inner.value());
  }

  void setEdges(std::size_t cell, CellEdges& edges)
  {
    if (!isWanted(OpenEdges) && !isWanted(Concavity))
    {
      setCell(cell, OpenEdges, MeasureSpecs[OpenEdges].best);
      setCell(cell, Concavity, MeasureSpecs[Concavity].best);
      return;
    }
    edges.clear();
    forEachFace(cell, [&](std::size_t face) {
      const bool owned = owner(face) == cell;
      for (std::size_t i = 0; i < sizeOf(face); ++i)
      {
        const std::uint32_t from = point(face, i);
        const std::uint32_t to = point(face, i + 1 < sizeOf(face) ? i + 1 : 0);
        const Vector normal = normalAt(face, from, to);
        owned ? edges.add(from, to, normal) : edges.add(to, from, scaled(normal, -1));
      }
    });
    const CellEdges::Result result =
      edges.measure([&](std::uint32_t point) { return faces_.at(point); });
    setCell(cell, OpenEdges, result.open);
    setCell(cell, Concavity, result.concavity);
  }

  // The normal of a warped face at one of its edges: that of the triangle with the face centre, unless the triangle
  // is inverted or a mere sliver.
  Vector normalAt(std::size_t face, std::uint32_t from, std::uint32_t to) const
  {
    constexpr double Sliver = 1e-6; // of the face's area
    const FaceGeometry& geometry = quality_.faceGeometry[face];
    const Vector triangle =
      cross(minus(faces_.at(from), geometry.centre), minus(faces_.at(to), geometry.centre));
    const double least = Sliver * dot(geometry.area, geometry.area);
    return dot(triangle, geometry.area) > least ? triangle : geometry.area;
  }

  const FaceCorners faces_;
  const FaceList& list_;
  FacesOfCells of_;
  Execution& execution_;
  const QualityLimits limits_;
  const std::uint32_t leftOut_; // bits of measures
  Quality quality_;
};

}

Quality measureQuality(const double* points, const CellFaces& cells, const FaceList& faces,
  Execution& execution, const QualityLimits& limits, std::uint32_t leftOut)
{
  return Meter(points, cells, faces, execution, limits, leftOut).run();
}

namespace
{

// Sums up the cells that count.
class Summary
{
public:
  Summary(const Quality& quality, const FaceList& faces, const unsigned char* leftOut)
    : quality_(quality)
    , faces_(faces)
    , leftOut_(leftOut)
  {
  }

  std::vector<SummaryValue> run() &&
  {
    add("Cells", sum([](std::size_t) { return 1; }));
    add("FailingCells", sum([&](std::size_t c) { return quality_.cellFailures[c] != 0; }));
    add("ConcaveCells",
      sum([&](std::size_t c) { return quality_.cells[Concavity][c] >= ConcaveFrom; }));
    add("TotalVolume", sum([&](std::size_t c) { return quality_.cellGeometry[c].volume; }));
    add("BoundaryArea", boundaryArea());
    for (std::size_t m = 0; m < MeasureCount; ++m)
    {
      add(std::string(MeasureSpecs[m].name) + "Failures",
        sum([&](std::size_t c) { return quality_.cellFailures[c] >> m & 1u; }));
      addWorst(m);
    }
    return std::move(result_);
  }

private:
  bool counts(std::size_t cell) const { return !leftOut_ || leftOut_[cell] == 0; }

  void add(const std::string& name, double value)
  {
    result_.push_back({ name, value, SummaryValue::Reduction::Sum });
  }

  template <class Value>
  double sum(Value&& value) const
  {
    double result = 0;
    for (std::size_t c = 0; c < quality_.cellGeometry.size(); ++c)
    {
      result += counts(c) ? static_cast<double>(value(c)) : 0;
    }
    return result;
  }

  double boundaryArea() const
  {
    double area = 0;
    for (std::size_t f = faces_.neighbour.size(); f < faces_.owner.size(); ++f)
    {
      area += counts(faces_.owner[f]) ? norm(quality_.faceGeometry[f].area) : 0;
    }
    return area;
  }

  void addWorst(std::size_t measure)
  {
    const MeasureSpec& spec = MeasureSpecs[measure];
    const RawVector<double>& values = quality_.cells[measure];
    double worst = spec.best;
    for (std::size_t c = 0; c < values.size(); ++c)
    {
      if (counts(c))
      {
        worst = spec.largeIsWorse ? std::max(worst, values[c]) : std::min(worst, values[c]);
      }
    }
    result_.push_back({ std::string(spec.largeIsWorse ? "Max" : "Min") + spec.name, worst,
      spec.largeIsWorse ? SummaryValue::Reduction::Maximum : SummaryValue::Reduction::Minimum });
  }

  const Quality& quality_;
  const FaceList& faces_;
  const unsigned char* leftOut_;
  std::vector<SummaryValue> result_;
};

}

std::vector<SummaryValue> summarise(
  const Quality& quality, const FaceList& faces, const unsigned char* leftOut)
{
  return Summary(quality, faces, leftOut).run();
}

}
