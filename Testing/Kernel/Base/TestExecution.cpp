// Chunks, threads, progress and stopping.
#include "Base/Error.h"
#include "Base/Execution.h"
#include "Support/ThreadLimit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <system_error>
#include <thread>

using namespace cartesian;

namespace
{

// The chunks that forEach made, in any order.
std::set<std::pair<std::size_t, std::size_t>> chunksOf(
  int threads, std::size_t count, std::size_t grain)
{
  Execution execution(threads);
  std::mutex mutex;
  std::set<std::pair<std::size_t, std::size_t>> made;
  execution.forEach(count, grain, [&](std::size_t begin, std::size_t end) {
    const std::lock_guard<std::mutex> lock(mutex);
    EXPECT_TRUE(made.emplace(begin, end).second);
  });
  return made;
}

// Threads that forEach(8 threads) ran on, where no more than `most` can be started beside the caller's. Chunks wait
// until all that are expected have come, or for as long as a loaded machine may take.
std::size_t threadsUsed(unsigned most)
{
  const ThreadLimit limit(most);
  const std::size_t expected = std::min(8U, most + 1);
  std::mutex mutex;
  std::condition_variable came;
  std::set<std::thread::id> used;
  Execution(8).forEach(100, 1, [&](std::size_t, std::size_t) {
    std::unique_lock<std::mutex> lock(mutex);
    used.insert(std::this_thread::get_id());
    came.notify_all();
    came.wait_for(lock, std::chrono::seconds(30), [&] { return used.size() >= expected; });
  });
  return used.size();
}

}

TEST(Execution, ChunksDependOnNoThreads)
{
  for (const std::size_t count : { 0U, 1U, 9U, 10U, 11U, 1000U })
  {
    const auto expected = chunksOf(1, count, 10);
    EXPECT_EQ(expected.size(), chunks(count, 10));
    std::size_t next = 0;
    for (const auto& [begin, end] : expected)
    {
      EXPECT_EQ(begin, next);
      EXPECT_LE(end - begin, 10U);
      next = end;
    }
    EXPECT_EQ(next, count);
    for (const int threads : { 2, 3, 8 })
    {
      EXPECT_EQ(chunksOf(threads, count, 10), expected);
    }
  }
}

TEST(Execution, ExceptionsComeOutOfAnyThread)
{
  for (const int threads : { 1, 2, 8 })
  {
    Execution execution(threads);
    for (std::size_t bad = 0; bad < 20; ++bad)
    {
      EXPECT_THROW(execution.forEach(20, 1,
                     [&](std::size_t begin, std::size_t) {
                       if (begin == bad)
                       {
                         throw Error(Fault::BadParameter, "bad");
                       }
                     }),
        Error);
    }
  }
}

TEST(Execution, MakesDoWithTheThreadsThatStart)
{
  {
    const ThreadLimit limit(0);
    EXPECT_THROW(std::thread([] {}).join(), std::system_error);
    EXPECT_EQ(chunksOf(8, 1000, 10), chunksOf(1, 1000, 10));
  }
  EXPECT_EQ(threadsUsed(0), 1U);
  EXPECT_EQ(threadsUsed(2), 3U);
  EXPECT_EQ(threadsUsed(20), 8U);
}

TEST(Execution, ThreadsAreStartedOnce)
{
  static std::atomic<int> seen{
    0
  }; // by what only a new thread has not counted yet: ids are used again
  Execution execution(3);
  std::mutex mutex;
  std::condition_variable came;
  for (int loop = 0; loop < 20; ++loop)
  {
    std::size_t inLoop = 0;
    execution.forEach(3, 1, [&](std::size_t, std::size_t) {
      thread_local const int number = ++seen;
      std::unique_lock<std::mutex> lock(mutex);
      inLoop += number > 0 ? 1 : 0;
      came.notify_all();
      came.wait_for(lock, std::chrono::seconds(30), [&] { return inLoop == 3; });
    });
    EXPECT_EQ(inLoop, 3U);
  }
  EXPECT_EQ(seen, 3);
}

TEST(Execution, ProgressNeverFallsAndIsReportedByTheCaller)
{
  const std::thread::id caller = std::this_thread::get_id();
  double last = 0;
  std::string stages;
  Execution execution(3, [&](double fraction, const char* stage) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1);
    last = fraction;
    if (stages.empty() || stages.back() != *stage)
    {
      stages += stage;
    }
    return true;
  });
  execution.stage("a", 0, 0.25);
  execution.forEach(1000, 1, [](std::size_t, std::size_t) {});
  execution.stage("b", 0.25, 1);
  execution.forEach(1000, 1, [](std::size_t, std::size_t) {});
  EXPECT_EQ(stages, "ab");
  EXPECT_GE(last, 0.25);
  ASSERT_EQ(execution.seconds().size(), 2U);
  EXPECT_EQ(execution.seconds()[1].first, "b");
  EXPECT_GE(execution.seconds()[1].second, 0);
}

TEST(Execution, LoopsAreSharesOfWhatIsLeft)
{
  double last = 0;
  Execution execution(
    1,
    [&](double fraction, const char*) {
      last = fraction;
      return true;
    },
    0.5, 1);
  execution.leaveOut(0.75, 1);
  const auto loop = [&] { execution.forEach(10, 1, [](std::size_t, std::size_t) {}); };
  execution.stage("a", 0.5, 0.625);
  loop();
  EXPECT_EQ(last, 0);
  execution.nextLoop(0.5);
  loop();
  EXPECT_EQ(last, 0.25);
  execution.nextLoop(0.5);
  loop();
  EXPECT_EQ(last, 0.375);
  loop();
  EXPECT_EQ(last, 0.375);
  execution.stage("b", 0.625, 0.75);
  EXPECT_EQ(last, 0.5);
  execution.nextLoop(1);
  loop();
  EXPECT_EQ(last, 1);
  execution.stage("left out", 0.75, 1);
  EXPECT_EQ(last, 1);
}

// ... and of other loops: those of work that runs alone in one of them, too.
TEST(Execution, WorkInsideALoopReportsItsPart)
{
  double last = 0;
  Execution execution(1, [&](double fraction, const char*) {
    last = fraction;
    return true;
  });
  execution.stage("Stage", 0, 0.5);
  execution.nextLoop(1);
  execution.forEach(2, 1, [&](std::size_t item, std::size_t) {
    const double begin = static_cast<double>(item) / 2;
    Execution alone = execution.alone(begin, begin + 0.5);
    EXPECT_DOUBLE_EQ(last, 0.5 * begin);
    alone.stage("half", 0, 0.5);
    alone.reach(0.5);
    EXPECT_DOUBLE_EQ(last, 0.5 * (begin + 0.125));
    alone.stage("the other half", 0.5, 1);
    EXPECT_DOUBLE_EQ(last, 0.5 * (begin + 0.25));
    alone.reach(1);
    EXPECT_DOUBLE_EQ(last, 0.5 * (begin + 0.5));
  });
  EXPECT_DOUBLE_EQ(last, 0.5);
}

TEST(Execution, LoopsOfOthersStopToo)
{
  bool goOn = true;
  Execution execution(1, [&](double, const char*) { return goOn; });
  execution.stage("work", 0, 1);
  goOn = false;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  EXPECT_THROW(
    while (std::chrono::steady_clock::now() < end) { execution.poll(); }, Stopped);
}

// Work that runs alone inside a loop is no longer silent than other work.
TEST(Execution, LoopsOfOthersReportAsOften)
{
  std::vector<std::chrono::steady_clock::time_point> times;
  Execution execution(1, [&](double, const char*) {
    times.push_back(std::chrono::steady_clock::now());
    return true;
  });
  execution.stage("Stage", 0, 1);
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(600);
  execution.forEach(1, 1, [&](std::size_t, std::size_t) {
    Execution alone = execution.alone(0, 1);
    while (std::chrono::steady_clock::now() < end)
    {
      alone.poll();
    }
  });
  EXPECT_GE(times.size(), 5U); // 10 and more on an idle machine
}

TEST(Execution, StopsAtOnce)
{
  for (const int threads : { 1, 4 })
  {
    std::atomic<int> done{ 0 };
    Execution execution(threads, [&](double, const char*) { return done == 0; });
    execution.stage("work", 0, 1);
    EXPECT_THROW(execution.forEach(1000000, 1,
                   [&](std::size_t, std::size_t) {
                     ++done;
                     std::this_thread::sleep_for(std::chrono::microseconds(10));
                   }),
      Stopped);
    EXPECT_LT(done, 500000);
  }
}

// The caller has nothing left to do, while another thread works on.
TEST(Execution, StopsWhatOtherThreadsStillDo)
{
  const std::thread::id caller = std::this_thread::get_id();
  const auto begin = std::chrono::steady_clock::now();
  const auto passed = [&] { return std::chrono::steady_clock::now() - begin; };
  Execution execution(
    2, [&](double, const char*) { return passed() < std::chrono::milliseconds(100); });
  execution.stage("work", 0, 1);
  EXPECT_THROW(execution.forEach(2, 1,
                 [&](std::size_t, std::size_t) {
                   while (
                     std::this_thread::get_id() != caller && passed() < std::chrono::seconds(10))
                   {
                     std::this_thread::sleep_for(std::chrono::milliseconds(1));
                     execution.poll();
                   }
                   std::this_thread::sleep_for(std::chrono::milliseconds(20)); // both get one
                 }),
    Stopped);
  EXPECT_LT(passed(), std::chrono::seconds(5));
}

TEST(Execution, NoThreadsMeansOneACore)
{
  EXPECT_GE(Execution(0).threads(), 1);
  EXPECT_GE(Execution(-3).threads(), 1);
  EXPECT_EQ(Execution(5).threads(), 5);
}
