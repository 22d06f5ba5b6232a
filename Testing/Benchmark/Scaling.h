// Speed-up by threads: from the processor time of each chunk on one thread follows the time on many, on machines
// that have fewer, and other work to do.
//
// Not considered: that threads share caches and memory, and what it takes to wake them (microseconds a loop).
#pragma once

#include <string>
#include <vector>

namespace cartesian
{

// Prints two tables for each file: speed-ups by the number of threads; and seconds by stage, serial, in loops, and on
// numbers of threads. Among the arguments, a number: how many cells
// across surfaces, from there on. Without files, for a sphere.
void printScaling(const std::vector<std::string>& arguments);

}
