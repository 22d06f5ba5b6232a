// What faces and cells cost: where they fail, against the mesh's quality as OpenFOAM measures it, and gradients against
// differences.
#include "Editing/EditMeasures.h"
#include "Editing/WallObjective.h"
#include "Quality/QualityMeasures.h"
#include "Support/EditMeshes.h"

#include "Editing/EditDecision.h" // after the enumerators that it shadows

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace cartesian
{

namespace
{

// The same mesh for QualityMeasures: its regions, 0 and 1, do not touch.
class AsOutput
{
public:
  explicit AsOutput(const MeshEditor& mesh)
  {
    const auto count = static_cast<std::uint32_t>(mesh.nodeCount());
    std::vector<double> points;
    for (std::uint32_t n = 0; n < 2 * count; ++n)
    {
      const Vector& at = mesh.node(n % count).at;
      points.insert(points.end(), at.begin(), at.end());
    }
    CellFaces cells;
    std::vector<std::uint32_t> numbers; // of the faces of cells
    for (std::uint32_t c = 0; c < mesh.cellCount(); ++c)
    {
      cells.firstFace.push_back(cells.firstCorner.size());
      for (const std::uint32_t f : mesh.facesOf(c))
      {
        cells.firstCorner.push_back(cells.corners.size());
        const Items ring = mesh.cornersOf(f);
        std::vector<std::uint32_t> corners(ring.begin(), ring.end());
        if (mesh.face(f).below != c)
        {
          std::reverse(corners.begin(), corners.end());
        }
        for (std::uint32_t& n : corners)
        {
          n += mesh.cell(c).region == 0 ? 0 : count;
        }
        cells.corners.insert(cells.corners.end(), corners.begin(), corners.end());
        numbers.push_back(f);
      }
    }
    cells.firstFace.push_back(cells.firstCorner.size());
    cells.firstCorner.push_back(cells.corners.size());
    Execution execution;
    const FaceList list = listFaces(cells, 2 * mesh.nodeCount(), Clashes::Refused, execution);
    quality = measureQuality(points.data(), cells, list, execution);
    for (std::size_t i = 0; i < list.face.size(); ++i)
    {
      places[numbers[list.face[i]]].push_back(i);
    }
  }

  double value(std::uint32_t f, Measure measure) const
  {
    return quality.faces[measure][places.at(f).front()];
  }

  Quality quality;
  std::map<std::uint32_t, std::vector<std::size_t>>
    places; // of each face in the list: of walls of two regions, two
};

// Whether any measure of a face that the objective calls failing is beyond these limits; `limits` may be stricter.
bool failsBeyond(const AsOutput& output, const MeshEditor& mesh, std::uint32_t f, bool withMargin)
{
  const double boundary = withMargin ? std::acos(EditLimits::BoundaryCosine) * 180 / Pi : 90;
  const double inner = withMargin ? std::acos(EditLimits::InnerCosine) * 180 / Pi : 75;
  const double orthogonality =
    withMargin ? std::atan(std::sqrt(EditLimits::Slope)) * 180 / Pi : Limits::NonOrthogonality;
  const std::vector<std::size_t>& places = output.places.at(f);
  return std::any_of(places.begin(), places.end(), [&](std::size_t i) {
    const auto value = [&](Measure measure) { return output.quality.faces[measure][i]; };
    return value(StarTriangulation) < (withMargin ? 0 : Limits::StarTriangulation) ||
      (withMargin && mesh.face(f).warp > 0.6F) ||
      (mesh.isSurface(f) ? !(value(BoundaryAngle) < boundary) : !(value(InnerAngle) < inner)) ||
      !(value(NonOrthogonality) < orthogonality) || !(value(Skewness) < Limits::Skewness);
  });
}

// What costs around a node, its cells and their faces, of where nodes are.
class CostAround
{
public:
  CostAround(const MeshEditor& mesh, std::uint32_t n, const ObjectiveSpec& spec)
    : mesh_(mesh)
    , spec_(spec)
  {
    for (const std::uint32_t f : mesh.facesAround(n))
    {
      cells_.insert(mesh.face(f).below);
      cells_.insert(mesh.face(f).above);
    }
    cells_.erase(None);
    for (const std::uint32_t c : cells_)
    {
      faces_.insert(mesh.facesOf(c).begin(), mesh.facesOf(c).end());
    }
  }

  // As the formulas have it now.
  double computed() const
  {
    double cost = 0;
    for (const std::uint32_t c : cells_)
    {
      DeterminantOfCell<double> determinant;
      for (const std::uint32_t f : mesh_.facesOf(c))
      {
        if (!mesh_.isSurface(f))
        {
          determinant.add(measuresOf(f).area);
        }
      }
      cost += costOfCell(
        measuresOfOne(c).volume / mesh_.cell(c).boxVolume, mesh_.wantedShare(), determinant.value())
                .value;
    }
    for (const std::uint32_t f : faces_)
    {
      cost += costOfFaceNow(f);
    }
    return cost;
  }

  // As the mesh has it.
  double known() const
  {
    double cost = 0;
    for (const std::uint32_t c : cells_)
    {
      cost += mesh_.cell(c).cost;
    }
    for (const std::uint32_t f : faces_)
    {
      cost += mesh_.face(f).cost;
    }
    return cost;
  }

private:
  FaceMeasures<double> measuresOf(std::uint32_t f) const
  {
    return measuresOfFace(
      mesh_.face(f).corners.size, [&](std::size_t i) { return mesh_.corner(f, i); });
  }

  CellGeometry measuresOfOne(std::uint32_t c) const
  {
    if (cells_.count(c) == 0)
    {
      return { mesh_.cell(c).centre, mesh_.cell(c).volume };
    }
    return measureCell(mesh_.facesOf(c).size(), [&](std::size_t i) -> FaceGeometry {
      const std::uint32_t f = mesh_.facesOf(c)[i];
      const FaceMeasures<double> face = measuresOf(f);
      return { face.centre, scaled(face.area, mesh_.face(f).below == c ? 1 : -1) };
    });
  }

  double costOfFaceNow(std::uint32_t f) const
  {
    const EditFace& face = mesh_.face(f);
    if (!mesh_.isSurface(f))
    {
      const FaceMeasures<double> measures = measuresOf(f);
      FaceCost<double> cost(measures, spec_);
      cost.addInner(measuresOfOne(face.below), measuresOfOne(face.above), face.corners.size,
        [&](std::size_t i) { return mesh_.corner(f, i); });
      return cost.cost().value;
    }
    return costOfWall(f, face.below) + (mesh_.isWall(f) ? 0 : costOfWall(f, face.above));
  }

  // What it costs on the side of this cell.
  double costOfWall(std::uint32_t f, std::uint32_t c) const
  {
    const EditFace& face = mesh_.face(f);
    const double out = face.below == c ? 1 : -1;
    FaceMeasures<double> measures = measuresOf(f);
    measures.area = scaled(measures.area, out);
    FaceCost<double> cost(measures, spec_);
    const auto corner = [&](std::size_t i) { return mesh_.corner(f, i); };
    cost.addWall(
      measuresOfOne(c), mesh_.cell(c).edge, scaled(face.original, out), face.corners.size, corner);
    if (face.below == c && mesh_.hasLayers(face.wall))
    {
      cost.addLayers(mesh_.cell(c).edge, face.corners.size, corner);
    }
    return cost.cost().value;
  }

  const MeshEditor& mesh_;
  const ObjectiveSpec& spec_;
  std::set<std::uint32_t> cells_;
  std::set<std::uint32_t> faces_;
};

Vector along(std::size_t axis, double length)
{
  Vector v{};
  v[axis] = length;
  return v;
}

// Neither centre is nearly in the face's plane, or on its wrong side: what the objective measures there is not what OpenFOAM
// does.
bool isUpright(const MeshEditor& mesh, std::uint32_t f)
{
  const EditFace& face = mesh.face(f);
  const Vector& below = mesh.cell(face.below).centre;
  const Vector& above = mesh.cell(face.above).centre;
  const Vector normal = unit(face.area);
  const double distance = norm(minus(above, below));
  return dot(normal, minus(above, below)) > 0.15 * distance &&
    std::min(dot(normal, minus(face.centre, below)), dot(normal, minus(above, face.centre))) >
    0.02 * distance;
}

// A cube on a sheared one: of one more parameter each, all measures go through their limits.
MeshEditor twoBoxes(double shift, double height, double twist)
{
  return meshOfBoxes(blockOfBoxes(1, 1, 2), { [&](const Vector& p) {
    return p[2] < 2 ? p : Vector{ p[0] + shift + (p[1] > 0 ? twist : 0), p[1], 1 + height };
  } });
}

}

// The same measures, for any mesh: where the objective says that a face fails, one of them is beyond its limit.
TEST(WallObjective, FailsWhereTheMeshsQualityDoes)
{
  std::mt19937 random(17);
  std::uniform_real_distribution<double> part(-1, 1);
  std::array<int, 2> count{};
  for (int i = 0; i < 300; ++i)
  {
    const double first = 5 * part(random); // in an order of our own: compilers differ
    const double second = std::pow(10, 2 * part(random));
    const double third = 2 * part(random);
    MeshEditor mesh = i % 2 == 0 ? randomMesh(random, 0.6) : twoBoxes(first, second, third);
    const AsOutput output(mesh);
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
    {
      const bool isPositive = mesh.cell(mesh.face(f).below).volume > 1e-3 &&
        (mesh.isWall(f) || mesh.cell(mesh.face(f).above).volume > 1e-3);
      if (isPositive)
      {
        EXPECT_EQ(mesh.face(f).fails != 0, failsBeyond(output, mesh, f, true));
        EXPECT_TRUE(mesh.face(f).fails != 0 || !failsBeyond(output, mesh, f, false));
        ++count[mesh.face(f).fails != 0 ? 1 : 0];
      }
    }
  }
  EXPECT_GT(count[0], 1000);
  EXPECT_GT(count[1], 100);
}

// So are weights and ratios of faces, and determinants of cells.
TEST(WallObjective, StrainsWhereTheMeshsQualitySaysSo)
{
  std::mt19937 random(23);
  std::uniform_real_distribution<double> part(-1, 1);
  std::array<int, 4> count{};
  for (int i = 0; i < 300; ++i)
  {
    const double first = part(random) / 10; // in an order of our own: compilers differ
    const double second = std::pow(10, 1.7 * part(random));
    const MeshEditor mesh = i % 2 == 0 ? randomMesh(random, 0.6) : twoBoxes(first, second, 0);
    const AsOutput output(mesh);
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
    {
      if (mesh.isSurface(f) || !isUpright(mesh, f))
      {
        continue;
      }
      const bool strains = fails(FaceWeight, output.value(f, FaceWeight)) ||
        fails(VolumeRatio, output.value(f, VolumeRatio));
      EXPECT_EQ(mesh.face(f).strains, strains);
      ++count[mesh.face(f).strains ? 1 : 0];
    }
    for (std::uint32_t c = 0; c < mesh.cellCount(); ++c)
    {
      EXPECT_EQ(mesh.cell(c).strains, fails(Determinant, output.quality.cells[Determinant][c]));
      ++count[mesh.cell(c).strains ? 3 : 2];
    }
  }
  for (const int each : count)
  {
    EXPECT_GT(each, 10);
  }
}

TEST(WallObjective, MeasuresAreThoseOfCellGeometry)
{
  std::mt19937 random(29);
  for (int i = 0; i < 50; ++i)
  {
    const MeshEditor mesh = randomMesh(random, 0.4);
    const AsOutput output(mesh);
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
    {
      const FaceGeometry& geometry = output.quality.faceGeometry[output.places.at(f).front()];
      EXPECT_LT(norm(minus(mesh.face(f).centre, geometry.centre)), 1e-12);
      const double turned = dot(mesh.face(f).area, geometry.area) < 0 ? -1 : 1;
      EXPECT_LT(norm(minus(mesh.face(f).area, scaled(geometry.area, turned))), 1e-12);
      EXPECT_NEAR(double(mesh.face(f).star), output.value(f, StarTriangulation), 1e-5);
    }
    for (std::uint32_t c = 0; c < mesh.cellCount(); ++c)
    {
      const CellGeometry& geometry = output.quality.cellGeometry[c];
      EXPECT_NEAR(mesh.cell(c).volume, geometry.volume, 1e-12);
      EXPECT_LT(norm(minus(mesh.cell(c).centre, geometry.centre)), 1e-12);
    }
  }
}

TEST(WallObjective, CubesCostNextToNothing)
{
  const MeshEditor mesh = meshOfBoxes(blockOfBoxes(3, 3, 3));
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
  {
    EXPECT_LT(mesh.face(f).cost, 0.02);
    EXPECT_FALSE(mesh.face(f).fails != 0 || mesh.face(f).strains);
  }
  EXPECT_EQ(mesh.cell(13).cost, 0);
  EXPECT_FALSE(mesh.cell(0).strains);
}

// Prisms on squares are good; not so on faces that lean along a wall, and small ones.
TEST(WallObjective, WallsWithLayersCostByTheirEdges)
{
  const ObjectiveSpec spec;
  const auto costOf = [&](double lean, double height) {
    const std::array<Vector, 4> corners{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1 + lean, height, 0 },
      { lean, height, 0 } } };
    const auto corner = [&](std::size_t i) { return corners[i]; };
    const FaceMeasures<double> measures = measuresOfFace(4, corner);
    FaceCost<double> cost(measures, spec);
    const double before = cost.cost().value;
    cost.addLayers(1, 4, corner);
    return cost.cost().value - before;
  };
  EXPECT_EQ(costOf(0, 1), 0);
  EXPECT_GT(costOf(1, 1), 1);
  EXPECT_GT(costOf(2, 1), costOf(1, 1));
  EXPECT_GT(costOf(0, 0.02), 5);
}

// No unit of length: all twice as large costs the same, to the bit.
TEST(WallObjective, HasNoUnit)
{
  std::mt19937 first(31);
  std::mt19937 second(31);
  for (int i = 0; i < 20; ++i)
  {
    const MeshEditor mesh = randomMesh(first);
    MeshEditor large = randomMesh(second);
    scaleBy(large, 4);
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
    {
      EXPECT_EQ(mesh.face(f).cost, large.face(f).cost);
    }
    for (std::uint32_t c = 0; c < mesh.cellCount(); ++c)
    {
      EXPECT_EQ(mesh.cell(c).cost, large.cell(c).cost);
    }
  }
}

// Sums saturate: their order stays, and what a face may cost at most grows slowly.
TEST(WallObjective, Saturates)
{
  ObjectiveSpec all;
  all.saturation = 0;
  double last = 0;
  double lastOfAll = 0;
  for (const double shift : { 0.5, 1.0, 2.0, 4.0 })
  {
    MeshEditor mesh = twoBoxes(shift, 1, 0);
    const std::uint32_t f = faceBetween(mesh, 0, 1);
    const double cost = costOfFace(mesh, f, ObjectiveSpec()).value;
    const double sum = costOfFace(mesh, f, all).value;
    EXPECT_GT(cost, last);
    EXPECT_GT(sum, lastOfAll);
    EXPECT_LE(cost, sum);
    last = cost;
    lastOfAll = sum;
  }
}

// Between two regions the costs of both sides are summed; by another specification they are what they are measured to be.
TEST(WallObjective, CostsByAnotherSpecificationAreThoseMeasured)
{
  TestMeshSpec spec;
  spec.place = [](const Vector& p) { // the side between the boxes folds over both
    return p[0] == 1 ? Vector{ (p[1] > 0) == (p[2] > 0) ? 3.5 : -1.5, p[1], p[2] } : p;
  };
  MeshEditor mesh =
    meshOfBoxes({ { { 0, 0, 0 }, { 1, 1, 1 }, 0 }, { { 1, 0, 0 }, { 2, 1, 1 }, 1 } }, spec);
  const ObjectiveSpec usual;
  ObjectiveSpec other;
  other.saturation = 40;
  other.failing = 100;
  const std::uint32_t between = faceBetween(mesh, 0, 1);
  ASSERT_GT(costOfFace(mesh, between, usual).fails, 0);
  for (const auto& [from, to] : { std::pair{ usual, other }, std::pair{ other, usual } })
  {
    costAgain(mesh, from);
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
    {
      const double measured = costOfFace(mesh, f, to).value;
      EXPECT_NEAR(costBy(mesh, f, to, from), measured, 1e-9 * measured) << f;
    }
  }
}

// Against central differences of a whole and of half a step: where those agree, the formula is smooth.
TEST(WallObjective, GradientsAreDifferences)
{
  std::mt19937 random(37);
  int smooth = 0;
  int all = 0;
  for (int i = 0; i < 60; ++i)
  {
    ObjectiveSpec spec;
    spec.saturation = i % 2 == 0 ? 15 : 0;
    MeshEditor mesh = randomMesh(random, 0.35);
    mesh.mesh().layered.assign(i % 3 == 0 ? 8 : 0, 1);
    for (std::uint32_t n = 0; n < mesh.nodeCount(); n += 3)
    {
      const CostAround around(mesh, n, spec);
      const Vector gradient = gradientAt(mesh, n, spec);
      const Vector at = mesh.node(n).at;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const auto slope = [&](double step) {
          mesh.rawNode(n).at = plus(at, along(axis, step));
          const double above = around.computed();
          mesh.rawNode(n).at = plus(at, along(axis, -step));
          const double below = around.computed();
          mesh.rawNode(n).at = at;
          return (above - below) / (2 * step);
        };
        const double coarse = slope(2e-5);
        const double fine = slope(1e-5);
        const double scale = std::max(1.0, std::abs(fine));
        ++all;
        if (std::abs(coarse - fine) < 1e-6 * scale)
        {
          EXPECT_NEAR(gradient[axis], fine, 1e-5 * scale);
          ++smooth;
        }
      }
    }
  }
  EXPECT_GT(smooth, 1000);
  EXPECT_GT(smooth, 0.8 * all);
}

// Settled, costs are those of the formulas, but for what is kept in single precision.
TEST(WallObjective, IsWhatSettlingFinds)
{
  std::mt19937 random(41);
  std::uniform_real_distribution<double> part(-0.1, 0.1);
  const ObjectiveSpec spec;
  int count = 0;
  for (int i = 0; i < 30; ++i)
  {
    MeshEditor mesh = randomMesh(random, 0.2);
    for (std::uint32_t n = 0; n < mesh.nodeCount(); ++n)
    {
      const CostAround around(mesh, n, spec);
      const double before = around.known();
      const MeshEditor::Mark mark = mesh.mark();
      mesh.moveNode(n, plus(mesh.node(n).at, { part(random), part(random), part(random) }));
      if (updateAndValidate(mesh, spec))
      {
        EXPECT_NEAR(around.known(), around.computed(), 1e-4 * (1 + around.computed()));
        EXPECT_NEAR(mesh.delta.cost, around.known() - before, 1e-9 * (1 + before));
        ++count;
      }
      mesh.undo(mark);
    }
  }
  EXPECT_GT(count, 500);
}

}
