// Tasks that wait for others.
#include "Base/Execution.h"
#include "Base/TaskOrder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <numeric>
#include <random>
#include <thread>

using namespace cartesian;

namespace
{

TaskOrder::After randomOrder(unsigned seed, std::uint32_t count, std::uint32_t most)
{
  std::mt19937 random(seed);
  TaskOrder::After after(count);
  for (std::uint32_t task = 1; task < count; ++task)
  {
    for (std::uint32_t i = 0; i < most; ++i)
    {
      after[task].push_back(static_cast<std::uint32_t>(random() % task));
    }
    std::sort(after[task].begin(), after[task].end());
    after[task].erase(std::unique(after[task].begin(), after[task].end()), after[task].end());
  }
  return after;
}

}

TEST(TaskOrder, EachTaskRunsOnceAfterThoseThatItWaitsFor)
{
  for (const int threads : { 1, 2, 5 })
  {
    for (const std::uint32_t count : { 0U, 1U, 300U })
    {
      const TaskOrder::After after = randomOrder(7, count, 3);
      std::vector<std::atomic<int>> ended(count);
      Execution(threads).forEachInOrder(after, [&](std::uint32_t task) {
        for (const std::uint32_t earlier : after[task])
        {
          EXPECT_EQ(ended[earlier], 1);
        }
        ++ended[task];
      });
      for (const std::atomic<int>& times : ended)
      {
        EXPECT_EQ(times, 1);
      }
    }
  }
}

TEST(TaskOrder, OneThreadTakesTheLowestFirst)
{
  std::vector<std::uint32_t> taken;
  const TaskOrder::After after = randomOrder(11, 100, 2);
  Execution(1).forEachInOrder(after, [&](std::uint32_t task) { taken.push_back(task); });
  std::vector<std::uint32_t> all(after.size());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(taken, all);
}

// Two that wait for nothing meet, on two threads: neither waits for a third that is slow to come.
TEST(TaskOrder, TasksDoNotWaitForWhatIsNotTheirs)
{
  std::atomic<int> here{ 0 };
  Execution(2).forEachInOrder({ {}, {}, { 0 } }, [&](std::uint32_t task) {
    if (task == 2)
    {
      return;
    }
    ++here;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (here < 2 && std::chrono::steady_clock::now() < end)
    {
      std::this_thread::yield();
    }
    EXPECT_EQ(here, 2);
  });
}

TEST(TaskOrder, AnErrorEndsAllAndIsThrown)
{
  for (const int threads : { 1, 3 })
  {
    std::atomic<int> ran{ 0 };
    TaskOrder::After chain(50);
    for (std::uint32_t task = 1; task < chain.size(); ++task)
    {
      chain[task] = { task - 1 };
    }
    EXPECT_THROW(Execution(threads).forEachInOrder(chain,
                   [&](std::uint32_t task) {
                     ++ran;
                     if (task == 20)
                     {
                       throw std::runtime_error("20");
                     }
                   }),
      std::runtime_error);
    EXPECT_EQ(ran, 21);
  }
}

TEST(TaskOrder, TheUserCanStopIt)
{
  for (const int threads : { 1, 3 })
  {
    std::atomic<bool> stops{ false };
    Execution execution(threads, [&](double, const char*) { return !stops; });
    execution.stage("Stage", 0, 1);
    execution.nextLoop(1);
    std::atomic<int> ran{ 0 };
    EXPECT_THROW(execution.forEachInOrder(TaskOrder::After(100000),
                   [&](std::uint32_t) {
                     stops = ++ran >= 10;
                     std::this_thread::sleep_for(std::chrono::milliseconds(1));
                   }),
      Stopped);
    EXPECT_LT(ran, 10000);
  }
}
