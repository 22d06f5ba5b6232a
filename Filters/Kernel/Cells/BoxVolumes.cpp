// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/BoxVolumes.h"

#include "Polyhedra/CellGeometry.h"

#include <cmath>

namespace cartesian
{

namespace
{

// A cell whose mean thickness is below this part of a lattice step is rounding and no volume.
constexpr double ThinnestCell = 0.01;

// Triangles between lattice points have at least half a square step, or no area.
constexpr double LeastArea = 0.5;

// Beyond this solid angle, a point counts as inside.
constexpr double HalfAround = 2 * Pi;

}

bool Shell::isSliver() const
{
  return !(std::abs(volume) > ThinnestCell * std::max(area / 2, LeastArea));
}

void BoxVolumes::find(BoxFaces& faces, const Point& origin)
{
  measureFaces(faces, origin);
  findShells(faces);
  voids_ = fillVoids(faces);
  folds_ = dropFolds(faces);
}

void BoxVolumes::measureFaces(const BoxFaces& faces, const Point& origin)
{
  measures_.clear();
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    ring_.clear();
    faces.forEachCorner(
      f, [&](std::uint32_t node) { ring_.push_back(minus(nodes_.at[node], origin)); });
    const Cone cone =
      measureCone(ring_.size(), [&](std::size_t i) -> const Vector& { return ring_[i]; });
    measures_.push_back({ norm(cone.area), cone.volume });
  }
}

void BoxVolumes::findShells(BoxFaces& faces)
{
  pool_.release(shells_);
  shellOf_.assign(faces.size(), None);
  for (std::uint32_t f = 0; f < faces.size(); ++f)
  {
    const std::uint32_t r = faces.root(f);
    if (shellOf_[r] == None)
    {
      shellOf_[r] = static_cast<std::uint32_t>(shells_.size());
      shells_.push_back(pool_.acquire());
      shells_.back().clear();
    }
    Shell& shell = shells_[shellOf_[r]];
    shell.faces.push_back(f);
    shell.volume += measures_[f].volume;
    shell.area += measures_[f].area;
    shell.hasInnerFace = shell.hasInnerFace || !faces.isPatch(f);
  }
}

// A closed piece of surface inside the box that encloses no part of the domain becomes a hole of the
// cell around it.
std::size_t BoxVolumes::fillVoids(const BoxFaces& faces)
{
  std::size_t voids = 0;
  for (Shell& shell : shells_)
  {
    if (shell.volume >= 0 || shell.hasInnerFace || shell.isSliver())
    {
      continue;
    }
    if (Shell* around = shellAround(faces, shell))
    {
      around->faces.insert(around->faces.end(), shell.faces.begin(), shell.faces.end());
      around->volume += shell.volume;
      shell.faces.clear();
      ++voids;
    }
  }
  return voids;
}

// Two patches of one volume with the same corners in opposite order are a wall without thickness inside it. They
// bound nothing, so both are dropped; all their edges have other faces too.
std::size_t BoxVolumes::dropFolds(const BoxFaces& faces)
{
  if (!faces.hasSharedEdges())
  {
    return 0;
  }
  std::size_t folds = 0;
  for (Shell& shell : shells_)
  {
    faces.listPatchCycles(shell.faces, cycles_);
    dropped_.clear();
    std::ptrdiff_t twin = 0; // how many patches before this one have the same corners
    for (std::size_t i = 0; i < cycles_.size(); ++i)
    {
      // Where parts overlap a patch may come several times: each is paired with another opposite one.
      const bool again = i > 0 && cycles_[i].first == cycles_[i - 1].first;
      twin = again ? twin + 1 : 0;
      const BoxFaces::Cycle opposite = faces.cycleOf(cycles_[i].second, true);
      const auto found = std::lower_bound(
        cycles_.begin(), cycles_.end(), std::make_pair(opposite, std::uint32_t(0)));
      if (cycles_.end() - found > twin && (found + twin)->first == opposite)
      {
        dropped_.push_back(cycles_[i].second);
      }
    }
    const auto gone = [&](std::uint32_t face) {
      return std::find(dropped_.begin(), dropped_.end(), face) != dropped_.end();
    };
    shell.faces.erase(
      std::remove_if(shell.faces.begin(), shell.faces.end(), gone), shell.faces.end());
    folds += dropped_.size() / 2;
  }
  return folds;
}

bool BoxVolumes::anyFaceTwice(const BoxFaces& faces)
{
  for (const Shell& shell : shells_)
  {
    if (shell.faces.size() == 2) // of no volume
    {
      continue;
    }
    cycles_.clear();
    for (const std::uint32_t face : shell.faces)
    {
      cycles_.emplace_back(std::min(faces.cycleOf(face, false), faces.cycleOf(face, true)), face);
    }
    std::sort(cycles_.begin(), cycles_.end());
    const auto twice = std::adjacent_find(cycles_.begin(), cycles_.end(),
      [](const auto& a, const auto& b) { return a.first == b.first; });
    if (twice != cycles_.end())
    {
      return true;
    }
  }
  return false;
}

// The smallest volume that a void lies in.
Shell* BoxVolumes::shellAround(const BoxFaces& faces, const Shell& inner)
{
  Shell* best = nullptr;
  const Point& from = nodes_.at[faces.firstCorner(inner.faces.front())];
  for (Shell& shell : shells_)
  {
    if (shell.volume > 0 && (!best || shell.volume < best->volume) &&
      std::abs(solidAngle(faces, shell, from)) > HalfAround)
    {
      best = &shell;
    }
  }
  return best;
}

// Solid angle of a shell seen from a point: 4 pi from inside, 0 from outside.
double BoxVolumes::solidAngle(const BoxFaces& faces, const Shell& shell, const Point& from)
{
  double sum = 0;
  for (const std::uint32_t f : shell.faces)
  {
    ring_.clear();
    faces.forEachCorner(
      f, [&](std::uint32_t node) { ring_.push_back(minus(nodes_.at[node], from)); });
    for (std::size_t i = 1; i + 1 < ring_.size(); ++i)
    {
      const Vector& a = ring_[0];
      const Vector& b = ring_[i];
      const Vector& c = ring_[i + 1];
      const double la = std::sqrt(dot(a, a));
      const double lb = std::sqrt(dot(b, b));
      const double lc = std::sqrt(dot(c, c));
      sum += 2 *
        std::atan2(
          dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
    }
  }
  return sum;
}

std::int32_t BoxVolumes::mainBoundary(const BoxFaces& faces, const Shell& shell)
{
  areas_.clear();
  for (const std::uint32_t f : shell.faces)
  {
    if (faces.isPatch(f))
    {
      areas_.emplace_back(patches_.boundary[faces[f].face], measures_[f].area);
    }
  }
  if (areas_.size() > 1)
  {
    std::sort(areas_.begin(), areas_.end());
  }
  std::int32_t best = NoBoundary;
  double most = -1;
  for (std::size_t i = 0; i < areas_.size();)
  {
    const std::int32_t boundary = areas_[i].first;
    double sum = 0;
    for (; i < areas_.size() && areas_[i].first == boundary; ++i)
    {
      sum += areas_[i].second;
    }
    if (sum > most)
    {
      most = sum;
      best = boundary;
    }
  }
  return best;
}

}
