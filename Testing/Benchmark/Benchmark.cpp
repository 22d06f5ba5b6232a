// Benchmark [THREADS...]: seconds and memory of the kernel, stage by stage, for three surfaces at
// three sizes, with each of the given numbers of threads (default: 1, and one a core); then what
// refinement costs a cell, and how many boxes it takes against an isotropic octree.
//
// Memory is what the process takes above what it had before the run: the peak within each stage.
// Linux forgets a peak when told so; where it does not, peaks are those since the beginning.
#include "Error.h"
#include "Mesher.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <malloc.h>
#include <map>
#include <thread>

using namespace cartesian;

namespace
{

constexpr double Sizes[] = { 5e4, 5e5, 2e6 };
constexpr double MB = 1e6;

struct Triangles
{
  std::string name;
  std::vector<double> points;
  std::vector<std::uint32_t> corners;
  std::vector<std::int32_t> boundary;

  std::size_t size() const { return corners.size() / 3; }

  void add(const std::array<std::array<double, 3>, 3>& triangle)
  {
    for (const auto& p : triangle)
    {
      corners.push_back(static_cast<std::uint32_t>(points.size() / 3));
      points.insert(points.end(), p.begin(), p.end());
    }
    boundary.push_back(0);
  }

  SurfaceView view() const
  {
    return { points.data(), points.size() / 3, corners.data(), size(), boundary.data() };
  }

  double volume() const
  {
    double sum = 0;
    for (std::size_t t = 0; t < size(); ++t)
    {
      const double* const a = &points[9 * t];
      const double* const b = a + 3;
      const double* const c = a + 6;
      sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
        a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    return std::abs(sum / 6);
  }
};

Triangles sphere(int rings)
{
  const int meridians = 2 * rings;
  const double pi = std::acos(-1.0);
  const auto at = [&](int ring, int meridian) -> std::array<double, 3> {
    const double polar = pi * ring / rings;
    const double angle = 2 * pi * (meridian % meridians) / meridians;
    const double radius = ring == 0 || ring == rings ? 0 : std::sin(polar);
    return { radius * std::cos(angle), radius * std::sin(angle), std::cos(polar) };
  };
  Triangles surface;
  surface.name = "sphere";
  for (int ring = 0; ring < rings; ++ring)
  {
    for (int m = 0; m < meridians; ++m)
    {
      if (ring > 0)
      {
        surface.add({ at(ring, m), at(ring + 1, m), at(ring, m + 1) });
      }
      if (ring + 1 < rings)
      {
        surface.add({ at(ring, m + 1), at(ring + 1, m), at(ring + 1, m + 1) });
      }
    }
  }
  return surface;
}

// An STL file in ASCII.
Triangles readStl(const std::string& name)
{
  std::ifstream file(DATA_FOLDER "/" + name);
  Triangles surface;
  surface.name = name;
  std::array<std::array<double, 3>, 3> triangle;
  std::size_t corner = 0;
  for (std::string word; file >> word;)
  {
    if (word == "vertex")
    {
      for (double& x : triangle[corner])
      {
        // As vtkSTLReader reads them: in single precision.
        float single = 0;
        file >> single;
        x = single;
      }
      if (++corner == 3)
      {
        surface.add(triangle);
        corner = 0;
      }
    }
  }
  if (surface.size() == 0)
  {
    std::fprintf(stderr, "There are no triangles in " DATA_FOLDER "/%s.\n", name.c_str());
    std::exit(1);
  }
  return surface;
}

// A line of /proc/self/status, in bytes.
double status(const char* key)
{
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
  {
    if (line.compare(0, std::strlen(key), key) == 0)
    {
      return 1024 * std::atof(line.c_str() + std::strlen(key));
    }
  }
  return 0;
}

// The peak of the process's memory within each stage.
class Memory
{
public:
  Memory()
  {
    malloc_trim(0); // gives back what earlier runs left
    before_ = status("VmRSS:");
    forget();
  }

  // What the execution calls; never stops.
  bool operator()(const char* stage)
  {
    if (stage_ != stage)
    {
      close();
      stage_ = stage;
    }
    return true;
  }

  void close()
  {
    if (!stage_.empty())
    {
      peaks_[stage_] = status("VmHWM:") - before_;
    }
    forget();
  }

  double peak(const std::string& stage) const
  {
    const auto found = peaks_.find(stage);
    return found == peaks_.end() ? 0 : found->second;
  }

  double peak() const
  {
    double most = 0;
    for (const auto& [stage, bytes] : peaks_)
    {
      most = std::max(most, bytes);
    }
    return most;
  }

private:
  static void forget() { std::ofstream("/proc/self/clear_refs") << 5; }

  double before_ = 0;
  std::string stage_;
  std::map<std::string, double> peaks_;
};

// The mesh in arrays such as VTK's; how many bytes they take.
double write(const Mesh& mesh, Execution& execution)
{
  const auto cells = static_cast<std::size_t>(mesh.cellCount());
  std::vector<double> points(3 * static_cast<std::size_t>(mesh.pointCount()));
  std::vector<Id> offsets(cells + 1);
  std::vector<Id> connectivity(static_cast<std::size_t>(mesh.connectivitySize()));
  std::vector<unsigned char> types(cells);
  std::vector<Id> faceStart(cells);
  std::vector<Id> faceStream(static_cast<std::size_t>(mesh.faceStreamSize()));
  std::vector<int> globalBox(3 * cells);
  std::vector<unsigned char> level(3 * cells);
  std::vector<int> region(cells);
  std::vector<double> fraction(cells);
  mesh.writePoints(points.data(), execution);
  mesh.writeCells({ offsets.data(), connectivity.data(), types.data(), faceStart.data(),
                    faceStream.data(), 12, 42 },
    execution);
  mesh.writeCellData({ globalBox.data(), level.data(), region.data(), fraction.data() }, execution);
  const BoundaryMesh boundary = mesh.boundaryMesh(execution);
  const auto bytes = [](const auto&... arrays) {
    return (0.0 + ... + static_cast<double>(arrays.size() * sizeof(arrays[0])));
  };
  return bytes(points, offsets, connectivity, types, faceStart, faceStream, globalBox, level,
    region, fraction, boundary.start, boundary.corners, boundary.meshPoint);
}

// The cell size that gives about as many boxes.
double sizeFor(double boxes, const Triangles& surface)
{
  Execution execution(0);
  GridSpec grid;
  grid.cellSize = std::cbrt(surface.volume() / boxes);
  for (int i = 0; i < 2; ++i)
  {
    const PreparedSurface prepared = prepareSurface(surface.view(), grid, 1e12, execution);
    const BoxedSurface boxed = boxSurface(prepared, RefinementSpec(), execution);
    grid.cellSize *= std::cbrt(static_cast<double>(boxed.boxes.boxes.size()) / boxes);
  }
  return grid.cellSize;
}

struct Figures
{
  double cells = 0;
  double cut = 0;
  double seconds = 0;
  double peak = 0;
  double output = 0;
  std::vector<std::pair<std::string, double>> stages;
};

Figures measure(const Triangles& surface, double cellSize, int depth, PatchMethod method,
  int threads, Memory& memory)
{
  Execution execution(threads, [&](double, const char* stage) { return memory(stage); });
  GridSpec grid;
  grid.cellSize = cellSize;
  const PreparedSurface prepared = prepareSurface(surface.view(), grid, 1e12, execution);
  RefinementSpec refinement;
  refinement.depth = depth;
  const BoxedSurface boxed = boxSurface(prepared, refinement, execution);
  execution.stage("Patches", AfterBoxes, AfterPatches);
  PatchSpec spec;
  spec.method = method;
  const Patches patches =
    generatePatches(prepared.surface, boxed.boxes, boxed.shoeboxes, spec, execution);
  const Assembly assembly(boxed.boxes, patches, CellSpec(), execution);
  execution.stage("Writing the mesh", AfterNumbering, 1);
  Figures figures;
  figures.output = write(assembly.mesh(), execution);
  figures.stages = execution.seconds();
  memory.close();
  for (const auto& [stage, time] : figures.stages)
  {
    figures.seconds += time;
  }
  for (const auto& [name, value] : assembly.statistics())
  {
    figures.cut = std::strcmp(name, "Polyhedra") == 0 ? value : figures.cut;
  }
  figures.cells = static_cast<double>(assembly.mesh().cellCount());
  figures.peak = memory.peak();
  return figures;
}

void printRun(const Triangles& surface, double cellSize, PatchMethod method, int threads)
{
  Memory memory;
  const Figures f = measure(surface, cellSize, 0, method, threads, memory);
  std::printf("%-32s%10s%10s%8s%10s%12s%10s%10s\n", surface.name.c_str(), "cells", "cut", "threads",
    "seconds", "cells/s", "peak MB", "output MB");
  std::printf("%8zu triangles, %-14s%26.0f%10.0f%8d%10.2f%12.0f%10.0f%10.0f\n", surface.size(),
    method == PatchMethod::ExactFit ? "Exact Fit" : "Automatic", f.cells, f.cut, threads, f.seconds,
    f.cells / f.seconds, f.peak / MB, f.output / MB);
  for (const auto& [stage, time] : f.stages)
  {
    std::printf("  %-58s%10.2f%12s%10.0f\n", stage.c_str(), time, "", memory.peak(stage) / MB);
  }
  std::printf("\n");
  std::fflush(stdout);
}

// What refinement costs: cells halved again and again along the same surface, on one thread.
void printDepths(const Triangles& surface)
{
  const double size = sizeFor(2e3, surface);
  std::printf("%-32s%10s%10s%10s%10s%12s%14s%12s\n", (surface.name + ", refined").c_str(), "depth",
    "cells", "cut", "seconds", "us a cell", "us a cut cell", "bytes a cell");
  for (int depth = 0; depth <= 4; ++depth)
  {
    Memory memory;
    const Figures f = measure(surface, size, depth, PatchMethod::Automatic, 1, memory);
    std::printf("%42d%10.0f%10.0f%10.2f%12.1f%14.1f%12.0f\n", depth, f.cells, f.cut, f.seconds,
      1e6 * f.seconds / f.cells, 1e6 * f.seconds / f.cut, f.peak / f.cells);
    std::fflush(stdout);
  }
  std::printf("\n");
}

// The leaves of an octree that divides whatever the surface passes through to the same depth: the
// units that boxes are made of, joined only eight at a time.
double octreeLeaves(const Boxes& boxes, const GlobalBox& global, const FinePoint& low, int level)
{
  const std::int64_t size = FinePerBox >> level;
  std::int64_t step = 0;
  bool kept = false;
  bool divided = false;
  for (std::int64_t i = 0; i < size * size * size; ++i)
  {
    const FinePoint at = { low[0] + i % size, low[1] + i / size % size, low[2] + i / size / size };
    const std::uint32_t b = boxes.boxAt(at, boxes.boxes[global.firstBox].global, step);
    kept = kept || b != None;
    divided = divided || b == None || boxes.boxes[b].status == BoxStatus::Intersected;
  }
  if (!kept || !divided || level == global.depth)
  {
    return kept ? 1 : 0;
  }
  double leaves = 0;
  for (std::int64_t octant = 0; octant < 8; ++octant)
  {
    const std::int64_t half = size / 2;
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
    GridSpec grid;
    grid.cellSize = 0.2;
    RefinementSpec refinement;
    refinement.depth = depth;
    const PreparedSurface prepared = prepareSurface(ball.view(), grid, 1e12, execution);
    const BoxedSurface boxed = boxSurface(prepared, refinement, execution);
    double leaves = 0;
    for (std::size_t g = 0; g + 1 < boxed.boxes.globals.size(); ++g)
    {
      const GlobalBox& global = boxed.boxes.globals[g];
      leaves += octreeLeaves(boxed.boxes, global,
        { global.index[0] * FinePerBox, global.index[1] * FinePerBox,
          global.index[2] * FinePerBox },
        0);
    }
    const auto count = static_cast<double>(boxed.boxes.boxes.size());
    std::printf("%42d%12.0f%12.0f%9.1f%%\n", depth, count, leaves, 100 * (1 - count / leaves));
  }
}

}

int main(int count, char** arguments)
{
  std::vector<int> threads;
  for (int i = 1; i < count; ++i)
  {
    threads.push_back(std::atoi(arguments[i]));
  }
  if (threads.empty())
  {
    threads = { 1, static_cast<int>(std::thread::hardware_concurrency()) };
  }
  try
  {
    for (const Triangles& surface :
      { sphere(100), readStl("kcl_exhaust_header_lumens.stl"), readStl("tm_featuretype_occ.stl") })
    {
      for (const double cells : Sizes)
      {
        const double size = sizeFor(cells, surface);
        for (const int number : threads)
        {
          printRun(surface, size, PatchMethod::Automatic, number);
          printRun(surface, size, PatchMethod::ExactFit, number);
        }
      }
    }
    printDepths(sphere(100));
    printDepths(readStl("kcl_exhaust_header_lumens.stl"));
    printSaving();
  }
  catch (const Error& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
