#include "SurfaceRepair.h"

#include "Orientation.h"

#include <algorithm>

namespace cartesian
{

std::size_t SurfaceRepair::leaks() const
{
  return static_cast<std::size_t>(
    std::count_if(holes.begin(), holes.end(), [](const Hole& hole) { return hole.leak; }));
}

SurfaceRepair repair(Surface& surface, const Meshlines& planes, Execution& execution)
{
  SurfaceRepair result;
  {
    const SurfaceEdges edges(surface, execution);
    result.duplicates = dropDuplicates(surface, edges, findDuplicates(surface, edges));
  }
  orient(surface, execution);
  const SurfaceEdges edges(surface, execution);
  result.check = check(edges, execution);
  if (!result.check.closed())
  {
    result.holes = closeHoles(surface, edges, planes, execution);
    orient(surface, execution);
  }
  return result;
}

}
