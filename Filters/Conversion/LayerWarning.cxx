// SPDX-License-Identifier: BSD-3-Clause
#include "LayerWarning.h"

#include "BoundaryNames.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>
#include <vector>

namespace cartesian
{

namespace
{

constexpr double LeastCoverage = 0.9; // less is told
constexpr std::size_t MostNamed = 10;
constexpr double LeastRatio = 1. / 20; // of volumes: below it, simpleFoam has died

struct BareWall
{
  std::string name;
  double coverage;
};

// Where faces were to have layers.
std::set<std::int32_t> askedOf(const LayeredBoundary& layered)
{
  std::set<std::int32_t> asked;
  for (std::size_t i = 0; i < layered.faces.size(); ++i)
  {
    if (layered.stacks[i].asked > 0)
    {
      asked.insert(layered.faces[i].boundary);
    }
  }
  for (const LayeredInterface& face : layered.interfaces)
  {
    if (face.stack.asked > 0)
    {
      asked.insert(face.boundary);
    }
  }
  return asked;
}

// Those with the least coverage first.
std::vector<BareWall> bareWalls(const BoundaryLayers& layers, vtkDataObject* mesh)
{
  std::vector<BareWall> bare;
  vtkDataArray* coverages = mesh->GetFieldData()->GetArray("BoundaryLayerCoverages");
  const std::set<std::int32_t> asked = askedOf(layers.boundary);
  vtkIdType i = 0;
  for (const auto& [boundary, name] : boundaryNames(mesh))
  {
    const double coverage = coverages->GetComponent(i, 0);
    if (asked.count(boundary) > 0 && coverage < LeastCoverage)
    {
      bare.push_back({ name, coverage });
    }
    ++i;
  }
  std::stable_sort(bare.begin(), bare.end(),
    [](const BareWall& a, const BareWall& b) { return a.coverage < b.coverage; });
  return bare;
}

// Down: none of them is told to have what it lacks.
std::string rounded(double coverage)
{
  constexpr double Rounding = 1e-9;
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", std::floor(100 * coverage + Rounding) / 100);
  return text.data();
}

}

std::string describeBareWalls(const BoundaryLayers& layers, vtkDataObject* mesh)
{
  const std::vector<BareWall> bare = bareWalls(layers, mesh);
  if (bare.empty())
  {
    return {};
  }
  std::string text = "Layers reach half the requested thickness on less than " +
    rounded(LeastCoverage) + " of the area of ";
  const char* separator = "";
  for (std::size_t i = 0; i < std::min(bare.size(), MostNamed); ++i)
  {
    text += separator + bare[i].name + " (" + rounded(bare[i].coverage) + ")";
    separator = ", ";
  }
  const std::size_t more = bare.size() - std::min(bare.size(), MostNamed);
  return text + (more == 0 ? "" : " and " + std::to_string(more) + " more boundaries") +
    ". The output Boundary has LayersMade and LayerThickness: use smaller boxes where layers end, "
    "or, where they are "
    "thick, thinner layers.";
}

std::string describeJumps(const BoundaryLayers& layers, vtkDataObject* mesh)
{
  vtkDataArray* ratios = mesh->GetFieldData()->GetArray("BoundaryLastLayerRatios");
  std::string text;
  std::size_t named = 0;
  vtkIdType i = 0;
  for (const auto& [boundary, name] : boundaryNames(mesh))
  {
    const double ratio = ratios->GetComponent(i++, 0);
    if (ratio > 0 && ratio < LeastRatio && named++ < MostNamed)
    {
      text += (text.empty() ? "" : ", ") + name + " (1:" + number(std::round(1 / ratio)) + ")";
    }
  }
  if (text.empty())
  {
    return text;
  }
  text = "The cells beside the last layer are more than " + number(1 / LeastRatio) +
    " times as large as that on " + text + ", where solvers may diverge. ";
  const int most = WallLayerSpec::MostLayers;
  return text +
    (layers.wanted <= most ? std::to_string(layers.wanted) +
          " Layers would lead to a tenth of a box; -1 finds that number."
                           : std::to_string(layers.wanted) +
          " layers would lead to a tenth of a box, but at most " + std::to_string(most) +
          " are made: use smaller boxes, a thicker first layer or a larger Layer Expansion Ratio.");
}

}
