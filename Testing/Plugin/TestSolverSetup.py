"""Solver Setup: from a surface to a solver that runs, by Allrun, with nothing written by hand. Through a duct, around a
body on the ground, in gas and solid, whole and in pieces; from Python and from a task file."""

import math
import pathlib
import re
import subprocess
import sys
import tempfile

from paraview import simple

import foam
from pipeline import Messages
from slab import box

PROGRAM = sys.argv[2]
temporary = tempfile.TemporaryDirectory()
root = pathlib.Path(temporary.name)


SAID = ""


def expect(value, expected, tolerance):
    assert value is None or math.isclose(value, expected, rel_tol=tolerance), value


def ran(folder):
    """The first residuals of pressure, iteration by iteration."""
    global SAID
    SAID = foam.run(folder, "./Allrun")
    log = (folder / "log.simpleFoam").read_text()
    return [float(residual) for residual in re.findall(r"Solving for p, Initial residual = ([^,]+)", log)]


def last(folder, function, column=1):
    """Of what a function object has written; none with an OpenFOAM that has none."""
    if SAID.count("without function objects"):
        return None
    file = next((folder / "postProcessing" / function / "0").iterdir())
    return float(file.read_text().splitlines()[-1].split()[column].strip("()"))


# A duct of 3 x 1 x 1 mm.
duct = simple.CartesianMesher(Input=box([0, 0, 0], [3, 1, 1], ("inlet", "outlet")), BoundaryArray="Wall", CellSize=0.2)
case = foam.save(duct, root / "duct", SolverSetup="Incompressible", Scale=0.001, Speed=2, Iterations=60)
residuals = ran(case)
assert len(residuals) == 60 and residuals[-1] < 1e-3 * residuals[0], residuals
expect(last(case, "flux_inlet"), -2e-6, 1e-5)
expect(last(case, "flux_outlet"), 2e-6, 1e-4)
assert (last(case, "pressure_inlet") or 1) > 0

# What is there stays, unless told; and checkMesh's few files are no set-up.
velocity = case / "0" / "U"
with Messages() as said:
    foam.save(duct, case, SolverSetup="Incompressible", Speed=3)
assert "existing files are kept, 11 in all" in str(said) and "refValue uniform -2;" in velocity.read_text(), str(said)
with Messages() as said:
    foam.save(duct, case, SolverSetup="Incompressible", Speed=3, OverwriteSetup=1)
assert "already exist" not in str(said) and "refValue uniform -3;" in velocity.read_text(), str(said)

# A user's own template, and one that has nothing to fill in: refused before the mesh is written.
(root / "mine/flow").mkdir(parents=True)
own = root / "mine/flow/transportProperties"
own.write_text("transportModel Newtonian;\nnu [0 2 -1 0 0 0 0] @viscosity@; // mine\n")
case = foam.save(duct, root / "own", SolverSetup="Incompressible", Viscosity=0.5, CaseTemplates=str(root / "mine"))
assert (case / "constant/transportProperties").read_text().endswith("}\n\ntransportModel Newtonian;\nnu [0 2 -1 0 0 0 0] 0.5; // mine\n")
own.write_text("nu @Viscosity@;\n")
with Messages() as said:
    simple.SaveData(str(root / "wrong/case.foam"), duct, SolverSetup="Incompressible", CaseTemplates=str(root / "mine"))
assert f"{own} has the placeholder @Viscosity@" in str(said) and not (root / "wrong/constant").exists(), str(said)
own.write_text("transportModel Newtonian;\nnu [0 2 -1 0 0 0 0] @viscosity@; // mine\n")

# In two pieces, laminar.
case = foam.save(duct, root / "pieces", SolverSetup="Incompressible", Turbulence="Laminar", Viscosity=0.01,
                 Speed=1, Iterations=30, Pieces=2)
(case / "Allrun").write_text((case / "Allrun").read_text().replace("mpirun", " ".join(foam.MPIRUN)))
residuals = ran(case)
assert len(residuals) == 30 and residuals[-1] < 0.01 * residuals[0], residuals
expect(last(case, "flux_outlet"), 1, 1e-3)

# Around a cube on the ground, by a task file: nothing but the surface, the domain and the set-up.
simple.SaveData(str(root / "cube.stl"), proxy=simple.Triangulate(Input=simple.Box()))
(root / "task.toml").write_text("""
[surface]
file = "cube.stl"
[domain]
domain = "Outside"
ground = "zMin"
boxes_along_body = 12
lengths_before = 2
lengths_behind = 3
lengths_beside = 1.5
[case]
solver_setup = "Incompressible"
iterations = 60
case_templates = "mine"
[output]
mesh = "cube/case.foam"
""")
subprocess.run([PROGRAM, str(root / "task.toml")], check=True, capture_output=True)
case = root / "cube"
assert "// mine" in (case / "constant/transportProperties").read_text()
control = (case / "system/controlDict").read_text()
area, length = (float(re.search(name + r" (\S+);", control)[1]) for name in ("Aref", "lRef"))
assert abs(area - 1) < 0.01 and abs(length - 1) < 1e-6, (area, length)
residuals = ran(case)
# It sheds vortices: a steady solver's residuals go up and down.
assert max(residuals[1:]) < 0.5 * residuals[0] and min(residuals[30:]) < 0.1 * residuals[0], residuals
# Cubes on the ground are measured to have about 1.
assert 0.6 < (last(case, "forceCoeffs") or 1) < 1.6, last(case, "forceCoeffs")

# With prisms a thousand times as wide as high: pressure is solved in a few cycles, and the flow stays bounded. (With cells 100 times as large
# beside the last layer, of which the mesher warns, it does not.)
thin = root / "thin.toml"
thin.write_text((root / "task.toml").read_text().replace("along_body = 12", "along_body = 8").replace("iterations = 60", "iterations = 12")
                .replace("cube/", "thin/") + "[layers]\nlayers = -1\nfirst_layer_thickness = 1e-4\n")
assert subprocess.run([PROGRAM, str(thin)], capture_output=True).returncode in (0, 3)  # 3: it warns of layers that end
ran(root / "thin")
cycles = re.findall(r"Solving for p, .*No Iterations (\d+)", (root / "thin/log.simpleFoam").read_text())
assert len(cycles) == 12 and max(map(int, cycles)) < 50, cycles
assert 0.6 < (last(root / "thin", "forceCoeffs") or 1) < 4, last(root / "thin", "forceCoeffs")

# Gas of 600 K over a solid that is cooled by air of 293 K.
both = simple.GroupDatasets(BlockNames=["gas", "solid"], Input=[
    box([0, 0, 0], [3, 1, 1], ("inlet", "outlet")), box([0, 1, 0], [3, 2, 1], ("end_1", "end_2"))])
regions = simple.CartesianMesher(Input=both, RegionsFrom="Blocks", BoundaryArray="Wall", CellSize=0.2)
for pieces, flow in (1, {}), (2, {"Turbulence": "Laminar", "Viscosity": 0.01}):
    case = foam.save(regions, root / f"heat{pieces}", SolverSetup="Conjugate Heat", Scale=0.1, InletTemperature=600,
                     Iterations=100, Pieces=pieces, **flow)
    for script in case / "Allrun", case / "flow/gas/Allrun":
        script.write_text(script.read_text().replace("mpirun", " ".join(foam.MPIRUN)))
    foam.run(case, "./Allrun")
    log = (case / "log.chtMultiRegionSimpleFoam").read_text()
    ranges = [tuple(map(float, found)) for found in re.findall(r"Min/max T:(\S+) (\S+)", log)]
    (coldest, hottest), (least, most) = ranges[-2:]
    assert len(ranges) == 200 and hottest < 600.1, ranges[-2:]
    assert 293 < least < most < hottest and coldest > least - 1, ranges[-2:]

# A second solid, warmed by the first alone, takes long to reach its temperature: heat is iterated until it is in balance,
# and what is not in balance after all iterations is told.
three = simple.GroupDatasets(BlockNames=["gas", "solid", "solid_2"], Input=[
    box([0, 0, 0], [3, 1, 1], ("inlet", "outlet")), box([0, 1, 0], [3, 2, 1], ("end_1", "end_2")),
    box([0, 2, 0], [3, 3, 1], ("end_3", "end_4"))])
regions = simple.CartesianMesher(Input=three, RegionsFrom="Blocks", BoundaryArray="Wall", CellSize=0.25)


def heat(case):
    """By the heat's table, after the last iteration: that, and {region: {patch: heat into the region}}."""
    rows = [line.split() for line in (case / "postProcessing/heat.dat").read_text().splitlines()]
    table = {}
    for iteration, region, patch, watts in rows:
        if iteration == rows[-1][0]:
            table.setdefault(region, {})[patch] = float(watts)
    return int(rows[-1][0]), table


flow = {"SolverSetup": "Conjugate Heat", "Scale": 0.01, "InletTemperature": 600}
case = foam.save(regions, root / "short", Iterations=250, **flow)
said = foam.run(case, "./Allrun")
assert heat(case)[0] == 200 and "NOT CONVERGED: after 200 iterations" in said, said
into = {patch: watts for patches in heat(case)[1].values() for patch, watts in patches.items()}
assert f"solid_to_solid_2: {-into['solid_to_solid_2']:.6g} W leave solid, {into['solid_2_to_solid']:.6g} W enter solid_2" in said, said

case = foam.save(regions, root / "balanced", **flow)
for _ in range(2):  # a second run begins anew
    said = foam.run(case, "./Allrun")
    last, table = heat(case)
    assert f"heat in and out of each solid agree to 0.001 after {last} iterations" in said and 200 < last < 20000, said
    assert sorted(path.name for path in case.glob("[0-9]*")) == ["0", str(last)]
for name in "solid", "solid_2":
    passes = sum(map(abs, table[name].values())) / 2
    assert abs(sum(table[name].values())) < 1e-3 * passes, table
    assert abs(table["solid"]["solid_to_solid_2"] + table["solid_2"]["solid_2_to_solid"]) < 1e-3 * passes, table
# What the gas loses leaves through the outer walls of both solids.
lost = -table["gas"]["gas_to_solid"]
given = -sum(watts for name in ("solid", "solid_2") for patch, watts in table[name].items() if "_to_" not in patch)
assert lost > 1 and abs(lost - given) < 3e-3 * lost, table

# What cannot run is refused before anything is written; what is there stays.
closed = simple.CartesianMesher(Input=simple.Triangulate(Input=simple.Box()), CellSize=0.5)


def expect_refusal(proxy, folder, *words, **properties):
    with Messages() as said:
        simple.SaveData(str(folder / "case.foam"), proxy, **{"SolverSetup": "Incompressible"} | properties)
    for word in words:
        assert word in str(said), str(said)


for pieces in 1, 2:
    (root / "closed").mkdir(exist_ok=True)
    expect_refusal(closed, root / "closed", "no boundary is an inlet", "Nothing is written", Pieces=pieces)
    assert not list((root / "closed").iterdir()), list((root / "closed").iterdir())
    expect_refusal(duct, root / "closed", "Speed is -1: it must be more than 0.", Speed=-1, Pieces=pieces)
    expect_refusal(duct, root / "closed", "Viscosity is -1: it must be more than 0.", Viscosity=-1, Pieces=pieces)
    expect_refusal(duct, root / "closed", "Scale is -1: it must be 0 or more.", Scale=-1, Pieces=pieces)
    assert not list((root / "closed").iterdir()), list((root / "closed").iterdir())
expect_refusal(closed, root / "duct", "no boundary is an inlet")
assert "inlet" in (root / "duct/constant/polyMesh/boundary").read_text()
assert not list((root / "duct/constant").glob("polyMesh.*"))

# A task says so at once, by line and key, and leaves no mesh.
simple.SaveData(str(root / "closed.stl"), proxy=simple.Triangulate(Input=simple.Box()))
FILES = '[surface]\nfile = "closed.stl"\n[output]\nmesh = "refused/case.foam"\n[case]\nsolver_setup = "Incompressible"\n'
for text, *words in (("speed = -1", ":7: case.speed", "out of range"),
                     ("viscosity = -0.1", ":7: case.viscosity", "out of range"),
                     ("scale = -1", ":7: case.scale", "out of range: 0 or more"),
                     ("", ":6: case.solver_setup", "no boundary is an inlet")):
    (root / "refused.toml").write_text(FILES + text + "\n")
    done = subprocess.run([PROGRAM, str(root / "refused.toml")], capture_output=True, text=True)
    assert done.returncode == 2 and all(word in done.stderr for word in words), done
    assert not list((root / "refused").glob("*")), list((root / "refused").glob("*"))

# A file where a folder has to be.
(root / "way").mkdir()
(root / "way/0").write_text("mine")
expect_refusal(duct, root / "way", "way/0", "choose another folder")
