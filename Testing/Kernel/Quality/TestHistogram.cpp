// Histograms: every value that is a number is counted once, in the bin whose ends enclose it.

#include "Quality/Histogram.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace cartesian;

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

}

TEST(Histogram, CountsAddUp)
{
  std::mt19937 random(1);
  std::normal_distribution<double> normal(3, 20);
  std::vector<double> values(1000);
  std::generate(values.begin(), values.end(), [&] { return normal(random); });
  for (const std::size_t bins : { 1U, 2U, 7U, 1000U })
  {
    const Histogram histogram = histogramOf(values, rangeOf(values), bins);
    ASSERT_EQ(histogram.counts.size(), bins);
    EXPECT_EQ(histogram.total(), values.size());
    EXPECT_EQ(histogram.edge(0), *std::min_element(values.begin(), values.end()));
    EXPECT_DOUBLE_EQ(histogram.edge(bins), *std::max_element(values.begin(), values.end()));
  }
}

TEST(Histogram, ValuesAreInTheirBins)
{
  const Histogram histogram = histogramOf({ 0, 0.5, 1, 1.5, 2, 3.999, 4 }, { 0, 4 }, 4);
  EXPECT_EQ(histogram.counts, (std::vector<std::size_t>{ 2, 2, 1, 2 }));
  EXPECT_EQ(histogram.edge(1), 1);
}

TEST(Histogram, ValuesBeyondTheRangeAreInTheLastBins)
{
  const Histogram histogram =
    histogramOf({ -Infinity, -7, 1, 9, Infinity, std::nan("") }, { 0, 2 }, 2);
  EXPECT_EQ(histogram.counts, (std::vector<std::size_t>{ 2, 3 }));
}

TEST(Histogram, RangeIsOfFiniteValues)
{
  const ValueRange range = rangeOf({ Infinity, 2, -1, std::nan(""), -Infinity });
  EXPECT_EQ(range.low, -1);
  EXPECT_EQ(range.high, 2);
}

TEST(Histogram, AnyValuesHaveBinsOfSomeWidth)
{
  for (const std::vector<double>& values : { std::vector<double>{}, { 3, 3 }, { 0 }, { 1e300 },
         { -1e-300 }, { Infinity }, { std::nan("") } })
  {
    const Histogram histogram = histogramOf(values, rangeOf(values), 5);
    EXPECT_LT(histogram.edge(0), histogram.edge(5));
    EXPECT_EQ(histogram.total(), values.empty() || std::isnan(values[0]) ? 0 : values.size());
  }
}
