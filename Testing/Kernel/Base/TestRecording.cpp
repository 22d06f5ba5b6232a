// Times of chunks, and what follows from them.
#include "Base/Execution.h"
#include "Base/Recording.h"

#include <gtest/gtest.h>

#include <ctime>
#include <numeric>
#include <sstream>

using namespace cartesian;

namespace
{

constexpr double Milliseconds = 1e-3;

double processorTime()
{
  return double(std::clock()) / CLOCKS_PER_SEC;
}

void work(double seconds)
{
  for (const double begin = processorTime(); processorTime() < begin + seconds;)
  {
  }
}

double sum(const Recording::Step& step)
{
  return std::accumulate(step.tasks.begin(), step.tasks.end(), 0.0);
}

const TaskOrder::After Order{ {}, {}, { 0, 1 } };

// A stage with serial work and three loops: 3 chunks of 5 ms, none, and 3 tasks in order.
Recording recorded()
{
  Execution execution(4);
  Recording recording;
  execution.record(recording);
  execution.stage("One stage", 0, 1);
  work(20 * Milliseconds);
  execution.forEach(5, 2, [](std::size_t, std::size_t) { work(5 * Milliseconds); });
  execution.forEach(0, 2, [](std::size_t, std::size_t) {});
  execution.forEachInOrder(Order, [](std::uint32_t) { work(1 * Milliseconds); });
  recording.end();
  return recording;
}

}

TEST(Recording, EveryThreadTakesTheNextTaskWhenItIsFree)
{
  const Recording::Step step{ 0, true, { 3, 1, 1, 1, 4 }, {} };
  EXPECT_EQ(secondsOn(1, step), 10);
  EXPECT_EQ(secondsOn(2, step), 7);
  EXPECT_EQ(secondsOn(3, step), 5);
  EXPECT_EQ(secondsOn(100, step), 4);
  EXPECT_EQ(secondsOn(2, { 0, true, {}, {} }), 0);
}

TEST(Recording, TasksWaitForThoseBeforeThem)
{
  const Recording::Step step{ 0, true, { 3, 1, 1, 1, 4 }, { {}, {}, { 0 }, { 1 }, { 2, 3 } } };
  EXPECT_EQ(secondsOn(1, step), 10);
  EXPECT_EQ(secondsOn(2, step), 8);
  EXPECT_EQ(secondsOn(100, step), 8);
}

TEST(Recording, HasAllChunksAndWhatIsBetween)
{
  const Recording recording = recorded();
  ASSERT_EQ(recording.stages().size(), 2U);
  EXPECT_EQ(recording.stages()[1], "One stage");
  ASSERT_EQ(recording.steps().size(), 8U);
  const bool loops[] = { false, false, true, false, true, false, true, false };
  const std::size_t tasks[] = { 1, 1, 3, 1, 0, 1, 3, 1 };
  for (std::size_t i = 0; i < 8; ++i)
  {
    const Recording::Step& step = recording.steps()[i];
    EXPECT_EQ(step.stage, i == 0 ? 0U : 1U);
    EXPECT_EQ(step.isLoop, loops[i]);
    EXPECT_EQ(step.tasks.size(), tasks[i]);
  }
  EXPECT_GE(sum(recording.steps()[1]), 19 * Milliseconds);
  EXPECT_GE(sum(recording.steps()[2]), 14 * Milliseconds);
  EXPECT_EQ(recording.steps()[6].after, Order);
}

TEST(Recording, IsReadAsItWasWritten)
{
  const Recording recording = recorded();
  std::stringstream file;
  recording.write(file);
  const Recording read = Recording::read(file);
  EXPECT_EQ(read.stages(), recording.stages());
  ASSERT_EQ(read.steps().size(), recording.steps().size());
  for (std::size_t i = 0; i < read.steps().size(); ++i)
  {
    EXPECT_EQ(read.steps()[i].stage, recording.steps()[i].stage);
    EXPECT_EQ(read.steps()[i].isLoop, recording.steps()[i].isLoop);
    EXPECT_EQ(read.steps()[i].tasks.size(), recording.steps()[i].tasks.size());
    EXPECT_EQ(read.steps()[i].after, recording.steps()[i].after);
    EXPECT_NEAR(sum(read.steps()[i]), sum(recording.steps()[i]), 1e-6);
  }
}
