// FuzzProperties FIRST_SEED COUNT [SECONDS]: meshes random surfaces with random properties, each in a process of
// its own. Each must give a valid mesh, or be refused with a reason, within a hundred times what the default
// properties take in the same grid, refined the same way. Prints the seeds at fault; exit code 1 if there are any.
#include "RandomTask.h"

#include "Base/Error.h"
#include "Support/MeshChecker.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iostream>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace cartesian;

namespace
{

enum Outcome
{
  ValidMesh,
  Refused,
  Invalid,
};

constexpr double LongestOfDefault = 100;
constexpr double LeastSeconds = 0.05; // of the default: less is noise
constexpr unsigned MostSeconds = 120;

double now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool isReason(Fault fault)
{
  return fault != Fault::BadMesh && fault != Fault::OutOfMemory && fault != Fault::MissingArray;
}

Outcome meshOne(const RandomTask& task)
{
  try
  {
    Execution execution(task.options.threads);
    const auto assembly = mesh(task.soup.view(), task.options, execution);
    MeshArrays arrays = arraysOf(*assembly->mesh, assembly->boxes, execution);
    // Whatever shapes cells, or moves their corners, may take them out of their boxes.
    const bool inBoxes =
      task.options.collapse.ratio == 0 && !shapesCells(task.options) && !assembly->layers;
    if (assembly->layers)
    {
      arrays = withLayers(std::move(arrays), *assembly->layers);
    }
    const auto valid = isValid(arrays, !inBoxes);
    if (!valid || !task.valid)
    {
      std::cerr << (task.valid ? valid.message() : "accepted what is out of range") << "\n";
    }
    return valid && task.valid ? ValidMesh : Invalid;
  }
  catch (const Error& error)
  {
    const bool reason = isReason(error.fault) && *error.what() != '\0';
    if (!reason)
    {
      std::cerr << error.what() << "\n";
    }
    return reason ? Refused : Invalid;
  }
}

struct Ended
{
  int status;
  double seconds; // of processor time: what else runs on the machine does not count
};

// A process that does the work, but not for longer than some seconds.
Ended run(unsigned seconds, const std::function<Outcome()>& work)
{
  const pid_t child = fork();
  if (child == 0)
  {
    const rlimit limit{ seconds, seconds };
    setrlimit(RLIMIT_CPU, &limit);
    std::_Exit(work());
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  constexpr double Microseconds = 1e-6;
  return { status,
    static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
      Microseconds * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec) };
}

// Empty if all is well.
std::string faultOf(unsigned seed, std::array<int, 2>& counts)
{
  const RandomTask task(seed);
  RandomTask usual(seed);
  usual.valid = true;
  usual.options = TestOptions();
  if (task.valid)
  {
    // More boxes take longer whatever is done to them.
    usual.options.grid = task.options.grid;
    usual.options.refinement = task.options.refinement;
    usual.options.domain = task.options.domain;
  }
  const double usualSeconds = run(MostSeconds, [&] { return meshOne(usual); }).seconds;
  const double allowed = LongestOfDefault * std::max(LeastSeconds, usualSeconds);
  const int status = run(std::min(MostSeconds, static_cast<unsigned>(allowed) + 1), [&] {
    return meshOne(task);
  }).status;
  if (WIFSIGNALED(status))
  {
    const int signal = WTERMSIG(status);
    return signal == SIGKILL || signal == SIGXCPU
      ? "takes longer than " + std::to_string(allowed) + " s"
      : "ended by signal " + std::to_string(signal);
  }
  const int outcome = WEXITSTATUS(status);
  if (outcome > Refused)
  {
    return "no valid mesh";
  }
  ++counts[static_cast<std::size_t>(outcome)];
  return "";
}

}

int main(int argc, char** argv)
{
  if (argc < 3)
  {
    std::cerr << "usage: FuzzProperties FIRST_SEED COUNT [SECONDS]\n";
    return 2;
  }
  const auto first = static_cast<unsigned>(std::strtoul(argv[1], nullptr, 10));
  const auto count = static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10));
  const double end = now() + (argc > 3 ? std::strtod(argv[3], nullptr) : 1e9);
  std::array<int, 2> counts{};
  int faults = 0;
  unsigned seed = first;
  for (; seed - first < count && now() < end; ++seed)
  {
    const std::string fault = faultOf(seed, counts);
    if (!fault.empty())
    {
      ++faults;
      std::cout << "seed " << seed << ": " << fault << ": " << describe(RandomTask(seed))
                << std::endl;
    }
  }
  std::cout << seed - first << " tasks: " << counts[0] << " meshes, " << counts[1] << " refused, "
            << faults << " at fault\n";
  return faults == 0 ? 0 : 1;
}
