#include "InOut.h"

namespace cartesian
{

InOut::InOut(
  const Surface& surface, const SurfaceCheck& check, const Meshlines& planes, Execution& execution)
  : closed_(check.closed())
{
  for (int axis = 0; axis < (closed_ ? 1 : 3); ++axis)
  {
    along_.emplace_back(surface, planes, axis, execution);
  }
}

bool InOut::inside(std::uint32_t i, std::uint32_t j, std::uint32_t k) const
{
  return closed_ ? along_[0].below(j, k, i) % 2 == 1 : vote({ i, j, k });
}

// Of the two rays along one axis, those that cross the surface an odd number of times.
int InOut::votes(const LineCrossings& lines, const std::array<std::uint32_t, 3>& vertex)
{
  const std::uint32_t middle = vertex[lines.axes().middle];
  const std::uint32_t outer = vertex[lines.axes().outer];
  const std::size_t below = lines.below(middle, outer, vertex[lines.axes().along]);
  const std::size_t above = lines.total(middle, outer) - below;
  return static_cast<int>(below % 2 + above % 2);
}

bool InOut::vote(const std::array<std::uint32_t, 3>& vertex) const
{
  int sum = 0;
  for (const LineCrossings& lines : along_)
  {
    sum += votes(lines, vertex);
  }
  return sum > 3;
}

std::uint8_t InOut::corners(std::uint32_t i, std::uint32_t j, std::uint32_t k) const
{
  unsigned bits = 0;
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    const bool in = inside(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2));
    bits |= unsigned(in) << corner;
  }
  return static_cast<std::uint8_t>(bits);
}

}
