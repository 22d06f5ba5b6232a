// Neighbouring boxes of not too different levels (section 4.5, figure 2).
//
// No side of a box may be touched by more than one split line of its neighbours in each direction:
// across a side, levels along it differ by one at most. A box that is too coarse is halved in that
// direction. This goes round by round: what happens in a round depends on the boxes before it
// only, and a box is halved once a round, along the lowest axis that asks for it. So the result
// depends on no order of visits.
#pragma once

#include "Boxes.h"
#include "Execution.h"

namespace cartesian
{

// For each box, the axis along which it must be halved, or NoAxis. Empty where none must.
constexpr std::uint8_t NoAxis = 3;
std::vector<std::uint8_t> tooCoarse(const Boxes& boxes, Execution& execution);

}
