"""potentialFoam runs in the ducts of an exhaust header: what flows into each flows out of it, and
nowhere, not in the worst cell, much faster than in a duct's bends."""

import tempfile

import numpy as np
from paraview import simple

import foam
from ducts import DUCTS, SPEED, solve
from pipeline import DATA

mesher = simple.CartesianMesher(Input=simple.OpenDataFile(str(DATA / "kcl_exhaust_header_lumens.stl")),
    CellSize=6)
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
