// Shapes and grids of which walls are edited in place.
#pragma once

#include "Support/Pipeline.h"

#include <ostream>
#include <string>

namespace cartesian
{

struct WallCase
{
  std::string name;
  Soup soup;
  double size; // of boxes
  int levels;
};

inline std::ostream& operator<<(std::ostream& stream, const WallCase& one)
{
  return stream << one.name;
}

inline std::string nameOfCase(const ::testing::TestParamInfo<WallCase>& info)
{
  return info.param.name;
}

// For a grid of the case.
inline TestOptions optionsInPlace(const WallCase& one)
{
  TestOptions options;
  options.refinement = depth(one.levels);
  return options;
}

}
