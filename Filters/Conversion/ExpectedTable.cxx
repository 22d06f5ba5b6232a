// SPDX-License-Identifier: BSD-3-Clause
#include "ExpectedTable.h"

#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace cartesian
{

namespace
{

// Of estimates, which are known to two digits.
constexpr int Digits = 2;

constexpr const char* Arrow = "\u2192 ";
constexpr const char* Length = "%.4g";

constexpr double MillimetresInMetre = 1000;

// Of surfaces that are more often in another unit than so small or large.
constexpr double Smallest = 0.01;
constexpr double Largest = 1000;

std::string inText(double value, const char* format)
{
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

double rounded(double value)
{
  const double unit = std::pow(10, std::max(0.0, std::floor(std::log10(value)) - (Digits - 1)));
  return std::round(value / unit) * unit;
}

// 1,234,567; beyond that in powers of ten.
std::string count(double value)
{
  constexpr double Most = 1e12;
  if (value >= Most)
  {
    return inText(value, "%.1e");
  }
  std::string text = inText(rounded(value), "%.0f");
  for (auto end = static_cast<std::ptrdiff_t>(text.size()) - 3; end > 0; end -= 3)
  {
    text.insert(static_cast<std::size_t>(end), 1, ',');
  }
  return text;
}

std::string memory(double bytes)
{
  constexpr double MiB = 1024.0 * 1024;
  constexpr double GiB = 1024 * MiB;
  return bytes < GiB   ? count(bytes / MiB) + " MiB"
    : bytes < 10 * GiB ? inText(bytes / GiB, "%.1f GiB")
                       : count(bytes / GiB) + " GiB";
}

}

void toVTK(const std::vector<ExpectedRow>& rows, vtkStringArray* table)
{
  for (const char* column : { "Cell size", "\u2248 Boxes", "\u2248 Cells", "\u2248 Memory" })
  {
    table->InsertNextValue(column);
  }
  for (const auto& [mesh, isAsked] : rows)
  {
    table->InsertNextValue((isAsked ? Arrow : "") + inText(mesh.size, Length));
    table->InsertNextValue(count(mesh.boxes));
    table->InsertNextValue(count(mesh.cells));
    table->InsertNextValue(memory(mesh.bytes));
  }
}

void toVTK(const FlowRefinement& flow, vtkStringArray* table)
{
  const auto add = [&](const std::array<std::string, 4>& row) {
    for (const std::string& text : row)
    {
      table->InsertNextValue(text);
    }
  };
  const auto place = [](const std::array<double, 3>& at) {
    return inText(at[0], Length) + ", " + inText(at[1], Length) + ", " + inText(at[2], Length);
  };
  add({ "Where", "Depth", "From", "To" });
  add({ "at the surface", std::to_string(flow.depth), "", "" });
  const char* where = "around it";
  for (const FlowZone& zone : flow.zones)
  {
    add({ where, std::to_string(zone.depth), place(zone.box.low), place(zone.box.high) });
    where = "in its wake";
  }
}

void toVTK(const WallLayerSpec& layers, double total, double metresPerUnit, vtkStringArray* table)
{
  const auto thickness = [&](double length) {
    return inText(length, Length) + " (" +
      inText(length * metresPerUnit * MillimetresInMetre, Length) + " mm)";
  };
  for (const char* column : { "First layer", "Layers", "Together" })
  {
    table->InsertNextValue(column);
  }
  table->InsertNextValue(thickness(total * heightsOfLayers(layers)[1]));
  table->InsertNextValue(std::to_string(layers.count));
  table->InsertNextValue(thickness(total));
}

std::string describeLengths(const std::array<double, 3>& lengths)
{
  constexpr const char* Times = " \u00d7 ";
  return inText(lengths[0], Length) + Times + inText(lengths[1], Length) + Times +
    inText(lengths[2], Length);
}

std::string describeLength(double metres)
{
  const std::string length = ": " + inText(metres, Length) + " m long";
  return metres < Smallest || metres > Largest ? length + ". Is Length Unit right?" : length;
}

}
