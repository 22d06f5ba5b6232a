// SPDX-License-Identifier: BSD-3-Clause
// Moves many nodes at once, each a part of its way: where faces would become poor, nodes around them go only half of it, then
// none.
#pragma once

#include "Editing/MeshEditor.h"
#include "Editing/WallObjective.h"

#include <functional>
#include <vector>

namespace cartesian
{

// A wall, also between two regions, of a cell that may change.
bool isFreeWall(const MeshView& mesh, std::uint32_t f);

// Whether a node is on smooth walls, or between the same two regions all around, and only of cells that may change.
bool maySlide(const MeshView& mesh, std::uint32_t n);

// Whether it is where such walls end at one end of the grid, as at a plane of symmetry: it may move in that.
bool maySlideInPlane(const MeshView& mesh, std::uint32_t n);

// The mean of its walls' (MeshEditor::signOf), of length 1; ends of the grid are left out.
Vector normalOfWalls(const MeshView& mesh, std::uint32_t n);

// Whether none of its walls turns far from that.
bool isSmoothAt(const MeshView& mesh, std::uint32_t n, const Vector& normal);

class NodeShifts
{
public:
  // `mostCost`: how much more a face may cost than before; it does not fail if it did not.
  NodeShifts(EditMesh& whole, const ObjectiveSpec& spec, double mostCost, Execution& execution);

  // Calls way(node) for all nodes; 0: it stays.
  void plan(const std::function<Vector(std::uint32_t)>& way);

  // Costs are valid before and afterwards; what walls owe follows what they passed over.
  void make();

  // Calls visit(node) for those that have moved.
  template <class Visitor>
  void forEachMoved(Visitor&& visit) const
  {
    for (const Shift& shift : shifts_)
    {
      shift.part != 0 ? visit(shift.node) : void();
    }
  }

private:
  struct Shift
  {
    std::uint32_t node;
    Vector before; // where it was
    Vector way;
    double part = 1;          // of it
    bool isTakenBack = false; // in this round
  };

  // Faces with a node that moved, cells with such a face: each once.
  struct Reach
  {
    std::uint8_t stamp; // theirs, or higher
    std::vector<std::uint32_t> faces;
    std::vector<std::uint32_t> cells;
  };

  // Of the last reach that has a face or cell; 0: none.
  struct Stamps
  {
    int last = 0;
    std::vector<std::uint8_t> faces;
    std::vector<std::uint8_t> cells;
  };

  template <class Visitor>
  void forEach(const std::vector<std::uint32_t>& list, Visitor&& visit) const;
  template <class Visitor>
  void forEachDependent(const Reach& reach, Visitor&& visit) const;
  template <class Add>
  std::vector<std::uint32_t> gather(std::size_t count, Add&& add) const;

  void place(Shift& shift);
  template <class IsMeant>
  Reach reachOf(const std::vector<std::uint32_t>& shifts, IsMeant&& isMeant);
  void measure(const Reach& reach);
  void findPoor(const Reach& reach);
  bool isWorse(std::uint32_t f) const;
  std::vector<std::uint32_t> takeBack(int round);
  std::vector<std::uint32_t> shiftsAtPoor(bool ofCells) const;
  void setCosts(const Reach& reach);
  void passOver(const Reach& reach);
  double sweptBy(std::uint32_t f) const;

  EditMesh& whole_;
  const MeshEditor mesh_; // to read from
  const ObjectiveSpec& spec_;
  const double mostCost_;
  Execution& execution_;
  RecordVector<Shift> shifts_;       // of nodes that may move, in order
  RawVector<std::uint32_t> shiftOf_; // each node's, or None
  Stamps stamps_;
  RawVector<Cost<double>> costs_;    // of faces in reach, as they are now
  std::vector<std::uint8_t> isPoor_; // faces
  std::vector<std::uint32_t> poor_;  // these
};

}
