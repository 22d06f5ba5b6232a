// SPDX-License-Identifier: BSD-3-Clause
// Nodes at short edges, the nodes that they were merged with so far, and the faces around them.
#pragma once

#include "Base/Sorting.h"
#include "Collapse/ShortEdgeList.h"
#include "Lattice/Vector.h"

#include <algorithm>

namespace cartesian
{

// Such a node is called a slot, and numbered from 0. Borrows the faces that it is given.
class MergingNodes
{
public:
  struct Slot
  {
    std::uint32_t node;
    std::uint32_t into; // slot that it is part of, else itself
    std::uint32_t next; // ring of the slots that are one
    Point at;           // of the slot that stays
  };

  MergingNodes(const Patches& patches, const Nodes& nodes, const InnerFaces& inner)
    : patches_(patches)
    , nodes_(nodes)
    , inner_(inner)
  {
  }

  // Takes the ends of the edges.
  void find(const std::vector<ShortEdge>& edges, Execution& execution);

  std::size_t size() const { return slots_.size(); }
  Slot& operator[](std::size_t slot) { return slots_[slot]; }
  const Slot& operator[](std::size_t slot) const { return slots_[slot]; }
  std::vector<Slot>::const_iterator begin() const { return slots_.begin(); }
  std::vector<Slot>::const_iterator end() const { return slots_.end(); }

  // The slot of a node, or None.
  std::uint32_t ofNode(std::uint32_t node) const { return slotOf_[node]; }

  bool isGridNode(std::uint32_t slot) const { return slots_[slot].node >= nodes_.patchPoints; }

  // The slot that a slot is part of: the one that it was in when the round began may itself have merged
  // into another since.
  std::uint32_t standing(std::uint32_t slot) const { return slots_[slots_[slot].into].into; }

  const Point& placeOf(std::uint32_t node) const
  {
    return slotOf_[node] == None ? nodes_.at[node] : slots_[standing(slotOf_[node])].at;
  }

  // Faces: patches, then inner faces.
  bool isPatch(std::uint32_t face) const { return face < patches_.size(); }

  // Whether test(face) is true for any face at all nodes that became this one; faces may come twice.
  template <class Test>
  bool anyFaceAt(std::uint32_t slot, Test&& test) const
  {
    std::uint32_t s = slot;
    do
    {
      if (std::any_of(facesOf_.begin(s), facesOf_.end(s),
            [&](const FaceOfSlot& use) { return test(use.face); }))
      {
        return true;
      }
      s = slots_[s].next;
    } while (s != slot);
    return false;
  }

  // Calls visit(face) for all of them.
  template <class Visitor>
  void forEachFaceAt(std::uint32_t slot, Visitor&& visit) const
  {
    anyFaceAt(slot, [&](std::uint32_t face) {
      visit(face);
      return false;
    });
  }

  // Calls visit(slot) for the slots that share a face with a slot, as they are one now; they come several times.
  template <class Visitor>
  void forEachSlotAround(std::uint32_t slot, Visitor&& visit) const
  {
    forEachFaceAt(slot, [&](std::uint32_t face) {
      const auto [begin, end] = cornersOf(face);
      std::for_each(begin, end, [&](std::uint32_t node) {
        if (slotOf_[node] != None)
        {
          visit(standing(slotOf_[node]));
        }
      });
    });
  }

  // The corners that a face has left.
  void ringOf(std::uint32_t face, std::vector<std::uint32_t>& ring) const
  {
    const auto [begin, end] = cornersOf(face);
    ringOf(begin, end, ring);
  }

  void ringOf(
    const std::uint32_t* begin, const std::uint32_t* end, std::vector<std::uint32_t>& ring) const;

  // Twice the area vector of a ring, and of a face before anything moved.
  Vector areaOf(const std::vector<std::uint32_t>& ring) const;
  Vector originalArea(std::uint32_t face) const;

private:
  struct FaceOfSlot
  {
    std::uint32_t slot;
    std::uint32_t face;

    bool operator<(const FaceOfSlot& other) const { return face < other.face; }
  };

  // Begin and end.
  std::array<const std::uint32_t*, 2> cornersOf(std::uint32_t face) const
  {
    const bool patch = isPatch(face);
    const std::size_t f = patch ? face : face - patches_.size();
    const std::size_t* const start = (patch ? patches_.start : inner_.start).data() + f;
    const std::uint32_t* const corners = (patch ? patches_.corners : inner_.nodes).data();
    return { corners + start[0], corners + start[1] };
  }

  void listFaces(Execution& execution);

  const Patches& patches_;
  const Nodes& nodes_;
  const InnerFaces& inner_;
  std::vector<std::uint32_t> slotOf_; // of nodes, or None
  std::vector<Slot> slots_;
  Buckets<FaceOfSlot> facesOf_; // of slots
};

}
