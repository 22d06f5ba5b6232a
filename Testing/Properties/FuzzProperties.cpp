// FuzzProperties FIRST_SEED COUNT [SECONDS]: meshes random surfaces with random properties, each in a process of
// its own. Each must give a valid mesh, or be refused with a reason, within a hundred times what the default
// properties take. Prints the seeds at fault; exit code 1 if there are any.
#include "RandomTask.h"

#include "Base/Error.h"
#include "Support/MeshChecker.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iostream>

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
    const Meshed meshed = meshOf(task.soup, task.options.grid, task.options);
    // Whatever shapes cells, or moves their corners, may take them out of their boxes.
    const bool inBoxes = task.options.collapse.ratio == 0 && !shapesCells(task.options);
    const auto valid = isValid(meshed.mesh, !inBoxes);
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

// What a process ends with that does the work, but not for longer than some seconds.
int outcomeOf(unsigned seconds, const std::function<Outcome()>& work)
{
  const pid_t child = fork();
  if (child == 0)
  {
    alarm(seconds);
    std::_Exit(work());
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

// Empty if all is well.
std::string faultOf(unsigned seed, std::array<int, 2>& counts)
{
  const RandomTask task(seed);
  RandomTask usual(seed);
  usual.valid = true;
  usual.options = TestOptions();
  usual.options.grid = task.valid ? task.options.grid : GridSpec();
  const double began = now();
  outcomeOf(MostSeconds, [&] { return meshOne(usual); });
  const double allowed = LongestOfDefault * std::max(LeastSeconds, now() - began);
  const int status = outcomeOf(
    std::min(MostSeconds, static_cast<unsigned>(allowed) + 1), [&] { return meshOne(task); });
  if (WIFSIGNALED(status))
  {
    const int signal = WTERMSIG(status);
    return signal == SIGALRM ? "takes longer than " + std::to_string(allowed) + " s"
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
