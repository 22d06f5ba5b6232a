// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/CyclicFaces.h"

#include "Base/Error.h"

#include <algorithm>
#include <limits>

namespace cartesian
{

namespace
{

// The faces of a patch.
struct FaceRange
{
  std::size_t first;
  std::size_t end;

  std::size_t count() const { return end - first; }
};

class CyclicOrder
{
public:
  CyclicOrder(FoamMesh& mesh, std::size_t first, std::size_t second)
    : mesh_(mesh)
    , patches_{ first, second }
    , faces_{ rangeOf(first), rangeOf(second) }
  {
  }

  void run()
  {
    listMiddles();
    std::vector<std::size_t> order;
    std::vector<std::uint32_t> corners;
    for (std::size_t face = faces_[0].first; face < faces_[0].end; ++face)
    {
      order.push_back(findBeyond(face));
    }
    std::vector<std::size_t> sorted = order;
    std::sort(sorted.begin(), sorted.end());
    if (sorted.size() != faces_[1].count() ||
      std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
    {
      refuse(middleOf(faces_[0].first));
    }
    arrange(order);
  }

private:
  FaceRange rangeOf(std::size_t patch) const
  {
    std::size_t first = mesh_.neighbour.size();
    for (std::size_t i = 0; i < patch; ++i)
    {
      first += mesh_.patches[i].count;
    }
    return { first, first + mesh_.patches[patch].count };
  }

  Vector pointOf(std::uint32_t p) const
  {
    const double* const at = &mesh_.points[3 * std::size_t(p)];
    return { at[0], at[1], at[2] };
  }

  Vector moved(const Vector& point) const { return mesh_.patches[patches_[0]].motion.of(point); }

  Vector middleOf(std::size_t face) const
  {
    Vector sum{};
    for (std::size_t i = mesh_.start[face]; i < mesh_.start[face + 1]; ++i)
    {
      sum = plus(sum, pointOf(mesh_.corners[i]));
    }
    return scaled(sum, 1 / static_cast<double>(mesh_.start[face + 1] - mesh_.start[face]));
  }

  double shortestEdge(std::size_t face) const
  {
    double least = std::numeric_limits<double>::max();
    std::uint32_t before = mesh_.corners[mesh_.start[face + 1] - 1];
    for (std::size_t i = mesh_.start[face]; i < mesh_.start[face + 1]; ++i)
    {
      least = std::min(least, norm(minus(pointOf(mesh_.corners[i]), pointOf(before))));
      before = mesh_.corners[i];
    }
    return least;
  }

  // Along a direction that no grid has, so that few middles are close to each other.
  static double along(const Vector& place) { return dot(place, { 0.5377, 0.6919, 0.4817 }); }

  void listMiddles()
  {
    for (std::size_t face = faces_[1].first; face < faces_[1].end; ++face)
    {
      middles_.emplace_back(along(middleOf(face)), face);
    }
    std::sort(middles_.begin(), middles_.end());
  }

  std::size_t findBeyond(std::size_t face) const
  {
    const Vector middle = moved(middleOf(face));
    const double reach = CyclicFaces::Same * shortestEdge(face);
    auto at = std::lower_bound(
      middles_.begin(), middles_.end(), std::pair(along(middle) - reach, std::size_t(0)));
    for (; at != middles_.end() && at->first <= along(middle) + reach; ++at)
    {
      const std::size_t other = at->second;
      if (norm(minus(middleOf(other), middle)) <= reach &&
        mesh_.start[other + 1] - mesh_.start[other] == mesh_.start[face + 1] - mesh_.start[face])
      {
        return other;
      }
    }
    refuse(middleOf(face));
  }

  [[noreturn]] void refuse(const Vector& at) const
  {
    throw Error(Fault::BadMesh,
      "The boundaries \"" + mesh_.patches[patches_[0]].name + "\" and \"" +
        mesh_.patches[patches_[1]].name + "\" are periodic, but have other faces at (" +
        number(at[0]) + ", " + number(at[1]) + ", " + number(at[2]) +
        "): save the output of Periodic Boundaries itself, and let regions meet themselves there.");
  }

  // The first corner becomes that where the first one of the face before is.
  void addTurned(std::size_t face, std::size_t before, std::vector<std::uint32_t>& corners) const
  {
    const Vector first = moved(pointOf(mesh_.corners[mesh_.start[before]]));
    const std::size_t size = mesh_.start[face + 1] - mesh_.start[face];
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < size; ++i)
    {
      const double away = norm(minus(pointOf(mesh_.corners[mesh_.start[face] + i]), first));
      nearest = away < least ? i : nearest;
      least = std::min(least, away);
    }
    for (std::size_t i = 0; i < size; ++i)
    {
      corners.push_back(mesh_.corners[mesh_.start[face] + (nearest + i) % size]);
    }
  }

  // `order`: the faces of the second patch as they are to come.
  void arrange(const std::vector<std::size_t>& order)
  {
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> owners;
    std::vector<std::size_t> ends;
    const std::size_t firstCorner = mesh_.start[faces_[1].first];
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      addTurned(order[i], faces_[0].first + i, corners);
      owners.push_back(mesh_.owner[order[i]]);
      ends.push_back(firstCorner + corners.size());
    }
    std::copy(corners.begin(), corners.end(), mesh_.corners.data() + firstCorner);
    std::copy(owners.begin(), owners.end(), mesh_.owner.data() + faces_[1].first);
    std::copy(ends.begin(), ends.end(), mesh_.start.data() + faces_[1].first + 1);
  }

  FoamMesh& mesh_;
  std::array<std::size_t, 2> patches_;
  std::array<FaceRange, 2> faces_;
  std::vector<std::pair<double, std::size_t>> middles_; // of the second patch's faces
};

}

void orderCyclicFaces(FoamMesh& mesh)
{
  for (std::size_t i = 0; i < mesh.patches.size(); ++i)
  {
    const FoamPatch& patch = mesh.patches[i];
    if (patch.type != "cyclic" || patch.partner.empty())
    {
      continue;
    }
    const auto partner = std::find_if(mesh.patches.begin(), mesh.patches.end(),
      [&](const FoamPatch& other) { return other.name == patch.partner; });
    if (partner == mesh.patches.end())
    {
      throw Error(Fault::BadMesh,
        "The boundary \"" + patch.name + "\" is periodic, but \"" + patch.partner +
          "\" has no faces in the same region.");
    }
    const auto other = static_cast<std::size_t>(partner - mesh.patches.begin());
    if (i < other)
    {
      CyclicOrder(mesh, i, other).run();
    }
  }
}

}
