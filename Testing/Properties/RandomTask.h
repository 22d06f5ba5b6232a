// A surface and all properties, drawn at random; the same for the same seed.
#pragma once

#include "Support/Pipeline.h"

#include <vector>

namespace cartesian
{

struct RandomTask
{
  explicit RandomTask(unsigned seed);

  Soup soup;
  std::vector<Soup> regions; // what options.refinement.regions refers to
  TestOptions options;
  bool valid = true; // else one of the properties is out of its range
};

std::string describe(const RandomTask& task);

}
