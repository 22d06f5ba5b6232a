// Benchmark [stages | surfaces | growth | refinement | memory] [THREADS...] [FILE.stl...]: what the kernel takes, in
// seconds and memory, with each of the given numbers of threads (default: 1, and one a core).
//
// stages: stage by stage, for three surfaces, or those of the files (ASCII), at three sizes; surfaces: of the same, a line
// for each method and two sizes; growth: against the number of cells, of
// triangles, and the depth, with exponents, on the first number of threads; refinement: how many
// boxes it takes against an isotropic octree; memory: what is estimated for 40 meshes against what they take, on the
// first number of threads. By default all of these.
//
// Benchmark depth: what the grid takes of the processor if boxes of one size at a sphere are halved 0 to 10 times.
//
// Benchmark scaling [CELLS] [FILE.stl... | TASK.toml...]: what 1 to 128 threads would speed up, by the processor time of each chunk
// on one thread (Scaling.h): of surfaces in cells of a 60th (or CELLS) of their length, and of tasks of cartesian-mesher;
// by default of a sphere in cells of an 80th.
#include "Base/Error.h"
#include "Run.h"
#include "Scaling.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

using namespace cartesian;

namespace
{

constexpr double Sizes[] = { 5e4, 5e5, 2e6 };
constexpr double MB = 1e6;
constexpr double Microseconds = 1e6;

const char* nameOf(PatchMethod method)
{
  return method == PatchMethod::ExactFit ? "Exact Fit" : "Automatic";
}

void printStages(const Triangles& surface, double cellSize, PatchMethod method, int threads)
{
  const Figures f = measure(surface, cellSize, 0, method, threads);
  std::printf("%-32s%10s%10s%8s%10s%12s%10s%10s\n", surface.name.c_str(), "cells", "cut", "threads",
    "seconds", "cells/s", "peak MB", "output MB");
  std::printf("%8zu triangles, %-14s%26.0f%10.0f%8d%10.2f%12.0f%10.0f%10.0f\n", surface.size(),
    nameOf(method), f.cells, f.cut, threads, f.seconds, f.cells / f.seconds, f.peak / MB,
    f.output / MB);
  std::printf("%60s%10s%12s%10s\n", "", "seconds", "us/cut cell", "peak MB");
  for (const Figures::Stage& stage : f.stages)
  {
    std::printf("  %-58s%10.2f%12.2f%10.0f\n", stage.name.c_str(), stage.seconds,
      Microseconds * stage.seconds / f.cut, stage.peak / MB);
  }
  std::printf("\n");
  std::fflush(stdout);
}

void printStages(const Triangles& surface, const std::vector<int>& threads)
{
  for (const double cells : Sizes)
  {
    const double size = sizeFor(cells, surface);
    for (const int number : threads)
    {
      printStages(surface, size, PatchMethod::Automatic, number);
      printStages(surface, size, PatchMethod::ExactFit, number);
    }
  }
}

void printSurface(const Triangles& surface, const std::vector<int>& threads)
{
  for (const double cells : { Sizes[0], Sizes[1] })
  {
    for (const PatchMethod method : { PatchMethod::Automatic, PatchMethod::ExactFit })
    {
      for (const int number : threads)
      {
        const Figures f = measure(surface, sizeFor(cells, surface), 0, method, number);
        std::printf("%-34s%10zu  %-10s%8d%10.0f%10.0f%10.2f%10.2f%12.1f%14.0f\n",
          surface.name.c_str(), surface.size(), nameOf(method), number, f.cells, f.cut, f.seconds,
          f.processor, Microseconds * f.processor / f.cut, f.peak / f.cells);
        std::fflush(stdout);
      }
    }
  }
}

void printSurfaces(const std::vector<Triangles>& surfaces, const std::vector<int>& threads)
{
  std::printf("%-34s%10s  %-10s%8s%10s%10s%10s%10s%12s%14s\n", "", "triangles", "patches",
    "threads", "cells", "cut", "seconds", "of CPU", "us/cut cell", "bytes a cell");
  for (const Triangles& surface : surfaces)
  {
    printSurface(surface, threads);
  }
}

std::vector<Triangles> surfaces(const std::vector<std::string>& files)
{
  if (files.empty())
  {
    return { sphere(100), readStl("kcl_exhaust_header_lumens.stl"),
      readStl("tm_featuretype_occ.stl") };
  }
  std::vector<Triangles> read;
  std::transform(files.begin(), files.end(), std::back_inserter(read), readStl);
  return read;
}

// A table whose rows grow in one quantity; time and memory grow with exponents of it.
class GrowthTable
{
public:
  GrowthTable(const Triangles& surface, const char* quantity)
  {
    std::printf("%-28s%12s%10s%10s%10s%10s%12s%14s%12s%10s%10s\n", surface.name.c_str(), quantity,
      "cells", "cut", "seconds", "of CPU", "us a cell", "us a cut cell", "bytes a cell", "time ~n^",
      "peak ~n^");
  }

  void add(double quantity, const Figures& f)
  {
    std::printf("%40.0f%10.0f%10.0f%10.2f%10.2f%12.2f%14.1f%12.0f", quantity, f.cells, f.cut,
      f.seconds, f.processor, Microseconds * f.processor / f.cells,
      Microseconds * f.processor / f.cut, f.peak / f.cells);
    if (quantity_ > 0)
    {
      const double factor = std::log(quantity / quantity_);
      std::printf("%10.2f%10.2f", std::log(f.processor / before_.processor) / factor,
        std::log(f.peak / before_.peak) / factor);
    }
    std::printf("\n");
    std::fflush(stdout);
    quantity_ = quantity;
    before_ = f;
  }

private:
  double quantity_ = 0;
  Figures before_;
};

void printGrowth(int threads)
{
  const Triangles ball = sphere(100);
  const auto run = [&](const Triangles& surface, double size, int depth) {
    return measure(surface, size, depth, PatchMethod::Automatic, threads);
  };
  for (const Triangles& surface : { ball, readStl("kcl_exhaust_header_lumens.stl") })
  {
    GrowthTable table(surface, "boxes");
    for (const double cells : { 2e4, 2e5, 2e6, 2e7 })
    {
      table.add(cells, run(surface, sizeFor(cells, surface), 0));
    }
  }
  {
    GrowthTable table(ball, "triangles");
    const double size = sizeFor(5e5, ball);
    for (const int rings : { 12, 36, 112, 354, 1118 })
    {
      const Triangles surface = sphere(rings);
      table.add(static_cast<double>(surface.size()), run(surface, size, 0));
    }
  }
  for (const Triangles& surface : { ball, readStl("kcl_exhaust_header_lumens.stl") })
  {
    GrowthTable table(surface, "2^depth");
    const double size = sizeFor(2e3, surface);
    for (int depth = 0; depth <= 5; ++depth)
    {
      table.add(std::pow(2, depth), run(surface, size, depth));
    }
  }
  std::printf("\n");
}

void printMemoryOf(
  const Triangles& surface, double cells, int depth, PatchMethod method, int threads)
{
  const Bounds bounds = boundsOf(surface.view());
  double length = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    length = std::max(length, bounds.high[axis] - bounds.low[axis]);
  }
  const double size = length / cells;
  const Estimates estimated = estimate(surface, size, depth, method, threads);
  // In a process of its own: what the last one freed is not taken anew.
  const pid_t child = fork();
  if (child == 0)
  {
    const double taken = measure(surface, size, depth, method, threads).peak;
    std::printf("%-34s%9zu%6.0f%6d  %-10s%10.1f%8.2f%8.2f\n", surface.name.c_str(), surface.size(),
      cells, depth, nameOf(method), taken / MB, estimated.layers / taken, estimated.boxes / taken);
    std::fflush(stdout);
    std::_Exit(0);
  }
  waitpid(child, nullptr, 0);
}

void printMemory(int threads)
{
  std::printf("%-34s%9s%6s%6s  %-10s%10s%16s\n%82s%8s\n", "", "triangles", "cells", "depth",
    "patches", "taken MB", "estimated/taken", "before", "boxes");
  std::fflush(stdout);
  const auto print = [&](const Triangles& surface, double cells, int depth) {
    for (const PatchMethod method : { PatchMethod::Automatic, PatchMethod::ExactFit })
    {
      printMemoryOf(surface, cells, depth, method, threads);
    }
  };
  for (const Triangles& surface : { sphere(12), sphere(60),
         readStl("kcl_exhaust_header_lumens.stl"), readStl("tm_featuretype_occ.stl") })
  {
    for (const double cells : { 12., 30. })
    {
      print(surface, cells, 0);
      print(surface, cells, 2);
    }
  }
  print(sphere(12), 12, 3);
  print(sphere(12), 12, 4);
  print(sphere(200), 12, 0);
  print(sphere(200), 40, 0);
}

// One and the same sphere in boxes of the same size at the surface, which are global boxes halved more and more often.
void printDepths()
{
  constexpr double BoxesAcross = 96;
  const Triangles ball = sphere(100);
  std::printf("%-10s%7s%10s%10s%12s%12s%12s%12s%12s%12s%16s%12s\n", "sphere", "depth", "boxes",
    "cut", "polyhedral", "boxes s", "patches s", "sides s", "faces s", "grid s", "us/polyhedral",
    "peak MB");
  for (int depth = 0; depth <= 10; ++depth)
  {
    const Figures f = measureGrid(ball, 2 / BoxesAcross * std::pow(2, depth), depth);
    std::printf("%17d%10.0f%10.0f%12.0f", depth, f.boxes, f.intersected, f.polyhedral);
    double grid = 0;
    for (const char* stage : { "Boxes", "Patches", "Common sides of boxes", "Inner faces" })
    {
      const double seconds = f.secondsOf(stage);
      grid += std::strcmp(stage, "Patches") == 0 ? 0 : seconds;
      std::printf("%12.3f", seconds);
    }
    std::printf("%12.3f%16.2f%12.1f\n", grid, Microseconds * grid / f.polyhedral, f.peak / MB);
    std::fflush(stdout);
  }
}

// The leaves of an octree that divides whatever the surface passes through to the same depth: the
// units that boxes are made of, joined only eight at a time.
double octreeLeaves(const Boxes& boxes, const GlobalBox& global, const FinePoint& low, int level)
{
  const std::int64_t unit = FinePerBox >> global.depth;
  const std::int64_t size = std::int64_t(1) << (global.depth - level); // in units
  std::int64_t step = 0;
  bool kept = false;
  bool divided = false;
  for (std::int64_t i = 0; i < size * size * size; ++i)
  {
    const FinePoint at = { low[0] + unit * (i % size), low[1] + unit * (i / size % size),
      low[2] + unit * (i / size / size) };
    const std::uint32_t b = boxes.boxAt(at, boxes.packed[global.firstBox].global, step);
    kept = kept || b != None;
    divided = divided || b == None || boxes.packed[b].status == BoxStatus::Intersected;
  }
  if (!kept || !divided || level == global.depth)
  {
    return kept ? 1 : 0;
  }
  double leaves = 0;
  for (std::int64_t octant = 0; octant < 8; ++octant)
  {
    const std::int64_t half = unit * size / 2;
    leaves += octreeLeaves(boxes, global,
      { low[0] + (octant & 1) * half, low[1] + (octant >> 1 & 1) * half,
        low[2] + (octant >> 2) * half },
      level + 1);
  }
  return leaves;
}

// A ball of 10 mm in boxes of 1 mm: how many boxes the halving along single axes saves.
void printSaving()
{
  const Triangles ball = sphere(60); // radius 1, in units of 5 mm
  std::printf("%-32s%10s%12s%12s%10s\n", "ball of 10 mm in boxes of 1 mm", "depth", "boxes",
    "octree", "saving");
  for (int depth = 0; depth <= 3; ++depth)
  {
    Execution execution(0);
    Options options;
    options.grid.cellSize = 0.2;
    options.refinement.depth = depth;
    options.memoryLimit = PlentyOfMemory;
    const PreparedSurface prepared = prepareSurface(ball.view(), options, execution);
    const auto decomposition = decompose(prepared, options, execution);
    const Boxes boxes = decomposition->boxes(decomposition->allLayers(), execution);
    double leaves = 0;
    for (std::size_t g = 0; g + 1 < boxes.globals.size(); ++g)
    {
      const GlobalBox& global = boxes.globals[g];
      leaves += octreeLeaves(boxes, global,
        { global.index[0] * FinePerBox, global.index[1] * FinePerBox,
          global.index[2] * FinePerBox },
        0);
    }
    const auto count = static_cast<double>(boxes.packed.size());
    std::printf("%42d%12.0f%12.0f%9.1f%%\n", depth, count, leaves, 100 * (1 - count / leaves));
  }
}

}

int main(int count, char** arguments)
{
  std::vector<int> threads;
  const auto asked = [&](const char* what) {
    const bool all = count == 1 || std::atoi(arguments[1]) > 0;
    return all || std::strcmp(arguments[1], what) == 0;
  };
  std::vector<std::string> files;
  for (int i = 1; i < count; ++i)
  {
    if (std::filesystem::path(arguments[i]).extension() == ".stl")
    {
      files.push_back(std::filesystem::absolute(arguments[i]));
    }
    else if (std::atoi(arguments[i]) > 0)
    {
      threads.push_back(std::atoi(arguments[i]));
    }
  }
  if (threads.empty())
  {
    threads = { 1, static_cast<int>(std::thread::hardware_concurrency()) };
  }
  try
  {
    if (count > 1 && std::strcmp(arguments[1], "scaling") == 0)
    {
      printScaling({ arguments + 2, arguments + count });
      return 0;
    }
    if (asked("stages"))
    {
      for (const Triangles& surface : surfaces(files))
      {
        printStages(surface, threads);
      }
    }
    if (asked("surfaces"))
    {
      printSurfaces(surfaces(files), threads);
    }
    if (asked("growth"))
    {
      printGrowth(threads.front());
    }
    if (count > 1 && asked("depth"))
    {
      printDepths();
    }
    if (asked("refinement"))
    {
      printSaving();
    }
    if (asked("memory"))
    {
      printMemory(threads.front());
    }
  }
  catch (const Error& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
