"""potentialFoam runs in the ducts of an exhaust header: what flows into each flows out of it, and
nowhere, not in the worst cell, much faster than in a duct's bends."""

import pathlib
import tempfile

import numpy as np
from paraview import simple

import foam
from pipeline import read

SPEED = 1.0
# The file's solids: a wall, an inlet and an outlet for each duct.
DUCTS = [[f"boundary_{3 * duct + part}" for part in range(3)] for duct in range(4)]


def solve(folder):
    """Flow through each patch, out of the mesh; velocities of the cells."""
    every = {"velocity": {}, "pressure": {}}
    for wall, inlet, outlet in DUCTS:
        every["velocity"] |= {wall: "fixedValue; value uniform (0 0 0);",
            inlet: f"surfaceNormalFixedValue; refValue uniform {-SPEED};", outlet: "zeroGradient;"}
        every["pressure"] |= {wall: "zeroGradient;", inlet: "zeroGradient;",
            outlet: "fixedValue; value uniform 0;"}
    foam.write_field(folder, "U", "[0 1 -1 0 0 0 0]", "(0 0 0)", every["velocity"])
    foam.write_field(folder, "p", "[0 2 -2 0 0 0 0]", "0", every["pressure"])
    foam.write(folder, "system/fvSolution",
        "solvers { Phi { solver PCG; preconditioner DIC; tolerance 1e-10; relTol 0; } }\n"
        "potentialFlow { nNonOrthogonalCorrectors 10; }")
    foam.control(folder, 1)
    foam.run(folder, "potentialFoam", "-writephi")
    return foam.read_flows(folder, 0), foam.read_field(folder, 0, "U")


mesher = simple.CartesianMesher(Input=read("kcl_exhaust_header_lumens.stl"), CellSize=6)
with tempfile.TemporaryDirectory() as temporary:
    folder = foam.save(mesher, temporary)
    areas = foam.Files(folder).areas()
    flow, velocities = solve(folder)
speeds = np.linalg.norm(velocities, axis=1)
print(f"{len(speeds)} cells, speeds up to {speeds.max():.3g}")
for wall, inlet, outlet in DUCTS:
    print(f"{inlet}: in {-flow[inlet]:.6g}, out {flow[outlet]:.6g}")
    assert abs(-flow[inlet] / (SPEED * areas[inlet]) - 1) < 1e-6
    assert abs(flow[outlet] / -flow[inlet] - 1) < 1e-6
    assert abs(flow[wall]) < 1e-9 * areas[wall]
assert speeds.max() < 3 * SPEED  # 2.2 in the bends
