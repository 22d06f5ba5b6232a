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

// Calls visit(assembly) for meshes of some sizes.
template <class Visit>
void forEachMesh(const Soup& soup, Visit&& visit)
{
  Options options;
  Execution execution;
  for (const double boxes : { 3.3, 5.0, 8.0 })
  {
    SCOPED_TRACE(boxes);
    options.grid = cellsAlongLongest(soup, boxes);
    const auto assembly = mesh(soup.view(), options, execution);
    visit(*assembly, arraysOf(*assembly->mesh, assembly->boxes, execution));
  }
}

TEST_P(CellsLeftOut, AreToldWhereTheyMatter)
{
  forEachMesh(GetParam().soup, [](const Assembly& assembly, const MeshArrays& arrays) {
    const double left = volumeLeftOut(assembly);
    const double share = shareLeftOut(assembly);
    const double volume = volumeOf(arrays);
    EXPECT_NEAR(share * (volume + left), left, 1e-6 * volume);
    EXPECT_EQ(left == 0, cellsLeftOut(assembly).empty());
    EXPECT_EQ(describeFlaws(assembly).find("left out") != std::string::npos, share > 1e-3);
  });
}

TEST_P(CellsLeftOut, OnesThatStayThoughCheckMeshFailsAreTold)
{
  forEachMesh(GetParam().soup, [](const Assembly& assembly, const MeshArrays& arrays) {
    const Quality quality = qualityOf(arrays);
    const auto failing = [&](Measure measure, double limit) {
      const std::vector<double>& values = quality.cells[measure];
      return static_cast<std::size_t>(
        std::count_if(values.begin(), values.end(), [&](double v) { return v > limit; }));
    };
    const std::size_t skewed = failing(Skewness, Limits::Skewness);
    const std::vector<std::uint32_t>& kept = assembly.shaping.kept;
    EXPECT_LE(kept.size(), skewed + failing(BoundaryAngle, 90) + failing(InnerAngle, 90));
    EXPECT_TRUE(skewed == 0 || !kept.empty());
    EXPECT_EQ(
      describeFlaws(assembly).find("checkMesh will fail") != std::string::npos, !kept.empty());
  });
}

}
}
