"""Zones that turn, by Solver Setup, from Python and from a task: the flow goes along with a rotor's blade; its shaft stays still, or turns along
outside the zone too. Rows that do not fit are refused, by the zone's name."""

import pathlib
import re
import subprocess
import sys
import tempfile

from paraview import simple

import foam
from pipeline import Messages
from rotors import fan, parts

PROGRAM = sys.argv[2]
temporary = tempfile.TemporaryDirectory()
root = pathlib.Path(temporary.name)
SCALE = 0.5  # m
mesher = fan()
mesh = simple.OutputPort(mesher, "Mesh")
SETUP = {"SolverSetup": "Incompressible", "Turbulence": "Laminar", "Viscosity": 0.05, "Iterations": 40, "Scale": SCALE, "Speed": 0.01,
         "ZoneRegions": ["rotor"]}
ROTATION = {"RotationZones": ["rotor"], "RotationSpeeds": [60]}


def ran(case):
    """The first and the last residual of the velocity along x, once Allrun has run."""
    foam.run(case, "./Allrun")
    log = (case / "log.simpleFoam").read_text()
    residuals = [float(found) for found in re.findall(r"Solving for Ux, Initial residual = ([^,]+)", log)]
    assert len(residuals) == SETUP["Iterations"] and "creating MRF zone: MRF_rotor" in log, log[-3000:]
    return residuals[0], residuals[-1]


# The shaft, which is outside the zone too, stays still unless told; the message says so.
with Messages() as said:
    case = foam.save(mesh, root / "still", **SETUP, **ROTATION)
assert "Zone rotor turns at 60 rpm (6.28319 rad/s). Boundaries in it that turn along: blade; that stay still: shaft." in str(said), str(said)
properties = (case / "constant/MRFProperties").read_text()
assert "nonRotatingPatches (shaft);" in properties and "shaft { type noSlip; }" in (case / "0/U").read_text(), properties
first, last = ran(case)
assert last < 0.1 * first, (first, last)

case = foam.save(mesh, root / "turning", **SETUP, **ROTATION, StillBoundaries=["none"], RotationAxes=[0, 0, 1], RotationOrigins=[0, 0, 0])
assert "nonRotatingPatches ();" in (case / "constant/MRFProperties").read_text()
first, last = ran(case)
assert last < 0.1 * first, (first, last)

# The flow goes along with the blade, and is nowhere faster than its end.
files = foam.Files(case)
velocity = foam.read_field(case, SETUP["Iterations"], "U")
speed = (velocity ** 2).sum(axis=1) ** 0.5
tip = 6.28319 * 0.5 * SCALE
assert 0.3 * tip < speed.max() < 1.1 * tip, (speed.max(), tip)
x, y, z = files.centres().T / SCALE
near = (abs(z) < 0.2) & (abs(y) < 0.3) & (abs(x) > 0.3) & (abs(x) < 0.6)
assert near.any() and (velocity[near, 1] * x[near] > 0).all()

# In a task, transient.
for name, part in parts().items():
    simple.SaveData(str(root / f"{name}.stl"), proxy=part)
(root / "task.toml").write_text("""
[surface]
file = ["blade.stl", "shaft.stl", "rotor.stl"]
[grid]
cell_size = 0.4
[domain]
domain = "Outside"
box_from = "Bounds"
domain_bounds = [-2, 2, -2, 2, -2, 2]
boxes_along_body = 0
[[boundaries]]
name = "rotor"
type = "zone"
[case]
solver_setup = "Transient"
end_time = 0.02
time_step = 0.005
speed = 1
zone_regions = ["rotor"]
[[rotations]]
zone = "rotor"
speed = -600
origin = [0, 0, 1]
axis = [0, 0, 2]
still_boundaries = "sh*"
[output]
mesh = "task/case.foam"
""")
done = subprocess.run([PROGRAM, str(root / "task.toml")], capture_output=True, text=True)
assert done.returncode == 0, done
properties = (root / "task/constant/MRFProperties").read_text()
for entry in "cellZone        rotor;", "origin          (0 0 1);", "axis            (0 0 2);", "omega           -62.8319;", "(shaft)":
    assert entry in properties, properties
foam.run(root / "task", "./Allrun")
assert "creating MRF zone: MRF_rotor" in (root / "task/log.pimpleFoam").read_text()


def expect_refusal(*words, proxy=mesh, **properties):
    with Messages() as said:
        simple.SaveData(str(root / "refused/case.foam"), proxy, **SETUP | ROTATION | properties)
    assert all(word in str(said) for word in words), str(said)
    assert not (root / "refused/constant").exists()


expect_refusal('no zone is called "fan", only rotor', "Nothing is written", RotationZones=["fan"])
expect_refusal("zone rotor has a speed of 0", RotationSpeeds=[0])
expect_refusal('no boundary is called "casing", only', StillBoundaries=["casing"])
expect_refusal("Rotation Speeds has 2 values for 1 rows", RotationSpeeds=[1, 2])
expect_refusal("Incompressible and Transient only", SolverSetup="Conjugate Heat", ZoneRegions=[])
expect_refusal("write the case whole and run decomposePar", ZoneRegions=[], RegionsAs="Zones", Pieces=2)
mesher.BoundaryNames, mesher.BoundaryTypes = [], []  # the rotor is a body
expect_refusal("the mesh has no zones", "name it in Zone Regions", ZoneRegions=[])
