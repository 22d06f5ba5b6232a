// One run of the kernel from surface to arrays, timed stage by stage.
//
// Memory is what the process takes above what it had before the run: the peak within each stage.
// Linux forgets a peak when told so; where it does not, peaks are those since the beginning.
#pragma once

#include "Base/Recording.h"
#include "Mesher/Mesher.h"

#include <map>

namespace cartesian
{

struct Triangles
{
  std::string name;
  std::vector<double> points;
  std::vector<std::uint32_t> corners;
  std::vector<std::int32_t> boundary;

  std::size_t size() const { return corners.size() / 3; }
  void add(const std::array<std::array<double, 3>, 3>& triangle);
  SurfaceView view() const; // borrows
  double volume() const;
};

Triangles sphere(int rings);                // 4 rings (rings - 1) triangles, of radius 1
Triangles readStl(const std::string& name); // a path, from the folder Data

constexpr double PlentyOfMemory = 1000; // GiB

// The cell size that gives about as many boxes.
double sizeFor(double boxes, const Triangles& surface);

struct Figures
{
  double cells = 0;
  double cut = 0; // cells that are no hexahedra
  double seconds = 0;
  double processor = 0; // seconds, of all threads: hardly more on a machine with other work
  double peak = 0;      // bytes
  double output = 0;    // bytes of the arrays
  struct Stage
  {
    std::string name;
    double seconds;
    double peak;
  };
  std::vector<Stage> stages;
  double boxes = 0;
  double intersected = 0;
  double polyhedral = 0; // intersected, or with hanging nodes

  double secondsOf(const std::string& stage) const;
};

// Bytes that the mesh is said to take.
struct Estimates
{
  double layers; // before there are boxes: it decides about pieces
  double boxes;  // before there are patches
};

Estimates estimate(
  const Triangles& surface, double cellSize, int depth, PatchMethod method, int threads);

Figures measure(
  const Triangles& surface, double cellSize, int depth, PatchMethod method, int threads);

// The grid alone, as far as inner faces: of stages, the processor's seconds.
Figures measureGrid(const Triangles& surface, double cellSize, int depth);

// Automatic patches, depth 0.
Recording record(const Triangles& surface, double cellSize);

}
