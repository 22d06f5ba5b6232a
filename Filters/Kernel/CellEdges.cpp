#include "CellEdges.h"

#include "CellGeometry.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace cartesian
{

void CellEdges::sort()
{
  std::sort(edges_.begin(), edges_.end(), [](const Edge& left, const Edge& right) {
    return std::tie(left.low, left.high, left.ahead, left.face) <
      std::tie(right.low, right.high, right.ahead, right.face);
  });
}

CellEdges::Result CellEdges::measureGroup(
  std::size_t begin, std::size_t end, const std::vector<Vector>& areas, const Vector& along) const
{
  // Back comes before ahead.
  const auto middle = static_cast<std::size_t>(
    std::find_if(edges_.begin() + static_cast<std::ptrdiff_t>(begin),
      edges_.begin() + static_cast<std::ptrdiff_t>(end), [](const Edge& e) { return e.ahead; }) -
    edges_.begin());
  Result result;
  result.open = 2 * middle == begin + end ? 0 : 1;
  for (std::size_t ahead = middle; middle > begin && ahead < end; ++ahead)
  {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t back = begin; back < middle; ++back)
    {
      const Vector& u = areas[edges_[ahead].face];
      const Vector& v = areas[edges_[back].face];
      // From one normal to the other, about the edge: negative where the cell is convex.
      const double bend = angle(u, v);
      least = std::min(least, dot(cross(u, v), along) < 0 ? bend : -bend);
    }
    result.concavity = std::max(result.concavity, least);
  }
  return result;
}

}
