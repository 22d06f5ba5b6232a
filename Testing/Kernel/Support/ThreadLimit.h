// A process that runs short of threads, also where root runs the tests.
#pragma once

#include <fstream>
#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

namespace cartesian
{

// While it lives, no more than `most` threads can be started: the address space has no room for
// another stack.
class ThreadLimit
{
public:
  explicit ThreadLimit(unsigned most)
  {
    pthread_attr_init(&attributes_);
    pthread_getattr_default_np(&attributes_);
    pthread_attr_t large = attributes_;
    pthread_attr_setstacksize(&large, StackSize);
    pthread_setattr_default_np(&large);

    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    getrlimit(RLIMIT_AS, &limit_);
    rlimit lower = limit_;
    lower.rlim_cur = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + most * StackSize +
      StackSize / 2; // for what else is allocated meanwhile
    setrlimit(RLIMIT_AS, &lower);
  }
  ~ThreadLimit()
  {
    setrlimit(RLIMIT_AS, &limit_);
    pthread_setattr_default_np(&attributes_);
    pthread_attr_destroy(&attributes_);
  }
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
  static constexpr rlim_t StackSize = rlim_t(1) << 31U;

  pthread_attr_t attributes_{};
  rlimit limit_{};
};

}
