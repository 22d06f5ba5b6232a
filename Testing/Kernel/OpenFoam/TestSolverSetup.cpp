// What a solver needs beside the mesh; TestSolverSetup.py runs the solvers.

#include "Base/Error.h"
#include "OpenFoam/FrontalArea.h"
#include "OpenFoam/LeastSystem.h"
#include "OpenFoam/Rotations.h"
#include "OpenFoam/SolverSetup.h"
#include "OpenFoam/ZoneFaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

using namespace cartesian;

namespace
{

namespace fs = std::filesystem;

FoamPatch patch(const std::string& name, const std::string& type)
{
  return { name, 1, type };
}

// An empty folder of each test's own.
class SolverCase : public testing::Test
{
protected:
  SolverCase()
    : folder(fs::path(testing::TempDir()) /
        testing::UnitTest::GetInstance()->current_test_info()->name())
  {
    fs::remove_all(folder);
    writeLeastSystem(folder, {});
  }
  ~SolverCase() override { fs::remove_all(folder); }

  std::string read(const fs::path& name) const
  {
    std::ifstream file(folder / name);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
  }

  // With these words, and nothing written.
  void expectRefusal(const std::string& words) const
  {
    try
    {
      writeSolverCase(folder, setup, duct, {}, 1);
      ADD_FAILURE() << "nothing was thrown";
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.fault, Fault::BadParameter);
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
    EXPECT_FALSE(fs::exists(folder / "0"));
  }

  fs::path folder;
  SolverSetup setup = { Solver::Incompressible };
  std::vector<MeshOfCase> duct = { { {}, true,
    { patch("inlet", "patch"), patch("outlet_1", "patch"), patch("vent", "patch"),
      patch("wall", "wall"), patch("middle", "symmetryPlane") } } };
};

// Cubes of edge 1 with the low corner at x, y, z, one patch each.
FoamMesh cubes(const std::vector<std::array<double, 3>>& corners)
{
  FoamMesh mesh;
  mesh.start = { 0 };
  mesh.cellCount = corners.size();
  for (std::size_t cube = 0; cube < corners.size(); ++cube)
  {
    for (std::uint32_t corner = 0; corner < 8; ++corner)
    {
      for (std::uint32_t axis = 0; axis < 3; ++axis)
      {
        mesh.points.push_back(corners[cube][axis] + (corner >> axis & 1U));
      }
    }
    for (const std::array<std::uint32_t, 4>& face :
      { std::array{ 0U, 4U, 6U, 2U }, std::array{ 1U, 3U, 7U, 5U }, std::array{ 0U, 1U, 5U, 4U },
        std::array{ 2U, 6U, 7U, 3U }, std::array{ 0U, 2U, 3U, 1U }, std::array{ 4U, 5U, 7U, 6U } })
    {
      for (const std::uint32_t corner : face)
      {
        mesh.corners.push_back(corner + static_cast<std::uint32_t>(8 * cube));
      }
      mesh.start.push_back(mesh.corners.size());
      mesh.owner.push_back(static_cast<std::uint32_t>(cube));
    }
    mesh.patches.push_back({ "cube" + std::to_string(cube), 6 });
  }
  return mesh;
}

}

TEST_F(SolverCase, PatchesHaveTheirRolesByTypeAndName)
{
  const auto expect = [](const FoamPatch& of, PatchRole inDuct, PatchRole around) {
    FlowAround flow;
    flow.direction = 3; // minus y
    EXPECT_EQ(roleOf(of, {}), inDuct) << of.name;
    EXPECT_EQ(roleOf(of, flow), around) << of.name;
  };
  using Role = PatchRole;
  expect(patch("Inlet_2", "patch"), Role::Inlet, Role::Inlet);
  expect(patch("outlet", "patch"), Role::Outlet, Role::Outlet);
  expect(patch("vent", "patch"), Role::Outlet, Role::Outlet);
  expect(patch("inlet", "wall"), Role::Wall, Role::Wall);
  expect(patch("ground", "wall"), Role::Wall, Role::Ground);
  expect(patch("zMin", "wall"), Role::Wall, Role::Ground);
  expect(patch("sides", "patch"), Role::Outlet, Role::Slip);
  expect(patch("yMax", "patch"), Role::Outlet, Role::Inlet);
  expect(patch("yMin", "patch"), Role::Outlet, Role::Outlet);
  expect(patch("xMin", "patch"), Role::Outlet, Role::Slip);
  expect(patch("inlet", "symmetryPlane"), Role::Constraint, Role::Constraint);
  expect(patch("a_to_b", "mappedWall"), Role::Coupled, Role::Coupled);
}

TEST_F(SolverCase, EachFieldHasEachPatch)
{
  EXPECT_TRUE(writeSolverCase(folder, setup, duct, {}, 1).empty());
  for (const char* field : { "U", "p", "k", "omega", "nut" })
  {
    const std::string text = read(fs::path("0") / field);
    for (const FoamPatch& of : duct.front().patches)
    {
      EXPECT_NE(text.find("    " + of.name + " { type "), std::string::npos) << field << of.name;
    }
    EXPECT_NE(text.find("middle { type symmetryPlane; }"), std::string::npos) << field;
  }
  EXPECT_NE(read("0/U").find("inlet { type surfaceNormalFixedValue; refValue uniform -10; }"),
    std::string::npos);
  setup.turbulence = Turbulence::Laminar;
  fs::remove_all(folder);
  writeSolverCase(folder, setup, duct, {}, 3);
  EXPECT_FALSE(fs::exists(folder / "processor0/0/k"));
  EXPECT_NE(read("processor2/0/U").find("\"procBoundary.*\" { type processor;"), std::string::npos);
}

TEST_F(SolverCase, FlowAroundBodiesGoesWhereItShould)
{
  duct.front().patches = { patch("inlet", "patch"), patch("outlet", "patch"),
    patch("ground", "wall"), patch("sides", "patch"), patch("car", "wall") };
  FlowAround flow;
  flow.direction = 3;
  setup.speed = 20;
  writeSolverCase(folder, setup, duct, flow, 1);
  const std::string velocity = read("0/U");
  for (const char* name : { "inlet", "ground" })
  {
    EXPECT_NE(velocity.find(std::string(name) + " { type fixedValue; value uniform (0 -20 0); }"),
      std::string::npos)
      << velocity;
  }
  const std::string control = read("system/controlDict");
  EXPECT_NE(control.find("patches (car);"), std::string::npos) << control;
  EXPECT_NE(control.find("dragDir (0 -1 0);"), std::string::npos);
  EXPECT_NE(control.find("liftDir (0 0 1);"), std::string::npos);
}

TEST_F(SolverCase, WhatIsThereStays)
{
  std::ofstream(folder / "system/fvSchemes") << "mine";
  EXPECT_EQ(writeSolverCase(folder, setup, duct, {}, 1),
    std::vector<fs::path>{ folder / "system/fvSchemes" });
  EXPECT_EQ(read("system/fvSchemes"), "mine");
  EXPECT_NE(read("system/controlDict").find("simpleFoam"), std::string::npos);
  setup.speed = 5;
  EXPECT_EQ(writeSolverCase(folder, setup, duct, {}, 1).size(), 11);
  EXPECT_NE(read("0/U").find("-10"), std::string::npos);
  setup.overwrites = true;
  EXPECT_TRUE(writeSolverCase(folder, setup, duct, {}, 1).empty());
  EXPECT_NE(read("0/U").find("-5"), std::string::npos);
  EXPECT_NE(read("system/fvSchemes"), "mine");
}

TEST_F(SolverCase, WhatCannotRunIsRefused)
{
  setup.solver = Solver::ConjugateHeat;
  expectRefusal("set Regions From");
  setup.solver = Solver::Incompressible;
  duct.front().region = "gas";
  expectRefusal("choose Conjugate Heat");
  duct.front().region.clear();
  for (const double viscosity : { -1., 0. })
  {
    setup.viscosity = viscosity;
    expectRefusal("Viscosity is " + number(viscosity) + ": it must be more than 0.");
  }
  setup.viscosity = 1;
  setup.speed = 0;
  expectRefusal("Speed is 0: it must be more than 0.");
  setup.speed = 1;
  duct.front().patches[0].name = "in";
  expectRefusal("is an inlet");
}

// A boundary's own row counts before patterns, and of these the first; signs follow what the boundary is.
TEST_F(SolverCase, RowsOfConditionsAreThoseOfTheirBoundary)
{
  setup.density = 2;
  setup.conditions = { { "*let*", FlowCondition::Pressure, 6 }, { "out*", FlowCondition::Speed, 9 },
    { "inlet", FlowCondition::MassFlow, 3 }, { "vent", FlowCondition::VolumeFlow, -0.5 } };
  duct.front().patches[0].area = 0.5;
  writeSolverCase(folder, setup, duct, {}, 1);
  const auto expect = [&](const char* field, const std::string& entries) {
    EXPECT_NE(read(fs::path("0") / field).find(entries), std::string::npos)
      << entries << read(fs::path("0") / field);
  };
  expect("U", "inlet { type flowRateInletVelocity; volumetricFlowRate constant 1.5;");
  expect("U", "outlet_1 { type inletOutlet;");
  expect("U", "vent { type flowRateInletVelocity; volumetricFlowRate constant 0.5;");
  expect("p", "inlet { type zeroGradient; }");
  expect("p", "outlet_1 { type fixedValue; value uniform 3; }");
  expect("p", "vent { type zeroGradient; }");
  expect("k", "inlet { type fixedValue; value uniform 0.03375; }"); // 5 % of 3 m/s
  expect("k", "outlet_1 { type inletOutlet;");
}

TEST_F(SolverCase, RowsThatDoNotFitAreRefusedByName)
{
  const auto expectRefusalOf = [&](std::vector<Condition> rows, const std::string& words) {
    setup.conditions = std::move(rows);
    expectRefusal(words);
  };
  expectRefusalOf({ { "Inlet" } }, "no boundary is called \"Inlet\", only inlet, outlet_1");
  expectRefusalOf({ { "inlet" }, { "inlet" } }, "two rows are for inlet");
  expectRefusalOf({ { "wall", FlowCondition::Speed, 1 } }, "boundary wall is a wall");
  expectRefusalOf(
    { { "middle", FlowCondition::Pressure, 1 } }, "boundary middle is of type symmetryPlane");
  expectRefusalOf({ { "inlet", FlowCondition::ByName, 0, HeatCondition::Temperature, 300 } },
    "boundary inlet has a temperature");
  expectRefusalOf({ { "inlet", FlowCondition::ByName, 0, HeatCondition::ByName, 0, 2 } },
    "of boundary inlet is 2");
  expectRefusalOf(
    { { "vent", FlowCondition::ByName, 0, HeatCondition::ByName, 0, -1, 1 } }, "nothing flows in");
  expectRefusalOf(
    { { "*t*", FlowCondition::Speed, 1 }, { "middle" } }, "all openings, inlet, outlet_1, vent");
  setup.materials = { { "gas", Material::Water } };
  expectRefusalOf({}, "only Conjugate Heat has regions");
  setup.materials.clear();
  setup.turbulence = Turbulence::Laminar;
  expectRefusalOf({ { "inlet", FlowCondition::ByName, 0, HeatCondition::ByName, 0, 0.1 } },
    "the flow is laminar");
}

TEST_F(SolverCase, TransientFlowHasTimes)
{
  setup.solver = Solver::Transient;
  setup.times = { 3, 0, 0, 0.8 };
  writeSolverCase(folder, setup, duct, {}, 1);
  const std::string control = read("system/controlDict");
  for (const char* entry :
    { "application     pimpleFoam;", "endTime         3;", "writeInterval   0.3;",
      "deltaT          0.003;", "adjustTimeStep  yes;", "maxCo           0.8;", "flux_inlet" })
  {
    EXPECT_NE(control.find(entry), std::string::npos) << entry << control;
  }
  EXPECT_NE(read("system/fvSolution").find("PIMPLE"), std::string::npos);
  EXPECT_NE(read("Allrun").find("run pimpleFoam"), std::string::npos);
  setup.times.step = 0;
  setup.times.end = 0;
  EXPECT_THROW(writeSolverCase(folder, setup, duct, {}, 1), Error);
}

// A wall that is outside the zone too stays still, unless the user says otherwise: then it turns there as well.
TEST_F(SolverCase, ZonesTurnWithTheWallsThatAreOnlyInThem)
{
  duct.front().patches.push_back(patch("blade", "wall"));
  duct.front().patches.push_back({ "shaft", 4, "wall" });
  duct.front().zones = { { "rotor", { 0, 0, 1, 0, 1, 1, 2 } },
    { "fluid", { 1, 1, 0, 1, 0, 0, 2 } } };
  setup.rotations = { { "rot*", 60, { 1, 2, 3 }, { 0, -1, 0 } } };
  writeSolverCase(folder, setup, duct, {}, 1);
  const std::string properties = read("constant/MRFProperties");
  for (const char* entry :
    { "cellZone        rotor;", "nonRotatingPatches (vent shaft);", "origin          (1 2 3);",
      "axis            (0 -1 0);", "omega           6.28319; // rad/s: 60 rpm" })
  {
    EXPECT_NE(properties.find(entry), std::string::npos) << entry << properties;
  }
  EXPECT_EQ(properties.find("fluid"), std::string::npos) << properties;
  EXPECT_NE(read("0/U").find("shaft { type noSlip; }"), std::string::npos);
  const std::string words = rotationsInWords(setup, duct, {});
  EXPECT_NE(words.find("turn along: blade; that stay still: vent, shaft."), std::string::npos)
    << words;

  setup.overwrites = true;
  setup.rotations.front().stillBoundaries = "none";
  writeSolverCase(folder, setup, duct, {}, 1);
  EXPECT_NE(read("constant/MRFProperties").find("nonRotatingPatches (vent);"), std::string::npos);
  EXPECT_NE(read("0/U").find(
              "shaft { type rotatingWallVelocity; origin (1 2 3); axis (0 -1 0); omega 6.28319;"),
    std::string::npos);
  EXPECT_NE(read("0/U").find("blade { type noSlip; }"), std::string::npos);

  setup.rotations.front().stillBoundaries = "bl* wall";
  EXPECT_NE(
    rotationsInWords(setup, duct, {}).find("turn along: shaft; that stay still: vent, blade."),
    std::string::npos);

  // What turned before does not turn in a case without rows.
  setup.rotations.clear();
  writeSolverCase(folder, setup, duct, {}, 1);
  EXPECT_EQ(read("constant/MRFProperties").find("cellZone"), std::string::npos);
}

TEST_F(SolverCase, RotationsThatDoNotFitAreRefusedByName)
{
  const auto expectRefusalOf = [&](std::vector<Rotation> rows, const std::string& words) {
    setup.rotations = std::move(rows);
    expectRefusal(words);
  };
  expectRefusalOf({ { "rotor", 1 } }, "the mesh has no zones");
  duct.front().zones = { { "rotor", { 0, 0, 0, 1, 0 } } };
  expectRefusalOf({ { "Rotor", 1 } }, "no zone is called \"Rotor\", only rotor");
  expectRefusalOf({ { "rotor", 1 }, { "rotor", 2 } }, "two rows are for rotor");
  expectRefusalOf({ { "rotor" } }, "zone rotor has a speed of 0");
  expectRefusalOf({ { "rotor", NAN } }, "Rotation Speeds: of zone rotor is nan");
  expectRefusalOf({ { "rotor", 1, { 0, 0, 0 }, { 0, 0, 0 } } }, "an axis of length 0");
  expectRefusalOf({ { "rotor", 1, { 0, 0, 0 }, { 0, 0, 1 }, "wall casing" } },
    "zone rotor: no boundary is called \"casing\", only inlet");
  setup.solver = Solver::ConjugateHeat;
  duct.front().region = "gas";
  expectRefusalOf({ { "rotor", 1 } }, "in Incompressible and Transient only");
}

// A rotor drives the flow: it comes in through what is open, as it goes out.
TEST_F(SolverCase, ARotorNeedsNoInlet)
{
  duct.front().patches[0].name = "opening";
  expectRefusal("is an inlet");
  duct.front().zones = { { "rotor", { 0, 0, 0, 1, 0 } } };
  setup.rotations = { { "rotor", 1 } };
  EXPECT_TRUE(writeSolverCase(folder, setup, duct, {}, 1).empty());
}

TEST(ZoneFaces, AreThoseOfTheZonesCells)
{
  FoamMesh mesh = cubes({ { 0, 0, 0 }, { 3, 0, 0 } });
  mesh.patches = { { "a", 5 }, { "both", 3 }, { "b", 4 } };
  mesh.zones = { { "none", {} }, { "second", { 1 } } };
  const std::vector<ZoneOfMesh> zones = facesOfZones(mesh);
  ASSERT_EQ(zones.size(), 2U);
  EXPECT_EQ(zones[0].faces, (std::vector<std::size_t>{ 0, 0, 0 }));
  EXPECT_EQ(zones[1].name, "second");
  EXPECT_EQ(zones[1].faces, (std::vector<std::size_t>{ 0, 2, 4 }));
}

// What is not replaced stays; a user's text is as it is, but for its placeholders.
TEST_F(SolverCase, OwnTemplatesReplaceTheLibrarys)
{
  setup.templates = folder / "mine";
  fs::create_directories(setup.templates / "flow");
  std::ofstream(setup.templates / "README.md") << "@nothing@";
  std::ofstream(setup.templates / "flow/transportProperties")
    << "// mail me@home @ 5@\nnu @viscosity@ @viscosity@;\n";
  writeSolverCase(folder, setup, duct, {}, 1);
  EXPECT_NE(
    read("constant/transportProperties").find("// mail me@home @ 5@\nnu 1.5e-05 1.5e-05;\n"),
    std::string::npos);
  EXPECT_NE(read("constant/turbulenceProperties").find("kOmegaSST"), std::string::npos);
}

TEST_F(SolverCase, WhatIsNoTemplateIsRefusedBeforeAnythingIsWritten)
{
  setup.templates = folder / "mine";
  expectRefusal("mine cannot be read (No such file or directory)");
  fs::create_directories(setup.templates / "flow");
  std::ofstream(setup.templates / "flow/controlDict") << "endTime @speed@;";
  expectRefusal(
    "flow/controlDict has the placeholder @speed@, which has no value there. Those that "
    "have: @functions@, @iterations@.");
  fs::rename(setup.templates / "flow/controlDict", setup.templates / "controlDict");
  expectRefusal("controlDict is no template. Templates are: Allrun, flow/MRFProperties, "
                "flow/commands, flow/controlDict");
}

// Each interface is looked at once, and solids whose heat passes through walls alone.
TEST_F(SolverCase, HeatEndsInBalance)
{
  setup.solver = Solver::ConjugateHeat;
  setup.heatIterations = 250;
  duct.front().region = "gas";
  duct.front().patches.push_back({ "gas_to_a", 1, "mappedWall", { "a", "a_to_gas" } });
  duct.push_back({ "a", false,
    { patch("outside", "wall"), { "a_to_gas", 1, "mappedWall", { "gas", "gas_to_a" } } } });
  duct.push_back({ "b", false, { patch("open", "patch") } });
  writeSolverCase(folder, setup, duct, {}, 1);
  const std::string control = read("system/controlDict");
  for (const char* entry : { "stopAt          nextWrite;", "startFrom       latestTime;",
         "endTime         250;", "\nwriteInterval   100;", "heat_gas", "heat_a", "heat_b" })
  {
    EXPECT_NE(control.find(entry), std::string::npos) << entry << control;
  }
  const std::string script = read("Allrun");
  EXPECT_NE(
    script.find(
      "-v solids=\"a\" -v sides=\"gas/gas_to_a/a/a_to_gas\" -v agreement=0.001 -v sources=\"0\""),
    std::string::npos)
    << script;
  EXPECT_NE(script.find("[ $((last + 100)) -gt 250 ]"), std::string::npos) << script;
}

// Conjugate Heat is the flow's set-up, too: its turbulence has a time scale by the speed.
TEST_F(SolverCase, HeatNeedsAFlow)
{
  setup.solver = Solver::ConjugateHeat;
  setup.speed = 0;
  duct.front().region = "gas";
  EXPECT_THROW(writeSolverCase(folder, setup, duct, {}, 1), Error);
}

TEST_F(SolverCase, AFileInTheWayIsAnErrorThatSaysWhatToDo)
{
  std::ofstream(folder / "0") << "mine";
  try
  {
    writeSolverCase(folder, setup, duct, {}, 1);
    ADD_FAILURE() << "no error";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.fault, Fault::CannotWrite);
    EXPECT_NE(std::string(error.what()).find("choose another folder"), std::string::npos)
      << error.what();
  }
}

TEST(BodySize, IsThatOfTheShadow)
{
  // The second is behind the first along x, half of it aside; the third is far away.
  const FoamMesh mesh = cubes({ { 0, 0, 0 }, { 3, 0.5, 0 }, { 0, 9, 9 } });
  const BodySize size = sizeOfBodies(mesh, { "cube0", "cube1" }, 0);
  EXPECT_EQ(size.length, 4);
  EXPECT_NEAR(size.frontalArea, 1.5, 0.002);
  EXPECT_NEAR(sizeOfBodies(mesh, { "cube0", "cube1" }, 1).frontalArea, 2, 0.002);
  EXPECT_EQ(sizeOfBodies(mesh, { "none" }, 1).frontalArea, 0);
  EXPECT_FALSE(flatAxisOf(mesh, { "none" }));
  EXPECT_EQ(flatAxisOf(mesh, { "cube0", "cube2" }), 0);
}
