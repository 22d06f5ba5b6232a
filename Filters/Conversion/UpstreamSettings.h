// SPDX-License-Identifier: BSD-3-Clause
// What a mesh was made with, found in the pipeline in front of an algorithm.
#pragma once

#include <string>
#include <vector>

class vtkAlgorithm;

namespace cartesian
{

struct UpstreamSetting
{
  std::string filter;
  std::string property; // as in the panel
  std::string value;
};

struct Upstream
{
  std::vector<UpstreamSetting>
    settings; // properties of our filters that differ from their defaults, and files read
  std::vector<std::string> warnings; // of their last updates
  bool hasMesher = false;
};

Upstream upstreamOf(vtkAlgorithm* algorithm);

}
