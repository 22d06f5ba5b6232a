#include "Scaling.h"

#include "Run.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <numeric>

#include <unistd.h>

namespace cartesian
{

namespace
{

constexpr std::size_t Threads[] = { 1, 2, 4, 8, 16, 32, 64, 128 };
constexpr double SphereCells = 80; // across
constexpr double FileCells = 60;

// Of the wall and layers: the rest is shown apart.
const std::vector<std::string> WallStages = { "Opening of the wall", "Edits of the wall",
  "Closing of the wall", "Layers" };

struct Times
{
  double serial = 0;
  double loops = 0;
  double on[std::size(Threads)] = {};

  double whole() const { return serial + loops; }
};

Times timesOf(const Recording::Step& step)
{
  Times times;
  (step.isLoop ? times.loops : times.serial) =
    std::accumulate(step.tasks.begin(), step.tasks.end(), 0.0);
  std::transform(std::begin(Threads), std::end(Threads), times.on,
    [&](std::size_t threads) { return secondsOn(threads, step); });
  return times;
}

Times operator+(Times a, const Times& b)
{
  a.serial += b.serial;
  a.loops += b.loops;
  std::transform(std::begin(a.on), std::end(a.on), b.on, a.on, std::plus<>());
  return a;
}

struct Stage
{
  std::string name;
  Times times;
};

// In the order in which they first began.
std::vector<Stage> stagesOf(const Recording& recording)
{
  std::vector<Stage> stages;
  for (const Recording::Step& step : recording.steps())
  {
    const std::string& name = recording.stages()[step.stage];
    auto stage = std::find_if(
      stages.begin(), stages.end(), [&](const Stage& other) { return other.name == name; });
    if (stage == stages.end())
    {
      stage = stages.insert(stages.end(), { name, {} });
    }
    stage->times = stage->times + timesOf(step);
  }
  return stages;
}

void printHead(const std::string& text, const char* first, const char* second)
{
  std::printf("%-44s%10s%10s", text.c_str(), first, second);
  for (const std::size_t threads : Threads)
  {
    std::printf("%8zu", threads);
  }
  std::printf("\n");
}

void printSpeedUp(const std::string& name, const Times& times)
{
  std::printf("  %-42s%10.2f%10.2f", name.c_str(), times.serial, times.loops);
  for (const double seconds : times.on)
  {
    std::printf("%8.2f", seconds > 0 ? times.whole() / seconds : 1);
  }
  std::printf("\n");
}

void printSeconds(const Stage& stage)
{
  std::printf("  %-42s%10.3f%10.3f", stage.name.c_str(), stage.times.serial, stage.times.loops);
  for (const double seconds : stage.times.on)
  {
    std::printf("%8.3f", seconds);
  }
  std::printf("\n");
}

void printScaling(const std::string& name, const Recording& recording)
{
  const std::vector<Stage> stages = stagesOf(recording);
  Times all;
  Times others;
  Times wall;
  for (const Stage& stage : stages)
  {
    const bool isWall =
      std::find(WallStages.begin(), WallStages.end(), stage.name) != WallStages.end();
    all = all + stage.times;
    (isWall ? wall : others) = (isWall ? wall : others) + stage.times;
  }
  printHead(name + ": speed-up", "serial s", "loops s");
  printSpeedUp("all", all);
  printSpeedUp("all but the wall and layers", others);
  printSpeedUp("these", wall);
  printHead("seconds", "serial", "loops");
  for (const Stage& stage : stages)
  {
    if (stage.times.whole() >= 0.0005) // what is shown
    {
      printSeconds(stage);
    }
  }
  std::printf("\n");
  std::fflush(stdout);
}

double lengthOf(const Triangles& surface)
{
  const Bounds bounds = boundsOf(surface.view());
  return bounds.longest();
}

Recording recordTask(const std::string& task)
{
  const std::filesystem::path program =
    std::filesystem::canonical("/proc/self/exe").parent_path() / "cartesian-mesher";
  const std::filesystem::path file =
    std::filesystem::temp_directory_path() / ("scaling" + std::to_string(getpid()));
  setenv(Recording::Variable, file.c_str(), 1);
  const int code =
    std::system(("'" + program.string() + "' --quiet '" + task + "' > /dev/null").c_str());
  std::ifstream recorded(file);
  const Recording recording = Recording::read(recorded);
  std::filesystem::remove(file);
  if (recording.steps().empty())
  {
    std::fprintf(stderr, "%s: nothing was meshed (%d).\n", task.c_str(), code);
    std::exit(1);
  }
  return recording;
}

}

void printScaling(const std::vector<std::string>& arguments)
{
  bool isAnyFile = false;
  double cells = 0; // 0: as usual
  const auto print = [&](const Triangles& surface, double usual) {
    const double across = cells > 0 ? cells : usual;
    printScaling(surface.name + ", 1/" + std::to_string(int(across)),
      record(surface, lengthOf(surface) / across));
    isAnyFile = true;
  };
  for (const std::string& argument : arguments)
  {
    const std::filesystem::path path = std::filesystem::absolute(argument);
    if (path.extension() == ".toml")
    {
      printScaling(path.filename(), recordTask(path));
      isAnyFile = true;
    }
    else if (path.extension() == ".stl")
    {
      print(readStl(path), FileCells);
    }
    else
    {
      cells = std::atof(argument.c_str());
    }
  }
  if (!isAnyFile)
  {
    print(sphere(100), SphereCells);
  }
}

}
