// SPDX-License-Identifier: BSD-3-Clause
// Cells that can be cut and joined (sections 4.10 and 4.11), in one slab (Slabs.h).
//
// Cells and faces are copied when they change for the first time ("opened"): untouched ones cost nothing. A
// hexahedron that gets a node or another face becomes a polyhedron.
//
// Slabs of one stage may change at the same time. The only shared data that they write are the cells below and above
// an original face (WallFaces::cells): a slab writes those of its free cells, and reads those of cells that touch
// one; likewise for sights.
#pragma once

#include "Base/EdgeTable.h"
#include "Lattice/PointSortKey.h"
#include "Parts/Slabs.h"
#include "Polyhedra/PolyhedronCut.h"
#include "Shaping/FaceJoining.h"
#include "Shaping/SlabChanges.h"

#include <map>
#include <memory>
#include <optional>

namespace cartesian
{

// A cell and its neighbours beyond each face.
struct MeasuredCell
{
  Polyhedron shape; // without nodes in common; the origin is the lower corner of its box
  CellShape measures;
  std::vector<CellKey> across; // or None
  std::vector<NeighbourCell> beyond;
};

// The cells of its region beyond its faces that are alive, each with the area between them (lattice
// levels), the largest first.
std::vector<std::pair<CellKey, double>> neighboursOf(const MeasuredCell& cell);

class CellComplex
{
public:
  CellComplex(ShapedWall& whole, const Slab& slab);

  // Of cells of polyhedral boxes, opened or not, and opened others.
  // Several neighbours as one; the origin is the lower corner of the first one's box.
  void view(const std::vector<CellKey>& keys, CellView& view) const;

  // Fills CellView::beyond; `key`: the view's first cell.
  void lookBeyond(CellKey key, CellView& view) const;

  // A cell, and where it is from the lower corner of another's box.
  NeighbourCell placeFrom(CellKey other, CellKey key) const
  {
    return placeAndVolume(key, whole_.boxes.lowOf(boxOf(other)));
  }

  // Without nodes in common: for measures only.
  void shape(CellKey key, Polyhedron& shape) const;
  void lookAround(CellKey key, MeasuredCell& cell) const;

  // From the lower corner of one's box to that of the other's.
  Vector between(CellKey from, CellKey to) const;

  std::vector<std::pair<CellKey, double>> neighbours(CellKey key) const;

  // Whether is(other) for a cell beyond one of its faces.
  template <class Is>
  bool anyBeyond(CellKey key, Is&& is) const;

  // The acting cells that are alive and free, except untouched hexahedra, in order.
  std::vector<CellKey> polyhedra() const;

  // Of these, those at fault.
  std::vector<CellKey> polyhedraAtFault() const;

  // Of these, those that have changed, or have a neighbour that has, since `mark` was called.
  std::uint32_t mark() { return ++now_; }
  std::vector<CellKey> polyhedraChangedSince(std::uint32_t mark) const;

  // All that have, and the cells beside them, in order, each once; None may be among them.
  std::vector<CellKey> allChangedSince(std::uint32_t mark) const;

  // Free cells that the slab does not look after, but has changed, or one beside them.
  std::vector<CellKey> othersTouched() const;

  // Whether it, or a cell beyond one of its faces, or one beyond theirs, has changed since then.
  bool hasChangedNear(CellKey key, std::uint32_t mark) const;

  // Whether it may change: all of it lies in the slab's free layers.
  bool isFree(CellKey key) const;

  // Whether the slab also looks after it: is free, and its box lies in the slab's acting layers.
  bool isActing(CellKey key) const;

  // Whether all are free, of one region, and do not lie in too many layers for one cell.
  bool mayMerge(const std::vector<CellKey>& keys) const;

  // Whether together they would be fixed in the second stage, beside cells that are not.
  bool wouldStraddleStages(const std::vector<CellKey>& keys) const;

  // Cosine of Feature Angle.
  double featureCosine() const { return whole_.featureCosine; }

  bool hasRegions() const { return whole_.patches.walls.any(); }
  std::int32_t regionOf(CellKey key) const;

  // The wall (Walls.h) between a free cell and another region, if it has no other wall, and all its neighbours are free.
  std::optional<std::int32_t> onlyWallOf(CellKey key) const;

  // Moves a cell to the region beyond its only wall: that goes to its other faces. Once more takes it back.
  void changeRegion(CellKey key, std::int32_t wall);

  // 1 if it belongs to the part that is meshed (Boxes::core), else 0.
  std::size_t counts(CellKey key) const
  {
    return whole_.boxes.isCore(whole_.boxes.packed[boxOf(key)]) ? 1 : 0;
  }

  const Boxes& boxes() const { return whole_.boxes; }
  std::uint32_t boxOf(CellKey key) const;
  bool isAlive(CellKey key) const; // neither removed nor merged

  // Hexahedra that have not been opened do not.
  bool hasFaces(CellKey key) const { return isOfWall(key) || opened(key) != nullptr; }

  void open(CellKey key);

  // The cells that a cut changes, `key` first: beyond cut faces, and around cut edges. Opens them.
  std::vector<CellKey> touchedBy(CellKey key, const CellView& view, const CellCut& cut);

  // Whether a cut of the first of these cells spoils none of them: no new point falls on a node of
  // theirs, or on another, or spoils the star triangulation of a face, no piece of a face is one that
  // the cell beyond has already, none of the others is thin, and all are free.
  bool allows(const std::vector<CellKey>& touched, const CellView& view, const CellCut& cut) const;

  // Cuts an opened cell. The first part keeps its key. Appends the keys of all parts.
  void cut(CellKey key, const CellView& view, const CellCut& cut, std::vector<CellKey>& parts);

  // Gives the small cell's faces to the other except those between them, which vanish.
  void merge(CellKey small, CellKey into);

  // Its inner faces become boundary faces of its neighbours (4.10).
  void remove(CellKey key);

  // Whether a cell near this one has a face with these nodes already: with another, it would enclose nothing. Of a
  // cell that is not free only those around these nodes are examined.
  bool hasFaceNear(CellKey key, std::vector<std::uint32_t> nodes) const;

  // Whether the union of several faces of a cell, as seen from it, already exists.
  bool hasFacesNear(CellKey key, const CellView& view, const JoinedFaces& joined) const;

  // Joins each group of faces of an opened cell, as seen from it.
  void join(CellKey key, const CellView& view, const JoinedFaces& joined);

  // Gives a face of free cells other corners, as the cell below has it; without any, it goes.
  void reform(std::uint32_t face, const std::vector<std::uint32_t>& ring);

  // That most of its patches belonged to, or NoBoundary.
  std::int32_t boundaryOfCell(CellKey key) const;

  // Whether one of its faces is a boundary face now, and none is shared with another region: removing a cell there
  // leaves a hole.
  bool isAtBoundary(CellKey key) const;

  // Of its boundary faces as they are now, by boundary; square levels.
  std::map<std::int32_t, double> wallAreas(CellKey key) const;

  // Of these, that with the largest area; without any, its own.
  std::int32_t mainBoundary(CellKey key) const;

  // In lattice levels.
  double volumeOfBox(CellKey key) const;
  double volume(CellKey key) const;

  // Its volume as a part of its box's.
  double share(CellKey key) const;

  // As isAnyAtFault (CellFaults.h): known beforehand for cells as they were.
  bool isAtFault(CellKey key) const;

  // Whether all its faces pass by what is known beforehand; else its neighbours must be examined.
  bool isSurelyAccepted(CellKey key) const;

  // Whether all its inner faces surely cost little (CellCost.h), and its boundary faces are plain.
  bool isSurelyGood(CellKey key) const;

  // Makes that known of cells that have changed.
  void lookAtChanged();

  bool changed() const { return changed_; }

private:
  friend class ShapedCells; // writes all back
  friend struct ShapedWall; // measures

  struct FaceNodes
  {
    const std::uint32_t* first;
    std::size_t size;
  };
  // Scratch space for reading, kept for its memory.
  struct Scratch
  {
    struct Outer
    {
      FaceUse use;
      CellKey other;
      std::size_t begin; // of its corners
      std::size_t end;
    };
    std::vector<Outer> faces;
    std::vector<std::uint32_t> corners;
    std::vector<PointSortKey> places; // of nodes, each once
    EdgeTable numberOf;               // of nodes: edges from them to themselves
    Polyhedron polyhedron;
    CellShape measures;
    MeasuredCell cell;
    BesideHexahedron beside;
  };

  static bool isOfWall(CellKey key) { return key < FirstHexahedron; }

  std::uint32_t firstMade() const { return static_cast<std::uint32_t>(whole_.mesh.faces.size()); }
  bool isMadeHere(std::uint32_t face) const { return face >= firstMade(); }
  MadeFace& made(std::uint32_t face) { return madeFaces_.all[face - firstMade()]; }
  const MadeFace& made(std::uint32_t face) const { return madeFaces_.all[face - firstMade()]; }

  template <class Visitor>
  void forEachFace(CellKey key, Visitor&& visit) const;
  void addFaceTo(Polyhedron& shape, const FaceUse& use, const Point& origin) const;
  template <class Visitor>
  void forEachNodeOf(const FaceUse& use, Visitor&& visit) const;
  FaceNodes nodesOf(std::uint32_t face) const;

  const Point& placeOf(std::uint32_t node) const
  {
    const std::vector<Point>& at = whole_.nodes.at;
    return node < at.size() ? at[node] : madeNodes_.at[node - at.size()];
  }
  std::uint32_t nextNode() const
  {
    return static_cast<std::uint32_t>(whole_.nodes.at.size() + madeNodes_.at.size());
  }
  template <class Kept>
  std::vector<CellKey> select(Kept&& isKept) const;
  Layers layersOf(CellKey key) const;
  Layers layersOf(const std::vector<CellKey>& keys) const;
  OpenCell* opened(CellKey key) { return open_.find(key); }
  const OpenCell* opened(CellKey key) const { return open_.find(key); }
  std::array<CellKey, 2> cellsOf(std::uint32_t face) const;
  CellKey across(const FaceUse& use) const;

  // Whether a face is between two regions. For solvers of one of them it is at the boundary; but a cut of it
  // is one for both.
  bool isInterface(const FaceUse& use) const;
  void setCell(const FaceUse& use, CellKey key);
  bool hasChanged(CellKey key) const;
  bool isSeen(CellKey key) const;
  template <class Accept>
  bool allSights(CellKey key, Accept&& accept) const;
  void noteSights(CellKey key, const CellShape& measures, Sights& given, Sights& ofMade) const;

  void openHexahedron(std::uint32_t box, OpenCell& cell);
  void addSideOfHexahedron(std::uint32_t box, unsigned side, OpenCell& cell);
  void numberNodes(const Point& origin, CellView& view) const;
  std::uint32_t nodeOfCorner(std::uint32_t box, unsigned corner);

  bool hasEdge(const FaceUse& use, std::uint32_t u, std::uint32_t v) const;
  std::vector<CellKey> cellsAround(CellKey key, std::uint32_t u, std::uint32_t v);
  std::uint32_t own(std::uint32_t face);
  void makeWall(std::uint32_t face, std::int32_t wall);
  Point placeOfPoint(CellKey key, const CellCut::NewNode& point) const;
  bool meetsNode(
    const std::vector<CellKey>& touched, const CellView& view, const CellCut& cut) const;
  bool meetsFace(const CellView& view, const CellCut& cut) const;
  bool losesStar(const FaceUse& use, CellKey key, const CellView& view, const CellCut& cut) const;
  std::uint32_t nodeAt(const Point& place, const std::vector<std::uint32_t>& inOrder) const;
  const std::vector<std::uint32_t>& nodesInOrder();
  std::uint32_t addNode(const Point& place);
  std::vector<std::uint32_t> insertNodes(
    CellKey key, const CellView& view, const CellCut& cut, std::vector<CellKey>& touched);
  std::vector<CellKey> addParts(CellKey key, std::uint32_t count);
  void addCutFace(MadeFace face);
  FaceUse addFace(MadeFace face);
  FaceUse addPiece(FaceUse use, MadeFace piece, std::uint32_t& owned);
  std::uint32_t renamed(std::uint32_t face) const;
  const CellShape& measured(CellKey key) const; // until the next
  NeighbourCell measuredPlace(CellKey key) const;
  void remeasure(std::vector<CellKey>& keys);
  NeighbourCell placeAndVolume(CellKey key, const Point& origin) const;
  void insertNode(CellKey cell, std::uint32_t u, std::uint32_t v, std::uint32_t node);

  std::int32_t boundaryOf(std::uint32_t face) const;
  void reachAsFarAs(CellKey small, CellKey into);
  void setNodes(std::uint32_t face, std::vector<std::uint32_t> nodes);
  void removeFace(CellKey key, std::uint32_t face);
  void dropTwins(std::vector<FaceUse>& faces, std::size_t ofSmall);

  ShapedWall& whole_; // only the cells of faces, and sights, change
  Slab slab_;
  OpenCells open_;
  MadeFaces madeFaces_;
  MadeNodes madeNodes_;
  std::vector<std::uint32_t> nodesInOrder_; // once a cut needs them
  std::vector<CellKey> acting_;             // alive and free, as they were
  std::array<std::uint32_t, 2> freeBoxes_;  // begin and end
  CellKey nextKey_ = FirstOfCuts;
  std::uint32_t now_ = 0;
  bool changed_ = false;
  mutable Scratch scratch_; // one thread has a slab
};

// Writes back what the slabs of one stage changed: cells, nodes, and the sides' list of polyhedral
// boxes. Numbers follow from the order of slabs, and in each from what happened there.
void writeBack(
  ShapedWall& whole, const std::vector<std::unique_ptr<CellComplex>>& slabs, Execution& execution);

template <class Visitor>
void CellComplex::forEachFace(CellKey key, Visitor&& visit) const
{
  if (const OpenCell* cell = opened(key))
  {
    std::for_each(cell->faces.begin(), cell->faces.end(), visit);
    return;
  }
  whole_.mesh.forEachUse(key, visit);
}

template <class Is>
bool CellComplex::anyBeyond(CellKey key, Is&& is) const
{
  bool any = false;
  forEachFace(key, [&](const FaceUse& use) {
    const CellKey other = any ? None : across(use);
    any = any || (other != None && is(other));
  });
  return any;
}

inline CellComplex::FaceNodes CellComplex::nodesOf(std::uint32_t face) const
{
  if (!isMadeHere(face))
  {
    const std::size_t first = whole_.mesh.faces.start[face];
    return { whole_.mesh.faces.corners.data() + first, whole_.mesh.faces.start[face + 1] - first };
  }
  return { made(face).nodes.data(), made(face).nodes.size() };
}

// Counter-clockwise from outside the cell that uses the face.
template <class Visitor>
void CellComplex::forEachNodeOf(const FaceUse& use, Visitor&& visit) const
{
  const FaceNodes nodes = nodesOf(use.face);
  for (std::size_t i = 0; i < nodes.size; ++i)
  {
    visit(nodes.first[use.turned ? nodes.size - 1 - i : i]);
  }
}

}
