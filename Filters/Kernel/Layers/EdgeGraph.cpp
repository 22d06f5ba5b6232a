// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/EdgeGraph.h"

#include "Base/ForEachItem.h"

#include <algorithm>

namespace cartesian
{

void EdgeGraph::leaveOutTwins(Execution& execution)
{
  const auto at = [&](std::size_t edge) { return to_.begin() + static_cast<std::ptrdiff_t>(edge); };
  std::vector<std::size_t> kept(nodes());
  forEachItem(nodes(), execution, [&](std::size_t n) {
    std::sort(at(first_[n]), at(first_[n + 1]));
    kept[n] =
      static_cast<std::size_t>(std::unique(at(first_[n]), at(first_[n + 1])) - at(first_[n]));
  });
  std::size_t next = 0;
  for (std::size_t n = 0; n < kept.size(); ++n)
  {
    std::copy_n(at(first_[n]), kept[n], at(next));
    first_[n] = next;
    next += kept[n];
  }
  first_.back() = next;
  to_.resize(next);
  to_.shrink_to_fit();
}

}
