// SPDX-License-Identifier: BSD-3-Clause
// The processor time of each chunk of each loop, and of what is done between loops, on one thread: from it follows what
// the same work would take on any number of threads.
#pragma once

#include "Base/TaskOrder.h"

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace cartesian
{

class Recording
{
public:
  // Where filters append what they record to: a path in the environment.
  static constexpr const char* Variable = "CARTESIANMESHER_RECORDING";

  // Either a loop, or what is done on one thread until the next.
  struct Step
  {
    std::size_t stage;
    bool isLoop;
    std::vector<double> tasks; // seconds of each chunk
    TaskOrder::After after;    // of tasks in order (Execution::forEachInOrder); empty: in any
  };

  Recording(); // begins

  // What an Execution calls.
  void stage(const std::string& name);
  void beginLoop();
  void beginTasks(const TaskOrder::After& after);
  void endTask();

  void end();

  const std::vector<std::string>& stages() const { return stages_; }
  const std::vector<Step>& steps() const { return steps_; }

  void write(std::ostream& file) const;
  static Recording read(std::istream& file);

private:
  double lap();
  void endStep();

  std::vector<std::string> stages_{ "" };
  std::vector<Step> steps_;
  double last_; // seconds, when the last task ended
};

// Seconds until the last of a step's tasks is done, if each thread takes the next one whenever it is free.
double secondsOn(std::size_t threads, const Recording::Step& step);

}
