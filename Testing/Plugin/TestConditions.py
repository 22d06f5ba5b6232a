"""Conditions by boundary and materials by region, from Python and from a task: cases run, and balance mass and heat; rows
that do not fit are refused, by the boundary's or region's name."""

import math
import pathlib
import subprocess
import sys
import tempfile

from paraview import simple
from vtkmodules.vtkCommonCore import vtkStringArray

import foam
from pipeline import Messages, output, producer
from slab import box

PROGRAM = sys.argv[2]
temporary = tempfile.TemporaryDirectory()
root = pathlib.Path(temporary.name)


def plenum():
    """3 x 1 x 1, with an inlet at x = 0, an outlet at 3, and a vent, all of the side at y = 1."""
    surface = output(simple.Triangulate(Input=simple.Box(XLength=3, Center=[1.5, 0.5, 0.5])))
    names = vtkStringArray()
    names.SetName("Wall")
    for i in range(surface.GetNumberOfCells()):
        bounds = surface.GetCell(i).GetBounds()
        names.InsertNextValue("inlet" if bounds[1] == 0 else "outlet" if bounds[0] == 3 else "vent" if bounds[2] == 1 else "side")
    surface.GetCellData().AddArray(names)
    return producer(surface)


mesh = simple.CartesianMesher(Input=plenum(), BoundaryArray="Wall", CellSize=0.2, BoundaryNames=["vent"], BoundaryTypes=["patch"])


def conditions(**rows):
    """Of each boundary: (flow, value) or (heat, value)."""
    heats = "temperature", "heat flux"
    return {"ConditionBoundaries": list(rows),
            "ConditionFlows": ["automatic" if what in heats else what for what, _ in rows.values()],
            "ConditionFlowValues": [0 if what in heats else value for what, value in rows.values()],
            "ConditionHeats": [what if what in heats else "automatic" for what, _ in rows.values()],
            "ConditionHeatValues": [value if what in heats else 0 for what, value in rows.values()]}


def flows(case):
    """Out of each opening, m3/s, once Allrun has run; what is left of their sum is no more than a millionth of what flows in.
    None with an OpenFOAM without function objects."""
    if foam.run(case, "./Allrun").count("without function objects"):
        return None
    files = {name: next(case.glob(f"postProcessing/flux_{name}/*/*")) for name in ("inlet", "outlet", "vent")}
    found = {name: float(file.read_text().splitlines()[-1].split()[1]) for name, file in files.items()}
    assert abs(sum(found.values())) < 1e-6 * -min(found.values()), found
    return found


def expect(found, within=1e-6, **expected):
    for name, value in expected.items():
        assert found is None or math.isclose(found[name], value, rel_tol=within), (name, found)


STEADY = {"SolverSetup": "Incompressible", "Viscosity": 0.01, "Turbulence": "Laminar", "Iterations": 50}
case = foam.save(mesh, root / "rates", **STEADY, Density=1.5, **conditions(inlet=("mass flow", 0.75), vent=("volume flow", 0.2)))
expect(flows(case), inlet=-0.5, vent=0.2, outlet=0.3)

# Of a mesh that is scaled; what is sucked out of an inlet is negative there.
case = foam.save(mesh, root / "speeds", **STEADY, Scale=0.5, **conditions(inlet=("speed", -2), vent=("speed", -3)))
expect(flows(case), 1e-5, inlet=0.5, vent=-2.25)  # the mesh's areas are rounded

# Turbulent and transient, by a task: 12 Pa of total pressure, which no flow exceeds.
(root / "task.toml").write_text(f"""
[surface]
file = "plenum.vtp"
boundary_array = "Wall"
[grid]
cell_size = 0.2
[[boundaries]]
name = "vent"
type = "patch"
[case]
solver_setup = "Transient"
viscosity = 0.01
end_time = 0.25
write_interval = 0.125
[[conditions]]
boundary = "in*"
flow = "pressure"
flow_value = 12
turbulence_intensity = 0.1
turbulence_length = 0.05
[output]
mesh = "transient/case.foam"
""")
simple.SaveData(str(root / "plenum.vtp"), proxy=plenum())
subprocess.run([PROGRAM, str(root / "task.toml")], check=True, capture_output=True)
case = root / "transient"
found = flows(case)
assert found is None or 0 < -found["inlet"] < math.sqrt(2 * 12 / 1.2), found
assert sorted(path.name for path in case.glob("[0-9]*")) == ["0", "0.125", "0.25"]
inflow = (case / "0/k").read_text(), (case / "0/omega").read_text()
k = 1.5 * (0.1 * math.sqrt(2 * 12 / 1.2)) ** 2
for text, value in zip(inflow, (k, math.sqrt(k) / (0.09 ** 0.25 * 0.05))):
    assert f"inlet {{ type fixedValue; value uniform {value:.6g}; }}" in text, text
fixed = foam.save(mesh, root / "fixed", SolverSetup="Transient", TimeStep=0.01)
assert "deltaT          0.01;\nadjustTimeStep  no;" in (fixed / "system/controlDict").read_text()

# 50 W come into being in a solid, and leave it by the water alone. A second one is between two temperatures.
blocks = {"solid": ([0, 1, 0], [3, 2, 1], ("end_1", "end_2")), "water": ([0, 0, 0], [3, 1, 1], ("inlet", "outlet")),
          "bar": ([0, 3, 0], [3, 4, 1], ("hot", "cold"))}
regions = simple.CartesianMesher(Input=simple.GroupDatasets(BlockNames=list(blocks), Input=[box(*block) for block in blocks.values()]),
                                 RegionsFrom="Blocks", BoundaryArray="Wall", CellSize=0.25)
HEAT = {"SolverSetup": "Conjugate Heat", "Scale": 0.01, "InletTemperature": 300, "Speed": 5}
MATERIALS = {"MaterialRegions": ["solid", "water", "bar"], "Materials": ["aluminium", "water", "copper"],
             "MaterialConductivities": [-1, -1, 100], "HeatSources": [50, 0, 0]}
rows = conditions(**{"end_*": ("heat flux", 0), "side": ("heat flux", 0), "hot": ("temperature", 400), "cold": ("temperature", 300)})
case = foam.save(regions, root / "heat", **HEAT, Iterations=50, **MATERIALS, **rows)
said = foam.run(case, "./Allrun")
assert "heat in and out of each solid agree to 0.001 after 50 iterations" in said, said
heat = {patch: float(watts) for _, region, patch, watts in map(str.split, (case / "postProcessing/heat.dat").read_text().splitlines())}
assert math.isclose(heat["solid_to_water"], -50, rel_tol=1e-2) and math.isclose(heat["water_to_solid"], 50, rel_tol=1e-2), heat
bar = 100 * 100 / 0.03 * 0.01 ** 2  # conductivity, difference, length, area
assert math.isclose(heat["hot"], bar, rel_tol=1e-2) and math.isclose(heat["cold"], -bar, rel_tol=1e-2), heat
for region, words in (("water", ("// water", "rho 998", "Cp 4182")), ("bar", ("// copper", "rho 8960", "kappa 100"))):
    text = (case / "constant" / region / "thermophysicalProperties").read_text()
    assert all(word in text for word in words), text
assert "nu              [0 2 -1 0 0 0 0] 1.004e-06;" in (case / "flow/water/constant/transportProperties").read_text()


def expect_refusal(proxy, *words, **properties):
    with Messages() as said:
        simple.SaveData(str(root / "refused/case.foam"), proxy, **properties)
    assert all(word in str(said) for word in words), str(said)
    assert not (root / "refused/constant").exists()


for words, row in ((['no boundary is called "outlets", only', "vent"], {"outlets": ("speed", 1)}),
                   (["boundary side is a wall", "through which nothing flows"], {"side": ("mass flow", 1)}),
                   (["boundary outlet has a temperature or heat flux", "Conjugate Heat"], {"outlet": ("temperature", 300)}),
                   (["given at all openings, inlet, outlet, vent"], {"inlet": ("speed", 1), "outlet": ("speed", 1), "vent": ("speed", 0)})):
    expect_refusal(mesh, *words, **STEADY, **conditions(**row))
expect_refusal(mesh, '"flow" is not one of automatic, speed', **STEADY, **conditions(inlet=("flow", 1)))
expect_refusal(mesh, "Condition Flow Values has 1 values for 2 rows", **STEADY, ConditionBoundaries=["inlet", "vent"], ConditionFlowValues=[1])
expect_refusal(mesh, "only Conjugate Heat has regions", **STEADY, MaterialRegions=["*"])
expect_refusal(regions, "boundary inlet is an inlet, where only a temperature", **HEAT, **conditions(inlet=("heat flux", 1)))
expect_refusal(regions, "boundary solid_to_water lies between two regions", **HEAT, **conditions(solid_to_water=("temperature", 300)))
expect_refusal(regions, "region water is fluid, but steel is not", **HEAT, MaterialRegions=["water"], Materials=["steel"])
expect_refusal(regions, "Condition Heat Values: of boundary hot is -1", **HEAT, **conditions(hot=("temperature", -1)))
