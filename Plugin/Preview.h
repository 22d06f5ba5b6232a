// SPDX-License-Identifier: BSD-3-Clause
// A look at what will be meshed, in the window, while values in a panel were not applied.
#pragma once

namespace cartesian
{

// Called when the plugin is loaded. From then on a source that names a filter of its own kind in its hints, whose outputs
// are those of vtkMeshPreview, is shown by it in the active view of the window while it is selected and its panel has values
// that were not applied:
//
//   <Preview group="internal_filters" name="MeshPreview"/>
//
// All that shows it is hidden from the user, states, traces and undo, and ends with Apply or Reset. Scripts have no
// such values.
void showPreviews();

}
