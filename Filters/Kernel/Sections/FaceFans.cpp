// SPDX-License-Identifier: BSD-3-Clause
#include "Sections/FaceFans.h"

#include "Base/Sorting.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

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

class FanFinder
{
public:
  FanFinder(const CellFaces& cells, const double* points, Execution& execution)
    : count_(cells.faceCount())
    , corners_(cells, points)
    , execution_(execution)
  {
    result_.fanOf.assign(count_, NoPoint);
  }

  FaceFans find(const std::function<bool(const FaceCorners&, std::size_t)>& hasFan)
  {
    std::vector<std::vector<NamedFan>> found(chunks(count_, FacesAChunk));
    execution_.forEach(count_, FacesAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t face = begin; face < end; ++face)
      {
        if (hasFan(corners_, face))
        {
          found[begin / FacesAChunk].push_back(named(face));
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
    findCentres();
    return std::move(result_);
  }

private:
  NamedFan named(std::size_t face) const
  {
    NamedFan result{ { NoPoint, NoPoint, NoPoint }, static_cast<std::uint32_t>(face) };
    for (std::size_t i = 0; i < corners_.size(face); ++i)
    {
      std::uint32_t point = corners_.id(face, i);
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
    const std::size_t count = corners_.size(a);
    if (corners_.size(b) != count)
    {
      return false;
    }
    for (std::size_t shift = 0; shift < count; ++shift)
    {
      bool same = true;
      bool opposite = true;
      for (std::size_t i = 0; i < count && (same || opposite); ++i)
      {
        same = same && corners_.id(a, i) == corners_.id(b, (shift + i) % count);
        opposite = opposite && corners_.id(a, i) == corners_.id(b, (shift + count - i) % count);
      }
      if (same || opposite)
      {
        return true;
      }
    }
    return false;
  }

  // Each face has the fan of the first that is the same.
  void unite(std::vector<NamedFan>::iterator begin, std::vector<NamedFan>::iterator end)
  {
    for (auto a = begin; a != end; ++a)
    {
      const auto same = std::find_if(
        begin, a, [&](const NamedFan& before) { return areSame(before.face, a->face); });
      if (same == a)
      {
        result_.fanOf[a->face] = static_cast<std::uint32_t>(result_.faces.size());
        result_.faces.push_back(a->face);
      }
      else
      {
        result_.fanOf[a->face] = result_.fanOf[same->face];
      }
    }
  }

  void findCentres()
  {
    result_.centres.resize(result_.faces.size());
    execution_.forEach(result_.faces.size(), FacesAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t fan = begin; fan < end; ++fan)
      {
        result_.centres[fan] = corners_.geometry(result_.faces[fan]).centre;
      }
    });
  }

  std::size_t count_;
  FaceCorners corners_;
  Execution& execution_;
  FaceFans result_;
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

FaceFans findFans(const CellFaces& cells, const double* points,
  const std::function<bool(const FaceCorners&, std::size_t)>& hasFan, Execution& execution)
{
  return FanFinder(cells, points, execution).find(hasFan);
}

}
