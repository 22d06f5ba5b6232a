// SPDX-License-Identifier: BSD-3-Clause
// Moves many nodes at once, each a part of its way: where faces would become poor, nodes around them go only half of it, then
// none.
#pragma once

#include "Editing/MeshEditor.h"
#include "Editing/WallObjective.h"

#include <functional>

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

  bool hasMoved(std::uint32_t n) const { return shifts_[n].part != 0; }
  const Vector& before(std::uint32_t n) const { return shifts_[n].before; }

private:
  struct Shift
  {
    Vector before{}; // where the node was
    Vector way{};
    double part = 0;          // of it
    bool isTakenBack = false; // in this round
  };

  // Faces with a node that moved, cells with such a face.
  struct Reach
  {
    std::vector<std::uint8_t> faces;
    std::vector<std::uint8_t> cells;
  };

  void forEach(std::size_t count, const std::function<void(std::uint32_t)>& visit);
  void place(std::uint32_t n);
  void find(Reach& reach, bool Shift::*isTakenBack);
  void measure(const Reach& reach);
  bool dependsOn(const Reach& reach, std::uint32_t f) const;
  void findPoor(const Reach& reach);
  bool isWorse(std::uint32_t f) const;
  bool takeBack(int round);
  bool isAnyPoor(std::uint32_t n, bool ofCells) const;
  void setCosts();
  void passOver();
  double sweptBy(std::uint32_t f) const;

  EditMesh& whole_;
  const MeshEditor mesh_; // to read from
  const ObjectiveSpec& spec_;
  const double mostCost_;
  Execution& execution_;
  RecordVector<Shift> shifts_;
  Reach near_;                       // of all that moved
  Reach now_;                        // of what was taken back in this round
  std::vector<std::uint8_t> isPoor_; // faces
};

}
