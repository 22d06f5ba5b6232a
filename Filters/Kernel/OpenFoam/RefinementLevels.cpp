// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/RefinementLevels.h"

#include "Base/Sorting.h"
#include "OpenFoam/HexahedralBox.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cartesian
{

namespace
{

constexpr std::int32_t Free =
  100;                        // of points that no refinable cell has: above the level of any cell
constexpr int Undefined = -1; // of a face without four anchors, which solvers do not divide
constexpr int Anchors = 8;

class LevelFinder
{
public:
  explicit LevelFinder(const FoamMesh& mesh)
    : mesh_(mesh)
    , box_(mesh)
    , isRefinable_(mesh.cellCount)
    , isFreed_(mesh.points.size() / 3)
    , levels_{ std::vector<std::int32_t>(mesh.cellCount),
      std::vector<std::int32_t>(mesh.points.size() / 3), 0 }
  {
    listFaces();
    double edge = std::numeric_limits<double>::max();
    for (std::size_t c = 0; c < mesh.cellCount; ++c)
    {
      if (mesh_.boxLevels[c].isWhole && readBox(c))
      {
        isRefinable_[c] = 1;
        edge = std::min(edge, std::ldexp(box_.shortestEdge(), levelOfBox(c)));
      }
    }
    levels_.edge = edge;
  }

  std::optional<RefinementLevels> find()
  {
    do
    {
      findPointLevels();
      findCellLevels();
    } while (giveUp());
    const bool any = std::find(isRefinable_.begin(), isRefinable_.end(), 1) != isRefinable_.end();
    return any ? std::optional(std::move(levels_)) : std::nullopt;
  }

private:
  // Of each cell.
  void listFaces()
  {
    firstFace_.assign(mesh_.cellCount + 1, 0);
    const auto forEachUse = [&](const auto& visit) {
      for (std::size_t f = 0; f < mesh_.owner.size(); ++f)
      {
        visit(mesh_.owner[f], static_cast<std::uint32_t>(f));
        if (f < mesh_.neighbour.size())
        {
          visit(mesh_.neighbour[f], static_cast<std::uint32_t>(f));
        }
      }
    };
    forEachUse([&](std::uint32_t cell, std::uint32_t) { ++firstFace_[cell]; });
    faces_.resize(scan(firstFace_));
    std::vector<std::size_t> next(firstFace_.begin(), firstFace_.end() - 1);
    forEachUse([&](std::uint32_t cell, std::uint32_t face) { faces_[next[cell]++] = face; });
  }

  bool readBox(std::size_t cell)
  {
    return box_.read(faces_.data() + firstFace_[cell], firstFace_[cell + 1] - firstFace_[cell]);
  }

  int levelOfBox(std::size_t cell) const { return mesh_.boxLevels[cell].most; }

  // Without hanging nodes.
  bool isPlain(std::size_t cell) const
  {
    const auto begin = faces_.begin() + static_cast<std::ptrdiff_t>(firstFace_[cell]);
    return firstFace_[cell + 1] - firstFace_[cell] == 6 &&
      std::all_of(begin, begin + 6,
        [&](std::uint32_t f) { return mesh_.start[f + 1UL] - mesh_.start[f] == 4; });
  }

  // Calls visit(point, halvings) for the points of each face of a cell that can be refined (HexahedralBox.h), and
  // visitFace(face, isWhole) for the faces.
  template <class Visitor, class FaceVisitor>
  void forEachPart(std::size_t cell, Visitor&& visit, FaceVisitor&& visitFace)
  {
    if (!isPlain(cell))
    {
      readBox(cell);
      box_.forEachPoint(visit);
      box_.forEachFace(visitFace);
      return;
    }
    for (std::size_t i = firstFace_[cell]; i < firstFace_[cell + 1]; ++i)
    {
      for (std::size_t c = mesh_.start[faces_[i]]; c < mesh_.start[faces_[i] + 1UL]; ++c)
      {
        visit(mesh_.corners[c], 0);
      }
      visitFace(faces_[i], true);
    }
  }

  // Calls visit(cell) for those that can be refined.
  template <class Visitor>
  void forEachRefinable(Visitor&& visit) const
  {
    for (std::size_t c = 0; c < mesh_.cellCount; ++c)
    {
      if (isRefinable_[c] != 0)
      {
        visit(c);
      }
    }
  }

  void findPointLevels()
  {
    std::fill(levels_.ofPoints.begin(), levels_.ofPoints.end(), Free);
    uses_.assign(levels_.ofPoints.size(), 0);
    forEachRefinable([&](std::size_t c) {
      forEachPart(
        c,
        [&](std::uint32_t point, int halvings) {
          std::int32_t& level = levels_.ofPoints[point];
          level = std::min(level, levelOfBox(c) + halvings);
          ++uses_[point];
        },
        [](std::uint32_t, bool) {});
    });
  }

  // Of cells that cannot be refined: as that of their box, but no more than the faces and neighbours allow.
  void findCellLevels()
  {
    for (std::size_t c = 0; c < mesh_.cellCount; ++c)
    {
      levels_.ofCells[c] = levelOfBox(c);
    }
    bool changes = true;
    while (changes)
    {
      changes = false;
      for (std::size_t f = 0; f < mesh_.owner.size(); ++f)
      {
        const std::uint32_t a = mesh_.owner[f];
        const std::uint32_t b = f < mesh_.neighbour.size() ? mesh_.neighbour[f] : a;
        if (isRefinable_[a] == 0 || isRefinable_[b] == 0)
        {
          const int level = levelOfFace(f);
          const int most = level == Undefined ? Free : level;
          changes |= lower(a, std::min(most, levels_.ofCells[b] + 1));
          changes |= lower(b, std::min(most, levels_.ofCells[a] + 1));
        }
      }
    }
  }

  bool lower(std::uint32_t cell, int most)
  {
    const bool isLower = isRefinable_[cell] == 0 && levels_.ofCells[cell] > most;
    levels_.ofCells[cell] = isLower ? most : levels_.ofCells[cell];
    return isLower;
  }

  // As hexRef8::faceLevel.
  int levelOfFace(std::size_t f) const
  {
    const std::uint32_t* const begin = mesh_.corners.data() + mesh_.start[f];
    const std::uint32_t* const end = mesh_.corners.data() + mesh_.start[f + 1];
    if (end - begin <= 4)
    {
      int most = 0;
      std::for_each(
        begin, end, [&](std::uint32_t p) { most = std::max(most, levels_.ofPoints[p]); });
      return most;
    }
    for (const int level : { levels_.ofCells[mesh_.owner[f]], levels_.ofCells[mesh_.owner[f]] + 1 })
    {
      if (std::count_if(
            begin, end, [&](std::uint32_t p) { return levels_.ofPoints[p] <= level; }) == 4)
      {
        return level;
      }
    }
    return Undefined;
  }

  // Boxes that are wrong, or beside something that is. Whether there are any.
  bool giveUp()
  {
    std::vector<char> isWrong(mesh_.cellCount);
    forEachRefinable([&](std::size_t c) { isWrong[c] = isSound(c) ? 0 : 1; });
    const bool ofFaces = freePointsOfFaces(isWrong);
    const bool ofProtected = freePointsOfProtected();
    if (ofFaces || ofProtected)
    {
      forEachRefinable([&](std::size_t c) { isWrong[c] = isWrong[c] != 0 || hasFreed(c) ? 1 : 0; });
    }
    bool any = false;
    for (std::size_t c = 0; c < mesh_.cellCount; ++c)
    {
      any = any || isWrong[c] != 0;
      isRefinable_[c] = isRefinable_[c] != 0 && isWrong[c] == 0 ? 1 : 0;
    }
    return any;
  }

  bool hasFreed(std::size_t cell)
  {
    bool has = false;
    forEachPart(
      cell, [&](std::uint32_t point, int) { has = has || isFreed_[point] != 0; },
      [](std::uint32_t, bool) {});
    return has;
  }

  // Whether a cell that can be refined would be divided right.
  bool isSound(std::size_t cell)
  {
    const int level = levelOfBox(cell);
    bool sound = true;
    forEachPart(
      cell,
      [&](std::uint32_t point, int halvings) {
        const std::int32_t found = levels_.ofPoints[point];
        sound = sound && (halvings == 0 ? found <= level : found == level + halvings);
      },
      [&](std::uint32_t face, bool isWhole) {
        sound = sound && (!isWhole || levelOfFace(face) == level);
      });
    return sound;
  }

  // Of those that solvers would divide although no cell beside them is refined, or that have too large a step.
  bool freePointsOfFaces(std::vector<char>& isWrong)
  {
    bool any = false;
    for (std::size_t f = 0; f < mesh_.owner.size(); ++f)
    {
      const std::uint32_t a = mesh_.owner[f];
      const std::uint32_t b = f < mesh_.neighbour.size() ? mesh_.neighbour[f] : a;
      const int level = levelOfFace(f);
      const auto [least, most] = std::minmax(levels_.ofCells[a], levels_.ofCells[b]);
      if (most - least > 1 || (level != Undefined && level < most))
      {
        isWrong[a] = isRefinable_[a];
        isWrong[b] = isRefinable_[b];
        any = (isRefinable_[a] == 0 && isRefinable_[b] == 0 &&
                freeOne({ static_cast<std::uint32_t>(f) })) ||
          any;
      }
    }
    return any;
  }

  // Of other cells that have as many anchors as if they could be refined.
  bool freePointsOfProtected()
  {
    bool any = false;
    for (std::size_t c = 0; c < mesh_.cellCount; ++c)
    {
      if (isRefinable_[c] == 0)
      {
        const std::vector<std::uint32_t> faces(
          faces_.begin() + static_cast<std::ptrdiff_t>(firstFace_[c]),
          faces_.begin() + static_cast<std::ptrdiff_t>(firstFace_[c + 1]));
        any = (anchorsOf(faces, levels_.ofCells[c]).size() == Anchors && freeOne(faces)) || any;
      }
    }
    return any;
  }

  // The points of these faces up to a level.
  std::vector<std::uint32_t> anchorsOf(const std::vector<std::uint32_t>& faces, int level) const
  {
    std::vector<std::uint32_t> anchors;
    for (const std::uint32_t f : faces)
    {
      std::copy_if(mesh_.corners.data() + mesh_.start[f],
        mesh_.corners.data() + mesh_.start[f + 1UL], std::back_inserter(anchors),
        [&](std::uint32_t p) { return levels_.ofPoints[p] <= level; });
    }
    std::sort(anchors.begin(), anchors.end());
    anchors.erase(std::unique(anchors.begin(), anchors.end()), anchors.end());
    return anchors;
  }

  // The one that the fewest boxes have, which are given up. False: none has any.
  bool freeOne(const std::vector<std::uint32_t>& faces)
  {
    const std::vector<std::uint32_t> points = anchorsOf(faces, Free - 1);
    const auto found = std::min_element(points.begin(), points.end(),
      [&](std::uint32_t a, std::uint32_t b) { return uses_[a] < uses_[b]; });
    if (found != points.end())
    {
      isFreed_[*found] = 1;
    }
    return found != points.end();
  }

  const FoamMesh& mesh_;
  HexahedralBox box_;
  std::vector<std::size_t> firstFace_; // of each cell in `faces_`, and the end
  std::vector<std::uint32_t> faces_;
  std::vector<char> isRefinable_;  // of each cell
  std::vector<char> isFreed_;      // of each point: no box may have it
  std::vector<std::uint8_t> uses_; // of each point, by the faces of boxes that can be refined
  RefinementLevels levels_;
};

}

std::optional<RefinementLevels> refinementLevels(const FoamMesh& mesh)
{
  return mesh.boxLevels.empty() ? std::nullopt : LevelFinder(mesh).find();
}

}
