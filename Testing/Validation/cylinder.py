# SPDX-License-Identifier: BSD-3-Clause
"""DFG 3D-1Z: laminar flow around a cylinder across a square channel (Schaefer, Turek and others, 1996; the figures are
FEATFLOW's)."""

import re

import numpy as np
from paraview import simple

import harness  # before what it finds
import foam
from wallsurfaces import from_proxy

HEIGHT, LENGTH, DIAMETER, MIDDLE = 0.41, 2.5, 0.1, (0.5, 0.2)
FASTEST, VISCOSITY = 0.45, 1e-3
MEAN = 4 / 9 * FASTEST  # Reynolds number 20
DRAG, LIFT = 6.18533, 0.009401
ITERATIONS = 600


def cylinder():
    """Longer than the channel is wide: it ends in its walls."""
    source = simple.Transform(Input=simple.Triangulate(Input=simple.Cylinder(Resolution=200, Radius=DIAMETER / 2, Height=2 * HEIGHT)))
    source.Transform.Rotate = [90, 0, 0]
    source.Transform.Translate = [*MIDDLE, HEIGHT / 2]
    return from_proxy("cylinder", source)


def inflow(p):
    y, z = p[:, 1], p[:, 2]
    speed = 16 * FASTEST * y * z * (HEIGHT - y) * (HEIGHT - z) / HEIGHT ** 4
    return np.stack([np.maximum(speed, 0), 0 * y, 0 * y], axis=1)


def measured(files, _):
    folder = files.folder.parents[1]
    body = next(name for name in files.patches if name not in ("inlet", "outlet", "sides"))
    centres, _ = files.face_centres()
    given = foam.items(inflow(centres[files.of_patch("inlet")]))
    foam.write_field(folder, "U", "[0 1 -1 0 0 0 0]", f"({MEAN} 0 0)", {
        body: "noSlip;", "sides": "noSlip;", "inlet": f"fixedValue; value {given};", "outlet": "zeroGradient;"})
    foam.write_field(folder, "p", "[0 2 -2 0 0 0 0]", "0", {
        name: "fixedValue; value uniform 0;" if name == "outlet" else "zeroGradient;" for name in files.patches})
    foam.write(folder, "constant/transportProperties", f"transportModel Newtonian; nu [0 2 -1 0 0 0 0] {VISCOSITY};")
    foam.write(folder, "constant/turbulenceProperties", "simulationType laminar;")
    foam.write(folder, "system/fvSchemes", "ddtSchemes { default steadyState; } gradSchemes { default Gauss linear; }\n"
        "divSchemes { default none; div(phi,U) bounded Gauss linearUpwind grad(U); div((nuEff*dev2(T(grad(U))))) Gauss linear; }\n"
        "laplacianSchemes { default Gauss linear corrected; } interpolationSchemes { default linear; }\n"
        "snGradSchemes { default corrected; }")
    foam.write(folder, "system/fvSolution",
        "solvers { p { solver GAMG; smoother GaussSeidel; tolerance 1e-9; relTol 0.01; }\n"
        "U { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-10; relTol 0.05; } }\n"
        "SIMPLE { consistent yes; nNonOrthogonalCorrectors 0; residualControl { p 1e-6; U 1e-7; } }\n"
        "relaxationFactors { equations { U 0.9; } }")
    foam.control(folder, ITERATIONS, f"""functions {{ forces {{ type forceCoeffs; libs (forces); patches ({body}); rho rhoInf;
        rhoInf 1; magUInf {MEAN}; lRef {DIAMETER}; Aref {DIAMETER * HEIGHT}; dragDir (1 0 0); liftDir (0 1 0); pitchAxis (0 0 1);
        CofR (0 0 0); writeControl timeStep; writeInterval 1; }} }}""")
    said = foam.run(folder, "simpleFoam")
    file = next((folder / "postProcessing" / "forces" / "0").iterdir())
    last = file.read_text().splitlines()[-1].split()
    return {"drag": float(last[1]) / DRAG - 1, "lift": float(last[3]) - LIFT,
            "iterations": len(re.findall(r"^Time = ", said, re.M))}


CASE = harness.Case("cylinder", "DFG 3D-1Z: a cylinder across a channel, Reynolds number 20",
    "A channel of 2.5 x 0.41 x 0.41 with a cylinder of diameter 0.1 across it; boxes at its wall are halved twice; simpleFoam, "
    "linearUpwind, without limiters. Drag against 6.18533; lift less 0.009401.",
    cylinder(), (HEIGHT / 10, HEIGHT / 16, HEIGHT / 24, HEIGHT / 36), measured, depth=2,
    outside=((0.0, 0.0, 0.0), (LENGTH, HEIGHT, HEIGHT)))

if __name__ == "__main__":
    harness.run(CASE)
