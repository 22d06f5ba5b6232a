# SPDX-License-Identifier: BSD-3-Clause
"""Meshes one cell across (Flat Mesh) in the solver: the Strouhal number of a cylinder at a Reynolds number of 100 (0.164 to 0.165:
Williamson 1989), and the fall of pressure in a pipe, of which a wedge is meshed (Poiseuille's). pvpython flat.py FOLDER"""

import pathlib
import re
import sys

import numpy as np
from paraview import simple

import harness  # before what it finds
import foam
from laminar import FIXED, OUTFLOW, SCHEMES, SLIP, SOLUTION, STILL, given

VISCOSITY = 0.2  # of the pipe
CYLINDER_SCHEMES = """ddtSchemes { default backward; } gradSchemes { default Gauss linear; }
divSchemes { default none; div(phi,U) Gauss linear; } laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; } snGradSchemes { default corrected; }"""
CYLINDER_SOLUTION = """solvers { p { solver GAMG; smoother GaussSeidel; tolerance 1e-6; relTol 0.02; }
pFinal { $p; relTol 0; } U { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-8; relTol 0; } }
PISO { nCorrectors 2; nNonOrthogonalCorrectors 0; pRefCell 0; pRefValue 0; }"""


def write_case(folder, velocities, pressures, viscosity, start, kept):
    flat = {name: f"{kind};" for name, kind in kept.items()}
    foam.write_field(folder, "U", "[0 1 -1 0 0 0 0]", start, {**velocities, **flat})
    foam.write_field(folder, "p", "[0 2 -2 0 0 0 0]", "0", {**pressures, **flat})
    foam.write(folder, "constant/transportProperties", f"transportModel Newtonian; nu [0 2 -1 0 0 0 0] {viscosity};")
    foam.write(folder, "constant/turbulenceProperties", "simulationType laminar;")


def strouhal(folder, end=140, step=0.02):
    """From the lift of its second half. Diameter and speed are 1."""
    cylinder = simple.Transform(Input=simple.Cylinder(Radius=0.5, Height=4, Resolution=120), Transform="Transform")
    cylinder.Transform.Rotate = [90, 0, 0]
    wake = simple.RefinementRegion(Input=cylinder, Shape="Box", Position=[-1, -1.5, -1], Length=[9, 3, 3], Depth=2)
    mesher = simple.CartesianMesher(Input=cylinder, RefinementRegions=wake, Domain="Outside", BoxFrom="Bounds", SideNames="Axes",
                                    DomainBounds=[-16, 32, -16, 16, 0, 0.1], CellSize=0.5, BoxesAlongBody=32)
    foam.save(simple.FlatMesh(Input=mesher, Thickness=1), folder)
    check = foam.CheckMesh(folder)
    assert check.ok and "2 solution (non-empty) directions (1 1 0)" in check.text, check.failures
    inflow = FIXED.format("uniform (1 0 0)")
    write_case(folder, {"boundary_0": STILL, "xMin": inflow, "xMax": OUTFLOW, "yMin": SLIP, "yMax": SLIP},
               {"boundary_0": OUTFLOW, "xMin": OUTFLOW, "xMax": FIXED.format("uniform 0"), "yMin": SLIP, "yMax": SLIP}, 0.01,
               "(1 0.1 0)", {"front": "empty", "back": "empty"})
    foam.write(folder, "system/fvSchemes", CYLINDER_SCHEMES)
    foam.write(folder, "system/fvSolution", CYLINDER_SOLUTION)
    foam.write(folder, "system/controlDict", f"""application icoFoam; startFrom startTime; startTime 0; stopAt endTime; endTime {end};
        deltaT {step}; writeControl runTime; writeInterval {end}; functions {{ forces {{ type forceCoeffs; libs (forces); patches (boundary_0);
        rho rhoInf; rhoInf 1; magUInf 1; lRef 1; Aref 1; dragDir (1 0 0); liftDir (0 1 0); pitchAxis (0 0 1); CofR (0 0 0);
        writeControl timeStep; writeInterval 1; }} }}""")
    foam.run(folder, "icoFoam")
    file = next((pathlib.Path(folder) / "postProcessing" / "forces" / "0").iterdir())
    rows = np.array([line.split()[:4] for line in file.read_text().splitlines() if not line.startswith("#")], float)
    time, drag, lift = rows[rows[:, 0] > end / 2].T[[0, 1, 3]]
    rising = np.flatnonzero((lift[:-1] < 0) & (lift[1:] >= 0))
    passes = time[rising] - lift[rising] * (time[rising + 1] - time[rising]) / (lift[rising + 1] - lift[rising])
    return 1 / np.diff(passes).mean(), drag.mean(), check.figures


def pipe(folder, size, angle=5):
    """How far the fall of pressure is off, in a pipe of radius 1 and length 6 whose fluid is as fast as developed flow is."""
    tube = simple.Transform(Input=simple.Cylinder(Radius=1, Height=8, Resolution=64, Capping=0), Transform="Transform")
    tube.Transform.Rotate = [0, 0, 90]
    mesher = simple.CartesianMesher(Input=tube, Domain="Outside", KeepPoints=[0, 0.5, size / 3], BoxFrom="Bounds", SideNames="Axes",
                                    DomainBounds=[-3, 3, 0, 1.1, 0, size], CellSize=size, BoxesAlongBody=0)
    foam.save(simple.FlatMesh(Input=mesher, Shape="Wedge", WedgeAngle=angle), folder)
    check = foam.CheckMesh(folder)
    assert check.ok, check.failures
    files = foam.Files(folder)
    wall = next(name for name in files.patches if name not in ("xMin", "xMax", "front", "back"))
    centres, vectors = (of[files.of_patch("xMin")] for of in files.face_centres())
    inflow = np.zeros(centres.shape)
    inflow[:, 0] = np.maximum(2 * (1 - centres[:, 1] ** 2 - centres[:, 2] ** 2), 0)
    write_case(folder, {wall: STILL, "xMin": given(inflow), "xMax": OUTFLOW},
               {wall: OUTFLOW, "xMin": OUTFLOW, "xMax": FIXED.format("uniform 0")}, VISCOSITY, "(0 0 0)", {"front": "wedge", "back": "wedge"})
    foam.write(folder, "system/fvSchemes", SCHEMES)
    foam.write(folder, "system/fvSolution", SOLUTION)
    foam.control(folder, 600)
    said = foam.run(folder, "simpleFoam")
    pressure = foam.read_field(folder, len(re.findall(r"^Time = ", said, re.M)), "p")
    x = files.centres()[:, 0]
    middle = abs(x) < 1.5
    mean = -np.einsum("ij,ij->", inflow, vectors) / (np.sin(np.radians(angle)) / 2)
    return -np.polyfit(x[middle], pressure[middle], 1, w=np.sqrt(files.volumes()[middle]))[0] / (8 * VISCOSITY * mean) - 1, len(x)


if __name__ == "__main__":
    for size in 0.2, 0.1, 0.05:
        print("pipe of a wedge, boxes of", size, ": pressure, cells", *pipe(f"{sys.argv[1]}/pipe-{size}", size), flush=True)
    print("cylinder at Re 100: Strouhal number, drag", *strouhal(f"{sys.argv[1]}/cylinder"), flush=True)
