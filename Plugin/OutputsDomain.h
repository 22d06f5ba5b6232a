// SPDX-License-Identifier: BSD-3-Clause
// Inputs that must be outputs of some sources, such as those of one mesher.
#pragma once

namespace cartesian
{

// Called when the plugin is loaded. From then on there is, for an InputProperty, the domain of outputs, from one on, of
// sources with these names:
//
//   <OutputsDomain name="boundary" of="CartesianMesher CellAssembler" first="1"/>
void registerOutputsDomain();

}
