// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/Meshlines.h"

#include "Base/Error.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace cartesian
{

namespace
{

// A last cell thinner than this part of the cell size is due to rounding and left out.
constexpr double RoundingOfCounts = 1e-6;

// A surface this many times smaller than a cell would lose its shape on a lattice that holds the
// cell.
constexpr double LargestCell = 1000;

// Memory for each row of boxes along x, even an empty one: its start in several lists.
constexpr double BytesOfARow = 40;

// In a direction: with more, positions in the fine grid (Boxes/Boxes.h) would not fit in 32 bits.
constexpr double MostCells = (1 << 20) - 1;

constexpr std::array<const char*, 3> AxisName = { "X", "Y", "Z" };

double cellSize(const GridSpec& spec, const Bounds& surface)
{
  const double size =
    spec.cellSize == 0 ? surface.longest() / DefaultCellsAlongLongest : spec.cellSize;
  if (!(size > 0) || !std::isfinite(size))
  {
    throw Error(Fault::BadCellSize,
      "Cell Size is " + number(spec.cellSize) +
        ": it must be a positive length (0 stands for the longest dimension / 50).");
  }
  if (size > LargestCell * surface.longest())
  {
    throw Error(Fault::BadCellSize,
      "Cell Size is " + number(size) + ", but the surface is only " + number(surface.longest()) +
        " long: choose a smaller one.");
  }
  return size;
}

double cellCount(double size, double extent)
{
  return std::max(1.0, std::ceil(extent / size - RoundingOfCounts));
}

void checkMeshlines(const std::vector<double>& lines, int axis, const Bounds& surface)
{
  const std::string name = std::string("Meshlines ") + AxisName[axis];
  if (lines.size() < 2)
  {
    throw Error(Fault::BadMeshlines, name + " has one position: give at least two, or none.");
  }
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    if (!std::isfinite(lines[i]) || (i > 0 && !(lines[i] > lines[i - 1])))
    {
      throw Error(Fault::BadMeshlines,
        name + " must increase: position " + std::to_string(i) + " is " + number(lines[i]) +
          (i > 0 ? " after " + number(lines[i - 1]) : "") + ".");
    }
  }
  if (double(lines.size()) - 1 > MostCells)
  {
    throw Error(Fault::TooManyBoxes,
      name + " make " + number(double(lines.size()) - 1) + " boxes, but there may be at most " +
        number(MostCells) + ": give fewer positions, and refine between them.");
  }
  if (lines.back() <= surface.low[axis] || lines.front() >= surface.high[axis])
  {
    throw Error(Fault::BadMeshlines,
      name + " run from " + number(lines.front()) + " to " + number(lines.back()) +
        " and miss the surface, which lies between " + number(surface.low[axis]) + " and " +
        number(surface.high[axis]) + ". Give positions that enclose part of it.");
  }
}

// The number of cells of this size along an axis.
double requireLines(double size, double extent, int axis)
{
  const double count = cellCount(size, extent);
  if (count > MostCells)
  {
    throw Error(Fault::TooManyBoxes,
      "Cell Size " + number(size) + " makes " + number(count) + " cells along " + AxisName[axis] +
        ", but there may be at most " + number(MostCells) + ": choose a larger one, and refine.");
  }
  return count;
}

std::vector<Level> uniformLines(
  double size, double low, double high, int axis, const Lattice& lattice)
{
  const double count = requireLines(size, high - low, axis);
  std::vector<Level> lines;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
  {
    lines.push_back(lattice.plane(axis, low + static_cast<double>(i) * size));
  }
  lines.push_back(lattice.plane(axis, std::max(low + count * size, high)));
  return lines;
}

// Moves planes that would touch the bounds of the surface away from it.
void clearOf(std::vector<Level>& lines, Level least, Level most)
{
  if (lines.front() == least + 1)
  {
    lines.front() = least - 1;
  }
  if (lines.back() == most - 1)
  {
    lines.back() = most + 1;
  }
}

}

Bounds domainOf(const GridSpec& spec, const Bounds& surface)
{
  Bounds domain = surface;
  const double size = cellSize(spec, surface);
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto& lines = spec.meshlines[axis];
    if (lines.empty())
    {
      const double extent = surface.high[axis] - surface.low[axis];
      domain.include(axis, surface.low[axis] + cellCount(size, extent) * size);
    }
    else
    {
      checkMeshlines(lines, axis, surface);
      domain.include(axis, lines.front());
      domain.include(axis, lines.back());
    }
  }
  return domain;
}

GridSpec fittedTo(const Bounds& box, const GridSpec& spec)
{
  GridSpec grid = spec;
  const double size = cellSize(spec, box);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double extent = box.high[axis] - box.low[axis];
    const double count = requireLines(size, extent, static_cast<int>(axis));
    for (double i = 0; spec.meshlines[axis].empty() && i < count; ++i)
    {
      grid.meshlines[axis].push_back(box.low[axis] + i * extent / count);
    }
    if (spec.meshlines[axis].empty())
    {
      grid.meshlines[axis].push_back(box.high[axis]);
    }
  }
  return grid;
}

Meshlines onLattice(const GridSpec& spec, const Bounds& surface, const Lattice& lattice)
{
  Meshlines planes;
  const double size = cellSize(spec, surface);
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto& lines = spec.meshlines[axis];
    if (lines.empty())
    {
      planes[axis] = uniformLines(size, surface.low[axis], surface.high[axis], axis, lattice);
    }
    else
    {
      for (const double x : lines)
      {
        planes[axis].push_back(lattice.plane(axis, x));
      }
    }
    clearOf(planes[axis], lattice.vertex(axis, surface.low[axis]),
      lattice.vertex(axis, surface.high[axis]));
    const auto twice = std::adjacent_find(
      planes[axis].begin(), planes[axis].end(), [](Level a, Level b) { return a >= b; });
    if (twice != planes[axis].end())
    {
      throw Error(lines.empty() ? Fault::BadCellSize : Fault::BadMeshlines,
        std::string("Two meshlines along ") + AxisName[axis] + " are closer than the lattice's " +
          "step of " + number(2 * lattice.step()) + " near " +
          number(lattice.position(axis, *twice)) +
          (lines.empty() ? ": choose a larger Cell Size." : ": space them farther apart."));
    }
  }
  return planes;
}

void checkGrid(const GridSpec& spec, const Bounds& surface, double mostBytes)
{
  std::array<double, 3> cells;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    cells[axis] = spec.meshlines[axis].empty()
      ? cellCount(cellSize(spec, surface), surface.high[axis] - surface.low[axis])
      : static_cast<double>(spec.meshlines[axis].size() - 1);
  }
  if (cells[1] * cells[2] * BytesOfARow > mostBytes)
  {
    throw Error(Fault::TooManyBoxes,
      "The grid would have " + number(cells[0]) + " x " + number(cells[1]) + " x " +
        number(cells[2]) +
        " boxes, which do not fit in the Memory Limit: choose a larger Cell "
        "Size.");
  }
}

std::int64_t intervalOf(const std::vector<Level>& lines, Level level)
{
  // Most meshlines are evenly spaced: the first guess is right, or off by one.
  if (!lines.empty() && level >= lines.front() && level < lines.back())
  {
    const std::uint64_t part = std::uint64_t(level - lines.front()) * (lines.size() - 1);
    auto guess = static_cast<std::size_t>(part / (lines.back() - lines.front()));
    guess -= level < lines[guess] ? 1 : 0;
    guess += level >= lines[guess + 1] ? 1 : 0;
    if (level >= lines[guess] && level < lines[guess + 1])
    {
      return static_cast<std::int64_t>(guess);
    }
  }
  return std::upper_bound(lines.begin(), lines.end(), level) - lines.begin() - 1;
}

double spacing(const std::vector<Level>& lines, double level)
{
  const auto last = static_cast<std::int64_t>(lines.size()) - 2;
  const std::int64_t i =
    std::clamp<std::int64_t>(intervalOf(lines, static_cast<Level>(level)), 0, last);
  return double(lines[static_cast<std::size_t>(i + 1)]) - lines[static_cast<std::size_t>(i)];
}

double narrowestSide(const Meshlines& planes, const std::array<double, 3>& at)
{
  return std::min(
    { spacing(planes[0], at[0]), spacing(planes[1], at[1]), spacing(planes[2], at[2]) });
}

}
