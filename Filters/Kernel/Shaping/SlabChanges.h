// SPDX-License-Identifier: BSD-3-Clause
// Changes of shaping in one slab (Slabs.h) relative to the original wall mesh: cells, faces and nodes. CellComplex
// works with it; at the end of a stage all slabs' changes become the wall mesh (writeBack).
#pragma once

#include "Polyhedra/Polyhedron.h"
#include "Shaping/ShapedWall.h"

#include <map>
#include <unordered_map>

namespace cartesian
{

// A cell that may change, with its own faces.
struct OpenCell
{
  static constexpr std::array<std::uint8_t, 2> NoReach{ 0, 0 };

  // Since it changed.
  struct Known
  {
    IsAtFault fault = IsAtFault::Unknown;
    bool isPlain = false; // as KnownCells::isPlain
    bool isSeen = false;  // its faces' sights are known
  };

  std::vector<FaceUse> faces;
  std::uint32_t box;
  CellKey origin; // the cell that it is or was a part of
  std::int32_t region;
  std::int32_t boundary; // as in Cell
  bool alive = true;
  bool removed = false; // as in Cell
  bool changed = false;
  std::uint32_t changedAt = 0;
  std::array<std::uint8_t, 2> reach = NoReach; // as in Cell
  NeighbourCell place;                         // from the lower corner of its box
  mutable Known known;                         // one thread has a slab

  void change(std::uint32_t now)
  {
    changed = true;
    changedAt = now;
    known = {};
  }

  bool hasChangedSince(std::uint32_t mark) const { return changed && changedAt >= mark; }
};

class OpenCells
{
public:
  // The slab's cells of polyhedral boxes, and its boxes: begins and ends.
  OpenCells(const std::array<CellKey, 2>& ofSlab, const std::array<std::uint32_t, 2>& boxes)
    : first_(ofSlab[0])
    , firstHexahedron_(keyOfHexahedron(boxes[0]))
    , placeOf_(ofSlab[1] - ofSlab[0], None)
    , isOpenHexahedron_(boxes[1] - boxes[0])
  {
  }

  const OpenCell* find(CellKey key) const
  {
    const std::uint32_t place = placeOf(key);
    return place == None ? nullptr : &all_[place];
  }
  OpenCell* find(CellKey key)
  {
    const std::uint32_t place = placeOf(key);
    return place == None ? nullptr : &all_[place];
  }

  void add(CellKey key, OpenCell&& cell)
  {
    const auto place = static_cast<std::uint32_t>(all_.size());
    if (key >= FirstOfCuts) // they come in order
    {
      placeOfCut_.push_back(place);
    }
    else if (const std::size_t i = std::size_t(key) - first_; i < placeOf_.size())
    {
      placeOf_[i] = place;
    }
    else
    {
      others_[key] = place;
    }
    if (const std::size_t n = std::size_t(key) - firstHexahedron_; n < isOpenHexahedron_.size())
    {
      isOpenHexahedron_[n] = true;
    }
    all_.push_back(std::move(cell));
  }

  // Calls visit(key, cell): those of the slab's polyhedral boxes in order, then the others in any order.
  template <class Visitor>
  void forEach(Visitor&& visit) const
  {
    for (std::size_t i = 0; i < placeOf_.size(); ++i)
    {
      if (placeOf_[i] != None)
      {
        visit(static_cast<CellKey>(first_ + i), all_[placeOf_[i]]);
      }
    }
    forEachOther(visit);
  }

  // Of hexahedra, cells made by cuts, and such of polyhedral boxes outside the slab.
  template <class Visitor>
  void forEachOther(Visitor&& visit) const
  {
    for (const auto& [key, place] : others_)
    {
      visit(key, all_[place]);
    }
    for (std::size_t i = 0; i < placeOfCut_.size(); ++i)
    {
      visit(static_cast<CellKey>(FirstOfCuts + i), all_[placeOfCut_[i]]);
    }
  }

  // In the order in which they were opened.
  const std::vector<OpenCell>& all() const { return all_; }
  std::vector<OpenCell>& all() { return all_; }

private:
  std::uint32_t placeOf(CellKey key) const
  {
    if (const std::size_t i = std::size_t(key) - first_; i < placeOf_.size())
    {
      return placeOf_[i];
    }
    if (key >= FirstOfCuts)
    {
      return placeOfCut_[key - FirstOfCuts];
    }
    if (const std::size_t n = std::size_t(key) - firstHexahedron_;
        n < isOpenHexahedron_.size() && !isOpenHexahedron_[n])
    {
      return None;
    }
    const auto found = others_.find(key);
    return found == others_.end() ? std::uint32_t(None) : found->second;
  }

  CellKey first_;
  CellKey firstHexahedron_;
  std::vector<OpenCell> all_;
  std::vector<std::uint32_t> placeOf_;                // in all_, or None: of the slab's cells
  std::vector<std::uint32_t> placeOfCut_;             // the same, of those made by cuts
  std::unordered_map<CellKey, std::uint32_t> others_; // ... of all others
  std::vector<bool> isOpenHexahedron_;                // of the slab's boxes
};

// Faces are numbered on from those of the wall mesh.
struct MadeFace
{
  std::vector<std::uint32_t> nodes;
  std::array<CellKey, 2> cells;
  std::int32_t boundary;
};

struct MadeFaces
{
  std::vector<MadeFace> all;
  Sights sights; // of the first of them
  std::unordered_map<std::uint32_t, std::uint32_t>
    numberOf; // of those of the mesh that are here now
  std::unordered_map<std::uint64_t, std::uint32_t> ofHexahedra; // 6 * box + side
};

// Likewise.
struct MadeNodes
{
  std::vector<Point> at;
  std::map<Point, std::uint32_t> ofCuts;
  std::vector<VertexNode> vertices;
  std::unordered_map<std::uint64_t, std::uint32_t> ofVertex; // of the global mesh
};

}
