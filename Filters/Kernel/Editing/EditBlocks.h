// SPDX-License-Identifier: BSD-3-Clause
// Edits on all threads, with the same bits on any number of them: cells are looked at block by block (EditBlockDivision.h), each
// with its surroundings free. Blocks that have these in common are edited in turn, others at the same time.
#pragma once

#include "Editing/LoopMemory.h"
#include "Editing/MeshEditor.h"

#include <functional>
#include <memory>

namespace cartesian
{

// What an editor looks at.
struct ZoneTask
{
  MeshEditor& mesh;
  LoopMemory& memory;
  const std::vector<std::uint32_t>& cells; // to be looked at, in order
  Items zone;                              // all that are free, except those that are made
  const std::vector<std::uint32_t>& turns; // of cells: when their block looks at them; 0: none does
  std::uint32_t turn;                      // of this block

  // Calls visit(face) for the faces of these cells, those between two of them twice.
  template <class Visitor>
  void forEachFace(Visitor&& visit) const
  {
    for (const std::uint32_t c : cells)
    {
      for (std::size_t i = 0; !mesh.cell(c).gone && i < mesh.cell(c).faces.size; ++i)
      {
        visit(mesh.facesOf(c)[i]);
      }
    }
  }

  // Whether a later block looks at a cell. `isHere`: of `cells`.
  bool isDeferred(std::uint32_t c, bool isHere) const
  {
    return !isHere && c < turns.size() && turns[c] > turn;
  }

  ZoneTask with(const std::vector<std::uint32_t>& others) const
  {
    return { mesh, memory, others, zone, turns, turn };
  }
};

using ZoneWork = std::function<void(const ZoneTask&)>;

// Of all cells but ghosts. They belong to zone 0 before and after each edit.
class BlockEditing
{
public:
  BlockEditing(EditMesh& mesh, Execution& execution);
  ~BlockEditing();

  BlockEditing(const BlockEditing&) = delete;
  BlockEditing& operator=(const BlockEditing&) = delete;

  // Calls work for each block that has some of these cells, of which alone it looks at.
  void edit(
    const std::vector<std::uint32_t>& cells, const EditBlockSize& size, const ZoneWork& work);

  // ... of all cells.
  void edit(const EditBlockSize& size, const ZoneWork& work);

  // Puts all lists into the first arena: the last call.
  void finish();

private:
  class State;
  std::unique_ptr<State> state_;
};

}
