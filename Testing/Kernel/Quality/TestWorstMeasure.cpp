// The measure that a mesh is coloured by.

#include "Quality/WorstMeasure.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace cartesian;

namespace
{

// Of a perfect mesh, with these numbers of it changed.
std::vector<SummaryValue> summaryWith(const std::vector<std::pair<std::string, double>>& changes)
{
  std::vector<SummaryValue> summary = summarise({}, {});
  for (const auto& [name, value] : changes)
  {
    const auto found = std::find_if(summary.begin(), summary.end(),
      [&, name = name](const SummaryValue& entry) { return entry.name == name; });
    EXPECT_NE(found, summary.end()) << name;
    found->value = value;
  }
  return summary;
}

Measure worstWith(const std::vector<std::pair<std::string, double>>& changes)
{
  return worstMeasure(summaryWith(changes), standardLimits());
}

}

TEST(WorstMeasure, IsTheOneThatMostCellsFail)
{
  EXPECT_EQ(
    worstWith({ { "SkewnessFailures", 3 }, { "MaxSkewness", 400 }, { "FaceWeightFailures", 5 } }),
    FaceWeight);
  EXPECT_EQ(
    worstWith({ { "StarTriangulationFailures", 1 }, { "MaxSkewness", 3.9 } }), StarTriangulation);
}

TEST(WorstMeasure, IsElseTheNearestToItsLimit)
{
  EXPECT_EQ(worstWith({ { "MaxSkewness", 2 }, { "MaxNonOrthogonality", 36 } }), NonOrthogonality);
  EXPECT_EQ(worstWith({ { "MaxSkewness", 2 }, { "MinFaceWeight", 0.09 } }), FaceWeight);
  EXPECT_EQ(worstWith({ { "MaxSkewness", 2 }, { "MinFaceWeight", 0.11 } }), Skewness);
  EXPECT_EQ(worstWith({ { "MaxAspectRatio", 600 }, { "MaxSkewness", 2.3 } }), AspectRatio);
}

TEST(WorstMeasure, TetrahedraAreForParticles)
{
  EXPECT_EQ(worstWith({ { "TetQualityFailures", 100 }, { "MaxInnerAngle", 60 } }), InnerAngle);
}

TEST(WorstMeasure, HeedsTheLimitsAsked)
{
  QualityLimits limits = standardLimits();
  const auto summary = summaryWith({ { "MaxSkewness", 2 }, { "MaxNonOrthogonality", 60 } });
  EXPECT_EQ(worstMeasure(summary, limits), NonOrthogonality);
  limits[Skewness] = 2.1;
  EXPECT_EQ(worstMeasure(summary, limits), Skewness);
}

TEST(WorstMeasure, NearnessIsOneAtTheLimit)
{
  for (std::size_t m = 0; m < MeasureCount; ++m)
  {
    const MeasureSpec& spec = MeasureSpecs[m];
    const double nearness = nearnessToLimit(static_cast<Measure>(m), spec.limit, standardLimits());
    EXPECT_EQ(nearness, spec.limit == NoLimit || spec.limit < 1e-20 ? 0 : 1) << spec.name;
  }
}
