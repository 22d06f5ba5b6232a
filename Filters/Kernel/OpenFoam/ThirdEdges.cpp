// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/ThirdEdges.h"

#include "Lattice/Vector.h"

#include <algorithm>
#include <map>
#include <set>

namespace cartesian
{

namespace
{

constexpr int MostRounds = 8;        // a division may make a face that needs another one
constexpr std::uint8_t FewFaces = 4; // points of more have more than two edges
constexpr std::size_t LeastCorners = 3;
constexpr double LeastPart = 1e-3; // of the face, along its normal

// A face divided by a line between two of its corners.
struct Division
{
  std::size_t from; // of the corners of the face, from 0
  std::size_t to;
  double part; // the smaller one, of the face
};

class Round
{
public:
  explicit Round(const FoamMesh& mesh)
    : mesh_(mesh)
  {
    findPoints();
  }

  // By face.
  std::map<std::size_t, Division> divisions() const
  {
    std::map<std::size_t, Division> found;
    for (std::size_t f = 0; f < mesh_.owner.size(); ++f)
    {
      if (cornersLeft(f) < LeastCorners)
      {
        add(f, found);
      }
    }
    return found;
  }

private:
  std::size_t sizeOf(std::size_t face) const { return mesh_.start[face + 1] - mesh_.start[face]; }

  // From 0, and on after the last.
  std::uint32_t cornerOf(std::size_t face, std::size_t i) const
  {
    return mesh_.corners[mesh_.start[face] + i % sizeOf(face)];
  }

  // Those with two edges, and their faces.
  void findPoints()
  {
    std::vector<std::uint8_t> uses(mesh_.points.size() / 3);
    for (std::size_t i = 0; i < mesh_.corners.size(); ++i)
    {
      std::uint8_t& count = uses[mesh_.corners[i]];
      count = std::min<std::uint8_t>(count + 1, FewFaces + 1);
    }
    std::map<std::uint32_t, std::set<std::uint32_t>> neighbours;
    for (std::size_t f = 0; f < mesh_.owner.size(); ++f)
    {
      for (std::size_t i = 0; i < sizeOf(f); ++i)
      {
        const std::uint32_t point = cornerOf(f, i);
        if (uses[point] <= FewFaces)
        {
          facesOf_[point].push_back(f);
          neighbours[point].insert({ cornerOf(f, i + 1), cornerOf(f, i + sizeOf(f) - 1) });
        }
      }
    }
    for (const auto& [point, others] : neighbours)
    {
      if (others.size() > 2)
      {
        facesOf_.erase(point);
      }
    }
  }

  std::size_t cornersLeft(std::size_t face) const
  {
    std::size_t left = 0;
    for (std::size_t i = 0; i < sizeOf(face); ++i)
    {
      left += facesOf_.count(cornerOf(face, i)) == 0 ? 1 : 0;
    }
    return left;
  }

  // The best one of another face at a corner that would go; none if all are poor.
  void add(std::size_t face, std::map<std::size_t, Division>& found) const
  {
    Division best{ 0, 0, LeastPart };
    std::size_t where = face;
    for (std::size_t i = 0; i < sizeOf(face); ++i)
    {
      const auto point = facesOf_.find(cornerOf(face, i));
      for (std::size_t n = 0; point != facesOf_.end() && n < point->second.size(); ++n)
      {
        const std::size_t other = point->second[n];
        const Division division = bestOf(other, point->first);
        if (other != face && found.count(other) == 0 && division.part > best.part)
        {
          best = division;
          where = other;
        }
      }
    }
    if (where != face)
    {
      found[where] = best;
    }
  }

  Division bestOf(std::size_t face, std::uint32_t point) const
  {
    const std::size_t size = sizeOf(face);
    std::size_t from = 0;
    while (cornerOf(face, from) != point)
    {
      ++from;
    }
    const Vector whole = doubleArea(face, from, size);
    Division best{ from, from, 0 };
    for (std::size_t n = 2; n + 2 <= size; ++n)
    {
      const double share = dot(doubleArea(face, from, n + 1), whole) / dot(whole, whole);
      const double part = std::min(share, 1 - share);
      best = part > best.part ? Division{ from, (from + n) % size, part } : best;
    }
    return best;
  }

  // Of a polygon of `count` corners from one on.
  Vector doubleArea(std::size_t face, std::size_t from, std::size_t count) const
  {
    const auto at = [&](std::size_t i) {
      const double* const p = mesh_.points.data() + 3UL * cornerOf(face, from + i);
      return Vector{ p[0], p[1], p[2] };
    };
    Vector area{};
    for (std::size_t i = 1; i + 1 < count; ++i)
    {
      area = plus(area, cross(minus(at(i), at(0)), minus(at(i + 1), at(0))));
    }
    return area;
  }

  const FoamMesh& mesh_;
  std::map<std::uint32_t, std::vector<std::size_t>> facesOf_; // of each point with two edges
};

// The parts follow each other, so that the order of faces stays.
class Divided
{
public:
  Divided(FoamMesh&& mesh, const std::map<std::size_t, Division>& divisions)
    : old_(std::move(mesh))
  {
    new_ = { std::move(old_.points), { 0 }, {}, {}, {}, old_.cellCount, std::move(old_.patches) };
    new_.boxLevels = std::move(old_.boxLevels);
    for (const FoamPatch& patch : new_.patches)
    {
      countsBefore_.push_back(patch.count);
    }
    corners_.reserve(old_.corners.size());
    auto next = divisions.begin();
    for (std::size_t f = 0; f < old_.owner.size(); ++f)
    {
      const std::size_t size = old_.start[f + 1] - old_.start[f];
      if (next == divisions.end() || next->first != f)
      {
        addPart(f, 0, size);
        continue;
      }
      const auto [from, to] = std::minmax(next->second.from, next->second.to);
      addPart(f, from, to - from + 1);
      addPart(f, to, size - (to - from) + 1);
      countTwice(f);
      ++next;
    }
    new_.corners.resize(corners_.size());
    std::copy(corners_.begin(), corners_.end(), new_.corners.data());
  }

  FoamMesh take() { return std::move(new_); }

private:
  // Of so many corners from one on.
  void addPart(std::size_t face, std::size_t from, std::size_t count)
  {
    const std::size_t size = old_.start[face + 1] - old_.start[face];
    for (std::size_t i = from; i < from + count; ++i)
    {
      corners_.push_back(old_.corners[old_.start[face] + i % size]);
    }
    new_.start.push_back(corners_.size());
    new_.owner.push_back(old_.owner[face]);
    if (face < old_.neighbour.size())
    {
      new_.neighbour.push_back(old_.neighbour[face]);
    }
  }

  // In its patch.
  void countTwice(std::size_t face)
  {
    std::size_t end = old_.neighbour.size();
    for (std::size_t p = 0; p < new_.patches.size() && face >= old_.neighbour.size(); ++p)
    {
      const std::size_t first = end;
      end += countsBefore_[p];
      new_.patches[p].count += face >= first && face < end ? 1 : 0;
    }
  }

  FoamMesh old_;
  FoamMesh new_{};
  std::vector<std::uint32_t> corners_;
  std::vector<std::size_t> countsBefore_; // faces of each patch
};

}

FoamMesh withThirdEdges(FoamMesh mesh)
{
  for (int round = 0; round < MostRounds; ++round)
  {
    const std::map<std::size_t, Division> divisions = Round(mesh).divisions();
    if (divisions.empty())
    {
      break;
    }
    mesh = Divided(std::move(mesh), divisions).take();
  }
  return mesh;
}

}
