// SPDX-License-Identifier: BSD-3-Clause
#include "Mesher/VolumeLoss.h"

#include "Mesher/Statistics.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace cartesian
{

namespace
{

constexpr double LargestUntold = 0.01; // of what a region encloses
constexpr std::size_t TilesAlong = 8;  // of the grid, in which places are looked for
constexpr std::size_t MostPlaces = 3;
constexpr std::size_t FacesAChunk = 2048;
constexpr double LeastOfPlace = 0.2; // of what is missing in the first

using Polygon = std::vector<Vector>;

// The part above (or below) a plane across an axis.
Polygon cutOff(const Polygon& polygon, std::size_t axis, double plane, bool above)
{
  Polygon part;
  const auto height = [&](const Vector& p) { return above ? p[axis] - plane : plane - p[axis]; };
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Vector& p = polygon[i];
    const Vector& q = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    if (height(p) >= 0)
    {
      part.push_back(p);
    }
    if ((height(p) < 0) != (height(q) < 0))
    {
      part.push_back(plus(p, scaled(minus(q, p), height(p) / (height(p) - height(q)))));
    }
  }
  return part;
}

// Volumes enclosed by closed, outward surfaces, in each of some tiles of a box: lengths along x of what is inside, over
// the tile's rectangle. Levels above the box's lower corner.
class Tiles
{
public:
  Tiles(const Vector& size, std::size_t along)
    : size_(scaled(size, 1.0 / static_cast<double>(along)))
    , along_(along)
    , volumes_(along * along * along)
  {
  }

  void add(const Polygon& polygon) { divide(polygon, 2, {}); }

  // The same tiles with nothing in them.
  Tiles empty() const
  {
    Tiles tiles = *this;
    std::fill(tiles.volumes_.begin(), tiles.volumes_.end(), 0.0);
    return tiles;
  }

  void add(const Tiles& others)
  {
    std::transform(
      volumes_.begin(), volumes_.end(), others.volumes_.begin(), volumes_.begin(), std::plus<>());
  }

  double sum() const
  {
    double all = 0;
    for (const double volume : volumes_)
    {
      all += volume;
    }
    return all;
  }
  double operator[](std::size_t tile) const { return volumes_[tile]; }
  std::size_t count() const { return volumes_.size(); }

  std::array<std::size_t, 3> indexOf(std::size_t tile) const
  {
    return { tile % along_, tile / along_ % along_, tile / along_ / along_ };
  }
  const Vector& sizeOfTile() const { return size_; }

private:
  // Cuts along z, y and x in turn.
  void divide(const Polygon& polygon, std::size_t axis, std::array<std::size_t, 3> tile)
  {
    if (polygon.size() < 3)
    {
      return;
    }
    const auto [least, most] = std::minmax_element(polygon.begin(), polygon.end(),
      [axis](const Vector& a, const Vector& b) { return a[axis] < b[axis]; });
    const auto tileAt = [&](double x) { return std::floor(x / size_[axis]); };
    const auto first = static_cast<std::int64_t>(std::max(tileAt((*least)[axis]), -2.0));
    const auto end = static_cast<std::int64_t>(along_);
    const auto last =
      static_cast<std::int64_t>(std::min(tileAt((*most)[axis]), static_cast<double>(along_)));
    for (std::int64_t t = std::max<std::int64_t>(first, axis == 0 ? -1 : 0); t <= last; ++t)
    {
      if (t == end && axis != 0)
      {
        break;
      }
      const auto place = static_cast<double>(t);
      Polygon part = polygon;
      part = first < t ? cutOff(part, axis, place * size_[axis], true) : part;
      part = t < last ? cutOff(part, axis, (place + 1) * size_[axis], false) : part;
      if (axis == 0)
      {
        count(part, place, tile);
        continue;
      }
      tile[axis] = static_cast<std::size_t>(t);
      divide(part, axis - 1, tile);
    }
  }

  // All tiles below a piece, along x, are inside behind it.
  void count(const Polygon& piece, double t, const std::array<std::size_t, 3>& tile)
  {
    double area = 0;
    double moment = 0;
    for (std::size_t i = 1; i + 1 < piece.size(); ++i)
    {
      const double part = cross(minus(piece[i], piece[0]), minus(piece[i + 1], piece[0]))[0] / 2;
      area += part;
      moment += part * (piece[0][0] + piece[i][0] + piece[i + 1][0]) / 3;
    }
    const std::size_t row = along_ * (tile[1] + along_ * tile[2]);
    for (std::size_t i = 0; i < along_ && static_cast<double>(i) <= t; ++i)
    {
      const bool isOwn = static_cast<double>(i) == t;
      volumes_[row + i] += isOwn ? moment - t * size_[0] * area : size_[0] * area;
    }
  }

  const Vector size_;
  const std::size_t along_;
  std::vector<double> volumes_;
};

class Comparison
{
public:
  Comparison(const PreparedSurface& prepared, const Assembly& assembly, Execution& execution)
    : surface_(prepared.surface)
    , a_(assembly)
    , execution_(execution)
  {
    const auto& planes = a_.boxes.planes;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      low_[axis] = planes[axis].front();
      size_[axis] = double(planes[axis].back()) - planes[axis].front();
    }
  }

  VolumeLoss run()
  {
    VolumeLoss loss;
    loss.meshed = a_.regionVolumes;
    for (std::size_t r = 0; r < loss.meshed.size(); ++r)
    {
      const auto region = static_cast<std::int32_t>(r) + FirstRegion;
      Tiles whole(size_, 1);
      addSurface(region, whole);
      const double box = isAround(region) ? size_[0] * size_[1] * size_[2] : 0;
      loss.enclosed.push_back(inUnits(whole.sum() + box));
    }
    for (std::size_t r = 0; r < loss.meshed.size(); ++r)
    {
      loss.places.emplace_back();
      if (loss.isTold(r))
      {
        findPlaces(static_cast<std::int32_t>(r) + FirstRegion, loss);
      }
    }
    return loss;
  }

private:
  double inUnits(double volume) const { return volume * std::pow(a_.boxes.lattice.step(), 3); }

  // Whether it is the space around bodies, which is inside of the box.
  bool isAround(std::int32_t region) const
  {
    return surface_.around.inside() && surface_.around.region() == region;
  }

  // Calls add(item, tiles) for some items, chunk by chunk.
  template <class Add>
  void addAll(std::size_t count, Tiles& tiles, Add&& add) const
  {
    std::vector<Tiles> parts(chunks(count, FacesAChunk), tiles.empty());
    execution_.forEach(count, FacesAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        add(i, parts[begin / FacesAChunk]);
      }
    });
    for (const Tiles& part : parts)
    {
      tiles.add(part);
    }
  }

  // All that bounds a region.
  void addSurface(std::int32_t region, Tiles& tiles) const
  {
    const Walls& walls = surface_.walls;
    addAll(surface_.triangles.size(), tiles, [&](std::size_t t, Tiles& part) {
      const std::int32_t wall = surface_.boundary[t];
      const std::int32_t behind = walls.givenOf(walls.behind(wall));
      const std::int32_t front = walls.givenOf(walls.front(wall));
      const bool isBehind = behind == region;
      const bool isInFront = front == region;
      if (isBehind != isInFront)
      {
        Corners c = surface_.corners(t);
        if (isInFront)
        {
          std::swap(c[1], c[2]);
        }
        part.add({ relative(c[0]), relative(c[1]), relative(c[2]) });
      }
    });
  }

  Vector relative(const Point& p) const
  {
    return { p[0] - low_[0], p[1] - low_[1], p[2] - low_[2] };
  }

  // Of each cell, by the number that boundary faces give it.
  std::vector<std::int32_t> regionsOfCells() const
  {
    const auto count = static_cast<std::size_t>(a_.mesh->cellCount());
    std::vector<Id> number(count);
    std::vector<int> globalBox(3 * count);
    std::vector<unsigned char> level(3 * count);
    std::vector<int> region(count);
    std::vector<double> fraction(count);
    a_.mesh->writeCellData(
      { number.data(), globalBox.data(), level.data(), region.data(), fraction.data() },
      execution_);
    std::vector<std::int32_t> result(count);
    for (std::size_t c = 0; c < count; ++c)
    {
      result[static_cast<std::size_t>(number[c])] = region[c];
    }
    return result;
  }

  void addMesh(std::int32_t region, Tiles& tiles) const
  {
    const std::vector<std::int32_t> regionOf = regionsOfCells();
    const std::vector<BoundaryFace>& outer = a_.mesh->boundary();
    addFaces(a_.mesh->boundaryMesh(execution_), tiles, [&](std::size_t f) {
      return regionOf[static_cast<std::size_t>(outer[f].cell)] == region ? 1 : 0;
    });
    const Walls& walls = a_.patches.walls;
    const std::vector<BoundaryFace>& inner = a_.mesh->interfaces();
    addFaces(a_.mesh->interfaceMesh(execution_), tiles, [&](std::size_t f) {
      return (walls.givenOf(walls.behind(inner[f].boundary)) == region ? 1 : 0) -
        (walls.givenOf(walls.front(inner[f].boundary)) == region ? 1 : 0);
    });
  }

  // sideOf(face): 1 if they are outward, -1 if inward, 0: they are none of it.
  template <class SideOf>
  void addFaces(const BoundaryMesh& faces, Tiles& tiles, SideOf&& sideOf) const
  {
    std::vector<double> xyz(3 * static_cast<std::size_t>(a_.mesh->pointCount()));
    a_.mesh->writePoints(xyz.data(), execution_);
    addAll(faces.start.size() - 1, tiles, [&](std::size_t f, Tiles& part) {
      const int side = sideOf(f);
      Polygon corners;
      for (auto i = faces.start[f]; side != 0 && i < faces.start[f + 1]; ++i)
      {
        const auto corner = static_cast<std::size_t>(faces.corners[static_cast<std::size_t>(i)]);
        corners.push_back(
          relative(xyz.data() + 3 * static_cast<std::size_t>(faces.meshPoint[corner])));
      }
      for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      {
        part.add({ corners[0], corners[side > 0 ? i : i + 1], corners[side > 0 ? i + 1 : i] });
      }
    });
  }

  Vector relative(const double* at) const
  {
    const Lattice& lattice = a_.boxes.lattice;
    Vector p;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      p[axis] =
        (at[axis] - lattice.position(static_cast<int>(axis), static_cast<Level>(low_[axis]))) /
        lattice.step();
    }
    return p;
  }

  void findPlaces(std::int32_t region, VolumeLoss& loss) const
  {
    Tiles ofSurface(size_, TilesAlong);
    Tiles ofMesh(size_, TilesAlong);
    addSurface(region, ofSurface);
    addMesh(region, ofMesh);
    const Vector& size = ofMesh.sizeOfTile();
    const double tile = isAround(region) ? size[0] * size[1] * size[2] : 0;
    std::vector<VolumeLoss::Place>& places = loss.places.back();
    for (std::size_t t = 0; t < ofMesh.count(); ++t)
    {
      const double missing = tile + ofSurface[t] - ofMesh[t];
      Vector low;
      Vector high;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const auto at = static_cast<double>(ofMesh.indexOf(t)[axis]);
        const double origin =
          a_.boxes.lattice.position(static_cast<int>(axis), static_cast<Level>(low_[axis]));
        low[axis] = origin + at * size[axis] * a_.boxes.lattice.step();
        high[axis] = low[axis] + size[axis] * a_.boxes.lattice.step();
      }
      places.push_back({ low, high, inUnits(missing) });
    }
    std::stable_sort(places.begin(), places.end(),
      [](const auto& x, const auto& y) { return std::abs(x.missing) > std::abs(y.missing); });
    places.resize(std::min(places.size(), MostPlaces));
    while (std::abs(places.back().missing) < LeastOfPlace * std::abs(places.front().missing))
    {
      places.pop_back();
    }
  }

  const Surface& surface_;
  const Assembly& a_;
  Execution& execution_;
  Vector low_{};
  Vector size_{};
};

std::string inPercent(double share)
{
  constexpr double Percent = 100;
  return number(std::round(share * Percent * 100) / 100) + " %";
}

std::string inWords(const Vector& p)
{
  return "(" + number(p[0]) + ", " + number(p[1]) + ", " + number(p[2]) + ")";
}

}

double VolumeLoss::share(std::size_t region) const
{
  return region < enclosed.size() && enclosed[region] > 0 ? 1 - meshed[region] / enclosed[region]
                                                          : 0;
}

bool VolumeLoss::isTold(std::size_t region) const
{
  return std::abs(share(region)) > LargestUntold;
}

VolumeLoss findVolumeLoss(
  const PreparedSurface& prepared, const Assembly& assembly, Execution& execution)
{
  const bool isKnown = assembly.separate.leftOut == 0 && !prepared.isEnclosed;
  return isKnown ? Comparison(prepared, assembly, execution).run() : VolumeLoss{};
}

std::string describe(const VolumeLoss& loss, const std::vector<std::string>& regions)
{
  std::string text;
  for (std::size_t r = 0; r < loss.enclosed.size(); ++r)
  {
    if (!loss.isTold(r))
    {
      continue;
    }
    const double share = loss.share(r);
    text += (text.empty() ? "" : "\n") +
      (loss.enclosed.size() > 1 && r < regions.size() ? "Region " + regions[r] : "The mesh") +
      " holds " + inPercent(std::abs(share)) + (share > 0 ? " less" : " more") +
      " than the surface encloses: " + number(loss.meshed[r]) + " of " + number(loss.enclosed[r]) +
      ". Use a smaller Cell Size or a larger Refinement Depth there:";
    for (const VolumeLoss::Place& place : loss.places[r])
    {
      text += "\n  " + number(std::abs(place.missing)) + (place.missing > 0 ? " less" : " more") +
        " from " + inWords(place.low) + " to " + inWords(place.high);
    }
  }
  return text;
}

}
