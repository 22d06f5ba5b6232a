// SPDX-License-Identifier: BSD-3-Clause
// Which nodes may move where, and which may merge, so that no face is inverted or leaves the surface.
#pragma once

#include "Collapse/EdgeCollapse.h"
#include "Collapse/MergingNodes.h"

namespace cartesian
{

// Keeps its storage from node to node; each thread needs one of its own.
class CollapseChecks
{
public:
  CollapseChecks(const Boxes& boxes, const EdgeCollapseSpec& spec, const Patches& patches,
    const MergingNodes& merging);

  // Whether a node may move there without leaving the surface, its features and the ends of the grid.
  // `unit`: the shortest edge of the smallest box around.
  bool mayMove(std::uint32_t slot, const Point& to, double unit);

  // Whether all walls (Walls.h) at a node are also at another: else a region between them would lose its
  // thickness where the first becomes the second.
  bool keepsWalls(std::uint32_t slot, std::uint32_t to);

  // The curvature of the surface at a node: the smallest cosine between the normals of patches there; 2 where there
  // is none.
  double bendAt(std::uint32_t slot);

  // Whether two nodes may become one: a node next to both must be the third corner of a triangle, else
  // faces would touch.
  bool closesUp(std::uint32_t a, std::uint32_t b);

  // Calls visit(ring) for the faces at a node that are wrong since it moved; a ring may come twice.
  template <class Visitor>
  void forEachBadFace(std::uint32_t slot, Visitor&& visit)
  {
    twins_.clear();
    merging_.forEachFaceAt(slot, [&](std::uint32_t face) {
      merging_.ringOf(face, ring_);
      if (!isGood(face))
      {
        visit(ring_);
      }
      else if (ring_.size() > 2)
      {
        twins_.emplace_back(keyOfRing(), face);
      }
    });
    // A cell that became flat vanishes where one of its two faces is a patch; two inner faces would
    // remain as a wall.
    std::sort(twins_.begin(), twins_.end());
    twins_.erase(std::unique(twins_.begin(), twins_.end()), twins_.end());
    for (std::size_t i = 0; i + 1 < twins_.size(); ++i)
    {
      if (twins_[i].first == twins_[i + 1].first &&
        (merging_.isPatch(twins_[i].second) == merging_.isPatch(twins_[i + 1].second) ||
          isInterface(twins_[i].second) || isInterface(twins_[i + 1].second)))
      {
        merging_.ringOf(twins_[i].second, ring_);
        visit(ring_);
      }
    }
  }

private:
  bool isOnSurface(std::uint32_t slot);
  bool staysOnGrid(const Point& from, const Point& to) const;
  void listBorders(std::uint32_t slot, std::uint32_t face);
  void listWalls(std::uint32_t slot, std::vector<std::int32_t>& walls);
  double distanceFromBorders(std::uint32_t slot, const Point& to);
  bool isGood(std::uint32_t face) const;

  // Between two regions (Walls.h): a cell that becomes flat there must stay, as nothing else lies between its
  // neighbours.
  bool isInterface(std::uint32_t face) const
  {
    return merging_.isPatch(face) && patches_.walls.isInterface(patches_.boundary[face]);
  }
  std::uint64_t keyOfRing() const;

  template <class Visitor>
  void forEachNeighbour(std::uint32_t slot, Visitor&& visit);

  const Boxes& boxes_;
  const EdgeCollapseSpec& spec_;
  const Patches& patches_;
  const MergingNodes& merging_;
  double featureCosine_;
  std::vector<std::uint32_t> ring_;
  std::vector<Vector> normals_;
  std::vector<std::pair<std::uint32_t, std::int32_t>> borders_; // next node, boundary
  std::array<std::vector<std::int32_t>, 2> walls_;
  std::vector<std::uint32_t> near_;
  std::vector<std::uint32_t> thirds_;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> twins_; // key of the corners, face
};

}
