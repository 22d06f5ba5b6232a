// How long work runs: on how many threads, with what progress, until when.
//
// Work is cut into chunks of a fixed number of items, so that what a chunk does never depends on
// the number of threads. Only the calling thread reports progress and asks whether to go on.
#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace cartesian
{

// Thrown out of a stage that the user stopped.
struct Stopped : std::runtime_error
{
  Stopped()
    : std::runtime_error("stopped by the user")
  {
  }
};

class Execution
{
public:
  // Called with a fraction (0 to 1) of all work and the stage's name; returns false to stop.
  using Monitor = std::function<bool(double fraction, const char* stage)>;

  // `threads` 0: one a core.
  explicit Execution(int threads = 1, Monitor monitor = nullptr);

  int threads() const { return threads_; }

  // What follows is the stage `name`, from `begin` to `end` of all work (0 to 1).
  void stage(const char* name, double begin, double end);

  // Seconds by stage so far, in the order in which stages began.
  std::vector<std::pair<std::string, double>> seconds() const;

  // Calls work(begin, end) for chunks of `grain` items of [0, count), on all threads.
  // An exception ends the loop and is thrown again here.
  void forEach(std::size_t count, std::size_t grain,
    const std::function<void(std::size_t begin, std::size_t end)>& work);

private:
  void report(double fractionOfStage);

  int threads_;
  Monitor monitor_;
  const char* stage_ = "";
  double begin_ = 0;
  double end_ = 1;
  double reported_ = -1;
  double started_ = 0;
  std::vector<std::pair<std::string, double>> seconds_;
};

// How many chunks forEach makes: where each chunk has a result of its own.
inline std::size_t chunks(std::size_t count, std::size_t grain)
{
  return (count + grain - 1) / grain;
}

}
