#include "Run.h"

#include "Faces/InnerFaces.h"
#include "Mesher/Assembly.h"
#include "Mesher/Stages.h"
#include "Mesher/Statistics.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <malloc.h>
#include <numeric>

namespace cartesian
{

namespace
{

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

Options optionsOf(double cellSize, int depth, PatchMethod method)
{
  Options options;
  options.grid.cellSize = cellSize;
  options.refinement.depth = depth;
  options.patches.method = method;
  options.memoryLimit = PlentyOfMemory;
  return options;
}

// The mesh in arrays such as VTK's.
class WrittenMesh
{
public:
  WrittenMesh(const OutputMesh& mesh, Execution& execution)
    : points_(3 * static_cast<std::size_t>(mesh.pointCount()))
    , offsets_(static_cast<std::size_t>(mesh.cellCount()) + 1)
    , connectivity_(static_cast<std::size_t>(mesh.connectivitySize()))
    , types_(static_cast<std::size_t>(mesh.cellCount()))
    , faceStart_(types_.size())
    , faceStream_(static_cast<std::size_t>(mesh.faceStreamSize()))
    , number_(types_.size())
    , globalBox_(3 * types_.size())
    , level_(3 * types_.size())
    , region_(types_.size())
    , fraction_(types_.size())
  {
    mesh.writePoints(points_.data(), execution);
    mesh.writeCells({ offsets_.data(), connectivity_.data(), types_.data(), faceStart_.data(),
                      faceStream_.data(), 12, 42 },
      execution);
    mesh.writeCellData(
      { number_.data(), globalBox_.data(), level_.data(), region_.data(), fraction_.data() },
      execution);
    boundary_ = mesh.boundaryMesh(execution);
  }

  double bytes() const
  {
    const auto sum = [](const auto&... arrays) {
      return (0.0 + ... + static_cast<double>(arrays.size() * sizeof(arrays[0])));
    };
    return sum(points_, offsets_, connectivity_, types_, faceStart_, faceStream_, globalBox_,
      level_, region_, fraction_, number_, boundary_.start, boundary_.corners, boundary_.meshPoint);
  }

private:
  RawVector<double> points_;
  RawVector<Id> offsets_;
  RawVector<Id> connectivity_;
  RawVector<unsigned char> types_;
  RawVector<Id> faceStart_;
  RawVector<Id> faceStream_;
  RawVector<Id> number_;
  RawVector<int> globalBox_;
  RawVector<unsigned char> level_;
  RawVector<int> region_;
  RawVector<double> fraction_;
  BoundaryMesh boundary_;
};

// STL files that are not ASCII: a head, the number of triangles, and as many bytes for each.
constexpr std::size_t StlHead = 84;
constexpr std::size_t StlTriangle = 50;

bool isBinary(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  std::uint32_t count = 0;
  file.seekg(StlHead - sizeof(count));
  file.read(reinterpret_cast<char*>(&count), sizeof(count));
  return file && std::filesystem::file_size(path) == StlHead + StlTriangle * count;
}

// As vtkSTLReader reads them: in single precision.
void readAscii(std::istream& file, Triangles& surface)
{
  std::array<std::array<double, 3>, 3> triangle;
  std::size_t corner = 0;
  for (std::string word; file >> word;)
  {
    if (word == "vertex")
    {
      for (double& x : triangle[corner])
      {
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
}

void readBinary(std::istream& file, Triangles& surface)
{
  file.seekg(StlHead);
  std::array<char, StlTriangle> bytes;
  while (file.read(bytes.data(), bytes.size()))
  {
    std::array<float, 12> numbers; // of the normal, then of the corners
    std::memcpy(numbers.data(), bytes.data(), sizeof(numbers));
    std::array<std::array<double, 3>, 3> triangle;
    for (std::size_t i = 0; i < 9; ++i)
    {
      triangle[i / 3][i % 3] = numbers[3 + i];
    }
    surface.add(triangle);
  }
}

}

void Triangles::add(const std::array<std::array<double, 3>, 3>& triangle)
{
  for (const auto& p : triangle)
  {
    corners.push_back(static_cast<std::uint32_t>(points.size() / 3));
    points.insert(points.end(), p.begin(), p.end());
  }
  boundary.push_back(0);
}

SurfaceView Triangles::view() const
{
  return { points.data(), points.size() / 3, corners.data(), size(), boundary.data() };
}

double Triangles::volume() const
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

Triangles readStl(const std::string& name)
{
  const std::filesystem::path path = std::filesystem::path(DATA_FOLDER) / name;
  std::ifstream file(path, std::ios::binary);
  Triangles surface;
  surface.name = path.filename();
  if (isBinary(path))
  {
    readBinary(file, surface);
  }
  else
  {
    readAscii(file, surface);
  }
  if (surface.size() == 0)
  {
    std::fprintf(stderr, "There are no triangles in %s.\n", path.c_str());
    std::exit(1);
  }
  return surface;
}

double sizeFor(double boxes, const Triangles& surface)
{
  Execution execution(Execution::AllCores);
  Options options;
  options.grid.cellSize = std::cbrt(surface.volume() / boxes);
  options.memoryLimit = PlentyOfMemory;
  for (int i = 0; i < 2; ++i)
  {
    const PreparedSurface prepared = prepareSurface(surface.view(), options, execution);
    const auto decomposition = decompose(prepared, options, execution);
    const Boxes boxed = decomposition->boxes(decomposition->allLayers(), execution);
    options.grid.cellSize *= std::cbrt(static_cast<double>(boxed.packed.size()) / boxes);
  }
  return options.grid.cellSize;
}

Estimates estimate(
  const Triangles& surface, double cellSize, int depth, PatchMethod method, int threads)
{
  Execution execution(threads);
  const Options options = optionsOf(cellSize, depth, method);
  const PreparedSurface prepared = prepareSurface(surface.view(), options, execution);
  const auto decomposition = decompose(prepared, options, execution);
  const SlabRange all = decomposition->allLayers();
  const Boxes boxes = decomposition->boxes(all, execution);
  const auto bytes = [&](const std::vector<MeshEstimate>& ofLayers) {
    return decomposition->together(ofLayers, all).bytes(prepared.memoryLimit);
  };
  return { bytes(decomposition->estimateLayers(execution)),
    bytes(estimateLayers(decomposition->shoeboxes(), boxes, execution)) };
}

Figures measure(
  const Triangles& surface, double cellSize, int depth, PatchMethod method, int threads)
{
  Memory memory;
  Execution execution(threads, [&](double, const char* stage) { return memory(stage); });
  const Options options = optionsOf(cellSize, depth, method);
  const std::clock_t began = std::clock();
  const auto assembly = mesh(surface.view(), options, execution);
  execution.stage("Writing the mesh", AfterLayers, 1);
  Figures figures;
  figures.output = WrittenMesh(*assembly->mesh, execution).bytes();
  figures.processor = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
  memory.close();
  for (const auto& [stage, time] : execution.seconds())
  {
    figures.stages.push_back({ stage, time, memory.peak(stage) });
    figures.seconds += time;
  }
  for (const Statistic& statistic : statistics(*assembly))
  {
    figures.cut = std::strcmp(statistic.name, "Polyhedra") == 0 ? statistic.value : figures.cut;
  }
  figures.cells = static_cast<double>(assembly->mesh->cellCount());
  figures.peak = memory.peak();
  return figures;
}

double Figures::secondsOf(const std::string& stage) const
{
  return std::accumulate(stages.begin(), stages.end(), 0.0,
    [&](double sum, const Stage& s) { return sum + (s.name == stage ? s.seconds : 0); });
}

Figures measureGrid(const Triangles& surface, double cellSize, int depth)
{
  Memory memory;
  Execution execution(1, [&](double, const char* stage) { return memory(stage); });
  Recording recording;
  execution.record(recording);
  const Options options = optionsOf(cellSize, depth, PatchMethod::Automatic);
  const PreparedSurface prepared = prepareSurface(surface.view(), options, execution);
  const auto decomposition = decompose(prepared, options, execution);
  const Boxes boxes = decomposition->boxes(decomposition->allLayers(), execution);
  const Patches patches = makePatches(prepared, *decomposition, boxes, options, execution);
  execution.stage("Common sides of boxes", AfterPatches, AfterSides);
  const Sides sides = findSides(boxes, execution);
  const Nodes nodes = findNodes(boxes, patches, sides, execution);
  execution.stage("Inner faces", AfterSides, AfterInnerFaces);
  const InnerFaces faces = generateInnerFaces(boxes, patches, sides, nodes, execution);
  recording.end();
  memory.close();
  Figures figures;
  for (const Recording::Step& step : recording.steps())
  {
    figures.stages.push_back({ recording.stages()[step.stage],
      std::accumulate(step.tasks.begin(), step.tasks.end(), 0.0), 0 });
  }
  figures.boxes = static_cast<double>(boxes.packed.size());
  figures.intersected = static_cast<double>(patches.boxStart.size() - 1);
  figures.polyhedral = static_cast<double>(sides.polyhedral.size());
  figures.peak = memory.peak();
  return figures;
}

Recording record(const Triangles& surface, double cellSize)
{
  Execution execution;
  Recording recording;
  execution.record(recording);
  const Options options = optionsOf(cellSize, 0, PatchMethod::Automatic);
  const auto assembly = mesh(surface.view(), options, execution);
  execution.stage("Writing the mesh", AfterLayers, 1);
  const WrittenMesh written(*assembly->mesh, execution);
  recording.end();
  return recording;
}

}
