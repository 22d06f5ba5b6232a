# SPDX-License-Identifier: BSD-3-Clause
"""A row of cylinders in a plane channel, laminar: the gradient of pressure between two periodic sides, which cut a cylinder in halves, against
that behind the third of six cylinders in a channel with inlet and outlet. pvpython periodic.py FOLDER"""

import pathlib
import re
import sys

import numpy as np
from paraview import simple

import harness  # before what it finds
import foam
from laminar import FIXED, OUTFLOW, SCHEMES, SOLUTION, STILL

PITCH, RADIUS, VISCOSITY, STEPS = 2, 0.2, 0.05, 1500  # channel's height and mean speed: 1


def flat(size, low, high, centres, layers=0, **options):
    """A mesh one cell deep."""
    rods = [simple.Transform(Input=simple.Cylinder(Radius=RADIUS, Height=4, Resolution=48), Transform="Transform") for _ in centres]
    for rod, x in zip(rods, centres):
        rod.Transform.Rotate, rod.Transform.Translate = [90, 0, 0], [x, 0.5, 0]
    blocks = simple.GroupDatasets(Input=rods, BlockNames=[f"rod{i}" for i in range(len(rods))])
    mesher = simple.CartesianMesher(Input=blocks, Domain="Outside", BoxFrom="Bounds", DomainBounds=[low, high, 0, 1, 0, 2 * size],
                                    CellSize=size, BoxesAlongBody=0, SideNames="Axes", Layers=layers, **options)
    return simple.FlatMesh(Input=mesher, Thickness=1)


def solve(mesh, folder, kinds, inflow="", options=""):
    """What simpleFoam said, and the case's files. `kinds`: conditions that both fields have alike."""
    foam.save(mesh, folder)
    assert not foam.refused(folder), foam.CheckMesh(folder).failures
    files = foam.Files(folder)
    others = [name for name in files.patches if name not in kinds]
    ends = {"xMin": inflow, "xMax": OUTFLOW} if inflow else {}
    foam.write_field(folder, "U", "[0 1 -1 0 0 0 0]", "(1 0 0)", {**{name: STILL for name in others}, **ends, **kinds})
    foam.write_field(folder, "p", "[0 2 -2 0 0 0 0]", "0",
                     {**{name: OUTFLOW for name in others}, **({"xMax": FIXED.format("uniform 0")} if inflow else {}), **kinds})
    foam.write(folder, "constant/transportProperties", f"transportModel Newtonian; nu [0 2 -1 0 0 0 0] {VISCOSITY};")
    foam.write(folder, "constant/turbulenceProperties", "simulationType laminar;")
    foam.write(folder, "system/fvSchemes", SCHEMES)
    foam.write(folder, "system/fvSolution", SOLUTION)
    if options:
        foam.write(folder, "constant/fvOptions", options)
    foam.control(folder, STEPS)
    return foam.run(folder, "simpleFoam"), files


def periodic_gradient(folder, size, layers=0):
    """And the number of cells; the fluid's share of the channel is in it."""
    mesh = flat(size, 0, PITCH, [0, PITCH], layers)
    pair = simple.PeriodicBoundaries(Input=mesh, FirstBoundary="xMin", SecondBoundary="xMax")
    depth = 1 - np.pi * RADIUS**2 / PITCH
    said, files = solve(pair, folder, {"front": "empty;", "back": "empty;", "xMin": "cyclic;", "xMax": "cyclic;"}, options=f"""drive {{
        type meanVelocityForce; active yes; selectionMode all; fields (U); Ubar ({1 / depth} 0 0); }}""")
    return float(re.findall(r"pressure gradient = ([-+\d.e]+)", said)[-1]), len(files.centres())


def gradient_behind(folder, size, layers=0):
    mesh = flat(size, -PITCH / 2, 5.5 * PITCH, [i * PITCH for i in range(6)], layers)
    said, files = solve(mesh, folder, {"front": "empty;", "back": "empty;"}, FIXED.format("uniform (1 0 0)"))
    pressure = foam.read_field(folder, len(re.findall(r"^Time = ", said, re.M)), "p")
    x = files.centres()[:, 0]

    def mean(at):
        near = abs(x - at) < 0.75 * size
        return np.average(pressure[near], weights=files.volumes()[near])

    return (mean(2.5 * PITCH) - mean(3.5 * PITCH)) / PITCH, len(x)


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1])
    for size, layers in (0.05, 0), (0.05, 3), (0.03, 0):
        gradient, cells = periodic_gradient(folder / f"periodic-{size}-{layers}", size, layers)
        reference, more = gradient_behind(folder / f"ends-{size}-{layers}", size, layers)
        print(f"boxes of {size}, {layers} layers: gradient {gradient:.5f} ({cells} cells), with inlet and outlet {reference:.5f} ({more}): "
              f"{100 * (gradient / reference - 1):+.2f} %", flush=True)
