// SPDX-License-Identifier: BSD-3-Clause
// Measures of the editable mesh (WallObjective.h), and what a node's place means for them.
#pragma once

#include "Editing/MeshEditor.h"
#include "Editing/WallObjective.h"

namespace cartesian
{

// Centre, area, star and warp of a face, and the volume behind a wall, which the delta follows.
void measureFace(MeshEditor& mesh, std::uint32_t f);

// Centre and volume of a cell, of its faces' measures.
void measureCell(MeshEditor& mesh, std::uint32_t c);

// What edits left dirty, whatever its shape; it stays listed. False: a cell has no volume.
bool measureDirty(MeshEditor& mesh);

// A cell's volume by its box's.
double shareOf(const MeshView& mesh, std::uint32_t c);

// Of a face or cell as measured.
Cost<double> costOfFace(const MeshView& mesh, std::uint32_t f, const ObjectiveSpec& spec);
Cost<double> costOfCell(const MeshView& mesh, std::uint32_t c);

// What a face that has a cost by one specification costs by another. Between regions it is measured: of a sum of two sides
// nothing can be undone.
double costBy(
  const MeshView& mesh, std::uint32_t f, const ObjectiveSpec& to, const ObjectiveSpec& from);

// Of a face or cell as measured, as what they cost from now on.
void setCostOfFace(MeshEditor& mesh, std::uint32_t f, const ObjectiveSpec& spec);
void setCostOfCell(MeshEditor& mesh, std::uint32_t c);
void setCost(EditFace& face, const Cost<double>& cost);

// Everything, where no edit is under way; then what that costs, for a specification.
void measureAll(EditMesh& whole, Execution& execution);
void costAll(EditMesh& whole, const ObjectiveSpec& spec, Execution& execution);

// Whether the body is as thin as the cell: most of what it shares with others is with such as are no larger.
bool isThinThere(const MeshView& mesh, std::uint32_t c);

// Whether the cells beside a cell are connected nowhere near but through it, or are too many to tell.
bool isBridge(const MeshView& mesh, std::uint32_t c);

// The cells beside faces that changed since the last commit; they are appended.
void listChanged(const MeshEditor& mesh, std::vector<std::uint32_t>& cells);

// ... of cells that are there and may change, and of their faces.
void costCells(MeshEditor& mesh, Items cells, const ObjectiveSpec& spec);

// How the objective changes with the place of a node: by its coordinates. Nothing is changed. What costs no more than
// `least` is left out: the less it costs, the less it changes.
Vector gradientAt(
  const MeshView& mesh, std::uint32_t node, const ObjectiveSpec& spec, double least = -1);

}
