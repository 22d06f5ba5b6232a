// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/ThirdEdges.h"

#include "Polyhedra/CellGeometry.h"

#include <algorithm>
#include <map>
#include <set>

namespace cartesian
{

namespace
{

constexpr int MostRounds = 8;        // a division may make a face that needs another one
constexpr std::uint8_t FewFaces = 6; // points of more have more than two edges
constexpr double LeastCosine =
  0.1; // between a part's normal and the way to it from its cells' centres

// A face divided by a line between two of its corners.
struct Division
{
  std::size_t from; // of the corners of the face, from 0
  std::size_t to;
  double cosine; // the smallest
};

class Round
{
public:
  explicit Round(const FoamMesh& mesh)
    : mesh_(mesh)
  {
    findPoints();
    findCentres();
  }

  // By face, each with one at most.
  std::map<std::size_t, Division> divisions() const
  {
    std::map<std::size_t, Division> found;
    for (const auto& [point, faces] : facesOf_)
    {
      add(point, faces, found);
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
    for (const std::uint32_t corner : mesh_.corners)
    {
      std::uint8_t& count = uses[corner];
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

  // The best one of a face of the point; none if all are poor.
  void add(std::uint32_t point, const std::vector<std::size_t>& faces,
    std::map<std::size_t, Division>& found) const
  {
    Division best{ 0, 0, LeastCosine };
    std::size_t where = 0;
    for (const std::size_t face : faces)
    {
      const Division division = bestOf(face, point);
      if (found.count(face) == 0 && division.cosine > best.cosine)
      {
        best = division;
        where = face;
      }
    }
    if (best.cosine > LeastCosine)
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
    Division best{ from, from, 0 };
    for (std::size_t n = 2; n + 2 <= size; ++n)
    {
      const double cosine =
        std::min(leastCosine(face, from, n + 1), leastCosine(face, from + n, size - n + 1));
      best = cosine > best.cosine ? Division{ from, (from + n) % size, cosine } : best;
    }
    return best;
  }

  FaceGeometry geometryOf(std::size_t face, std::size_t from, std::size_t count) const
  {
    return measureFace(count, [&](std::size_t i) {
      const double* const p = mesh_.points.data() + 3UL * cornerOf(face, from + i);
      return Vector{ p[0], p[1], p[2] };
    });
  }

  // Of the part with `count` corners from one on, as its cells see it.
  double leastCosine(std::size_t face, std::size_t from, std::size_t count) const
  {
    const FaceGeometry part = geometryOf(face, from, count);
    const auto cosineOf = [&](std::uint32_t cell) {
      const Vector way = minus(part.centre, centres_.at(cell));
      return dot(part.area, way) / std::max(Tiny, norm(part.area) * norm(way));
    };
    const double ofOwner = cosineOf(mesh_.owner[face]);
    return face < mesh_.neighbour.size() ? std::min(ofOwner, -cosineOf(mesh_.neighbour[face]))
                                         : ofOwner;
  }

  // Of the cells with points that have two edges: of the pyramids on their faces about the mean of these, as OpenFOAM.
  void findCentres()
  {
    for (const auto& [point, faces] : facesOf_)
    {
      for (const std::size_t face : faces)
      {
        centres_[mesh_.owner[face]] = {};
        if (face < mesh_.neighbour.size())
        {
          centres_[mesh_.neighbour[face]] = {};
        }
      }
    }
    std::map<std::uint32_t, std::vector<FaceGeometry>> faces;
    for (std::size_t f = 0; f < mesh_.owner.size(); ++f)
    {
      addFace(f, mesh_.owner[f], 1, faces);
      if (f < mesh_.neighbour.size())
      {
        addFace(f, mesh_.neighbour[f], -1, faces);
      }
    }
    for (auto& [cell, centre] : centres_)
    {
      centre = centreOf(faces[cell]);
    }
  }

  void addFace(std::size_t face, std::uint32_t cell, double sign,
    std::map<std::uint32_t, std::vector<FaceGeometry>>& faces) const
  {
    if (centres_.count(cell) > 0)
    {
      FaceGeometry geometry = geometryOf(face, 0, sizeOf(face));
      geometry.area = scaled(geometry.area, sign);
      faces[cell].push_back(geometry);
    }
  }

  static Vector centreOf(const std::vector<FaceGeometry>& faces)
  {
    Vector mean{};
    for (const FaceGeometry& face : faces)
    {
      mean = plus(mean, scaled(face.centre, 1.0 / static_cast<double>(faces.size())));
    }
    Vector moment{};
    double volume = 0;
    for (const FaceGeometry& face : faces)
    {
      const double pyramid = dot(face.area, minus(face.centre, mean));
      moment = plus(moment, scaled(minus(face.centre, mean), 0.75 * pyramid));
      volume += pyramid;
    }
    return volume > Tiny ? plus(mean, scaled(moment, 1 / volume)) : mean;
  }

  const FoamMesh& mesh_;
  std::map<std::uint32_t, std::vector<std::size_t>> facesOf_; // of each point with two edges
  std::map<std::uint32_t, Vector> centres_;                   // of their cells
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
