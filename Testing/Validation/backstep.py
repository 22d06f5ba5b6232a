# SPDX-License-Identifier: BSD-3-Clause
"""Driver and Seegmiller's backward-facing step (1985), turbulent, as OpenFOAM's tutorial backwardFacingStep2D has it: its geometry,
conditions, schemes and solvers, but more turbulence at the inlet, where boxes are so large that walls are for wall functions, and
residuals as they can be on meshes of three dimensions."""

import re

import numpy as np

import harness  # before what it finds
import foam
from laminar import FIXED, OUTFLOW, SLIP, STILL, given, wall_gradient
from prisms import prism
from wallflow import last, set_types

STEP, SPEED, REATTACHED = 0.0127, 44.2, 6.26  # the length in steps, +- 0.1
DEPTH, FINE = 2.3, (-1, 9)  # in steps: the prism's depth; from where to where boxes at the lower wall are fine
SCHEMES = """ddtSchemes { default steadyState; } gradSchemes { default Gauss linear; }
divSchemes { default none; div(phi,U) bounded Gauss LUST grad(U); div(phi,k) bounded Gauss limitedLinear 1;
    div(phi,omega) bounded Gauss limitedLinear 1; div((nuEff*dev2(T(grad(U))))) Gauss linear; }
laplacianSchemes { default Gauss linear corrected; } interpolationSchemes { default linear; }
snGradSchemes { default corrected; } wallDist { method meshWave; }"""
SOLUTION = """solvers { p { solver GAMG; tolerance 1e-10; relTol 0.1; smoother DICGaussSeidel; }
"(U|k|omega)" { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-10; relTol 0.1; } }
SIMPLE { nNonOrthogonalCorrectors 0; consistent yes; residualControl { p 1e-4; "(k|omega)" 1e-3; } }
relaxationFactors { equations { U 0.9; ".*" 0.8; } }"""


def surface():
    start, end = FINE
    sides = [((-130, 1), "symmetry"), ((-110, 1), "wall"), ((start, 1), "step"), ((0, 1), "step"), ((0, 0), "step"), ((end, 0), "wall"),
             ((50, 0), "outlet"), ((50, 9), "wall"), ((-110, 9), "symmetry"), ((-130, 9), "inlet")]
    return prism("backstep", [(STEP * np.array([corner for corner, _ in sides]), [side for _, side in sides])], 0, STEP * DEPTH)


def measured(files, turn):
    folder, ahead = files.folder.parents[1], turn[:, 0]
    set_types(folder, ["inlet", "outlet", "symmetry"])

    def field(name, dimensions, start, inlet, outlet, wall):
        foam.write_field(folder, name, dimensions, start, {
            patch: {"inlet": inlet, "outlet": outlet, "symmetry": SLIP}.get(patch, wall) for patch in files.patches})

    def turbulent(name, dimensions, start, wall):
        value = f"value uniform {start};"
        field(name, dimensions, start, f"fixedValue; {value}", OUTFLOW, f"{wall}; {value}")

    field("U", "[0 1 -1 0 0 0 0]", "(0 0 0)", given(np.tile(SPEED * ahead, (files.patches["inlet"][2], 1))), OUTFLOW, STILL)
    field("p", "[0 2 -2 0 0 0 0]", "0", OUTFLOW, FIXED.format("uniform 0"), OUTFLOW)
    # The tutorial's 1.09e-3 and 181728 are for resolved walls: wall functions see no turbulence in so little, and make none.
    turbulent("k", "[0 2 -2 0 0 0 0]", "0.3", "kqRWallFunction")
    turbulent("omega", "[0 0 -1 0 0 0 0]", "2000", "omegaWallFunction")
    calculated = "calculated; value uniform 0;"
    field("nut", "[0 2 -1 0 0 0 0]", "0", calculated, calculated, "nutUBlendedWallFunction; value uniform 0;")
    foam.write(folder, "constant/transportProperties", "transportModel Newtonian; nu [0 2 -1 0 0 0 0] 1.56e-05;")
    foam.write(folder, "constant/turbulenceProperties", "simulationType RAS; RAS { RASModel kOmegaSST; turbulence on; printCoeffs off; }")
    foam.write(folder, "system/fvSchemes", SCHEMES)
    foam.write(folder, "system/fvSolution", SOLUTION)
    foam.control(folder, 600)
    said = foam.run(folder, "simpleFoam")
    iterations = len(re.findall(r"^Time = ", said, re.M))
    gradient, centres, sizes = wall_gradient(files, "step", foam.read_field(folder, iterations, "U"))
    return {"reattachment": beyond(centres @ turn / STEP, gradient @ ahead, sizes), "iterations": iterations,
            "residual of p": last(r"Solving for p, Initial residual = ([^,]+)", said)}


def beyond(at, shear, sizes):
    """In steps, from the measured place to where the shear on the floor turns forward: a cubic's root."""
    x = at[:, 0] - REATTACHED
    near = (at[:, 1] < 0.1) & (np.abs(x) < 2)
    roots = np.roots(np.polyfit(x[near], shear[near], 3, w=np.sqrt(sizes[near])))
    return float(min(roots[np.isreal(roots)].real, key=abs))


CASE = harness.Case("backstep", "Turbulent flow over a backward-facing step",
    "Driver and Seegmiller's, Reynolds number 36,000 based on step height, as in OpenFOAM's tutorial backwardFacingStep2D, k-omega "
    "SST with blended wall functions; simpleFoam. Boxes at the step are halved twice, with eight transition layers. Reattachment "
    "length in step heights, minus the measured 6.26 (+- 0.1).",
    surface(), (STEP, STEP * 0.8, STEP * 0.6), measured, depth=2, fine=("step",), between=(4, 8))

if __name__ == "__main__":
    harness.run(CASE)
