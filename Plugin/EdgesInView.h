// SPDX-License-Identifier: BSD-3-Clause
// Edges of our outputs where there are not too many to see.
#pragma once

namespace cartesian
{

// Called when the plugin is loaded. From then on a new representation of an output with the hint RepresentationType
// "Surface With Edges" has edges while it has at most 60,000 cells, also after the source has changed; until somebody
// else chooses what it shows.
void watchEdges();

}
