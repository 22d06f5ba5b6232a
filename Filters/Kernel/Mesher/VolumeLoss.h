// SPDX-License-Identifier: BSD-3-Clause
// Where a mesh holds less, or more, than the surface encloses in the grid, whatever the reason.
#pragma once

#include "Mesher/Mesher.h"

namespace cartesian
{

struct VolumeLoss
{
  // Of each region, in the order of the regions given; cubic user units.
  std::vector<double> enclosed;
  std::vector<double> meshed;

  // A part of the grid, in user units, and the volume that is missing there.
  struct Place
  {
    Vector low;
    Vector high;
    double missing;
  };
  std::vector<std::vector<Place>>
    places; // of each region, the worst first; none where nothing is told

  // Of a region: missing, as a part of what is enclosed; negative: there is more.
  double share(std::size_t region) const;
  bool isTold(std::size_t region) const;
};

// Of the whole mesh. Nothing is known of parts of the domain that were left out (Keep Points): then all shares are 0.
VolumeLoss findVolumeLoss(
  const PreparedSurface& prepared, const Assembly& assembly, Execution& execution);

// In words, with names of regions, which may be missing; empty where nothing is told.
std::string describe(const VolumeLoss& loss, const std::vector<std::string>& regions);

}
