// SPDX-License-Identifier: BSD-3-Clause
// The faces of one polyhedral box: its patches and the inner faces of its sides, and which of them are
// connected by edges (section 6, step B1).
#pragma once

#include "Base/DisjointSets.h"
#include "Base/EdgeTable.h"
#include "Cells/WallMesh.h"

#include <algorithm>

namespace cartesian
{

// Keeps its storage from box to box. Faces are numbered from 0 in each box.
class BoxFaces
{
public:
  BoxFaces(const Patches& patches, const Sides& sides, const InnerFaces& inner)
    : patches_(patches)
    , sides_(sides)
    , inner_(inner)
  {
  }

  // Takes the faces around a region in the n-th polyhedral box and connects those that share an edge.
  // Returns false if they do not close: one of the sides is flawed, or at some edge the faces do not cancel
  // (as many run through it one way as the other).
  bool gather(std::size_t n, std::int32_t region) { return list(n, region) && connect(); }

  std::size_t size() const { return faces_.size(); }
  const FaceUse& operator[](std::size_t face) const { return faces_[face]; }
  bool isPatch(std::size_t face) const { return faces_[face].face < patches_.size(); }

  // The first of the faces that a face is connected with.
  std::uint32_t root(std::uint32_t face) { return sets_.find(face); }

  // Whether an edge has more than two faces. Nearly no box has such edges; without them, no two faces
  // of a volume can coincide.
  bool hasSharedEdges() const { return !shared_.empty(); }

  // Calls visit(node) for the corners of a face, counter-clockwise from outside.
  template <class Visitor>
  void forEachCorner(std::size_t face, Visitor&& visit) const
  {
    const CornerRange& corners = corners_[face];
    if (corners.turned)
    {
      for (const std::uint32_t* corner = corners.last; corner != corners.first; --corner)
      {
        visit(corner[-1]);
      }
    }
    else
    {
      std::for_each(corners.first, corners.last, visit);
    }
  }

  std::uint32_t firstCorner(std::size_t face) const
  {
    return corners_[face].turned ? corners_[face].last[-1] : *corners_[face].first;
  }

  // The corners of a face, lowest first, in their order or in the opposite one.
  using Cycle = std::vector<std::uint32_t>;
  Cycle cycleOf(std::uint32_t face, bool opposite) const;

  // Patches and their cycles, sorted by cycle.
  using Cycles = std::vector<std::pair<Cycle, std::uint32_t>>;
  void listPatchCycles(const std::vector<std::uint32_t>& faces, Cycles& cycles) const;

  // Whether parts of the surface overlap: they share walls that face the same way, so there are several
  // volumes in one place. Where as many walls face the other way, volumes only touch.
  bool anyPatchTwice();

private:
  // As the face's array has them.
  struct CornerRange
  {
    const std::uint32_t* first;
    const std::uint32_t* last;
    bool turned;

    std::size_t size() const { return static_cast<std::size_t>(last - first); }
  };

  // An edge of a face.
  struct FaceEdge
  {
    std::uint32_t lower;
    std::uint32_t upper;
    std::uint32_t face;
    int direction;

    bool operator<(const FaceEdge& other) const
    {
      return lower != other.lower
        ? lower < other.lower
        : (upper != other.upper ? upper < other.upper : face < other.face);
    }
    bool sameEdge(const FaceEdge& other) const
    {
      return lower == other.lower && upper == other.upper;
    }
  };

  template <class Visitor>
  void forEachEdge(std::size_t face, Visitor&& visit) const;
  bool list(std::size_t n, std::int32_t region);
  void add(const FaceUse& face);
  bool connect();
  bool joinInPairs();
  void listEdges();
  void joinFlatCells();
  void joinAtSharedEdges();

  // In firstAtEdge_: the edge has both its faces.
  static constexpr std::uint32_t Paired = EdgeTable::Fresh - 1;

  const Patches& patches_;
  const Sides& sides_;
  const InnerFaces& inner_;
  std::vector<FaceUse> faces_;       // as WallFaces numbers them
  std::vector<CornerRange> corners_; // of each face
  std::vector<FaceEdge> edges_;
  EdgeTable firstAtEdge_; // twice the first face at each edge, plus 1 if it runs up; then Paired
  DisjointSets sets_;     // of faces
  std::vector<std::pair<std::size_t, std::size_t>> shared_; // ranges of edges_
  Cycles cycles_;
};

}
