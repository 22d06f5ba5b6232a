# SPDX-License-Identifier: BSD-3-Clause
"""A blade on a shaft that turns (MRF, simpleFoam): the torque with a zone whose border cells follow, against the same boxes without a
border, where the cells whose centres are inside are the zone. pvpython rotor.py FOLDER"""

import pathlib
import re
import sys

import numpy as np
from paraview import simple

import harness  # before what it finds
import foam
from laminar import OUTFLOW, SCHEMES, SOLUTION, STILL

SPEED, VISCOSITY, RADIUS = 2.0, 0.05, 0.8  # about z; Reynolds number of the tip: 10


def box(x, y, z):
    return simple.Triangulate(Input=simple.Box(XLength=x, YLength=y, ZLength=z))


def mesher(hasZone, size):
    rotor = simple.Transform(Input=simple.Triangulate(Input=simple.Cylinder(Radius=RADIUS, Height=1, Resolution=60)), Transform="Transform")
    rotor.Transform.Rotate = [90, 0, 0]
    parts = {"blade": box(1, 0.2, 0.4), "shaft": box(0.2, 0.2, 1.6), **({"rotor": rotor} if hasZone else {})}
    blocks = simple.GroupDatasets(Input=list(parts.values()), BlockNames=list(parts))
    zone = dict(BoundaryNames=["rotor"], BoundaryTypes=["zone"]) if hasZone else {}
    return simple.CartesianMesher(Input=blocks, Domain="Outside", BoxFrom="Bounds", DomainBounds=[-2, 2] * 3, CellSize=size, BoxesAlongBody=0,
                                  SideNames="Axes", **zone)


def torque(folder, hasZone, size):
    """Of blade and shaft about z, and the number of cells."""
    folder = pathlib.Path(folder)
    foam.save(simple.OutputPort(mesher(hasZone, size), "Mesh"), folder, **(dict(ZoneRegions=["rotor"]) if hasZone else {}))
    assert not foam.refused(folder)
    files = foam.Files(folder)
    if not hasZone:
        foam.write(folder, "system/topoSetDict", f"""actions ( {{ name rotor; type cellZoneSet; action new; source cylinderToCell;
            p1 (0 0 -0.5); p2 (0 0 0.5); radius {RADIUS}; }} );""")
        foam.control(folder, 1)
        foam.run(folder, "topoSet")
    walls = {name: STILL for name in files.patches}
    spun = {name: "fixedValue; value uniform (0 0 0);" for name in walls}
    # All of the blade is in the zone, which makes it turn: its U is the fluid's where it stands still.
    spun["shaft"] = f"rotatingWallVelocity; origin (0 0 0); axis (0 0 1); omega {SPEED}; value uniform (0 0 0);"
    foam.write_field(folder, "U", "[0 1 -1 0 0 0 0]", "(0 0 0)", spun)
    foam.write_field(folder, "p", "[0 2 -2 0 0 0 0]", "0", {name: OUTFLOW for name in walls})
    foam.write(folder, "constant/transportProperties", f"transportModel Newtonian; nu [0 2 -1 0 0 0 0] {VISCOSITY};")
    foam.write(folder, "constant/turbulenceProperties", "simulationType laminar;")
    foam.write(folder, "constant/MRFProperties", f"""MRF {{ cellZone rotor; active yes; nonRotatingPatches (); origin (0 0 0); axis (0 0 1);
        omega {SPEED}; }}""")
    foam.write(folder, "system/fvSchemes", SCHEMES)
    foam.write(folder, "system/fvSolution", SOLUTION)
    foam.control(folder, 400, """functions { forces { type forces; libs (forces); patches (blade shaft); rho rhoInf; rhoInf 1; CofR (0 0 0);
        writeControl timeStep; writeInterval 1; } }""")
    foam.run(folder, "simpleFoam")
    file = next((folder / "postProcessing" / "forces" / "0").glob("moment*"), None) or next((folder / "postProcessing" / "forces" / "0").iterdir())
    numbers = np.array(re.findall(r"[-+]?[\d.]+(?:e[-+]?\d+)?", file.read_text().splitlines()[-1]), float)
    return numbers[3], files.cells  # after time, x and y


if __name__ == "__main__":
    for size in 0.2, 0.1:
        for hasZone in False, True:
            print(size, "zone" if hasZone else "no border", *torque(f"{sys.argv[1]}/rotor-{size}-{hasZone}", hasZone, size), flush=True)
