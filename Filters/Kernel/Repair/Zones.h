// SPDX-License-Identifier: BSD-3-Clause
// Zones of a flow domain: a closed surface that is no body divides the space around bodies, as that of a rotor, a porous
// medium or a heat source does. Bodies may pass through it.
//
// Bodies, zones and what is around them are separated as regions are (Regions.h), bodies first. Then they change their numbers:
// the space around becomes the first region, zones follow in order, and bodies are outside.
#pragma once

#include "Repair/Regions.h"

namespace cartesian
{

// `zones`: their boundaries, in order; Surface::region is empty. As separateRegions(); Surface::around is of the first region.
std::vector<ClosedContact> separateZones(Surface& surface, const std::vector<std::int32_t>& zones,
  const Meshlines& planes, RegionSpec spec, Execution& execution);

}
