// How long work runs: on how many threads, with what progress, until when.
//
// Work is cut into chunks of a fixed number of items, so that what a chunk does never depends on
// the number of threads. Only the calling thread reports progress and asks whether to go on.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
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
  // Called many times a second with a fraction (0 to 1) of the work, which never falls, and the
  // stage's name; returns false to stop.
  using Monitor = std::function<bool(double fraction, const char* stage)>;

  // `threads` 0: one a core. The work is the part from `begin` to `end` of a whole that stages are
  // parts of.
  explicit Execution(int threads = 1, Monitor monitor = nullptr, double begin = 0, double end = 1);

  int threads() const { return threads_; }

  // From `begin` to `end` of the whole there will be nothing to do.
  void leaveOut(double begin, double end);

  // What follows is the stage `name`, from `begin` to `end` of the whole (0 to 1).
  void stage(const char* name, double begin, double end);

  // The next forEach is this share (0 to 1) of what is left of the stage; without a word, nothing of it.
  void nextLoop(double share) { share_ = share; }

  // In long loops that are no forEach: reports if it is time, throws Stopped if the user wants it; on
  // a thread of forEach's, only if the user has said so elsewhere.
  void poll();

  // For a piece of work inside forEach: it has one thread, and its polls are this one's.
  Execution alone();

  // Seconds by stage so far, in the order in which stages began.
  std::vector<std::pair<std::string, double>> seconds() const;

  // Calls work(begin, end) for chunks of `grain` items of [0, count), on all threads, or on as many as
  // the system can start. An exception ends the loop and is thrown again here.
  void forEach(std::size_t count, std::size_t grain,
    const std::function<void(std::size_t begin, std::size_t end)>& work);

private:
  struct Part
  {
    double begin;
    double end;
  };

  double workUpTo(double whole) const;
  void advance(double fractionOfLoop);
  void ask();

  int threads_;
  std::thread::id owner_ = std::this_thread::get_id();
  std::atomic<bool> stopped_{ false };
  Monitor monitor_;
  Part work_;            // of the whole
  Part leftOut_{ 0, 0 }; // of the whole
  const char* stage_ = "";
  Part loop_{ 0, 1 };   // of the whole
  double stageEnd_ = 1; // of the whole
  double share_ = 0;    // of the next loop
  double reported_ = 0; // of the work
  double asked_ = 0;    // when the monitor was called, and what was reported then
  double reportedThen_ = 0;
  unsigned polls_ = 0;
  double started_ = 0;
  std::vector<std::pair<std::string, double>> seconds_;
};

// How many chunks forEach makes: where each chunk has a result of its own.
inline std::size_t chunks(std::size_t count, std::size_t grain)
{
  return (count + grain - 1) / grain;
}

}
