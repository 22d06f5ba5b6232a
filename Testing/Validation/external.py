# SPDX-License-Identifier: BSD-3-Clause
"""Turbulent flow around a body by simpleFoam, with the schemes and the relaxation of OpenFOAM's tutorial motorBike."""

import re

import numpy as np

import foam
from laminar import FIXED, OUTFLOW, SLIP, STILL
from wallflow import set_types, start_potential

SCHEMES = """ddtSchemes { default steadyState; } gradSchemes { default Gauss linear; grad(U) cellLimited Gauss linear 1; }
divSchemes { default none; div(phi,U) bounded Gauss linearUpwindV grad(U); div(phi,k) bounded Gauss upwind;
div(phi,omega) bounded Gauss upwind; div((nuEff*dev2(T(grad(U))))) Gauss linear; }
laplacianSchemes { default Gauss linear corrected; } interpolationSchemes { default linear; } snGradSchemes { default corrected; }
wallDist { method meshWave; }"""
SOLUTION = """solvers { p { solver GAMG; smoother GaussSeidel; tolerance 1e-7; relTol 0.01; } Phi { $p; }
"(U|k|omega)" { solver smoothSolver; smoother GaussSeidel; tolerance 1e-8; relTol 0.1; } }
SIMPLE { nNonOrthogonalCorrectors 0; consistent yes; } potentialFlow { nNonOrthogonalCorrectors 10; }
relaxationFactors { equations { U 0.9; k 0.7; omega 0.7; } }"""
ENDS = "inlet", "outlet", "sides"
VISCOSITY = 1.5e-5
BACK = "inletOutlet; inletValue uniform {0}; value uniform {0};"


def forces(files, speed, k, omega, ground, iterations):
    """The force on the body along x, y and z, by the density; the mean of the last quarter of the iterations and its deviation.
    `ground`: its condition for the velocity."""
    folder = files.folder.parents[1]
    set_types(folder, ENDS)
    body = [name for name in files.patches if name not in (*ENDS, "ground")]

    def field(name, dimensions, start, inlet, outlet, sides, wall, ground):
        conditions = dict(zip((*ENDS, "ground"), (inlet, outlet, sides, ground)))
        foam.write_field(folder, name, dimensions, start, {patch: conditions.get(patch, wall) for patch in files.patches})

    stream = f"({speed} 0 0)"
    field("U", "[0 1 -1 0 0 0 0]", stream, FIXED.format(f"uniform {stream}"), BACK.format("(0 0 0)"), SLIP, STILL, ground)
    field("p", "[0 2 -2 0 0 0 0]", "0", OUTFLOW, FIXED.format("uniform 0"), SLIP, OUTFLOW, OUTFLOW)
    for name, units, value, wall in (("k", "[0 2 -2 0 0 0 0]", k, "kqRWallFunction"),
                                     ("omega", "[0 0 -1 0 0 0 0]", omega, "omegaWallFunction")):
        wall = f"{wall}; value uniform {value};"
        field(name, units, str(value), FIXED.format(f"uniform {value}"), BACK.format(value), SLIP, wall, wall)
    wall, free = "nutkWallFunction; value uniform 0;", "calculated; value uniform 0;"
    field("nut", "[0 2 -1 0 0 0 0]", "0", free, free, free, wall, wall)
    foam.write(folder, "constant/transportProperties", f"transportModel Newtonian; nu [0 2 -1 0 0 0 0] {VISCOSITY};")
    foam.write(folder, "constant/turbulenceProperties", "simulationType RAS; RAS { RASModel kOmegaSST; turbulence on; printCoeffs off; }")
    foam.write(folder, "system/fvSchemes", SCHEMES)
    foam.write(folder, "system/fvSolution", SOLUTION)
    foam.control(folder, iterations, f"""functions {{ forces {{ type forces; libs (forces); patches ({" ".join(body)}); rho rhoInf;
        rhoInf 1; CofR (0 0 0); writeControl timeStep; writeInterval 1; }} }}""")
    start_potential(folder)
    foam.run(folder, "simpleFoam")
    file = next((folder / "postProcessing" / "forces" / "0").glob("force*.dat"))
    rows = [re.sub(r"[()]", " ", line).split()[1:4] for line in file.read_text().splitlines() if not line.startswith("#")]
    last = np.array(rows, float)[-iterations // 4:]
    return last.mean(axis=0), last.std(axis=0)
