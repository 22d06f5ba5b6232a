// What the mesh lacks is known, and told where it is more than a thousandth of the volume.
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

}
}
