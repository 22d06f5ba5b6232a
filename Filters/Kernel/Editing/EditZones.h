// SPDX-License-Identifier: BSD-3-Clause
// Edits on all threads, with the same bits on any number of them: cells are divided into zones, each of which has an editor
// of its own at the same time as the others.
//
// Zones end at planes. Cells that share a node with two zones are fixed, and no cell near them is looked at yet: in the next
// round zones end across other directions. What is left after some rounds lies in small groups far from each other: these
// are the last zones. Thus every cell is looked at once, with its surroundings free.
#pragma once

#include "Editing/MeshEditor.h"

#include <functional>

namespace cartesian
{

// What an editor looks at.
struct ZoneTask
{
  MeshEditor& mesh;
  const std::vector<std::uint32_t>& cells; // to be looked at, in order
  Items zone;                              // all of the zone, except those that are made
  const std::vector<std::uint8_t>&
    isDone; // of all cells before this round: looked at in an earlier one

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

  // Whether a later round looks at a cell. `isHere`: of `cells`.
  bool isDeferred(std::uint32_t c, bool isHere) const
  {
    return !isHere && c < isDone.size() && isDone[c] == 0;
  }
};

// Calls work for each zone of each round. All cells belong to zone 0 before and afterwards, and all lists to the first
// arena. `looksAgain`: the last zones also have the cells of faces that fail then.
void editInZones(EditMesh& mesh, Execution& execution,
  const std::function<void(const ZoneTask&)>& work, bool looksAgain = false);

// Calls work for each connected group of some cells, in order, with their surroundings.
void editInGroups(EditMesh& mesh, Execution& execution, const std::vector<std::uint32_t>& cells,
  const std::function<void(const ZoneTask&)>& work);

}
