// What the mesh lacks is known, and told where it is more than a thousandth of the volume.
#include "Acceptance/Limits.h"
#include "Mesher/CellsLeftOut.h"
#include "Mesher/Messages.h"
#include "Support/MeshChecker.h"
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

namespace cartesian
{
namespace
{

class CellsLeftOut : public ::testing::TestWithParam<NamedShape>
{
};
INSTANTIATE_TEST_SUITE_P(Of, CellsLeftOut, ::testing::ValuesIn(cleanShapes()), nameOf);

TEST_P(CellsLeftOut, AreToldWhereTheyMatter)
{
  const Soup& soup = GetParam().soup;
  Options options;
  Execution execution;
  for (const double boxes : { 3.3, 5.0, 8.0 })
  {
    SCOPED_TRACE(boxes);
    options.grid = cellsAlongLongest(soup, boxes);
    const auto assembly = mesh(soup.view(), options, execution);
    const double left = volumeLeftOut(*assembly);
    const double share = shareLeftOut(*assembly);
    const double volume = volumeOf(arraysOf(*assembly->mesh, assembly->boxes, execution));
    EXPECT_NEAR(share * (volume + left), left, 1e-6 * volume);
    EXPECT_EQ(left == 0, cellsLeftOut(*assembly).empty());
    EXPECT_EQ(describeFlaws(*assembly).find("left out") != std::string::npos, share > 1e-3);
  }
}

TEST_P(CellsLeftOut, OnesThatStayThoughCheckMeshFailsAreTold)
{
  const Soup& soup = GetParam().soup;
  Options options;
  Execution execution;
  for (const double boxes : { 3.3, 5.0, 8.0 })
  {
    SCOPED_TRACE(boxes);
    options.grid = cellsAlongLongest(soup, boxes);
    const auto assembly = mesh(soup.view(), options, execution);
    const Quality quality = qualityOf(arraysOf(*assembly->mesh, assembly->boxes, execution));
    const auto failing = [&](Measure measure, double limit) {
      const std::vector<double>& values = quality.cells[measure];
      return std::count_if(values.begin(), values.end(), [&](double v) { return v > limit; });
    };
    const auto skewed = static_cast<std::size_t>(failing(Skewness, Limits::Skewness));
    const auto turned =
      static_cast<std::size_t>(failing(BoundaryAngle, 90) + failing(InnerAngle, 90));
    EXPECT_LE(assembly->shaping.kept.size(), skewed + turned);
    EXPECT_TRUE(skewed == 0 || !assembly->shaping.kept.empty());
    EXPECT_EQ(describeFlaws(*assembly).find("checkMesh will fail") != std::string::npos,
      !assembly->shaping.kept.empty());
  }
}

}
}
